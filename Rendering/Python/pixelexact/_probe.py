"""Values at points."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Optional, Sequence, Union

from ._cut import field_of
from ._expressions import FieldName
from ._read import Warp
from ._scene import Vector, source_of
from ._warp import warped
from ._work import Progress, run
from .PixelExactFilters import vtkHighOrderProbe

if TYPE_CHECKING:
    import numpy

    Array = numpy.ndarray[Any, Any]

OUTSIDE, INSIDE, UNKNOWN = 0, 1, 2


class Probed:
    """What is known at n points; arrays are views of VTK's and not copies.

    field: its name. values: (n,), of vectors (n, components); NaN where a point is not inside.
    verdicts: 0 outside, 1 inside, 2 unknown. elements: cells of the source, -1 outside. xi: (n, 3),
    reference coordinates. gradients: on request, (n, 3), of vectors (n, components, 3). lower, upper:
    on request, as values: proven to hold the field's value. Not asked for: None.
    """

    def __init__(self, field: str, data: Any, components: int) -> None:
        from vtkmodules.util.numpy_support import vtk_to_numpy

        def array(name: str) -> Any:
            found = data.GetArray(name)
            return None if found is None else vtk_to_numpy(found)

        self.field = field
        self.values: Array = array(field)
        self.verdicts: Array = array("Verdict")
        self.elements: Array = array("Element")
        self.xi: Array = array("Xi")
        self.gradients: Optional[Array] = array(f"{field}_Gradient")
        self.lower: Optional[Array] = array(f"{field}_lower")
        self.upper: Optional[Array] = array(f"{field}_upper")
        if self.gradients is not None and components > 1:
            self.gradients = self.gradients.reshape(-1, components, 3)

    @property
    def inside(self) -> Array:
        """Whether each point is."""
        inside: Array = self.verdicts == INSIDE
        return inside

    def __len__(self) -> int:
        return len(self.verdicts)

    def __repr__(self) -> str:
        outside, inside, unknown = (int((self.verdicts == verdict).sum()) for verdict in range(3))
        return (
            f"<Probed {self.field!r} at {len(self)} points: {inside} inside, {outside} outside, "
            f"{unknown} unknown>"
        )


def _cloud(points: Any) -> Any:
    """The points as VTK's, which share an array of doubles (n, 3) that lie one behind the other."""
    import numpy
    from vtkmodules.util.numpy_support import numpy_to_vtk
    from vtkmodules.vtkCommonCore import vtkPoints
    from vtkmodules.vtkCommonDataModel import vtkPolyData

    if numpy.iscomplexobj(points):
        raise TypeError("points: real numbers, not complex ones")
    if numpy.ma.isMaskedArray(points):
        points = points.astype(numpy.float64).filled(numpy.nan)
    places = numpy.ascontiguousarray(points, dtype=numpy.float64)
    if places.ndim == 1 and places.shape == (3,):
        places = places.reshape(1, 3)
    if places.ndim != 2 or places.shape[1] != 3:
        raise ValueError(f"points: an array of shape (n, 3), not {places.shape}")
    shared = vtkPoints()
    shared.SetDataTypeToDouble()
    shared.SetData(numpy_to_vtk(places))
    cloud = vtkPolyData()
    cloud.SetPoints(shared)
    return cloud


def probe(
    grid: Any,
    field: Optional[FieldName] = None,
    points: Union[Array, Sequence[Sequence[float]], None] = None,
    *,
    gradients: bool = False,
    enclosures: bool = False,
    warp: Warp = None,
    warp_direction: Optional[Vector] = None,
    progress: Progress = None,
) -> Probed:
    """The exact values of a field at points (n, 3), in the order of these.

    grid: as of cut. field: None: the first one. points: an array of doubles that is contiguous is
    used as it is; a point that is not finite, or masked, is outside. enclosures: an interval for each value,
    20 to 50 times the cost of a value. warp, warp_direction: as of cut; points are those of the
    deformed mesh.

    progress: a function of the part that is done; what it raises, and KeyboardInterrupt, end the
    work. Other threads of Python run meanwhile. Raises Error where there is no such field.
    """
    if points is None:
        raise TypeError("probe: give points, an array of shape (n, 3)")
    source = warped(source_of(grid, progress), warp, warp_direction, progress)
    name = field_of(source, field)
    if name is None and hasattr(source, "GetHighOrderFieldName"):
        name = source.GetHighOrderFieldName(0)
    if not name:
        raise ValueError("field: name it")
    prober = vtkHighOrderProbe()
    cloud = _cloud(points)
    prober.SetInputData(cloud)
    prober.SetSourceData(source)
    prober.AddField(name)
    prober.SetComputeGradients(gradients)
    prober.SetEnclosures(enclosures)
    run(prober, progress)
    data = prober.GetOutputDataObject(0).GetPointData()
    return Probed(name, data, data.GetArray(name).GetNumberOfComponents())
