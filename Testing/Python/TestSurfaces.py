# SPDX-License-Identifier: BSD-3-Clause
"""Cut-surfaces that are no implicit functions, from Python."""

import os
import tempfile
import unittest

import numpy as np
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401
from vtkmodules.util.misc import calldata_type
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.util.vtkConstants import VTK_STRING
from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkPoints
from vtkmodules.vtkCommonDataModel import VTK_QUAD, VTK_TETRA, vtkPlane, vtkUnstructuredGrid
from vtkmodules.vtkFiltersSources import vtkPlaneSource
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader, vtkXMLUnstructuredGridWriter
from vtkmodules.vtkRenderingCore import vtkActor, vtkRenderer, vtkRenderWindow

import pixelexact

DATA = os.environ["PIXELEXACT_DATA_DIR"]


class Scene:
    """An actor of a case of Data, a torus, in an off-screen window."""

    def __init__(self, case="toroid_hex_g3_p6"):
        self.errors = []
        self.reader = vtkXMLUnstructuredGridReader()
        self.reader.SetFileName(os.path.join(DATA, case + ".vtu"))
        self.converter = pixelexact.vtkUnstructuredGridToHighOrderGrid()
        self.converter.SetInputConnection(self.reader.GetOutputPort())
        self.mapper = pixelexact.vtkHighOrderMapper()
        self.mapper.SetInputConnection(self.converter.GetOutputPort())

        @calldata_type(VTK_STRING)
        def failed(_object, _event, text):
            self.errors.append(text)

        self.mapper.AddObserver("ErrorEvent", failed)
        self.actor = vtkActor()
        self.actor.SetMapper(self.mapper)
        self.renderer = vtkRenderer()
        self.renderer.AddActor(self.actor)
        self.window = vtkRenderWindow()
        self.window.SetOffScreenRendering(1)
        self.window.SetSize(60, 50)
        self.window.AddRenderer(self.renderer)

    def buffer(self, name):
        self.window.Render()
        return vtk_to_numpy(self.mapper.GetBuffers().GetPointData().GetArray(name)).copy()


class Surfaces(unittest.TestCase):
    def test_triangles_of_a_plane_are_the_plane(self):
        scene = Scene()
        scene.mapper.SetCutFunction(vtkPlane())
        plane = scene.buffer("Value")
        source = vtkPlaneSource()
        source.SetOrigin(-3, -3, 0)
        source.SetPoint1(3, -3, 0)
        source.SetPoint2(-3, 3, 0)
        source.SetOutputPointsPrecision(1)
        surface = pixelexact.vtkHighOrderTriangleSurface()
        surface.SetInputConnection(source.GetOutputPort())
        scene.mapper.SetSurface(surface)
        self.assertIs(scene.mapper.GetSurface(), surface)
        self.assertEqual(scene.mapper.GetNumberOfCutFunctions(), 0)
        triangles = scene.buffer("Value")
        self.assertGreater(np.isfinite(plane).sum(), 200)
        np.testing.assert_allclose(triangles, plane, rtol=0, atol=1e-12)
        self.assertEqual(scene.mapper.GetNumberOfSurfaceBuilds(), 2)
        # As a layer, after the pipeline has changed.
        source.SetResolution(4, 3)
        layer = pixelexact.vtkHighOrderLayer()
        layer.SetSurface(surface)
        scene.mapper.SetSurface(None)
        scene.mapper.AddLayer(layer)
        np.testing.assert_allclose(scene.buffer("Value"), plane, rtol=0, atol=1e-12)
        self.assertEqual(scene.mapper.GetNumberOfSurfaceBuilds(), 3)
        self.assertEqual(scene.errors, [])

    def test_walls_are_where_a_field_jumps(self):
        walls = pixelexact.vtkHighOrderJumpWalls()
        walls.SetFieldName("u")
        walls.SetValue(0.3)
        # A discontinuous solution on a cube of 27 bent elements, and a continuous one.
        for case, least in [("periodic_hex_dg_g3_p4", 5), ("toroid_hex_g3_p6", 0)]:
            scene = Scene(case)
            scene.window.SetSize(200, 160)
            scene.mapper.SetSurface(walls)
            exact = scene.buffer("Verdict") == 1
            self.assertEqual(scene.errors, [])
            if least == 0:
                self.assertEqual(exact.sum(), 0)
                continue
            self.assertGreater(exact.sum(), least)
            # The hits are on a face of their element, up to rounding.
            xi = scene.buffer("Xi")[exact]
            self.assertLess(np.abs(np.abs(xi).max(axis=1) - 1).max(), 1e-14)

    def test_faces_between_elements(self):
        grid = pixelexact.read(os.path.join(DATA, "periodic_hex_dg_g3_p4.vtu"))
        faces = pixelexact.vtkHighOrderBoundarySurface()
        self.assertFalse(faces.GetInnerFaces())
        faces.InnerFacesOn()
        picture = pixelexact.render(grid, "jump(u)", surface=faces, size=(60, 50), view="iso")
        exact = picture.verdicts == 1
        self.assertGreater(exact.sum(), 500)
        # All points lie on faces of elements, and have an element on the other side.
        self.assertTrue(np.isfinite(picture.values[exact]).all())
        xi = np.abs(picture.xi[exact])
        self.assertTrue((xi.max(axis=1) >= 1.0 - 1e-9).all())
        faces.InnerFacesOff()
        boundary = pixelexact.render(grid, "jump(u)", surface=faces, size=(60, 50), view="iso")
        self.assertTrue(np.isnan(boundary.values[boundary.verdicts == 1]).all())

    def test_surfaces_that_cannot_be_drawn_say_why(self):
        iso = pixelexact.vtkHighOrderIsoSurface()
        iso.SetFieldName("u")
        iso.SetValue(1e6)
        boundary = pixelexact.vtkHighOrderBoundarySurface()
        boundary.AddElement(-5)
        patches = pixelexact.vtkHighOrderPatchSurface()
        for surface, told in [
            (iso, "1e+06 is none of them"),
            (boundary, "no element -5"),
            (patches, "vtkHighOrderPatchSurface: it has no input"),
        ]:
            scene = Scene()
            scene.mapper.SetSurface(surface)
            scene.window.Render()
            self.assertIsNone(scene.mapper.GetBuffers())
            self.assertEqual(len(scene.errors), 1)
            self.assertIn(told, scene.errors[0])


