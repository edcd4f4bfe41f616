# SPDX-License-Identifier: BSD-3-Clause
"""A view (views.py) by Python, by a mapper without a window, and by one in a window."""

import contextlib
import functools

import numpy as np
import pixelexact
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkUnsignedCharArray
from vtkmodules.vtkCommonDataModel import vtkBox, vtkCylinder, vtkImplicitFunction, vtkPlane, vtkQuadric, vtkSphere
from vtkmodules.vtkRenderingCore import vtkActor, vtkCamera, vtkRenderer, vtkRenderWindow

from tool import case

# Keywords of `render` whose names differ from the tool's options, and what it says in other ways.
KEYWORDS = {"colormap": "cmap", "range": "clim"}
NO_KEYWORDS = {"case", "field", "size", "layers", "camera", "background"}
DIRECTIONS = {"iso": (1, 1, 1), "x": (1, 0, 0), "y": (0, 1, 0), "z": (0, 0, 1)}


def surface_of(layer):
    """A function of VTK's, or a surface of ours."""
    kind, *numbers = layer["surface"]
    if kind == "plane":
        made = vtkPlane()
        made.SetOrigin(numbers[:3])
        made.SetNormal(numbers[3:])
    elif kind == "sphere":
        made = vtkSphere()
        made.SetCenter(numbers[:3])
        made.SetRadius(numbers[3])
    elif kind == "cylinder":
        made = vtkCylinder()
        made.SetCenter(numbers[:3])
        made.SetAxis(numbers[3:6])
        made.SetRadius(numbers[6])
    elif kind == "quadric":
        made = vtkQuadric()
        made.SetCoefficients(numbers)
    elif kind == "torus":
        made = pixelexact.vtkImplicitTorus()
        made.SetCenter(numbers[:3])
        made.SetAxis(numbers[3:6])
        made.SetRadius(numbers[6])
        made.SetTubeRadius(numbers[7])
    elif kind == "box":
        made = vtkBox()
        made.SetXMin(numbers[:3])
        made.SetXMax(numbers[3:])
    elif kind == "isosurface":
        made = pixelexact.vtkHighOrderIsoSurface()
        made.SetFieldName(numbers[0])
        made.SetValue(numbers[1])
    else:
        made = pixelexact.vtkHighOrderBoundarySurface()
    return made


@functools.lru_cache(maxsize=None)
def grid_of(name):
    return pixelexact.read(case(name))


def table_of(name, limits):
    """A layer's own map over its own range."""
    mapper = pixelexact.vtkHighOrderMapper()
    mapper.SetColorMap(name)
    table = mapper.GetLookupTable()
    table.SetRange(*limits)
    return table


def _set_contours(target, contours):
    """Of a mapper or a layer: `target` has a number of them, or values."""
    if isinstance(contours, list):
        for i, value in enumerate(contours):
            target.SetContourValue(i, value)
    else:
        target.SetContourCount(contours)


def layer_of(layer, view):
    made = pixelexact.vtkHighOrderLayer()
    surface = surface_of(layer)
    if isinstance(surface, vtkImplicitFunction):
        made.SetCutFunction(surface)
    else:
        made.SetSurface(surface)
    made.SetOpacity(layer.get("opacity", 1.0))
    if "color" in layer:
        made.ScalarVisibilityOff()
        made.SetColor(layer["color"])
    elif "colormap" in layer or "range" in layer:
        made.SetLookupTable(table_of(layer.get("colormap", "viridis"), layer["range"]))
    if "contours" in layer:
        _set_contours(made, layer["contours"])
    lights = layer.get("lights", view.get("lights", "curved"))
    made.SetLighting(lights != "off")
    made.SetLightFlat(lights == "on")
    return made


def _set_colors(mapper, view):
    mapper.SetColorMap(view.get("colormap", "viridis"))
    if view.get("log"):
        mapper.GetLookupTable().SetScaleToLog10()
    limits = view.get("range", "cut")
    if isinstance(limits, list):
        mapper.SetScalarRange(*limits)
        return
    mapper.SetRangeSymmetric(limits.startswith("symmetric"))
    if "%" in limits:
        mapper.SetRangeModeToPercentiles()
        mapper.SetRangePercentiles([float(part.rstrip("%")) for part in limits.split(",")])
    elif limits.endswith("field"):
        mapper.SetRangeModeToField()
    else:
        mapper.SetRangeModeToCut()


