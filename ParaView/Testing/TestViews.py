"""The views of Testing/Contract that ParaView can show have the tool's pixels."""

import json
import os
import subprocess
import sys
import tempfile
import unittest

import numpy
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLImageDataReader

import scene

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../Testing/Contract"))

import views  # noqa: E402
import options  # noqa: E402

# ParaView's colour maps are its own; black to white is the same in both. Its lights, too.
LIMITS = [-0.5, 0.75]
KINDS = {"plane": "Plane", "sphere": "Sphere", "box": "Box", "quadric": "Quadric", "isosurface": None, "boundary": None}
KEPT = {"case", "field", "size", "layers", "camera", "contours", "contour_width", "contour_color", "edges",
        "edge_color", "edges_by_kind", "samples"}
TABLE_SIZE = 1024


def shown_by_both():
    """Of one opaque layer, without what ParaView's panel has not."""
    for view in views.views():
        layer = view["layers"][0]
        if len(view["layers"]) == 1 and set(layer) == {"surface"} and layer["surface"][0] in KINDS:
            kept = {key: value for key, value in view.items() if key in KEPT}
            yield kept | {"colormap": "grayscale", "range": LIMITS, "lights": "off"}


def by_tool(view):
    """Buffers and the camera."""
    with tempfile.TemporaryDirectory() as folder:
        buffers = os.path.join(folder, "b.vti")
        command = [scene.TOOL, "render", scene.data(view["case"] + ".vtu"), *options.options_of(view), "--json",
                   "--buffers", buffers, "--output", os.path.join(folder, "i.png")]
        own = {k: v for k, v in os.environ.items() if k not in ("LD_LIBRARY_PATH", "PYTHONPATH")}
        done = subprocess.run(command, check=True, capture_output=True, text=True, env=own)
        reader = vtkXMLImageDataReader()
        reader.SetFileName(buffers)
        reader.Update()
        points = reader.GetOutput().GetPointData()
        arrays = {name: vtk_to_numpy(points.GetArray(name)).copy() for name in ("Color", "Verdict")}
        return arrays, json.loads(done.stdout)["camera"]


def set_surface(shown, layer):
    kind, *numbers = layer["surface"]
    if kind == "boundary":
        shown.PixelExactSurface = "Boundary"
    elif kind == "isosurface":
        shown.PixelExactSurface = "Iso-Surface"
        shown.IsoArray = ["POINTS", numbers[0]]
        shown.IsoValue = numbers[1]
    else:
        shown.CutFunction = KINDS[kind]
        cut = shown.CutFunction
        if kind == "plane":
            cut.Origin, cut.Normal = numbers[:3], numbers[3:]
        elif kind == "sphere":
            cut.Center, cut.Radius = numbers[:3], numbers[3]
        elif kind == "box":
            cut.Position = numbers[:3]
            cut.Length = [upper - lower for lower, upper in zip(numbers[:3], numbers[3:])]
        else:
            cut.QuadricCoefficients = numbers


def set_appearance(shown, view):
    contours = view.get("contours", [])
    if isinstance(contours, list):
        shown.PixelExactContours = contours
    else:
        shown.ContourCount = contours
    shown.ContourWidth = view.get("contour_width", 1.5)
    if view.get("contour_color") == "map":
        shown.ContourColorsByValue = 1
    else:
        shown.ContourColor = view.get("contour_color", [0, 0, 0])
    shown.ElementEdges = int("edges" in view)
    shown.EdgesByKind = int(view.get("edges_by_kind", False))
    shown.LineWidth = view.get("edges", 1.5)
    shown.EdgeColor = view.get("edge_color", [0.4, 0.4, 0.4])
    shown.PixelExactSamples = view.get("samples", 1)
    shown.Ambient, shown.Diffuse = 1.0, 0.0


def set_camera(render_view, camera):
    render_view.CameraPosition = camera["position"]
    render_view.CameraFocalPoint = camera["focal_point"]
    render_view.CameraViewUp = camera["view_up"]
    render_view.CameraParallelProjection = int("parallel_scale" in camera)
    if "parallel_scale" in camera:
        render_view.CameraParallelScale = camera["parallel_scale"]
    else:
        render_view.CameraViewAngle = camera["view_angle"]


@unittest.skipUnless(os.path.exists(scene.TOOL), "there is no command-line tool to compare with")
class Views(unittest.TestCase):
    def tearDown(self):
        simple.ResetSession()

    def check(self, view):
        wanted, camera = by_tool(view)
        render_view = scene.view()
        render_view.ViewSize = view["size"]
        source = simple.PixelExactGridReader(FileName=[scene.data(view["case"] + ".vtu")])
        shown = simple.Show(source, render_view)
        shown.SetRepresentationType("PixelExact")
        simple.ColorBy(shown, ("POINTS", view["field"]))
        shown.SetScalarBarVisibility(render_view, False)
        colors = simple.GetColorTransferFunction(view["field"])
        colors.ColorSpace = "RGB"
        colors.RGBPoints = [LIMITS[0], 0, 0, 0, LIMITS[1], 1, 1, 1]
        colors.NumberOfTableValues = TABLE_SIZE
        set_surface(shown, view["layers"][0])
        set_appearance(shown, view)
        # The first render of a session places the camera.
        simple.Render(render_view)
        set_camera(render_view, camera)
        rgb = scene.pixels(render_view).reshape(-1, 3).astype(int)
        exact = (wanted["Verdict"] == 1) & (wanted["Color"][:, 3] == 255)
        off = numpy.abs(rgb[exact] - wanted["Color"][exact, :3]).max(axis=1)
        self.assertGreater(exact.sum(), 50)
        self.assertLessEqual(off.max(), 2, f"{(off > 2).sum()} of {exact.sum()} pixels")

    def test_views(self):
        count = 0
        for number, view in enumerate(shown_by_both()):
            with self.subTest(number=number, view=view):
                self.check(view)
            simple.ResetSession()
            count += 1
        self.assertGreater(count, 12)


if __name__ == "__main__":
    scene.main()
