# SPDX-License-Identifier: BSD-3-Clause
"""Contours of the mapper, from Python."""

import os
import unittest

import numpy as np
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkPlane
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader
from vtkmodules.vtkRenderingCore import vtkActor, vtkRenderer, vtkRenderWindow

import pixelexact

DATA = os.environ["PIXELEXACT_DATA_DIR"]


class Contours(unittest.TestCase):
    def test_values_are_as_those_of_vtk(self):
        mapper = pixelexact.vtkHighOrderMapper()
        self.assertEqual(mapper.GetNumberOfContours(), 0)
        mapper.GenerateContourValues(3, (0, 1))
        self.assertEqual(mapper.GetContourValues(), (0, 0.5, 1))
        # Both ends, where 49 * (1 / 49) is less than 1.
        mapper.GenerateContourValues(50, 0, 1)
        self.assertEqual((mapper.GetContourValue(0), mapper.GetContourValue(49)), (0, 1))
        mapper.GenerateContourValues(1, 0.25, 5)
        self.assertEqual(mapper.GetContourValues(), (0.25,))
        mapper.SetContourValue(2, 7)
        self.assertEqual(mapper.GetContourValues(), (0.25, 0, 7))
        mapper.SetContourValues(numpy_to_vtk(np.array([1.0, 2.5])))
        self.assertEqual(mapper.GetContourValues(), (1, 2.5))
        time = mapper.GetMTime()
        mapper.SetNumberOfContours(0)
        self.assertGreater(mapper.GetMTime(), time)
        self.assertEqual(mapper.GetContourValues(), ())

    def test_copies_have_them(self):
        mapper, copy = pixelexact.vtkHighOrderMapper(), pixelexact.vtkHighOrderMapper()
        mapper.GenerateContourValues(3, 0, 1)
        mapper.SetContourWidth(3)
        mapper.ContourLabelsOn()
        mapper.ContourInteriorOn()
        mapper.SetContourEffort(4)
        copy.ShallowCopy(mapper)
        self.assertEqual(copy.GetContourValues(), (0, 0.5, 1))
        self.assertEqual(copy.GetContourWidth(), 3)
        self.assertTrue(copy.GetContourLabels())
        self.assertTrue(copy.GetContourInterior())
        self.assertEqual(copy.GetContourEffort(), 4)
        self.assertIn("ContourWidth: 3", str(copy))

    def test_a_window_shows_them_and_tells_of_them(self):
        reader = vtkXMLUnstructuredGridReader()
        reader.SetFileName(os.path.join(DATA, "toroid_hex_g3_p6.vtu"))
        converter = pixelexact.vtkUnstructuredGridToHighOrderGrid()
        converter.SetInputConnection(reader.GetOutputPort())
        mapper = pixelexact.vtkHighOrderMapper()
        mapper.SetInputConnection(converter.GetOutputPort())
        plane = vtkPlane()
        plane.SetNormal(0, 0, 1)
        mapper.SetCutFunction(plane)
        actor = vtkActor()
        actor.SetMapper(mapper)
        renderer, window = vtkRenderer(), vtkRenderWindow()
        renderer.AddActor(actor)
        window.SetOffScreenRendering(1)
        window.SetSize(200, 200)
        window.AddRenderer(renderer)
        window.Render()
        self.assertIsNone(mapper.GetBuffers().GetPointData().GetArray("Contour"))
        self.assertEqual(mapper.GetNumberOfContourPixels(), 0)
        traces = mapper.GetNumberOfTraces()
        for count in (3, 9):
            mapper.GenerateContourValues(count, *mapper.GetScalarRange())
            window.Render()
            found = vtk_to_numpy(mapper.GetBuffers().GetPointData().GetArray("Contour"))
            self.assertEqual((found == 1).sum(), mapper.GetNumberOfContourPixels())
            self.assertEqual((found == 2).sum(), mapper.GetNumberOfUndecidedContourPixels())
            self.assertGreater((found == 1).sum(), 100)
        self.assertEqual(mapper.GetNumberOfTraces(), traces)


if __name__ == "__main__":
    unittest.main()
