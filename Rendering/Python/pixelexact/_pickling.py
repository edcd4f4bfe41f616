"""What pictures are pickled and copied as: VTK's objects cannot be, so their numbers are."""

from __future__ import annotations

from typing import Any

from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkCommonMath import vtkMatrix4x4
from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkRenderingCore import vtkCamera

# All that a camera is set by; what a VTK does not know is left out.
_NUMBERS = (
    "Position FocalPoint ViewUp ViewAngle ParallelProjection ParallelScale UseHorizontalViewAngle "
    "UseHorizontalParallelScale WindowCenter ClippingRange ViewShear UseExplicitAspectRatio "
    "ExplicitAspectRatio UseExplicitProjectionTransformMatrix UseOffAxisProjection ScreenBottomLeft "
    "ScreenBottomRight ScreenTopRight EyeSeparation Stereo EyeAngle LeftEye"
).split()
_MATRICES = ("ModelTransformMatrix", "ExplicitProjectionTransformMatrix", "EyeTransformMatrix")
_TRANSFORMS = ("UserTransform", "UserViewTransform")


def _numbers_of(matrix: Any) -> list[float]:
    return [matrix.GetElement(i, j) for i in range(4) for j in range(4)]


def _matrix_of(numbers: list[float]) -> Any:
    matrix = vtkMatrix4x4()
    matrix.DeepCopy(numbers)
    return matrix


def state_of_camera(camera: Any) -> dict[str, Any]:
    """By the names of its properties; transforms are their matrices."""
    state: dict[str, Any] = {}
    for name in _NUMBERS:
        if hasattr(camera, f"Set{name}"):
            state[name] = getattr(camera, f"Get{name}")()
    for name in _MATRICES + _TRANSFORMS:
        found = getattr(camera, f"Get{name}")()
        if found is not None:
            state[name] = _numbers_of(found.GetMatrix() if name in _TRANSFORMS else found)
    return state


def camera_of_state(state: dict[str, Any]) -> Any:
    camera = vtkCamera()
    for name, value in state.items():
        if not hasattr(camera, f"Set{name}"):
            continue  # of another VTK
        if name in _TRANSFORMS:
            transform = vtkTransform()
            transform.SetMatrix(_matrix_of(value))
            value = (transform,)
        elif name in _MATRICES:
            value = (_matrix_of(value),)
        elif not isinstance(value, tuple):
            value = (value,)
        getattr(camera, f"Set{name}")(*value)
    return camera


def state_of_image(data: Any) -> dict[str, Any]:
    """Its size, the arrays of its pixels by their names, and which of them is shown."""
    from vtkmodules.util.numpy_support import vtk_to_numpy

    points = data.GetPointData()
    arrays = [points.GetArray(i) for i in range(points.GetNumberOfArrays())]
    shown = points.GetScalars()
    return {
        "shown": shown.GetName() if shown else None,
        "size": data.GetDimensions()[:2],
        "arrays": {array.GetName(): vtk_to_numpy(array) for array in arrays},
    }


def image_of_state(state: dict[str, Any]) -> Any:
    from vtkmodules.util.numpy_support import numpy_to_vtk

    data = vtkImageData()
    data.SetDimensions(*state["size"], 1)
    for name, numbers in state["arrays"].items():
        array = numpy_to_vtk(numbers, deep=True)
        array.SetName(name)
        data.GetPointData().AddArray(array)
    if state["shown"] is not None:
        data.GetPointData().SetActiveScalars(state["shown"])
    return data
