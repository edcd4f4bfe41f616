# SPDX-License-Identifier: BSD-3-Clause
"""Reads the table of colour maps, colormaps.json.

load() gives its rows, each with all of KEYS. A row that contradicts itself or has an unknown key is
a ValueError.
"""

import functools
import json
import re
from pathlib import Path

TABLE = Path(__file__).resolve().parent / "colormaps.json"

KEYS = {
    "name": "the name of --colormap; with _r after it, the map is reversed",
    "kind": "one of KINDS",
    "space": "where colours are interpolated: one of SPACES",
    "step": "the colours are the published ones of the indices 0, step, ..., 255; none: no table is published",
    "nan": "the colour of NaN, which is not in the map; else gray",
    "source": "authors, year and licence",
    "use": "for which values or viewers the map is made",
    "colors": "rrggbb, with blanks between them, at equal steps over the range",
}
KINDS = ("sequential", "diverging", "cyclic", "rainbow")
# CIELAB, K. Moreland's space of diverging maps, RGB.
SPACES = ("lab", "diverging", "rgb")
# The first lines of the table of colour maps in Module/Documentation/command-line.md.
PAGE_HEAD = "| map | kind | use | source |\n|---|---|---|---|\n"


@functools.cache
def load():
    """The rows, in the order in which messages list the names."""
    rows = [_complete(given) for given in json.loads(TABLE.read_text(encoding="utf-8"))["colormaps"]]
    names = [row["name"] for row in rows]
    if len(set(names)) < len(names):
        raise ValueError(f"colour maps of one name: {names}")
    return rows


def names():
    return [row["name"] for row in load()]


def page_table():
    """The table of colour maps in Markdown."""
    lines = (f"| `{row['name']}` | {row['kind']} | {row['use']} | {row['source']} |\n" for row in load())
    return PAGE_HEAD + "".join(lines)


def _complete(given):
    row = {**dict.fromkeys(KEYS), "nan": "808080", **given}
    row["colors"] = " ".join(row["colors"]).split()
    wrong = [color for color in [*row["colors"], row["nan"]] if not re.fullmatch("[0-9a-f]{6}", color)]
    if set(row) != set(KEYS) or row["kind"] not in KINDS or row["space"] not in SPACES or wrong:
        raise ValueError(f"{row['name']}: unknown keys, kind or space, or colours that are no rrggbb: {wrong}")
    if len(row["colors"]) < 2 or row["step"] and len(row["colors"]) != 1 + 255 // row["step"]:
        raise ValueError(f"{row['name']}: {len(row['colors'])} colours do not fit the step {row['step']}")
    return row
