"""Contour lines as polylines."""

from __future__ import annotations

from typing import Any, Optional, Sequence, Union

from ._cut import check_field
from ._scene import (
    Normal,
    Vector,
    asks_python,
    component_of,
    numbers_of,
    source_of,
    surface_of,
)
from ._work import Error, Progress, run
from .PixelExactFilters import vtkHighOrderContour


def _bounds_of(source: Any) -> Sequence[float]:
    from .PixelExactRendering import vtkHighOrderMapper

    mapper = vtkHighOrderMapper()
    mapper.SetInputData(source)
    bounds: Sequence[float] = mapper.GetBounds()
    return bounds


def contours(
    grid: Any,
    field: Optional[str] = None,
    values: Union[float, Sequence[float], None] = None,
    *,
    normal: Normal = "z",
    origin: Union[float, Vector, None] = None,
    surface: Any = None,
    component: Union[int, str, None] = None,
    tolerance: float = 0.0,
    progress: Progress = None,
) -> Any:
    """Lines on a cut-surface where a field has these values: a vtkPolyData of polylines.

    Points are where the field has the value, to rounding; the arrays, and what is proven of the
    lines, are those of vtkHighOrderContour, which warns of what it could not prove. grid, field,
    normal, origin, component: as of cut; surface: a vtkImplicitFunction or a function of points.
    tolerance: how far chords may be from the curves; 0: 1e-4 of the diagonal of the mesh's box.
    """
    if values is None:
        raise TypeError("contours: give values, a number or several")
    source = source_of(grid, progress)
    check_field(source, field)
    shape = surface_of(surface, _bounds_of(source), normal, origin)
    if not shape.IsA("vtkImplicitFunction"):
        raise Error("contours: on functions' surfaces alone; cut draws them on the others")
    lines = vtkHighOrderContour()
    lines.SetInputData(source)
    lines.SetCutFunction(shape)
    if field is not None:
        lines.SetFieldName(field)
    lines.SetComponent(component_of(component))
    lines.SetTolerance(tolerance)
    for i, value in enumerate(numbers_of(values, "values")):
        lines.SetValue(i, value)
    run(lines, progress, may_release=not asks_python(shape))
    return lines.GetOutput()
