"""A user's session, action by action. Each picture is checked by numbers; the trace repeats the last."""

import contextlib
import glob
import os
import subprocess
import unittest

import numpy
from paraview import simple, smstate, smtrace

import scene
import user_actions

AGAIN = """
import sys
sys.path.insert(0, {folder!r})
import scene, numpy
from paraview import simple
view = simple.GetActiveView() or simple.GetRenderViews()[0]
scene.make_plain(view)
numpy.save({result!r}, scene.pixels(view))
"""


class Session(user_actions.Actions, unittest.TestCase):
    """The pictures are session_NN_ACTION.png in the order of the actions."""

    is_traced = True

    def setUp(self):
        self.count = 0

    def tearDown(self):
        simple.ResetSession()

    def picture(self, action):
        self.count += 1
        # A trace would write its own pictures over these.
        with self.unrecorded(), scene.messages() as heard:
            rgb = scene.pixels(self.view, f"session_{self.count:02}_{action}.png")
        self.assertEqual(heard, [""], action)
        return rgb

    def again(self, program, name):
        """The picture that a program makes in a new process."""
        script, result = (os.path.join(scene.PICTURES, name + end) for end in (".py", ".npy"))
        with open(script, "w") as file:
            file.write(program + AGAIN.format(folder=os.path.dirname(__file__), result=result))
        done = subprocess.run(["pvbatch", script], capture_output=True, text=True)
        self.assertNotIn("ERR|", done.stderr)
        self.assertEqual(done.returncode, 0, done.stderr)
        return numpy.load(result)

    def test_actions(self):
        smtrace.start_trace()
        self.view = scene.view()
        steps = self.actions()
        action = next(steps)
        with contextlib.suppress(StopIteration):
            while True:
                action = steps.send(self.picture(action))
        self.assertGreater(self.count, 29)

        # A larger picture, and the trace, states and an animation of what is shown.
        name = os.path.join(scene.PICTURES, "session_large.png")
        simple.SaveScreenshot(name, self.view, ImageResolution=[2 * n for n in scene.SIZE])
        large = simple.PNGSeriesReader(FileNames=[name])
        large.UpdatePipeline()
        self.assertEqual(large.GetDataInformation().GetNumberOfPoints(), 4 * scene.SIZE[0] * scene.SIZE[1])
        simple.Delete(large)
        program = smtrace.stop_trace()
        final = scene.pixels(self.view)

        for part in "PixelExactSlice(", "PixelExactClip(", "PixelExactWarp(", "SliceOffsetValues":
            self.assertIn(part, program)
        with self.subTest("trace"):
            self.assertTrue(numpy.array_equal(self.again(program, "session_trace"), final))
        with self.subTest("Python state"):
            self.assertTrue(numpy.array_equal(self.again(smstate.get_state(), "session_state"), final))
        with self.subTest("state"):
            name = os.path.join(scene.PICTURES, "session.pvsm")
            simple.SaveState(name)
            loads = "from paraview import simple\nsimple._DisableFirstRenderCameraReset()\n"
            loads += f"simple.LoadState({name!r})\n"
            self.assertTrue(numpy.array_equal(self.again(loads, "session_pvsm"), final))
        with self.subTest("animation"):
            self.animate(self.first)

    def animate(self, cut):
        """Each frame is the slice at that height."""
        simple.HideAll(self.view)
        simple.Show(cut, self.view)
        animation = simple.GetAnimationScene()
        animation.NumberOfFrames, animation.PlayMode = 3, "Sequence"
        animation.StartTime, animation.EndTime = 0.0, 2.0
        track = simple.GetAnimationTrack("Origin", index=2, proxy=cut.SliceType)
        frames = [simple.CompositeKeyFrame(KeyTime=t, KeyValues=[z]) for t, z in ((0, -0.1), (1, 0.1))]
        track.KeyFrames = frames
        animation.GoToFirst()
        for height in (-0.1, 0.0, 0.1):
            self.on_plane(cut, [0, 0, height], [0, 0, 1])
            animation.GoToNext()
        simple.SaveAnimation(
            os.path.join(scene.PICTURES, "session_frame.png"), self.view, ImageResolution=scene.SIZE)
        self.assertEqual(len(glob.glob(os.path.join(scene.PICTURES, "session_frame.000*.png"))), 3)


if __name__ == "__main__":
    scene.main()
