"""What commands of the program make: figures, facts of a mesh, comparisons with linear pictures."""

from __future__ import annotations

import os
import tempfile
from pathlib import Path as FilePath
from typing import Any, Mapping, Optional

from ._read import Path
from ._tool import Input, run_tool, words_of

_SERIES = ("sweep", "turn")
# Options of files that are written beside the figure.
_OF_OTHER_FILES = ("buffers", "arrays", "contours_output", "contours_tolerance")
# Lines of a text that stand for fields.
_MAX_FIELDS = 5
# Facts that info finds on request.
_REQUESTED = ("jacobian", "extremes", "jumps", "norms", "warp_limit")


class Figure:
    """A figure: a picture with colour bars, axes and title. Notebooks display it.

    content: the bytes of the file. path: its name; None where none was asked for. report: what the
    program states with --json, such as pixels by verdict, ranges and camera. notes: texts about
    what it chose, and about lines that are no vectors.
    """

    def __init__(
        self,
        content: bytes,
        path: Optional[str],
        report: dict[str, Any],
        notes: list[str],
        scene: tuple[Input, Optional[str], dict[str, Any]],
    ) -> None:
        self.content = content
        self.path = path
        self.report = report
        self.notes = notes
        self._scene = scene
        self._suffix = os.path.splitext(path or "figure.png")[1].lower()
        self._png: Optional[bytes] = content if self._suffix == ".png" else None

    def __repr__(self) -> str:
        pixels = ", ".join(f"{count} {name}" for name, count in self.report["pixels"].items())
        name = f" '{self.path}'" if self.path is not None else ""
        return f"<Figure{name}, {len(self.content)} bytes; pixels: {pixels}>"

    def _repr_svg_(self) -> Optional[str]:
        return self.content.decode() if self._suffix == ".svg" else None

    def _repr_jpeg_(self) -> Optional[bytes]:
        return self.content if self._suffix in (".jpg", ".jpeg") else None

    def _repr_png_(self) -> Optional[bytes]:
        """Of a PDF or TIFF, which notebooks do not display, the same figure as PNG. It is drawn by
        the first call."""
        if self._png is None and self._suffix in (".pdf", ".tif", ".tiff"):
            grid, field, options = self._scene
            kept = {name: value for name, value in options.items() if name not in _OF_OTHER_FILES}
            self._png = figure(grid, field, **kept).content
        return self._png


def figure(
    grid: Input, field: Optional[str] = None, *, output: Optional[Path] = None, **options: Any
) -> Figure:
    """A figure as the program's `render --figure` draws it, with the same bytes.

    grid: a vtkUnstructuredGrid, the name of a file, or a list of names (a mesh and its fields). A
        grid is written to a temporary file. field: a field's name or an expression, as text.
    output: the file to write: .png, .pdf, .svg, .tiff or .jpg. None: a PNG that is kept in memory.
    options: those of the program's render, with underscores, or those of pixelexact.render that
        have the same values: plane="z=40%", contours=9, cmap="vik", clim="symmetric", size=(800,
        600) or "85x60mm", title="...". A list of texts gives an option several times.

    Raises Error, with the program's words, for what it refuses, and where there is no program;
    ValueError for animations.
    """
    series = [name for name in _SERIES if options.get(name) is not None]
    series += ["time_step"] * (options.get("time_step") == "all")
    if series:
        raise ValueError(f"{series[0]}: figure draws one figure; run the program for series and films")
    with tempfile.TemporaryDirectory(prefix="pixelexact-") as folder:
        file = os.path.join(folder, "figure.png") if output is None else os.fspath(output)
        words = words_of({"field": field, **options, "figure": True, "output": file})
        report, notes = run_tool("figure", "render", grid, words)
        content = FilePath(file).read_bytes()
    path = None if output is None else file
    return Figure(content, path, report, notes, (grid, field, options))


def _number(value: float) -> str:
    return f"{value:.6g}"


def _orders(counts: Mapping[str, int]) -> str:
    """The orders of a report, which counts elements by order."""
    orders = sorted(map(int, counts))
    if not orders:
        return "no order"
    return f"order {orders[0]}" + (f" to {orders[-1]}" if len(orders) > 1 else "")


def _counted(shape: str, count: int) -> str:
    if count == 1:
        return f"1 {shape}"
    return f"{count} " + (shape[:-2] + "a" if shape.endswith("hedron") else shape + "s")


