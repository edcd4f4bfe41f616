"""Tori, surfaces of files, and what is written over the picture."""

import os
import re
import tempfile
import unittest

import numpy
from paraview import simple
from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkPoints
from vtkmodules.vtkCommonDataModel import (
    VTK_HEXAHEDRON,
    VTK_QUAD,
    vtkCellArray,
    vtkPolyData,
    vtkUnstructuredGrid,
)
from vtkmodules.vtkIOGeometry import vtkSTLWriter
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

import scene

HEIGHT = 0.1


def square(triangles):
    """The plane z = HEIGHT about the mesh: two triangles, or a bicubic patch of 16 points."""
    points, cells = vtkPoints(), vtkCellArray()
    points.SetDataTypeToDouble()
    side = 2 if triangles else 4
    for i in range(side):
        for j in range(side):
            points.InsertNextPoint(6.0 * i / (side - 1) - 3.0, 6.0 * j / (side - 1) - 3.0, HEIGHT)
    data = vtkPolyData()
    data.SetPoints(points)
    if triangles:
        for corners in ((0, 2, 3), (0, 3, 1)):
            cells.InsertNextCell(3, corners)
        data.SetPolys(cells)
    return data


def write(writer, data, name):
    writer.SetFileName(name)
    writer.SetInputData(data)
    writer.Write()
    return name


class Surfaces(unittest.TestCase):
    def setUp(self):
        self.view = scene.view()
        self.grid = simple.PixelExactGridReader(FileName=[scene.data("toroid_hex_g3_p6.vtu")])
        self.shown = simple.Show(self.grid)
        self.shown.SetRepresentationType("PixelExact")
        simple.ColorBy(self.shown, ("POINTS", "u"))
        simple.GetColorTransferFunction("u").RescaleTransferFunction(-1.0, 1.0)
        self.shown.SetScalarBarVisibility(self.view, False)
        self.shown.Ambient, self.shown.Diffuse = 1.0, 0.0
        self.shown.CutFunction.Origin = [0, 0, HEIGHT]
        self.shown.CutFunction.Normal = [0, 0, 1]

    def tearDown(self):
        simple.ResetSession()

    def test_torus(self):
        radius, tube = 1.0, 0.15
        self.shown.CutFunction = "Torus"
        self.shown.CutFunction.Center = [0, 0, 0]
        self.shown.CutFunction.Axis = [0, 0, 2]
        self.shown.CutFunction.Radius = radius
        self.shown.CutFunction.TubeRadius = tube
        rgb = scene.pixels(self.view, "torus.png")
        rows, columns = numpy.mgrid[3:237:3, 3:317:3]
        places = numpy.stack([columns.ravel(), rows.ravel()], axis=1)
        points, _ = scene.rays(self.view, places)
        # Seen from above: the upper half of the tube.
        height = tube**2 - (numpy.hypot(points[:, 0], points[:, 1]) - radius) ** 2
        points, places = points[height > 0.0], places[height > 0.0]
        points[:, 2] = numpy.sqrt(height[height > 0.0])
        found = scene.probe(self.grid, points)
        hit = found["Verdict"] == 1
        self.assertGreater(hit.sum(), 100)
        shown = rgb[places[:, 1], places[:, 0]][hit].astype(int)
        self.assertLessEqual(numpy.abs(shown - scene.mapped("u", found["u"][hit])).max(), 1)

    def test_files(self):
        wanted = scene.pixels(self.view).astype(int)
        with tempfile.TemporaryDirectory() as folder:
            files = [
                write(vtkSTLWriter(), square(True), os.path.join(folder, "a.stl")),
                write(vtkXMLPolyDataWriter(), square(True), os.path.join(folder, "b.vtp")),
                write(vtkXMLPolyDataWriter(), square(False), os.path.join(folder, "c.vtp")),
            ]
            self.shown.PixelExactSurface = "File"
            for file in files:
                self.shown.SurfaceFile = file
                name = os.path.basename(file)
                off = numpy.abs(scene.pixels(self.view, f"file_{name}.png") - wanted).max(axis=-1)
                # STL keeps heights in single precision.
                self.assertLessEqual(numpy.count_nonzero(off > 1), 5, name)
        self.assertGreater(numpy.count_nonzero(~scene.is_background(wanted)), 5000)

    def test_files_that_are_none(self):
        self.shown.PixelExactSurface = "File"
        for name, word in (("", "no surface file"), ("absent.stl", "absent.stl"), (__file__, "suffix")):
            with scene.messages() as heard:
                self.shown.SurfaceFile = name
                rgb = scene.pixels(self.view)
            self.assertIn(word, heard[0])
            self.assertTrue(scene.is_background(rgb).all())

    def test_legend(self):
        before = scene.pixels(self.view).astype(int)
        with scene.messages() as heard:
            self.shown.VerdictLegend = 1
            after = scene.pixels(self.view, "verdict_legend.png").astype(int)
        self.assertEqual(heard, [""])
        changed = numpy.abs(after - before).max(axis=-1) > 0
        self.assertGreater(changed[:, :150].sum(), 300)
        self.assertFalse(changed[:180].any())
        self.assertTrue((after == [255, 0, 255]).all(axis=-1).any())
        self.shown.Visibility = 0
        self.assertTrue(scene.is_background(scene.pixels(self.view)).all())

    def test_value_under_pointer(self):
        self.view.MakeRenderWindowInteractor(True)
        simple.Render(self.view)
        before = scene.pixels(self.view).astype(int)
        self.shown.ValueUnderPointer = 1
        simple.Render(self.view)
        interactor = self.view.GetInteractor()
        found = []
        for place in ((160, 120), (230, 120), (240, 130)):
            interactor.SetEventInformation(*place)
            interactor.InvokeEvent("MouseMoveEvent")
            self.shown.UpdatePropertyInformation()
            found.append(self.shown.GetProperty("PointerText")[0].replace("\n", " "))
            self.shown.PickedPixel = place
            self.shown.UpdatePropertyInformation()
            self.compare_texts(found[-1], self.shown.GetProperty("PickedText")[0] or "")
        self.assertEqual(found[0], "")  # the hole
        self.assertIn(" in [", found[1])
        self.assertNotEqual(found[1], found[2])
        after = scene.pixels(self.view, "value_under_pointer.png").astype(int)
        changed = numpy.abs(after - before).max(axis=-1) > 0
        self.assertGreater(changed[:80].sum(), 300)
        self.assertFalse(changed[100:].any())

    def compare_texts(self, brief, whole):
        """Six digits under the pointer, with an interval that holds the proven one."""
        number = r"-?\d+\.?\d*(?:e[-+]\d+)?"
        self.assertEqual(re.sub(number, "#", brief), re.sub(number, "#", whole))
        few, all_digits = (re.findall(number, text) for text in (brief, whole))
        for short, exact in zip(few, map(float, all_digits)):
            self.assertLessEqual(len(re.sub(r"e.*|\D", "", short).lstrip("0")), 6)
            self.assertAlmostEqual(float(short), exact, delta=2e-5 * abs(exact))
        if few:
            self.assertLess(float(few[-2]), float(all_digits[-2]))
            self.assertGreater(float(few[-1]), float(all_digits[-1]))


