#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""One picture for each kind of cut-surface, in VTK's windows. Usage: surfaces.py [FOLDER [WIDTH]]

surfaces.sh makes the like by the command-line tool.
Without a display: xvfb-run -a -s "-screen 0 1280x1024x24 -noreset" surfaces.py
"""

import sys
from pathlib import Path

import numpy as np
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401, VTK's way to choose how to draw
from pixelexact import (
    implicit_function,
    vtkHighOrderBoundarySurface,
    vtkHighOrderIsoSurface,
    vtkHighOrderLayer,
    vtkHighOrderMapper,
    vtkHighOrderPatchSurface,
    vtkHighOrderTriangleSurface,
    vtkImplicitTorus,
    vtkUnstructuredGridToHighOrderGrid,
)
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import (
    vtkCylinder,
    vtkImplicitBoolean,
    vtkPlane,
    vtkPlaneCollection,
    vtkPolyData,
    vtkSphere,
)
from vtkmodules.vtkIOGeometry import vtkSTLReader
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkColorTransferFunction,
    vtkLight,
    vtkRenderer,
    vtkRenderWindow,
    vtkWindowToImageFilter,
)

DATA = Path(__file__).resolve().parent.parent / "Data"
RANGE = (-0.85, 0.85)


def plane_at(origin, normal):
    plane = vtkPlane()
    plane.SetOrigin(origin)
    plane.SetNormal(normal)
    return plane


def ball():
    sphere = vtkSphere()
    sphere.SetCenter(0.9, 0.1, 0.05)
    sphere.SetRadius(0.55)
    return sphere


def pipe():
    cylinder = vtkCylinder()
    cylinder.SetAxis(0, 0, 1)
    cylinder.SetRadius(1)
    return cylinder


def pipe_without_ball():
    """Closed forms stay exact in unions, intersections and differences."""
    difference = vtkImplicitBoolean()
    difference.SetOperationTypeToDifference()
    difference.AddFunction(pipe())
    difference.AddFunction(ball())
    return difference


def waves():
    """z = 0.15 sin(6 x), as a function of arrays: searched for along the rays."""

    def value(x):
        return x[:, 2] - 0.15 * np.sin(6 * x[:, 0])

    def gradient(x):
        slope = -0.9 * np.cos(6 * x[:, 0])
        return np.stack([slope, np.zeros(len(x)), np.ones(len(x))], axis=1)

    return implicit_function(value, gradient)


def saddle():
    """16 points are a bicubic patch, rows of u."""
    points = vtkPoints()
    file = DATA / "surfaces" / "saddle.txt"
    points.SetData(numpy_to_vtk(np.loadtxt(file), deep=True))
    data = vtkPolyData()
    data.SetPoints(points)
    patches = vtkHighOrderPatchSurface()
    patches.SetInputData(data)
    return patches


def octahedron():
    reader = vtkSTLReader()
    reader.SetFileName(str(DATA / "surfaces" / "octahedron.stl"))
    triangles = vtkHighOrderTriangleSurface()
    triangles.SetInputConnection(reader.GetOutputPort())
    return triangles


def isosurface(value):
    surface = vtkHighOrderIsoSurface()
    surface.SetFieldName("u")
    surface.SetValue(value)
    return surface


def elements(*numbers):
    surface = vtkHighOrderBoundarySurface()
    for number in numbers:
        surface.AddElement(number)
    return surface


def grey_boundary():
    layer = vtkHighOrderLayer()
    layer.SetSurface(vtkHighOrderBoundarySurface())
    layer.ScalarVisibilityOff()
    layer.SetColor(0.75, 0.75, 0.8)
    layer.SetOpacity(0.25)
    return layer


def layer_of(surface):
    layer = vtkHighOrderLayer()
    layer.SetSurface(surface)
    return layer


def together(mapper):
    """Both iso-surfaces within the boundary, the front half clipped away."""
    for layer in (layer_of(isosurface(0.3)), layer_of(isosurface(-0.3)), grey_boundary()):
        mapper.AddLayer(layer)
    planes = vtkPlaneCollection()
    planes.AddItem(plane_at((0, -0.2, 0), (0, 1, 0)))
    mapper.SetClippingPlanes(planes)


def transparent(mapper):
    mapper.SetCutFunction(plane_at((0, 0, 0.05), (0.06, -0.1, 1)))
    mapper.AddLayer(grey_boundary())


# What cuts, by the names of the pictures. Functions and surfaces alone, or what sets a mapper up.
FUNCTIONS = {
    "plane": lambda: plane_at((0, 0, 0.05), (0.06, -0.1, 1)),
    "sphere": ball,
    "cylinder": pipe,
    "torus": vtkImplicitTorus,
    "boolean": pipe_without_ball,
    "python": waves,
}
SURFACES = {
    "patches": saddle,
    "triangles": octahedron,
    "boundary": vtkHighOrderBoundarySurface,
    "elements": lambda: elements(0, 7, 21, 40),
    "isosurface": lambda: isosurface(0.3),
}
SCENES = {"transparent": transparent, "together": together}


def colors():
    table = vtkColorTransferFunction()
    table.SetColorSpaceToDiverging()
    table.AddRGBPoint(RANGE[0], 0.230, 0.299, 0.754)
    table.AddRGBPoint(RANGE[1], 0.706, 0.016, 0.150)
    return table


def mapper_for(name, grid_port):
    mapper = vtkHighOrderMapper()
    mapper.SetInputConnection(grid_port)
    mapper.SelectColorArray("u")
    mapper.SetLookupTable(colors())
    mapper.SetScalarRange(*RANGE)
    if name in FUNCTIONS:
        mapper.SetCutFunction(FUNCTIONS[name]())
    elif name in SURFACES:
        mapper.SetSurface(SURFACES[name]())
    else:
        SCENES[name](mapper)
    return mapper


def window_of(width):
    """An empty one, seen from above in the light of the eye and of a lamp beside it."""
    renderer = vtkRenderer()
    renderer.SetBackground(1, 1, 1)
    camera = renderer.GetActiveCamera()
    camera.SetPosition(2.5, -3, 3.5)
    camera.SetFocalPoint(0, 0, 0)
    camera.SetViewUp(0, 0, 1)
    camera.SetViewAngle(33)
    eye = vtkLight()
    eye.SetLightTypeToHeadlight()
    eye.SetIntensity(0.7)
    lamp = vtkLight()
    lamp.SetLightTypeToCameraLight()
    lamp.SetPosition(-2, 2, 1)
    lamp.SetIntensity(0.4)
    renderer.AddLight(eye)
    renderer.AddLight(lamp)
    window = vtkRenderWindow()
    window.SetOffScreenRendering(True)
    window.SetSize(width, width * 5 // 6)
    window.AddRenderer(renderer)
    return window, renderer


def write(window, path):
    grab = vtkWindowToImageFilter()
    grab.SetInput(window)
    grab.ReadFrontBufferOff()
    writer = vtkPNGWriter()
    writer.SetFileName(str(path))
    writer.SetInputConnection(grab.GetOutputPort())
    writer.Write()
    print("wrote", path)


def main():
    folder = Path(sys.argv[1] if len(sys.argv) > 1 else "pictures/surfaces")
    width = int(sys.argv[2]) if len(sys.argv) > 2 else 400
    folder.mkdir(parents=True, exist_ok=True)
    reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(str(DATA / "toroid_hex_g3_p6.vtu"))
    convert = vtkUnstructuredGridToHighOrderGrid()
    convert.SetInputConnection(reader.GetOutputPort())
    window, renderer = window_of(width)
    for name in (*FUNCTIONS, *SURFACES, *SCENES):
        actor = vtkActor()
        actor.SetMapper(mapper_for(name, convert.GetOutputPort()))
        renderer.AddActor(actor)
        renderer.ResetCameraClippingRange()
        write(window, folder / f"{name}.png")
        renderer.RemoveActor(actor)


if __name__ == "__main__":
    main()
