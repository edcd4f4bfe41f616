#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The picture at the head of the README: half of a twisted torus, its cut pixel-exact.

The cut is the solver's own polynomials, order 6 on curved hexahedra of order 3. What is below it,
the grey skin and the dark edges of the elements, is ordinary VTK geometry, finely triangulated;
both hide each other to the pixel. Usage: readme_picture.py [IMAGE.png [WIDTH]]
"""

import sys
from pathlib import Path

import numpy as np
import vtkmodules.vtkRenderingFreeType  # noqa: F401
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401
from pixelexact import vtkHighOrderMapper, vtkUnstructuredGridToHighOrderGrid
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPlane, vtkPolyData, vtkUnstructuredGrid
from vtkmodules.vtkCommonExecutionModel import vtkTrivialProducer
from vtkmodules.vtkFiltersCore import vtkClipPolyData, vtkPolyDataNormals, vtkTubeFilter
from vtkmodules.vtkFiltersGeometry import vtkDataSetSurfaceFilter
from vtkmodules.vtkImagingCore import vtkImageShrink3D
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader
from vtkmodules.vtkRenderingAnnotation import vtkScalarBarActor
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkColorTransferFunction,
    vtkLightKit,
    vtkPolyDataMapper,
    vtkRenderer,
    vtkRenderWindow,
    vtkWindowToImageFilter,
)

HERE = Path(__file__).resolve().parent
# Drawn larger and averaged down: smooth edges everywhere, of cut, skin and letters alike.
OVERSAMPLING = 2
RANGE = (-0.9, 0.9)


def cool_to_warm():
    """K. Moreland's diverging map: the field oscillates around zero."""
    colors = vtkColorTransferFunction()
    colors.SetColorSpaceToDiverging()
    colors.AddRGBPoint(RANGE[0], 0.230, 0.299, 0.754)
    colors.AddRGBPoint(RANGE[1], 0.706, 0.016, 0.150)
    return colors


def exact_cut(grid_port, plane, colors):
    mapper = vtkHighOrderMapper()
    mapper.SetInputConnection(grid_port)
    mapper.SetCutFunction(plane)
    mapper.SelectColorArray("u")
    mapper.SetLookupTable(colors)
    mapper.SetScalarRange(*RANGE)
    actor = vtkActor()
    actor.SetMapper(mapper)
    return actor


def below(port, plane):
    """The part of polygons or lines on the side of the plane that its normal points away from."""
    clip = vtkClipPolyData()
    clip.SetInputConnection(port)
    clip.SetClipFunction(plane)
    clip.InsideOutOn()
    return clip


def plain_actor(port, color):
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(port)
    mapper.ScalarVisibilityOff()
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(*color)
    actor.GetProperty().SetAmbient(0.2)
    actor.GetProperty().SetSpecular(0.15)
    actor.GetProperty().SetSpecularPower(20)
    return actor


def with_shared_points(grid):
    """In the file the elements have points of their own; VTK finds a skin where they share them."""
    points = vtk_to_numpy(grid.GetPoints().GetData())
    _, first, number = np.unique(
        np.round(points, 9) + 0.0, axis=0, return_index=True, return_inverse=True
    )
    shared_points = vtkPoints()
    shared_points.SetData(numpy_to_vtk(points[first], deep=True))
    cells = vtkCellArray()
    for c in range(grid.GetNumberOfCells()):
        ids = grid.GetCell(c).GetPointIds()
        cells.InsertNextCell(ids.GetNumberOfIds())
        for i in range(ids.GetNumberOfIds()):
            cells.InsertCellPoint(int(number[ids.GetId(i)]))
    shared = vtkUnstructuredGrid()
    shared.SetPoints(shared_points)
    shared.SetCells(grid.GetCellType(0), cells)
    return shared


def skin(grid, plane):
    surface = vtkDataSetSurfaceFilter()
    surface.SetInputData(grid)
    surface.SetNonlinearSubdivisionLevel(3)
    half = below(surface.GetOutputPort(), plane)
    normals = vtkPolyDataNormals()
    normals.SetInputConnection(half.GetOutputPort())
    normals.SetFeatureAngle(40)
    return plain_actor(normals.GetOutputPort(), (0.86, 0.86, 0.87))


