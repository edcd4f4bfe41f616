"""What the tests of the plugin share: files, pictures and values."""

import contextlib
import csv
import math
import os
import subprocess
import sys
import tempfile
import unittest

import numpy
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkOutputWindow, vtkPoints, vtkStringOutputWindow
from vtkmodules.vtkCommonDataModel import vtkPolyData

DATA = os.environ["PIXELEXACT_DATA_DIR"]
TOOL = os.environ["PIXELEXACT_TOOL"]
PICTURES = os.environ["PIXELEXACT_PICTURES"]
SIZE = (320, 240)


def data(name):
    return os.path.join(DATA, name)


def oracle(name):
    """Columns of a table that a solver's library computed."""
    with open(data(name), newline="") as file:
        rows = list(csv.DictReader(file))
    return {key: [row[key] for row in rows] for key in rows[0]}


def numbers(table, *columns):
    return numpy.array([[float(x) for x in table[column]] for column in columns]).T


def point_source(points):
    """A source of ParaView's with these points."""
    made = vtkPoints()
    made.SetDataTypeToDouble()
    made.SetData(numpy_to_vtk(numpy.ascontiguousarray(points, dtype=float), deep=True))
    polydata = vtkPolyData()
    polydata.SetPoints(made)
    source = simple.TrivialProducer()
    source.GetClientSideObject().SetOutput(polydata)
    source.MarkModified(source.SMProxy)
    return source


def probe(grid, points, **settings):
    """Point arrays of the filter PixelExact Probe."""
    places = point_source(points)
    found = simple.PixelExactProbe(Input=places, Source=grid, **settings)
    arrays = servermanager.Fetch(found).GetPointData()
    result = {
        arrays.GetArrayName(i): vtk_to_numpy(arrays.GetArray(i)).copy()
        for i in range(arrays.GetNumberOfArrays())
    }
    simple.Delete(found)
    simple.Delete(places)
    return result


def tool_values(inputs, field, points):
    """Values of `pixelexact probe`; none where there is no such program."""
    if not os.path.exists(TOOL):
        return None
    with tempfile.TemporaryDirectory() as folder:
        asked, answered = os.path.join(folder, "points.csv"), os.path.join(folder, "values.csv")
        with open(asked, "w") as file:
            file.write("x,y,z\n")
            file.writelines(",".join(repr(float(x)) for x in point) + "\n" for point in points)
        command = [TOOL, "probe", *inputs, "--field", field, "--points", asked, "--output", answered]
        own = {k: v for k, v in os.environ.items() if k not in ("LD_LIBRARY_PATH", "PYTHONPATH")}
        subprocess.run(command, check=True, capture_output=True, env=own)
        with open(answered, newline="") as file:
            rows = list(csv.DictReader(file))
    columns = [key for key in rows[0] if key == "value" or key.startswith("value_")]
    return numpy.array([[float(row[key]) for key in columns] for row in rows])


def make_plain(the_view, size=SIZE):
    """Nothing but data on a background, each pixel as it was drawn."""
    the_view.ViewSize = size
    the_view.OrientationAxesVisibility = 0
    the_view.UseColorPaletteForBackground = 0
    the_view.BackgroundColorMode = "Single Color"
    the_view.Background = [0.2, 0.4, 0.6]
    the_view.UseFXAA = 0


def view(direction=(0, 0, -1), up=(0, 1, 0), centre=(0, 0, 0), scale=1.6):
    """A plain view in parallel projection."""
    made = simple.CreateView("RenderView")
    aim(made, direction, up, centre, scale)
    simple.SetActiveView(made)
    return made


def aim(the_view, direction=(0, 0, -1), up=(0, 1, 0), centre=(0, 0, 0), scale=1.6, size=SIZE):
    """Makes a view plain, in parallel projection."""
    make_plain(the_view, size)
    the_view.CameraParallelProjection = 1
    the_view.CameraParallelScale = scale
    the_view.CameraFocalPoint = list(centre)
    the_view.CameraPosition = [c - 10.0 * d for c, d in zip(centre, direction)]
    the_view.CameraViewUp = list(up)


def pixels(the_view, name=None):
    """RGB of a view, lower row first, and a PNG of that name among the pictures."""
    simple.Render(the_view)
    image = the_view.CaptureWindow(1)
    width, height, _ = image.GetDimensions()
    rgb = vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, -1)[:, :, :3]
    if name is not None:
        simple.SaveScreenshot(os.path.join(PICTURES, name), the_view, ImageResolution=SIZE)
    return rgb.copy()


def is_background(rgb):
    return numpy.all(numpy.abs(rgb.astype(int) - [51, 102, 153]) <= 1, axis=-1)


def rays(the_view, places, size=SIZE):
    """Where the rays through pixels (column, row) begin, and their direction, in parallel projection."""
    eye, centre = numpy.array(the_view.CameraPosition), numpy.array(the_view.CameraFocalPoint)
    ahead = (centre - eye) / math.dist(centre, eye)
    right = numpy.cross(ahead, the_view.CameraViewUp)
    right /= numpy.linalg.norm(right)
    up = numpy.cross(right, ahead)
    width, height = size
    step = 2.0 * the_view.CameraParallelScale / height
    places = numpy.asarray(places, dtype=float)
    across = (places[:, 0] + 0.5 - width / 2) * step
    along = (places[:, 1] + 0.5 - height / 2) * step
    return eye + numpy.outer(across, right) + numpy.outer(along, up), ahead


def mapped(array, values):
    """RGB bytes that ParaView's colour map of an array gives values."""
    table = simple.GetColorTransferFunction(array).GetClientSideObject()
    table.Build()
    color = [0.0, 0.0, 0.0]
    colors = []
    for value in values:
        table.GetColor(float(value), color)
        colors.append([int(255.0 * part + 0.5) for part in color])
    return numpy.array(colors)


@contextlib.contextmanager
def messages():
    """A list that gets what VTK reports meanwhile as its only entry."""
    before = vtkOutputWindow.GetInstance()
    window = vtkStringOutputWindow()
    vtkOutputWindow.SetInstance(window)
    heard = []
    try:
        yield heard
    finally:
        vtkOutputWindow.SetInstance(before)
        heard.append(window.GetOutput())


def main():
    """Runs the tests and ends at once: while it closes its window at exit, ParaView may crash."""
    done = unittest.main(exit=False)
    sys.stdout.flush()
    sys.stderr.flush()
    os._exit(0 if done.result.wasSuccessful() else 1)
