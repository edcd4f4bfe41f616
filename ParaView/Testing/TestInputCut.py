"""Filters of a PixelExact Slice or Clip take its cut, and follow it."""

import json
import math
import os
import shutil
import subprocess
import unittest

import numpy
from paraview import servermanager, simple, smstate
from vtkmodules.util.numpy_support import vtk_to_numpy

import scene
from TestSlices import cube, torus

# In ParaView's own window, in which a plane was moved.
CLIENT = """
import json, os, traceback
from paraview.simple import *
try:
    reader = PixelExactGridReader(FileName=[{file!r}])
    display = Show(reader)
    display.CutFunction.Origin, display.CutFunction.Normal = [0.1, 0.2, 0.3], [0.0, 0.6, 0.8]
    other = PixelExactGridReader(FileName=[{file!r}])
    of_other = Show(other)
    of_other.CutFunction = "Sphere"
    of_other.CutFunction.Center, of_other.CutFunction.Radius = [0.5, 0, 0], 0.25
    found = {{}}
    for name, source in (("reader", reader), ("other", other)):
        function = PixelExactIntegrate(Input=source).CutFunction
        found[name] = [float(x) for x in (function.Origin if name == "reader" else function.Center)]
        found[name] += [float(x) for x in (function.Normal if name == "reader" else [function.Radius])]
    hidden = PixelExactGridReader(FileName=[{file!r}])
    found["hidden"] = [float(x) for x in PixelExactIntegrate(Input=hidden).CutFunction.Normal]
    with open({numbers!r}, "w") as out:
        json.dump(found, out)
except Exception:
    traceback.print_exc()
os._exit(0)
"""


def rows(integral):
    """The table as {quantity: (lower, upper)}."""
    table = servermanager.Fetch(integral)
    names = [table.GetColumnByName("Quantity").GetValue(i) for i in range(table.GetNumberOfRows())]
    ends = [vtk_to_numpy(table.GetColumnByName(name)) for name in ("Lower", "Upper")]
    return {name: (ends[0][i], ends[1][i]) for i, name in enumerate(names)}


