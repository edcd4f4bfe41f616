# SPDX-License-Identifier: BSD-3-Clause
"""pixelexact info --jumps: closed forms, and the probe on both sides of faces."""

import unittest

import numpy as np

import lagrange
from tool import CUBE, DATA, ToolTest, case, plain_grid, read_buffers, read_csv


def cubes(boxes):
    """Cubes that share no points, as (corner, size, function of x, y, z)."""
    points, cells, values = [], [], []
    for corner, size, function in boxes:
        first = len(points)
        for p in CUBE:
            points.append([c + size * x for c, x in zip(corner, p, strict=True)])
            values.append(function(*points[-1]))
        cells.append((12, list(range(first, first + 8))))
    return plain_grid(points, cells, [("u", values)])


class Jumps(ToolTest):
    def jumps(self, *arguments):
        return self.summary("info", *arguments)["jumps"]["fields"][0]

    def write(self, boxes):
        path = self.folder / "cubes.vtu"
        path.write_text(cubes(boxes), encoding="utf-8")
        return path

    def test_two_cubes(self):
        path = self.write([
            ([0, 0, 0], 1.0, lambda x, y, z: x),
            ([1, 0, 0], 1.0, lambda x, y, z: 2 * x + y),
            ([0, 1, 0], 1.0, lambda x, y, z: x),
        ])  # fmt: skip
        found = self.jumps(path, "--jumps", "u")
        # |1 + y| on x = 1, and none on y = 1.
        self.assertEqual((found["faces"], found["proven_faces"], found["zero_faces"]), (2, 2, 1))
        self.assertGreaterEqual(found["bound"], 2.0)
        self.assertLessEqual(found["bound"], 2.0 * 1.05)
        self.assertGreater(found["largest"], 1.95)
        self.assertLessEqual(found["largest"], 2.0 + 1e-14)
        self.assertAlmostEqual(found["l2"], np.sqrt(7.0 / 3.0), delta=1e-12)
        self.assertAlmostEqual(found["area"], 2.0, delta=1e-13)
        self.assertEqual(found["worst"][0]["elements"], [0, 1])
        self.assertAlmostEqual(found["worst"][0]["position"][0], 1.0, delta=1e-14)
        text = self.succeeds("info", path, "--jumps", "u").stdout
        self.assertRegex(text, r"u: largest 1\.9\d+, proven at most 2\.")
        self.assertIn("elements 0 and 1, at (1, ", text)

    def test_numpy_quadrature(self):
        path = case("periodic_hex_dg_g3_p4")
        found = self.jumps(path, "--jumps", "u")
        area, l2 = lagrange.jumps(lagrange.read_hexahedra(path))
        self.assertAlmostEqual(found["area"], area, delta=1e-12 * area)
        self.assertAlmostEqual(found["l2"], l2, delta=1e-12 * l2)
        area, l2 = lagrange.jumps(lagrange.read_hexahedra(case("toroid_hex_g3_p6")))
        self.assertLess(l2, 1e-12)

    def test_hanging_faces(self):
        small = [([1, y, z], 0.5, lambda x, y, z: x + y) for y in (0, 0.5) for z in (0, 0.5)]
        path = self.write([([0, 0, 0], 1.0, lambda x, y, z: x), *small])
        found = self.jumps(path, "--jumps", "u")
        # |y| on x = 1; between the small ones there are four faces of area 1/4 without a jump.
        self.assertEqual(found["faces"], 8)
        self.assertEqual(found["proven_faces"], 4)
        self.assertIsNone(found["bound"])
        self.assertAlmostEqual(found["l2"], np.sqrt(1.0 / 3.0), delta=1e-12)
        self.assertAlmostEqual(found["area"], 2.0, delta=1e-12)
        self.assertEqual(found["zero_faces"], 4)
        self.assertIn("numeric on 4 faces, proven on 4", self.succeeds("info", path, "--jumps", "u").stdout)

    def test_continuous_fields_are_zero_within_rounding(self):
        for name in ("toroid_hex_g3_p6", "escher_tet_g3_p3", "toroid_prism_g3_p4"):
            found = self.jumps(case(name), "--jumps", "u")
            self.assertTrue(found["zero_within_rounding"], name)
            self.assertLess(found["bound"], 1e-11 * found["largest_value"])
            self.assertEqual(found["proven_faces"], found["faces"])
        self.assertIn("zero within rounding",
            self.succeeds("info", case("toroid_hex_g3_p6"), "--jumps", "u").stdout)

    def test_the_probe_on_both_sides(self):
        darcy = DATA / "mfem_escher_tet_darcy_p3"
        for files, field in (
            ([case("periodic_hex_dg_g3_p4")], "u"),
            ([darcy / "mfem_escher_tet_darcy_p3.mesh", darcy / "pressure.gf"], "pressure"),
        ):
            found = self.jumps(*files, "--jumps", field)
            self.assertEqual(found["proven_faces"], found["faces"])
            self.assertEqual(found["largest"], found["worst"][0]["largest"])
            step = 1e-7
            random = np.random.default_rng(1)
            for face in found["worst"]:
                self.assertLessEqual(face["largest"], face["bound"])
                self.assertLessEqual(face["bound"], 1.05 * face["largest"] + 1e-12)
                table, out = self.folder / "points.csv", self.folder / "values.csv"
                points = np.array(face["position"]) + step * random.uniform(-1, 1, (200, 3))
                np.savetxt(table, points, delimiter=",", header="x,y,z", comments="", fmt="%.17g")
                self.succeeds("probe", *files, "--field", field, "--points", table, "--output", out)
                sides = {element: [] for element in face["elements"]}
                for row in read_csv(out):
                    if row["verdict"] == "inside" and int(row["element"]) in sides:
                        sides[int(row["element"])].append(float(row["value"]))
                one, other = (np.mean(values) for values in sides.values())
                self.assertAlmostEqual(abs(one - other), face["largest"], delta=1e-4)

    def test_expressions_and_mapped_fields_are_numeric(self):
        path = self.write([
            ([0, 0, 0], 1.0, lambda x, y, z: x * y),
            ([1, 0, 0], 1.0, lambda x, y, z: x * y),
        ])  # fmt: skip
        found = self.jumps(path, "--jumps", "grad(u)")
        # Trilinear: grad u is continuous here.
        self.assertTrue(found["zero_within_rounding"])
        self.assertEqual(found["proven_faces"], 0)
        darcy = DATA / "mfem_escher_tet_darcy_p3"
        found = self.jumps(darcy / "mfem_escher_tet_darcy_p3.mesh", darcy / "flux.gf", "--jumps", "flux")
        self.assertEqual(found["proven_faces"], 0)
        self.assertGreater(found["largest"], 0.0)

    def test_plane_meshes(self):
        folder = DATA / "nek_plane_kovasznay_p7"
        files = [folder / "nek_plane_kovasznay_p7.xml", folder / "nek_plane_kovasznay_p7.rst"]
        found = self.jumps(*files, "--jumps", "u")
        self.assertLess(found["largest"], 1e-8)
        self.assertEqual(found["worst"][0]["position"][2], 0.0)

    def test_faces_as_a_surface(self):
        path = self.write([
            ([0, 0, 0], 1.0, lambda x, y, z: x),
            ([1, 0, 0], 1.0, lambda x, y, z: 2 * x + y),
        ])  # fmt: skip
        image, buffers = self.folder / "i.png", self.folder / "b.vti"
        view = ["--camera-position", "5,0.5,0.5", "--focal-point", "1,0.5,0.5", "--view-up", "0,0,1",
            "--parallel-scale", 0.6, "--size", "48x48", "--output", image, "--buffers", buffers]
        self.succeeds("render", path, "--faces", "--field", "jump(u)", *view)
        found = read_buffers(buffers)
        exact = found["Verdict"] == 1
        x = found["Position"][exact]
        # The face is 1 / 1.2 of the picture's side.
        self.assertEqual(exact.sum(), 40 * 40)
        np.testing.assert_allclose(x[:, 0], 1.0, rtol=0, atol=1e-15)
        np.testing.assert_allclose(found["Value"][exact], 1.0 + x[:, 1], rtol=0, atol=1e-13)
        self.assertEqual(set(found["Element"][exact].tolist()), {0})
        # The boundary, which has no jumps, is another surface.
        self.succeeds("render", path, "--faces", "--boundary", "--field", "u", *view)
        self.assertEqual((read_buffers(buffers)["Position"][exact][:, 0] == 2.0).all(), True)
        alone = self.write([([0, 0, 0], 1.0, lambda x, y, z: x)])
        self.fails(1, "render", alone, "--faces", "--field", "u", *view, names=["--faces", "no face"])

    def test_refusals(self):
        path = case("toroid_hex_g3_p6")
        self.fails(1, "info", path, "--jumps", "nothing", names=["nothing"])
        self.fails(1, "info", path, "--jumps", "jump(u)", names=["jump"])

    def test_a_single_element_has_no_face_between_elements(self):
        path = self.write([([0, 0, 0], 1.0, lambda x, y, z: x)])
        self.assertEqual(self.jumps(path, "--jumps", "u")["faces"], 0)
        self.assertIn("no face between elements", self.succeeds("info", path, "--jumps", "u").stdout)

    def test_any_number_of_threads_gives_the_same_answer(self):
        answers = []
        for threads in (1, 2):
            answers.append(self.jumps(case("periodic_hex_dg_g3_p4"), "--jumps", "u", "--threads", threads))
        self.assertEqual(*answers)


if __name__ == "__main__":
    unittest.main()
