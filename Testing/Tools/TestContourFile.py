# SPDX-License-Identifier: BSD-3-Clause
"""Contours written as polylines."""

import unittest

import numpy as np

from tool import ToolTest, case, unit_cube_grid


def read_lines(path):
    """Points, point arrays and cell arrays of a .vtp."""
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

    reader = vtkXMLPolyDataReader()
    reader.SetFileName(str(path))
    reader.Update()
    lines = reader.GetOutput()

    def arrays(data):
        return {
            data.GetArrayName(i): vtk_to_numpy(data.GetArray(i))
            for i in range(data.GetNumberOfArrays())
        }

    return (
        vtk_to_numpy(lines.GetPoints().GetData()),
        arrays(lines.GetPointData()),
        arrays(lines.GetCellData()),
    )


class ContourFile(ToolTest):
    def setUp(self):
        super().setUp()
        self.lines = self.folder / "lines.vtp"
        self.more = ["--size", "40x40", "--output", self.folder / "i.png"]
        self.more += ["--contours-output", self.lines]

    def test_values_on_two_surfaces(self):
        cuts = ["--plane", "0,0,0.02,0,0,1", "--sphere", "1,0,0,0.4"]
        toroid = case("toroid_hex_g3_p6")
        self.succeeds("render", toroid, "--field", "u", *cuts, "--contours", "-0.1,0.3", *self.more)
        points, at, of = read_lines(self.lines)
        self.assertEqual(set(at), {"u", "Element", "Xi", "Gradient"})
        self.assertEqual(set(of), {"ContourValue", "Closed", "Certified", "Layer"})
        self.assertEqual(set(of["ContourValue"]), {-0.1, 0.3})
        self.assertEqual(set(of["Layer"]), {0, 1})
        self.assertEqual(set(of["Certified"]), {1})
        values = np.minimum(np.abs(at["u"] + 0.1), np.abs(at["u"] - 0.3))
        self.assertLess(values.max(), 1e-14)
        plane = np.abs(points[:, 2] - 0.02)
        ball = np.abs(np.linalg.norm(points - [1, 0, 0], axis=1) - 0.4)
        self.assertLess(np.minimum(plane, ball).max(), 1e-14)

    def test_lines_on_a_torus_are_proven(self):
        toroid = case("toroid_hex_g3_p6")
        torus = ["--torus", "0,0,0,0,0,1,1,0.2"]
        self.succeeds("render", toroid, "--field", "u", *torus, "--contours", "0.1", *self.more)
        points, at, of = read_lines(self.lines)
        self.assertGreater(len(of["Certified"]), 0)
        self.assertEqual(set(of["Certified"]), {1})
        self.assertLess(np.abs(at["u"] - 0.1).max(), 1e-14)
        rho = np.hypot(points[:, 0], points[:, 1])
        self.assertLess(np.abs(np.hypot(rho - 1, points[:, 2]) - 0.2).max(), 1e-13)

    def test_plateaus_are_told_and_have_no_lines(self):
        cube = self.folder / "cube.vtu"
        cube.write_text(unit_cube_grid(), encoding="utf-8")
        # u = x on x = 0.25.
        cut = ["--field", "u", "--plane", "0.25,0,0,1,0,0"]
        told = self.succeeds("render", cube, *cut, "--contours", "0.25,0.75", *self.more).stderr
        self.assertIn("with the value", told)
        self.assertEqual(len(read_lines(self.lines)[0]), 0)

    def test_a_number_of_contours(self):
        cube = self.folder / "cube.vtu"
        cube.write_text(unit_cube_grid(), encoding="utf-8")
        cut = ["--field", "u", "--plane", "0,0,0.5,0,0,1"]
        self.succeeds("render", cube, *cut, "--contours", "3", "--range", "0.25,0.75", *self.more)
        points, _, of = read_lines(self.lines)
        np.testing.assert_allclose(of["ContourValue"], [0.3, 0.5, 0.7], atol=1e-12)
        self.assertEqual(len(set(np.round(points[:, 0], 12))), 3)

    def test_the_magnitude_of_a_scalar_is_the_scalar(self):
        # As in the picture, where values below 0 are seen.
        cut = ["--field", "u", "--plane", "0,0,0.02,0,0,1", "--component", "magnitude"]
        self.succeeds("render", case("toroid_hex_g3_p6"), *cut, "--contours", "-0.3,0.3", *self.more)
        _, at, of = read_lines(self.lines)
        self.assertEqual(set(of["ContourValue"]), {-0.3, 0.3})
        self.assertLess(np.abs(np.abs(at["u"]) - 0.3).max(), 1e-14)
        self.assertLess(at["u"].min(), -0.29)

    def test_what_is_not_honoured_is_refused(self):
        base = ["render", case("escher_tet_g3_p3"), "--field", "u", *self.more]
        plane = ["--plane", "0,0,0,0,0,1"]
        self.fails(2, *base, *plane, names=["--contours-output", "--contours"])
        self.fails(2, *base, *plane, "--contours", "1,x", names=["--contours", "'1,x'"])
        self.fails(2, *base, *plane, "--contours", "nan", names=["--contours"])
        self.fails(1, *base, "--boundary", "--contours", "3", names=["planes", "tori", "boxes"])
        tolerance = ["--contours", "3", "--contours-tolerance"]
        self.fails(2, *base, *plane, *tolerance, "0", names=["--contours-tolerance"])
        self.lines = self.folder / "lines.txt"
        other = base[:-1] + [self.lines, *plane, "--contours", "3"]
        self.fails(2, *other, names=["--contours-output", ".vtp"])


if __name__ == "__main__":
    unittest.main()
