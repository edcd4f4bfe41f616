"""What is left of the coefficients behind ParaView's filters: kept, followed, stale or lost, never wrong."""

import os
import unittest

import numpy
from paraview import simple

import scene

# ParaView's Python Calculator and Programmable Filter put NumPy's names into this module: a function here must have none
# of them, such as clip and block.
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


def bent(source):
    vector = simple.Calculator(source, Function="0.1*kHat + 0.02*coordsX^2*iHat", ResultArrayName="shift")
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


def changed_by_python(source):
    return simple.PythonCalculator(source, Expression="2*inputs[0].PointData['u']", ArrayName="u")


def programmed(script):
    """A Programmable Filter that passes its input's arrays on and then does this with `u`."""
    return lambda source: simple.ProgrammableFilter(Input=[source], CopyArrays=1, Script=script)


def one_block(source):
    return simple.ExtractBlock(simple.GroupDatasets(Input=[source]), Selectors=["/Root"])


def cut_off(source):
    made = simple.Clip(source)
    low_x, high_x, low_y, high_y, low_z, high_z = source.GetDataInformation().GetBounds()
    made.ClipType.Origin = [(low_x + high_x) / 2, (low_y + high_y) / 2, (low_z + high_z) / 2]
    made.ClipType.Normal = [0.0, 0.0, 1.0]
    return made


def packed(source):
    return simple.PixelExactPack(Input=source)


def halves(source):
    """The cells of two thresholds, the second half first."""
    parts = []
    for low, high in ((24, 1000000), (0, 23)):
        part = simple.Threshold(source, Scalars=["CELLS", "PixelExactElementId"])
        part.LowerThreshold, part.UpperThreshold = low, high
        parts.append(part)
    return parts


def extracted(source):
    chosen = simple.IDSelectionSource(IDs=[i for cell in range(24) for i in (-1, cell)])
    return simple.ExtractSelection(Input=source, Selection=chosen)


def renamed(before, now):
    """A filter that has another name in ParaView 6.1."""
    return getattr(simple, before, None) or getattr(simple, now)


# Behind PixelExact Pack.
PACKED = {
    "itself": (lambda s: s, "kept"),
    "Append Datasets": (lambda s: simple.AppendDatasets(Input=halves(s)), "kept"),
    "Append Datasets, twice the same": (lambda s: simple.AppendDatasets(Input=[s, s]), "kept"),
    "Merge Blocks": (
        lambda s: simple.MergeBlocks(simple.GroupDatasets(Input=halves(s)), MergePoints=0),
        "kept",
    ),
    # Points that become one, as in Clean to Grid, are the same up to rounding, and so are values.
    "Merge Blocks, points merged": (
        lambda s: simple.MergeBlocks(simple.GroupDatasets(Input=halves(s)), MergePoints=1),
        "kept",
    ),
    "Redistribute Data Set": (lambda s: simple.RedistributeDataSet(s), "kept"),
    "Ghost Cells": (lambda s: renamed("GhostCellsGenerator", "GhostCells")(s), "kept"),
    "Extract Selection": (extracted, "kept"),
    "Threshold": (threshold, "kept"),
    "Calculator": (calculator, "kept"),
    "Cell Data to Point Data": (lambda s: simple.CellDatatoPointData(s), "lost"),
    "Cell Data to Point Data, passed": (
        lambda s: simple.CellDatatoPointData(s, PassCellData=1),
        "kept",
    ),
    "Pass Arrays": (lambda s: simple.PassArrays(s, PointDataArrays=["u"]), "lost"),
    "Point Data to Cell Data": (lambda s: simple.PointDatatoCellData(s, PassPointData=1), "kept"),
    "Clean to Grid": (lambda s: simple.CleantoGrid(s), "kept"),
    "Shrink": (lambda s: simple.Shrink(s), "shrunk"),
    "Tetrahedralize": (lambda s: simple.Tetrahedralize(s), "stale"),
    "Clip": (cut_off, "stale"),
    "Transform": (transform, "moved"),
    "Warp By Vector": (warp, "raised"),
    "values of a field changed": (changed, "doubled"),
    "saved as .vtu": (saved, "kept"),
    "saved as .pvtu": (lambda s: saved(s, ".pvtu"), "kept"),
    "saved as .vtk": (lambda s: saved(s, ".vtk"), "kept"),
    "PixelExact Convert": (lambda s: simple.PixelExactConvert(Input=s), "kept"),
    "PixelExact Unpack": (lambda s: simple.PixelExactUnpack(Input=s), "kept"),
}

