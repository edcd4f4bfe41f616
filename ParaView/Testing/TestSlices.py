"""PixelExact Slice and PixelExact Clip draw what their functions leave of the mesh."""

import unittest

import numpy
from paraview import simple
from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkPoints
from vtkmodules.vtkCommonDataModel import VTK_HEXAHEDRON, vtkUnstructuredGrid

import scene

CORNERS = ((0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1))
SLOPE = numpy.array([0.2, 0.3, 0.4])


def cube():
    """The cube [-1, 1]^3 as one cell, with u = SLOPE x."""
    grid, points, values = vtkUnstructuredGrid(), vtkPoints(), vtkDoubleArray()
    points.SetDataTypeToDouble()
    values.SetName("u")
    for corner in CORNERS:
        place = 2.0 * numpy.array(corner) - 1.0
        points.InsertNextPoint(place)
        values.InsertNextValue(float(SLOPE @ place))
    grid.InsertNextCell(VTK_HEXAHEDRON, 8, range(8))
    grid.SetPoints(points)
    grid.GetPointData().SetScalars(values)
    source = simple.TrivialProducer()
    source.GetClientSideObject().SetOutput(grid)
    source.MarkModified(source.SMProxy)
    return source


def torus():
    return simple.PixelExactGridReader(FileName=[scene.data("toroid_hex_g3_p6.vtu")])


def color(shown, view, lower=-0.9, upper=0.9):
    """Colours by u, unlit, so that a pixel is the colour of a value."""
    simple.ColorBy(shown, ("POINTS", "u"))
    simple.GetColorTransferFunction("u").RescaleTransferFunction(lower, upper)
    shown.SetScalarBarVisibility(view, False)
    shown.Ambient, shown.Diffuse = 1.0, 0.0


def of_plane(origin, normal):
    """A plane's function and its intersections with rays."""
    origin, normal = numpy.array(origin, dtype=float), numpy.array(normal, dtype=float)

    def roots(eyes, ahead):
        return [((origin - eyes) @ normal) / (ahead @ normal)]

    return lambda x: (x - origin) @ normal, roots


def of_sphere(centre, radius):
    """The same of a sphere."""
    centre = numpy.array(centre, dtype=float)

    def roots(eyes, ahead):
        half = (eyes - centre) @ ahead
        with numpy.errstate(invalid="ignore"):
            root = numpy.sqrt(half**2 - ((eyes - centre) ** 2).sum(axis=1) + radius**2)
        return [-half - root, -half + root]

    return lambda x: ((x - centre) ** 2).sum(axis=-1) - radius**2, roots


def of_faces():
    """The same of the faces of the cube, less their function."""

    def roots(eyes, ahead):
        return [(side - eyes[:, axis]) / ahead[axis] for axis in range(3) for side in (-1.0, 1.0)]

    return roots


