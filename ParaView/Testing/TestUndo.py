"""Edit > Undo and Redo in ParaView's own window: pixels are those before and after an action."""

import glob
import os
import shutil
import subprocess
import unittest

import numpy

import scene

ACTIONS = (
    ("the plane's origin", "shown.CutFunction.Origin = [0, 0, 0.1]"),
    ("the plane's normal", "shown.CutFunction.Normal = [0.2, 0.1, 1]"),
    ("values of contours", "shown.PixelExactContours = [-0.2, 0.1]"),
    ("the contours' width", "shown.ContourWidth = 4.0"),
    ("the number of contours", "shown.ContourCount = 7"),
    ("element edges", "shown.ElementEdges = 1"),
    ("the surface", "shown.PixelExactSurface = 'Boundary'"),
    ("the plane of a slice", "cut.SliceType.Origin = [0, 0, -0.2]"),
    ("the type of a slice", "cut.SliceType = 'Sphere'"),
)
# ParaView keeps ten steps. A change of opacity adds some that change nothing, as it does in the
# representation Surface.
OF_ISO_SURFACES = (
    ("the iso-surface", "shown.PixelExactSurface = 'Iso-Surface'"),
    ("a value", "shown.IsoValue = 0.3"),
    ("a negative value", "shown.IsoValue = -0.4"),
    ("the opacity", "shown.Opacity = 0.4"),
)

# Each picture that the window draws is kept; a menu's action draws after the script has ended.
CLIENT = """
import os, sys, traceback
sys.path.insert(0, {folder!r})
os.environ.update({environment!r})
try:
    import numpy
    from paraview import simple
    import scene
    reader = simple.PixelExactGridReader(FileName=[{file!r}])
    view = simple.GetActiveViewOrCreate("RenderView")
    scene.make_plain(view)
    shown = simple.Show(reader, view)
    simple.GetColorTransferFunction("u").RescaleTransferFunction(-1.0, 1.0)
    cut = simple.PixelExactSlice(Input=reader)
    cut.SliceType.Origin, cut.SliceType.Normal = [0, 0, 0.2], [1, 0, 0.3]
    displays = [shown] + ([simple.Show(cut, view)] if {slice} else [])
    for display in displays:
        simple.ColorBy(display, ("POINTS", "u"))
        display.SetScalarBarVisibility(view, False)
    view.CameraPosition, view.CameraFocalPoint = [1, 2, 5], [0, 0, 0]
    number, busy = 0, False

    def keep(*_):
        global number, busy
        if not busy:
            busy = True
            numpy.save("{frames}%03d.npy" % number, scene.pixels(view))
            number, busy = number + 1, False

    keep()
    view.SMProxy.AddObserver("EndEvent", keep)
    for action in {actions!r}:
        exec(action)
        simple.Render(view)
except Exception:
    traceback.print_exc()
"""

EVENT = '  <pqevent object="pqClientMainWindow/menubar/menu_Edit" command="activate" arguments="action{}" />'


@unittest.skipIf(shutil.which("paraview") is None, "there is no window's ParaView")
class Undo(unittest.TestCase):
    def test_undo_and_redo(self):
        self.check("undo", ACTIONS, len(ACTIONS))

    def test_iso_surfaces(self):
        self.check("undo_iso", OF_ISO_SURFACES, 12, has_slice=False)

    def check(self, name, actions, clicks, has_slice=True):
        script, events, frames = (
            os.path.join(scene.PICTURES, name + end) for end in (".py", ".xml", "_frame_")
        )
        for name in glob.glob(frames + "*.npy"):
            os.remove(name)
        with open(script, "w") as file:
            file.write(
                CLIENT.format(
                    folder=os.path.dirname(os.path.abspath(__file__)),
                    environment={k: v for k, v in os.environ.items() if k.startswith("PIXELEXACT_")},
                    file=scene.data("toroid_hex_g3_p6.vtu"),
                    frames=frames,
                    actions=[action for _, action in actions],
                    slice=has_slice,
                )
            )
        clicks = [EVENT.format(way) for way in ("EditUndo", "EditRedo") for _ in range(clicks)]
        with open(events, "w") as file:
            file.write("\n".join(['<?xml version="1.0" ?>', "<pqevents>", *clicks, "</pqevents>", ""]))
        done = subprocess.run(
            ["paraview", "--dr", "--script=" + script, "--test-script=" + events, "--exit"],
            capture_output=True,
            text=True,
            timeout=300,
        )
        self.assertEqual(done.returncode, 0, done.stderr)
        for word in "Traceback", "ERR|":
            self.assertNotIn(word, done.stdout + done.stderr)
        # Without the pictures that a window draws again unchanged.
        seen = []
        for name in sorted(glob.glob(frames + "*.npy")):
            rgb = numpy.load(name)
            if not seen or not numpy.array_equal(rgb, seen[-1]):
                seen.append(rgb)
        count = len(actions)
        self.assertEqual(len(seen), 3 * count + 1)
        for i, (what, _) in enumerate(actions):
            with self.subTest(what):
                before, after = seen[i], seen[i + 1]
                self.assertFalse(numpy.array_equal(before, after), "the action shows")
                self.assertTrue(numpy.array_equal(seen[2 * count - i], before), "undone")
                self.assertTrue(numpy.array_equal(seen[2 * count + i + 1], after), "redone")


if __name__ == "__main__":
    scene.main()
