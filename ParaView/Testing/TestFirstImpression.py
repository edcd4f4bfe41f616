"""What a reader shows without any choice: exact pixels, coloured over the field's own range."""

import json
import os
import shutil
import subprocess
import unittest

import numpy
from paraview import simple

import pictures
import scene


# In ParaView's own window.
CLIENT = """
import json, os, traceback
from paraview.simple import *
try:
    display = Show(PixelExactGridReader(FileName=[{file!r}]))
    view = GetActiveView()
    ResetCamera(view)
    SaveScreenshot({picture!r}, view, ImageResolution=[320, 240])
    found = dict(type=display.SMProxy.GetProperty("Representation").GetElement(0), normal=[float(x) for x in display.CutFunction.Normal])
    with open({numbers!r}, "w") as out:
        json.dump(found, out)
except Exception:
    traceback.print_exc()
os._exit(0)
"""


def toroid():
    return simple.PixelExactGridReader(FileName=[scene.data("toroid_hex_g3_p6.vtu")])


def nektar():
    name = "nek_tet_varp"
    return simple.PixelExactNektarReader(FileName=[scene.data(f"{name}/{name}.xml")])


def mfem():
    name = "mfem_escher_tet_darcy_p3"
    return simple.PixelExactMFEMReader(FileName=scene.data(f"{name}/{name}.mesh"))


class FirstImpression(unittest.TestCase):
    def setUp(self):
        self.view = scene.view(direction=(-0.8, 0, -0.6))

    def tearDown(self):
        simple.ResetSession()

    def shown(self, make):
        """Shows a source as it comes; returns its display and RGB. There is no message."""
        with scene.messages() as heard:
            source = make()
            display = simple.Show(source, self.view)
            display.SetScalarBarVisibility(self.view, False)
            simple.ResetCamera(self.view)
            rgb = scene.pixels(self.view, f"first_{make.__name__}.png")
        self.assertEqual(heard, [""])
        return source, display, rgb

    def test_readers(self):
        for make in toroid, nektar, mfem:
            with self.subTest(make.__name__):
                source, display, rgb = self.shown(make)
                self.assertEqual(display.Representation, "PixelExact")
                self.assertGreater((~scene.is_background(rgb)).sum(), 1000)
                self.check_range(source, display)
                # Fields of one name share a colour map, which keeps the larger range.
                self.tearDown()
                self.setUp()

    def check_range(self, source, display):
        """The colour map spans the field's values, which samples attain, and little more."""
        association, name = display.ColorArrayName
        self.assertEqual(association, "POINTS")
        points = simple.GetColorTransferFunction(name).RGBPoints
        lower, upper = points[0], points[-4]
        box = source.GetDataInformation().GetBounds()
        random = numpy.random.default_rng(7)
        places = random.uniform(box[::2], box[1::2], (20000, 3))
        found = scene.probe(source, places)
        values = found[name][found["Verdict"] == 1]
        if values.ndim == 2:
            values = numpy.linalg.norm(values, axis=1)
        self.assertGreater(len(values), 1000)
        self.assertLessEqual(lower, values.min())
        self.assertGreaterEqual(upper, values.max())
        # Vectors are largest at a corner, where no random point is near.
        slack = (0.15 if found[name].ndim == 1 else 1.5) * (values.max() - values.min())
        self.assertGreater(lower, values.min() - slack)
        self.assertLess(upper, values.max() + slack)

    def test_rescale_to_data_range(self):
        source, display, _ = self.shown(toroid)
        table = simple.GetColorTransferFunction("u")
        table.RescaleTransferFunction(-7.0, 7.0)
        display.RescaleTransferFunctionToDataRange(False, True)
        simple.Render(self.view)
        display.UpdatePropertyInformation()
        ends = [table.RGBPoints[0], table.RGBPoints[-4]]
        numpy.testing.assert_allclose(ends, list(display.GetProperty("FieldRange")), rtol=1e-14)
        numpy.testing.assert_allclose(ends, list(source.PointData["u"].GetRange()), rtol=1e-14)
        # The maximum of |u| lies between the cells' points.
        self.assertAlmostEqual(ends[0], -0.884489, delta=2e-3)

    def test_vectors(self):
        """Ranges of magnitude and of components."""
        source, display, _ = self.shown(mfem)
        random = numpy.random.default_rng(11)
        box = source.GetDataInformation().GetBounds()
        found = scene.probe(source, random.uniform(box[::2], box[1::2], (20000, 3)))
        flux = found["flux"][found["Verdict"] == 1]
        array = source.PointData["flux"]
        for component, values in [(-1, numpy.linalg.norm(flux, axis=1))] + list(enumerate(flux.T)):
            lower, upper = array.GetRange(component)
            self.assertLessEqual(lower, values.min())
            self.assertGreaterEqual(upper, values.max())
            self.assertLess(upper - lower, 4.0 * (values.max() - values.min()))

    @unittest.skipIf(shutil.which("paraview") is None, "there is no window's ParaView")
    def test_window(self):
        """The first plane faces the camera, which would see ParaView's default plane edge-on."""
        names = {
            key: os.path.join(scene.PICTURES, "first_window" + end)
            for key, end in (("picture", ".png"), ("numbers", ".json"), ("script", ".py"))
        }
        with open(names["script"], "w") as file:
            file.write(CLIENT.format(file=scene.data("toroid_hex_g3_p6.vtu"), **names))
        done = subprocess.run(
            ["paraview", "--dr", "--script=" + names["script"]],
            capture_output=True,
            text=True,
            timeout=120,
        )
        self.assertEqual(done.returncode, 0, done.stderr)
        for word in "PixelExact", "Error":
            self.assertNotIn(word, done.stdout + done.stderr)
        with open(names["numbers"]) as file:
            found = json.load(file)
        self.assertEqual(found, {"type": "PixelExact", "normal": [0, 0, 1]})
        colors = pictures.read(names["picture"])[:, :3].astype(int)
        # Red and blue values, which a gray background lacks.
        self.assertGreater((colors[:, 0] - colors[:, 2] > 100).sum(), 300)
        self.assertGreater((colors[:, 2] - colors[:, 0] > 100).sum(), 300)

    def test_filters(self):
        """Ours that return a mesh are shown as it was; ParaView's are shown as ParaView shows them."""
        reader = toroid()
        for filtered in (
            simple.PixelExactConvert(Input=reader),
            simple.PixelExactTruncate(Input=reader, Order=3),
            simple.PixelExactCalculator(Input=reader, Function="2*u"),
            simple.PixelExactSlice(Input=reader),
            simple.PixelExactClip(Input=reader),
        ):
            self.assertEqual(simple.Show(filtered, self.view).Representation, "PixelExact")
        self.assertEqual(simple.Show(simple.Shrink(Input=reader), self.view).Representation, "Surface")


if __name__ == "__main__":
    scene.main()
