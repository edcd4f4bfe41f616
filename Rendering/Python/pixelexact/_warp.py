"""Deformed meshes."""

from __future__ import annotations

import math
from typing import Any, Optional

from ._read import Warp, as_high_order
from ._scene import Vector, source_of, three
from ._work import Progress, run
from .PixelExactFilters import vtkHighOrderWarp


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
    if not isinstance(field, str):
        raise TypeError(f"field: the name of the displacement, not {field!r}")
    if not math.isfinite(scale):
        raise ValueError(f"scale: a finite number, not {scale!r}")
    filter_ = vtkHighOrderWarp()
    filter_.SetInputData(source_of(grid, progress))
    filter_.SetFieldName(field)
    filter_.SetScaleFactor(scale)
    if direction is not None:
        vector = three(direction, "direction")
        if not any(vector):
            raise ValueError("direction: it must not be zero")
        filter_.SetDirection(*vector)
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
