# SPDX-License-Identifier: BSD-3-Clause
"""Each of render's options has a test; those that have no other one have it here."""

import os
import re
import unittest
from pathlib import Path

import numpy as np

from tool import CUBE, ToolTest, plain_grid, read_image, run, strict_json, unit_cube_grid

HERE = Path(__file__).resolve().parent
# The unit square at z = 0.5, 100 x 100 pixels in the middle of 120 x 120.
VIEW = ["--plane", "z=0.5", "--camera-position", "0.5,0.5,3", "--focal-point", "0.5,0.5,0.5",
        "--parallel-scale", "0.6", "--size", "120x120", "--color", "1,1,1"]


def near(pixels, color, within=40):
    """Where an image has a colour."""
    return (np.abs(pixels[..., :3].astype(int) - color) <= within).all(axis=2)


class RenderOptions(ToolTest):
    def setUp(self):
        super().setUp()
        self.cube = self.folder / "cube.vtu"
        self.cube.write_text(unit_cube_grid([("u", [p[0] * p[1] for p in CUBE])]), encoding="utf-8")
        self.image = self.folder / "i.png"

    def draw(self, *words, source=None):
        done = self.succeeds("render", source or self.cube, "--field", "u", *VIEW, *words, "-o", self.image)
        return read_image(self.image), done

    def test_all_have_one(self):
        told = set(re.findall(r"--[a-z][a-z-]+", self.succeeds("--completion", "man").stdout.replace("\\-", "-")))
        help_text = self.succeeds("render", "--help-all").stdout
        own = set(re.findall(r"^ +(?:-\w,)?(--[a-z][a-z-]+)", help_text, re.MULTILINE))
        self.assertGreater(len(own), 70)
        self.assertLessEqual(own, told)
        tests = "".join(file.read_text(encoding="utf-8") for file in HERE.glob("*.py"))
        self.assertEqual([name for name in sorted(own) if not re.search(rf'"{name}["=]', tests)], [])

    def test_edges_by_kind(self):
        """Black between elements, blue at the mesh's boundary."""
        points = [[x, y, z] for z in (0.0, 1.0) for y in (0.0, 1.0) for x in (0.0, 0.6, 1.0)]
        cells = [(12, [0, 1, 4, 3, 6, 7, 10, 9]), (12, [1, 2, 5, 4, 7, 8, 11, 10])]
        two = self.folder / "two.vtu"
        two.write_text(plain_grid(points, cells, [("u", [p[0] for p in points])]), encoding="utf-8")
        plain, _ = self.draw("--edges", "2", "--edge-color", "0,0,0", source=two)
        kinds, _ = self.draw("--edges", "2", "--edges-by-kind", source=two)
        self.assertTrue(near(kinds[20:100, 68:72], 0).any(axis=1).all())
        np.testing.assert_array_equal(kinds[20:100, 60:80], plain[20:100, 60:80])
        blue = (kinds[..., 2].astype(int) - kinds[..., 0]) > 100
        self.assertTrue(blue[20:100, 8:14].any(axis=1).all())
        self.assertFalse(blue[20:100, 40:100].any())

    def test_colours_of_lines(self):
        for words, color in [
            (["--edges", "3", "--edge-color", "1,0,0"], (255, 0, 0)),
            (["--mesh-outline", "--mesh-outline-color", "0,1,0", "--mesh-outline-width", "3"], (0, 255, 0)),
            (["--contours", "0.25", "--contour-width", "3", "--contour-color", "1,0,1"], (255, 0, 255)),
        ]:
            pixels, _ = self.draw(*words)
            self.assertGreater(near(pixels, color).sum(), 80, words)

    def test_undecided_contours(self):
        """u = x y has a saddle at the corner (0, 0), where the line of 0 is the square's two sides."""
        words = ["--contours", "0", "--show-undecided-contours", "--undecided-contour-color", "1,0.5,0"]
        counts = {}
        for certifier in [["--certifier", "interval"], ["--certifier", "interval", "--subdivisions", "0"]]:
            words_now = [*words, *certifier, "--json"]
            pixels, done = self.draw(*words_now)
            pixels_told = strict_json(done.stdout)["contours"]["pixels"]
            shown = near(pixels, (255, 127, 0)).sum()
            self.assertEqual(shown > 0, pixels_told["undecided"] > 0)
            counts[len(certifier)] = pixels_told["undecided"]
        # Without halving, intervals leave more open.
        self.assertGreaterEqual(counts[4], counts[2])

    def test_quiet(self):
        for flag in ["--quiet", "-q"]:
            done = self.succeeds("render", self.cube, flag, "-o", self.image, "--size", "9x9")
            self.assertEqual((done.stdout, done.stderr), ("", ""))

    def test_threads_and_config_change_no_pixel(self):
        self.draw()
        before = self.image.read_bytes()
        self.draw("--threads", "1", "--no-config")
        self.assertEqual(self.image.read_bytes(), before)


class Places(ToolTest):
    """Names with blanks, and such that are no UTF-8; folders that are files; disks that are full."""

    def setUp(self):
        super().setUp()
        self.cube = self.folder / "my cube.vtu"
        self.cube.write_text(unit_cube_grid(), encoding="utf-8")

    def test_names(self):
        for name in ["a b.png", "ä.png", os.fsdecode(b"x\xff.png"), "-a.png", "'q'.png"]:
            done = run("render", self.cube, "--size", "9x9", f"--output={name}", folder=self.folder, text=False)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertTrue((self.folder / name).exists(), name)

    def test_repeated_command(self):
        import shlex

        done = self.succeeds("render", self.cube, "--size", "9x9", "-o", self.folder / "a b.png")
        (line,) = [row for row in done.stdout.splitlines() if row.startswith("repeat")]
        words = shlex.split(line)[2:]
        self.assertEqual(words[1], str(self.cube))
        before = (self.folder / "a b.png").read_bytes()
        self.succeeds(*words)
        self.assertEqual((self.folder / "a b.png").read_bytes(), before)

    def test_full_disks(self):
        for suffix in [".png", ".tif", ".jpg", ".svg", ".pdf"]:
            full = self.folder / f"full{suffix}"
            full.symlink_to("/dev/full")
            self.fails(1, "render", self.cube, "-q", "--size", "9x9", "-o", full, names=[full, "No space", "room"])
        lines = self.folder / "full.vtp"
        lines.symlink_to("/dev/full")
        self.fails(1, "render", self.cube, "-q", "--plane", "z", "--contours", "0.5", "--size", "9x9", "-o",
            self.folder / "i.png", "--contours-output", lines, names=[lines, "No space", "room"])

    def test_folders(self):
        empty = self.folder / "empty"
        empty.mkdir()
        for command in ["info", "render"]:
            self.fails(1, command, empty, names=[empty, "folder"])
        self.fails(1, "render", self.cube, "-q", "-o", self.cube / "i.png", names=["i.png"])

    def test_nearest_words(self):
        for words, nearest in [(["rendr"], "render"), (["render", self.cube, "--ouput", "a.png"], "--output"),
                (["render", self.cube, "--precision", "flot"], "float"),
                (["render", self.cube, "--lights", "curve"], "curved"),
                (["render", self.cube, "--colormap", "virdis"], "viridis")]:
            self.fails(2, *words, names=[f"did you mean {nearest}?"])
        # Nothing is near.
        done = run("render", self.cube, "--precision", "quadruple")
        self.assertNotIn("did you mean", done.stderr)


if __name__ == "__main__":
    unittest.main()
