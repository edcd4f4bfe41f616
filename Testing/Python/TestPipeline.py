"""Reader, converter, mapper, actor, window: the pipeline of any VTK script."""

import os
import tempfile
import unittest

import numpy
import vtkmodules.vtkInteractionStyle  # noqa: F401
import vtkmodules.vtkRenderingFreeType  # noqa: F401
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkDataObject, vtkPlane, vtkPolyData
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader
from vtkmodules.vtkRenderingAnnotation import vtkScalarBarActor
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkRenderer,
    vtkRenderWindow,
    vtkWindowToImageFilter,
)

from pixelexact import vtkHighOrderMapper, vtkHighOrderProbe, vtkUnstructuredGridToHighOrderGrid

DATA = os.environ["PIXELEXACT_DATA_DIR"]
SIZE = (400, 300)


class Pipeline(unittest.TestCase):
    def setUp(self):
        self.reader = vtkXMLUnstructuredGridReader()
        self.reader.SetFileName(os.path.join(DATA, "toroid_hex_g3_p6.vtu"))
        self.converter = vtkUnstructuredGridToHighOrderGrid()
        self.converter.SetInputConnection(self.reader.GetOutputPort())
        self.plane = vtkPlane()
        self.plane.SetNormal(0, 0, 1)
        self.mapper = vtkHighOrderMapper()
        self.mapper.SetInputConnection(self.converter.GetOutputPort())
        self.mapper.SetFieldName("u")
        self.mapper.SetCutFunction(self.plane)
        self.actor = vtkActor()
        self.actor.SetMapper(self.mapper)
        self.renderer = vtkRenderer()
        self.renderer.AddActor(self.actor)
        self.window = vtkRenderWindow()
        self.window.SetOffScreenRendering(True)
        self.window.SetMultiSamples(0)
        self.window.SetSize(*SIZE)
        self.window.AddRenderer(self.renderer)

    def picture(self):
        image = vtkWindowToImageFilter()
        image.SetInput(self.window)
        image.Update()
        return image.GetOutput()

    def save(self, image):
        folder = os.path.join(tempfile.gettempdir(), "pixelexact-pictures")
        os.makedirs(folder, exist_ok=True)
        writer = vtkPNGWriter()
        writer.SetFileName(os.path.join(folder, self.id() + ".png"))
        writer.SetInputData(image)
        writer.Write()

    def buffer(self, name):
        return vtk_to_numpy(self.mapper.GetBuffers().GetPointData().GetArray(name))

    def test_every_pixel_is_the_field(self):
        self.mapper.SetScalarRange(-0.5, 0.5)
        bar = vtkScalarBarActor()
        bar.SetLookupTable(self.mapper.GetLookupTable())
        self.renderer.AddActor(bar)
        self.window.Render()
        self.save(self.picture())

        self.assertEqual(self.mapper.GetBuffers().GetDimensions(), (*SIZE, 1))
        verdict = self.buffer("Verdict")
        self.assertGreater(numpy.count_nonzero(verdict == 1), 15000)
        self.assertEqual(numpy.count_nonzero(verdict == 2), 0)

        # The same points, asked for by the probe, which takes another way through the elements.
        probe = vtkHighOrderProbe()
        inside = verdict == 1
        points = vtkPoints()
        points.SetDataTypeToDouble()
        points.SetData(numpy_to_vtk(numpy.ascontiguousarray(self.buffer("Position")[inside]), 1))
        cloud = vtkPolyData()
        cloud.SetPoints(points)
        probe.SetInputData(cloud)
        probe.SetSourceConnection(self.converter.GetOutputPort())
        probe.Update()
        probed = vtk_to_numpy(probe.GetOutput().GetPointData().GetArray("u"))
        numpy.testing.assert_allclose(self.buffer("Value")[inside], probed, rtol=0, atol=1e-12)

    def test_a_changed_source_is_drawn_again(self):
        self.window.Render()
        self.window.Render()
        self.assertEqual(self.mapper.GetNumberOfTraces(), 1)
        self.reader.SetFileName(os.path.join(DATA, "fichera_hex_g3_p4.vtu"))
        self.renderer.ResetCamera()
        self.window.Render()
        self.assertEqual(self.mapper.GetNumberOfModelBuilds(), 2)
        self.assertEqual(self.mapper.GetNumberOfTraces(), 2)
        self.assertGreater(numpy.count_nonzero(self.buffer("Verdict") == 1), 5000)
        self.save(self.picture())

    def test_windows_are_deleted_before_their_renderers(self):
        pictures = []
        for _ in range(3):
            self.window.Render()
            pixels = self.picture().GetPointData().GetScalars()
            pictures.append(vtk_to_numpy(pixels).copy())
            self.window = vtkRenderWindow()
            self.window.SetOffScreenRendering(True)
            self.window.SetMultiSamples(0)
            self.window.SetSize(*SIZE)
            self.window.AddRenderer(self.renderer)
        self.assertGreater(numpy.count_nonzero(pictures[0]), 15000)
        for other in pictures[1:]:
            numpy.testing.assert_array_equal(other, pictures[0])

    def test_producers_may_release_their_data(self):
        self.window.Render()
        expected = self.buffer("Value").copy()
        self.reader.ReleaseDataFlagOn()
        self.converter.ReleaseDataFlagOn()
        self.converter.Modified()
        self.window.Render()
        self.assertEqual(self.mapper.GetNumberOfModelBuilds(), 2)
        numpy.testing.assert_array_equal(self.buffer("Value"), expected)
        self.assertLess(self.mapper.GetBounds()[0], self.mapper.GetBounds()[1])
        # As with stock mappers of polygons, it is not read again for each frame.
        self.plane.SetOrigin(0, 0, 0.1)
        self.window.Render()
        self.assertEqual(self.mapper.GetNumberOfModelBuilds(), 2)
        self.assertTrue(self.converter.GetReleaseDataFlag())

    def test_all_producers_may_release_their_data(self):
        vtkDataObject.SetGlobalReleaseDataFlag(1)
        try:
            self.window.Render()
            self.assertGreater(numpy.count_nonzero(self.buffer("Verdict") == 1), 15000)
            self.assertEqual(vtkDataObject.GetGlobalReleaseDataFlag(), 1)
        finally:
            vtkDataObject.SetGlobalReleaseDataFlag(0)

    def test_missing_arrays_are_an_error_that_names_the_remedy(self):
        messages = []

        def listen(caller, event, text=None):
            messages.append(text)

        listen.CallDataType = "string0"
        self.mapper.AddObserver("ErrorEvent", listen)
        self.mapper.SetInputConnection(self.reader.GetOutputPort())
        self.window.Render()
        self.assertIn("vtkUnstructuredGridToHighOrderGrid", "".join(messages))
        self.assertIsNone(self.mapper.GetBuffers())


if __name__ == "__main__":
    unittest.main()
