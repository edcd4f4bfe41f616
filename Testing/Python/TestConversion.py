# SPDX-License-Identifier: BSD-3-Clause
"""A solver's .vtu converted, asked, probed and resampled from Python."""

import csv
import math
import os
import unittest

from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet, vtkPolyData
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader

from pixelexact import (
    vtkHighOrderGrid,
    vtkHighOrderLinearResample,
    vtkHighOrderProbe,
    vtkUnstructuredGridToHighOrderGrid,
)

DATA = os.environ["PIXELEXACT_DATA_DIR"]


def convert(name):
    reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(os.path.join(DATA, name + ".vtu"))
    converter = vtkUnstructuredGridToHighOrderGrid()
    converter.SetInputConnection(reader.GetOutputPort())
    converter.Update()
    return converter


def oracle(name):
    with open(os.path.join(DATA, name + ".oracle.csv")) as file:
        return [
            {key: value if key == "type" else float(value) for key, value in row.items()}
            for row in csv.DictReader(file)
        ]


def worst_probe_error(name):
    rows = oracle(name)
    points = vtkPoints()
    points.SetDataTypeToDouble()
    for row in rows:
        points.InsertNextPoint(row["x"], row["y"], row["z"])
    where = vtkPolyData()
    where.SetPoints(points)
    converter = convert(name)  # an output port does not keep its filter
    probe = vtkHighOrderProbe()
    probe.SetInputData(where)
    probe.SetSourceConnection(converter.GetOutputPort())
    probe.AddField("u")
    probe.Update()
    data = probe.GetOutput().GetPointData()
    if any(data.GetArray("Verdict").GetValue(i) != 1 for i in range(len(rows))):
        return math.inf
    return max(abs(data.GetArray("u").GetValue(i) - row["u"]) for i, row in enumerate(rows))


class Conversion(unittest.TestCase):
    def test_grid_answers(self):
        grid = convert("toroid_hex_g3_p6").GetOutput()
        self.assertIsInstance(grid, vtkHighOrderGrid)
        self.assertTrue(vtkHighOrderGrid.IsHighOrder(grid))
        self.assertEqual(vtkHighOrderGrid.CheckCoefficients(grid), "")
        count = grid.GetNumberOfHighOrderFields()
        self.assertIn("u", [grid.GetHighOrderFieldName(i) for i in range(count)])
        orders = [0, 0]
        grid.GetGeometryOrderRange(orders)
        self.assertEqual(orders, [3, 3])
        grid.GetFieldOrderRange("u", orders)
        self.assertEqual(orders, [6, 6])

        value = vtkDoubleArray()
        for row in oracle("toroid_hex_g3_p6"):
            xi = [2 * row[key] - 1 for key in "rst"]
            x = [0.0, 0.0, 0.0]
            self.assertTrue(grid.MapForward(int(row["element"]), xi, x))
            self.assertTrue(grid.EvaluateField("u", int(row["element"]), xi, value))
            for a, key in zip(x, "xyz"):
                self.assertAlmostEqual(a, row[key], delta=1e-13)
            self.assertAlmostEqual(value.GetValue(0), row["u"], delta=1e-13)

    def test_moved_points_are_seen(self):
        grid = convert("toroid_hex_g3_p6").GetOutput()
        grid.GetPoints().SetPoint(0, 9.0, 9.0, 9.0)
        grid.GetPoints().Modified()
        problem = vtkHighOrderGrid.CheckCoefficients(grid)
        self.assertIn("moved", problem)
        self.assertIn("vtkUnstructuredGridToHighOrderGrid", problem)

    def test_probe_meets_the_oracles(self):
        for name in (
            "toroid_hex_g3_p6",
            "escher_tet_g3_p3",
            "toroid_prism_g3_p4",
            "fichera_hex_g3_p4",
            "periodic_hex_dg_g3_p4",
            "dolfinx_hex_g2_p4",
        ):
            with self.subTest(name):
                self.assertLess(worst_probe_error(name), 1e-13)

    def test_resample(self):
        converter = convert("toroid_hex_g3_p6")
        resample = vtkHighOrderLinearResample()
        resample.SetInputConnection(converter.GetOutputPort())
        resample.SetDimensions(12, 12, 6)
        resample.AddField("u")
        resample.Update()
        image = resample.GetOutput()
        self.assertEqual(image.GetDimensions(), (12, 12, 6))
        mask = image.GetPointData().GetArray("vtkValidPointMask")
        u = image.GetPointData().GetArray("u")
        inside = [mask.GetComponent(i, 0) != 0 for i in range(mask.GetNumberOfTuples())]
        self.assertTrue(0 < sum(inside) < len(inside))
        for i, flag in enumerate(inside):
            self.assertNotEqual(math.isnan(u.GetValue(i)), flag)

    def test_blocks_are_converted_one_by_one(self):
        blocks = vtkMultiBlockDataSet()
        for i, name in enumerate(("toroid_hex_g3_p6", "escher_tet_g3_p3")):
            reader = vtkXMLUnstructuredGridReader()
            reader.SetFileName(os.path.join(DATA, name + ".vtu"))
            reader.Update()
            blocks.SetBlock(i, reader.GetOutput())
        converter = vtkUnstructuredGridToHighOrderGrid()
        converter.SetInputDataObject(blocks)
        converter.Update()
        output = converter.GetOutputDataObject(0)
        for i in range(2):
            self.assertEqual(vtkHighOrderGrid.CheckCoefficients(output.GetBlock(i)), "")


if __name__ == "__main__":
    unittest.main()
