#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""A pixel-exact cut in an ordinary VTK pipeline. Usage: five_lines.py [MESH.vtu [IMAGE.png]]

Without a display: xvfb-run -a -s "-screen 0 1280x1024x24 -noreset" five_lines.py
"""

import sys
from pathlib import Path

import vtkmodules.vtkRenderingOpenGL2  # noqa: F401, VTK's way to choose how to draw
from pixelexact import vtkHighOrderMapper, vtkUnstructuredGridToHighOrderGrid
from vtkmodules.vtkCommonDataModel import vtkPlane
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkRenderer,
    vtkRenderWindow,
    vtkWindowToImageFilter,
)

DATA = Path(__file__).resolve().parent.parent / "Data"
mesh = sys.argv[1] if len(sys.argv) > 1 else str(DATA / "toroid_hex_g3_p6.vtu")
image = sys.argv[2] if len(sys.argv) > 2 else "five_lines.png"

reader = vtkXMLUnstructuredGridReader()
reader.SetFileName(mesh)

# The five lines.
convert = vtkUnstructuredGridToHighOrderGrid()
convert.SetInputConnection(reader.GetOutputPort())
mapper = vtkHighOrderMapper()
mapper.SetInputConnection(convert.GetOutputPort())
mapper.SetCutFunction(vtkPlane())  # through the origin, normal to z

mapper.SelectColorArray("u")
mapper.SetScalarRange(-0.85, 0.85)  # of u on the cut
actor = vtkActor()
actor.SetMapper(mapper)
renderer = vtkRenderer()
renderer.SetBackground(1, 1, 1)
renderer.AddActor(actor)
renderer.ResetCamera()
window = vtkRenderWindow()
window.SetOffScreenRendering(True)
window.SetSize(800, 800)
window.AddRenderer(renderer)

grab = vtkWindowToImageFilter()
grab.SetInput(window)
grab.ReadFrontBufferOff()
writer = vtkPNGWriter()
writer.SetFileName(image)
writer.SetInputConnection(grab.GetOutputPort())
writer.Write()
print("wrote", image)