class Slices(unittest.TestCase):
    def setUp(self):
        self.view = scene.view(direction=numpy.array([-3.0, 2.0, -5.0]) / numpy.sqrt(38.0))

    def tearDown(self):
        simple.ResetSession()

    def show(self, source):
        shown = simple.Show(source, self.view)
        color(shown, self.view)
        return shown

    def check(self, kept, surfaces):
        """Compares pixels with the first point of the cube on one of `surfaces`, of roots, that `kept`
        keeps: a function of points and of the number of the surface."""
        rgb = scene.pixels(self.view, f"{self.id().split('.')[-1]}.png")
        rows, columns = numpy.mgrid[2:240:3, 2:320:3]
        places = numpy.stack([columns.ravel(), rows.ravel()], axis=1)
        eyes, ahead = scene.rays(self.view, places)
        nearest = numpy.full(len(places), numpy.inf)
        margin = numpy.full(len(places), numpy.inf)
        for number, roots in enumerate(surfaces):
            for t in roots(eyes, ahead):
                x = eyes + t[:, None] * ahead
                slack = numpy.minimum(1.0 - numpy.abs(x).max(axis=1) + 1e-9, kept(x, number))
                slack = numpy.where(numpy.isnan(t), -numpy.inf, slack)
                nearest = numpy.where((slack >= 0) & (t < nearest), t, nearest)
                # The faces themselves are at slack 1e-9.
                margin = numpy.where(numpy.abs(slack) > 1e-8, numpy.minimum(margin, numpy.abs(slack)), margin)
        clear = margin > 0.02
        hit = clear & numpy.isfinite(nearest)
        self.assertGreater(hit.sum(), 300)
        values = (eyes[hit] + nearest[hit][:, None] * ahead) @ SLOPE
        shown = rgb[places[:, 1], places[:, 0]]
        off = numpy.abs(shown[hit].astype(int) - scene.mapped("u", values)).max(axis=1)
        self.assertLessEqual(numpy.percentile(off, 99), 1)
        self.assertTrue(scene.is_background(shown[clear & ~numpy.isfinite(nearest)]).all())

    def test_offsets(self):
        """Three planes of one filter."""
        cut = simple.PixelExactSlice(Input=cube(), SliceType="Plane")
        cut.SliceType.Origin, cut.SliceType.Normal = [0, 0, 0], [0, 0, 2]
        cut.SliceOffsetValues = [-0.5, 0.0, 0.6]
        self.show(cut)
        planes = [of_plane([0, 0, z], [0, 0, 1])[1] for z in (-0.5, 0.0, 0.6)]
        self.check(lambda x, number: numpy.full(len(x), 1.0), planes)

    def test_clip_by_plane(self):
        clip = simple.PixelExactClip(Input=cube(), ClipType="Plane")
        clip.ClipType.Origin, clip.ClipType.Normal = [0.2, 0, 0], [1, 0.3, 0.5]
        shown = self.show(clip)
        self.assertEqual(shown.PixelExactSurface, "Slice or Clip")
        value, roots = of_plane([0.2, 0, 0], [1, 0.3, 0.5])
        self.check(lambda x, number: numpy.where(number == 0, -value(x), 1.0), [of_faces(), roots])
        clip.Invert = 0
        self.check(lambda x, number: numpy.where(number == 0, value(x), 1.0), [of_faces(), roots])

    def test_clip_by_sphere(self):
        clip = simple.PixelExactClip(Input=cube(), ClipType="Sphere")
        clip.ClipType.Center, clip.ClipType.Radius = [0.3, 0, 0.5], 0.9
        self.show(clip)
        value, roots = of_sphere([0.3, 0, 0.5], 0.9)
        self.check(lambda x, number: numpy.where(number == 0, -value(x), 1.0), [of_faces(), roots])
        clip.Invert = 0
        self.check(lambda x, number: numpy.where(number == 0, value(x), 1.0), [of_faces(), roots])

    def test_two_clips(self):
        first = simple.PixelExactClip(Input=cube(), ClipType="Plane")
        first.ClipType.Origin, first.ClipType.Normal = [0.2, 0, 0], [1, 0, 0]
        second = simple.PixelExactClip(Input=first, ClipType="Sphere", Invert=0)
        second.ClipType.Center, second.ClipType.Radius = [0, 0, 1], 0.8
        self.show(second)
        plane, of_first = of_plane([0.2, 0, 0], [1, 0, 0])
        sphere, of_second = of_sphere([0, 0, 1], 0.8)

        def kept(x, number):
            both = numpy.minimum(-plane(x), sphere(x))
            return (both, sphere(x), -plane(x))[number]

        self.check(kept, [of_faces(), of_first, of_second])

    def test_slice_of_clip(self):
        clip = simple.PixelExactClip(Input=cube(), ClipType="Sphere")
        clip.ClipType.Center, clip.ClipType.Radius = [0, 0, 0], 0.8
        cut = simple.PixelExactSlice(Input=clip, SliceType="Plane")
        cut.SliceType.Origin, cut.SliceType.Normal = [0, 0, 0.1], [0, 0, 1]
        self.show(cut)
        value, _ = of_sphere([0, 0, 0], 0.8)
        self.check(lambda x, number: -value(x), [of_plane([0, 0, 0.1], [0, 0, 1])[1]])

    def test_each_function_slices(self):
        """Pixels are those of the representation's own cut by that function."""
        reader = torus()
        settings = {
            "Plane": {"Origin": [0.1, 0, 0], "Normal": [0.2, 0.1, 1]},
            "Sphere": {"Center": [1, 0, 0], "Radius": 0.45},
            "Cylinder": {"Center": [0.2, 0.1, 0], "Axis": [0, 1, 1], "Radius": 0.8},
            "Box": {"Position": [-0.5, -0.6, -0.2], "Rotation": [10, 20, 30], "Length": [1, 0.9, 0.3]},
            "Quadric": {"QuadricCoefficients": [1, 1, 1, 0, 0, 0, 0, 0, 0, -1]},
            "Torus": {"Center": [0, 0, 0], "Axis": [0, 0, 2], "Radius": 1, "TubeRadius": 0.15},
        }
        for name, values in settings.items():
            with self.subTest(name):
                shown = self.show(reader)
                shown.CutFunction = name
                cut = simple.PixelExactSlice(Input=reader, SliceType=name)
                for key, value in values.items():
                    setattr(shown.CutFunction, key, value)
                    setattr(cut.SliceType, key, value)
                wanted = scene.pixels(self.view)
                simple.Hide(reader, self.view)
                self.show(cut)
                with scene.messages() as heard:
                    rgb = scene.pixels(self.view, f"slice_{name.lower()}.png")
                self.assertEqual(heard, [""])
                self.assertGreater((~scene.is_background(rgb)).sum(), 300)
                self.assertTrue(numpy.array_equal(rgb, wanted))
                simple.Delete(cut)

    def test_several_of_a_source(self):
        """Each is shown and hidden on its own."""
        reader = torus()
        cuts = []
        for normal in ([0, 0, 1], [1, 1, 0]):
            cut = simple.PixelExactSlice(Input=reader)
            cut.SliceType.Origin, cut.SliceType.Normal = [0, 0, 0], normal
            self.show(cut)
            cuts.append(cut)
        both = scene.pixels(self.view, "two_slices.png")
        alone = []
        for cut, other in (cuts, cuts[::-1]):
            simple.Hide(other, self.view)
            simple.Show(cut, self.view)
            alone.append(scene.pixels(self.view))
        seen = [~scene.is_background(rgb) for rgb in alone]
        self.assertTrue(numpy.array_equal(seen[0] | seen[1], ~scene.is_background(both)))
        # Where one is seen alone it has its own colour.
        for one, other, rgb in ((0, 1, alone[0]), (1, 0, alone[1])):
            only = seen[one] & ~seen[other]
            self.assertGreater(only.sum(), 30)
            self.assertTrue(numpy.array_equal(both[only], rgb[only]))

    def test_state(self):
        cut = simple.PixelExactSlice(Input=torus(), SliceType="Sphere")
        cut.SliceType.Center, cut.SliceType.Radius = [1, 0, 0], 0.45
        shown = self.show(cut)
        for surface in "Slice or Clip", "Boundary":
            shown.PixelExactSurface = surface
            before = scene.pixels(self.view)
            name = f"{scene.PICTURES}/slice.pvsm"
            simple.SaveState(name)
            simple.ResetSession()
            simple.LoadState(name)
            self.view = simple.GetRenderViews()[0]
            shown = simple.GetDisplayProperties(simple.FindSource("PixelExactSlice1"), self.view)
            scene.make_plain(self.view)
            self.assertTrue(numpy.array_equal(scene.pixels(self.view), before))

    def test_messages(self):
        shown = simple.Show(torus(), self.view)
        shown.SetRepresentationType("PixelExact")
        with scene.messages() as heard:
            shown.PixelExactSurface = "Slice or Clip"
            rgb = scene.pixels(self.view)
        self.assertTrue(scene.is_background(rgb).all())
        self.assertIn("apply PixelExact Slice", heard[0])
        cut = simple.PixelExactSlice(Input=torus(), SliceType="Sphere", SliceOffsetValues=[0.5])
        with scene.messages() as heard:
            cut.UpdatePipeline()
        self.assertIn("Slice Offset Values move planes", heard[0])


if __name__ == "__main__":
    scene.main()
