"""Two and four processes give the picture of one."""

import os
import shutil
import subprocess
import unittest

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

import scene

SCRIPT = """
import sys
from paraview.simple import *
kind, picture, *files = sys.argv[1:]
view = CreateView("RenderView")
view.ViewSize, view.UseFXAA, view.OrientationAxesVisibility = [320, 240], 0, 0
if files[0].endswith(".xml"):
    reader = PixelExactNektarReader(FileName=files)
elif files[0].endswith(".mesh"):
    reader = PixelExactMFEMReader(FileName=files[:1], GridFunctionFileNames=files[1:])
else:
    reader = PixelExactGridReader(FileName=files)
if kind == "packed":
    reader = GhostCellsGenerator(RedistributeDataSet(PixelExactPack(Input=reader)))
shown = Show(reader, view)
shown.SetRepresentationType("PixelExact")
if kind.startswith("boundary"):
    shown.PixelExactSurface = "Boundary"
    shown.Opacity = 1.0 if kind.endswith("opaque") else 0.5
    shown.ColorArrayName = [None, ""]
elif kind == "iso":
    shown.PixelExactSurface = "Iso-Surface"
    shown.IsoArray = ["POINTS", "u"]
    shown.IsoValue = 0.2
    shown.ColorArrayName = [None, ""]
else:
    ColorBy(shown, ("POINTS" if files[0].endswith(".vtu") else "CELLS", "u"))
    GetColorTransferFunction("u").RescaleTransferFunction(-1.0, 1.0)
    shown.CutFunction.Normal = [0, 0, 1]
    if kind == "contours":
        shown.PixelExactContours = [0.2]
middle = [0.5 * (a + b) for a, b in zip(*[iter(reader.GetDataInformation().GetBounds())] * 2)]
length = max(b - a for a, b in zip(*[iter(reader.GetDataInformation().GetBounds())] * 2))
view.CameraFocalPoint = middle
view.CameraPosition = [middle[0] + 0.3 * length, middle[1] - 0.2 * length, middle[2] + 2.5 * length]
Render(view)
SaveScreenshot(picture, view, ImageResolution=[320, 240])
"""
NEK = ("nek_tet_varp/nek_tet_varp.xml",)
# Script's arguments, how many processes, and by how much the pictures may differ: pixels, levels of
# a byte.
CASES = {
    "cut": (("cut", "toroid_hex_g3_p6.vtu"), (2, 4), 0, 0),
    "iso": (("iso", "escher_tet_g3_p3.vtu"), (2,), 0, 0),
    "packed": (("packed", "toroid_hex_g3_p6.vtu"), (2,), 0, 0),
    # Seen through, so that walls between the parts would show; blending rounds once more. Not of four:
    # ParaView blends processes in the order of their boxes, and theirs overlap.
    "boundary": (("boundary", *NEK), (2,), 320 * 240, 1),
    "boundary_opaque": (("boundary_opaque", *NEK), (4,), 0, 0),
    # Pixels whose corners are in another process' part have no line.
    "contours": (("contours", "toroid_hex_g3_p6.vtu"), (2,), 20, 255),
}


def read(name):
    reader = vtkPNGReader()
    reader.SetFileName(name)
    reader.Update()
    return vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars()).astype(int)


@unittest.skipIf(shutil.which("mpirun") is None, "there is no mpirun")
class Parallel(unittest.TestCase):
    def picture(self, name, processes):
        script = os.path.join(scene.PICTURES, "parallel.py")
        picture = os.path.join(scene.PICTURES, f"parallel_{name}_{processes}.png")
        with open(script, "w") as file:
            file.write(SCRIPT)
        kind, *files = CASES[name][0]
        # Not those of this process, which has started MPI too.
        own = {k: v for k, v in os.environ.items() if not k.startswith(("OMPI_", "PMIX_", "ORTE_"))}
        # --sym: every process runs the script, as the processes of a batch job do.
        done = subprocess.run(
            ["mpirun", "--oversubscribe", "--bind-to", "none", "-n", str(processes)]
            + ["pvbatch", "--mpi", "--sym", script, kind, picture]
            + [scene.data(file) for file in files],
            env=own | {"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"},
            capture_output=True,
            text=True,
        )
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertNotIn("ERR|", done.stdout + done.stderr)
        return read(picture)

    def test_the_same(self):
        for name, (_, counts, pixels, levels) in CASES.items():
            with self.subTest(name):
                alone = self.picture(name, 1)
                for processes in counts:
                    off = numpy.abs(self.picture(name, processes) - alone).max(axis=-1)
                    self.assertLessEqual(numpy.count_nonzero(off), pixels, processes)
                    self.assertLessEqual(off.max(), levels, processes)


if __name__ == "__main__":
    scene.main()
