"""Integrals, norms, extremes and statistics over surfaces."""

from __future__ import annotations

from typing import Any, NamedTuple, Optional, Sequence, Union

from ._contours import _bounds_of
from ._cut import field_of
from ._expressions import FieldName
from ._read import Warp
from ._scene import Normal, Vector, source_of, surface_of
from ._warp import warped
from ._work import Error, Progress, run
from .PixelExactDataModel import vtkHighOrderGrid
from .PixelExactFilters import vtkHighOrderIntegrate


class Enclosed(NamedTuple):
    """A number with proven bounds (NaN and infinite where nothing is proven)."""

    value: float
    error: float
    """A bound of the error of value."""
    lower: float
    upper: float


class Integrals(dict[str, Enclosed]):
    """Numbers by name, as the rows of the program's integrate: Area, Integral, Mean, ..."""

    minimum_point: Optional[tuple[float, float, float]] = None
    maximum_point: Optional[tuple[float, float, float]] = None
    met: bool = False
    """Whether the errors of the integrals are within the tolerance."""


def integrate(
    grid: Any,
    field: Optional[FieldName] = None,
    *,
    normal: Normal = "z",
    origin: Union[float, Vector, None] = None,
    surface: Any = None,
    boundary: Union[bool, Sequence[int]] = False,
    norms: bool = False,
    extremes: bool = False,
    statistics: int = 0,
    correlate: Optional[FieldName] = None,
    tolerance: float = 1e-8,
    seconds: float = 0.0,
    warp: Warp = None,
    warp_direction: Optional[Vector] = None,
    progress: Progress = None,
) -> Integrals:
    """Area, integral, mean and flux of a field over a surface, with proven errors.

    grid, field, normal, origin, warp, warp_direction: as of cut; surface: a vtkImplicitFunction.
    boundary: True for all of the mesh's boundary, or attributes of its parts; a mesh that is a
    surface in space is its boundary. norms adds L1, L2 and Linf; extremes Minimum and Maximum, whose
    points are attributes of the result; statistics a number of classes: Variance, Deviation,
    quantiles ("Quantile 0.5") and the parts of the area in the classes ("Class 1"); correlate another
    scalar: Correlation. tolerance: of errors, relative to the integral of the magnitude. seconds: a
    limit of the time; 0: none.
    """
    source = warped(source_of(grid, progress), warp, warp_direction, progress)
    name = field_of(source, field)
    work = vtkHighOrderIntegrate()
    work.SetInputData(source)
    if surface is None and origin is None and vtkHighOrderGrid.IsSurfaceInSpace(source):
        boundary = boundary or True
    if boundary is False:
        shape = surface_of(surface, _bounds_of(source), normal, origin)
        if not shape.IsA("vtkImplicitFunction"):
            raise Error("integrate: a surface is a vtkImplicitFunction; cut draws on all")
        work.SetCutFunction(shape)
    else:
        if surface is not None or origin is not None:
            raise ValueError("boundary: leave out surface and origin")
        for attribute in [] if boundary is True else boundary:
            work.AddBoundaryAttribute(attribute)
    if name is not None:
        work.SetFieldName(name)
    work.SetNorms(norms)
    work.SetExtremes(extremes)
    if statistics and statistics < 2:
        raise ValueError(f"statistics: a number of classes from 2, not {statistics}")
    work.SetStatisticsClasses(statistics)
    if correlate is not None:
        work.SetCorrelateWith(field_of(source, correlate))
    work.SetTolerance(tolerance)
    work.SetSeconds(seconds)
    run(work, progress)
    table = work.GetOutput()
    columns = [table.GetColumnByName(part) for part in ("Value", "ErrorBound", "Lower", "Upper")]
    found = Integrals()
    for i in range(table.GetNumberOfRows()):
        found[table.GetColumnByName("Quantity").GetValue(i)] = Enclosed(
            *(column.GetValue(i) for column in columns)
        )
    found.met = work.GetToleranceMet()
    if extremes:
        found.minimum_point = work.GetMinimumPoint()
        found.maximum_point = work.GetMaximumPoint()
    return found
