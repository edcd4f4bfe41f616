# SPDX-License-Identifier: BSD-3-Clause
"""Reads the table of settings, settings.json.

load() gives its rows with all that the table states once for several rows filled in. A row that
contradicts itself or has an unknown key is a ValueError. KEYS explains the keys of a row, and
Module/Documentation/how-to-add.md shows one.
"""

import json
import math
import re
from pathlib import Path

import colormaps
import formats

TABLE = Path(__file__).resolve().parent / "settings.json"

# The types of a setting, and the form in which the help shows a value without "form" or "unit".
FORMS = {
    "flag": "",
    "choice": "{choices}",
    "integer": "N",
    "integers": "none|n1,n2,...",
    "number": None,
    "number-if-any": None,
    "numbers": None,
    "color": "r,g,b",
    "size": "WxH[mm|in]",
    "text": None,
    "texts": None,
    "word-groups": None,
    "read": None,
}
KEYS = {
    "option": "names on the command line, the long one last; none: the row is no option",
    "type": "one of FORMS; `read` is a form of its own, which a function of the program reads",
    "commands": "a list of commands, or the name of a set; else those of the row's group",
    "common": "true, or commands, in whose --help the option is shown",
    "required": "true, or commands that need the option",
    "group": "filled in: the title of the row's group",
    "repeated": "whether the option may be given any number of times",
    "count": "how many numbers a value of type `numbers` has",
    "choices": "the words of a choice, or those of a text that completion offers; colormaps: the names of"
               " colormaps.json",
    "form": "what the help shows for the value",
    "unit": "the unit of a number, which is then its form",
    "min": "the smallest number", "max": "the largest number", "above": "an open lower limit",
    "default": "a number, a list, a word, or a text about the default",
    "default_note": "an exception to the default",
    "implied": "the number of a `number-if-any` where it is left out",
    "needs": "options without which this one is refused",
    "excludes": "options with which it is refused",
    "help": "one or two sentences; {min}, {max}, {implied}, {choices}, {suffixes} and"
            " {field_suffixes} of formats.json, and what FillHelp (Tools/Base) fills in",
    "layer": "the key of --layer",
    "tool_only": "why Python, VTK and ParaView have no such setting, as options.md states it",
    "vtk": "properties of VTK's classes: \"Class.Property\", or an object of VTK_KEYS",
    "python": "the keyword of pixelexact.cut or render",
    "python_default": "its default, where it differs from the option's",
    "python_help": "its text in the docstring, where it differs from the help",
}
# `type`, `min`, `max` and `default` are the row's where an entry has none.
VTK_KEYS = {"property", "type", "min", "max", "default", "paraview"}
PARAVIEW_KEYS = {
    "name": "the name of ParaView's property; else VTK's",
    "label": "its label; else the name in words",
    "advanced": "whether only the advanced panel shows it",
    "help": "its documentation; else the row's help",
    "written": "whether the representation's function is written by hand",
}


def load(path=TABLE):
    """The rows, in the order of the help. Each is a dictionary with all of KEYS."""
    table = json.loads(Path(path).read_text(encoding="utf-8"))
    sets = table["sets"]
    rows = []
    for group in table["groups"]:
        for given in group["settings"]:
            row = {"commands": group["commands"], "group": group["title"], **given}
            rows.append(_complete(row, sets))
    _check_references(rows)
    return rows


def vtk_only(path=TABLE):
    """Properties of VTK's classes that are no setting of tool or Python, and why, by
    "Class.Property"."""
    return json.loads(Path(path).read_text(encoding="utf-8"))["vtk_only"]


def name_of(row):
    """The long name of a row's option, or the Python keyword of a row without an option."""
    return row["option"].split(",")[-1] if row["option"] else row["python"]


def number_text(number):
    """A number as the help shows it: 32, 0.1, 1e-08."""
    return str(int(number)) if float(number).is_integer() else repr(float(number))


def limits_of(row):
    """The smallest and the largest number of a row; an open end is the next double inside."""
    lowest = row["min"] if row["min"] is not None else -math.inf
    if row["above"] is not None:
        lowest = math.nextafter(row["above"], math.inf)
    return lowest, row["max"] if row["max"] is not None else math.inf