FILTERS = {
    "Calculator": (calculator, "kept"),
    "Threshold": (threshold, "kept"),
    "Pass Arrays": (lambda s: simple.PassArrays(s, PointDataArrays=["u"]), "kept"),
    "Group Datasets": (lambda s: simple.GroupDatasets(Input=[s]), "kept"),
    "Extract Block": (one_block, "kept"),
    "Merge Blocks": (lambda s: simple.MergeBlocks(simple.GroupDatasets(Input=[s])), "kept"),
    "Clean to Grid": (lambda s: simple.CleantoGrid(s), "kept"),
    "Generate Ids": (lambda s: renamed("GenerateIds", "PointAndCellIds")(s), "kept"),
    "Cell Data to Point Data": (lambda s: simple.CellDatatoPointData(s), "kept"),
    "Connectivity": (lambda s: simple.Connectivity(s), "kept"),
    "Gradient": (lambda s: simple.Gradient(s, ScalarArray=["POINTS", "u"]), "kept"),
    "Shrink": (lambda s: simple.Shrink(s), "shrunk"),
    "Tetrahedralize": (lambda s: simple.Tetrahedralize(s), "stale"),
    "Clip": (cut_off, "stale"),
    "Transform": (transform, "moved"),
    "Warp By Vector": (warp, "raised"),
    "Append Datasets": (lambda s: simple.AppendDatasets(Input=[threshold(s), cut_off(s)]), "stale"),
    "values of a field changed": (changed, "doubled"),
    "saved as .vtu": (saved, "kept"),
    "saved as .vtk": (lambda s: saved(s, ".vtk"), "kept"),
}


# Where filters move the points, and by what they multiply the field.
# Cells that are shrunk have moved each by itself, so their values are elsewhere.
FOLLOWED = {
    "moved": ([0.1, 0.0, 0.0], 1),
    "raised": ([0.0, 0.0, 0.1], 1),
    "doubled": ([0.0] * 3, 2),
    "shrunk": ([0.0] * 3, None),
}

# These make linear cells of curved ones.
LINEAR = {"Tetrahedralize", "Clip", "Append Datasets"}


