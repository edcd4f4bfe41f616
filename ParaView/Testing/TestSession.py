"""A user's session, action by action. Each picture is checked by numbers; the trace repeats the last."""

import contextlib
import glob
import os
import subprocess
import unittest

import numpy
from paraview import servermanager, simple, smstate, smtrace
from vtkmodules.util.numpy_support import vtk_to_numpy

import scene

FILE = scene.data("toroid_hex_g3_p6.vtu")
RANGE = (-0.9, 0.9)

AGAIN = """
import sys
sys.path.insert(0, {folder!r})
import scene, numpy
from paraview import simple
view = simple.GetActiveView() or simple.GetRenderViews()[0]
scene.make_plain(view)
numpy.save({result!r}, scene.pixels(view))
"""


@contextlib.contextmanager
def applied(proxy):
    """Records changes of properties, as the button Apply does; those of scripts are not traced."""
    item = smtrace._create_trace_item_internal("PropertiesModified", kwargs={"proxy": proxy.SMProxy})
    yield
    item.finalize()


@contextlib.contextmanager
def unrecorded():
    """Keeps what the checks do out of the trace."""
    item = smtrace._create_trace_item_internal("BlockTraceItems")
    yield
    item.finalize()


def probe(source, points):
    with unrecorded():
        return scene.probe(source, points)


