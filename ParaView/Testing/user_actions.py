"""Thirty-one actions of a user, and what the picture after each must show.

TestSession takes them in pvbatch and repeats their trace. TestWindow takes them in ParaView's own
window, with a screenshot of the window after each.
"""

import contextlib

import numpy
from paraview import servermanager, simple, smtrace
from vtkmodules.util.numpy_support import vtk_to_numpy

import scene

FILE = scene.data("toroid_hex_g3_p6.vtu")
RANGE = (-0.9, 0.9)


class Actions:
    """For test cases with a view of `size`, and `is_traced` where ParaView records a trace."""

    is_traced = False
    size = scene.SIZE

    @contextlib.contextmanager
    def applied(self, proxy):
        """Records changes of properties, as the button Apply does; those of scripts are not traced."""
        with self.recorded("PropertiesModified", kwargs={"proxy": proxy.SMProxy}):
            yield

    @contextlib.contextmanager
    def recorded(self, *item, **settings):
        made = smtrace._create_trace_item_internal(*item, **settings) if self.is_traced else None
        yield
        if made is not None:
            made.finalize()

    def unrecorded(self):
        """Keeps what the checks do out of the trace."""
        return self.recorded("BlockTraceItems")

    def probe(self, source, points):
        with self.unrecorded():
            return scene.probe(source, points)

    def seen(self, rgb):
        return int((~scene.is_background(rgb)).sum())

    def dark(self, rgb, plain):
        """The number of pixels that are black, and were not."""
        return int(((rgb < 60).all(axis=-1) & ~(plain < 60).all(axis=-1)).sum())

    def on_plane(self, source, origin, normal, field="u"):
        """Compares the picture with values of PixelExact Probe where rays meet a plane."""
        rgb = scene.pixels(self.view)
        height, width, _ = rgb.shape
        rows, columns = numpy.mgrid[3 : height - 3 : 6, 3 : width - 3 : 6]
        places = numpy.stack([columns.ravel(), rows.ravel()], axis=1)
        eyes, ahead = scene.rays(self.view, places, (width, height))
        along = ((numpy.array(origin) - eyes) @ normal) / (ahead @ normal)
        found = self.probe(source, eyes + along[:, None] * ahead)
        inside = found["Verdict"] == 1
        self.assertGreater(inside.sum(), 100)
        shown = rgb[places[:, 1], places[:, 0]].astype(int)
        off = numpy.abs(shown[inside] - scene.mapped(field, found[field][inside])).max(axis=1)
        self.assertLessEqual(numpy.percentile(off, 98), 1)
        return found[field][inside]

    def display(self, source):
        display = simple.Show(source, self.view)
        simple.ColorBy(display, ("POINTS", "u"))
        # ParaView takes the range of the part that is shown.
        simple.GetColorTransferFunction("u").RescaleTransferFunction(*RANGE)
        display.SetScalarBarVisibility(self.view, False)
        with self.applied(display):
            display.Ambient, display.Diffuse = 1.0, 0.0
        return display

    def actions(self):
        """Yields the name of each action, after it, and gets the picture."""
        scene.aim(self.view, direction=(0.3, 0.2, -1.0), scale=1.5, size=self.size)
        self.reader = simple.PixelExactGridReader(registrationName="torus", FileName=[FILE])
        self.shown = simple.Show(self.reader, self.view)
        self.shown.SetScalarBarVisibility(self.view, False)
        self.assertEqual(self.shown.Representation, "PixelExact")
        self.assertGreater(self.seen((yield "open")), 200)
        yield from self.colors()
        yield from self.lines()
        yield from self.surfaces()
        yield from self.slices()
        yield from self.filters()
        # The camera.
        simple.Show(self.first, self.view)
        simple.Show(self.second, self.view)
        self.view.CameraParallelScale = 1.2
        self.assertGreater(self.seen((yield "zoom")), self.seen(self.two))

    def colors(self):
        shown, reader = self.shown, self.reader
        with self.applied(shown):
            shown.CutFunction.Origin, shown.CutFunction.Normal = [0, 0, 0], [0, 0, 1]
        simple.ColorBy(shown, ("POINTS", "u"))
        yield "color"
        self.on_plane(reader, [0, 0, 0], [0, 0, 1])
        table = simple.GetColorTransferFunction("u")
        table.RescaleTransferFunction(*RANGE)
        yield "custom_range"
        self.on_plane(reader, [0, 0, 0], [0, 0, 1])
        table.ApplyPreset("Viridis (matplotlib)", True)
        yield "preset"
        self.on_plane(reader, [0, 0, 0], [0, 0, 1])
        table.ApplyPreset("Cool to Warm", True)
        table.RescaleTransferFunction(*RANGE)

        shown.CutFunction.Origin = [0, 0, 0.12]
        yield "move_plane"
        before = self.on_plane(reader, [0, 0, 0.12], [0, 0, 1])
        shown.CutFunction.Normal = [0.3, 0.1, 1]
        yield "turn_plane"
        self.on_plane(reader, [0, 0, 0.12], [0.3, 0.1, 1])

        shown.UpdatePropertyInformation()
        lower, upper = shown.GetProperty("VisibleRange")
        self.assertGreater(lower, RANGE[0])
        self.assertLess(upper, RANGE[1])
        self.assertGreaterEqual(upper, before.max() - 0.4)
        shown.SMProxy.InvokeCommand("RescaleToVisible")
        yield "visible_range"
        numpy.testing.assert_allclose([table.RGBPoints[0], table.RGBPoints[-4]], [lower, upper], rtol=1e-14)
        table.RescaleTransferFunction(*RANGE)

    def lines(self):
        shown = self.shown
        plain = (yield "back").astype(int)
        shown.PixelExactContours = [-0.3, 0.0, 0.3]
        lines = yield "contours"
        black = (lines < 60).all(axis=-1) & ~(plain < 60).all(axis=-1)
        self.assertGreater(black.sum(), 200)
        self.assertTrue(numpy.array_equal(lines[~black], plain[~black]) or black.sum() < 8000)
        shown.ContourLabels = 1
        changed = ((yield "contour_labels") != lines).any(axis=-1).sum()
        self.assertGreater(changed, 50)
        self.assertLess(changed, plain[:, :, 0].size / 20)
        shown.ContourLabels = 0
        shown.PixelExactContours = []
        shown.ElementEdges, shown.EdgeColor = 1, [0, 0, 0]
        self.assertGreater(self.dark((yield "edges"), plain), 200)
        shown.EdgesByKind = 1
        blue = numpy.abs((yield "edges_by_kind").astype(int) - [0, 114, 178]).max(axis=-1) < 40
        self.assertGreater((blue & ~scene.is_background(plain)).sum(), 50)
        shown.EdgesByKind = 0
        shown.ElementEdges = 0
        shown.Opacity = 0.5
        half = yield "opacity"
        self.assertLessEqual(numpy.abs(half - (plain + [51, 102, 153]) / 2).max(), 2)
        shown.Opacity = 1.0

        # The pointer: a pixel's value is that of the probe at its point.
        places = numpy.argwhere(numpy.abs(plain - [51, 102, 153]).max(axis=-1) > 1)
        shown.PickedPixel = [int(n) for n in places[len(places) // 3][::-1]]
        simple.Render(self.view)
        shown.UpdatePropertyInformation()
        picked = list(shown.GetProperty("Picked"))
        self.assertEqual(picked[0], 1)
        self.assertAlmostEqual(self.probe(self.reader, [picked[8:11]])["u"][0], picked[5], delta=1e-9)

    def surfaces(self):
        shown = self.shown
        shown.CutFunction = "Sphere"
        shown.CutFunction.Center, shown.CutFunction.Radius = [0.9, 0, 0], 0.5
        self.assertGreater(self.seen((yield "sphere")), 500)
        shown.CutFunction = "Plane"
        shown.PixelExactSurface = "Iso-Surface"
        shown.IsoArray, shown.IsoValue = ["POINTS", "u"], 0.3
        shown.Ambient, shown.Diffuse = 1.0, 0.0
        iso = yield "iso_surface"
        self.hit = ~scene.is_background(iso)
        self.assertGreater(self.hit.sum(), 500)
        self.assertLessEqual(numpy.abs(iso[self.hit].astype(int) - scene.mapped("u", [0.3])[0]).max(), 1)
        shown.PixelExactSurface = "Boundary"
        boundary = yield "boundary"
        self.assertTrue((self.hit & scene.is_background(boundary)).sum() == 0)
        shown.Opacity = 0.6
        without = scene.pixels(self.view).astype(int)
        shown.ElementEdges = 1
        changed = numpy.abs((yield "translucent_boundary").astype(int) - without).max(axis=-1) > 20
        self.assertGreater(changed.sum(), 0.02 * self.seen(boundary))
        self.assertLess(changed.sum(), 0.2 * self.seen(boundary))
        shown.ElementEdges, shown.Opacity = 0, 1.0
        shown.PixelExactSurface = "Cut"

    def slices(self):
        simple.Hide(self.reader, self.view)
        first = self.first = simple.PixelExactSlice(registrationName="slice1", Input=self.reader)
        with self.applied(first):
            first.SliceType.Origin, first.SliceType.Normal = [0, 0, 0], [0, 0, 1]
        of_first = self.display(first)
        self.one = yield "slice"
        self.on_plane(first, [0, 0, 0], [0, 0, 1])
        second = self.second = simple.PixelExactSlice(registrationName="slice2", Input=self.reader)
        with self.applied(second):
            second.SliceType.Origin, second.SliceType.Normal = [0, 0, 0], [1, 0.2, 0]
        self.display(second)
        two = self.two = yield "slice_twice"
        self.assertGreater(self.seen(two), self.seen(self.one))
        with self.applied(second):
            second.SliceOffsetValues = [-0.3, 0.0, 0.3]
        self.assertGreater(self.seen((yield "offsets")), self.seen(two))
        with self.applied(second):
            second.SliceOffsetValues = [0.0]
        self.assertTrue(numpy.array_equal((yield "no_offsets"), two))
        of_first.Visibility = 0
        self.assertLess(self.seen((yield "hide")), self.seen(two))
        of_first.Visibility = 1
        clip = simple.PixelExactClip(registrationName="clip", Input=self.reader)
        with self.applied(clip):
            clip.ClipType.Origin, clip.ClipType.Normal = [0.1, 0, 0], [1, 0, 0]
        self.display(clip)
        kept = yield "clip"
        with self.applied(clip):
            clip.Invert = 0
        other = yield "clip_inverted"
        self.assertFalse(numpy.array_equal(kept, other))
        together = ~scene.is_background(kept) | ~scene.is_background(other)
        self.assertTrue(together[self.hit].all())
        simple.HideAll(self.view)

    def filters(self):
        reader = self.reader
        moved = simple.PixelExactWarp(
            registrationName="warp", Input=reader, Displacement="u", ScaleFactor=0.1, Direction=[0, 0, 1])
        warped = self.display(moved)
        warped.CutFunction.Origin, warped.CutFunction.Normal = [0, 0, 0], [0, 0, 1]
        yield "warp"
        self.on_plane(moved, [0, 0, 0], [0, 0, 1])
        simple.Hide(moved, self.view)
        squared = simple.PixelExactCalculator(
            registrationName="squared", Input=reader, ResultArrayName="squared", Function="u*u")
        self.show_by(squared, "squared")
        yield "calculator"
        values = self.on_plane(squared, [0, 0, 0], [0, 0, 1], "squared")
        self.assertGreaterEqual(values.min(), 0.0)
        simple.Hide(squared, self.view)
        # ParaView's own: the polynomial through values at points, which the legend and the pointer say.
        nodal = simple.Calculator(
            registrationName="nodal", Input=reader, ResultArrayName="nodal", Function="u*u")
        shown = self.show_by(nodal, "nodal")
        shown.VerdictLegend = 1
        rgb = yield "paraview_calculator"
        places = numpy.argwhere(~scene.is_background(rgb))
        shown.PickedPixel = [int(n) for n in places[len(places) // 2][::-1]]
        simple.Render(self.view)
        shown.UpdatePropertyInformation()
        self.assertIn("nodal (interpolated, not the formula) = ", str(shown.GetProperty("PickedText")))
        simple.Hide(nodal, self.view)
        part = simple.Threshold(registrationName="part", Input=reader)
        part.Scalars = ["CELLS", "PixelExactElementId"]
        part.LowerThreshold, part.UpperThreshold = 0, 20
        parted = self.display(part)
        parted.SetRepresentationType("PixelExact")
        parted.CutFunction.Origin, parted.CutFunction.Normal = [0, 0, 0], [0, 0, 1]
        threshold = yield "threshold"
        self.assertGreater(self.seen(threshold), 300)
        self.assertLess(self.seen(threshold), self.seen(self.one))
        simple.Hide(part, self.view)
        triangles = simple.PixelExactLinearCut(registrationName="triangles", Input=self.first, Resolution=40)
        self.display(triangles)
        exact = ~scene.is_background(self.one)
        linear = ~scene.is_background((yield "linear_cut"))
        self.assertLess((exact != linear).sum(), 0.02 * exact.sum())
        simple.Hide(triangles, self.view)
        lines = simple.PixelExactContour(
            registrationName="lines", Input=self.first, ContourBy="u", ContourValues=[-0.3, 0.0, 0.3])
        self.display(lines)
        drawn = self.seen((yield "contour_filter"))
        self.assertGreater(drawn, 200)
        self.assertLess(drawn, 0.2 * exact.sum())
        simple.Hide(lines, self.view)
        self.numbers()

    def show_by(self, source, name):
        """Shows a plane through the source, coloured by a field of squares."""
        shown = simple.Show(source, self.view)
        shown.SetRepresentationType("PixelExact")
        simple.ColorBy(shown, ("POINTS", name))
        simple.GetColorTransferFunction(name).RescaleTransferFunction(0.0, 1.0)
        shown.SetScalarBarVisibility(self.view, False)
        shown.CutFunction.Origin, shown.CutFunction.Normal = [0, 0, 0], [0, 0, 1]
        return shown

    def numbers(self):
        """Filters that give numbers and no picture."""
        line = simple.PixelExactPlotOverLine(Input=self.reader, Point1=[0.5, 0.1, 0], Point2=[1.4, 0.2, 0.1])
        data = servermanager.Fetch(line)
        points = vtk_to_numpy(data.GetPoints().GetData())
        along = vtk_to_numpy(data.GetPointData().GetArray("u"))
        probed = self.probe(self.reader, points)
        good = (probed["Verdict"] == 1) & numpy.isfinite(along)
        self.assertGreater(good.sum(), 100)
        self.assertLess(numpy.abs(along - probed["u"])[good].max(), 1e-6)
        certified = simple.PixelExactCertify(Input=self.reader, Field="u")
        certified.UpdatePipeline()
        self.assertEqual(tuple(certified.CellData["Verdict"].GetRange()), (0.0, 0.0))
        area = simple.PixelExactIntegrate(Input=self.reader, Field="u", UseCutOfInput=0)
        area.CutFunction.Origin, area.CutFunction.Normal = [0, 0, 0], [0, 0, 1]
        rows = servermanager.Fetch(area).GetRowData()
        self.assertGreater(rows.GetNumberOfArrays(), 2)
        for made in line, certified, area:
            simple.Delete(made)