WALL = (214, 94, 0)


def jumping_cube(function):
    """Eight cubes that share no points and fill [-1, 1]^3; `function` of a point and a cube's middle."""
    grid, points, values = vtkUnstructuredGrid(), vtkPoints(), vtkDoubleArray()
    points.SetDataTypeToDouble()
    values.SetName("u")
    for cube in numpy.ndindex(2, 2, 2):
        first = points.GetNumberOfPoints()
        middle = numpy.array(cube) - 0.5
        for corner in ((0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)):
            place = middle + numpy.array(corner) - 0.5
            points.InsertNextPoint(place)
            values.InsertNextValue(function(place, middle))
        grid.InsertNextCell(VTK_HEXAHEDRON, 8, range(first, first + 8))
    grid.SetPoints(points)
    grid.GetPointData().AddArray(values)
    source = simple.TrivialProducer()
    source.GetClientSideObject().SetOutput(grid)
    source.MarkModified(source.SMProxy)
    return source


class JumpWalls(unittest.TestCase):
    def setUp(self):
        self.view = scene.view(direction=numpy.array([7.0, -5.0, -3.0]) / numpy.sqrt(83.0), up=(0, 0, 1))

    def tearDown(self):
        simple.ResetSession()

    def show(self, source, value):
        shown = simple.Show(source)
        shown.SetRepresentationType("PixelExact")
        simple.ColorBy(shown, ("POINTS", "u"))
        simple.GetColorTransferFunction("u").RescaleTransferFunction(-1.0, 2.0)
        shown.SetScalarBarVisibility(self.view, False)
        shown.Ambient, shown.Diffuse = 1.0, 0.0
        shown.PixelExactSurface = "Iso-Surface"
        shown.IsoArray = ["POINTS", "u"]
        shown.IsoValue = value
        return shown

    def test_close_the_surface(self):
        """u = y, and y + 1 at x > 0: 0.5 is at y = 0.5, at y = -0.5, and on the wall between the two."""
        shown = self.show(jumping_cube(lambda x, middle: x[1] + float(middle[0] > 0)), 0.5)
        without = scene.pixels(self.view, "jump_walls_off.png")
        shown.JumpWalls = 1
        rgb = scene.pixels(self.view, "jump_walls.png")

        rows, columns = numpy.mgrid[0:240, 0:320]
        places = numpy.stack([columns.ravel(), rows.ravel()], axis=1)
        eyes, ahead = scene.rays(self.view, places)
        nearest = numpy.full(len(places), numpy.inf)
        kind = numpy.zeros(len(places), dtype=int)
        margin = numpy.full(len(places), numpy.inf)
        for which, axis, at, low, high in (
            (1, 1, 0.5, [-1, 0.5, -1], [0, 0.5, 1]),
            (1, 1, -0.5, [0, -0.5, -1], [1, -0.5, 1]),
            (2, 0, 0.0, [0, -0.5, -1], [0, 0.5, 1]),
        ):
            t = (at - eyes[:, axis]) / ahead[axis]
            x = eyes + t[:, None] * ahead
            others = [k for k in range(3) if k != axis]
            inside = numpy.minimum(x - low, numpy.array(high) - x)[:, others].min(axis=1)
            margin = numpy.minimum(margin, numpy.abs(inside))
            nearer = (inside > 0) & (t < nearest)
            nearest[nearer], kind[nearer] = t[nearer], which
        # Rays that pass an edge by rounding may see either side.
        sure = margin > 1e-9
        colors = numpy.array([[51, 102, 153], scene.mapped("u", [0.5])[0], WALL])
        off = numpy.abs(rgb.reshape(-1, 3).astype(int) - colors[kind]).max(axis=1)
        self.assertLessEqual(off[sure].max(), 1)
        self.assertGreater(numpy.count_nonzero(sure & (kind == 2)), 2000)
        self.assertFalse((numpy.abs(without.astype(int) - WALL).max(axis=-1) <= 1).any())

    def test_where_no_element_has_the_value(self):
        """Of constants in each element nothing but a wall."""
        shown = self.show(jumping_cube(lambda x, middle: float(middle[0] > 0)), 0.5)
        with scene.messages() as heard:
            self.assertTrue(scene.is_background(scene.pixels(self.view)).all())
        self.assertIn("0.5", heard[0])
        shown.JumpWalls = 1
        shown.JumpWallColor = [0.0, 1.0, 0.0]
        rgb = scene.pixels(self.view)
        green = numpy.abs(rgb.astype(int) - [0, 255, 0]).max(axis=-1) <= 1
        self.assertGreater(green.sum(), 2000)
        self.assertTrue((green | scene.is_background(rgb)).all())
        shown.PixelExactSurface = "Boundary"
        rgb = scene.pixels(self.view)
        self.assertFalse((numpy.abs(rgb.astype(int) - [0, 255, 0]).max(axis=-1) <= 1).any())

    def test_of_a_solution(self):
        """Of a discontinuous Galerkin solution some, of a continuous one none."""
        for file, least in (("periodic_hex_dg_g3_p4.vtu", 20), ("toroid_hex_g3_p6.vtu", 0)):
            shown = self.show(simple.PixelExactGridReader(FileName=[scene.data(file)]), 0.3)
            simple.ResetCamera(self.view)
            without = scene.pixels(self.view)
            shown.JumpWalls = 1
            rgb = scene.pixels(self.view, f"jump_walls_{file}.png")
            wall = numpy.abs(rgb.astype(int) - WALL).max(axis=-1) <= 1
            if least == 0:
                self.assertTrue((rgb == without).all())
            self.assertGreaterEqual(wall.sum(), least)
            simple.Hide()