class Info(dict[str, Any]):
    """Facts of a mesh by name, as the program's `info --json` states them. Its text has ten lines
    at most."""

    def __repr__(self) -> str:
        shapes = ", ".join(_counted(shape, count) for shape, count in self["shapes"].items())
        # Bounds computed from coefficients contain roundings in place of 0.
        least = 1e-12 * max(map(abs, self["bounds"]))
        bounds = [_number(value if abs(value) > least else 0.0) for value in self["bounds"]]
        sides = (f"{axis} {bounds[2 * i]} to {bounds[2 * i + 1]}" for i, axis in enumerate("xyz"))
        lines = [f"elements: {shapes or 'none'}; {_orders(self['geometry_orders'])}"]
        lines.append("bounds: " + ", ".join(sides))
        for field in self["fields"][:_MAX_FIELDS]:
            lines.append(f"field {self._field_text(field)}")
        others = [field["name"] for field in self["fields"][_MAX_FIELDS:]] + list(self["defined"])
        if others:
            lines.append("other fields: " + ", ".join(others))
        if self["times"]:
            first, last = (_number(self["times"][i]) for i in (0, -1))
            lines.append(f"times: {len(self['times'])}, {first} to {last}")
        asked = [name for name in _REQUESTED if name in self]
        return "\n".join(lines + (["also: " + ", ".join(asked)] if asked else []))

    @staticmethod
    def _field_text(field: Mapping[str, Any]) -> str:
        count = field["components"]
        kind = "scalar" if count == 1 else f"{count} components"
        text = f"{field['name']}: {kind}, {_orders(field['orders'])}"
        if field["continuity"] != "unknown":
            text += f", {field['continuity']}"
        ranges = field["ranges"]
        if count == 1 and ranges and ranges[0] is not None:
            text += f", values {_number(ranges[0][0])} to {_number(ranges[0][1])}"
        return text


def info(grid: Input, **options: Any) -> Info:
    """Facts of a mesh and its fields: the program's `info`.

    grid: as of figure. options: those of the program's info, with underscores: certify=True,
    extremes="u", jumps="u", norms=["u", "mag(grad(u))"], warp_limit="u", time_step=3; with norms,
    with_="other.vtu" adds a series and its slopes. Numbers that are not finite are None. Raises Error, with the program's words, for what it refuses, and where
    there is no program.
    """
    report, _ = run_tool("info", "info", grid, words_of(options))
    return Info(report)


class Comparison(dict[str, Any]):
    """What linear pictures cost and miss, or how far solutions are apart, by name, as the program's
    `compare --json` states it.

    rows: a dictionary for each setting (seconds, triangles, missing and invented pixels, errors) or,
    with several solutions, for each solution, or, with time_step="all", for each step. page: the path of report.html, which shows and
    explains them; None where solutions are compared, which gives pictures.
    """

    @property
    def rows(self) -> list[dict[str, Any]]:
        kinds = ("settings", "solutions", "steps")
        found: list[dict[str, Any]] = next((self[kind] for kind in kinds if kind in self), [])
        return found

    @property
    def page(self) -> Optional[str]:
        if "settings" not in self:
            return None
        return os.path.abspath(os.path.join(self["folder"], "report.html"))

    def __repr__(self) -> str:
        place = self.page or os.path.abspath(self.get("folder") or self["output"])
        return f"<Comparison, {len(self.rows)} rows: {place}>"


def compare(
    grid: Input, field: Optional[str] = None, *, output: Optional[Path] = None, **options: Any
) -> Comparison:
    """Linear pictures of a cut beside the exact one, in a report; or, with_ other solutions, the
    differences of these: the program's `compare`.

    grid, field: as of figure. output: the folder of the report, or the picture of one difference;
    None: as the program names it, in the current folder. options: those of the program's compare,
    with underscores: plane="z=0.1", resolutions=[16, 32], target_error=1e-4, with_="other.vtu", or
    with_=[["other.mesh", "u.gf"], ["another.vtu"]] for files of several solutions, and with_ and
    time_step="all" for each step. Raises Error, with
    the program's words, for what it refuses, and where there is no program.
    """
    words = words_of({"field": field, **options, "output": output})
    report, _ = run_tool("compare", "compare", grid, words)
    return Comparison(report)