class Session(unittest.TestCase):
    """The pictures are session_NN_ACTION.png in the order of the actions."""

    def setUp(self):
        self.count = 0

    def tearDown(self):
        simple.ResetSession()

    def picture(self, action):
        self.count += 1
        # A trace would write its own pictures over these.
        with unrecorded(), scene.messages() as heard:
            rgb = scene.pixels(self.view, f"session_{self.count:02}_{action}.png")
        self.assertEqual(heard, [""], action)
        return rgb

    def seen(self, rgb):
        return int((~scene.is_background(rgb)).sum())

    def on_plane(self, source, origin, normal, field="u"):
        """Compares the picture with values of PixelExact Probe where rays meet a plane."""
        rgb = scene.pixels(self.view)
        rows, columns = numpy.mgrid[3:237:6, 3:317:6]
        places = numpy.stack([columns.ravel(), rows.ravel()], axis=1)
        eyes, ahead = scene.rays(self.view, places)
        along = ((numpy.array(origin) - eyes) @ normal) / (ahead @ normal)
        found = probe(source, eyes + along[:, None] * ahead)
        inside = found["Verdict"] == 1
        self.assertGreater(inside.sum(), 100)
        shown = rgb[places[:, 1], places[:, 0]].astype(int)
        off = numpy.abs(shown[inside] - scene.mapped(field, found[field][inside])).max(axis=1)
        self.assertLessEqual(numpy.percentile(off, 98), 1)
        return found[field][inside]

    def again(self, program, name):
        """The picture that a program makes in a new process."""
        script, result = (os.path.join(scene.PICTURES, name + end) for end in (".py", ".npy"))
        with open(script, "w") as file:
            file.write(program + AGAIN.format(folder=os.path.dirname(__file__), result=result))
        done = subprocess.run(["pvbatch", script], capture_output=True, text=True)
        self.assertNotIn("ERR|", done.stderr)
        self.assertEqual(done.returncode, 0, done.stderr)
        return numpy.load(result)

    def test_actions(self):
        smtrace.start_trace()
        self.view = scene.view(direction=(0.3, 0.2, -1.0), scale=1.5)
        reader = simple.PixelExactGridReader(registrationName="torus", FileName=[FILE])
        shown = simple.Show(reader, self.view)
        shown.SetScalarBarVisibility(self.view, False)
        self.assertEqual(shown.Representation, "PixelExact")
        self.assertGreater(self.seen(self.picture("open")), 200)

        with applied(shown):
            shown.CutFunction.Origin, shown.CutFunction.Normal = [0, 0, 0], [0, 0, 1]
        simple.ColorBy(shown, ("POINTS", "u"))
        self.picture("color")
        self.on_plane(reader, [0, 0, 0], [0, 0, 1])
        table = simple.GetColorTransferFunction("u")
        table.RescaleTransferFunction(*RANGE)
        self.picture("custom_range")
        self.on_plane(reader, [0, 0, 0], [0, 0, 1])
        table.ApplyPreset("Viridis (matplotlib)", True)
        self.picture("preset")
        self.on_plane(reader, [0, 0, 0], [0, 0, 1])
        table.ApplyPreset("Cool to Warm", True)
        table.RescaleTransferFunction(*RANGE)

        shown.CutFunction.Origin = [0, 0, 0.12]
        self.picture("move_plane")
        before = self.on_plane(reader, [0, 0, 0.12], [0, 0, 1])
        shown.CutFunction.Normal = [0.3, 0.1, 1]
        self.picture("turn_plane")
        self.on_plane(reader, [0, 0, 0.12], [0.3, 0.1, 1])

        shown.UpdatePropertyInformation()
        lower, upper = shown.GetProperty("VisibleRange")
        self.assertGreater(lower, RANGE[0])
        self.assertLess(upper, RANGE[1])
        self.assertGreaterEqual(upper, before.max() - 0.4)
        shown.SMProxy.InvokeCommand("RescaleToVisible")
        self.picture("visible_range")
        self.assertEqual([table.RGBPoints[0], table.RGBPoints[-4]], [lower, upper])
        table.RescaleTransferFunction(*RANGE)

        plain = self.picture("back").astype(int)
        shown.PixelExactContours = [-0.3, 0.0, 0.3]
        lines = self.picture("contours")
        black = (lines < 60).all(axis=-1) & ~(plain < 60).all(axis=-1)
        self.assertGreater(black.sum(), 200)
        self.assertTrue(numpy.array_equal(lines[~black], plain[~black]) or black.sum() < 8000)
        shown.PixelExactContours = []
        shown.ElementEdges, shown.EdgeColor = 1, [0, 0, 0]
        edges = self.picture("edges")
        self.assertGreater(((edges < 60).all(axis=-1) & ~(plain < 60).all(axis=-1)).sum(), 200)
        shown.ElementEdges = 0
        shown.Opacity = 0.5
        half = self.picture("opacity")
        self.assertLessEqual(numpy.abs(half - (plain + [51, 102, 153]) / 2).max(), 2)
        shown.Opacity = 1.0

        # The pointer: a pixel's value is that of the probe at its point.
        places = numpy.argwhere(numpy.abs(plain - [51, 102, 153]).max(axis=-1) > 1)
        shown.PickedPixel = [int(n) for n in places[len(places) // 3][::-1]]
        simple.Render(self.view)
        shown.UpdatePropertyInformation()
        picked = list(shown.GetProperty("Picked"))
        self.assertEqual(picked[0], 1)
        self.assertAlmostEqual(probe(reader, [picked[8:11]])["u"][0], picked[5], delta=1e-9)

        shown.PixelExactSurface = "Iso-Surface"
        shown.IsoArray, shown.IsoValue = ["POINTS", "u"], 0.3
        shown.Ambient, shown.Diffuse = 1.0, 0.0
        iso = self.picture("iso_surface")
        hit = ~scene.is_background(iso)
        self.assertGreater(hit.sum(), 500)
        self.assertLessEqual(numpy.abs(iso[hit].astype(int) - scene.mapped("u", [0.3])[0]).max(), 1)
        shown.PixelExactSurface = "Boundary"
        boundary = self.picture("boundary")
        self.assertTrue((hit & scene.is_background(boundary)).sum() == 0)
        shown.PixelExactSurface = "Cut"

        # Slices and clips.
        simple.Hide(reader, self.view)
        first = simple.PixelExactSlice(registrationName="slice1", Input=reader)
        with applied(first):
            first.SliceType.Origin, first.SliceType.Normal = [0, 0, 0], [0, 0, 1]
        of_first = self.display(first)
        one = self.picture("slice")
        self.on_plane(first, [0, 0, 0], [0, 0, 1])
        second = simple.PixelExactSlice(registrationName="slice2", Input=reader)
        with applied(second):
            second.SliceType.Origin, second.SliceType.Normal = [0, 0, 0], [1, 0.2, 0]
        self.display(second)
        two = self.picture("slice_twice")
        self.assertGreater(self.seen(two), self.seen(one))
        with applied(second):
            second.SliceOffsetValues = [-0.3, 0.0, 0.3]
        self.assertGreater(self.seen(self.picture("offsets")), self.seen(two))
        with applied(second):
            second.SliceOffsetValues = [0.0]
        self.assertTrue(numpy.array_equal(self.picture("no_offsets"), two))
        of_first.Visibility = 0
        self.assertLess(self.seen(self.picture("hide")), self.seen(two))
        of_first.Visibility = 1
        clip = simple.PixelExactClip(registrationName="clip", Input=reader)
        with applied(clip):
            clip.ClipType.Origin, clip.ClipType.Normal = [0.1, 0, 0], [1, 0, 0]
        self.display(clip)
        kept = self.picture("clip")
        with applied(clip):
            clip.Invert = 0
        other = self.picture("clip_inverted")
        self.assertFalse(numpy.array_equal(kept, other))
        together = ~scene.is_background(kept) | ~scene.is_background(other)
        self.assertTrue(together[hit].all())

        # Filters.
        simple.HideAll(self.view)
        moved = simple.PixelExactWarp(
            registrationName="warp", Input=reader, Displacement="u", ScaleFactor=0.1, Direction=[0, 0, 1])
        warped = self.display(moved)
        warped.CutFunction.Origin, warped.CutFunction.Normal = [0, 0, 0], [0, 0, 1]
        self.picture("warp")
        self.on_plane(moved, [0, 0, 0], [0, 0, 1])
        simple.Hide(moved, self.view)
        squared = simple.PixelExactCalculator(
            registrationName="squared", Input=reader, ResultArrayName="squared", Function="u*u")
        calculated = simple.Show(squared, self.view)
        simple.ColorBy(calculated, ("POINTS", "squared"))
        simple.GetColorTransferFunction("squared").RescaleTransferFunction(0.0, 1.0)
        calculated.SetScalarBarVisibility(self.view, False)
        calculated.CutFunction.Origin, calculated.CutFunction.Normal = [0, 0, 0], [0, 0, 1]
        self.picture("calculator")
        values = self.on_plane(squared, [0, 0, 0], [0, 0, 1], "squared")
        self.assertGreaterEqual(values.min(), 0.0)
        simple.Hide(squared, self.view)
        part = simple.Threshold(registrationName="part", Input=reader)
        part.Scalars = ["CELLS", "PixelExactElementId"]
        part.LowerThreshold, part.UpperThreshold = 0, 20
        parted = self.display(part)
        parted.SetRepresentationType("PixelExact")
        parted.CutFunction.Origin, parted.CutFunction.Normal = [0, 0, 0], [0, 0, 1]
        threshold = self.picture("threshold")
        self.assertGreater(self.seen(threshold), 300)
        self.assertLess(self.seen(threshold), self.seen(one))
        simple.Hide(part, self.view)

        # Numbers.
        line = simple.PixelExactPlotOverLine(Input=reader, Point1=[0.5, 0.1, 0], Point2=[1.4, 0.2, 0.1])
        data = servermanager.Fetch(line)
        points = vtk_to_numpy(data.GetPoints().GetData())
        along = vtk_to_numpy(data.GetPointData().GetArray("u"))
        probed = probe(reader, points)
        good = (probed["Verdict"] == 1) & numpy.isfinite(along)
        self.assertGreater(good.sum(), 100)
        self.assertLess(numpy.abs(along - probed["u"])[good].max(), 1e-6)
        certified = simple.PixelExactCertify(Input=reader, Field="u")
        certified.UpdatePipeline()
        self.assertEqual(tuple(certified.CellData["Verdict"].GetRange()), (0.0, 0.0))
        area = simple.PixelExactIntegrate(Input=reader, Field="u")
        area.CutFunction.Origin, area.CutFunction.Normal = [0, 0, 0], [0, 0, 1]
        rows = servermanager.Fetch(area).GetRowData()
        self.assertGreater(rows.GetNumberOfArrays(), 2)
        simple.Delete(line)
        simple.Delete(certified)
        simple.Delete(area)

        # The camera, a larger picture, an animation of the plane.
        simple.Show(first, self.view)
        simple.Show(second, self.view)
        self.view.CameraParallelScale = 1.2
        zoomed = self.picture("zoom")
        self.assertGreater(self.seen(zoomed), self.seen(two))
        name = os.path.join(scene.PICTURES, "session_large.png")
        simple.SaveScreenshot(name, self.view, ImageResolution=[2 * n for n in scene.SIZE])
        large = simple.PNGSeriesReader(FileNames=[name])
        large.UpdatePipeline()
        self.assertEqual(large.GetDataInformation().GetNumberOfPoints(), 4 * zoomed.shape[0] * zoomed.shape[1])
        simple.Delete(large)
        program = smtrace.stop_trace()
        final = scene.pixels(self.view)

        for part in "PixelExactSlice(", "PixelExactClip(", "PixelExactWarp(", "SliceOffsetValues":
            self.assertIn(part, program)
        with self.subTest("trace"):
            self.assertTrue(numpy.array_equal(self.again(program, "session_trace"), final))
        with self.subTest("Python state"):
            self.assertTrue(numpy.array_equal(self.again(smstate.get_state(), "session_state"), final))
        with self.subTest("state"):
            name = os.path.join(scene.PICTURES, "session.pvsm")
            simple.SaveState(name)
            loads = "from paraview import simple\nsimple._DisableFirstRenderCameraReset()\n"
            loads += f"simple.LoadState({name!r})\n"
            self.assertTrue(numpy.array_equal(self.again(loads, "session_pvsm"), final))
        with self.subTest("animation"):
            self.animate(first)

    def display(self, source):
        display = simple.Show(source, self.view)
        simple.ColorBy(display, ("POINTS", "u"))
        # ParaView takes the range of the part that is shown.
        simple.GetColorTransferFunction("u").RescaleTransferFunction(*RANGE)
        display.SetScalarBarVisibility(self.view, False)
        with applied(display):
            display.Ambient, display.Diffuse = 1.0, 0.0
        return display

    def animate(self, cut):
        """Each frame is the slice at that height."""
        simple.HideAll(self.view)
        simple.Show(cut, self.view)
        animation = simple.GetAnimationScene()
        animation.NumberOfFrames, animation.PlayMode = 3, "Sequence"
        animation.StartTime, animation.EndTime = 0.0, 2.0
        track = simple.GetAnimationTrack("Origin", index=2, proxy=cut.SliceType)
        frames = [simple.CompositeKeyFrame(KeyTime=t, KeyValues=[z]) for t, z in ((0, -0.1), (1, 0.1))]
        track.KeyFrames = frames
        animation.GoToFirst()
        for height in (-0.1, 0.0, 0.1):
            self.on_plane(cut, [0, 0, height], [0, 0, 1])
            animation.GoToNext()
        simple.SaveAnimation(
            os.path.join(scene.PICTURES, "session_frame.png"), self.view, ImageResolution=scene.SIZE)
        self.assertEqual(len(glob.glob(os.path.join(scene.PICTURES, "session_frame.000*.png"))), 3)


if __name__ == "__main__":
    scene.main()
