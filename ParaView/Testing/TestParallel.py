"""Two processes give the picture of one."""

import os
import shutil
import subprocess
import unittest

import scene

SCRIPT = """
import sys
from paraview.simple import *
view = CreateView("RenderView")
view.ViewSize, view.UseFXAA, view.OrientationAxesVisibility = [320, 240], 0, 0
reader = PixelExactGridReader(FileName=[sys.argv[1]])
shown = Show(reader, view)
shown.SetRepresentationType("PixelExact")
ColorBy(shown, ("POINTS", "u"))
shown.CutFunction.Normal = [0, 0, 1]
shown.PixelExactContours = [0.2]
view.CameraPosition, view.CameraFocalPoint = [0, 0, 8], [0, 0, 0]
Render(view)
SaveScreenshot(sys.argv[2], view, ImageResolution=[320, 240])
"""


class Parallel(unittest.TestCase):
    def picture(self, processes):
        script = os.path.join(scene.PICTURES, "parallel.py")
        picture = os.path.join(scene.PICTURES, f"parallel_{processes}.png")
        with open(script, "w") as file:
            file.write(SCRIPT)
        # Not those of this process, which has started MPI too.
        own = {k: v for k, v in os.environ.items() if not k.startswith(("OMPI_", "PMIX_", "ORTE_"))}
        done = subprocess.run(
            ["mpirun", "--oversubscribe", "-n", str(processes), "pvbatch", "--mpi", script]
            + [scene.data("toroid_hex_g3_p6.vtu"), picture],
            env=own | {"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"},
            capture_output=True,
            text=True,
        )
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertNotIn("ERR|", done.stdout + done.stderr)
        with open(picture, "rb") as file:
            return file.read()

    def test_two(self):
        if shutil.which("mpirun") is None:
            self.skipTest("there is no mpirun")
        self.assertEqual(self.picture(2), self.picture(1))


if __name__ == "__main__":
    scene.main()
