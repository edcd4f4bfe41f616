"""A script that draws a picture of a kind, and how its pictures are read."""

import os

from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

import scene

SUFFIX = ".png"
SCRIPT = """
import sys
from paraview.simple import *
kind, picture, *files = sys.argv[1:]
if kind.startswith("port:"):
    # A server reads the files and draws.
    _, port, kind = kind.split(":")
    Connect("localhost", int(port))
view = CreateView("RenderView")
view.ViewSize, view.UseFXAA, view.OrientationAxesVisibility = [320, 240], 0, 0
if files[0].endswith(".xml"):
    reader = PixelExactNektarReader(FileName=files)
elif files[0].endswith(".mesh"):
    reader = PixelExactMFEMReader(FileName=files[:1], GridFunctionFileNames=files[1:])
else:
    reader = PixelExactGridReader(FileName=files)
if kind == "packed":
    # ParaView 6.1 has renamed it.
    ghosts = GhostCellsGenerator if "GhostCellsGenerator" in globals() else GhostCells
    reader = ghosts(RedistributeDataSet(PixelExactPack(Input=reader)))
if kind == "slice":
    reader = PixelExactSlice(Input=reader, SliceType="Sphere")
    reader.SliceType.Center, reader.SliceType.Radius = [0.9, 0, 0], 0.5
elif kind == "clip":
    reader = PixelExactClip(Input=reader, ClipType="Plane")
    reader.ClipType.Origin, reader.ClipType.Normal = [0, 0, 0.1], [0.3, 0.2, 1]
shown = Show(reader, view)
shown.SetRepresentationType("PixelExact")
if kind.startswith("boundary"):
    shown.PixelExactSurface = "Boundary"
    shown.Opacity = 1.0 if kind.endswith("opaque") else 0.5
    shown.ColorArrayName = [None, ""]
elif kind.startswith("iso"):
    shown.PixelExactSurface = "Iso-Surface"
    shown.IsoArray = ["POINTS", "u"]
    shown.IsoValue = 0.2
    shown.JumpWalls = int(kind.endswith("walls"))
    shown.ColorArrayName = [None, ""]
else:
    ColorBy(shown, ("POINTS", "u"))
    GetColorTransferFunction("u").RescaleTransferFunction(-1.0, 1.0)
    shown.CutFunction.Normal = [0, 0, 1]
    if "contours" in kind:
        shown.PixelExactContours = [0.2]
    if "edges" in kind:
        shown.ElementEdges = 1
middle = [0.5 * (a + b) for a, b in zip(*[iter(reader.GetDataInformation().GetBounds())] * 2)]
length = max(b - a for a, b in zip(*[iter(reader.GetDataInformation().GetBounds())] * 2))
view.CameraFocalPoint = middle
view.CameraPosition = [middle[0] + 0.3 * length, middle[1] - 0.2 * length, middle[2] + 2.5 * length]
Render(view)
SaveScreenshot(picture, view, ImageResolution=[320, 240])
"""


def script():
    """The script's file."""
    name = os.path.join(scene.PICTURES, "picture_script.py")
    with open(name, "w") as file:
        file.write(SCRIPT)
    return name


def environment():
    """Of other processes: not that of this one, which has started MPI, too."""
    own = {k: v for k, v in os.environ.items() if not k.startswith(("OMPI_", "PMIX_", "ORTE_"))}
    return own | {"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"}


def read(name):
    reader = vtkPNGReader()
    reader.SetFileName(name)
    reader.Update()
    return vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars()).astype(int)
