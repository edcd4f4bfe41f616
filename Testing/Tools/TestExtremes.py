# SPDX-License-Identifier: BSD-3-Clause
"""pixelexact info --extremes: against dense samples, the probe at the places, and closed forms."""

import unittest

import numpy as np

from tool import CUBE, DATA, ToolTest, case, plain_grid, read_csv, unit_cube_grid

# Files and fields.
SAMPLED = [
    (["toroid_hex_g3_p6.vtu"], "u"),
    (["escher_tet_g3_p3.vtu"], "u"),
    (["toroid_prism_g3_p4.vtu"], "u"),
    (["toroid_prism_g3_p4.vtu"], "mag(grad(u))"),
    (["toroid_hex_g3_p6.vtu"], "u^2 + x"),
    (["nek_pyramid_curved_p6/nek_pyramid_curved_p6.xml", "nek_pyramid_curved_p6/nek_pyramid_curved_p6.fld"], "u"),
    (["nek_tet_varp/nek_tet_varp.xml", "nek_tet_varp/nek_tet_varp.fld"], "u"),
]
# The nodes of VTK's hexahedron with 27 nodes, in units of 1/2.
NODES_27 = [
    (0, 0, 0), (2, 0, 0), (2, 2, 0), (0, 2, 0), (0, 0, 2), (2, 0, 2), (2, 2, 2), (0, 2, 2),
    (1, 0, 0), (2, 1, 0), (1, 2, 0), (0, 1, 0), (1, 0, 2), (2, 1, 2), (1, 2, 2), (0, 1, 2),
    (0, 0, 1), (2, 0, 1), (2, 2, 1), (0, 2, 1),
    (0, 1, 1), (2, 1, 1), (1, 0, 1), (1, 2, 1), (1, 1, 0), (1, 1, 2), (1, 1, 1),
]  # fmt: skip


