# SPDX-License-Identifier: BSD-3-Clause
"""The tables of settings and file formats, and what is made from them: help, reference, readers."""

import fcntl
import os
import pty
import re
import struct
import subprocess
import sys
import termios
import unittest
from pathlib import Path
from unittest import mock
from xml.etree import ElementTree

from tool import DATA, MIDDLE, TOOL, ToolTest, case

ROOT = DATA.parent
sys.path.insert(0, str(ROOT / "Rendering" / "Settings"))
import colormaps  # noqa: E402
import formats  # noqa: E402
import settings  # noqa: E402

PAGE = ROOT / "Module" / "Documentation" / "options.md"
COMMANDS = ["info", "probe", "render", "bench", "compare", "integrate", "view", "serve"]


def options_in(text):
    """The long names of the options that a help lists."""
    return re.findall(r"^  (?:-\w,)?(--[a-z][a-z-]+)", text, re.MULTILINE)


class Help(ToolTest):
    def test_short_help_has_the_common_options(self):
        for command in COMMANDS:
            rows = [row for row in settings.load() if command in row["common"]]
            text = self.succeeds(command, "--help").stdout
            common = [settings.name_of(row) for row in rows if row["option"] != "INPUT"]
            self.assertEqual(options_in(text), common)
            self.assertLessEqual(len(common), 14)
            self.assertIn(f"pixelexact {command} --help-all", text.splitlines()[-1])
        self.assertIn("--help-all", self.succeeds("--help").stdout.splitlines()[-1])

    def test_whole_help_has_all_options_by_group(self):
        program = self.succeeds("--help-all").stdout
        for command in COMMANDS:
            text = self.succeeds(command, "--help-all").stdout
            rows = [row for row in settings.load() if command in row["commands"] and row["option"]]
            own = [settings.name_of(row) for row in rows if row["option"] != "INPUT"]
            self.assertEqual(options_in(text), own + ["--help", "--help-all", "--version"])
            groups = re.findall(r"^(\w.*):$", text, re.MULTILINE)
            self.assertEqual(len(groups), len(set(groups)))
            self.assertIn(text.split("\n", 1)[1], program)

    def check_width(self, text, width):
        lines = text.splitlines()
        for line in lines:
            # A form, or a word, that is longer than the line stays whole.
            self.assertTrue(len(line) <= width or " " not in line.strip() or line.startswith("  -"), line)
        self.assertGreater(max(map(len, lines)), width - 12)

    def test_columns(self):
        for width in (60, 132):
            with mock.patch.dict(os.environ, {"COLUMNS": str(width)}):
                self.check_width(self.succeeds("render", "--help-all").stdout, width)
        with mock.patch.dict(os.environ, {"COLUMNS": ""}):
            self.check_width(self.succeeds("render", "--help-all").stdout, 100)

    def test_the_width_of_a_terminal(self):
        parent, child = pty.openpty()
        fcntl.ioctl(child, termios.TIOCSWINSZ, struct.pack("HHHH", 24, 72, 0, 0))
        environment = {name: value for name, value in os.environ.items() if name != "COLUMNS"}
        with subprocess.Popen([TOOL, "info", "--help"], stdout=child, env=environment):
            os.close(child)
            text = ""
            while True:
                try:
                    part = os.read(parent, 4096)
                except OSError:  # the other end is closed
                    break
                if not part:
                    break
                text += part.decode()
        os.close(parent)
        self.check_width(text.replace("\r", ""), 72)


class Table(ToolTest):
    def test_the_reference_of_options(self):
        """Where it fails: pixelexact --completion markdown > Module/Documentation/options.md."""
        page = self.succeeds("--completion", "markdown").stdout
        self.assertEqual(PAGE.read_text(encoding="utf-8"), page)
        self.assertNotRegex(page, r"\{\w+\}")

    def test_keys_of_layers(self):
        done = self.fails(2, "render", case("escher_tet_g3_p3"), *MIDDLE, "--layer", "1:what=0")
        listed = re.search(r"is none of (.*), each with", done.stderr)[1].split(", ")
        self.assertEqual(sorted(listed), sorted(row["layer"] for row in settings.load() if row["layer"]))

    def test_names_of_colour_maps(self):
        done = self.fails(2, "render", case("escher_tet_g3_p3"), *MIDDLE, "--colormap", "what")
        row = next(row for row in settings.load() if row["option"] == "--colormap")
        self.assertEqual(row["choices"], colormaps.names())
        self.assertIn("there are " + ", ".join(row["choices"]) + ",", done.stderr)

    def test_table_of_colour_maps(self):
        """Where it fails: Rendering/Settings/generate.py page Module/Documentation/command-line.md."""
        page = (PAGE.parent / "command-line.md").read_text(encoding="utf-8")
        self.assertIn(f"\n{colormaps.page_table()}\n", page)

    def test_limits_are_refused_by_the_words_of_the_table(self):
        for row in settings.load():
            low, high = settings.limits_of(row)
            if row["type"] not in ("integer", "number", "number-if-any") or not row["option"]:
                continue
            name, command = settings.name_of(row), row["commands"][0]
            for value in ("nan", *[limit for limit in (low - 1, high + 1) if abs(limit) < 1e300]):
                text = str(value) if isinstance(value, str) else settings.number_text(value)
                done = self.fails(2, command, "missing.vtu", f"{name}={text}", names=[name])
                self.assertIn(settings.expected_of(row), done.stderr)


