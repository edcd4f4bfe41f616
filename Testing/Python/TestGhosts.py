# SPDX-License-Identifier: BSD-3-Clause
"""VTK's ghost cells are seen by what lies beside them, and not drawn."""

import os
import unittest

import numpy as np
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkDataSetAttributes, vtkPlane
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader
from vtkmodules.vtkRenderingCore import vtkActor, vtkRenderer, vtkRenderWindow, vtkWindowToImageFilter

import pixelexact

DATA = os.environ["PIXELEXACT_DATA_DIR"]


def grid_with_ghosts(ghosts):
    """The torus, of whose cells some are marked as copies of another process' cells."""
    reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(os.path.join(DATA, "toroid_hex_g3_p6.vtu"))
    converter = pixelexact.vtkUnstructuredGridToHighOrderGrid()
    converter.SetInputConnection(reader.GetOutputPort())
    converter.Update()
    grid = converter.GetOutput()
    marks = np.zeros(grid.GetNumberOfCells(), dtype=np.uint8)
    marks[list(ghosts)] = vtkDataSetAttributes.DUPLICATECELL
    array = numpy_to_vtk(marks, deep=True)
    array.SetName(vtkDataSetAttributes.GhostArrayName())
    grid.GetCellData().AddArray(array)
    return grid


def draw(grid, opacity=1.0):
    """RGB of each pixel, and the element that the mapper has there."""
    mapper = pixelexact.vtkHighOrderMapper()
    mapper.SetInputData(grid)
    mapper.SetCutFunction(vtkPlane())
    mapper.GenerateContourValues(5, -0.8, 0.8)
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetEdgeVisibility(opacity == 1.0)
    actor.GetProperty().SetOpacity(opacity)
    renderer = vtkRenderer()
    renderer.SetBackground(0.0, 0.0, 1.0)
    renderer.AddActor(actor)
    window = vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(0)
    window.SetSize(160, 120)
    window.AddRenderer(renderer)
    window.Render()
    picture = vtkWindowToImageFilter()
    picture.SetInput(window)
    picture.Update()
    rgb = vtk_to_numpy(picture.GetOutput().GetPointData().GetScalars()).reshape(-1, 3).copy()
    return rgb, vtk_to_numpy(mapper.GetBuffers().GetPointData().GetArray("Element")).copy()


class Ghosts(unittest.TestCase):
    def check(self, opacity):
        whole, element = draw(grid_with_ghosts([]), opacity)
        cells = np.unique(element[element >= 0])
        ghosts = cells[::2]
        rgb, seen = draw(grid_with_ghosts(ghosts), opacity)
        np.testing.assert_array_equal(seen, element)
        hidden = np.isin(element, ghosts)
        self.assertGreater(hidden.sum(), 500)
        self.assertGreater((~hidden & (element >= 0)).sum(), 500)
        # Lines up to the ghosts are those of the whole.
        np.testing.assert_array_equal(rgb[~hidden], whole[~hidden])
        self.assertEqual({tuple(pixel) for pixel in rgb[hidden].tolist()}, {(0, 0, 255)})

    def test_opaque(self):
        self.check(1.0)

    def test_translucent(self):
        self.check(0.5)


if __name__ == "__main__":
    unittest.main()
