# SPDX-License-Identifier: BSD-3-Clause
"""--warp, its sweep and its limit, against closed forms on a cube and MFEM's bent beam."""

import unittest

import numpy as np

from tool import (CUBE, DATA, ToolTest, case, plain_grid, read_buffers, read_image,
    unit_cube_grid)

BEAM = [DATA / "mfem_beam_hex_elast_p4" / name
        for name in ("mfem_beam_hex_elast_p4.mesh", "displacement.gf")]


class WarpTest(ToolTest):
    def setUp(self):
        super().setUp()
        # p = x y: trilinear, so exact. Moved along z by s p, the cube's top is z = 1 + s x y.
        self.cube = self.folder / "cube.vtu"
        fields = [("p", [x * y for x, y, _ in CUBE]), ("q", [x + 10.0 * z for x, _, z in CUBE])]
        self.cube.write_text(unit_cube_grid(fields), encoding="utf-8")
        self.warped = [self.cube, "--warp", "p=0.5", "--warp-direction", "0,0,1"]

    def probed(self, points, *arguments):
        table = self.folder / "points.csv"
        table.write_text("x,y,z\n" + "\n".join(",".join(map(repr, p)) for p in points) + "\n",
            encoding="utf-8")
        out = self.folder / "out.csv"
        self.succeeds("probe", *arguments, "--points", table, "-o", out)
        return np.genfromtxt(out, delimiter=",", names=True, dtype=None, encoding="utf-8")


class Values(WarpTest):
    def test_probe_finds_the_values_of_the_undeformed_points(self):
        places = np.random.default_rng(3).uniform(0.05, 0.95, (40, 3))
        moved = places + 0.5 * places[:, :1] * places[:, 1:2] * np.array([0.0, 0.0, 1.0])
        found = self.probed(moved.tolist(), *self.warped, "--field", "q")
        self.assertEqual(set(found["verdict"]), {"inside"})
        np.testing.assert_allclose(found["value"], places[:, 0] + 10.0 * places[:, 2], atol=1e-12)

    def test_volume_by_flux(self):
        # The boundary's area of the top grows; by the divergence theorem the volume is 1 + s / 4.
        found = self.summary("info", *self.warped)
        np.testing.assert_allclose(found["bounds"], [0, 1, 0, 1, 0, 1.5], atol=1e-12)
        flat = self.summary("integrate", *self.warped, "--field", "q", "--plane", "x=0.5")
        rows = {row["quantity"]: row for row in flat["surfaces"][0]["rows"]}
        # The cut is the unit square sheared along z: its area stays.
        self.assertAlmostEqual(rows["Area"]["value"], 1.0, delta=1e-9)

    def test_render_shows_the_deformed_shape(self):
        buffers = self.folder / "b.vti"
        self.succeeds("render", *self.warped, "--field", "q", "--plane", "y=0.8", "--size", "80x80",
            "-o", self.folder / "p.png", "--buffers", buffers)
        arrays = read_buffers(buffers)
        hit = arrays["Verdict"] == 1
        self.assertGreater(hit.mean(), 0.3)
        x, y, z = arrays["Position"][hit].T
        np.testing.assert_allclose(arrays["Value"][hit], x + 10.0 * (z - 0.5 * x * y), atol=1e-11)
        self.assertGreater(z.max(), 1.3)


class Sweeps(WarpTest):
    def test_pictures_are_those_of_scales(self):
        arguments = ["--field", "q", "--boundary", "--size", "60x60", "--range", "0,11",
            "--camera-position", "4,3,2", "--focal-point", "0.5,0.5,0.5"]
        found = self.summary("render", *self.warped, "--sweep", "warp=0:1:3", *arguments, "-o",
            self.folder / "f_%03d.png")
        self.assertEqual((found["frames"], found["written"], found["read"]), (3, 3, 1))
        for k, scale in enumerate([0.0, 0.5, 1.0]):
            single = self.folder / "single.png"
            self.succeeds("render", self.cube, "--warp", f"p={scale}", "--warp-direction", "0,0,1",
                *arguments, "-o", single)
            np.testing.assert_array_equal(read_image(found["files"][k]), read_image(single))

    def test_wrong_use(self):
        for arguments, message in [
            (["--sweep", "warp=0:1:3"], "give --warp FIELD"),
            (["--sweep", "warp=0:1"], "such as z=0:1:50"),
        ]:
            self.fails(2, "render", self.cube, "--field", "q", *arguments, "-o",
                self.folder / "f_%03d.png", names=[message])