def element_edges(grid):
    """The elements' edges on the boundary, as polylines through the edges' nodes."""
    faces = {}
    for c in range(grid.GetNumberOfCells()):
        cell = grid.GetCell(c)
        for f in range(cell.GetNumberOfFaces()):
            ids = cell.GetFace(f).GetPointIds()
            corners = frozenset(ids.GetId(i) for i in range(4))
            faces.setdefault(corners, []).append((c, f))
    lines, seen = vtkCellArray(), set()
    for users in faces.values():
        if len(users) > 1:
            continue
        cell, face = users[0]
        outer = grid.GetCell(cell).GetFace(face)
        for e in range(outer.GetNumberOfEdges()):
            ids = outer.GetEdge(e).GetPointIds()
            ends = frozenset((ids.GetId(0), ids.GetId(1)))
            if ends in seen:
                continue
            seen.add(ends)
            lines.InsertNextCell(ids.GetNumberOfIds())
            # A Lagrange curve's ends come first, its inner nodes after them.
            for i in [0, *range(2, ids.GetNumberOfIds()), 1]:
                lines.InsertCellPoint(ids.GetId(i))
    edges = vtkPolyData()
    edges.SetPoints(grid.GetPoints())
    edges.SetLines(lines)
    return edges


def edge_tubes(grid, plane, radius, color, above):
    """Clipped as tubes and not as lines, so that they end flush with the cut."""
    edges = vtkTrivialProducer()
    edges.SetOutput(element_edges(grid))
    tubes = vtkTubeFilter()
    tubes.SetInputConnection(edges.GetOutputPort())
    tubes.SetRadius(radius)
    tubes.SetNumberOfSides(16)
    half = below(tubes.GetOutputPort(), plane)
    half.SetInsideOut(not above)
    return plain_actor(half.GetOutputPort(), color)


def color_bar(colors, height):
    bar = vtkScalarBarActor()
    bar.SetLookupTable(colors)
    bar.SetTitle("u")
    bar.SetNumberOfLabels(7)
    bar.SetLabelFormat("%.1f")
    bar.UnconstrainedFontSizeOn()
    bar.SetPosition(0.905, 0.2)
    bar.SetWidth(0.07)
    bar.SetHeight(0.6)
    bar.SetBarRatio(0.3)
    for text in (bar.GetTitleTextProperty(), bar.GetLabelTextProperty()):
        text.SetColor(0.15, 0.15, 0.15)
        text.ItalicOff()
        text.BoldOff()
        text.ShadowOff()
        text.SetFontSize(height // 36)
    bar.GetTitleTextProperty().ItalicOn()
    return bar


def main():
    image = sys.argv[1] if len(sys.argv) > 1 else str(HERE / "images" / "readme.png")
    width = OVERSAMPLING * (int(sys.argv[2]) if len(sys.argv) > 2 else 1200)
    height = width * 5 // 8

    reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(str(HERE.parent / "Data" / "toroid_hex_g3_p6.vtu"))
    convert = vtkUnstructuredGridToHighOrderGrid()
    convert.SetInputConnection(reader.GetOutputPort())
    convert.Update()
    shared = with_shared_points(reader.GetOutput())
    plane = vtkPlane()
    plane.SetOrigin(0, 0, 0.06)
    plane.SetNormal(0.06, -0.1, 1)
    colors = cool_to_warm()

    renderer = vtkRenderer()
    renderer.SetBackground(1, 1, 1)
    for actor in (
        exact_cut(convert.GetOutputPort(), plane, colors),
        skin(shared, plane),
        edge_tubes(shared, plane, 0.007, (0.3, 0.3, 0.33), above=False),
        edge_tubes(shared, plane, 0.005, (0.55, 0.56, 0.6), above=True),
        color_bar(colors, height),
    ):
        renderer.AddActor(actor)
    lights = vtkLightKit()
    lights.SetKeyLightIntensity(0.9)
    lights.SetKeyToFillRatio(1.6)
    lights.AddLightsToRenderer(renderer)
    camera = renderer.GetActiveCamera()
    camera.SetFocalPoint(0.2, 0.0, -0.04)
    camera.SetPosition(0.9, -4.6, 4.6)
    camera.SetViewUp(0, 0, 1)
    camera.SetViewAngle(20.5)
    renderer.ResetCameraClippingRange()
    window = vtkRenderWindow()
    window.SetOffScreenRendering(True)
    window.SetMultiSamples(0)
    window.SetSize(width, height)
    window.AddRenderer(renderer)

    grab = vtkWindowToImageFilter()
    grab.SetInput(window)
    grab.ReadFrontBufferOff()
    average = vtkImageShrink3D()
    average.SetInputConnection(grab.GetOutputPort())
    average.SetShrinkFactors(OVERSAMPLING, OVERSAMPLING, 1)
    average.AveragingOn()
    writer = vtkPNGWriter()
    writer.SetFileName(image)
    writer.SetInputConnection(average.GetOutputPort())
    writer.Write()
    print("wrote", image)


if __name__ == "__main__":
    main()
