# SPDX-License-Identifier: BSD-3-Clause
"""Letters beyond ASCII in titles, fields and file names; bytes that are no letters."""

import os
import shutil
import subprocess
import unittest
import xml.etree.ElementTree as ElementTree

import numpy as np

from tool import CUBE, ToolTest, read_image, run, unit_cube_grid

FIGURE = ["--plane", "z", "--figure", "--size", "300x300"]
TITLE = "Größe ∂u"


class Letters(ToolTest):
    def setUp(self):
        super().setUp()
        self.cube = self.folder / "cube.vtu"
        self.cube.write_text(unit_cube_grid([("ρ", [p[0] for p in CUBE])]), encoding="utf-8")

    def title(self, text, *options):
        """The rows of a figure that hold its title."""
        path = self.folder / "title.png"
        done = self.succeeds("render", self.cube, *FIGURE, "--title", text, "-o", path, *options)
        return read_image(path)[-30:, :, :3], done

    def test_in_pixels(self):
        """VTK would leave them out, and say nothing."""
        ascii_alone, _ = self.title("Gre u")
        for font in ["sans", "serif"]:
            told, done = self.title(TITLE, "--font", font)
            self.assertNotIn("warning", done.stderr)
            other, _ = self.title(TITLE.replace("∂", "α"), "--font", font)
            self.assertTrue((told != other).any())
            self.assertGreater((told < 128).sum(), 1.1 * (ascii_alone < 128).sum())

    def test_of_a_field(self):
        self.title("x")
        named = read_image(self.folder / "title.png")
        other = self.folder / "other.vtu"
        other.write_text(unit_cube_grid([("σ", [p[0] for p in CUBE])]), encoding="utf-8")
        self.succeeds("render", other, *FIGURE, "--title", "x", "-o", self.folder / "other.png")
        self.assertTrue((read_image(self.folder / "other.png") != named).any())

    def test_that_no_font_has(self):
        _, done = self.title("\U000f1234")
        self.assertIn("--font", done.stderr)
        self.assertEqual(done.stderr.count("warning"), 1)

    @unittest.skipUnless(shutil.which("pdftotext"), "pdftotext is not installed")
    def test_in_pdf(self):
        path = self.folder / "a b.pdf"
        self.succeeds("render", self.cube, *FIGURE, "--title", TITLE, "-o", path)
        text = subprocess.run(["pdftotext", path, "-"], stdout=subprocess.PIPE, check=True).stdout.decode()
        self.assertIn(TITLE, text)
        self.assertIn("ρ", text)

    def test_bytes_that_are_no_letters(self):
        """In the names of files, which pictures keep, and in texts."""
        name = os.fsdecode(b"b\xff d.vtu")
        os.rename(self.cube, self.folder / name)
        for suffix in [".svg", ".pdf", ".png", ".tif"]:
            output = self.folder / (os.fsdecode(b"o\xfe") + suffix)
            done = run("render", self.folder / name, *FIGURE, "--title", os.fsdecode(b"T\xff"), "-q", "-o", output,
                text=False)
            self.assertEqual(done.returncode, 0, done.stderr)
            if suffix == ".svg":
                ElementTree.fromstring(output.read_bytes())
            elif suffix == ".png":
                self.assertGreater(len(np.unique(read_with_bytes(output).reshape(-1, 3), axis=0)), 20)


def read_with_bytes(path):
    """VTK's readers take names of valid letters alone."""
    copy = path.with_name("copy.png")
    shutil.copy(path, copy)
    return read_image(copy)


if __name__ == "__main__":
    unittest.main()
