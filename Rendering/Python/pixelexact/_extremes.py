"""Minima and maxima of fields."""

from __future__ import annotations

from typing import Any, NamedTuple, Optional, Union

from ._cut import field_of
from ._expressions import FieldName
from ._read import Warp
from ._scene import Vector, component_of, source_of
from ._warp import warped
from ._work import Error, Progress, run
from .PixelExactFilters import vtkHighOrderExtremes


class Extreme(NamedTuple):
    """The minimum or the maximum of a field: a point next to it, and proven bounds."""

    value: float
    """The field's value at the point."""
    bound: float
    """Proven: the field has no value below it (of a maximum: above it); infinite: no bound was found."""
    attained: float
    """Proven: the field attains a value not above it (of a maximum: not below it). The extreme lies
    between bound and this."""
    gap: float
    """abs(attained - bound), rounded up."""
    position: tuple[float, float, float]
    """The point."""
    element: int
    """The number, in the file, of its cell."""
    xi: tuple[float, float, float]
    """Its reference coordinates there."""


class Extremes(NamedTuple):
    """Both extremes of a field over a mesh, and what limits them."""

    minimum: Extreme
    maximum: Extreme
    met: bool
    """Whether both gaps are at most 1e-9 of the range of values, or 2^-40 of the largest magnitude."""
    not_finite: int
    """Elements with a coefficient that is not finite, which are left out."""
    unbounded: int
    """Elements of which no bound was found; then a bound is infinite."""
    inverted: int
    """Elements that are proven inverted; other elements may hold the same points."""
    undecided: int
    """Elements that are neither proven valid nor inverted."""


def extremes(
    grid: Any,
    field: Optional[FieldName] = None,
    *,
    component: Union[int, str, None] = None,
    warp: Warp = None,
    warp_direction: Optional[Vector] = None,
    progress: Progress = None,
) -> Extremes:
    """The minimum and the maximum of a field over the mesh, with proven bounds.

    grid, field, component, warp, warp_direction: as of cut. The work budget is 20,000 boxes an
    element. Of a discontinuous field a value is that of its element. Raises Error where no value
    is finite, and for expressions whose range cannot be proven.
    """
    source = warped(source_of(grid, progress), warp, warp_direction, progress)
    finder = vtkHighOrderExtremes()
    finder.SetInputData(source)
    name = field_of(source, field)
    if name is not None:
        finder.SetFieldName(name)
    finder.SetComponent(component_of(component))
    run(finder, progress)
    output = finder.GetOutput()
    if output.GetNumberOfPoints() != 2:
        raise Error("extremes: no value of the field is finite")
    data = output.GetPointData()

    def extreme(i: int) -> Extreme:
        numbers = [data.GetArray(array).GetValue(i) for array in ("Value", "Bound", "Attained", "Gap")]
        element = int(data.GetArray("Element").GetValue(i))
        return Extreme(*numbers, output.GetPoint(i), element, data.GetArray("Xi").GetTuple3(i))

    return Extremes(
        extreme(0),
        extreme(1),
        finder.GetToleranceMet(),
        finder.GetNotFiniteElements(),
        finder.GetUnboundedElements(),
        finder.GetInvertedElements(),
        finder.GetUndecidedElements(),
    )
