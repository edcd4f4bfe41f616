# SPDX-License-Identifier: BSD-3-Clause
"""render --figure, read back from the picture."""

import struct
import unittest

import numpy as np

from tool import CUBE, ToolTest, plain_grid, read_buffers, read_image, unit_cube_grid

# A figure of 600 x 400 pixels has letters of 10; its layout in these.
SIZE, FONT = "600x400", 10
LEFT = 600 - 11 * FONT + FONT  # of the column beside the picture
BAR = 12  # pixels wide


def texts_of(path):
    """The texts of a PNG by key."""
    data, at, texts = path.read_bytes(), 8, {}
    while at < len(data):
        length, kind = struct.unpack(">I4s", data[at : at + 8])
        if kind == b"tEXt":
            key, text = data[at + 8 : at + 8 + length].split(b"\0", 1)
            texts[key.decode()] = text.decode()
        at += 12 + length
    return texts


def runs(mask):
    """First and last of the runs of true entries."""
    edges = np.flatnonzero(np.diff(np.concatenate([[0], mask.astype(int), [0]])))
    return [(a, b - 1) for a, b in zip(edges[::2], edges[1::2])]


class Figure(ToolTest):
    def setUp(self):
        super().setUp()
        self.cube = self.folder / "cube.vtu"
        rows = [[p[0], 3.0 * p[1], 0.0] for p in CUBE]
        fields = [("u", [100.0 ** p[0] for p in CUBE]), ("v", rows), ("w", [p[0] for p in CUBE])]
        self.cube.write_text(unit_cube_grid(fields), encoding="utf-8")
        self.image = self.folder / "figure.png"

    def figure(self, *arguments, field="w"):
        return self.summary("render", self.cube, "--field", field, "--plane", "z", "--figure",
            "--size", SIZE, "-o", self.image, *arguments)

    def bar(self):
        """Rows of the topmost bar, and its colours from below."""
        pixels = read_image(self.image)
        # Its frame's left side is the longest black line there, the highest of them.
        frame = (pixels[:, LEFT - 1] == 0).all(axis=1)
        first, last = max((r for r in runs(frame) if r[1] - r[0] > 3 * FONT), key=lambda r: r[1])
        return first + 1, last - 1, pixels[first + 1 : last, LEFT + BAR // 2]

    def ticks(self):
        pixels = read_image(self.image)
        first, last, _ = self.bar()
        marked = (pixels[first - 1 : last + 2, LEFT + BAR + 2] < 128).all(axis=1)
        return [(0.5 * (a + b) + 0.5 - 1.0) / (last - first + 1) for a, b in runs(marked)]

    def test_size_and_picture(self):
        found = self.figure("--buffers", self.folder / "cut.vti")
        self.assertEqual(read_image(self.image).shape, (400, 600, 3))
        self.assertEqual((found["width"], found["height"]), (600 - 11 * FONT, 400))
        pixels = read_image(self.image)[:, : found["width"]]
        self.succeeds("render", self.cube, "--field", "w", "--plane", "z", "--size",
            f"{found['width']}x400", "--samples", 4, "-o", self.folder / "bare.png")
        np.testing.assert_array_equal(pixels, read_image(self.folder / "bare.png"))
        self.assertEqual(read_buffers(self.folder / "cut.vti")["Value"].shape, (400, 490))

    def test_smooth_edges_unless_colours_are_a_legends(self):
        self.assertIn("refined_pixels", self.figure())
        self.assertNotIn("refined_pixels", self.figure("--samples", 1))
        self.assertNotIn("refined_pixels", self.figure("--show-undecided"))

    def test_bar_spans_the_map(self):
        self.figure("--colormap", "grayscale", "--range", "0,1")
        _, _, colors = self.bar()
        part = (np.arange(len(colors)) + 0.5) / len(colors)
        np.testing.assert_allclose(colors[:, 0], 255 * part, atol=2.5)

    def test_ticks_are_where_their_values_are(self):
        for span, values in {"0,1": np.arange(0.0, 1.01, 0.1), "-3,7": np.arange(-3.0, 7.01),
                             "0.13,0.87": np.arange(0.2, 0.81, 0.1),
                             "1e-7,5e-7": np.arange(1e-7, 5.01e-7, 0.5e-7)}.items():
            self.figure("--colormap", "grayscale", "--range", span)
            lower, upper = map(float, span.split(","))
            found = self.ticks()
            expected = (values - lower) / (upper - lower)
            self.assertEqual(len(found), len(expected), f"{span}: {found}")
            np.testing.assert_allclose(found, expected, rtol=0, atol=0.006)

    def test_ticks_of_logarithms(self):
        self.figure("--log", "--colormap", "grayscale", "--range", "1,1000", field="u")
        values = [1, 2, 5, 10, 20, 50, 100, 200, 500, 1000]
        np.testing.assert_allclose(self.ticks(), np.log10(values) / 3.0, rtol=0, atol=0.006)

    def test_scale(self):
        for arguments in [["--parallel-scale", 0.7], []]:
            found = self.figure(*arguments)
            pixels = read_image(self.image)
            # The longest dark line of the column, some pixels high, below the bar.
            first, _, _ = self.bar()
            below = (pixels[: first - 20, LEFT:] < 100).all(axis=2)
            length = max(b - a + 1 for row in below for a, b in runs(row))
            camera = found["camera"]
            if "parallel_scale" in camera:
                unit = 2 * camera["parallel_scale"] / 400
            else:
                distance = camera["position"][2] - 0.5
                unit = 2 * distance * np.tan(np.radians(camera["view_angle"]) / 2) / 400
            steps = np.array([1, 2, 5]) * 10.0 ** np.arange(-3, 2)[:, None]
            self.assertLess(np.abs(length * unit - steps).min(), 3 * unit)
        # A view across has no lengths of its own.
        self.figure("--view", "iso")

    def test_title_and_texts(self):
        self.figure()
        self.assertTrue((read_image(self.image)[390:, :300] == 255).all())
        found = self.figure("--title", "A title (x > 0)")
        self.assertEqual(found["height"], 370)
        self.assertFalse((read_image(self.image)[375:, 200:400] == 255).all())
        texts = texts_of(self.image)
        self.assertIn("PixelExact", texts["Software"])
        self.assertIn("--title 'A title (x > 0)'", texts["Command"])
        self.assertRegex(texts["Source"], r"^cube.vtu: \d+ bytes, xxh3 [0-9a-f]{16}$")
        self.assertRegex(texts["Pixels"], r"^\d+ exact, \d+ nothing, 0 unknown$")
        self.succeeds("render", self.cube, "--field", "w", "-o", self.image, "--size", "9x9")
        self.assertEqual(set(texts_of(self.image)), {"Software"})

    def test_unknown_pixels_are_in_the_legend(self):
        # Of a cell without a volume, in the plane, nothing can be decided.
        flat = [[0.1 * p[0] + 1.1, 0.1 * p[1], 0.5] for p in CUBE]
        cells = [(12, list(range(8))), (12, list(range(8, 16)))]
        for points, there in [(CUBE + flat, True), (CUBE, False)]:
            grid = self.folder / "grid.vtu"
            text = plain_grid(points, cells[: len(points) // 8], [("w", [p[0] for p in points])])
            grid.write_text(text, encoding="utf-8")
            found = self.summary("render", grid, "--plane", "0,0,0.5,0,0,1", "--figure", "--size", SIZE,
                "-o", self.image)
            self.assertEqual(found["pixels"]["unknown"] > 100, there)
            magenta = (read_image(self.image)[:, LEFT:] == [255, 0, 255]).all(axis=2).sum()
            self.assertEqual(magenta, FONT * FONT if there else 0)

    def test_black_background(self):
        self.figure("--background", "0,0,0", "--colormap", "grayscale", "--range", "0,1")
        self.assertTrue((read_image(self.image)[-1] == 0).all())
        self.assertTrue((read_image(self.image)[:, LEFT:] > 200).any())

    def test_no_values(self):
        self.figure("--color", "1,0,0")
        column = read_image(self.image)[200:, LEFT:]
        self.assertTrue((column == 255).all())

    def test_refused(self):
        base = ["render", self.cube, "--field", "w", "-o", self.image]
        for size in ["140x400", "400x150", "20x20"]:
            self.fails(2, *base, "--figure", "--size", size, names=["--figure", "--size"])
        self.fails(2, *base, "--title", "t", names=["--figure"])
        self.fails(2, *base, "--figure", "--font-size", "3", names=["--font-size"])
        self.fails(2, *base, "--figure", "--show", "validity", names=["--figure"])


if __name__ == "__main__":
    unittest.main()