class Limits(WarpTest):
    def test_shear_never_inverts(self):
        found = self.summary("info", self.cube, "--warp-limit", "p", "--warp-direction", "0,0,1")
        limit = found["warp_limit"]
        self.assertGreater(limit["positive_below"], 1e5)
        self.assertIsNone(limit["inverted_at"])

    def test_along_the_field(self):
        # x - s x y: det J = 1 - s y, zero first at s = 1, where y = 1.
        found = self.summary("info", self.cube, "--warp-limit", "p", "--warp-direction", "-1,0,0")
        limit = found["warp_limit"]
        self.assertLessEqual(limit["positive_below"], 1.0)
        self.assertGreaterEqual(limit["inverted_at"], 1.0 - 1e-12)
        self.assertAlmostEqual(limit["positive_below"], 1.0, delta=1e-6)
        self.assertAlmostEqual(limit["inverted_at"], 1.0, delta=1e-6)
        self.assertEqual((limit["element"], limit["left_out"]), (0, 0))

    def test_negative_scales(self):
        found = self.summary("info", self.cube, "--warp-limit", "p=-1", "--warp-direction", "1,0,0")
        limit = found["warp_limit"]
        self.assertGreaterEqual(limit["positive_below"], -1.0)
        self.assertAlmostEqual(limit["positive_below"], -1.0, delta=1e-6)
        self.assertAlmostEqual(limit["inverted_at"], -1.0, delta=1e-6)
        # The numbers of the table hold, too.
        text = self.succeeds("info", self.cube, "--warp-limit", "p=-1", "--warp-direction", "1,0,0").stdout
        self.assertIn("between 0 and -0.99999", text)

    def test_a_displacement_that_is_zero_between_elements(self):
        """One node inside one of two hexahedra of order 2 moves; rounding at the others is no jump."""
        grid = self.folder / "two.vtu"
        points, cells, moved = [], [], []
        edge = [(0, 0), (2, 0), (2, 2), (0, 2)]
        for x in (0.0, 1.0):
            corners = [(i, j, k) for k in (0, 2) for i, j in edge]
            edges = [tuple((a + b) // 2 for a, b in zip(corners[s], corners[t]))
                     for s, t in [(0, 1), (1, 2), (2, 3), (3, 0), (4, 5), (5, 6), (6, 7), (7, 4),
                                  (0, 4), (1, 5), (2, 6), (3, 7)]]
            faces = [(0, 1, 1), (2, 1, 1), (1, 0, 1), (1, 2, 1), (1, 1, 0), (1, 1, 2), (1, 1, 1)]
            nodes = corners + edges + faces
            cells.append((29, list(range(len(points), len(points) + 27))))
            points += [(x + i / 2, j / 2, k / 2) for i, j, k in nodes]
            moved += [0.1 if x == 1.0 and node == (2, 1, 1) else 0.0 for node in nodes]
        grid.write_text(plain_grid(points, cells, [("p", moved)]), encoding="utf-8")
        limit = self.summary(
            "info", grid, "--warp-limit", "p", "--warp-direction", "-1,0,0")["warp_limit"]
        self.assertEqual((limit["left_out"], limit["element"]), (0, 1))
        self.assertGreater(limit["positive_below"], 0.0)
        self.assertLess(limit["inverted_at"] - limit["positive_below"], 1e-5)

    def test_verdicts_of_deformed_meshes_agree(self):
        limit = self.summary("info", *BEAM, "--warp-limit", "displacement")["warp_limit"]
        for scale, inverted in [(limit["positive_below"] * 0.999, 0), (limit["inverted_at"] * 1.001, 1)]:
            found = self.summary("info", *BEAM, "--warp", f"displacement={scale!r}", "--certify")
            self.assertEqual(min(found["jacobian"]["inverted"], 1), inverted)


class WrongUse(WarpTest):
    def test_messages(self):
        for status, arguments, message in [
            (2, ["--warp", "p=nan"], "FIELD or FIELD=SCALE with a finite number"),
            (2, ["--warp", "=2"], "FIELD or FIELD=SCALE"),
            (1, ["--warp", "p"], "'p' is a scalar, and a displacement is a vector"),
            (1, ["--warp", "d"], "there is no field 'd'"),
            (2, ["--warp-direction", "0,0,1"], "without --warp or --warp-limit"),
        ]:
            self.fails(status, "info", self.cube, *arguments, names=[message])
        self.fails(1, "info", case("periodic_hex_dg_g3_p4"), "--warp", "u", "--warp-direction",
            "0,0,1", names=["between elements, which would come apart"])


if __name__ == "__main__":
    unittest.main()
