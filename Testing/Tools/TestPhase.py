# SPDX-License-Identifier: BSD-3-Clause
"""Complex fields at a phase, against closed forms."""

import math
import unittest

import numpy as np

from tool import CUBE, ToolTest, columns, read_buffers, read_csv, unit_cube_grid


class Phase(ToolTest):
    def setUp(self):
        super().setUp()
        fields = [("u_real", [p[0] for p in CUBE]), ("u_imag", [p[1] for p in CUBE]),
                  ("v_real", [[p[0], p[1], p[2]] for p in CUBE]),
                  ("v_imag", [[1.0, p[2], p[0]] for p in CUBE]), ("w_real", [1.0] * 8)]
        self.cube = self.folder / "cube.vtu"
        self.cube.write_text(unit_cube_grid(fields), encoding="utf-8")

    def test_probes_have_the_turned_field(self):
        random = np.random.default_rng(3)
        points = random.uniform(0.0, 1.0, (20, 3))
        table, out = self.folder / "p.csv", self.folder / "o.csv"
        table.write_text("x,y,z\n" + "\n".join(",".join(map(repr, p)) for p in points.tolist()),
                         encoding="utf-8")
        x, y, z = points.T
        for degrees in (0.0, 30.0, 90.0, -225.0, 1000.0):
            with self.subTest(degrees=degrees):
                c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
                self.succeeds("probe", self.cube, "--phase", degrees, "--field", "u", "--field", "v",
                              "--points", table, "--output", out)
                found = columns(read_csv(out))
                np.testing.assert_allclose(found["u"], c * x - s * y, atol=1e-14)
                np.testing.assert_allclose(found["v_1"], c * y - s * z, atol=1e-14)

    def test_a_field_alone_and_one_that_is_stored(self):
        self.summary("probe", self.cube, "--phase", 30, "--field", "u", "--line", "0,0,0,1,0,0,3",
                     "--output", self.folder / "o.csv")
        stored = self.folder / "stored.vtu"
        stored.write_text(unit_cube_grid([(name, [1.0] * 8) for name in ("s", "s_real", "s_imag", "u_real", "u_imag")]),
                          encoding="utf-8")
        self.assertIn("field 's' is stored beside", self.succeeds("info", stored, "--phase", 30).stderr)

    def test_animation_over_a_period(self):
        summary = self.summary("render", self.cube, "--field", "u", "--plane", "z=0.5", "--sweep",
                               "phase=0:270:4", "--size", "20x20", "--output",
                               self.folder / "a_%02d.png", "--buffers", self.folder / "b_%02d.vti")
        self.assertEqual((summary["frames"], summary["read"]), (4, 1))
        for frame in range(4):
            seen = read_buffers(self.folder / f"b_{frame:02d}.vti")
            hit = seen["Verdict"] == 1
            x, y = seen["Position"][hit][:, 0], seen["Position"][hit][:, 1]
            exact = [x, -y, -x, y][frame]
            np.testing.assert_allclose(seen["Value"][hit], exact, atol=1e-15)

    def test_warp_at_a_phase(self):
        """Fields stay functions of the reference coordinates, which are those of the mesh at rest."""
        random = np.random.default_rng(4)
        rest = random.uniform(0.0, 1.0, (20, 3))
        table, out = self.folder / "p.csv", self.folder / "o.csv"
        x, y, z = rest.T
        for degrees in (0.0, 30.0, 90.0, 200.0):
            c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
            moves = {("--warp", "v=0.25"): 0.25 * np.stack([c * x - s, c * y - s * z, c * z - s * x], axis=1),
                     ("--warp", "u=0.5", "--warp-direction", "0,0,1"):
                         0.5 * np.stack([0 * x, 0 * x, c * x - s * y], axis=1),
                     ("--warp", "vec(u,0,'u_real'*2 - 0.5*u_imag)=0.1"):
                         0.1 * np.stack([c * x - s * y, 0 * x, 2 * x - 0.5 * y], axis=1)}
            for options, moved in moves.items():
                with self.subTest(degrees=degrees, options=options):
                    table.write_text("x,y,z\n" + "\n".join(",".join(map(repr, p)) for p in (rest + moved).tolist()),
                                     encoding="utf-8")
                    self.succeeds("probe", self.cube, "--phase", degrees, *options, "--field", "u", "--field", "u_real",
                                  "--points", table, "--output", out)
                    rows = read_csv(out)
                    self.assertEqual({row["verdict"] for row in rows}, {"inside"})
                    found = columns(rows)
                    np.testing.assert_allclose(found["u_real"], x, atol=1e-14)
                    np.testing.assert_allclose(found["u"], c * x - s * y, atol=1e-14)

    def test_warp_by_what_is_no_sum(self):
        for text in ("v*w_real", "v_real/2", "u_real + w_real*u_imag"):
            self.fails(1, "info", self.cube, "--phase", "10", "--warp", text, names=["cube.vtu"])

    def test_animation_of_the_deformed_mesh(self):
        """All pictures have the plane of the first one, which the command names."""
        options = ["--field", "u", "--warp", "v=0.25", "--sweep", "phase=0:270:4", "--size", "20x20"]
        summary = self.summary("render", self.cube, *options, "--output", self.folder / "w_%02d.png",
                               "--buffers", self.folder / "w_%02d.vti")
        self.assertIn("--plane=0,0,0.625,0,0,1", summary["command"])
        for frame, (c, s) in enumerate(((1, 0), (0, 1), (-1, 0), (0, -1))):
            seen = read_buffers(self.folder / f"w_{frame:02d}.vti")
            hit = seen["Verdict"] == 1
            # The inverse of the affine map from the mesh at rest.
            matrix = np.eye(3) + 0.25 * np.array([[c, 0, 0], [0, c, -s], [-s, 0, c]])
            rest = np.linalg.solve(matrix, (seen["Position"][hit] + [0.25 * s, 0, 0]).T)
            self.assertGreater(np.count_nonzero(hit), 50)
            np.testing.assert_allclose(seen["Position"][hit][:, 2], 0.625, atol=1e-15)
            np.testing.assert_allclose(seen["Value"][hit], c * rest[0] - s * rest[1], atol=1e-13)

    def test_without_complex_fields(self):
        plain = self.folder / "plain.vtu"
        plain.write_text(unit_cube_grid(), encoding="utf-8")
        self.fails(1, "info", plain, "--phase", "10", names=["--phase", "NAME_real and NAME_imag"])
        self.fails(2, "info", plain, "--phase", "x", names=["--phase"])


if __name__ == "__main__":
    unittest.main()
