# SPDX-License-Identifier: BSD-3-Clause
"""Deformed meshes in Python: the function warp, the keyword of read, render, cut and probe, and what
VTK's own filters do to grids."""

import os
import unittest
from pathlib import Path

import numpy as np
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401
from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkPoints
from vtkmodules.vtkCommonDataModel import VTK_HEXAHEDRON, vtkUnstructuredGrid
from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkFiltersCore import vtkArrayCalculator
from vtkmodules.vtkFiltersGeneral import vtkTransformFilter

import pixelexact

TORUS = Path(os.environ["PIXELEXACT_DATA_DIR"]) / "toroid_hex_g3_p6.vtu"
POINTS = np.array([[0.9, 0.1, 0.05], [1.0, -0.2, -0.1], [-0.7, 0.7, 0.0]])
UP = (0.0, 0.0, 1.0)


class Warp(unittest.TestCase):
    def setUp(self):
        self.grid = pixelexact.read(TORUS)
        self.u = pixelexact.probe(self.grid, "u", POINTS)
        self.moved = POINTS + 0.02 * self.u.values[:, None] * np.array(UP)

    def test_function_and_keywords_are_the_same(self):
        grid = pixelexact.warp(self.grid, "u", 0.02, direction=UP)
        for found in (
            pixelexact.probe(grid, "u", self.moved),
            pixelexact.probe(self.grid, "u", self.moved, warp="u=0.02", warp_direction=UP),
            pixelexact.probe(self.grid, "u", self.moved, warp=("u", 0.02), warp_direction=UP),
            pixelexact.probe(
                pixelexact.read(TORUS, warp="u=0.02", warp_direction=UP), "u", self.moved),
        ):
            self.assertTrue(found.inside.all())
            np.testing.assert_allclose(found.values, self.u.values, atol=1e-12)
        one = pixelexact.render(grid, "u", size=(60, 40))
        other = pixelexact.render(self.grid, "u", size=(60, 40), warp="u=0.02", warp_direction=UP)
        np.testing.assert_array_equal(one.image, other.image)

    def test_complex_fields_at_a_phase(self):
        """Of a unit cube: u = x + i y, which moves it along z by the real part of u e^(i 30 degrees)."""
        cube = vtkUnstructuredGrid()
        points = vtkPoints()
        points.SetDataTypeToDouble()
        parts = [vtkDoubleArray(), vtkDoubleArray()]
        for name, array in zip(("u_real", "u_imag"), parts):
            array.SetName(name)
            cube.GetPointData().AddArray(array)
        for x, y, z in ((0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)):
            points.InsertNextPoint(x, y, z)
            parts[0].InsertNextValue(x)
            parts[1].InsertNextValue(y)
        cube.SetPoints(points)
        cube.InsertNextCell(VTK_HEXAHEDRON, 8, list(range(8)))
        grid = pixelexact.warp(pixelexact.at_phase(cube, 30.0), "u", 0.25, direction=UP)
        rest = np.random.default_rng(2).uniform(0.0, 1.0, (20, 3))
        real = np.cos(np.pi / 6) * rest[:, 0] - 0.5 * rest[:, 1]
        found = pixelexact.probe(grid, "u", rest + 0.25 * real[:, None] * np.array(UP))
        self.assertTrue(found.inside.all())
        np.testing.assert_allclose(found.values, real, atol=1e-14)
        with self.assertRaisesRegex(pixelexact.Error, "sum of fields"):
            pixelexact.warp(cube, "u_real*u_imag", 0.25, direction=UP)

    def test_limit(self):
        # x + s u along z, of a unit cube with u = -x z: the edges x = 1 along z get the length 1 - s.
        cube = vtkUnstructuredGrid()
        points = vtkPoints()
        points.SetDataTypeToDouble()
        u = vtkDoubleArray()
        u.SetName("u")
        corners = [(0, 0), (1, 0), (1, 1), (0, 1)]
        for z in (0.0, 1.0):
            for x, y in corners:
                points.InsertNextPoint(x, y, z)
                u.InsertNextValue(-x * z)
        cube.SetPoints(points)
        cube.Allocate(1)
        cube.InsertNextCell(VTK_HEXAHEDRON, 8, list(range(8)))
        cube.GetPointData().AddArray(u)
        limit = pixelexact.warp_limit(cube, "u", direction=UP)
        self.assertLessEqual(limit.valid, 1.0)
        self.assertGreaterEqual(limit.inverted, 1.0)
        self.assertAlmostEqual(limit.valid, 1.0, delta=2e-6)
        self.assertAlmostEqual(limit.inverted, 1.0, delta=2e-6)
        self.assertEqual((limit.cell, limit.left_out), (0, 0))
        self.assertAlmostEqual(limit.xi[0], 1.0, delta=1e-5)
        away = pixelexact.warp_limit(cube, "u", direction=(0.0, 1.0, 0.0))  # a shear
        self.assertEqual((away.inverted, away.cell), (np.inf, -1))

    def test_wrong_use(self):
        with self.assertRaisesRegex(pixelexact.Error, "'u' is a scalar"):
            pixelexact.warp(self.grid, "u")
        with self.assertRaisesRegex(ValueError, "a finite number"):
            pixelexact.warp(self.grid, "u", float("nan"), direction=UP)
        with self.assertRaisesRegex(ValueError, "must not be zero"):
            pixelexact.warp(self.grid, "u", direction=(0, 0, 0))
        with self.assertRaisesRegex(ValueError, "warp_direction has no effect"):
            pixelexact.render(self.grid, "u", size=(2, 2), warp_direction=UP)
        with self.assertRaisesRegex(ValueError, "FIELD=SCALE"):
            pixelexact.render(self.grid, "u", size=(2, 2), warp="u=much")


