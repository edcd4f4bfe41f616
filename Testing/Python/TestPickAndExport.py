"""Exact picks; whoever takes what a mapper shows for polygons gets none, and a warning."""

import os
import tempfile
import unittest

import vtkmodules.vtkRenderingFreeType  # noqa: F401
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401
from vtkmodules import vtkIOExport
from vtkmodules.util.misc import calldata_type
from vtkmodules.util.vtkConstants import VTK_STRING
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPlane, vtkPolyData
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkCellPicker,
    vtkPicker,
    vtkPointPicker,
    vtkPolyDataMapper,
    vtkRenderer,
    vtkRenderWindow,
)

import pixelexact

DATA = os.environ["PIXELEXACT_DATA_DIR"]
EXPORTERS = [
    "vtkGLTFExporter",
    "vtkIVExporter",
    "vtkJSONSceneExporter",
    "vtkOBJExporter",
    "vtkOOGLExporter",
    "vtkPOVExporter",
    "vtkRIBExporter",
    "vtkSingleVTPExporter",
    "vtkVRMLExporter",
    "vtkX3DExporter",
]
# What an exporter writes of an actor that has no polygons: its colours and matrix. The outside of
# the mesh takes 130,000 bytes and more.
MOST_OF_NOTHING = 3000


class Scene:
    """A cut through a torus and a sphere beside it, in an off-screen window."""

    def __init__(self, with_cut, with_sphere):
        self.warnings = []
        self.reader = vtkXMLUnstructuredGridReader()
        self.reader.SetFileName(os.path.join(DATA, "toroid_hex_g3_p6.vtu"))
        self.converter = pixelexact.vtkUnstructuredGridToHighOrderGrid()
        self.converter.SetInputConnection(self.reader.GetOutputPort())
        self.mapper = pixelexact.vtkHighOrderMapper()
        self.mapper.SetInputConnection(self.converter.GetOutputPort())
        self.mapper.SetCutFunction(vtkPlane())
        self.mapper.SetFieldName("u")

        @calldata_type(VTK_STRING)
        def warned(_object, _event, text):
            self.warnings.append(text)

        self.mapper.AddObserver("WarningEvent", warned)
        self.cut = vtkActor()
        self.cut.SetMapper(self.mapper)
        self.source = vtkSphereSource()
        mapper = vtkPolyDataMapper()
        mapper.SetInputConnection(self.source.GetOutputPort())
        self.sphere = vtkActor()
        self.sphere.SetMapper(mapper)
        self.renderer = vtkRenderer()
        self.window = vtkRenderWindow()
        self.window.SetOffScreenRendering(1)
        self.window.SetSize(120, 90)
        self.window.AddRenderer(self.renderer)
        if with_cut:
            self.renderer.AddActor(self.cut)
        if with_sphere:
            self.renderer.AddActor(self.sphere)
        self.window.Render()

    def export(self, name):
        """The number of bytes that an exporter writes."""
        exporter = getattr(vtkIOExport, name)()
        exporter.SetRenderWindow(self.window)
        with tempfile.TemporaryDirectory() as folder:
            file = os.path.join(folder, "scene")
            if hasattr(exporter, "SetFilePrefix"):
                exporter.SetFilePrefix(file)
            else:
                exporter.SetFileName(file)
            if hasattr(exporter, "InlineDataOn"):
                exporter.InlineDataOn()
            exporter.Write()
            return sum(
                os.path.getsize(os.path.join(at, each))
                for at, _, files in os.walk(folder)
                for each in files
            )


class Export(unittest.TestCase):
    def test_no_outside_of_the_mesh(self):
        for name in EXPORTERS:
            with self.subTest(name):
                both = Scene(True, True)
                size = both.export(name)
                self.assertEqual(len(both.warnings), 1)
                self.assertIn("vtkHighOrderPicker", both.warnings[0])
                sphere = Scene(False, True).export(name)
                self.assertGreater(size, sphere - 100)
                self.assertLess(size, sphere + MOST_OF_NOTHING)
                self.assertLess(Scene(True, False).export(name), 2 * MOST_OF_NOTHING)

    def test_warned_again_after_each_picture(self):
        scene = Scene(True, False)
        for count in range(1, 4):
            scene.export("vtkOBJExporter")
            scene.export("vtkOBJExporter")
            self.assertEqual(len(scene.warnings), count)
            scene.window.Render()


class SoftwarePickers(unittest.TestCase):
    def test_no_cells_and_points_of_the_mesh(self):
        for picker in vtkCellPicker(), vtkPointPicker():
            with self.subTest(picker.GetClassName()):
                scene = Scene(True, False)
                for x in range(0, 120, 7):
                    self.assertEqual(picker.Pick(x, 45, 0, scene.renderer), 0)
                self.assertEqual(len(scene.warnings), 1)
                self.assertIn("vtkHighOrderPicker", scene.warnings[0])

    def test_boxes(self):
        scene = Scene(True, False)
        picker = vtkPicker()
        self.assertEqual(picker.Pick(60, 45, 0, scene.renderer), 1)
        self.assertIs(picker.GetActor(), scene.cut)


class ExactPicks(unittest.TestCase):
    def test_the_value_is_the_probe_s(self):
        scene = Scene(True, True)
        picker = pixelexact.vtkHighOrderPicker()
        hits = 0
        for x in range(0, 120, 7):
            if picker.Pick(x, 45, 0, scene.renderer) == 0:
                continue
            if picker.GetActor() is not scene.cut:
                self.assertEqual(picker.GetVerdict(), 0)
                continue
            hits += 1
            points = vtkPoints()
            points.SetDataTypeToDouble()
            points.InsertNextPoint(picker.GetPickPosition())
            where = vtkPolyData()
            where.SetPoints(points)
            probe = pixelexact.vtkHighOrderProbe()
            probe.SetInputData(where)
            probe.SetSourceConnection(scene.converter.GetOutputPort())
            probe.Update()
            probed = probe.GetOutputDataObject(0).GetPointData()
            self.assertEqual(picker.GetVerdict(), 1)
            self.assertEqual(picker.GetFieldName(), "u")
            self.assertEqual(picker.GetValue(), probed.GetArray("u").GetValue(0))
            self.assertEqual(picker.GetFieldValues().GetTuple(0), (picker.GetValue(),))
            self.assertEqual(picker.GetElement(), probed.GetArray("Element").GetValue(0))
            self.assertEqual(picker.GetXi(), probed.GetArray("Xi").GetTuple(0))
            self.assertEqual(picker.GetLayer(), 0)
        self.assertGreater(hits, 2)
        self.assertEqual(scene.warnings, [])


class Input(unittest.TestCase):
    def test_the_mapper_itself_knows_its_grid(self):
        scene = Scene(True, False)
        grid = scene.converter.GetOutputDataObject(0)
        self.assertIs(scene.mapper.GetInput(), grid)
        self.assertEqual(scene.warnings, [])
        outside = scene.mapper.GetInputDataObject(0, 0)
        self.assertEqual(outside.GetNumberOfPoints(), 0)
        self.assertEqual(len(scene.warnings), 1)

    def test_other_data_redraw_the_actor(self):
        scene = Scene(True, False)
        before = scene.cut.GetRedrawMTime()
        scene.converter.GetOutputDataObject(0).Modified()
        self.assertGreater(scene.cut.GetRedrawMTime(), before)


if __name__ == "__main__":
    unittest.main()