class Pipelines(unittest.TestCase):
    def tearDown(self):
        simple.ResetSession()

    def check(self, filters, before):
        table = scene.oracle(f"{NAME}.oracle.csv")
        points, values = scene.numbers(table, "x", "y", "z"), scene.numbers(table, "u")[:, 0]
        for name, (make, expected) in filters.items():
            with self.subTest(name):
                reader = simple.PixelExactGridReader(FileName=[scene.data(f"{NAME}.vtu")])
                reader.UpdatePipeline()
                source = before(reader)
                source.UpdatePipeline()
                filtered = make(source)
                filtered.UpdatePipeline()
                shift, factor = FOLLOWED.get(expected, ([0.0] * 3, 1))
                with scene.messages() as heard:
                    found = scene.probe(filtered, points + shift)
                inside = found.get("Verdict", numpy.zeros(1)) == 1
                if inside.any():
                    # Recomputed from nodal values where they were lost.
                    self.assertIn(expected, ("kept", "lost", *FOLLOWED))
                    self.assertEqual(heard, [""])
                    if factor is None:
                        simple.ResetSession()
                        continue
                    # Nothing that is given is wrong.
                    off = numpy.abs(found["u"] - factor * values)[inside].max()
                    self.assertLess(off, 1e-9 * abs(values).max())
                else:
                    self.assertEqual("stale", expected, heard)
                    remedy = "a conversion would lose" if name in LINEAR else "vtkUnstructuredGridToHighOrderGrid"
                    self.assertIn(remedy, heard[0])
                simple.ResetSession()

    def test_filters(self):
        self.check(FILTERS, lambda source: source)

    def test_filters_of_packed_grids(self):
        self.check(PACKED, packed)

    def test_solver_cells_that_are_changed(self):
        """Where their cells are linear, nothing advises a conversion, and none is done."""
        folder = "nek_tet_varp"
        files = [scene.data(f"{folder}/{folder}.xml")]
        table = scene.oracle(f"{folder}/oracle.csv")
        points = scene.numbers(table, "x", "y", "z")

        for make in (transform, warp, cut_off):
            for before in (lambda source: source, packed):
                with self.subTest(make.__name__ + (" packed" if before is packed else "")):
                    source = before(simple.PixelExactNektarReader(FileName=files, Cells="Corners"))
                    source.UpdatePipeline()
                    filtered = make(source)
                    for last in (filtered, simple.PixelExactConvert(Input=filtered)):
                        with scene.messages() as heard:
                            found = scene.probe(last, points)
                        self.assertFalse((found.get("Verdict", numpy.zeros(1)) == 1).any())
                        self.assertIn("a conversion would lose", heard[0])
                        self.assertNotIn("PixelExact Convert)", heard[0])
                    simple.ResetSession()

    def test_changes_of_lagrange_cells_are_followed(self):
        folder = "nek_tet_varp"
        files = [scene.data(f"{folder}/{folder}.xml")]
        table = scene.oracle(f"{folder}/oracle.csv")
        points, values = scene.numbers(table, "x", "y", "z"), scene.numbers(table, "u")[:, 0]
        for make, expected, said in (
            (transform, "moved", ""),
            (warp, "raised", ""),
            (bent, "raised", "the polynomial through them"),
            (changed, "doubled", "'u' was changed by a filter"),
        ):
            shift, factor = FOLLOWED[expected]
            shift = shift + (0.02 * points**2 * [1, 0, 0] if make is bent else 0 * points)
            reader = simple.PixelExactNektarReader(FileName=files)
            for last in (make(reader), simple.PixelExactConvert(Input=make(reader))):
                with self.subTest(expected), scene.messages() as heard:
                    found = scene.probe(last, points + shift)
                self.assertIn(said, heard[0])
                self.assertGreater((found["Verdict"] == 1).mean(), 0.95)
                inside = found["Verdict"] == 1
                off = numpy.abs(found["u"].ravel() - factor * values)[inside].max()
                self.assertLess(off, 1e-11 * abs(values).max())
            simple.ResetSession()

    def test_solver_fields_that_are_changed(self):
        """An array that shows a solver's field and has other values is refused, whoever changed it."""
        folder = "mfem49_tinyzoo_g3_p5"
        files = [scene.data(f"{folder}/{folder}.mesh")]
        table = scene.oracle(f"{folder}/oracle_u.csv")
        points, values = scene.numbers(table, "x", "y", "z"), scene.numbers(table, "u")[:, 0]
        edits = {
            "Calculator": (changed, "stale"),
            "Calculator, another name": (calculator, "kept"),
            "Python Calculator": (changed_by_python, "stale"),
            "Programmable Filter": (
                programmed("output.PointData.append(2 * inputs[0].PointData['u'], 'u')"),
                "stale",
            ),
            "Programmable Filter, in place": (programmed("output.PointData['u'][0] += 1e-9"), "stale"),
            "Programmable Filter, another name": (
                programmed("output.PointData.append(2 * inputs[0].PointData['u'], 'double')"),
                "kept",
            ),
        }
        for name, (make, expected) in edits.items():
            with self.subTest(name):
                reader = simple.PixelExactMFEMReader(FileName=files)
                reader.UpdatePipeline()
                self.assertIn("u", reader.PointData.keys())
                filtered = make(reader)
                filtered.UpdatePipeline()
                for last in (filtered, simple.PixelExactConvert(Input=filtered)):
                    with scene.messages() as heard:
                        found = scene.probe(last, points)
                    inside = found.get("Verdict", numpy.zeros(1)) == 1
                    if expected == "stale":
                        self.assertFalse(inside.any())
                        self.assertIn("'u'", heard[0])
                        self.assertIn("a conversion would lose", heard[0])
                    else:
                        self.assertEqual(heard, [""])
                        self.assertGreater(inside.mean(), 0.9)
                        off = numpy.abs(found["u"] - values)[inside].max()
                        self.assertLess(off, 1e-9 * abs(values).max())
                simple.ResetSession()

    def test_solver_coefficients(self):
        """Coefficients that nodal values do not determine: kept packed, else lost or refused, never wrong."""
        folder = "nek_tet_varp"
        files = [scene.data(f"{folder}/{folder}.xml")]
        table = scene.oracle(f"{folder}/oracle.csv")
        points, values = scene.numbers(table, "x", "y", "z"), scene.numbers(table, "u")[:, 0]
        for name in ("Append Datasets", "Merge Blocks", "Redistribute Data Set", "Ghost Cells"):
            with self.subTest(name):
                reader = simple.PixelExactNektarReader(FileName=files)
                filtered = PACKED[name][0](packed(reader))
                with scene.messages() as heard:
                    found = scene.probe(filtered, points)
                self.assertEqual(heard, [""])
                inside = found["Verdict"] == 1
                self.assertGreater(inside.mean(), 0.9)
                off = numpy.abs(found["u"] - values)[inside].max()
                self.assertLess(off, 1e-9 * abs(values).max())
                simple.ResetSession()


if __name__ == "__main__":
    scene.main()
