#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Writes what is made from the tables of settings, file formats and colour maps.

    generate.py cxx OUT.inc             the rows of the tool's options, for Tools/Base/Settings.cxx
    generate.py colormaps OUT.inc       the colour maps, for Rendering/Views/VtkColorMap.cxx
    generate.py formats OUT.inc         the rows of suffixes, for Tools/Input/FormatTable.cxx
    generate.py python OUT.py           the rows of Python's keywords, for pixelexact/_settings.py
    generate.py python-formats OUT.py   the texts of formats, for pixelexact/_read.py
    generate.py readers TEMPLATE.in OUT ParaView's readers, with the suffixes of <ReaderFactory reader="..."
                                        and the properties of <CellProperties />
    generate.py page PAGE.md            the tables of formats and colour maps, in place of those in files.md and
                                        command-line.md
    generate.py xml TEMPLATE.in OUT     ParaView's properties, in place of lines <Setting name="..."/>
    generate.py forwarders OUT.inc      the representation's functions that set these properties
    generate.py literal FILE OUT.inc    a text as string literals of C++, for the page of serve
"""

import json
import math
import pprint
import re
import sys
from pathlib import Path
from xml.sax.saxutils import escape

import colormaps
import formats
import settings

BEGIN_CXX = "// By Rendering/Settings/generate.py from {}.\n"


def cxx_string(text):
    for plain, escaped in (("\\", "\\\\"), ('"', '\\"'), ("\r", "\\r"), ("\n", "\\n")):
        text = text.replace(plain, escaped)
    return f'"{text}"'


def cxx_number(number):
    if math.isinf(number):
        return "kInfinity" if number > 0 else "-kInfinity"
    return repr(float(number))


def cxx_row(row):
    kind = "".join(word.capitalize() for word in row["type"].split("-"))
    default = row["default"]
    is_number = isinstance(default, (int, float)) and not isinstance(default, bool)
    lowest, highest = settings.limits_of(row)
    vtk = [entry["property"] for entry in row["vtk"]]
    texts = {
        "names": row["option"], "commands": " ".join(row["commands"]),
        "common": " ".join(row["common"]), "required": " ".join(row["required"]),
        "group": row["group"], "form": row["form"], "help": row["help"],
        "defaultText": settings.default_text(row), "expected": settings.expected_of(row),
        "choices": " ".join(row["choices"]), "needs": " ".join(row["needs"]),
        "excludes": " ".join(row["excludes"]),
        "implied": settings.number_text(row["implied"]) if row["implied"] is not None else "",
        "python": row["python"] or "", "vtk": " ".join(vtk), "layer": row["layer"] or "",
        "toolOnly": row["tool_only"] or "",
    }
    fields = {"type": f"SettingType::{kind}", "repeated": str(bool(row["repeated"])).lower()}
    fields |= {name: cxx_string(text) for name, text in texts.items()}
    fields["count"] = str(row["count"] or (3 if row["type"] == "color" else 0))
    fields["lowest"], fields["highest"] = cxx_number(lowest), cxx_number(highest)
    fields["initial"] = cxx_number(default) if is_number else "kNoNumber"
    return "  { " + ",\n    ".join(f".{name} = {text}" for name, text in fields.items()) + " },\n"


def write_cxx(out):
    rows = [cxx_row(row) for row in settings.load() if row["option"]]
    out.write_text(BEGIN_CXX.format("settings.json") + "".join(rows), encoding="utf-8")


def cxx_suffix(suffix, row, reader, has_mesh, is_folder):
    marks = ", ".join(map(cxx_string, row["marks"]))
    return (
        f"  {{ .suffix = {cxx_string(suffix)}, .name = {cxx_string(row['name'])},"
        f" .hasMesh = {str(has_mesh).lower()}, .mayBeFolder = {str(is_folder).lower()}, .read = &{reader},"
        f" .marks = {{ {marks} }} }},\n"
    )


def write_formats(out):
    rows = []
    for row in formats.load():
        rows += [cxx_suffix(suffix, row, row["reader"], True, False) for suffix in row["mesh"]]
        rows += [
            cxx_suffix(suffix, row, "RefuseFieldFile", False, row["field_folders"])
            for suffix in formats.own_fields(row)
        ]
    for row in formats.not_read():
        rows += [
            f"  {{ .suffix = {cxx_string(suffix)}, .name = {cxx_string(row['name'])},"
            f" .mayBeFolder = {str(row['folder']).lower()}, .remedy = {cxx_string(row['remedy'])} }},\n"
            for suffix in row["suffixes"]
        ]
    out.write_text(BEGIN_CXX.format("formats.json") + "".join(rows), encoding="utf-8")


def cxx_colors_name(row):
    return f"kColorsOf{row['name'][0].upper()}{row['name'][1:]}"


def cxx_colors(row):
    lines = [f"constexpr std::uint32_t {cxx_colors_name(row)}[] = {{"]
    for i in range(0, len(row["colors"]), 10):
        lines.append("  " + " ".join(f"0x{color}," for color in row["colors"][i : i + 10]))
    return "\n".join(lines) + "\n};\n"


def write_colormaps(out):
    colors = map(cxx_colors, colormaps.load())
    rows = []
    for row in colormaps.load():
        fields = [f'"{row["name"]}"', f"Between::{row['space'].capitalize()}", "0x" + row["nan"], cxx_colors_name(row)]
        rows.append(f"  {{ {', '.join(fields)} }},\n")
    table = "constexpr NamedMap kMaps[] = {\n" + "".join(rows) + "};\n"
    out.write_text(BEGIN_CXX.format("colormaps.json") + "".join(colors) + table, encoding="utf-8")


def write_python(out):
    rows = {}
    for row in settings.load():
        if row["python"]:
            lowest, highest = settings.limits_of(row)
            is_number = row["type"] in ("integer", "number")
            rows[row["python"]] = {
                "option": settings.name_of(row) if row["option"] else None, "type": row["type"], "help": row["python_help"], "choices": row["choices"],
                "limits": (lowest, highest) if is_number else None,
                "expected": settings.expected_of(row),
            }
    text = pprint.pformat(rows, width=100, sort_dicts=False)
    out.write_text(
        '"""The rows of settings.json that are keywords, by Rendering/Settings/generate.py."""\n\n'
        "from __future__ import annotations\n\nfrom typing import Any\n\n"
        f"ROWS: dict[str, dict[str, Any]] = {text}\n",
        encoding="utf-8",
    )


def format_text(row):
    """The line of a format in the docstring of pixelexact.read."""
    fields = formats.own_fields(row)
    suffixes = ", ".join(row["mesh"]) + (" with " + ", ".join(fields) if fields else "")
    return f"{suffixes}: {row['name']}. {row['help']}"


def write_python_formats(out):
    texts = pprint.pformat([format_text(row) for row in formats.load()], width=100)
    out.write_text(
        '"""The texts of the rows of formats.json, by Rendering/Settings/generate.py."""\n\n'
        f"from __future__ import annotations\n\nFORMATS: list[str] = {texts}\n",
        encoding="utf-8",
    )


# Properties of the readers of solvers' own files (vtkHighOrderFileReader).
CELL_PROPERTIES = """\
      <IntVectorProperty name="Cells"
                         command="SetCells"
                         animateable="0"
                         number_of_elements="1"
                         default_values="0">
        <EnumerationDomain name="enum">
          <Entry text="Lagrange" value="0" />
          <Entry text="Corners" value="1" />
        </EnumerationDomain>
        <Documentation>The cells that ParaView's own filters work on. Lagrange: of the degrees of geometry and
        fields, up to 10. Corners: linear cells between the vertices, which take the least memory; pictures of
        PixelExact are the same.</Documentation>
      </IntVectorProperty>
      <IdTypeVectorProperty name="MaximumNumberOfNodes"
                            label="Maximum Number Of Nodes"
                            command="SetMaximumNumberOfNodes"
                            animateable="0"
                            number_of_elements="1"
                            default_values="4000000"
                            panel_visibility="advanced">
        <Documentation>Above so many nodes the cells are linear, between the vertices, and a message says so.</Documentation>
      </IdTypeVectorProperty>
