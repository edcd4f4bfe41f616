# SPDX-License-Identifier: BSD-3-Clause
"""Expressions in Python: as a field's name, and as fields of a grid."""

import os
import tempfile
import unittest
from pathlib import Path

import numpy as np
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridWriter

import pixelexact

TORUS = Path(os.environ["PIXELEXACT_DATA_DIR"]) / "toroid_hex_g3_p6.vtu"
POINTS = np.array([[0.9, 0.1, 0.05], [1.0, -0.2, -0.1], [-0.7, 0.7, 0.0]])


class Calculate(unittest.TestCase):
    def setUp(self):
        self.grid = pixelexact.read(TORUS)
        self.u = pixelexact.probe(self.grid, "u", POINTS, gradients=True)
        self.assertTrue(self.u.inside.all())

    def test_names_are_expressions(self):
        found = pixelexact.probe(self.grid, "mag(grad(u))", POINTS, enclosures=True)
        slope = np.linalg.norm(self.u.gradients, axis=1)
        np.testing.assert_allclose(found.values, slope, rtol=1e-13)
        self.assertTrue((found.lower <= slope).all() and (slope <= found.upper).all())
        picture = pixelexact.render(self.grid, "u - x", normal="z", size=(60, 40))
        inside = picture.verdicts == 1
        values = pixelexact.probe(self.grid, "u", picture.positions[inside]).values
        np.testing.assert_allclose(
            picture.values[inside], values - picture.positions[inside][:, 0], atol=1e-13)

    def test_grids_carry_definitions(self):
        grid = pixelexact.calculate(self.grid, slope="mag(grad(u))", twice="2*slope")
        self.assertIsInstance(grid, pixelexact.vtkHighOrderGrid)
        slope = np.linalg.norm(self.u.gradients, axis=1)
        with tempfile.TemporaryDirectory() as folder:
            writer = vtkXMLUnstructuredGridWriter()
            writer.SetFileName(f"{folder}/saved.vtu")
            writer.SetInputData(grid)
            writer.Write()
            for one in [grid, pixelexact.read(f"{folder}/saved.vtu")]:
                found = pixelexact.probe(one, "twice", POINTS)
                np.testing.assert_allclose(found.values, 2 * slope, rtol=1e-13)
        self.assertIsNotNone(grid.GetPointData().GetArray("twice"))
        self.assertIsNone(self.grid.GetPointData().GetArray("twice"))
        bare = pixelexact.calculate(self.grid, point_values=False, slope="mag(grad(u))")
        self.assertIsNone(bare.GetPointData().GetArray("slope"))

    def test_refused(self):
        for name, text, message in [
            ("e", "u +", r"something is missing at the end\n  u \+\n     \^"),
            ("u", "2*u", "the grid has a field 'u'"),
            ("e", "2*e", "nothing is named 'e'"),
        ]:
            with self.assertRaisesRegex(pixelexact.Error, message):
                pixelexact.calculate(self.grid, **{name: text})
        with self.assertRaisesRegex(pixelexact.Error, "the grid has a field 'a'"):
            pixelexact.calculate(pixelexact.calculate(self.grid, a="u"), a="2*u")
        with self.assertRaisesRegex(pixelexact.Error, "proven ranges are not available"):
            pixelexact.render(self.grid, "2*u", clim="field", size=(40, 30))
        with self.assertRaisesRegex(TypeError, "expression as text"):
            pixelexact.calculate(self.grid, e=3)
        with self.assertRaisesRegex(TypeError, "name a field"):
            pixelexact.calculate(self.grid)
        with self.assertRaisesRegex(pixelexact.Error, "nothing is named 'w'"):
            pixelexact.render(self.grid, "u + w")
        with self.assertRaisesRegex(pixelexact.Error, "not available for expressions"):
            pixelexact.contours(self.grid, "2*u", values=[0.5])


if __name__ == "__main__":
    unittest.main()
