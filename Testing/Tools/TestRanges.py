# SPDX-License-Identifier: BSD-3-Clause
"""The ends of colour maps: the cut's, the field's, given ones; and values without a logarithm."""

import unittest

import numpy as np

from tool import CUBE, ToolTest, case, read_buffers, read_image, strict_json, unit_cube_grid
from tool import run

HALF = ("--plane", "0,0,0.5,0,0,1")


class RangeTest(ToolTest):
    def setUp(self):
        super().setUp()
        self.image, self.buffers = self.folder / "i.png", self.folder / "b.vti"

    def cube(self, function):
        """[0,1]^3 with a field that is linear along each edge."""
        path = self.folder / "cube.vtu"
        path.write_text(unit_cube_grid([("u", [function(*p) for p in CUBE])]), encoding="utf-8")
        return path

    def render(self, source, *options, plane=HALF):
        """Summary, buffers, picture and what stderr holds."""
        done = run(
            "render", source, "--field", "u", *plane, "--size", "41x31", "--colormap", "grayscale",
            "--output", self.image, "--buffers", self.buffers, *options, "--json",
        )
        self.assertEqual(done.returncode, 0, done.stderr)
        summary = strict_json(done.stdout)
        return summary, read_buffers(self.buffers), read_image(self.image), done.stderr


class Ranges(RangeTest):
    def test_cut_is_the_default(self):
        cube = self.cube(lambda x, y, z: x + 10 * z)
        for options in [[], ["--range", "cut"], ["--layer", "1:range=cut"]]:
            summary, buffers, _, _ = self.render(cube, *options)
            seen = buffers["Value"][buffers["Verdict"] == 1]
            self.assertEqual(summary["color_range"], [seen.min(), seen.max()])
            self.assertEqual(summary["beyond_range"], {"below": 0, "above": 0})

    def test_field_encloses_all_values(self):
        """x + 10 z over the cube is [0, 11], attained at vertices; the cut shows [5, 6]."""
        cube = self.cube(lambda x, y, z: x + 10 * z)
        for options in [["--range", "field"], ["--layer", "1:range=field"]]:
            summary, _, _, _ = self.render(cube, *options)
            low, high = summary["color_range"]
            self.assertTrue(-1e-13 < low <= 0 and 11 <= high < 11 + 1e-13, (low, high))

    def test_field_of_a_solver(self):
        """No nodal value of the file, each of which is one of the field's, lies outside."""
        from vtkmodules.util.numpy_support import vtk_to_numpy
        from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader

        reader = vtkXMLUnstructuredGridReader()
        reader.SetFileName(str(case("toroid_hex_g3_p6")))
        reader.Update()
        nodal = vtk_to_numpy(reader.GetOutput().GetPointData().GetArray("u"))
        middle = ["--plane", "0,0,0,0,0,1"]
        summary, _, _, _ = self.render(
            case("toroid_hex_g3_p6"), "--range", "field", plane=middle
        )
        low, high = summary["color_range"]
        spread = nodal.max() - nodal.min()
        self.assertTrue(nodal.min() - 0.1 * spread < low <= nodal.min() + 1e-12)
        self.assertTrue(nodal.max() - 1e-12 <= high < nodal.max() + 0.1 * spread)

    def test_magnitudes(self):
        path = self.folder / "v.vtu"
        vectors = [[3 * p[0], 4 * p[0], 0.0] for p in CUBE]
        path.write_text(unit_cube_grid([("u", vectors)]), encoding="utf-8")
        low, high = self.render(path, "--range", "field")[0]["color_range"]
        self.assertTrue(-0.01 <= low <= 0 and 5 <= high < 5.01, (low, high))

    def test_pixels_beyond_given_ends_are_counted(self):
        cube = self.cube(lambda x, y, z: x)
        summary, buffers, image, _ = self.render(cube, "--range", "0.25,0.5")
        exact = buffers["Verdict"] == 1
        below, above = exact & (buffers["Value"] < 0.25), exact & (buffers["Value"] > 0.5)
        self.assertGreater(min(below.sum(), above.sum()), 50)
        self.assertEqual(
            summary["beyond_range"], {"below": below.sum(), "above": above.sum()}
        )
        self.assertTrue((image[below] == 0).all() and (image[above] == 255).all())

    def test_each_layer_its_own(self):
        cube = self.cube(lambda x, y, z: x)
        two = [*HALF, "--plane", "0,0,0.25,0,0,1"]
        summary, _, _, _ = self.render(cube, "--layer", "2:range=-1:3", plane=two)
        first, second = (layer["color_range"] for layer in summary["layers"])
        self.assertEqual((first, second), (summary["value_range"], [-1, 3]))

    def test_what_is_no_range(self):
        base = ["render", self.cube(lambda x, y, z: x), *HALF, "--output", self.image]
        for text in ["auto", "0", "1,0", "0,1,2", "cut,field", "nan,1", "0,inf", "0:1"]:
            self.fails(2, *base, "--range", text, names=["--range", f"'{text}'"])
        for text in ["0,1", "1:0", "all"]:
            self.fails(2, *base, "--layer", f"1:range={text}", names=["--layer"])


class Logarithms(RangeTest):
    def test_values_without_logarithm_are_counted_and_told(self):
        cube = self.cube(lambda x, y, z: 2 * x - 1)
        summary, buffers, image, told = self.render(cube, "--log", "--nan-color", "1,0,0")
        exact = buffers["Verdict"] == 1
        none = exact & (buffers["Value"] <= 0)
        self.assertGreater(none.sum(), 50)
        lost = buffers["Value"][none]
        self.assertEqual(
            summary["no_logarithm"], {"pixels": none.sum(), "values": [lost.min(), lost.max()]}
        )
        self.assertEqual(summary["beyond_range"], {"below": 0, "above": 0})
        self.assertTrue((image[none] == [255, 0, 0]).all())
        for word in ["warning", "--log", f"{none.sum()} pixels", f"{lost.min():g}", "--nan-color"]:
            self.assertIn(word, told)

    def test_nothing_is_told_where_all_have_one(self):
        summary, _, _, told = self.render(self.cube(lambda x, y, z: 1 + x), "--log")
        self.assertNotIn("no_logarithm", summary)
        self.assertEqual(told, "")

    def test_ranges_that_are_not_above_zero(self):
        source = self.cube(lambda x, y, z: 2 * x - 1)
        base = ["render", source, "--field", "u", *HALF, "--output", self.image, "--log"]
        for text in ["0,1", "-1,1", "-2,-1"]:
            self.fails(2, *base, "--range", text, names=["--range", "--log", "above 0"])
            layer = text.replace(",", ":")
            self.fails(2, *base, "--layer", f"1:range={layer}", names=["--layer", "above 0"])
        self.fails(1, *base, "--range", "field", names=["--range field", "'u'", "above"])


class NotFinite(RangeTest):
    def test_a_value_that_is_no_number_is_told(self):
        source = self.cube(lambda x, y, z: float("nan") if x + y + z == 0 else 1.0)
        summary, _, _, told = self.render(source)
        self.assertGreater(summary["non_finite"], 0)
        for word in ["warning", f"{summary['non_finite']} pixels", "NaN", "--nan-color"]:
            self.assertIn(word, told)


if __name__ == "__main__":
    unittest.main()
