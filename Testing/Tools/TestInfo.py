# SPDX-License-Identifier: BSD-3-Clause
"""pixelexact info: what a file holds."""

import unittest

import numpy as np

from tool import CASES, CUBE, ToolTest, case, oracle, plain_grid, unit_cube_grid

# Shape, number of elements, orders of the geometry, order at which the file stores it, continuity.
FACTS = {
    "toroid_hex_g3_p6": ("hexahedron", 48, {"3"}, "6", "continuous"),
    "escher_tet_g3_p3": ("tetrahedron", 42, {"3"}, "3", "continuous"),
    "toroid_prism_g3_p4": ("prism", 48, {"3"}, "4", "continuous"),
    "fichera_hex_g3_p4": ("hexahedron", 56, {"3"}, "4", "continuous"),
    "periodic_hex_dg_g3_p4": ("hexahedron", 27, {"3"}, "4", "discontinuous"),
    "dolfinx_hex_g2_p4": ("hexahedron", 54, {"1", "2"}, "4", "continuous"),
}


class Info(ToolTest):
    def write(self, text):
        path = self.folder / "mesh.vtu"
        path.write_text(text, encoding="utf-8")
        return path

    def test_cases(self):
        for name, (shape, elements, orders, stored, continuity) in FACTS.items():
            with self.subTest(name=name):
                summary = self.summary("info", case(name))
                self.assertEqual(summary["elements"], elements)
                self.assertEqual(summary["shapes"], {shape: elements})
                self.assertEqual(set(summary["geometry_orders"]), orders)
                self.assertEqual(sum(summary["geometry_orders"].values()), elements)
                self.assertEqual(summary["stored_geometry_orders"], {stored: elements})
                self.assertEqual(summary["skipped_cells"], 0)
                field = next(f for f in summary["fields"] if f["name"] == "u")
                self.assertEqual(field["orders"], {str(CASES[name]): elements})
                self.assertEqual(field["components"], 1)
                self.assertEqual(field["continuity"], continuity)
                self.assertEqual(field["non_finite_elements"], 0)

    def test_text(self):
        text = self.succeeds("info", case("toroid_hex_g3_p6")).stdout
        field = "u: scalar, order 6, continuous"
        for word in ["48 hexahedra", "order 3", "stored as order 6", field]:
            self.assertIn(word, text)

    def test_ranges(self):
        rows = [[p[1] - 0.25, 4.0 * p[2], 3.0] for p in CUBE]
        gap = [p[0] if p[0] < 1.0 else float("nan") for p in CUBE]
        path = self.write(unit_cube_grid([("u", [p[0] for p in CUBE]), ("v", rows), ("w", gap)]))
        u, v, w = self.summary("info", path)["fields"]
        np.testing.assert_allclose(u["ranges"], [[0.0, 1.0]], rtol=0, atol=1e-14)
        self.assertNotIn("magnitude_range", u)
        np.testing.assert_allclose(
            v["ranges"], [[-0.25, 0.75], [0.0, 4.0], [3.0, 3.0]], rtol=0, atol=1e-14)
        lower, upper = v["magnitude_range"]
        self.assertAlmostEqual(upper, np.hypot(5.0, 0.75), delta=0.002)
        self.assertAlmostEqual(lower, 3.0, delta=0.002)
        self.assertEqual(w["ranges"], [None])
        text = self.succeeds("info", path).stdout
        for words in ["values 0 to 1", "component 1 0 to 4", "values not finite"]:
            self.assertIn(words, text)

    def test_the_component_across_a_plane_mesh_is_zero(self):
        mesh, field = self.folder / "square.mesh", self.folder / "e.gf"
        mesh.write_text(
            "MFEM mesh v1.0\n\ndimension\n2\n\nelements\n1\n1 3 0 1 2 3\n\nboundary\n0\n\n"
            "vertices\n4\n2\n0 0\n1 0\n1.25 1\n0 1\n",
            encoding="utf-8",
        )
        field.write_text(
            "FiniteElementSpace\nFiniteElementCollection: ND_2D_P1\nVDim: 1\nOrdering: 0\n\n1\n2\n-1\n0.5\n",
            encoding="utf-8",
        )
        ranges = self.summary("info", mesh, field)["fields"][0]["ranges"]
        self.assertGreater(ranges[0][1], ranges[0][0])
        self.assertEqual(ranges[2], [0.0, 0.0])

    def test_ranges_hold_the_oracle(self):
        for name in CASES:
            field = next(f for f in self.summary("info", case(name))["fields"] if f["name"] == "u")
            (lower, upper), values = field["ranges"][0], oracle(name)["u"]
            beyond = 1e-3 * (upper - lower)
            self.assertLess(upper - lower, 3.0 * np.ptp(values), name)
            self.assertLessEqual(lower - beyond, values.min(), name)
            self.assertGreaterEqual(upper + beyond, values.max(), name)

    def test_bounds(self):
        summary = self.summary("info", case("toroid_hex_g3_p6"))
        low_x, high_x, _, _, low_z, high_z = summary["node_bounds"]
        self.assertAlmostEqual(low_x, -1.4)
        self.assertLess(high_x, 1.4)
        self.assertAlmostEqual(low_z, -0.4)
        self.assertAlmostEqual(high_z, 0.4)
        self.assertEqual(summary["node_bounds_of"], "nodes")
        bounds, nodes = np.array(summary["bounds"]), np.array(summary["node_bounds"])
        np.testing.assert_allclose(bounds[[0, 4, 5]], [-1.4, -0.4, 0.4], rtol=0, atol=3e-3)
        self.assertTrue((bounds[::2] < nodes[::2] + 3e-3).all() and (bounds[1::2] > nodes[1::2] - 3e-3).all())

    def test_bounds_are_those_of_curved_sides(self):
        """A side y = 0.24 s^2 - 0.32 s is lowest at s = 2 / 3, between its nodes and below the corners."""
        mesh = self.folder / "bulge.msh"
        mesh.write_text(
            "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n6\n1 0 0 0\n2 1 -0.08 0\n3 0 1 0\n4 0.5 -0.1 0\n"
            "5 0.5 0.46 0\n6 0 0.5 0\n$EndNodes\n$Elements\n1\n1 9 2 1 1 1 2 3 4 5 6\n$EndElements\n",
            encoding="utf-8",
        )
        rows = dict(row.split(maxsplit=1) for row in self.succeeds("info", mesh).stdout.splitlines())
        self.assertTrue(rows["bounds"].startswith("x 0 to 1, y -0.10"), rows["bounds"])
        self.assertEqual(rows["elements"], "1: 1 triangle")
        summary = self.summary("info", mesh)
        low_x, high_x, low_y, high_y = summary["bounds"][:4]
        self.assertAlmostEqual(low_y, -8.0 / 75.0, delta=1.2e-3)
        np.testing.assert_allclose([low_x, high_x, high_y], [0.0, 1.0, 1.0], rtol=0, atol=1e-14)
        self.assertEqual(summary["node_bounds_of"], "corners")
        self.assertAlmostEqual(summary["node_bounds"][2], -0.08)

    def test_mixed_shapes_fields_and_skipped_cells(self):
        points = CUBE + [[0.5, 0.5, 2.0], [2.0, 0.5, 0.0], [2.0, 0.5, 1.0], [-1.0, 0.5, 0.5]]
        cells = [
            (9, [0, 1, 2, 3]),
            (12, list(range(8))),
            (14, [4, 5, 6, 7, 8]),
            (13, [1, 9, 2, 5, 10, 6]),
            (10, [0, 3, 7, 11]),
        ]
        scalars = [x + y for x, y, _ in points]
        material = ("material", [9.0, 1.0, 2.0, 3.0, 4.0])
        text = plain_grid(points, cells, [("u", scalars), ("v", points)], [material])
        summary = self.summary("info", self.write(text))
        self.assertEqual(summary["elements"], 4)
        self.assertEqual(summary["skipped_cells"], 1)
        shapes = {"hexahedron": 1, "prism": 1, "tetrahedron": 1, "pyramid": 1}
        self.assertEqual(summary["shapes"], shapes)
        fields = {field["name"]: field for field in summary["fields"]}
        self.assertEqual(fields["u"]["continuity"], "continuous")
        self.assertEqual(fields["v"]["components"], 3)
        self.assertEqual(fields["v"]["continuity"], "continuous")
        self.assertEqual(fields["material"]["orders"], {"0": 4})
        self.assertEqual(fields["material"]["continuity"], "discontinuous")

    def test_a_single_element_has_no_neighbour_to_compare_with(self):
        text = plain_grid(np.eye(4, 3), [(10, [0, 1, 2, 3])], [("u", np.arange(4.0))])
        summary = self.summary("info", self.write(text))
        self.assertEqual(summary["fields"][0]["continuity"], "unknown")

    def test_a_name_that_json_must_escape(self):
        text = plain_grid(np.eye(4, 3), [(10, [0, 1, 2, 3])], [("a&quot;\\ é", np.arange(4.0))])
        summary = self.summary("info", self.write(text))
        self.assertEqual(summary["fields"][0]["name"], 'a"\\ é')

    def test_no_fields(self):
        text = plain_grid(np.eye(4, 3), [(10, [0, 1, 2, 3])])
        self.assertEqual(self.summary("info", self.write(text))["fields"], [])


if __name__ == "__main__":
    unittest.main()
