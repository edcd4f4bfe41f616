"""What is left of the coefficients behind ParaView's filters: kept, stale or lost, never wrong."""

import os
import unittest

import numpy
from paraview import simple

import scene

NAME = "escher_tet_g3_p3"


def threshold(source):
    made = simple.Threshold(source)
    made.Scalars = ["CELLS", "PixelExactElementId"]
    made.LowerThreshold, made.UpperThreshold = 0, 23
    return made


def calculator(source):
    return simple.Calculator(source, Function="u*u", ResultArrayName="square")


def warp(source):
    vector = simple.Calculator(source, Function="0.1*kHat", ResultArrayName="shift")
    return simple.WarpByVector(vector, Vectors=["POINTS", "shift"])


def transform(source):
    made = simple.Transform(source)
    made.Transform.Translate = [0.1, 0.0, 0.0]
    return made


def saved(source, suffix=".vtu"):
    name = os.path.join(scene.PICTURES, "saved" + suffix)
    simple.SaveData(name, source)
    return simple.OpenDataFile(name)


def changed(source):
    return simple.Calculator(source, Function="2*u", ResultArrayName="u")


def block(source):
    return simple.ExtractBlock(simple.GroupDatasets(Input=[source]), Selectors=["/Root"])


def clip(source):
    made = simple.Clip(source)
    made.ClipType.Normal = [0.0, 0.0, 1.0]
    return made


FILTERS = {
    "Calculator": (calculator, "kept"),
    "Threshold": (threshold, "kept"),
    "Pass Arrays": (lambda s: simple.PassArrays(s, PointDataArrays=["u"]), "kept"),
    "Group Datasets": (lambda s: simple.GroupDatasets(Input=[s]), "kept"),
    "Extract Block": (block, "kept"),
    "Merge Blocks": (lambda s: simple.MergeBlocks(simple.GroupDatasets(Input=[s])), "kept"),
    "Clean to Grid": (lambda s: simple.CleantoGrid(s), "stale"),
    "Generate Ids": (lambda s: simple.GenerateIds(s), "kept"),
    "Cell Data to Point Data": (lambda s: simple.CellDatatoPointData(s), "kept"),
    "Connectivity": (lambda s: simple.Connectivity(s), "kept"),
    "Gradient": (lambda s: simple.Gradient(s, ScalarArray=["POINTS", "u"]), "kept"),
    "Shrink": (lambda s: simple.Shrink(s), "stale"),
    "Tetrahedralize": (lambda s: simple.Tetrahedralize(s), "stale"),
    "Clip": (clip, "stale"),
    "Transform": (transform, "stale"),
    "Warp By Vector": (warp, "stale"),
    "Append Datasets": (lambda s: simple.AppendDatasets(Input=[threshold(s), clip(s)]), "stale"),
    "values of a field changed": (changed, "stale"),
    "saved as .vtu": (saved, "kept"),
    "saved as .vtk": (lambda s: saved(s, ".vtk"), "kept"),
}


class Pipelines(unittest.TestCase):
    def tearDown(self):
        simple.ResetSession()

    def test_filters(self):
        table = scene.oracle(f"{NAME}.oracle.csv")
        points, values = scene.numbers(table, "x", "y", "z"), scene.numbers(table, "u")[:, 0]
        for name, (make, expected) in FILTERS.items():
            with self.subTest(name):
                reader = simple.PixelExactGridReader(FileName=[scene.data(f"{NAME}.vtu")])
                reader.UpdatePipeline()
                filtered = make(reader)
                filtered.UpdatePipeline()
                with scene.messages() as heard:
                    found = scene.probe(filtered, points)
                inside = found.get("Verdict", numpy.zeros(1)) == 1
                if inside.any():
                    self.assertEqual(("kept", heard), (expected, [""]))
                    # Nothing that is given is wrong.
                    off = numpy.abs(found["u"] - values)[inside].max()
                    self.assertLess(off, 1e-9 * abs(values).max())
                else:
                    self.assertEqual("stale", expected, heard)
                    self.assertIn("vtkUnstructuredGridToHighOrderGrid", heard[0])
                simple.ResetSession()


if __name__ == "__main__":
    scene.main()