"""


def write_readers(template, out):
    hints = formats.paraview_hints()

    def filled(match):
        suffixes, description = hints.pop(match[1])
        words = " ".join(suffix.removeprefix(".") for suffix in suffixes)
        return f'<ReaderFactory extensions="{words}" file_description="{escape(description)}"'

    text = re.sub(r'<ReaderFactory reader="(\w+)"', filled, template.read_text(encoding="utf-8"))
    if hints:
        raise ValueError(f"{template} lacks the readers {sorted(hints)}")
    out.write_text(text.replace("      <CellProperties />\n", CELL_PROPERTIES), encoding="utf-8")


def write_page(page):
    text = page.read_text(encoding="utf-8")
    for table in (formats, colormaps):
        begin = text.find(table.PAGE_HEAD)
        if begin >= 0:
            text = text[:begin] + table.page_table() + text[text.index("\n\n", begin) + 1 :]
    page.write_text(text, encoding="utf-8")


def paraview_entries():
    """The VTK properties that ParaView shows, by ParaView's name."""
    entries = [entry for row in settings.load() for entry in row["vtk"] if entry.get("paraview")]
    return {entry["paraview"]["name"]: entry for entry in entries}


def xml_property(entry, indent):
    """One property of a proxy."""
    shown = entry["paraview"]
    kinds = {"flag": "Int", "integer": "Int", "number": "Double", "color": "Double"}
    kind = kinds[entry["type"]] + "VectorProperty"
    defaults = entry["default"] if isinstance(entry["default"], list) else [entry["default"]]
    attributes = {
        "name": shown["name"], "label": shown["label"],
        "command": "Set" + entry["property"].split(".")[1],
        "number_of_elements": len(defaults),
        "default_values": " ".join(settings.number_text(value) for value in defaults),
    }
    if shown["advanced"]:
        attributes["panel_visibility"] = "advanced"
    if entry["type"] == "color":
        attributes["panel_widget"] = "color_selector"
        domain = '<DoubleRangeDomain name="range" min="0 0 0" max="1 1 1" />'
    elif entry["type"] == "flag":
        domain = '<BooleanDomain name="bool" />'
    else:
        limits = [settings.number_text(entry[end]) for end in ("min", "max")]
        domain = f'<{kinds[entry["type"]]}RangeDomain name="range" min="{limits[0]}" max="{limits[1]}" />'
    between = "\n" + indent + " " * (len(kind) + 2)
    words = between.join(f'{name}="{escape(str(value))}"' for name, value in attributes.items())
    return (
        f"{indent}<{kind} {words}>\n{indent}  {domain}\n"
        f"{indent}  <Documentation>{escape(shown['help'])}</Documentation>\n{indent}</{kind}>\n"
    )


