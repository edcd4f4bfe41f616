"""Norms of fields over a mesh."""

from __future__ import annotations

from typing import Any, NamedTuple, Optional

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

from ._cut import field_of
from ._expressions import FieldName
from ._read import Warp
from ._scene import Vector, source_of
from ._warp import warped
from ._work import Progress, run
from .PixelExactFilters import vtkHighOrderNorms


class Norms(NamedTuple):
    """Norms of a field over a mesh. Integrals are numeric, with estimates of their errors."""

    volume: float
    """Of the mesh, as a check; of a plane mesh its area."""
    volume_error: float
    l1: float
    """The integral of abs(f), or of the Euclidean norm of a vector."""
    l1_error: float
    l2: float
    """The root of the integral of its square."""
    l2_error: float
    linf: tuple[float, float]
    """Proven: the largest abs(f) lies between these two; NaN where nothing is proven."""
    largest_sample: float
    """The largest abs(f) at the points of quadrature; numeric."""
    met: bool
    """Whether the estimates are at most 1e-6 of the integrals."""
    not_finite: int
    """Elements with a value that is not finite, which are left out."""
    folded: int
    """Elements with det J <= 0 at a point; abs(det J) is integrated."""
    most: int
    """The smallest number of elements that carry 90 % of the square of l2."""
    elements: dict[str, np.ndarray]
    """By element: Element (the number, in the file, of its cell), Volume, L1, L2, L2Error, Largest."""


def norms(
    grid: Any,
    field: Optional[FieldName] = None,
    *,
    warp: Warp = None,
    warp_direction: Optional[Vector] = None,
    progress: Progress = None,
) -> Norms:
    """L1, L2 and Linf of a field or an expression over the mesh, and over each element.

    grid, field, warp, warp_direction: as of cut. An error is a function, such as
    lambda u, x: u - numpy.sin(x). Raises Error for expressions with jumps or normals.
    """
    source = warped(source_of(grid, progress), warp, warp_direction, progress)
    finder = vtkHighOrderNorms()
    finder.SetInputData(source)
    name = field_of(source, field)
    if name is not None:
        finder.SetFieldName(name)
    run(finder, progress)
    table = finder.GetOutput()
    columns = (table.GetColumn(k) for k in range(table.GetNumberOfColumns()))
    return Norms(
        finder.GetVolume(),
        finder.GetVolumeError(),
        finder.GetL1(),
        finder.GetL1Error(),
        finder.GetL2(),
        finder.GetL2Error(),
        (finder.GetLinfLower(), finder.GetLinfUpper()),
        finder.GetLargestSample(),
        finder.GetToleranceMet(),
        finder.GetNotFiniteElements(),
        finder.GetFoldedElements(),
        finder.GetElementsWith90Percent(),
        {column.GetName(): vtk_to_numpy(column) for column in columns},
    )