class SurfacesInSpace(unittest.TestCase):
    def test_are_shown_where_a_cut_would_be(self):
        """One bilinear quadrilateral, z = x y, with the field u = x, seen along z."""
        grid, points, field = vtkUnstructuredGrid(), vtkPoints(), vtkDoubleArray()
        points.SetDataTypeToDouble()
        field.SetName("u")
        for x, y in ((0, 0), (1, 0), (1, 1), (0, 1)):
            points.InsertNextPoint(x, y, x * y)
            field.InsertNextValue(x)
        grid.SetPoints(points)
        grid.InsertNextCell(VTK_QUAD, 4, [0, 1, 2, 3])
        grid.GetPointData().AddArray(field)
        view = scene.view()
        source = simple.TrivialProducer()
        source.GetClientSideObject().SetOutput(grid)
        source.MarkModified(source.SMProxy)
        shown = simple.Show(source)
        shown.SetRepresentationType("PixelExact")
        simple.ColorBy(shown, ("POINTS", "u"))
        simple.GetColorTransferFunction("u").RescaleTransferFunction(0.0, 1.0)
        shown.SetScalarBarVisibility(view, False)
        shown.Ambient, shown.Diffuse = 1.0, 0.0
        simple.ResetCamera(view)
        rgb = scene.pixels(view, "surface_in_space.png")
        places = numpy.argwhere(~scene.is_background(rgb))[:, ::-1]
        self.assertGreater(len(places), 5000)
        eyes, ahead = scene.rays(view, places)
        self.assertEqual(numpy.abs(ahead).tolist(), [0.0, 0.0, 1.0])
        x = eyes[:, 0]
        self.assertLess(numpy.abs(x - 0.5).max(), 0.5 + 1e-9)
        colors = scene.mapped("u", x)
        self.assertLessEqual(numpy.abs(rgb[places[:, 1], places[:, 0]].astype(int) - colors).max(), 1)
        simple.ResetSession()


if __name__ == "__main__":
    scene.main()
