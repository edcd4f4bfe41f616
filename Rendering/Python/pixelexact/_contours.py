"""Contour lines as polylines."""

from __future__ import annotations

from typing import Any, Optional, Sequence, Union

from ._cut import Limits, cut, field_of
from ._expressions import FieldName
from ._picture import picture_of
from ._read import Warp
from ._scene import (
    Normal,
    Vector,
    asks_python,
    component_of,
    count_of,
    list_of,
    source_of,
    surface_of,
)
from ._warp import warped
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
    field: Optional[FieldName] = None,
    values: Optional[Sequence[float]] = None,
    *,
    count: Optional[int] = None,
    clim: Limits = None,
    normal: Normal = "z",
    origin: Union[float, Vector, None] = None,
    surface: Any = None,
    component: Union[int, str, None] = None,
    tolerance: float = 0.0,
    warp: Warp = None,
    warp_direction: Optional[Vector] = None,
    progress: Progress = None,
) -> Any:
    """Lines on a cut-surface where a field has these values: a vtkPolyData of polylines.

    Points are where the field has the value, to rounding; the arrays, and what is proven of the
    lines, are those of vtkHighOrderContour, which warns of what it could not prove. grid, field,
    normal, origin, component, warp, warp_direction: as of cut; surface: a vtkImplicitFunction or a function of points.
    values: a list. count instead: so many round values strictly inside the range, as of cut and of
    the program's --contours N; clim: that range, as of cut, of a picture of 1000 x 1000 pixels.
    tolerance: how far chords may be from the curves; 0: 1e-4 of the diagonal of the mesh's box.
    """
    if (values is None) == (count is None):
        raise TypeError("contours: give either values, a list, or count, a number of values")
    if count is None and clim is not None:
        raise TypeError("contours: clim is the range of count's values: leave it out, or give count")
    chosen = [] if values is None else list_of(values, "values", "count")
    number = None if count is None else count_of(count, "count")
    source = warped(source_of(grid, progress), warp, warp_direction, progress)
    name = field_of(source, field)
    shape = surface_of(surface, _bounds_of(source), normal, origin)
    if not shape.IsA("vtkImplicitFunction"):
        raise Error(f"contours: {vtkHighOrderContour.DescribeSurfaces()}; cut draws on all")
    lines = vtkHighOrderContour()
    lines.SetInputData(source)
    lines.SetCutFunction(shape)
    if name is not None:
        lines.SetFieldName(name)
    lines.SetComponent(component_of(component))
    lines.SetTolerance(tolerance)
    if number is not None:
        seen = cut(source, name, surface=shape, component=component, clim=clim)
        low, high = picture_of(seen, buffers=False, progress=progress).range
        lines.GenerateRoundValues(number, low, high)
    for i, value in enumerate(chosen):
        lines.SetValue(i, value)
    run(lines, progress, may_release=not asks_python(shape))
    return lines.GetOutput()