def expected_of(row):
    """What a value must be, as messages state it; empty for values that only a function reads."""
    lowest, highest = row["min"], row["max"]
    if row["type"] == "flag":
        return "True or False"
    if row["type"] not in ("choice", "integer", "integers", "number", "number-if-any"):
        return ""
    if row["type"] == "choice":
        return "one of " + ", ".join(row["choices"])
    if row["type"] in ("integer", "integers"):
        span = f"from {number_text(lowest)} to {number_text(highest)}"
        if row["type"] == "integers":
            return f"'none' or integers {span} with commas between them"
        return f"a whole number {span}"
    if row["above"] is not None:
        more = f" and up to {number_text(highest)}" if highest is not None else ""
        return f"a number above {number_text(row['above'])}{more}"
    if lowest is not None and highest is not None:
        return f"a number from {number_text(lowest)} to {number_text(highest)}"
    return f"a number of {number_text(lowest)} or more" if lowest is not None else "a finite number"


def default_text(row):
    """The default as the help shows it; empty where there is none."""
    default = row["default"]
    if row["implied"] is not None:
        return f"{number_text(row['implied'])} where the number is left out"
    if default is None:
        return ""
    if isinstance(default, (int, float)):
        default = number_text(default)
    elif isinstance(default, list):
        default = ",".join(map(number_text, default))
    return f"{default} ({row['default_note']})" if row["default_note"] else default


def _complete(given, sets):
    unknown = set(given) - set(KEYS)
    row = {**dict.fromkeys(KEYS), **given}
    where = row["option"] or row["python"]
    if unknown or row["type"] not in FORMS or not row["help"]:
        raise ValueError(f"{where}: unknown keys {sorted(unknown)}, type {row['type']!r}, or no help")
    if row["tool_only"] and (row["vtk"] or row["python"]):
        raise ValueError(f"{where}: tool_only, and a setting of Python or VTK")
    row["commands"] = _commands(row["commands"], sets)
    for key in ("common", "required"):
        row[key] = row["commands"] if row[key] is True else _commands(row[key], sets)
        row[key] = [command for command in row[key] if command in row["commands"]]
    if row["choices"] == "colormaps":
        row["choices"] = colormaps.names()
    for key in ("choices", "needs", "excludes", "vtk"):
        row[key] = row[key] or []
    form = row["form"] or (row["unit"].upper() if row["unit"] else FORMS[row["type"]])
    if form is None and row["option"]:
        raise ValueError(f"{where}: a {row['type']} needs a form")
    row["form"] = (form or "").replace("{choices}", "|".join(row["choices"]))
    if row["type"] == "number-if-any":
        row["form"] = f"[{row['form']}]"
    row["vtk"] = [_complete_vtk(row, entry) for entry in row["vtk"]]
    for key in ("help", "python_help"):
        row[key] = _filled(row[key] or row["help"], row)
    return row


def _commands(names, sets):
    return sets[names] if isinstance(names, str) else names or []


def _complete_vtk(row, entry):
    given = {"property": entry} if isinstance(entry, str) else entry
    paraview = given.get("paraview")
    if set(given) - VTK_KEYS or set(paraview or {}) - set(PARAVIEW_KEYS):
        raise ValueError(f"{given['property']}: unknown keys")
    own = {key: row[key] for key in ("type", "min", "max", "default")} | given
    if own["type"] == "flag" and own["default"] is not True:
        own["default"] = False
    if paraview is not None:
        name = paraview.get("name", given["property"].split(".")[1])
        spaced = re.sub(r"(?<=[a-z])(?=[A-Z])", " ", name)
        own["paraview"] = {
            "name": name, "label": paraview.get("label", spaced),
            "advanced": paraview.get("advanced", False),
            "written": paraview.get("written", False),
            "help": paraview.get("help") or _filled(row["help"], row),
        }
    return own


def _filled(text, row):
    texts = {key: number_text(row[key]) for key in ("min", "max", "implied") if row[key] is not None}
    texts["choices"] = ", ".join(row["choices"])
    for key, value in (texts | formats.help_texts()).items():
        text = text.replace(f"{{{key}}}", value)
    return text


def _check_references(rows):
    for command in {command for row in rows for command in row["commands"]}:
        names = [name_of(row) for row in rows if command in row["commands"] and row["option"]]
        twice = {name for name in names if names.count(name) > 1}
        if twice:
            raise ValueError(f"{command}: several rows of {sorted(twice)}")
    known = {name_of(row) for row in rows}
    for row in rows:
        missing = set(row["needs"] + row["excludes"]) - known
        if missing:
            raise ValueError(f"{name_of(row)}: there is no {sorted(missing)}")
