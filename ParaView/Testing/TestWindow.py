"""A user's actions in ParaView's own window, with a screenshot of the window after each."""

import glob
import json
import os
import shutil
import subprocess
import unittest

import scene

# A timer takes one action at a time, so that the window's panels follow.
CLIENT = """
import json, os, shutil, subprocess, sys, traceback, unittest
sys.path.insert(0, {folder!r})
os.environ.update({environment!r})
from paraview import simple
import scene, user_actions

class Window(user_actions.Actions, unittest.TestCase):
    def __init__(self):
        super().__init__("actions")
        self.view = simple.GetActiveViewOrCreate("RenderView")
        self.steps, self.action, self.names = self.actions(), None, []
        self.active, self.busy, self.odd = None, False, False

    def shoot(self):
        name = {pictures!r} + "window_%02d_%s.png" % (len(self.names), self.names[-1])
        screen = ["-f", "x11grab", "-video_size", "1280x1024", "-i", os.environ["DISPLAY"]]
        subprocess.run(["ffmpeg", "-loglevel", "error", "-y", *screen, "-frames:v", "1", name], check=True)

    def tick(self, *_):
        # Every second tick is left to the window, which draws itself.
        self.odd = not self.odd
        if self.busy or self.odd:
            return
        self.busy = True
        try:
            self.take()
        except StopIteration:
            self.end()
        except Exception:
            traceback.print_exc()
            self.end()
        self.busy = False

    def take(self):
        if self.action is None:
            self.size = list(self.view.ViewSize)
            self.action = next(self.steps)
        elif self.active is None:
            self.names.append(self.action)
            self.shoot()
            # Hides the widgets of planes, which the checks would take for the picture.
            self.active = simple.GetActiveSource()
            simple.SetActiveSource(None)
            return
        else:
            self.action = self.steps.send(scene.pixels(self.view))
            if simple.GetActiveSource() is None:
                simple.SetActiveSource(self.active)
            self.active = None
        simple.Render(self.view)

    def end(self):
        with open({numbers!r}, "w") as out:
            json.dump(self.names, out)
        sys.stdout.flush()
        sys.stderr.flush()
        os._exit(0)

if shutil.which("xdotool"):
    subprocess.run(["xdotool", "search", "--onlyvisible", "--name", "ParaView", "windowsize", "%@", "1280", "1000"])
window = Window()
interactor = window.view.GetInteractor()
interactor.AddObserver("TimerEvent", window.tick)
interactor.CreateRepeatingTimer(300)
"""


@unittest.skipIf(shutil.which("paraview") is None, "there is no window's ParaView")
@unittest.skipIf(shutil.which("ffmpeg") is None, "there is no ffmpeg to shoot the window")
class Window(unittest.TestCase):
    """The screenshots are window_NN_ACTION.png in the order of the actions."""

    def test_actions(self):
        shots = os.path.join(scene.PICTURES, "window_[0-9]*.png")
        for name in glob.glob(shots):
            os.remove(name)
        script, numbers = (os.path.join(scene.PICTURES, "window" + end) for end in (".py", ".json"))
        with open(script, "w") as file:
            file.write(
                CLIENT.format(
                    folder=os.path.dirname(os.path.abspath(__file__)),
                    environment={k: v for k, v in os.environ.items() if k.startswith("PIXELEXACT_")},
                    pictures=os.path.join(scene.PICTURES, ""),
                    numbers=numbers,
                )
            )
        done = subprocess.run(
            ["paraview", "--dr", "--script=" + script], capture_output=True, text=True, timeout=500
        )
        self.assertEqual(done.returncode, 0, done.stderr)
        for word in "Traceback", "ERR|":
            self.assertNotIn(word, done.stdout + done.stderr)
        with open(numbers) as file:
            names = json.load(file)
        self.assertGreater(len(names), 29)
        self.assertEqual(names[-1], "zoom")
        self.assertEqual(len(glob.glob(shots)), len(names))


if __name__ == "__main__":
    scene.main()
