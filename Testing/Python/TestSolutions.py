# SPDX-License-Identifier: BSD-3-Clause
"""Two solutions compared, and fields truncated, from Python."""

import os
import unittest

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkPlane
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader
from vtkmodules.vtkRenderingCore import vtkCamera

from pixelexact import (
    vtkHighOrderDifference,
    vtkHighOrderProbe,
    vtkHighOrderTruncate,
    vtkUnstructuredGridToHighOrderGrid,
)

DATA = os.environ["PIXELEXACT_DATA_DIR"]


class Solutions(unittest.TestCase):
    def setUp(self):
        self.reader = vtkXMLUnstructuredGridReader()
        self.reader.SetFileName(os.path.join(DATA, "toroid_hex_g3_p6.vtu"))
        self.convert = vtkUnstructuredGridToHighOrderGrid()
        self.convert.SetInputConnection(self.reader.GetOutputPort())
        self.truncate = vtkHighOrderTruncate()
        self.truncate.SetInputConnection(self.convert.GetOutputPort())
        self.truncate.SetOrder(3)
        self.truncate.AddField("u")
        plane = vtkPlane()
        plane.SetOrigin(0.0, 0.0, 0.1)
        self.camera = vtkCamera()
        self.camera.SetPosition(0.0, 0.0, 6.0)
        self.difference = vtkHighOrderDifference()
        self.difference.SetInputConnection(0, self.convert.GetOutputPort())
        self.difference.SetInputConnection(1, self.truncate.GetOutputPort())
        self.difference.SetFieldName("u")
        self.difference.SetCutFunction(plane)
        self.difference.SetCamera(self.camera)
        self.difference.SetSize(120, 100)

    def array(self, name):
        return vtk_to_numpy(self.difference.GetOutput().GetPointData().GetArray(name))

    def number(self, name, at=0):
        return self.difference.GetOutput().GetFieldData().GetArray(name).GetValue(at)

    def test_a_truncated_field_differs_by_no_more_than_its_bound(self):
        self.difference.Update()
        bound = self.truncate.GetOutput().GetFieldData().GetArray("u_LargestChange").GetValue(0)
        both = self.array("Side") == 1
        value = self.array("Value")[both]
        self.assertEqual(both.sum(), self.number("Both"))
        self.assertGreater(both.sum(), 3000)
        self.assertEqual(np.abs(value).max(), self.number("Largest"))
        self.assertLessEqual(self.number("LargestTrue", 1), bound)
        self.assertGreater(self.number("Largest"), 0.05 * bound)
        self.assertTrue((self.array("Value_lower")[both] <= value).all())
        self.assertTrue((self.array("Value_upper")[both] >= value).all())
        self.assertLess(self.number("LargestBound"), 1e-9)
        np.testing.assert_array_equal(
            value, self.array("First")[both] - self.array("Second")[both]
        )

    def test_values_are_those_of_the_probe(self):
        self.difference.BoundsOff()
        self.difference.Update()
        self.assertIsNone(self.difference.GetOutput().GetPointData().GetArray("Value_lower"))
        both = np.flatnonzero(self.array("Side") == 1)
        from vtkmodules.util.numpy_support import numpy_to_vtk
        from vtkmodules.vtkCommonCore import vtkPoints
        from vtkmodules.vtkCommonDataModel import vtkPolyData

        points = vtkPoints()
        points.SetDataTypeToDouble()
        points.SetData(numpy_to_vtk(self.array("Position")[both].copy(), deep=True))
        where = vtkPolyData()
        where.SetPoints(points)
        for source, name in [(self.convert, "First"), (self.truncate, "Second")]:
            probe = vtkHighOrderProbe()
            probe.SetInputData(where)
            probe.SetSourceConnection(source.GetOutputPort())
            probe.AddField("u")
            probe.Update()
            found = vtk_to_numpy(probe.GetOutput().GetPointData().GetArray("u"))
            np.testing.assert_array_equal(found, self.array(name)[both])


if __name__ == "__main__":
    unittest.main()