class Extremes(ToolTest):
    def extremes(self, *arguments):
        return self.summary("info", *arguments)["extremes"]

    def probed(self, files, field, points):
        table, out = self.folder / "points.csv", self.folder / "values.csv"
        lines = [",".join(repr(float(x)) for x in point) for point in points]
        table.write_text("x,y,z\n" + "\n".join(lines) + "\n", encoding="utf-8")
        self.succeeds("probe", *files, "--field", field, "--points", table, "--output", out)
        return read_csv(out)

    def cube_of_27(self, function):
        points = np.array(NODES_27) / 2.0
        path = self.folder / "cube.vtu"
        values = [function(*point) for point in points]
        path.write_text(
            plain_grid(points.tolist(), [(29, list(range(27)))], [("u", values)]), encoding="utf-8")
        return path

    def test_samples_lie_within_the_bounds_and_the_probe_finds_the_values(self):
        random = np.random.default_rng(3)
        for names, field in SAMPLED:
            with self.subTest(names=names, field=field):
                files = [DATA / name for name in names]
                facts = self.summary("info", *files, "--extremes", field)
                known = facts["extremes"]["fields"][0]["components"][0]
                low, high = known["minimum"], known["maximum"]
                box = np.array(facts["bounds"]).reshape(3, 2)
                points = random.uniform(box[:, 0], box[:, 1], (20000, 3))
                rows = self.probed(files, field, points)
                values = np.array([float(r["value"]) for r in rows if r["verdict"] == "inside"])
                self.assertGreater(len(values), 500)
                self.assertGreaterEqual(values.min(), low["bound"])
                self.assertLessEqual(values.max(), high["bound"])
                self.assertTrue(known["tolerance_met"])
                self.assertLessEqual(low["value"], values.min())
                self.assertGreaterEqual(high["value"], values.max())
                size = max(abs(low["value"]), abs(high["value"]))
                for end, sign in ((low, 1.0), (high, -1.0)):
                    self.assertLessEqual(sign * end["bound"], sign * end["value"])
                    self.assertLessEqual(sign * end["bound"], sign * end["attained"])
                    self.assertLessEqual(end["gap"], 1e-9 * (high["value"] - low["value"]) + 1e-12 * size)
                    if field == "mag(grad(u))":
                        continue  # on faces each element has its own slope
                    found = self.probed(files, field, [end["position"]])[0]
                    self.assertEqual(found["verdict"], "inside")
                    self.assertAlmostEqual(float(found["value"]), end["value"], delta=1e-12 * size)

    def test_an_extreme_inside_an_element(self):
        path = self.cube_of_27(lambda x, y, z: 3.0 - (x - 0.25) ** 2 - 2.0 * (y - 0.625) ** 2 - (z - 0.5) ** 2)
        known = self.extremes(path, "--extremes", "u")["fields"][0]
        self.assertFalse(known["discontinuous"])
        high, low = known["components"][0]["maximum"], known["components"][0]["minimum"]
        self.assertAlmostEqual(high["value"], 3.0, delta=1e-9)
        self.assertGreaterEqual(high["bound"], 3.0)
        self.assertLessEqual(high["attained"], 3.0)
        np.testing.assert_allclose(high["position"], [0.25, 0.625, 0.5], rtol=0, atol=1e-4)
        # The farthest corner; z = 0 and z = 1 are as far.
        self.assertAlmostEqual(low["value"], 3.0 - 0.5625 - 2.0 * 0.390625 - 0.25, delta=1e-13)
        np.testing.assert_allclose(low["position"][:2], [1.0, 0.0], rtol=0, atol=1e-15)
        self.assertEqual((low["element"], high["element"]), (0, 0))

    def test_expressions_and_several_fields(self):
        path = self.cube_of_27(lambda x, y, z: x + y)
        first, second = self.extremes(path, "--extremes", "sin(3*u)", "--extremes", "grad(u)")["fields"]
        high = first["components"][0]["maximum"]
        self.assertAlmostEqual(high["value"], 1.0, delta=1e-9)
        self.assertAlmostEqual(sum(high["position"][:2]), np.pi / 6.0, delta=1e-4)
        self.assertEqual(len(second["components"]), 3)
        self.assertAlmostEqual(second["magnitude"]["minimum"]["value"], np.sqrt(2.0), delta=1e-12)
        self.assertAlmostEqual(second["components"][2]["maximum"]["value"], 0.0, delta=1e-12)

    def test_a_pole_has_no_bound(self):
        path = self.cube_of_27(lambda x, y, z: x - 1.0 / 3.0)
        done = self.succeeds("info", path, "--extremes", "1/u")
        self.assertIn("no bound was found", done.stdout)
        known = self.extremes(path, "--extremes", "1/u")["fields"][0]["components"][0]
        self.assertIsNone(known["maximum"]["bound"])
        self.assertIsNone(known["minimum"]["bound"])
        self.assertEqual(known["unbounded_elements"], 1)
        self.assertFalse(known["tolerance_met"])

    def test_what_is_not_finite_is_left_out(self):
        cube = self.folder / "cube.vtu"
        values = [float("nan")] + [point[0] for point in CUBE[1:]]
        cube.write_text(unit_cube_grid([("u", values)]), encoding="utf-8")
        known = self.extremes(cube, "--extremes", "u")["fields"][0]["components"][0]
        self.assertEqual(known["not_finite_elements"], 1)
        self.assertIsNone(known["minimum"]["value"])
        self.assertIn("no value is finite", self.succeeds("info", cube, "--extremes", "u").stdout)

    def test_discontinuous_fields_and_inverted_elements_are_named(self):
        done = self.succeeds("info", case("periodic_hex_dg_g3_p4"), "--extremes", "u")
        self.assertIn("discontinuous: values are those of the named elements", done.stdout)
        # The first corner is moved beyond the centre.
        points = [[0.9, 0.9, 0.9]] + CUBE[1:]
        path = self.folder / "folded.vtu"
        path.write_text(
            plain_grid(points, [(12, list(range(8)))], [("u", [p[0] for p in points])]), encoding="utf-8")
        facts = self.extremes(path, "--extremes", "u")
        self.assertEqual(facts["inverted_elements"], 1)
        self.assertIn("1 element inverted", self.succeeds("info", path, "--extremes", "u").stdout)

    def test_a_plane_mesh(self):
        folder = DATA / "nek_plane_kovasznay_p7"
        files = [folder / "nek_plane_kovasznay_p7.xml", folder / "nek_plane_kovasznay_p7.rst"]
        known = self.extremes(*files, "--extremes", "u")["fields"][0]["components"][0]
        for end in (known["minimum"], known["maximum"]):
            self.assertEqual(end["position"][2], 0.0)
            found = self.probed(files, "u", [end["position"]])[0]
            self.assertAlmostEqual(float(found["value"]), end["value"], delta=1e-12)

    def test_refusals(self):
        path = case("toroid_hex_g3_p6")
        self.fails(1, "info", path, "--extremes", "nothing", names=["nothing"])
        self.fails(1, "info", path, "--extremes", "jump(u)", names=["jump"])
        self.fails(2, "info", path, "--extremes", "u", "--plane", "z=0", names=["--plane"])
        self.fails(2, "info", path, "--extremes", "u", "--boundary", names=["--boundary"])

    def test_any_number_of_threads_gives_the_same_answer(self):
        answers = []
        for threads in (1, 2):
            facts = self.extremes(case("toroid_prism_g3_p4"), "--extremes", "u", "--threads", threads)
            del facts["seconds"]
            answers.append(facts)
        self.assertEqual(*answers)


if __name__ == "__main__":
    unittest.main()
