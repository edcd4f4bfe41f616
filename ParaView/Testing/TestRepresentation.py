"""Pixels of the representation PixelExact are the colours of the field's values."""

import unittest

import numpy
from paraview import simple

import scene

TORUS = ["toroid_hex_g3_p6.vtu"]


def torus():
    return simple.PixelExactGridReader(FileName=[scene.data(TORUS[0])])


def show(source, field=("POINTS", "u")):
    representation = simple.Show(source)
    representation.SetRepresentationType("PixelExact")
    if field is not None:
        simple.ColorBy(representation, field)
        span = representation_range(representation)
        simple.GetColorTransferFunction(field[1]).RescaleTransferFunction(*span)
        representation.SetScalarBarVisibility(simple.GetActiveView(), False)
    return representation


def representation_range(representation):
    simple.Render()
    representation.UpdatePropertyInformation()
    return list(representation.GetProperty("FieldRange"))


def flat(representation):
    """Colours as they are, whatever the surface's direction."""
    representation.Ambient = 1.0
    representation.Diffuse = 0.0


class Representation(unittest.TestCase):
    def setUp(self):
        self.view = scene.view()

    def tearDown(self):
        simple.ResetSession()

    def check(self, rgb, source, find, field="u"):
        """Compares pixels with the probe at the points that `find` gives for rays; NaN: none."""
        rows, columns = numpy.mgrid[3:237:9, 3:317:9]
        places = numpy.stack([columns.ravel(), rows.ravel()], axis=1)
        points = find(*scene.rays(self.view, places))
        none = numpy.isnan(points[:, 0])
        found = scene.probe(source, numpy.where(none[:, None], 1e9, points))
        shown = rgb[places[:, 1], places[:, 0]]
        hit = ~none & (found["Verdict"] == 1)
        self.assertGreater(hit.sum(), 30)
        expected = scene.mapped(field, found[field][hit])
        self.assertLessEqual(numpy.abs(shown[hit].astype(int) - expected).max(), 1)
        outside = none | (found["Verdict"] == 0)
        self.assertTrue(scene.is_background(shown[outside]).all())

    def test_plane(self):
        source = torus()
        representation = show(source)
        representation.CutFunction.Normal = [0, 0, 1]
        representation.CutFunction.Origin = [0, 0, 0]
        rgb = scene.pixels(self.view, "plane.png")
        self.check(rgb, source, lambda eyes, ahead: eyes - eyes[:, 2:] / ahead[2] * ahead)

    def test_visible_range(self):
        source = torus()
        representation = show(source)
        representation.CutFunction.Normal = [0, 0, 1]
        representation.CutFunction.Origin = [0, 0, 0]
        self.view.CameraPosition, self.view.CameraFocalPoint = [1, 0, 10], [1, 0, 0]
        self.view.CameraParallelScale = 0.4
        simple.Render(self.view)
        rows, columns = numpy.mgrid[: scene.SIZE[1], : scene.SIZE[0]]
        eyes, ahead = scene.rays(self.view, numpy.stack([columns.ravel(), rows.ravel()], axis=1))
        found = scene.probe(source, eyes - eyes[:, 2:] / ahead[2] * ahead)
        seen = found["u"][found["Verdict"] == 1]
        expected = [seen.min(), seen.max()]
        representation.UpdatePropertyInformation()
        told = list(representation.GetProperty("VisibleRange"))
        numpy.testing.assert_allclose(told, expected, rtol=0, atol=1e-12)
        representation.SMProxy.InvokeCommand("RescaleToVisible")  # as the panel's button
        points = simple.GetColorTransferFunction("u").RGBPoints
        numpy.testing.assert_allclose([points[0], points[-4]], told, rtol=0, atol=1e-15)
        points = simple.GetOpacityTransferFunction("u").Points
        numpy.testing.assert_allclose([points[0], points[-4]], told, rtol=0, atol=1e-15)
        representation.CutFunction.Origin = [0, 0, 9]
        simple.Render(self.view)
        representation.UpdatePropertyInformation()
        self.assertEqual(list(representation.GetProperty("VisibleRange")), [1.0, -1.0])
        with scene.messages() as heard:
            representation.SMProxy.InvokeCommand("RescaleToVisible")
        self.assertIn("keeps its range", heard[0])

    def test_plane_of_native_files(self):
        name = "mfem_escher_tet_darcy_p3"
        source = simple.PixelExactMFEMReader(FileName=scene.data(f"{name}/{name}.mesh"))
        source.UpdatePipeline()
        box = source.GetDataInformation().GetBounds()
        middle = [0.5 * (box[0] + box[1]), 0.5 * (box[2] + box[3]), 0.5 * (box[4] + box[5])]
        self.view.CameraFocalPoint = middle
        self.view.CameraPosition = [middle[0], middle[1], middle[2] + 10.0]
        self.view.CameraParallelScale = 0.6 * (box[3] - box[2])
        representation = show(source, ("POINTS", "pressure"))
        representation.CutFunction.Normal = [0, 0, 1]
        representation.CutFunction.Origin = middle
        rgb = scene.pixels(self.view, "plane_mfem.png")
        self.check(
            rgb,
            source,
            lambda eyes, ahead: eyes + ((middle[2] - eyes[:, 2:]) / ahead[2]) * ahead,
            "pressure",
        )

    def test_vector_component(self):
        name = "mfem_escher_tet_darcy_p3"
        source = simple.PixelExactMFEMReader(FileName=scene.data(f"{name}/{name}.mesh"))
        representation = show(source, ("POINTS", "flux", "Magnitude"))
        magnitude = representation_range(representation)
        simple.ColorBy(representation, ("POINTS", "flux", "X"))
        component = representation_range(representation)
        self.assertGreaterEqual(magnitude[0], 0.0)
        self.assertLess(component[0], 0.0)
        self.assertLessEqual(max(abs(x) for x in component), magnitude[1] * (1 + 1e-12))

    def test_sphere(self):
        source = torus()
        representation = show(source)
        flat(representation)
        representation.CutFunction = "Sphere"
        representation.CutFunction.Center = [1.0, 0.0, 0.0]
        representation.CutFunction.Radius = 0.35
        rgb = scene.pixels(self.view, "sphere.png")

        def front(eyes, ahead):
            to = eyes - [1.0, 0.0, 0.0]
            half = to @ ahead
            inner = half**2 - (to**2).sum(axis=1) + 0.35**2
            with numpy.errstate(invalid="ignore"):
                return eyes + (-half - numpy.sqrt(inner))[:, None] * ahead

        # Where the nearer half is outside of the mesh the other half shows.
        rows, columns = numpy.mgrid[3:237:3, 3:317:3]
        places = numpy.stack([columns.ravel(), rows.ravel()], axis=1)
        points = front(*scene.rays(self.view, places))
        seen = ~numpy.isnan(points[:, 0])
        found = scene.probe(source, points[seen])
        inside = found["Verdict"] == 1
        self.assertGreater(inside.sum(), 30)
        shown = rgb[places[seen][inside][:, 1], places[seen][inside][:, 0]].astype(int)
        self.assertLessEqual(
            numpy.abs(shown - scene.mapped("u", found["u"][inside])).max(), 1
        )
        self.assertTrue(scene.is_background(rgb[places[~seen][:, 1], places[~seen][:, 0]]).all())

    def test_each_function_cuts(self):
        representation = show(torus())
        self.view.CameraPosition = [6.0, 4.0, 8.0]
        for name in "Plane", "Sphere", "Cylinder", "Box", "Quadric":
            with self.subTest(name):
                with scene.messages() as heard:
                    representation.CutFunction = name
                    rgb = scene.pixels(self.view, f"{name.lower()}_default.png")
                self.assertEqual(heard, [""])
                self.assertGreater((~scene.is_background(rgb)).sum(), 300)

    def test_quadric_is_a_sphere(self):
        representation = show(torus())
        representation.CutFunction = "Sphere"
        representation.CutFunction.Center = [0, 0, 0]
        representation.CutFunction.Radius = 1.0
        sphere = scene.pixels(self.view)
        representation.CutFunction = "Quadric"
        representation.CutFunction.QuadricCoefficients = [1, 1, 1, 0, 0, 0, 0, 0, 0, -1]
        quadric = scene.pixels(self.view)
        # Rounding may move a pixel at the rim.
        different = numpy.abs(sphere.astype(int) - quadric).max(axis=-1) > 1
        self.assertLess(different.sum(), 5)

    def test_boundary(self):
        source = torus()
        representation = show(source)
        flat(representation)
        representation.PixelExactSurface = "Boundary"
        rgb = scene.pixels(self.view, "boundary.png")
        seen = ~scene.is_background(rgb)
        # What the plane z = 0 cuts is inside of the silhouette.
        representation.PixelExactSurface = "Cut"
        representation.CutFunction.Normal = [0, 0, 1]
        cut = ~scene.is_background(scene.pixels(self.view))
        self.assertGreater(cut.sum(), 1000)
        self.assertFalse((cut & ~seen).any())

    def test_iso_surface(self):
        representation = show(torus())
        flat(representation)
        representation.PixelExactSurface = "Iso-Surface"
        representation.IsoArray = ["POINTS", "u"]
        representation.IsoValue = 0.25
        rgb = scene.pixels(self.view, "isosurface.png")
        seen = ~scene.is_background(rgb)
        self.assertGreater(seen.sum(), 1000)
        color = scene.mapped("u", [0.25])[0]
        self.assertLessEqual(numpy.abs(rgb[seen].astype(int) - color).max(), 1)
        with scene.messages() as heard:
            representation.IsoValue = 5.0
            rgb = scene.pixels(self.view)
        self.assertTrue(scene.is_background(rgb).all())
        self.assertIn("choose a value between", heard[0])

    def test_lines(self):
        representation = show(torus())
        representation.CutFunction.Normal = [0, 0, 1]
        before = scene.pixels(self.view)
        representation.PixelExactContours = [-0.4, 0.0, 0.4]
        contours = scene.pixels(self.view, "contours.png")
        black = (contours < 60).all(axis=-1) & ~(before < 60).all(axis=-1)
        self.assertGreater(black.sum(), 200)
        representation.PixelExactContours = []
        # A number of them, as the program's --contours 3.
        representation.ContourCount = 3
        counted = (scene.pixels(self.view, "counted.png") < 60).all(axis=-1) & ~(before < 60).all(axis=-1)
        self.assertGreater(counted.sum(), 100)
        representation.ContourCount = 0
        self.assertTrue(numpy.array_equal(scene.pixels(self.view), before))
        representation.ElementEdges = 1
        representation.EdgeColor = [0, 0, 0]
        edges = scene.pixels(self.view, "edges.png")
        black = (edges < 60).all(axis=-1) & ~(before < 60).all(axis=-1)
        self.assertGreater(black.sum(), 200)

    def test_opacity(self):
        representation = show(torus())
        representation.CutFunction.Normal = [0, 0, 1]
        opaque = scene.pixels(self.view).astype(int)
        representation.Opacity = 0.5
        half = scene.pixels(self.view, "opacity.png").astype(int)
        expected = (opaque + [51, 102, 153]) / 2
        self.assertLessEqual(numpy.abs(half - expected).max(), 2)

    def test_one_color(self):
        representation = show(torus(), None)
        simple.ColorBy(representation, None)
        flat(representation)
        representation.CutFunction.Normal = [0, 0, 1]
        representation.AmbientColor = [1, 0, 0]
        representation.DiffuseColor = [1, 0, 0]
        rgb = scene.pixels(self.view)
        seen = ~scene.is_background(rgb)
        self.assertGreater(seen.sum(), 1000)
        self.assertTrue((rgb[seen] == [255, 0, 0]).all())

    def test_moved(self):
        representation = show(torus())
        representation.CutFunction.Normal = [0, 0, 1]
        before = scene.pixels(self.view)
        step = 2.0 * self.view.CameraParallelScale / scene.SIZE[1]
        # ParaView 5.13 has renamed it.
        names = {"Position", "Translation"} & set(representation.ListProperties())
        setattr(representation, names.pop(), [20 * step, 0, 0])
        after = scene.pixels(self.view)
        moved = numpy.abs(after[:, 20:].astype(int) - before[:, :-20]).max(axis=-1) > 1
        self.assertLess(moved.sum(), 20)

    def test_time_steps(self):
        files = [scene.data(name) for name in TORUS + ["escher_tet_g3_p3.vtu"]]
        source = simple.PixelExactGridReader(FileName=files)
        steps = []
        for time in 0.0, 1.0:
            representation = show(source)
            representation.CutFunction.Origin = [0, 0, 0]
            representation.CutFunction.Normal = [0, 0, 1]
            simple.GetColorTransferFunction("u").RescaleTransferFunction(-0.5, 0.5)
            self.view.ViewTime = time
            steps.append(scene.pixels(self.view))
        simple.Hide(source)
        representation = show(simple.PixelExactGridReader(FileName=files[1:]))
        representation.CutFunction.Origin = [0, 0, 0]
        representation.CutFunction.Normal = [0, 0, 1]
        simple.GetColorTransferFunction("u").RescaleTransferFunction(-0.5, 0.5)
        self.assertTrue(numpy.array_equal(scene.pixels(self.view), steps[1]))
        self.assertFalse(numpy.array_equal(*steps))

    def test_plain_grid_is_converted(self):
        plain = simple.XMLUnstructuredGridReader(FileName=[scene.data(TORUS[0])])
        representation = show(plain)
        representation.CutFunction.Normal = [0, 0, 1]
        first = scene.pixels(self.view)
        simple.Hide(plain)
        representation = show(torus())
        representation.CutFunction.Normal = [0, 0, 1]
        self.assertTrue(numpy.array_equal(scene.pixels(self.view), first))

    def test_moved_data(self):
        show(torus()).CutFunction.Normal = [0, 0, 1]
        first = scene.pixels(self.view)
        simple.HideAll(self.view)
        moved = simple.Transform(Input=torus())
        moved.Transform.Translate = [0.0, 0.0, 0.5]
        representation = show(moved)
        representation.CutFunction.Normal = [0, 0, 1]
        representation.CutFunction.Origin = [0, 0, 0.5]
        with scene.messages() as heard:
            rgb = scene.pixels(self.view)
        self.assertEqual(heard, [""])
        # Colours of neighbours may differ in their last bit.
        self.assertLess(numpy.abs(rgb.astype(int) - first).max(axis=-1).mean(), 0.1)

    def test_cut_data(self):
        cut = simple.Clip(Input=torus())
        representation = simple.Show(cut)
        representation.SetRepresentationType("PixelExact")
        with scene.messages() as heard:
            rgb = scene.pixels(self.view)
        self.assertTrue(scene.is_background(rgb).all())
        self.assertIn("a conversion would lose", heard[0])

    def test_results_of_calculator(self):
        """Drawn as what they are: the polynomial through the values at the cells' points."""
        name = "nek_tet_varp"
        reader = simple.PixelExactNektarReader(FileName=[scene.data(f"{name}/{name}.xml")])
        result = simple.Calculator(Input=reader, Function="2*u + 1", ResultArrayName="Result")
        representation = simple.Show(result)
        representation.SetRepresentationType("PixelExact")
        representation.CutFunction.Normal = [0, 0, 1]
        simple.ColorBy(representation, ("POINTS", "Result"))
        with scene.messages() as heard:
            rgb = scene.pixels(self.view)
        # ParaView's range is that of the points.
        self.assertIn("the colour map spans the values in the array 'Result'", heard[0])
        self.assertNotIn("no high-order field", heard[0])
        self.assertFalse(scene.is_background(rgb).all())

    def test_another_array_of_that_name(self):
        """Averages at points are not the field, whose values cells have."""
        name = "mfem_escher_tet_darcy_p3"
        reader = simple.PixelExactMFEMReader(FileName=scene.data(f"{name}/{name}.mesh"), Cells="Corners")
        averaged = simple.CellDatatoPointData(reader, PassCellData=1)
        representation = simple.Show(averaged)
        representation.SetRepresentationType("PixelExact")
        for association, part in ("CELLS", ""), ("POINTS", "is not the field of that name"):
            simple.ColorBy(representation, (association, "pressure"))
            with scene.messages() as heard:
                scene.pixels(self.view)
            self.assertIn(part, heard[0])
            self.assertEqual(heard[0] == "", part == "")

    def test_subset(self):
        source = torus()
        clipped = simple.Threshold(Input=source)
        clipped.Scalars = ["CELLS", "PixelExactElementId"]
        clipped.LowerThreshold, clipped.UpperThreshold = 0, 20
        representation = show(clipped)
        representation.CutFunction.Normal = [0, 0, 1]
        with scene.messages() as heard:
            part = ~scene.is_background(scene.pixels(self.view, "threshold.png"))
        self.assertEqual(heard, [""])
        self.assertGreater(part.sum(), 500)

    def test_narrow_color_map_is_told(self):
        """Arrays of ParaView's own readers have the range of the points' values."""
        plain = simple.XMLUnstructuredGridReader(FileName=[scene.data(TORUS[0])])
        representation = simple.Show(plain)
        representation.SetRepresentationType("PixelExact")
        simple.ColorBy(representation, ("POINTS", "u"))
        with scene.messages() as heard:
            scene.pixels(self.view)
        for part in "colour map", "-0.884489", "Rescale to Custom Range":
            self.assertIn(part, heard[0])
        with scene.messages() as heard:
            simple.GetColorTransferFunction("u").RescaleTransferFunction(-0.5, 0.5)
            scene.pixels(self.view)
        self.assertEqual(heard, [""])

    def test_what_is_no_field(self):
        representation = simple.Show(torus())
        representation.SetRepresentationType("PixelExact")
        simple.ColorBy(representation, ("CELLS", "PixelExactElementId"))
        with scene.messages() as heard:
            rgb = scene.pixels(self.view)
        self.assertTrue(scene.is_background(rgb).all())
        self.assertIn("there is no field 'PixelExactElementId'; choose one of 'u'", heard[0])


if __name__ == "__main__":
    scene.main()