class SurfacesInSpace(unittest.TestCase):
    """One bilinear quadrilateral, z = x y, with the field u = x."""

    def setUp(self):
        grid = vtkUnstructuredGrid()
        points = vtkPoints()
        points.SetDataTypeToDouble()
        field = vtkDoubleArray()
        field.SetName("u")
        for x, y in ((0, 0), (1, 0), (1, 1), (0, 1)):
            points.InsertNextPoint(x, y, x * y)
            field.InsertNextValue(x)
        grid.SetPoints(points)
        grid.InsertNextCell(VTK_QUAD, 4, [0, 1, 2, 3])
        grid.GetPointData().AddArray(field)
        self.grid = grid

    def test_are_drawn_without_a_surface(self):
        picture = pixelexact.render(self.grid, "u", size=(60, 60), view="z")
        hit = picture.array("Verdict") == 1
        self.assertGreater(np.count_nonzero(hit), 1000)
        x, y, z = picture.array("Position")[hit].T
        np.testing.assert_allclose(z, x * y, atol=1e-15)
        np.testing.assert_allclose(picture.array("Value")[hit], x, atol=1e-15)

    def test_refuse_planes(self):
        with self.assertRaisesRegex(pixelexact.Error, "surface in space"):
            pixelexact.render(self.grid, "u", size=(20, 20), surface=vtkPlane())

    def test_are_named(self):
        converter = pixelexact.vtkUnstructuredGridToHighOrderGrid()
        converter.SetInputData(self.grid)
        converter.Update()
        self.assertTrue(pixelexact.vtkHighOrderGrid.IsSurfaceInSpace(converter.GetOutput()))
        self.assertFalse(pixelexact.vtkHighOrderGrid.IsSurfaceInSpace(self.grid))

    def test_are_chosen_beside_solids(self):
        for x, y, z in ((3, 0, 0), (4, 0, 0), (3, 1, 0), (3, 0, 1)):
            self.grid.GetPoints().InsertNextPoint(x, y, z)
            self.grid.GetPointData().GetArray("u").InsertNextValue(x)
        self.grid.InsertNextCell(VTK_TETRA, 4, [4, 5, 6, 7])
        with tempfile.TemporaryDirectory() as folder:
            file = os.path.join(folder, "mixed.vtu")
            writer = vtkXMLUnstructuredGridWriter()
            writer.SetFileName(file)
            writer.SetInputData(self.grid)
            writer.Write()
            chosen = pixelexact.read(file, surface_elements=True)
            with self.assertWarnsRegex(RuntimeWarning, "1 surface element.*SetSurfaceElements"):
                solids = pixelexact.read(file)
            with self.assertRaisesRegex(pixelexact.Error, "no triangles and no quadrilaterals"):
                pixelexact.read(os.path.join(DATA, "toroid_hex_g3_p6.vtu"), surface_elements=True)
        self.assertTrue(pixelexact.vtkHighOrderGrid.IsSurfaceInSpace(chosen))
        self.assertFalse(pixelexact.vtkHighOrderGrid.IsSurfaceInSpace(solids))
        found = pixelexact.probe(chosen, "u", [[0.25, 0.5, 0.125], [3.1, 0.1, 0.1]])
        np.testing.assert_allclose(found.values[0], 0.25, atol=1e-15)
        self.assertEqual(list(found.verdicts), [1, 0])


if __name__ == "__main__":
    unittest.main()
