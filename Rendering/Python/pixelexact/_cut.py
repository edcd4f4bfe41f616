"""Cuts for windows: an actor and its scalar bar."""

from __future__ import annotations

import math
from typing import Any, Optional, Sequence, Union

from vtkmodules.vtkCommonCore import vtkScalarsToColors
from vtkmodules.vtkRenderingAnnotation import vtkScalarBarActor
from vtkmodules.vtkRenderingCore import vtkActor

from ._expressions import FieldName, expression_of
from ._picture import Cut
from ._scene import (
    Normal,
    Surface,
    Vector,
    component_of,
    count_or_values,
    numbers_of,
    source_of,
    surface_of,
)
from ._work import Error, Progress, errors_of
from .PixelExactRendering import vtkHighOrderMapper, vtkHighOrderSurface

Limits = Union[None, str, Sequence[float]]


def _fields_of(source: Any) -> list[str]:
    if not hasattr(source, "GetNumberOfHighOrderFields"):
        return []  # composite data: the mapper knows
    return [source.GetHighOrderFieldName(i) for i in range(source.GetNumberOfHighOrderFields())]


def rank_in(source: Any, name: str) -> Optional[int]:
    """The number of indices of a field of a grid, defined ones too; None where there is none."""
    if not hasattr(source, "GetHighOrderFieldComponents"):
        return None
    defined = source.GetFieldData().HasArray(f"PixelExact.Definition.{name}")
    if not defined and name not in _fields_of(source):
        return None
    components = source.GetHighOrderFieldComponents(f'"{name}"')
    return 2 if components == 9 else min(components - 1, 1)


def field_of(source: Any, field: Optional[FieldName]) -> Optional[str]:
    """The field's name or expression. Raises Error for what is neither a field of a grid nor an
    expression of its fields; of composite data the classes themselves tell."""
    name = expression_of(field, lambda of: rank_in(source, of))
    names = _fields_of(source)
    if name is not None and names and name not in names:
        with errors_of([source], "") as errors:
            source.GetHighOrderFieldComponents(name)
        if errors:
            raise Error(errors[0])
    return name


def _set_range(mapper: Any, clim: Limits) -> None:
    word = clim if isinstance(clim, str) else None  # arrays compare number by number
    if clim is None or word == "cut":
        mapper.SetRangeModeToCut()
    elif word == "field":
        mapper.SetRangeModeToField()
    elif (
        word is not None
        or len(numbers_of(clim, "clim: 'field', 'cut' or two")) != 2
        or not -math.inf < float(clim[0]) <= float(clim[1]) < math.inf
    ):
        raise ValueError(f"clim: 'field', 'cut' or (lowest, highest), not {clim!r}")
    else:
        mapper.SetScalarRange(float(clim[0]), float(clim[1]))


def _set_colors(mapper: Any, cmap: Union[str, vtkScalarsToColors]) -> None:
    if isinstance(cmap, vtkScalarsToColors):
        mapper.SetLookupTable(cmap)
        return
    with errors_of([mapper], "SetColorMap: ") as complaints:
        mapper.SetColorMap(cmap)
    if complaints:
        raise ValueError(f"cmap: {complaints[0]}")


def _bar_of(mapper: Any, title: str) -> Any:
    bar = vtkScalarBarActor()
    bar.SetLookupTable(mapper.GetLookupTable())
    bar.SetTitle(title)
    bar.SetMaximumWidthInPixels(80)
    bar.SetUnconstrainedFontSize(True)
    for text in (bar.GetTitleTextProperty(), bar.GetLabelTextProperty()):
        text.SetFontSize(16)
        text.SetColor(0.5, 0.5, 0.5)  # seen on white and on black
        text.ItalicOff()
        text.BoldOff()
        text.ShadowOff()
    return bar


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
    contours: Union[int, Sequence[float], None] = None,
    edges: Union[bool, float] = False,
    opacity: float = 1.0,
    progress: Progress = None,
) -> Cut:
    """A cut through a field: an actor, every pixel of which is the field's own value, and its bar.

    grid: a vtkUnstructuredGrid, also a plain one or PyVista's, composite data of such, or a file's
        name. field: its name, or an expression of fields as text or as a function of what its
        arguments are named after (lambda u, x: u - numpy.sin(x)); None: the first one.
    normal, origin: of the plane; "x", "y", "z", "-z" or three numbers; a point, a coordinate along
        the axis, or None: the middle of the box. surface instead: a vtkImplicitFunction, a
        vtkHighOrderSurface (boundary, iso-surface, patches), or a function that takes points (n, 3)
        and is 0 on the surface.
    component: of vectors: None or "magnitude", "x", "y", "z", a number from 0.
    clim: "cut" (None): of what a view shows, found anew for each view; "field": proven to hold all
        values of the field over the mesh, the same from wherever one looks; (low, high).
    cmap: viridis, inferno, plasma, coolwarm, jet, rainbow, grayscale, or a vtkScalarsToColors.
    contours: how many, so many round values strictly inside the range of the colours; or a list
        of values ([1] is the value 1). edges: lines between elements, True or their width in pixels.

    Raises Error, TypeError or ValueError, which name what is wrong.
    """
    source = source_of(grid, progress)
    name = field_of(source, field)
    mapper = vtkHighOrderMapper()
    mapper.SetInputData(source)
    if name is not None:
        mapper.SetFieldName(name)
    mapper.SetComponent(component_of(component))
    _set_colors(mapper, cmap)
    shape = surface_of(surface, mapper.GetBounds(), normal, origin)
    if isinstance(shape, vtkHighOrderSurface):
        mapper.SetSurface(shape)
    else:
        mapper.SetCutFunction(shape)
    _set_range(mapper, clim)
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetOpacity(opacity)
    if edges:
        actor.GetProperty().EdgeVisibilityOn()
        actor.GetProperty().SetLineWidth(1.0 if edges is True else numbers_of(edges, "edges")[0])
    count, values = count_or_values(contours)
    mapper.SetContourCount(count)
    for i, value in enumerate(values):
        mapper.SetContourValue(i, value)
    bar = _bar_of(mapper, name or (_fields_of(source) or [""])[0])
    return Cut(actor, bar, mapper, shape)