def actor_of(view):
    """An actor with a mapper, all of whose surfaces are layers."""
    mapper = pixelexact.vtkHighOrderMapper()
    mapper.SetInputData(grid_of(view["case"]))
    mapper.SetFieldName(view["field"])
    _set_colors(mapper, view)
    for layer in view["layers"]:
        mapper.AddLayer(layer_of(layer, view))
    if "contours" in view:
        _set_contours(mapper, view["contours"])
        color = view.get("contour_color", [0, 0, 0])
        if color == "map":
            mapper.ContourScalarVisibilityOn()
        else:
            mapper.SetContourColor(color)
        mapper.SetContourWidth(view.get("contour_width", 1.5))
        mapper.SetContoursOnly(view.get("contours_only", False))
    if view.get("certifier") == "interval":
        mapper.SetContourSubdivisions(view.get("subdivisions", 3))
    if "contour_labels" in view:
        mapper.ContourLabelsOn()
        mapper.SetContourLabelSize(view["contour_labels"])
    mapper.SetBands(view.get("bands", 0))
    mapper.SetShowUndecided(view.get("show_undecided", False))
    mapper.SetUndecidedColor(view.get("undecided_color", [1, 0, 0.5]))
    mapper.SetShowUndecidedContours(view.get("show_undecided_contours", False))
    mapper.SetUndecidedContourColor(view.get("undecided_contour_color", [0, 0.5, 0.5]))
    mapper.SetSamples(view.get("samples", 1))
    mapper.SetEdgesByKind(view.get("edges_by_kind", False))
    mapper.SetOutlines(view.get("outlines", False))
    mapper.SetOutlineColor(view.get("outline_color", [0, 0, 0]))
    actor = vtkActor()
    actor.SetMapper(mapper)
    # The material of the program, whose parts that face the viewer have the map's colours.
    actor.GetProperty().SetAmbient(0.4)
    actor.GetProperty().SetDiffuse(0.6)
    if "edges" in view:
        actor.GetProperty().EdgeVisibilityOn()
        actor.GetProperty().SetLineWidth(view["edges"])
        actor.GetProperty().SetEdgeColor(view.get("edge_color", [0.4, 0.4, 0.4]))
    for numbers in view.get("clip", []):
        plane = vtkPlane()
        plane.SetOrigin(numbers[:3])
        plane.SetNormal(numbers[3:])
        mapper.AddClippingPlane(plane)
    return actor


def camera_of(view):
    """The given camera; null: it is placed automatically."""
    told = view["camera"]
    if "view" in told:
        return None
    camera = vtkCamera()
    camera.SetPosition(told["camera_position"])
    camera.SetFocalPoint(told["focal_point"])
    camera.SetViewUp(told["view_up"])
    if "parallel_scale" in told:
        camera.ParallelProjectionOn()
        camera.SetParallelScale(told["parallel_scale"])
    else:
        camera.SetViewAngle(told.get("view_angle", 30.0))
    return camera


def arrays_of(image):
    points = image.GetPointData()
    return {points.GetArrayName(i): vtk_to_numpy(points.GetArray(i)) for i in range(points.GetNumberOfArrays())}


def without_a_window(view, actor):
    """Buffers, and the camera that they are seen through."""
    picture = pixelexact.vtkHighOrderPicture()
    picture.SetActor(actor)
    picture.SetSize(*view["size"])
    picture.AllBuffersOn()
    camera = camera_of(view)
    if camera is None:
        word = view["camera"]["view"]
        sign = -1 if word.startswith("-") else 1
        picture.ViewAlong([sign * part for part in DIRECTIONS[word.lstrip("+-")]])
    else:
        picture.SetCamera(camera)
    picture.Update()
    return arrays_of(picture.GetOutput()), picture.GetCamera()


@contextlib.contextmanager
def window_of(view, actor, camera, others=()):
    renderer = vtkRenderer()
    renderer.SetBackground(1, 1, 1)
    for shown in (actor, *others):
        renderer.AddActor(shown)
    renderer.SetActiveCamera(camera)
    renderer.ResetCameraClippingRange()
    window = vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(0)
    window.AddRenderer(renderer)
    window.SetSize(*view["size"])
    try:
        yield window
    finally:
        renderer.RemoveActor(actor)
        window.Finalize()


def in_a_window(view, actor, camera, *others):
    """Buffers, and RGBA of the window; `others`: actors beside it."""
    with window_of(view, actor, camera, others) as window:
        window.Render()
        # vtkWindowToImageFilter would turn the view angle a little.
        width, height = view["size"]
        seen = vtkUnsignedCharArray()
        window.GetRGBACharPixelData(0, 0, width - 1, height - 1, 0, seen)
        return arrays_of(actor.GetMapper().GetBuffers()), vtk_to_numpy(seen).copy()


def of_render(view):
    """The keywords of pixelexact.render; None: it has none for something in the view."""
    layer = view["layers"][0]
    if len(view["layers"]) > 1 or set(layer) - {"surface", "opacity"} or "certifier" in view:
        return None
    options = {"surface": surface_of(layer), "size": view["size"], "background": None}
    camera = camera_of(view)
    if camera is None:
        options["view"] = view["camera"]["view"]
    else:
        options["camera"] = camera
    options |= {KEYWORDS.get(key, key): view[key] for key in view if key not in NO_KEYWORDS}
    return options | ({"opacity": layer["opacity"]} if "opacity" in layer else {})


def by_render(view):
    """Rows from the bottom, as those of the others."""
    options = of_render(view)
    if options is None:
        return None
    picture = pixelexact.render(grid_of(view["case"]), view["field"], **options)
    names = ["Value", "Position", "Verdict", "Color"] + (["Contour"] if picture.contours is not None else [])
    return {name: np.concatenate(picture.array(name)[::-1]) for name in names}
