# SPDX-License-Identifier: BSD-3-Clause
"""The Python examples run and make pictures of what they say."""

import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

EXAMPLES = Path(__file__).resolve().parent.parent.parent / "Examples"


def colors(path):
    """Width, height and number of colours of a PNG."""
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkIOImage import vtkPNGReader

    reader = vtkPNGReader()
    reader.SetFileName(str(path))
    reader.Update()
    width, height, _ = reader.GetOutput().GetDimensions()
    pixels = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars())
    return width, height, len({tuple(pixel) for pixel in pixels.tolist()})


class Examples(unittest.TestCase):
    def setUp(self):
        self.folder = Path(tempfile.mkdtemp(prefix="pixelexact-"))
        self.addCleanup(shutil.rmtree, self.folder)
        self.image = self.folder / "image.png"

    def run_example(self, name, *arguments):
        script = [sys.executable] if name.endswith(".py") else []
        done = subprocess.run(
            [*script, str(EXAMPLES / name), *map(str, arguments)],
            cwd=self.folder,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
            timeout=300,
            check=False,
        )
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(done.stderr, "")
        return done.stdout

    def test_five_lines(self):
        mesh = EXAMPLES.parent / "Data" / "toroid_hex_g3_p6.vtu"
        self.run_example("five_lines.py", mesh, self.image)
        width, height, count = colors(self.image)
        self.assertEqual((width, height), (800, 800))
        self.assertGreater(count, 200)

    def test_short_values(self):
        table = self.folder / "values.csv"
        mesh = EXAMPLES.parent / "Data" / "escher_tet_g3_p3.vtu"
        text = self.run_example("short_values.py", mesh, table)
        self.assertIn("477 of 1001 points are inside", text)
        rows = table.read_text(encoding="utf-8").splitlines()
        self.assertEqual(rows[0], "x,y,z,u,lower,upper,d/dx,d/dy,d/dz,element")
        self.assertEqual(len(rows), 478)
        for row in rows[1:]:
            value, lower, upper = map(float, row.split(",")[3:6])
            self.assertLessEqual(lower, value)
            self.assertLessEqual(value, upper)

    def test_short_pictures(self):
        text = self.run_example("short_pictures.py", self.folder, 200)
        self.assertEqual(text.count(" 0 pixels unknown"), 5)
        for picture in self.folder.glob("*.png"):
            self.assertEqual(colors(picture)[:2], (200, 200))
            self.assertGreater(colors(picture)[2], 100)
        self.assertEqual(len(list(self.folder.glob("*.png"))), 5)

    def test_short_check(self):
        text = self.run_example("short_check.py")
        differences = [float(each) for each in re.findall(r"difference (\S+)", text)]
        self.assertEqual(len(differences), 6)
        self.assertLess(max(differences), 1e-13)

    def test_readme_picture(self):
        self.run_example("readme_picture.py", self.image, 240)
        width, height, count = colors(self.image)
        self.assertEqual((width, height), (240, 150))
        self.assertGreater(count, 200)

    def test_surfaces(self):
        """Each kind of them is seen, in windows and by the tool."""
        for name, size in [("surfaces.py", "120"), ("surfaces.sh", "120x100")]:
            folder = self.folder / name
            self.run_example(name, folder, size)
            pictures = sorted(folder.glob("*.png"))
            self.assertGreaterEqual(len(pictures), 13)
            for picture in pictures:
                width, height, count = colors(picture)
                self.assertEqual((width, height), (120, 100), picture)
                self.assertGreater(count, 60, picture)

    def test_thin_sheets(self):
        """Linear cells lose most of what is there."""
        text = self.run_example("thin_sheets.py", self.image, "60x40")
        shares = [float(share) for share in re.findall(r"(\S+)% of the pixels missing", text)]
        self.assertEqual(len(shares), 2)
        self.assertGreater(shares[0], shares[1])
        self.assertGreater(shares[1], 50)
        self.assertEqual(colors(self.image)[:2], (180, 40))

    def test_linear_comparison(self):
        """Second order: half the spacing, about a quarter of the error."""
        text = self.run_example("linear_comparison.py", self.image, 100, "24,48")
        means = [float(mean) for mean in re.findall(r"mean (\S+)", text)]
        self.assertEqual(len(means), 3)
        self.assertGreater(means[1] / means[2], 2.5)
        self.assertLess(means[1] / means[2], 6.5)
        self.assertGreater(colors(self.image)[2], 200)


if __name__ == "__main__":
    unittest.main()