def code_list(words):
    return ", ".join(f"`{word}`" for word in words)


class Formats(ToolTest):
    def write(self, name):
        path = self.folder / name
        path.write_text("x", encoding="utf-8")
        return path

    def test_table_of_formats(self):
        """Where it fails: Rendering/Settings/generate.py page Module/Documentation/files.md."""
        page = (PAGE.parent / "files.md").read_text(encoding="utf-8")
        self.assertIn(f"\n{formats.page_table()}\n", page)

    def test_readers_in_paraview(self):
        """Each proxy of the plugin's readers has the suffixes of its own rows, and so has the page."""
        template = ElementTree.parse(ROOT / "ParaView" / "Readers.xml.in")
        page = (PAGE.parent / "paraview.md").read_text(encoding="utf-8")
        for proxy in template.iter("SourceProxy"):
            readers = [hint.get("reader") for hint in proxy.iter("ReaderFactory")]
            self.assertEqual(readers, [proxy.get("name")])
            suffixes = formats.paraview_hints()[readers[0]][0]
            self.assertTrue(suffixes)
            self.assertRegex(page, rf"\n\| {re.escape(proxy.get('label'))} \| {code_list(suffixes)}[;|\s]")

    def test_suffixes_in_the_introduction(self):
        """README names each suffix of the table."""
        page = (ROOT / "README.md").read_text(encoding="utf-8")
        for row in formats.load():
            for suffix in row["mesh"] + row["fields"]:
                self.assertIn(f"`{suffix}`", page)

    def test_parts_in_folders(self):
        """The folder of a field file holds parts of the suffixes that the row has in ParaView."""
        row = next(row for row in formats.load() if row["field_folders"])
        session = DATA / "nek_half_mode" / "nek_half_mode.xml"
        for number, suffix in enumerate([*row["paraview_suffixes"], ".unknown"]):
            folder = self.folder / f"{number}{row['fields'][0]}"
            folder.mkdir()
            (folder / f"P0000000{suffix}").write_text("x", encoding="utf-8")
            done = self.fails(1, "info", session, folder)
            self.assertEqual("holds no parts" in done.stderr, suffix == ".unknown", done.stderr)

    def test_suffixes_that_the_tool_lists(self):
        done = self.fails(1, "info", self.write("a.unknown"))
        listed = re.search(r"suffixes are (.*), and", done.stderr)[1].split(", ")
        self.assertEqual(listed, [suffix for row in formats.load() for suffix in row["mesh"]])

    def test_formats_that_are_not_read(self):
        """They are refused by name, with the remedy, and files.md names their suffixes."""
        page = (PAGE.parent / "files.md").read_text(encoding="utf-8")
        for row in formats.not_read():
            for number, suffix in enumerate(row["suffixes"]):
                file = self.folder / f"{number}{suffix}"
                file.mkdir() if row["folder"] else self.write(file.name)
                self.fails(1, "info", file, names=[file, row["name"], row["remedy"]])
                self.assertIn(f"`{suffix}`", page)

    def test_names_of_formats(self):
        """Files of two formats are refused by the names of both."""
        for row in formats.load():
            first = "a.vtk" if row["name"] != "VTK legacy" else "a.cgns"
            for suffix in row["mesh"] + row["fields"]:
                second = self.write("b" + suffix)
                self.fails(2, "info", self.write(first), second, names=[f"'{second}' ({row['name']})"])

    def test_meshes_have_a_reader(self):
        for suffix in (suffix for row in formats.load() for suffix in row["mesh"]):
            file = self.write("a" + suffix)
            done = self.fails(1, "info", file, names=[file])
            self.assertNotIn("no format", done.stderr)

    def test_fields_need_a_mesh(self):
        for row in formats.load():
            for suffix in formats.own_fields(row):
                self.fails(2, "info", self.write("a" + suffix), names=["without its mesh"])

    def test_folders_of_fields(self):
        for row in formats.load():
            for suffix in row["mesh"] + row["fields"]:
                folder = self.folder / ("folder" + suffix)
                folder.mkdir(exist_ok=True)
                if row["field_folders"] and suffix in row["fields"]:
                    self.fails(2, "info", folder, names=["without its mesh"])
                else:
                    self.fails(1, "info", folder, names=["it is a folder"])


if __name__ == "__main__":
    unittest.main()
