# SPDX-License-Identifier: BSD-3-Clause
"""The tables of settings and file formats against Python's keywords and docstrings, and the
properties of VTK's classes."""

import inspect
import os
import re
import sys
import tempfile
import unittest
from pathlib import Path

import pixelexact

DATA = Path(os.environ["PIXELEXACT_DATA_DIR"])
sys.path.insert(0, str(DATA.parent / "Rendering" / "Settings"))
import formats  # noqa: E402
import settings  # noqa: E402

CLASSES = ["vtkHighOrderMapper", "vtkHighOrderLayer", "vtkHighOrderPicture"]
# Types of a value that one Set takes.
PLAIN = {"flag", "integer", "number", "color", "size"}


def keywords():
    """Python's keywords with their defaults, and the docstring that explains each."""
    found = {}
    for function in (pixelexact.render, pixelexact.cut):
        for name, parameter in inspect.signature(function).parameters.items():
            found[name] = (parameter.default, re.sub(r"\s+", " ", function.__doc__))
    return found


def as_list(value):
    return list(value) if isinstance(value, (list, tuple)) else [value]


class Keywords(unittest.TestCase):
    def test_defaults_and_texts(self):
        there = keywords()
        for row in settings.load():
            if not row["python"]:
                continue
            with self.subTest(row["python"]):
                default, doc = there[row["python"]]
                self.assertIn(f"{row['python']}: {row['python_help']}", doc)
                expected = row["python_default"]
                if expected is None and (row["type"] in PLAIN | {"choice"} or default == "viridis"):
                    expected = row["default"] if row["type"] != "flag" else False
                if isinstance(expected, (bool, int, float, list)) or row["type"] == "choice":
                    self.assertEqual(as_list(default), as_list(expected))
        self.assertNotIn("{", pixelexact.cut.__doc__ + pixelexact.render.__doc__)

    def test_values_that_the_table_does_not_allow(self):
        grid = pixelexact.read(DATA / "escher_tet_g3_p3.vtu")
        for row in settings.load():
            name, (low, high) = row["python"], settings.limits_of(row)
            wrong = {"flag": ["no", 2], "choice": ["what"], "integer": ["3", 1.5, high + 1],
                     "number": ["wide", low - 1, high + 1, float("nan")]}
            for value in wrong.get(row["type"], []) if name else []:
                with self.subTest(name, value=value), self.assertRaises((TypeError, ValueError)) as raised:
                    pixelexact.render(grid, "u", size=(2, 2), **{name: value})
                message = f"{name}: expected {settings.expected_of(row)}, got {value!r}"
                self.assertEqual(str(raised.exception), message)


class Formats(unittest.TestCase):
    def test_docstring_of_read(self):
        doc = re.sub(r"\s+", " ", pixelexact.read.__doc__)
        for row in formats.load():
            for text in (*row["mesh"], *row["fields"], f": {row['name']}. {row['help']}"):
                self.assertIn(text, doc)
        self.assertNotIn("{", doc)

    def test_suffixes_that_read_lists(self):
        with tempfile.NamedTemporaryFile(suffix=".unknown") as file:
            file.write(b"x")
            file.flush()
            with self.assertRaises(ValueError) as raised:
                pixelexact.read(file.name)
        self.assertIn(f"suffixes are {formats.help_texts()['suffixes']}, and", str(raised.exception))


class Properties(unittest.TestCase):
    def entries(self):
        for row in settings.load():
            for entry in row["vtk"]:
                name, prop = entry["property"].split(".")
                yield entry, getattr(pixelexact, name)(), prop

    def test_exist_with_their_defaults(self):
        for entry, item, prop in self.entries():
            with self.subTest(entry["property"]):
                self.assertTrue(hasattr(item, "Set" + prop))
                if entry["type"] in PLAIN and not isinstance(entry["default"], str):
                    value = getattr(item, "Get" + prop)()
                    self.assertEqual(as_list(value), as_list(entry["default"]))

    def test_limits(self):
        """A value outside of them is set to the limit, or refused when it is drawn."""
        grid = pixelexact.read(DATA / "escher_tet_g3_p3.vtu")
        for entry, item, prop in self.entries():
            if entry["type"] not in ("integer", "number"):
                continue
            for limit, outside in ((entry["min"], entry["min"] - 1), (entry["max"], entry["max"] + 1)):
                with self.subTest(entry["property"], outside=outside):
                    getattr(item, "Set" + prop)(outside)
                    found = getattr(item, "Get" + prop)()
                    if found != limit:
                        self.assertEqual(found, outside)
                        cut = pixelexact.cut(grid, "u", contours=2, contour_labels=True)
                        getattr(cut.mapper, "Set" + prop)(outside)
                        with self.assertRaises(pixelexact.Error):
                            cut.render(size=(20, 20))

    def test_all_are_in_the_table(self):
        known = {entry["property"] for entry, _, _ in self.entries()}
        exceptions = settings.vtk_only()
        for name in CLASSES:
            item = getattr(pixelexact, name)()
            own = {method[3:] for base in type(item).__mro__ if base.__module__.startswith("pixelexact")
                   for method in vars(base) if method.startswith("Set")}
            for prop in sorted(own):
                try:
                    value = getattr(item, "Get" + prop)()
                except (AttributeError, TypeError):
                    continue  # there is no Get, or one of several, which a number names
                inherited = any("Set" + prop in vars(base) for base in type(item).__mro__
                                if not base.__module__.startswith("pixelexact"))
                if isinstance(value, (bool, int, float, str, tuple)) and not inherited:
                    self.assertIn(f"{name}.{prop}", known | set(exceptions))
        self.assertEqual(known & set(exceptions), set())
        for prop in exceptions:
            name, setter = prop.split(".")
            self.assertTrue(hasattr(getattr(pixelexact, name), "Set" + setter), prop)


if __name__ == "__main__":
    unittest.main()
