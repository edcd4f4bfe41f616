# SPDX-License-Identifier: BSD-3-Clause
"""SVG and PDF: letters, lines and contours stay what they are, over the picture's pixels."""

import base64
import re
import shutil
import subprocess
import unittest
import xml.etree.ElementTree as ElementTree

import numpy as np

from tool import CUBE, ToolTest, View, plain_grid, read_image, unit_cube_grid

SVG = "{http://www.w3.org/2000/svg}"
LINK = "{http://www.w3.org/1999/xlink}href"
# Of a parallel view of the unit cube's cut across z: height 1.25 in 200 pixels.
VIEW = ["--plane", "z", "--camera-position", "0.5,0.5,3", "--focal-point", "0.5,0.5,0.5",
        "--parallel-scale", "0.625", "--size", "300x200"]
RED = ["--contour-color", "1,0,0", "--colormap", "grayscale"]


def needs(program):
    return unittest.skipUnless(shutil.which(program), f"{program} is not installed")


class VectorTest(ToolTest):
    def setUp(self):
        super().setUp()
        self.cube = self.folder / "cube.vtu"
        fields = [("u", [p[0] for p in CUBE]), ("w", [p[0] * p[1] for p in CUBE])]
        self.cube.write_text(unit_cube_grid(fields), encoding="utf-8")

    def draw(self, name, *arguments, field="u"):
        path = self.folder / name
        self.done = self.succeeds("render", self.cube, "--field", field, *VIEW, "-o", path, *arguments)
        return path

    def program(self, *words):
        return subprocess.run([str(word) for word in words], stdout=subprocess.PIPE, check=True,
            text=True).stdout

    def paths(self, path, color="rgb(100%,0%,0%)"):
        """Points of an SVG's lines of a colour, in pixels from the lower left."""
        root = ElementTree.parse(path).getroot()
        height = float(root.get("height").rstrip("pt"))
        found = []
        for element in root.iter(SVG + "path"):
            # Cairo 1.16 writes a style, 1.18 attributes.
            style = (element.get("style") or "").replace(" ", "")
            stroke = (element.get("stroke") or "").replace(" ", "")
            if f"stroke:{color}" not in style and stroke != color:
                continue
            numbers = [float(n) for n in re.findall(r"-?\d+\.?\d*(?:e-?\d+)?", element.get("d"))]
            points = np.reshape(numbers[: len(numbers) // 2 * 2], (-1, 2))
            matrix = element.get("transform")
            if matrix:
                a, b, c, d, e, f = [float(n) for n in re.findall(r"-?\d+\.?\d*(?:e-?\d+)?", matrix)]
                points = points @ np.array([[a, b], [c, d]]) + [e, f]
            found.append(points)
        scale = 300.0 / 72.0  # 300 dots per inch
        return [np.column_stack([p[:, 0], height - p[:, 1]]) * scale for p in found]

    def image(self, path):
        """The pixels that an SVG holds."""
        root = ElementTree.parse(path).getroot()
        images = [e.get(LINK) for e in root.iter(SVG + "image")]
        self.assertEqual(len(images), 1)
        file = self.folder / "embedded.png"
        file.write_bytes(base64.b64decode(images[0].split(",", 1)[1]))
        return read_image(file)


class Svg(VectorTest):
    def test_contours_are_paths(self):
        path = self.draw("a.svg", *RED, "--contours", "0.25,0.5")
        lines = self.paths(path)
        self.assertEqual(len(lines), 2)
        # u = x: a pixel is 1.25 / 200 wide.
        for line, value in zip(sorted(lines, key=lambda p: p[0, 0]), [0.25, 0.5]):
            np.testing.assert_allclose(line[:, 0], 150 + (value - 0.5) / 0.00625, atol=0.11)
            np.testing.assert_allclose(np.ptp(line[:, 1]), 160, atol=0.2)
        pixels = self.image(path)
        self.assertFalse(((pixels[..., 0] > 200) & (pixels[..., 1] < 50)).any())

    def test_curved_contours(self):
        values = [0.1, 0.3, 0.7]
        lines = self.paths(self.draw("a.svg", *RED, "--contours", "0.1,0.3,0.7", field="w"))
        self.assertEqual(len(lines), 3)
        for line in lines:
            x, y = ((line - [150, 100]) * 0.00625 + 0.5).T
            value = min(values, key=lambda v: abs(v - np.median(x * y)))
            # A tenth of a pixel off the curve x y = value, by the gradient's length.
            self.assertLess((np.abs(x * y - value) / np.hypot(x, y)).max(), 0.11 * 0.00625)

    def test_pixels_are_those_of_the_png(self):
        expected = read_image(self.draw("a.png"))
        found = self.image(self.draw("a.svg"))
        np.testing.assert_array_equal(found[..., :3], expected)

    def test_contours_that_stay_in_the_pixels(self):
        for more in [["--show-undecided-contours"], ["--sphere", "0.5,0.5,0.5,0.2"]]:
            path = self.draw("a.svg", *RED, "--contours", "0.26,0.51", *more)
            self.assertIn("in the picture's pixels", self.done.stderr)
            self.assertEqual(self.paths(path), [])
            pixels = self.image(path)
            self.assertTrue(((pixels[..., 0] > 200) & (pixels[..., 1] < 50)).any())

    def test_labels_stand_in_gaps(self):
        """No point of a line is where a text is, and the rest of the line is there."""
        whole = self.paths(self.draw("a.svg", *RED, "--contours", "0.25,0.5"))
        path = self.draw("a.svg", *RED, "--contours", "0.25,0.5", "--contour-labels", "10")
        self.assertNotIn("in the picture's pixels", self.done.stderr)
        lines = self.paths(path)
        # Three texts on each.
        self.assertEqual(len(lines), 8)

        def length(lines):
            return sum(np.hypot(*np.diff(line, axis=0).T).sum() for line in lines)

        self.assertLess(length(whole) - length(lines), 6 * 40)
        self.assertGreater(length(whole) - length(lines), 6 * 15)
        uses = ElementTree.parse(path).getroot().iter(SVG + "use")
        letters = [use for use in uses if use.get(LINK).startswith("#glyph")]
        self.assertEqual(len(letters), 3 * (len("0.25") + len("0.5")))
        pixels = self.image(path)
        self.assertFalse(((pixels[..., 0] > 200) & (pixels[..., 1] < 50)).any())

    def test_box(self):
        """Twelve edges of the unit cube, where a parallel camera sees them."""
        position = np.array([0.5, 0.5, 0.5]) + 3.0 * np.array([2.0, 1.0, 2.0]) / 3.0
        view = View(position, [0.5, 0.5, 0.5], [0, 1, 0], 300, 200, scale=1.25)
        path = self.folder / "box.svg"
        self.succeeds("render", self.cube, "--field", "u", "--plane", "0,0,-9,0,0,1", "--mesh-outline=box",
            "--mesh-outline-color", "1,0,0", *view.options(), "-o", path)
        lines = self.paths(path)
        self.assertEqual(len(lines), 12)
        forward = -np.array([2.0, 1.0, 2.0]) / 3.0
        right = np.cross(forward, [0, 1, 0])
        right /= np.linalg.norm(right)
        up = np.cross(right, forward)
        seen = np.array([(150 + (p @ right) * 80, 100 + (p @ up) * 80) for p in np.array(CUBE) - 0.5])
        for line in lines:
            self.assertEqual(len(line), 2)
            for end in line:
                self.assertLess(np.hypot(*(seen - end).T).min(), 0.26)

    def test_figure(self):
        path = self.draw("a.svg", "--figure", "--title", "A <title> & more", "--font", "serif", "--font-size", 9)
        root = ElementTree.parse(path).getroot()
        self.assertTrue(root.get("width").endswith("pt"))
        self.assertAlmostEqual(float(root.get("width").rstrip("pt")), 300 * 72 / 300, delta=1e-3)
        description = root.find(SVG + "desc")
        description = root.find("desc") if description is None else description
        self.assertIn("A <title> & more", description.text)
        self.assertIn("PixelExact", description.text)
        self.assertIn("cube.vtu", description.text)
        # Ticks and the scale are straight, and short.
        lines = self.paths(path, "rgb(0%,0%,0%)")
        self.assertGreaterEqual(len(lines), 4)
        for line in lines:
            self.assertEqual(len(line), 2)
            self.assertLess(min(np.ptp(line, axis=0)), 1e-3)
            self.assertLess(max(np.ptp(line, axis=0)), 70)
        # Letters are outlines that are used again.
        self.assertGreater(len(list(root.iter(SVG + "use"))), 20)

    def test_transparent(self):
        pixels = self.image(self.draw("a.svg", "--background", "none"))
        self.assertEqual(pixels.shape[2], 4)
        self.assertEqual(set(np.unique(pixels[..., 3])), {0, 255})

    def test_animation(self):
        self.succeeds("render", self.cube, "--field", "u", "--sweep", "z=0.2:0.8:2", "--contours", "3",
            "-o", self.folder / "s_%d.svg", "--size", "60x40")
        for k in range(2):
            self.assertIn(f"Frame: {k} of 2", (self.folder / f"s_{k}.svg").read_text(encoding="utf-8"))


class Edges(VectorTest):
    """Two elements side by side, which meet where x + y / 4 = 0.6."""

    def setUp(self):
        super().setUp()
        points = [[x, y, z] for z in (0.0, 1.0) for y in (0.0, 1.0) for x in (0.0, 0.6 - y / 4, 1.0)]
        cells = [(12, [0, 1, 4, 3, 6, 7, 10, 9]), (12, [1, 2, 5, 4, 7, 8, 11, 10])]
        self.cube.write_text(plain_grid(points, cells, [("u", [p[0] for p in points])]), encoding="utf-8")

    def off(self, x, y):
        """From the nearest of the five sides of the two elements, in pixels."""
        slanted = np.abs(x + y / 4 - 0.6) / np.hypot(1, 0.25)
        return np.minimum.reduce([slanted, *(np.abs(c - side) for c in (x, y) for side in (0, 1))]) / 0.00625

    def test_paths(self):
        for name, tolerance in [("--edges", 1 / 20), ("--mesh-outline", 1 / 2)]:
            color = "--edge-color" if name == "--edges" else "--mesh-outline-color"
            path = self.draw("a.svg", name, color, "1,0,0")
            self.assertNotIn("in the picture's pixels", self.done.stderr)
            lines = self.paths(path)
            self.assertTrue(lines)
            points = np.vstack([a + s * (b - a) for line in lines for a, b in zip(line, line[1:])
                for s in np.linspace(0, 1, 50)[:, None]])
            x, y = ((points - [150, 100]) * 0.00625 + 0.5).T
            # Corners are cut off by a pixel.
            corners = np.array([[cx, cy] for cx in (0, 1) for cy in (0, 1)] + [[0.6, 0], [0.35, 1]])
            away = np.min([np.hypot(x - cx, y - cy) for cx, cy in corners], axis=0) / 0.00625
            self.assertLess(self.off(x, y)[away > 2].max(), tolerance)
            self.assertLess(self.off(x, y).max(), 1.0)
            length = sum(np.hypot(*np.diff(line, axis=0).T).sum() for line in lines) * 0.00625
            self.assertAlmostEqual(length, np.hypot(1, 0.25) if name == "--edges" else 4, delta=0.05)
            pixels = self.image(path)
            self.assertFalse(((pixels[..., 0] > 200) & (pixels[..., 1] < 50)).any())

    def test_that_stay_in_the_pixels(self):
        for more in [["--edges-by-kind"], ["--sphere", "0.5,0.5,0.5,0.2"]]:
            path = self.draw("a.svg", "--edges", "--edge-color", "0,0,0", *more)
            self.assertIn("element edges: in the picture's pixels", self.done.stderr)
            self.assertTrue((self.image(path)[..., :3].max(axis=2) < 40).any())


class Pdf(VectorTest):
    @needs("pdftotext")
    def test_texts_are_texts(self):
        path = self.draw("a.pdf", "--figure", "--title", "A title of mine", "--range", "0,1")
        text = self.program("pdftotext", path, "-")
        for word in ["A title of mine", "0.5", "1", "u"]:
            self.assertIn(word, text)
        fonts = self.program("pdffonts", path).splitlines()[2:]
        self.assertTrue(fonts)
        for line in fonts:
            self.assertRegex(line, r"\byes\s+yes\b")  # embedded, a subset
        labels = self.draw("b.pdf", "--contours", "0.25,0.5", "--contour-labels")
        self.assertEqual(set(self.program("pdftotext", labels, "-").split()), {"0.25", "0.5"})
        info = self.program("pdfinfo", path)
        self.assertIn("PixelExact", info)
        self.assertIn("cube.vtu", info)

    @needs("pdffonts")
    def test_a_font_of_a_file(self):
        import glob

        fonts = sorted(glob.glob("/usr/share/fonts/**/DejaVuSans-Bold.ttf", recursive=True))
        if not fonts:
            self.skipTest("this font file is not on this machine")
        found = self.program("pdffonts", self.draw("a.pdf", "--figure", "--font", fonts[0]))
        self.assertIn("DejaVuSans-Bold", found)

    @needs("pdfinfo")
    def test_size(self):
        self.succeeds("render", self.cube, "--field", "u", "--plane", "z", "--size", "85x60mm", "--figure",
            "-o", self.folder / "a.pdf")
        width, height = map(float, re.search(r"Page size:\s+([\d.]+) x ([\d.]+)",
            self.program("pdfinfo", self.folder / "a.pdf")).groups())
        self.assertAlmostEqual(width, 85 / 25.4 * 72, delta=0.2)
        self.assertAlmostEqual(height, 60 / 25.4 * 72, delta=0.2)

    @needs("pdftoppm")
    def test_pixels(self):
        expected = read_image(self.draw("a.png")).astype(int)
        self.program("pdftoppm", "-r", 300, "-png", "-singlefile", self.draw("a.pdf"), self.folder / "p")
        found = read_image(self.folder / "p.png").astype(int)
        self.assertEqual(found.shape, expected.shape)
        # A renderer may blend at the borders of pixels.
        self.assertLess(np.median(np.abs(found - expected)), 1.0)
        self.assertLess(np.abs(found - expected).mean(), 2.0)

    @needs("pdftoppm")
    def test_contours_are_where_the_pixels_have_them(self):
        options = [*RED, "--contours", "0.1,0.3,0.7", "--contour-width", "2"]
        expected = read_image(self.draw("a.png", *options, field="w")).astype(int)
        self.program("pdftoppm", "-r", 300, "-png", "-singlefile",
            self.draw("a.pdf", *options, field="w"), self.folder / "p")
        found = read_image(self.folder / "p.png").astype(int)

        def red(pixels):
            return pixels[..., 0] - pixels[..., 1] > 100

        both = (red(found) & red(expected)).sum()
        self.assertGreater(both, 0.8 * red(expected).sum())
        self.assertGreater(both, 0.7 * red(found).sum())


if __name__ == "__main__":
    unittest.main()