class FollowedFilters(unittest.TestCase):
    def test_motions_and_new_arrays_of_a_solvers_grid(self):
        channel = Path(os.environ["PIXELEXACT_DATA_DIR"]) / "nek_prism_curved_p7"
        grid = pixelexact.read(
            channel / "nek_prism_curved_p7.xml", channel / "nek_prism_curved_p7.fld")
        # The middles of the cells' corners; some may lie outside of curved elements.
        corners = [[grid.GetPoint(grid.GetCell(c).GetPointId(k)) for k in range(6)]
                   for c in range(grid.GetNumberOfCells())]
        points = np.mean(corners, axis=1)
        before = pixelexact.probe(grid, "u", points)
        self.assertGreater(before.inside.mean(), 0.8)

        transform = vtkTransform()
        transform.Translate(10.0, 20.0, 30.0)
        transform.RotateWXYZ(50.0, 1.0, 1.0, 0.3)
        calculator = vtkArrayCalculator()
        calculator.SetInputData(grid)
        calculator.AddScalarArrayName("u")
        calculator.SetFunction("3*u + 1")
        calculator.SetResultArrayName("Result")
        move = vtkTransformFilter()
        move.SetTransform(transform)
        move.SetInputConnection(calculator.GetOutputPort())
        move.Update()
        moved = np.array([transform.TransformPoint(p) for p in points])
        for name, expected in (("u", before.values), ("Result", 3 * before.values + 1)):
            after = pixelexact.probe(move.GetOutput(), name, moved)
            np.testing.assert_array_equal(after.inside, before.inside)
            np.testing.assert_allclose(
                after.values[before.inside], expected[before.inside], rtol=0, atol=1e-11)
        picture = pixelexact.render(move.GetOutput(), "Result", size=(60, 40))
        self.assertGreater((picture.verdicts == 1).mean(), 0.05)
        self.assertEqual((picture.verdicts == 2).sum(), 0)


if __name__ == "__main__":
    unittest.main()
