"""What Export Scene and Save Data write: triangles and lines, or a message that names their filters."""

import json
import os
import unittest

import numpy
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader, vtkXMLUnstructuredGridReader

import pictures
import scene

HEIGHT = 0.125  # exact in single precision, in which glTF has points


def saved(name):
    return os.path.join(scene.PICTURES, "export_" + name)


def read(name):
    reader = vtkXMLPolyDataReader() if name.endswith(".vtp") else vtkXMLUnstructuredGridReader()
    reader.SetFileName(saved(name))
    reader.Update()
    return reader.GetOutput()


def points_of(data):
    return vtk_to_numpy(data.GetPoints().GetData()).astype(float)


class Export(unittest.TestCase):
    def setUp(self):
        self.view = scene.view(scale=1.6)
        self.source = simple.PixelExactGridReader(FileName=[scene.data("toroid_hex_g3_p6.vtu")])
        self.cut = simple.PixelExactSlice(Input=self.source)
        self.cut.SliceType.Origin, self.cut.SliceType.Normal = [0, 0, HEIGHT], [0, 0, 1]

    def tearDown(self):
        simple.ResetSession()

    def test_scene_of_pixels(self):
        """Formats of geometry get nothing of the picture, which a message says."""
        simple.Show(self.cut, self.view)
        scene.pixels(self.view, "export_slice.png")
        for suffix in "gltf", "x3d", "vtp", "vrml", "pov":
            with self.subTest(suffix), scene.messages() as heard:
                simple.ExportView(saved("pixels." + suffix), view=self.view)
            for part in "no polygons", "PixelExact Linear Cut", "PixelExact Contour":
                self.assertIn(part, heard[0], suffix)
            self.assertNotIn("Picker", heard[0])

    def test_pdf(self):
        """A PDF has the picture as an image."""
        shown = simple.Show(self.cut, self.view)
        simple.ExportView(saved("pixels.pdf"), view=self.view)
        whole = os.path.getsize(saved("pixels.pdf"))
        with open(saved("pixels.pdf"), "rb") as file:
            self.assertIn(b"/Image", file.read())
        shown.Visibility = 0
        self.assertGreater(whole, 3 * scene.SIZE[0] * scene.SIZE[1] / 2)

    def test_scene_of_triangles(self):
        """Linear Cut of the slice in its place: the same points in all formats."""
        triangles = simple.PixelExactLinearCut(Input=self.cut, Resolution=40)
        shown = simple.Show(triangles, self.view)
        simple.ColorBy(shown, ("POINTS", "u"))
        rgb = scene.pixels(self.view, "export_triangles.png")
        self.assertGreater((~scene.is_background(rgb)).sum(), 5000)
        count = triangles.GetDataInformation().GetNumberOfPoints()
        with scene.messages() as heard:
            for suffix in "gltf", "x3d", "vtp":
                simple.ExportView(saved("triangles." + suffix), view=self.view)
        self.assertEqual(heard, [""])
        with open(saved("triangles.gltf")) as file:
            accessors = json.load(file)["accessors"]
        points = [a for a in accessors if a["type"] == "VEC3" and a.get("min", [0] * 3)[2] == HEIGHT]
        self.assertEqual([(a["count"], a["max"][2]) for a in points], [(count, HEIGHT)])
        exported = read("triangles.vtp")
        self.assertEqual(exported.GetNumberOfPoints(), count)
        self.assertTrue((points_of(exported)[:, 2] == HEIGHT).all())
        with open(saved("triangles.x3d")) as file:
            self.assertIn("IndexedFaceSet", file.read())

    def test_enlarged_screenshots(self):
        """Lines and labels grow with ParaView's letters, and not where these do not."""
        shown = simple.Show(self.cut, self.view)
        shown.SetScalarBarVisibility(self.view, False)
        shown.ColorArrayName = [None, ""]
        shown.DiffuseColor, shown.Ambient, shown.Diffuse = [1, 1, 1], 1.0, 0.0
        for kind, values in (
            ("edges", {"ElementEdges": 1, "EdgeColor": [0, 0, 0], "LineWidth": 2.0}),
            ("contours", {"ElementEdges": 0, "ColorArrayName": ["POINTS", "u"],
                          "PixelExactContours": [-0.3, 0.0, 0.3], "ContourWidth": 2.0}),
            ("labels", {"ContourLabels": 1, "ContourLabelSize": 12}),
        ):
            for name, value in values.items():
                setattr(shown, name, value)
            shares = {}
            for by, scaling in ((1, "Scale fonts proportionally"), (4, "Scale fonts proportionally"),
                                (4, "Do not scale fonts")):
                name = saved(f"{kind}_{by}_{scaling.split()[0]}.png")
                simple.SaveScreenshot(name, self.view, FontScaling=scaling,
                                      ImageResolution=[by * n for n in scene.SIZE])
                shares[by, scaling] = (pictures.read(name)[:, :3] < 60).all(axis=1).mean()
            small, large, thin = shares.values()
            with self.subTest(kind):
                self.assertGreater(small, 0.005)
                self.assertAlmostEqual(large / small, 1.0, delta=0.35)
                self.assertLess(thin / small, 0.5)

    def test_data(self):
        """Saved triangles, lines and cells have the values of PixelExact Probe at their points."""
        lines = simple.PixelExactContour(Input=self.cut, ContourBy="u", ContourValues=[-0.3, 0.1])
        files = {
            "cut.vtp": simple.PixelExactLinearCut(Input=self.cut, Resolution=40),
            "lines.vtp": lines,
            "cells.vtu": simple.PixelExactSubdivide(Input=self.cut, Level=1),
            "certified.vtu": simple.PixelExactCertify(Input=self.cut, Field="u"),
        }
        for name, source in files.items():
            with self.subTest(name):
                simple.SaveData(saved(name), proxy=source)
                found = read(name)
                values = vtk_to_numpy(found.GetPointData().GetArray("u"))
                self.assertGreater(len(values), 100)
                probed = scene.probe(self.source, points_of(found))
                inside = probed["Verdict"] == 1
                # Points at the rim may lie outside by rounding.
                self.assertGreater(inside.mean(), 0.5)
                off = numpy.abs(values - probed["u"])[inside]
                self.assertLess(off.max(), 1e-4 if name == "lines.vtp" else 1e-9)
        cells = read("certified.vtu").GetCellData()
        self.assertEqual(tuple(cells.GetArray("Verdict").GetRange()), (0.0, 0.0))
        simple.SaveData(saved("cut.stl"), proxy=files["cut.vtp"])
        triangles = servermanager.Fetch(files["cut.vtp"]).GetNumberOfPolys()
        self.assertEqual(os.path.getsize(saved("cut.stl")), 84 + 50 * triangles)


if __name__ == "__main__":
    scene.main()