def write_xml(template, out):
    entries = paraview_entries()

    def filled(line):
        return xml_property(entries.pop(line[2]), line[1])

    text = re.sub(r'( *)<Setting name="(\w+)" />\n', filled, template.read_text(encoding="utf-8"))
    if entries:
        raise ValueError(f"{template} lacks the settings {sorted(entries)}")
    out.write_text(text, encoding="utf-8")


def forwarder(entry):
    name = entry["property"].split(".")[1]
    kinds = {"flag": "bool", "integer": "int", "number": "double"}
    if entry["type"] == "color":
        parameters, arguments = "double red, double green, double blue", "red, green, blue"
    else:
        parameters, arguments = kinds[entry["type"]] + " value", "value"
    return (
        f"void vtkPixelExactRepresentation::Set{name}({parameters})\n{{\n"
        f"  this->Data->Mapper->Set{name}({arguments});\n}}\n"
    )


def write_forwarders(out):
    plain = [entry for entry in paraview_entries().values() if not entry["paraview"]["written"]]
    text = BEGIN_CXX.format("settings.json") + "\n".join(map(forwarder, plain))
    out.write_text(text, encoding="utf-8")


def write_literal(source, out):
    """The text of a file as string literals of C++, one for each line. The compiler joins them."""
    lines = source.read_text(encoding="utf-8").splitlines()
    out.write_text("".join(json.dumps(line + "\n") + "\n" for line in lines), encoding="utf-8")


def main(what, *files):
    writers = {
        "cxx": write_cxx, "colormaps": write_colormaps, "formats": write_formats, "python": write_python,
        "python-formats": write_python_formats, "readers": write_readers, "page": write_page,
        "xml": write_xml, "forwarders": write_forwarders,
        "literal": write_literal,
    }
    writers[what](*map(Path, files))


if __name__ == "__main__":
    main(*sys.argv[1:])
