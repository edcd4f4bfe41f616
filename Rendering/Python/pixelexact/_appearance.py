"""How a cut is drawn: the settings of a mapper and its actor, by the names of the command-line tool."""

from __future__ import annotations

import math
from typing import Any, Optional, Sequence, Union

from vtkmodules.vtkCommonCore import vtkScalarsToColors
from vtkmodules.vtkCommonDataModel import vtkPlane

from ._scene import count_or_values, numbers_of
from ._work import errors_of

Limits = Union[None, str, Sequence[float]]
Color = Sequence[float]
Clip = Union[None, vtkPlane, Sequence[Union[vtkPlane, Sequence[float]]]]

_LIMITS = (
    "clim: 'cut', 'field', 'symmetric', 'symmetric-field', percentages as '1%,99%', or "
    "(lowest, highest)"
)


def color_of(color: Color, what: str) -> list[float]:
    """Red, green and blue."""
    values = numbers_of(color, what)
    if len(values) != 3 or not all(0.0 <= part <= 1.0 for part in values):
        raise ValueError(f"{what}: three numbers from 0 to 1, not {color!r}")
    return values


def _percentages(word: str) -> Optional[list[float]]:
    parts = word.split(",")
    if len(parts) != 2 or not all(part.endswith("%") for part in parts):
        return None
    try:
        return [float(part[:-1]) for part in parts]
    except ValueError:
        return None


def _set_found_range(mapper: Any, word: str) -> None:
    mapper.SetRangeSymmetric(word.startswith("symmetric"))
    percentages = _percentages(word)
    if word in ("cut", "symmetric", "symmetric-cut"):
        mapper.SetRangeModeToCut()
    elif word in ("field", "symmetric-field"):
        mapper.SetRangeModeToField()
    elif percentages and 0.0 <= percentages[0] < percentages[1] <= 100.0:
        mapper.SetRangePercentiles(percentages)
        mapper.SetRangeModeToPercentiles()
    else:
        raise ValueError(f"{_LIMITS}, not {word!r}")


def set_range(mapper: Any, clim: Limits) -> None:
    """Which values the ends of the colour map have."""
    if clim is None or isinstance(clim, str):  # arrays compare number by number
        _set_found_range(mapper, clim or "cut")
    elif (
        len(numbers_of(clim, _LIMITS)) != 2
        or not -math.inf < float(clim[0]) <= float(clim[1]) < math.inf
    ):
        raise ValueError(f"{_LIMITS}, not {clim!r}")
    else:
        mapper.SetScalarRange(float(clim[0]), float(clim[1]))


def set_colors(
    mapper: Any,
    actor: Any,
    cmap: Union[str, vtkScalarsToColors],
    color: Optional[Color],
    log: bool,
    bands: Optional[int],
) -> None:
    """The lookup table, or one colour in its place."""
    if isinstance(cmap, vtkScalarsToColors):
        mapper.SetLookupTable(cmap)
    else:
        with errors_of([mapper], "SetColorMap: ") as complaints:
            mapper.SetColorMap(cmap)
        if complaints:
            raise ValueError(f"cmap: {complaints[0]}")
    if log:
        if not hasattr(mapper.GetLookupTable(), "SetScaleToLog10"):
            raise ValueError("log: a vtkLookupTable or the name of a colour map, not this cmap")
        mapper.GetLookupTable().SetScaleToLog10()
    mapper.SetBands(bands or 0)
    if color is not None:
        mapper.ScalarVisibilityOff()
        actor.GetProperty().SetColor(color_of(color, "color"))


def set_undecided(
    mapper: Any,
    show_undecided: bool,
    undecided_color: Color,
    show_undecided_contours: bool,
    undecided_contour_color: Color,
) -> None:
    """Colours of pixels that are not proven."""
    mapper.SetShowUndecided(show_undecided)
    mapper.SetUndecidedColor(color_of(undecided_color, "undecided_color"))
    mapper.SetShowUndecidedContours(show_undecided_contours)
    mapper.SetUndecidedContourColor(color_of(undecided_contour_color, "undecided_contour_color"))


def set_lights(mapper: Any, actor: Any, lights: str) -> None:
    """On which surfaces a light shines."""
    actor.GetProperty().SetLighting(lights != "off")
    # Parts that face the viewer have exactly the colours of the map, as in the program.
    actor.GetProperty().SetAmbient(0.4)
    actor.GetProperty().SetDiffuse(0.6)
    mapper.SetLightFlat(lights == "on")


def set_edges(
    mapper: Any,
    actor: Any,
    edges: Union[bool, float],
    edge_color: Color,
    edges_by_kind: bool,
    outlines: bool,
    outline_color: Color,
) -> None:
    """Lines between elements."""
    if edges:
        actor.GetProperty().EdgeVisibilityOn()
        # Python's True is the tool's --edges.
        width = 1.5 if edges is True else numbers_of(edges, "edges")[0]
        actor.GetProperty().SetLineWidth(width)
        actor.GetProperty().SetEdgeColor(color_of(edge_color, "edge_color"))
    mapper.SetEdgesByKind(edges_by_kind)
    mapper.SetOutlines(outlines)
    mapper.SetOutlineColor(color_of(outline_color, "outline_color"))


def set_contours(
    mapper: Any,
    contours: Union[int, Sequence[float], None],
    contour_width: float,
    contour_color: Union[str, Color],
    contour_labels: Union[bool, int, None],
    contours_only: bool,
) -> None:
    """Iso-lines of the field on the surface."""
    count, values = count_or_values(contours)
    mapper.SetContourCount(count)
    for i, value in enumerate(values):
        mapper.SetContourValue(i, value)
    mapper.SetContourWidth(contour_width)
    if isinstance(contour_color, str):
        if contour_color != "map":
            raise ValueError(f"contour_color: (r, g, b) or 'map', not {contour_color!r}")
        mapper.ContourScalarVisibilityOn()
    else:
        mapper.SetContourColor(color_of(contour_color, "contour_color"))
    if contour_labels:
        mapper.ContourLabelsOn()
        mapper.SetContourLabelSize(12 if contour_labels is True else int(contour_labels))
    mapper.SetContoursOnly(contours_only)


def _plane_of(plane: Union[vtkPlane, Sequence[float]]) -> vtkPlane:
    if isinstance(plane, vtkPlane):
        return plane
    numbers = numbers_of(plane, "clip")
    if len(numbers) != 6 or not all(map(math.isfinite, numbers)) or not any(numbers[3:]):
        raise ValueError(
            "clip: planes of six numbers, a point and a normal that points to what stays, or "
            f"vtkPlanes, not {plane!r}"
        )
    made = vtkPlane()
    made.SetOrigin(numbers[:3])
    made.SetNormal(numbers[3:])
    return made


def set_clip(mapper: Any, clip: Clip) -> None:
    """Planes that cut away what lies behind them."""
    if clip is None:
        return
    planes: Sequence[Any] = [clip] if isinstance(clip, vtkPlane) else clip
    if len(planes) == 6 and not any(hasattr(part, "__len__") for part in planes):
        planes = [planes]
    for plane in planes:
        mapper.AddClippingPlane(_plane_of(plane))
