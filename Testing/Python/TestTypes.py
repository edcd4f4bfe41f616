# SPDX-License-Identifier: BSD-3-Clause
"""What mypy makes of the package and of scripts that use it."""

import importlib.util
import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import pixelexact

GOOD = """
import pixelexact
grid = pixelexact.read("a.mesh", "u.gf", time_step=0)
actor, bar = pixelexact.cut(grid, "u", normal="z", contours=[0.1, 0.2])
picture = pixelexact.render(grid, "u", size=(100, 100))
count: int = len(pixelexact.probe(grid, "u", [[0.0, 0.0, 0.0]]))
figure = pixelexact.figure("a.vtu", "u", plane="z=40%", output="a.pdf", size=(100, 100))
pages: list[str] = [note for note in figure.notes]
exact = pixelexact.info(grid, certify=True)["elements"]
rows = pixelexact.compare(["a.mesh", "u.gf"], "u").rows
mapper = pixelexact.vtkHighOrderMapper()
mapper.SetSearchSamples(3)
"""
WRONG = """
import pixelexact
pixelexact.set_threads("2")
pixelexact.vtkHighOrderMapper().SetSearchSamples("many")
pixelexact.render("a.vtu", size=3)
pixelexact.figure("a.vtu", 5)
"""


@unittest.skipUnless(importlib.util.find_spec("mypy"), "mypy is not installed")
class Types(unittest.TestCase):
    def mypy(self, text, *options):
        with tempfile.TemporaryDirectory() as folder:
            script = Path(folder) / "script.py"
            script.write_text(text, encoding="utf-8")
            where = Path(pixelexact.__file__).parent.parent
            return subprocess.run(
                [sys.executable, "-m", "mypy", "--ignore-missing-imports", "--strict"]
                + ["--allow-subclassing-any", "--no-warn-return-any"]
                + ["--cache-dir", folder, *options, str(script)],
                env={**os.environ, "MYPYPATH": str(where)},
                stdout=subprocess.PIPE,
                text=True,
                check=False,
            ).stdout

    def test_the_package_and_its_use(self):
        self.assertIn("Success", self.mypy(GOOD))

    def test_mistakes_are_found(self):
        found = self.mypy(WRONG)
        for line in (3, 4, 5, 6):
            self.assertIn(f"script.py:{line}: error", found)


if __name__ == "__main__":
    unittest.main()
