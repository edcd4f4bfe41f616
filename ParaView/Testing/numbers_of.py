"""A script that computes numbers of a mesh with the filters and picks of the plugin, and their comparison."""

import json
import os

import numpy

import scene

SUFFIX = ".json"
SCRIPT = """
import json, sys
from paraview.simple import *
from paraview import servermanager
from vtkmodules.util.numpy_support import vtk_to_numpy
kind, answers, *files = sys.argv[1:]
if kind.startswith("port:"):
    _, port, kind = kind.split(":")
    Connect("localhost", int(port))
if files[0].endswith(".xml"):
    reader = PixelExactNektarReader(FileName=files)
else:
    reader = PixelExactGridReader(FileName=files[:1])
grid = reader
if kind == "redistributed":
    # Each process has what it gets, whatever it asks for.
    grid = RedistributeDataSet(PixelExactPack(Input=reader))
elif kind == "blocks":
    grid = GroupDatasets(Input=[PixelExactGridReader(FileName=[file]) for file in files])
grid.UpdatePipeline()
found = {}


def rows(array):
    # Where there is nothing, of a contour for instance.
    return [] if array is None else vtk_to_numpy(array).tolist()


def arrays(name, source, *names):
    data = servermanager.Fetch(source)
    found[name] = {a: rows(data.GetPointData().GetArray(a)) for a in names}
    found[name]["Points"] = rows(data.GetPoints().GetData() if data.GetPoints() else None)


def table(name, source):
    data = servermanager.Fetch(source)
    columns = [data.GetColumn(i) for i in range(data.GetNumberOfColumns())]
    found[name] = {c.GetName(): rows(c) for c in columns if c.IsA("vtkDataArray")}


field = "u"
bounds = [*zip(*[iter(grid.GetDataInformation().GetBounds())] * 2)]
length = max(b - a for a, b in bounds)
# Beside the faces of elements, which belong to one of several.
middle = [0.5 * (a + b) + 0.013 * length for a, b in bounds]
ends = dict(Point1=[bounds[0][0], *middle[1:]], Point2=[bounds[0][1], *middle[1:]])
arrays("probe", PixelExactProbe(Input=Line(Resolution=60, **ends), Source=grid), field, "Verdict", "Element")
arrays("plot", PixelExactPlotOverLine(Input=grid, **ends), field, "Verdict", "Element", "arc_length")
cut = PixelExactLinearCut(Input=grid, Resolution=20)
contour = PixelExactContour(Input=grid, ContourValues=[0.1])
integral = PixelExactIntegrate(Input=grid)
comparison = PixelExactComparison(Input=grid, Surfaces=[cut], Size=[60, 50])
difference = PixelExactDifference(Input=grid, Other=grid, Size=[60, 50])
for filter in (cut, contour, integral, comparison, difference):
    filter.CutFunction.Origin, filter.CutFunction.Normal = middle, [0, 0, 1]
if kind != "blocks" and files[0].endswith(".vtu"):
    # Of this surface each process has a part.
    plane = Slice(Input=grid)
    plane.SliceType.Origin, plane.SliceType.Normal = middle, [0, 0, 1]
    comparison.Surfaces = [cut, plane]
arrays("cut", cut, field, "Element")
arrays("contour", contour, field)
if kind == "redistributed":
    # Elements come in another order: of those that share a point the first one has it, and lines
    # begin elsewhere.
    del found["cut"]["Element"], found["contour"]["Points"]
table("integral", integral)
table("comparison", comparison)
resampled = PixelExactLinearResample(Input=grid, Dimensions=[17, 16, 15])
arrays("resampled", Contour(Input=resampled, ContourBy=["POINTS", field], Isosurfaces=[0.1]), field)
arrays("difference", ExtractSurface(Input=difference), "First")

if kind != "blocks":
    truncated = PixelExactTruncate(Input=grid, Order=1)
    whole = servermanager.Fetch(truncated).GetFieldData()
    found["truncated"] = rows(whole.GetArray(field + "_LargestChange"))
    # Processes without cells have no errors to report.
    for filter in (truncated, PixelExactCertify(Input=grid), PixelExactSubdivide(Input=grid)):
        filter.UpdatePipeline()
        found[filter.SMProxy.GetXMLName()] = filter.GetDataInformation().GetNumberOfCells()

view = CreateView("RenderView")
view.ViewSize, view.UseFXAA, view.OrientationAxesVisibility = [320, 240], 0, 0
shown = Show(grid, view)
shown.SetRepresentationType("PixelExact")
ColorBy(shown, ("POINTS", field))
shown.CutFunction.Origin, shown.CutFunction.Normal = middle, [0, 0, 1]
if kind == "lines":
    shown.PixelExactContours = [0.1]
view.CameraFocalPoint = middle
view.CameraPosition = [middle[0] + 0.3 * length, middle[1] - 0.2 * length, middle[2] + 2.5 * length]
picked, text, bounding = [], [], []
for y in range(40, 220, 40):
    for x in range(40, 300, 40):
        shown.PickedPixel = [x, y]
        Render(view)
        shown.UpdatePropertyInformation()
        picked.append(list(shown.GetProperty("Picked")))
        text.append(shown.GetProperty("PickedText")[0] or "")
        if kind == "blocks" or picked[-1][0] != 1:
            continue
        SelectSurfaceCells(Rectangle=[x, y, x, y], View=view)
        information = ExtractSelection(Input=grid).GetDataInformation()
        bounding.append([information.GetNumberOfCells(), *information.GetBounds()])
        ClearSelection(grid)
found["picked"] = picked
found["text"] = text
found["selected"] = bounding
found["range"] = list(shown.GetProperty("FieldRange"))
found["visible"] = list(shown.GetProperty("VisibleRange"))
found["unknown"] = shown.GetProperty("UnknownPixels")[0]
shown.ValueUnderPointer = 1
view.MakeRenderWindowInteractor(True)
Render(view)
pointed = []
for y in range(40, 220, 40):
    view.GetInteractor().SetEventInformation(200, y)
    view.GetInteractor().InvokeEvent("MouseMoveEvent")
    shown.UpdatePropertyInformation()
    pointed.append(shown.GetProperty("PointerText")[0] or "")
found["pointed"] = pointed
with open(answers, "w") as file:
    json.dump(found, file)
"""


def script():
    """The script's file."""
    name = os.path.join(scene.PICTURES, "numbers_script.py")
    with open(name, "w") as file:
        file.write(SCRIPT)
    return name


def read(name):
    with open(name) as file:
        return json.load(file)


def compare(test, found, expected):
    """The same numbers, up to rounding: cells of parts come in another order, and so do sums."""
    test.assertEqual(found.keys(), expected.keys())
    for name, value in expected.items():
        if isinstance(value, dict):
            compare(test, found[name], value)
        elif name in ("text", "pointed"):
            test.assertEqual(found[name], value)
        elif name == "range":
            # Proven, to a thousandth of its width: parts are subdivided apart.
            numpy.testing.assert_allclose(found[name], value, rtol=0, atol=1e-3 * (value[1] - value[0]), err_msg=name)
        else:
            numpy.testing.assert_allclose(found[name], value, rtol=1e-13, atol=1e-13, err_msg=name)
