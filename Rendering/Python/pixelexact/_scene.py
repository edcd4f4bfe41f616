"""What is cut, of what, in which colours: what cut, render and contours have in common."""

from __future__ import annotations

import math
import operator
import os
from numbers import Real
from typing import Any, Callable, Sequence, Union

from vtkmodules.vtkCommonDataModel import vtkImplicitFunction, vtkPlane, vtkUnstructuredGrid

from ._functions import implicit_function
from ._read import as_high_order, read
from ._work import Progress
from .PixelExactDataModel import vtkImplicitCallback
from .PixelExactRendering import vtkHighOrderSurface

Vector = Sequence[float]
Normal = Union[str, Vector]
Surface = Union[vtkImplicitFunction, vtkHighOrderSurface, Callable[[Any], Any], None]

_AXES = {"x": (1.0, 0.0, 0.0), "y": (0.0, 1.0, 0.0), "z": (0.0, 0.0, 1.0)}
_COMPONENTS = {"x": 0, "y": 1, "z": 2}
_MOST_CONTOURS = 10000


def source_of(grid: Any, progress: Progress = None) -> Any:
    """A grid with coefficients, or composite data as they are; a path is read."""
    if isinstance(grid, (str, os.PathLike)):
        return read(grid, progress=progress)
    if isinstance(grid, vtkUnstructuredGrid):
        return as_high_order(grid, progress)
    if hasattr(grid, "IsA") and grid.IsA("vtkCompositeDataSet"):
        return grid
    raise TypeError(
        f"a grid is a vtkUnstructuredGrid, composite data of such, or a file's name, not "
        f"{type(grid).__name__}"
    )


def numbers_of(numbers: Any, what: str) -> list[float]:
    """One or several."""
    if not isinstance(numbers, (str, bytes)):
        try:
            return [float(n) for n in (numbers if hasattr(numbers, "__iter__") else [numbers])]
        except (TypeError, ValueError):
            pass
    raise TypeError(f"{what}: numbers, not {numbers!r}")


def three(numbers: Vector, what: str) -> tuple[float, float, float]:
    values = numbers_of(numbers, what)
    if len(values) != 3:
        raise ValueError(f"{what}: three numbers, not {len(values)}")
    if not all(map(math.isfinite, values)):
        raise ValueError(f"{what}: finite numbers, not {numbers!r}")
    return values[0], values[1], values[2]


def normal_of(normal: Normal, what: str = "normal") -> tuple[float, float, float]:
    if isinstance(normal, str):
        sign = -1.0 if normal.startswith("-") else 1.0
        axis = _AXES.get(normal.lstrip("+-"))
        if axis is None:
            raise ValueError(
                f"{what}: 'x', 'y', 'z' (or with a sign), or three numbers, not {normal!r}"
            )
        return three([sign * part for part in axis], what)
    values = three(normal, what)
    if not any(values):
        raise ValueError(f"{what}: it must not be zero")
    return values


def plane_of(
    bounds: Sequence[float], normal: Normal, origin: Union[float, Vector, None]
) -> vtkPlane:
    """origin: a point, a coordinate along a normal that is an axis, None: the middle of the box."""
    direction = normal_of(normal)
    middle = [0.5 * (bounds[2 * i] + bounds[2 * i + 1]) for i in range(3)]
    if origin is None:
        point: Vector = middle
    elif isinstance(origin, Real):
        if not isinstance(normal, str):
            raise ValueError("origin: a single number goes with the normals 'x', 'y' and 'z' alone")
        point = three(
            [float(origin) if part else middle[i] for i, part in enumerate(direction)], "origin"
        )
    else:
        point = three(origin, "origin")
    plane = vtkPlane()
    plane.SetNormal(*direction)
    plane.SetOrigin(*point)
    return plane


def surface_of(
    surface: Surface, bounds: Sequence[float], normal: Normal, origin: Union[float, Vector, None]
) -> Any:
    """A vtkImplicitFunction or vtkHighOrderSurface."""
    if surface is None:
        return plane_of(bounds, normal, origin)
    if origin is not None:
        raise ValueError("origin and normal are of planes: leave them out where a surface is given")
    if isinstance(surface, (vtkImplicitFunction, vtkHighOrderSurface)):
        return surface
    if callable(surface):
        return implicit_function(surface)
    raise TypeError(
        "surface: a vtkImplicitFunction, a vtkHighOrderSurface or a function of points, not "
        f"{type(surface).__name__}"
    )


def asks_python(surface: Any) -> bool:
    """Whether tracing it calls functions of Python."""
    if isinstance(surface, vtkImplicitCallback):
        return True
    # Others may hold one inside, or be somebody's own.
    return isinstance(surface, vtkImplicitFunction) and surface.IsA("vtkImplicitBoolean") != 0


def component_of(component: Union[int, str, None]) -> int:
    """As all classes number them: -1 for scalars, and magnitudes of vectors."""
    if component is None or component == "magnitude":
        return -1
    if isinstance(component, str):
        if component not in _COMPONENTS:
            raise ValueError(
                f"component: a number from 0, 'x', 'y', 'z' or 'magnitude', not {component!r}"
            )
        return _COMPONENTS[component]
    if component < 0:
        raise ValueError(f"component: a number from 0, not {component}")
    return component


def list_of(values: Any, what: str, count: str) -> list[float]:
    """Several numbers; a single one might be meant for their count, and is refused."""
    if isinstance(values, Real) or getattr(values, "shape", None) == ():
        raise TypeError(
            f"{what}: a list of values, not the number {values!r}; give {what}=[{values}] for that "
            f"value, or {count}=N for a number of values"
        )
    return numbers_of(values, what)


def count_of(count: Any, what: str) -> int:
    """How many contours."""
    number = operator.index(count)
    if not 1 <= number <= _MOST_CONTOURS:
        raise ValueError(f"{what}: from 1 to {_MOST_CONTOURS}, not {number}")
    return number


def count_or_values(contours: Union[int, Sequence[float], None]) -> tuple[int, list[float]]:
    """How many contours, 0: those of the values."""
    if contours is None:
        return 0, []
    whole = hasattr(contours, "__index__") and not hasattr(contours, "__iter__")
    if whole and not isinstance(contours, bool):
        return count_of(contours, "contours"), []
    return 0, list_of(contours, "contours", "contours")
