"""Deformed meshes."""

from __future__ import annotations

import math
from typing import Any, NamedTuple, Optional

from ._read import Warp, as_high_order
from ._scene import Vector, source_of, three
from ._work import Progress, run
from .PixelExactFilters import vtkHighOrderWarp


class WarpLimit(NamedTuple):
    """Scales up to which a deformed mesh is proven valid."""

    valid: float
    """det J of all elements is proven positive for scales between 0 and this."""
    inverted: float
    """det J is proven not to be positive at this scale; inf where no such scale was found."""
    cell: int
    """The number, in the file, of the cell where it is not; -1: none."""
    xi: tuple[float, float, float]
    """The reference point there; NaN: none."""
    left_out: int
    """Elements that are not proven valid without a displacement, which have no limit."""


def _filter(
    grid: Any, field: str, scale: float, direction: Optional[Vector], progress: Progress
) -> vtkHighOrderWarp:
    if not isinstance(field, str):
        raise TypeError(f"field: the name of the displacement, not {field!r}")
    if not math.isfinite(scale):
        raise ValueError(f"scale: a finite number, not {scale!r}")
    made = vtkHighOrderWarp()
    made.SetInputData(source_of(grid, progress))
    made.SetFieldName(field)
    made.SetScaleFactor(scale)
    if direction is not None:
        vector = three(direction, "direction")
        if not any(vector):
            raise ValueError("direction: it must not be zero")
        made.SetDirection(*vector)
    return made


def warp_limit(
    grid: Any,
    field: str,
    *,
    negative: bool = False,
    direction: Optional[Vector] = None,
    progress: Progress = None,
) -> WarpLimit:
    """The scales up to which warp(grid, field, scale) is proven to invert no element.

    grid, field, direction: as of warp. negative: of negative scales, as the results are then. The two scales differ by at most 1e-6 of the upper one where
    the work budget of 20,000 boxes suffices. Raises Error as warp does.
    """
    made = _filter(grid, field, -1.0 if negative else 1.0, direction, progress)
    made.FindLimitOn()
    run(made, progress)
    return WarpLimit(
        made.GetValidScale(),
        made.GetInvertedScale(),
        made.GetInvertedCell(),
        made.GetInvertedPoint(),
        made.GetElementsWithoutLimit(),
    )


def warp(
    grid: Any,
    field: str,
    scale: float = 1.0,
    *,
    direction: Optional[Vector] = None,
    progress: Progress = None,
) -> Any:
    """The grid with the map x + scale * field, exactly; other fields are the same functions of xi.

    grid: as of cut; it stays as it is. field: a continuous vector field, "vec(u,v,w)" of scalar
    fields or 0, or a scalar field with a direction, which is not normalised. Derivatives in
    expressions are those by the deformed coordinates. H(curl), H(div) and density fields are left
    out, with a RuntimeWarning.

    Raises Error for other expressions and for discontinuous or mapped displacements.
    """
    filter_ = _filter(grid, field, scale, direction, progress)
    run(filter_, progress)
    result = filter_.GetOutputDataObject(0)
    return result if result.IsA("vtkCompositeDataSet") else as_high_order(result)


def warped(
    grid: Any, given: Warp, direction: Optional[Vector] = None, progress: Progress = None
) -> Any:
    """A grid deformed as the keywords warp and warp_direction state; None: as it is."""
    if given is None:
        if direction is not None:
            raise ValueError("warp_direction has no effect without warp: leave it out")
        return grid
    if isinstance(given, str):
        field, equals, text = given.rpartition("=")
        try:
            pair = (field, float(text)) if equals else (given, 1.0)
        except ValueError:
            raise ValueError(f"warp: 'FIELD', 'FIELD=SCALE' or (field, scale), not {given!r}") from None
    else:
        try:
            name, number = given
            pair = (name, float(number))
        except (TypeError, ValueError):
            raise TypeError(f"warp: 'FIELD', 'FIELD=SCALE' or (field, scale), not {given!r}") from None
    return warp(grid, *pair, direction=direction, progress=progress)
