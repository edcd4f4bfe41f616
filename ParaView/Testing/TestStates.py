"""Saved states and traces give the same pixels again; so do blocks and the grids that they hold."""

import os
import subprocess
import unittest

import numpy
from paraview import simple, smstate, smtrace

import scene


def plane():
    view = scene.view(direction=(1, 0, 0), up=(0, 0, 1))
    reader = simple.PixelExactGridReader(FileName=[scene.data("toroid_hex_g3_p6.vtu")])
    reader.UpdatePipeline()
    shown = simple.Show(reader, view)
    shown.SetRepresentationType("PixelExact")
    simple.ColorBy(shown, ("POINTS", "u"))
    simple.GetColorTransferFunction("u").RescaleTransferFunction(-0.9, 0.9)
    simple.Render(view)
    return view, shown


def picture():
    view, shown = plane()
    shown.CutFunction = "Cylinder"
    shown.CutFunction.Center = [0.2, 0.1, 0.0]
    shown.CutFunction.Axis = [0.0, 1.0, 1.0]
    shown.CutFunction.Radius = 0.8
    shown.PixelExactContours = [-0.5, 0.0, 0.5]
    shown.ElementEdges = 1
    shown.Specular = 0.3
    simple.Render(view)
    return view


class States(unittest.TestCase):
    def tearDown(self):
        simple.ResetSession()

    def check_again(self, before):
        view = simple.GetActiveView() or simple.GetRenderViews()[0]
        scene.make_plain(view)  # ParaView takes FXAA from its settings, and traces no properties
        after = scene.pixels(view)
        self.assertFalse(scene.is_background(after).all())
        self.assertTrue(numpy.array_equal(after, before))

    def test_state(self):
        before = scene.pixels(picture(), "state.png")
        name = os.path.join(scene.PICTURES, "state.pvsm")
        simple.SaveState(name)
        simple.ResetSession()
        simple.LoadState(name)
        self.check_again(before)

    def test_python_state(self):
        before = scene.pixels(picture())
        program = smstate.get_state()
        for part in "PixelExactGridReader", "'PixelExact'", "Cylinder", "PixelExactContours":
            self.assertIn(part, program)
        simple.ResetSession()
        exec(program, {})
        self.check_again(before)

    def test_trace(self):
        smtrace.start_trace()
        before = scene.pixels(plane()[0])
        program = smtrace.stop_trace()
        for part in "PixelExactGridReader(", "SetRepresentationType('PixelExact')":
            self.assertIn(part, program)
        simple.ResetSession()
        exec(program, {})
        self.check_again(before)


OURS = ("PixelExact", "CutFunction", "CutBy", "IsoArray", "IsoSurface", "IsoValue", "Contour")


class StatesOfOthers(unittest.TestCase):
    """Grids that are drawn another way: their states run where the plugin is not."""

    def tearDown(self):
        simple.ResetSession()

    def shown(self):
        view = scene.view()
        grid = simple.Tetrahedralize(simple.Wavelet(WholeExtent=[-3, 3, -3, 3, -3, 3]))
        return simple.Show(grid, view)

    def check_alone(self, program):
        """A program runs, and says nothing, where there is no plugin."""
        for name in OURS:
            self.assertNotIn(name, program)
        script = os.path.join(scene.PICTURES, "alone.py")
        with open(script, "w") as file:
            file.write(program)
        alone = {k: v for k, v in os.environ.items() if k != "PV_PLUGIN_PATH"}
        done = subprocess.run(["pvpython", script], env=alone, capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertNotIn("ERR|", done.stderr)

    def test_python_states(self):
        self.shown()
        self.check_alone(smstate.get_state())

    def test_traces(self):
        smtrace.start_trace()
        self.shown()
        self.check_alone(smtrace.stop_trace())

    def test_settings_of_before_are_left_out(self):
        shown = self.shown()
        shown.SetRepresentationType("PixelExact")
        shown.PixelExactContours = [100.0]
        shown.CutFunction.Origin = [0.5, 0.0, 0.0]
        program = smstate.get_state()
        for part in "PixelExactContours = [100.0]", "CutFunction.Origin = [0.5, 0.0, 0.0]":
            self.assertIn(part, program)
        shown.SetRepresentationType("Surface")
        self.check_alone(smstate.get_state())
        # They are still there.
        shown.SetRepresentationType("PixelExact")
        self.assertEqual(list(shown.PixelExactContours), [100.0])
        self.assertEqual(smstate.get_state(), program)


class Blocks(unittest.TestCase):
    def tearDown(self):
        simple.ResetSession()

    def show(self, source, view):
        shown = simple.Show(source, view)
        shown.SetRepresentationType("PixelExact")
        simple.ColorBy(shown, ("POINTS", "u"))
        simple.GetColorTransferFunction("u").RescaleTransferFunction(-0.9, 0.9)
        shown.SetScalarBarVisibility(view, False)
        shown.CutFunction.Origin = [0, 0, 0]
        shown.CutFunction.Normal = [0, 0, 1]
        return shown

    def test_two_halves_are_the_whole(self):
        view = scene.view()
        whole = simple.PixelExactGridReader(FileName=[scene.data("toroid_hex_g3_p6.vtu")])
        self.show(whole, view)
        before = scene.pixels(view)
        simple.Hide(whole, view)
        halves = []
        for lower, upper in (0, 20), (21, 47):
            half = simple.Threshold(whole)
            half.Scalars = ["CELLS", "PixelExactElementId"]
            half.LowerThreshold, half.UpperThreshold = lower, upper
            halves.append(half)
        group = simple.GroupDatasets(Input=halves)
        shown = self.show(group, view)
        self.assertTrue(numpy.array_equal(scene.pixels(view, "blocks.png"), before))
        with scene.messages() as heard:
            shown.BlockSelectors = ["/Root/Block0"]
            scene.pixels(view)
        self.assertIn("Extract Block", heard[0])

    def test_plain_blocks_are_converted(self):
        view = scene.view()
        plain = simple.XMLUnstructuredGridReader(FileName=[scene.data("toroid_hex_g3_p6.vtu")])
        self.show(plain, view)
        before = scene.pixels(view)
        simple.Hide(plain, view)
        self.show(simple.GroupDatasets(Input=[plain]), view)
        self.assertTrue(numpy.array_equal(scene.pixels(view), before))


if __name__ == "__main__":
    scene.main()