class InputCut(unittest.TestCase):
    def tearDown(self):
        simple.ResetSession()

    def holds(self, interval, value):
        self.assertLessEqual(interval[0], value + 1e-12)
        self.assertGreaterEqual(interval[1], value - 1e-12)
        self.assertLess(interval[1] - interval[0], 1e-2)

    def test_integral_of_slices(self):
        """Areas and means of planes and spheres in a cube with u = 0.2 x + 0.3 y + 0.4 z."""
        cut = simple.PixelExactSlice(Input=cube())
        cut.SliceType.Origin, cut.SliceType.Normal = [0, 0, 0.5], [0, 0, 1]
        integral = simple.PixelExactIntegrate(Input=cut, Field="u", Tolerance=1e-6)
        self.assertEqual(integral.UseCutOfInput, 1)
        found = rows(integral)
        self.holds(found["Area"], 4.0)
        self.holds(found["Mean"], 0.2)
        cut.SliceType.Origin = [0, 0, -0.25]
        self.holds(rows(integral)["Mean"], -0.1)
        cut.SliceOffsetValues = [0.0, 0.75]
        found = rows(integral)
        self.holds(found["Area"], 8.0)
        self.holds(found["Mean"], 0.05)
        cut.SliceOffsetValues = [0.0]
        cut.SliceType = "Sphere"
        cut.SliceType.Center, cut.SliceType.Radius = [0, 0, 0.25], 0.5
        found = rows(integral)
        self.holds(found["Area"], math.pi)
        self.holds(found["Mean"], 0.1)

    def test_integral_of_clips(self):
        """The closing cut, the rest of the boundary, and a clipped slice."""
        clip = simple.PixelExactClip(Input=cube())
        clip.ClipType.Origin, clip.ClipType.Normal = [0, 0, 0.5], [0, 0, 1]
        integral = simple.PixelExactIntegrate(Input=clip, Field="u", Tolerance=1e-6)
        self.holds(rows(integral)["Area"], 4.0)
        integral.Over = "Boundary"
        self.holds(rows(integral)["Area"], 4.0 + 8.0 * 1.5)
        clip.Invert = 0
        self.holds(rows(integral)["Area"], 4.0 + 8.0 * 0.5)
        cut = simple.PixelExactSlice(Input=clip)
        cut.SliceType.Origin, cut.SliceType.Normal = [0, 0, 0], [1, 0, 0]
        self.holds(rows(simple.PixelExactIntegrate(Input=cut, Field="u", Tolerance=1e-6))["Area"], 1.0)
        # Clips of clips: a quarter of the cube, closed by two rectangles.
        clip.Invert = 1
        clip.ClipType.Origin = [0, 0, 0]
        both = simple.PixelExactClip(Input=clip)
        both.ClipType.Origin, both.ClipType.Normal = [0, 0, 0], [1, 0, 0]
        self.holds(rows(simple.PixelExactIntegrate(Input=both, Field="u", Tolerance=1e-6))["Area"], 4.0)
        box = simple.PixelExactClip(Input=cube(), ClipType="Box", Invert=0)
        refused = simple.PixelExactIntegrate(Input=box, Field="u", Over="Boundary")
        with scene.messages() as heard:
            refused.UpdatePipeline()
        self.assertIn("switch Invert", heard[0])

    def test_off(self):
        """Cut Function is the cut where the box is off, which traces and states keep."""
        cut = simple.PixelExactSlice(Input=cube())
        cut.SliceType.Origin, cut.SliceType.Normal = [0, 0, 0.5], [0, 0, 1]
        integral = simple.PixelExactIntegrate(Input=cut, Field="u", UseCutOfInput=0)
        integral.CutFunction.Origin, integral.CutFunction.Normal = [0.5, 0, 0], [1, 0, 0]
        self.holds(rows(integral)["Mean"], 0.1)
        self.assertEqual(simple.PixelExactIntegrate(Input=torus()).UseCutOfInput, 0)
        self.assertIn("UseCutOfInput = 0", smstate.get_state())

    def test_lines_and_triangles(self):
        reader = torus()
        cut = simple.PixelExactSlice(Input=reader)
        cut.SliceType.Origin, cut.SliceType.Normal = [0, 0, 0.1], [0, 0, 1]
        lines = simple.PixelExactContour(Input=cut, ContourBy="u", ContourValues=[0.1])
        triangles = simple.PixelExactLinearCut(Input=cut, Resolution=60)
        for height in 0.1, -0.15:
            cut.SliceType.Origin = [0, 0, height]
            for made in lines, triangles:
                made.UpdatePipeline()
                bounds = made.GetDataInformation().GetBounds()
                numpy.testing.assert_allclose(bounds[4:], height, atol=1e-12)
                self.assertGreater(bounds[1] - bounds[0], 1.0)
        cut.SliceOffsetValues = [0.0, 0.1]
        with scene.messages() as heard:
            lines.UpdatePipeline()
        self.assertIn("has 2 cuts", heard[0])

    def test_difference_and_comparison(self):
        """The images and tables are those of the same plane under Cut Function."""
        reader = torus()
        less = simple.PixelExactTruncate(Input=reader, Order=3)
        cut = simple.PixelExactSlice(Input=reader)
        cut.SliceType.Origin, cut.SliceType.Normal = [0, 0, 0.1], [0.1, 0, 1]
        triangles = simple.PixelExactLinearCut(Input=cut, Resolution=40)
        found = []
        for source, settings in ((cut, {}), (reader, {"plane": True})):
            difference = simple.PixelExactDifference(Input=source, Other=less, Size=[60, 50])
            comparison = simple.PixelExactComparison(
                Input=source, Surfaces=[triangles], Size=[60, 50], Field="u"
            )
            for made in difference, comparison:
                self.assertEqual(made.UseCutOfInput, 0 if settings else 1)
                if settings:
                    made.CutFunction.Origin, made.CutFunction.Normal = [0, 0, 0.1], [0.1, 0, 1]
            image = servermanager.Fetch(difference).GetPointData()
            table = servermanager.Fetch(comparison)
            found.append(
                [vtk_to_numpy(image.GetArray(i)) for i in range(image.GetNumberOfArrays())]
                + [vtk_to_numpy(table.GetColumn(i)) for i in range(table.GetNumberOfColumns())]
            )
        self.assertGreater(len(found[0]), 8)
        for ours, theirs in zip(*found):
            numpy.testing.assert_array_equal(ours, theirs)

    def test_neither(self):
        integral = simple.PixelExactIntegrate(Input=torus())
        integral.UseCutOfInput = 1
        with scene.messages() as heard:
            integral.UpdatePipeline()
        self.assertIn("apply PixelExact Slice", heard[0])

    @unittest.skipIf(shutil.which("paraview") is None, "there is no window's ParaView")
    def test_window(self):
        """In the window new filters start with the cut that their input shows."""
        numbers, script = (os.path.join(scene.PICTURES, "input_cut" + end) for end in (".json", ".py"))
        with open(script, "w") as file:
            file.write(CLIENT.format(file=scene.data("toroid_hex_g3_p6.vtu"), numbers=numbers))
        done = subprocess.run(
            ["paraview", "--dr", "--script=" + script], capture_output=True, text=True, timeout=120
        )
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertNotIn("Error", done.stdout + done.stderr)
        with open(numbers) as file:
            found = json.load(file)
        self.assertEqual(found["reader"], [0.1, 0.2, 0.3, 0.0, 0.6, 0.8])
        self.assertEqual(found["other"], [0.5, 0.0, 0.0, 0.25])
        self.assertEqual(found["hidden"], [1.0, 0.0, 0.0])


if __name__ == "__main__":
    scene.main()
