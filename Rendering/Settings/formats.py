# SPDX-License-Identifier: BSD-3-Clause
"""Reads the table of file formats, formats.json.

load() gives its rows, each with all of KEYS. A row that contradicts itself or has an unknown key is
a ValueError. Module/Documentation/how-to-add.md says what else a format needs.
"""

import functools
import json
from pathlib import Path

TABLE = Path(__file__).resolve().parent / "formats.json"

KEYS = {
    "name": "the format's name in messages",
    "mesh": "suffixes of files that hold a mesh",
    "fields": "suffixes of files that hold fields without a mesh; one that is also in `mesh` may hold either",
    "field_folders": "whether a folder may stand for a field file",
    "marks": "at most two texts at the beginning of its files, by which one with another suffix is recognised",
    "reader": "the tool's function in Tools/Input that reads the files",
    "paraview": "the proxy of the plugin's reader, a key of `paraview_readers`; none: the plugin has no reader",
    "paraview_suffixes": "the suffixes with which ParaView opens the reader; else those of `mesh`",
    "help": "one sentence about the files",
    "lost": "what is left out, changed or refused, for files.md",
    "tested": "which files were read in tests, and against which values, for files.md",
}
# The first lines of the table of formats in Module/Documentation/files.md.
PAGE_HEAD = (
    "| format | meshes | fields | reader in ParaView | files | left out, changed or refused | tested with |\n"
    "|---|---|---|---|---|---|---|\n"
)


@functools.cache
def load():
    """The rows, in the order in which messages list the suffixes."""
    table = _table()
    rows = [_complete(given, table["paraview_readers"]) for given in table["formats"]]
    suffixes = [suffix for row in rows for suffix in row["mesh"] + own_fields(row)]
    twice = {suffix for suffix in suffixes if suffixes.count(suffix) > 1}
    if twice:
        raise ValueError(f"several rows of {sorted(twice)}")
    return rows


def not_read():
    """The formats that are refused by name: name, suffixes, remedy, and whether a folder may be one."""
    rows = [{"folder": False, **given} for given in _table()["not_read"]]
    known = {suffix for row in load() for suffix in row["mesh"] + row["fields"]}
    for row in rows:
        if set(row) != {"name", "suffixes", "remedy", "folder"} or known & set(row["suffixes"]):
            raise ValueError(f"{row['name']}: unknown or missing keys, or a suffix that is read")
    return rows


def own_fields(row):
    """The suffixes of field files that no mesh file has."""
    return [suffix for suffix in row["fields"] if suffix not in row["mesh"]]


def help_texts():
    """What stands for {suffixes} and {field_suffixes} in the help of settings."""
    meshes = [suffix for row in load() for suffix in row["mesh"]]
    own = [_alternatives(own_fields(row)) for row in load() if own_fields(row)]
    shared = [suffix for row in load() for suffix in row["fields"] if suffix in row["mesh"]]
    fields = own + [f"{suffix} without a mesh" for suffix in shared]
    return {"suffixes": ", ".join(meshes), "field_suffixes": "; ".join(fields)}


def paraview_hints():
    """The suffixes and the description of the files that each of the plugin's readers opens."""
    descriptions = _table()["paraview_readers"]
    return {
        reader: (
            [suffix for row in load() if row["paraview"] == reader for suffix in row["paraview_suffixes"]],
            description,
        )
        for reader, description in descriptions.items()
    }


def page_table():
    """The table of formats in Markdown."""
    return PAGE_HEAD + "".join(map(_page_row, load()))


def _page_row(row):
    suffixes = (_code(row["mesh"]), _code(row["fields"]), _code(filter(None, [row["paraview"]])))
    return f"| {row['name']} | {' | '.join(suffixes)} | {row['help']} | {row['lost']} | {row['tested']} |\n"


def _code(words):
    return ", ".join(f"`{word}`" for word in words)


def _table():
    return json.loads(TABLE.read_text(encoding="utf-8"))


def _alternatives(words):
    return " or ".join(filter(None, [", ".join(words[:-1]), words[-1]]))


def _complete(given, paraview_readers):
    unknown = set(given) - set(KEYS)
    row = {**dict.fromkeys(KEYS), "fields": [], "field_folders": False, "marks": [], **given}
    needed = ("name", "mesh", "reader", "help", "lost", "tested")
    if unknown or not all(row[key] for key in needed):
        raise ValueError(f"{row['name']}: unknown keys {sorted(unknown)}, or one of {needed} is missing")
    if row["paraview"] and row["paraview"] not in paraview_readers:
        raise ValueError(f"{row['name']}: {row['paraview']} is none of paraview_readers")
    row["paraview_suffixes"] = row["paraview_suffixes"] or row["mesh"]
    if not set(row["paraview_suffixes"]) <= set(row["mesh"] + row["fields"]):
        raise ValueError(f"{row['name']}: paraview_suffixes has a suffix that the format lacks")
    return row
