# SPDX-License-Identifier: BSD-3-Clause
"""The cookbook's figures are made, and its questions are answered, by its lines."""

import re
import subprocess
import sys
import unittest
from pathlib import Path

import numpy as np

from tool import TOOL, ToolTest, read_image

ROOT = Path(__file__).resolve().parent.parent.parent
SCRIPT = ROOT / "Examples" / "cookbook.py"
PAGE = (ROOT / "Module" / "Documentation" / "cookbook.md").read_text(encoding="utf-8")


class Cookbook(ToolTest):
    def run_lines(self, argument):
        done = subprocess.run([sys.executable, SCRIPT, argument], cwd=self.folder, stdout=subprocess.PIPE,
            stderr=subprocess.PIPE, text=True, check=False)  # fmt: skip
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout.splitlines()

    def look_at_pictures(self, names):
        """All of them are there, and none is empty."""
        pictures = {path.name: path for path in (self.folder / "pictures").iterdir()}
        self.assertLessEqual(set(names), set(pictures))
        for picture in pictures.values():
            if picture.suffix == ".png":
                colors = np.unique(read_image(picture).reshape(-1, read_image(picture).shape[2]), axis=0)
                self.assertGreater(len(colors), 10, picture)
            else:
                self.assertEqual(picture.read_bytes()[:5], b"%PDF-")
        return len(pictures)

    def test_all_commands(self):
        commands = re.findall(r"^ +pixelexact (.*)$", PAGE, re.MULTILINE)
        lines = self.run_lines(TOOL)
        self.assertEqual(len(lines), len(commands))
        names = [name for line in commands for name in re.findall(r"pictures/(\S+)", line) if "%d" not in name]
        # The moving plane makes five.
        self.assertEqual(self.look_at_pictures(names), len(names) + 5)

    def test_all_lines_of_python(self):
        lines = re.findall(r"^    >>> (.*)$", PAGE, re.MULTILINE)
        names = [name for line in lines for name in re.findall(r"pictures/([^\"]+)", line)]
        output = self.run_lines("--python")
        assignments = [line for line in lines if re.match(r"\w+ = |import ", line)]
        self.assertEqual(len(output), len(lines) - len(assignments))
        self.assertEqual(self.look_at_pictures(names), len(names))
        values = dict(line.rsplit(": ", 1) for line in output if not line.startswith("pixelexact.figure"))
        errors = next(value for line, value in values.items() if line.startswith("[pixelexact.norms"))
        numbers = [float(text) for text in errors.strip("[]").split(",")]
        self.assertTrue(all(a > 7 * b for a, b in zip(numbers, numbers[1:], strict=False)), numbers)

    def test_each_question_has_a_command_and_a_line_of_python(self):
        questions = PAGE.split("\n**")[1:]
        self.assertGreaterEqual(len(questions), 15)
        for question in questions:
            self.assertRegex(question, r"(?m)^    pixelexact |Figures? \d+", question)
            self.assertRegex(question, r"(?m)^    >>> pixelexact|^    >>> \[pixelexact", question)


if __name__ == "__main__":
    unittest.main()
