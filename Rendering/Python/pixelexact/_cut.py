"""Cuts for windows: an actor and its scalar bar."""

from __future__ import annotations

from typing import Any, Optional, Sequence, Union

from vtkmodules.vtkCommonCore import vtkScalarsToColors
from vtkmodules.vtkRenderingAnnotation import vtkScalarBarActor
from vtkmodules.vtkRenderingCore import vtkActor

from ._appearance import (
    Clip,
    Color,
    Limits,
    set_clip,
    set_colors,
    set_contours,
    set_edges,
    set_lights,
    set_range,
    set_undecided,
)
from ._expressions import FieldName, expression_of
from ._picture import Cut
from ._read import Warp
from ._scene import (
    Normal,
    Surface,
    Vector,
    component_of,
    source_of,
    surface_of,
)
from ._settings import check, documented
from ._warp import warped
from ._work import Error, Progress, errors_of
from .PixelExactDataModel import vtkHighOrderGrid
from .PixelExactRendering import (
    vtkHighOrderBoundarySurface,
    vtkHighOrderMapper,
    vtkHighOrderSurface,
)


def _fields_of(source: Any) -> list[str]:
    if not hasattr(source, "GetNumberOfHighOrderFields"):
        return []  # for composite data, the mapper checks the name
    return [source.GetHighOrderFieldName(i) for i in range(source.GetNumberOfHighOrderFields())]


def rank_in(source: Any, name: str) -> Optional[int]:
    """The tensor rank of a grid's field, also of a defined one; None if there is no such field."""
    if not hasattr(source, "GetHighOrderFieldComponents"):
        return None
    defined = source.GetFieldData().HasArray(f"PixelExact.Definition.{name}")
    if not defined and name not in _fields_of(source):
        return None
    components = source.GetHighOrderFieldComponents(f'"{name}"')
    return 2 if components == 9 else min(components - 1, 1)


def field_of(source: Any, field: Optional[FieldName]) -> Optional[str]:
    """The field's name or expression. Raises Error if it is neither a field of a grid nor an
    expression of its fields. For composite data, the mapper reports such errors."""
    name = expression_of(field, lambda of: rank_in(source, of))
    names = _fields_of(source)
    if name is not None and names and name not in names:
        with errors_of([source], "") as errors:
            source.GetHighOrderFieldComponents(name)
        if errors:
            raise Error(errors[0])
    return name


def _bar_of(mapper: Any, title: str) -> Any:
    bar = vtkScalarBarActor()
    bar.SetLookupTable(mapper.GetLookupTable())
    bar.SetTitle(title)
    bar.SetMaximumWidthInPixels(80)
    bar.SetUnconstrainedFontSize(True)
    for text in (bar.GetTitleTextProperty(), bar.GetLabelTextProperty()):
        text.SetFontSize(16)
        text.SetColor(0.5, 0.5, 0.5)  # visible on white and on black
        text.ItalicOff()
        text.BoldOff()
        text.ShadowOff()
    return bar


@documented
def cut(
    grid: Any,
    field: Optional[FieldName] = None,
    *,
    normal: Normal = "z",
    origin: Union[float, Vector, None] = None,
    surface: Surface = None,
    component: Union[int, str, None] = None,
    clim: Limits = None,
    cmap: Union[str, vtkScalarsToColors] = "viridis",
    color: Optional[Color] = None,
    log: bool = False,
    bands: Optional[int] = None,
    lights: str = "curved",
    samples: int = 1,
    contours: Union[int, Sequence[float], None] = None,
    contour_width: float = 1.5,
    contour_color: Union[str, Color] = (0.0, 0.0, 0.0),
    contour_labels: Union[bool, int, None] = None,
    contours_only: bool = False,
    show_undecided_contours: bool = False,
    undecided_contour_color: Color = (0.0, 0.5, 0.5),
    show_undecided: bool = False,
    undecided_color: Color = (1.0, 0.0, 0.5),
    edges: Union[bool, float] = False,
    edge_color: Color = (0.4, 0.4, 0.4),
    edges_by_kind: bool = False,
    outlines: bool = False,
    outline_color: Color = (0.0, 0.0, 0.0),
    clip: Clip = None,
    opacity: float = 1.0,
    warp: Warp = None,
    warp_direction: Optional[Vector] = None,
    progress: Progress = None,
) -> Cut:
    """A cut through a field: an actor, every pixel of which is the field's own value, and its bar.

    grid: a vtkUnstructuredGrid, also a plain one or PyVista's, composite data of such, or a file's
        name. field: its name, or an expression of fields as text or as a function of what its
        arguments are named after (lambda u, x: u - numpy.sin(x)); None: the first one.
    normal, origin: of the plane; "x", "y", "z", "-z" or three numbers; a point, a coordinate along
        the axis, or None: the middle of the box, or all of a mesh that is a surface in space.
        surface instead: a vtkImplicitFunction, a vtkHighOrderSurface (boundary, iso-surface,
        patches), or a function that takes points (n, 3) and is 0 on the surface.
    {settings}

    Raises Error, TypeError or ValueError, which name what is wrong.
    """
    check(
        log=log,
        lights=lights,
        samples=samples,
        contour_width=contour_width,
        contours_only=contours_only,
        show_undecided_contours=show_undecided_contours,
        show_undecided=show_undecided,
        edges_by_kind=edges_by_kind,
        outlines=outlines,
        opacity=opacity,
    )
    if bands is not None:
        check(bands=bands)
    source = warped(source_of(grid, progress), warp, warp_direction, progress)
    name = field_of(source, field)
    mapper = vtkHighOrderMapper()
    mapper.SetInputData(source)
    if name is not None:
        mapper.SetFieldName(name)
    mapper.SetComponent(component_of(component))
    if surface is None and origin is None and vtkHighOrderGrid.IsSurfaceInSpace(source):
        surface = vtkHighOrderBoundarySurface()
    shape = surface_of(surface, mapper.GetBounds(), normal, origin)
    if isinstance(shape, vtkHighOrderSurface):
        mapper.SetSurface(shape)
    else:
        mapper.SetCutFunction(shape)
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetOpacity(opacity)
    set_colors(mapper, actor, cmap, color, log, bands)
    set_range(mapper, clim)
    set_lights(mapper, actor, lights)
    set_edges(mapper, actor, edges, edge_color, edges_by_kind, outlines, outline_color)
    set_contours(
        mapper, contours, contour_width, contour_color, contour_labels, contours_only
    )
    set_undecided(
        mapper, show_undecided, undecided_color, show_undecided_contours, undecided_contour_color
    )
    set_clip(mapper, clip)
    mapper.SetSamples(samples)
    bar = _bar_of(mapper, name or (_fields_of(source) or [""])[0])
    return Cut(actor, bar, mapper, shape)
