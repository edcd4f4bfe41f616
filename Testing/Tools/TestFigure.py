# SPDX-License-Identifier: BSD-3-Clause
"""render --figure, read back from the picture."""

import re
import shutil
import struct
import subprocess
import unittest

import numpy as np

from tool import CUBE, ToolTest, case, plain_grid, read_buffers, read_image, unit_cube_grid

# A figure of 600 x 400 pixels has letters of 10; its layout in these.
SIZE, FONT = "600x400", 10
LEFT = 600 - 10 * FONT + FONT  # of the column beside the picture
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
        # The left side of its frame is the highest long black line there.
        frame = (pixels[:, LEFT - 1] == 0).all(axis=1)
        first, last = max((r for r in runs(frame) if r[1] - r[0] > 3 * FONT), key=lambda r: r[1])
        return first + 1, last - 1, pixels[first + 1 : last, LEFT + BAR // 2]

    def picture(self, found):
        """The pixels of the picture inside the figure."""
        x, y = found["figure"]["picture"]
        return read_image(self.image)[y : y + found["height"], x : x + found["width"]]

    def ticks(self):
        pixels = read_image(self.image)
        first, last, _ = self.bar()
        marked = (pixels[first - 1 : last + 2, LEFT + BAR + 2] < 128).all(axis=1)
        return [(0.5 * (a + b) + 0.5 - 1.0) / (last - first + 1) for a, b in runs(marked)]

    def test_size_and_picture(self):
        found = self.figure("--buffers", self.folder / "cut.vti")
        self.assertEqual(read_image(self.image).shape, (400, 600, 3))
        layout = found["figure"]
        self.assertEqual((layout["width"], layout["height"], layout["font"]), (600, 400, FONT))
        self.assertEqual((layout["legend"], layout["coordinates"]), ("right", True))
        self.succeeds("render", self.cube, "--field", "w", "--plane", "z", "--size",
            f"{found['width']}x{found['height']}", "--samples", 4, "-o", self.folder / "bare.png")
        np.testing.assert_array_equal(self.picture(found), read_image(self.folder / "bare.png"))
        self.assertEqual(read_buffers(self.folder / "cut.vti")["Value"].shape,
            (found["height"], found["width"]))

    def test_layouts_of_an_animation_are_one(self):
        """Arrows appear in some pictures, and the bar stays where it is."""
        self.succeeds("render", self.cube, "--field", "w", "--sweep", "x=0.05:0.95:3", "--range", "0.3,0.7", "--figure",
            "--size", SIZE, "-o", self.folder / "s_%d.png", "-q")
        bars = []
        for k in range(3):
            self.image = self.folder / f"s_{k}.png"
            bars.append(self.bar()[:2])
        self.assertLessEqual(np.ptp(bars, axis=0).max(), 1, bars)

    def test_the_mesh_determines_height_and_legend(self):
        """A box of sides 1, 3 and 12 has cuts that are wide, tall and nearly square."""
        box = self.folder / "box.vtu"
        points = [[p[0], 3.0 * p[1], 12.0 * p[2]] for p in CUBE]
        box.write_text(plain_grid(points, [(12, list(range(8)))], [("u", [p[0] for p in CUBE])]), encoding="utf-8")
        for plane, up, legend, aspect in [
            ("z", "0,1,0", "right", 1 / 3), ("x", "0,0,1", "right", 1 / 4), ("x", "0,1,0", "below", 4.0),
        ]:
            found = self.summary("render", box, "--plane", plane, "--view-up", up, "--figure", "-o", self.image)
            layout = found["figure"]
            self.assertEqual(read_image(self.image).shape[:2], (layout["height"], layout["width"]))
            self.assertEqual((layout["width"], layout["legend"]), (1000, legend))
            # Long pictures are limited.
            self.assertAlmostEqual(found["width"] / found["height"], max(aspect, 1 / 1.6), delta=0.02)
            pixels = self.picture(found)
            rows, columns = np.nonzero((pixels != 255).any(axis=2))
            # The mesh fills its picture.
            filled = max(np.ptp(columns) / found["width"], np.ptp(rows) / found["height"])
            self.assertGreater(filled, 0.88)
        found = self.summary("render", box, "--plane", "x", "--view-up", "0,1,0", "--figure", "--size", "900x400",
            "-o", self.image)
        self.assertEqual(found["figure"]["legend"], "below")
        self.fails(2, "render", box, "--size", "900", "-o", self.image, names=["--size", "--figure", "WIDTHxHEIGHT"])

    def test_coordinates_are_where_their_values_are(self):
        """The mesh ends at 0 and at 1, where there are ticks."""
        for plane, words in [("z", []), ("y", []), ("x", ["--view", "-x"])]:
            found = self.summary("render", self.cube, "--field", "w", "--plane", plane, "--figure", "--size",
                "800x800", "--color", "1,0,0", "-o", self.image, *words)
            self.assertTrue(found["figure"]["coordinates"])
            (x, y), font = found["figure"]["picture"], found["figure"]["font"]
            pixels = read_image(self.image)
            inside = self.picture(found)
            rows, columns = np.nonzero((inside == [255, 0, 0]).all(axis=2))
            tick = font // 4
            below = [0.5 * (a + b) - x for a, b in runs((pixels[y - 1 - tick] < 128).all(axis=1))]
            beside = [0.5 * (a + b) - y for a, b in runs((pixels[:, x - 1 - tick] < 128).all(axis=1))]
            for ends, marks in [(columns, below), (rows, beside)]:
                for end in (ends.min() - 0.5, ends.max() + 0.5):
                    self.assertLess(np.abs(np.array(marks) - end).min(), 1.1, (plane, end, marks))
                # Ticks at round values are evenly spaced.
                self.assertLess(np.ptp(np.diff(marks)), 1.1)
        for words in [["--view", "iso"], ["--axes", "directions"], ["--axes", "none"]]:
            self.assertFalse(self.figure(*words)["figure"]["coordinates"])

    def test_a_cut_across_y_is_not_mirrored(self):
        camera = self.summary("render", self.cube, "--plane", "y", "-o", self.image, "--size", "60x60")["camera"]
        self.assertLess(camera["position"][1], -0.5)
        camera = self.summary("render", self.cube, "--plane", "y", "--view", "+y", "-o", self.image, "--size", "60x60")["camera"]
        self.assertGreater(camera["position"][1], 0.5)

    def test_arrows_where_values_lie_beyond(self):
        for span, low, high in [("0,1", False, False), ("0.2,1", True, False), ("0.2,0.7", True, True)]:
            self.figure("--colormap", "grayscale", "--range", span)
            pixels = read_image(self.image)
            first, last, _ = self.bar()
            middle = pixels[:, LEFT + BAR // 2 - 1 : LEFT + BAR // 2 + 1].min(axis=(1, 2))
            # The colours of the ends, black and white, beyond the bar, and their outlines.
            self.assertEqual((middle[first - 9 : first - 3] < 20).all(), low)
            self.assertEqual((pixels[last + 3 : last + 6, LEFT : LEFT + BAR] < 100).any(), high)

    def test_names_and_units(self):
        pdf = self.folder / "a.pdf"
        words = ["--bar-title", "load", "--unit", "MPa", "--length-unit", "mm", "--bar-ticks", "0.25,0.5"]
        self.succeeds("render", self.cube, "--field", "w", "--plane", "z", "--figure", "--range", "-1,1", *words, "-o", pdf)
        if shutil.which("pdftotext") is None:
            self.skipTest("pdftotext is not installed")
        text = subprocess.run(["pdftotext", "-layout", pdf, "-"], stdout=subprocess.PIPE, check=True, text=True).stdout
        for word in ["load [MPa]", "x [mm]", "0.25", "0.5"]:
            self.assertIn(word, text)
        self.succeeds("render", self.cube, "--field", "w", "--plane", "z", "--figure", "--range=-1.5,1", "-o", pdf)
        text = subprocess.run(["pdftotext", pdf, "-"], stdout=subprocess.PIPE, check=True, text=True).stdout
        # Minus signs are those of print.
        self.assertIn("\N{MINUS SIGN}1.5", text)
        self.assertNotIn("-1", text)
        # VTK's files may state a unit.
        stated = self.folder / "unit.vtu"
        label = '<InformationKey name="UNITS_LABEL" location="vtkDataArray">kg/m³</InformationKey></DataArray>'
        grid = self.cube.read_text(encoding="utf-8")
        stated.write_text(grid.replace("</DataArray>", label, 1), encoding="utf-8")
        first = self.summary("info", stated)["fields"][0]["name"]
        for words, unit in [([], "kg/m³"), (["--unit", "g/l"], "g/l")]:
            self.succeeds("render", stated, "--field", first, "--plane", "z", "--figure", "-o", pdf, *words)
            text = subprocess.run(["pdftotext", pdf, "-"], stdout=subprocess.PIPE, check=True, text=True).stdout
            self.assertIn(f"{first} [{unit}]", text)
            self.assertIn("\n80\n", text)

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
                             "0.13,0.87": np.array([0.13, *np.arange(0.2, 0.81, 0.1), 0.87]),
                             "-3.02,7.4": np.array([-3.02, *np.arange(-2.0, 6.01), 7.4]),
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
            found = self.figure("--axes", "directions", *arguments)
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
        # An oblique view has no lengths of its own.
        self.figure("--view", "iso")

    def test_lit_faces_towards_the_viewer_have_the_bars_colours(self):
        """A parallel view along z shows the cube's upper face and nothing else."""
        look = ["--camera-position", "0.5,0.5,3", "--focal-point", "0.5,0.5,0.5", "--parallel-scale", "0.7"]
        pictures = []
        for lights in ("on", "off"):
            found = self.summary("render", self.cube, "--field", "w", "--boundary", "--lights", lights, *look, "--figure",
                "--size", SIZE, "-o", self.image)
            pictures.append(self.picture(found))
        np.testing.assert_array_equal(*pictures)
        # From the side, colours are between 0.4 of the bar's and the bar's.
        for lights in ("on", "off"):
            self.succeeds("render", self.cube, "--field", "w", "--boundary", "--lights", lights, "--view", "iso",
                "--size", "100x100", "-o", self.image)
            pictures.append(read_image(self.image).astype(float))
        lit, plain = pictures[2:]
        shown = (plain < 250).any(axis=2)
        self.assertTrue((lit[shown] >= 0.4 * plain[shown] - 1).all() and (lit[shown] <= plain[shown] + 1).all())
        self.assertLess(lit[shown].mean(), 0.9 * plain[shown].mean())

    def test_title_and_texts(self):
        plain = self.figure()
        self.assertTrue((read_image(self.image)[392:, :300] == 255).all())
        found = self.figure("--title", "A title (x > 0)")
        self.assertEqual(plain["height"] - found["height"], 2 * FONT)
        rows, columns = np.nonzero((read_image(self.image)[372:, :] < 100).all(axis=2))
        # It stands over the middle of the picture.
        middle = found["figure"]["picture"][0] + 0.5 * found["width"]
        self.assertAlmostEqual(0.5 * (columns.min() + columns.max()), middle, delta=2)
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

    def test_legends_of_other_colours(self):
        """Each colour of a picture that is no field's has its swatch."""
        for words, colors in [(["--owners"], [(168, 212, 240)]), (["--show", "validity"], [(168, 212, 240)])]:
            self.figure(*words)
            column = read_image(self.image)[:, LEFT:]
            for color in colors:
                self.assertEqual((column == color).all(axis=2).sum(), FONT * FONT, words)
        found = self.summary("render", case("periodic_hex_dg_g3_p4"), "--plane", "z", "--show", "jumps", "--figure",
            "--size", SIZE, "-o", self.image)
        _, _, colors = self.bar()
        self.assertGreater(found["jumps"]["jumping"], 100)
        # From yellow to dark purple.
        np.testing.assert_allclose(colors[0], (240, 228, 66), atol=6)
        np.testing.assert_allclose(colors[-1], (75, 0, 80), atol=6)

    def grid(self, point, value):
        """One hexahedron whose corners and values are functions of those of the unit cube."""
        path = self.folder / "grid.vtu"
        points = [point(p) for p in CUBE]
        path.write_text(plain_grid(points, [(12, list(range(8)))], [("u", [value(p) for p in CUBE])]), encoding="utf-8")
        return path

    def words(self, source, *arguments):
        """The texts of a figure as PDF, with their boxes in the page, and the page's size."""
        path = self.folder / "words.pdf"
        self.succeeds("render", source, "--figure", "-o", path, *arguments)
        html = subprocess.run(["pdftotext", "-bbox", path, "-"], stdout=subprocess.PIPE, check=True, text=True).stdout
        page = [float(n) for n in re.search(r'<page width="([\d.]+)" height="([\d.]+)"', html).groups()]
        found = re.findall(r'<word xMin="(.*?)" yMin="(.*?)" xMax="(.*?)" yMax="(.*?)">(.*?)</word>', html)
        return [(word, *map(float, box)) for *box, word in found], page

    @unittest.skipUnless(shutil.which("pdftotext"), "pdftotext is not installed")
    def test_texts_are_within_the_figure(self):
        torus = case("toroid_hex_g3_p6")
        long_title = "A very long title " * 20
        far = self.grid(lambda p: [1e6 + x for x in p], lambda p: p[0])
        for source, *words in [
            (torus, "--plane", "y", "--axes", "none"),
            (torus, "--boundary", "--view", "-y", "--size", "1000x1000"),
            (torus, "--boundary", "--view", "+z", "--size", "400x400", "--range=-1234.5,9876.5"),
            (torus, "--plane", "z", "--title", long_title),
            (torus, "--plane", "z", "--size", "250x900"),
            (torus, "--plane", "z", "--length-unit", "m" * 200),
            (torus, "--plane", "z", "--range", "1,1.000000001"),
            (far, "--plane", "z"),
        ]:
            texts, (width, height) = self.words(source, *words)
            self.assertGreater(len(texts), 4)
            for word, left, top, right, bottom in texts:
                inside = left > -0.5 and right < width + 0.5 and top > -2 and bottom < height + 2
                self.assertTrue(inside, (words, word, left, top, right, bottom, width, height))

    @unittest.skipUnless(shutil.which("pdftotext"), "pdftotext is not installed")
    def test_ends_are_to_a_thousandth_of_the_range(self):
        rng = np.random.default_rng(5)
        spans = [(0.9995, 1.0005), (999.9996, 1000.0004), (28.441, 28.44235), (175188.0, 175399.3)]
        spans += [(m, m * (1 + 10.0 ** -e)) for m, e in zip(rng.uniform(1, 1e4, 6).round(3), range(1, 7))]
        for low, high in spans:
            texts, _ = self.words(self.cube, "--field", "w", "--plane", "z", "--axes", "none", "--range", f"{low!r},{high!r}")
            numbers = []
            for word, *_ in texts:
                try:
                    numbers.append(float(word.replace("\N{MINUS SIGN}", "-")))
                except ValueError:
                    pass
            for end in (low, high):
                self.assertLess(np.abs(np.array(numbers) - end).min(), 0.0011 * (high - low), (low, high, numbers))

    def test_extreme_values_and_ranges(self):
        for value in [lambda p: 5e-324 * (4 * p[2] + 2 * p[1] + p[0]), lambda p: 1e-310 * p[0], lambda p: 1.7e308,
                      lambda p: 0.0, lambda p: -3e-12]:
            self.summary("render", self.grid(list, value), "--plane", "z", "--figure", "--size", SIZE, "-o", self.image)
        for span in ["0,1e-307", "0,1.7e308", "1e-300,1e300"]:
            self.figure("--range", span)
        self.figure("--log", "--range", "1e-300,1e300", field="u")

    def test_long_meshes_fill_the_picture(self):
        for length in (5, 12, 40, 200):
            long = self.grid(lambda p, a=length: [a * p[0], p[1], p[2]], lambda p: p[0])
            found = self.summary("render", long, "--plane", "z", "--figure", "--color", "1,0,0", "-o", self.image)
            columns = np.nonzero((self.picture(found) != 255).any(axis=2))[1]
            self.assertGreater(np.ptp(columns), 0.85 * found["width"], length)
        # A section near the end that is farther from the viewer.
        long = self.grid(lambda p: [30.0 * p[0], p[1], p[2]], lambda p: p[0])
        found = self.summary("render", long, "--plane", "x=10%", "--figure", "--color", "1,0,0", "-o", self.image)
        columns = np.nonzero((self.picture(found) != 255).any(axis=2))[1]
        self.assertGreater(np.ptp(columns), 0.8 * found["width"])

    def test_refused(self):
        base = ["render", self.cube, "--field", "w", "-o", self.image]
        for size in ["30x400", "400x60", "20x20"]:
            self.fails(2, *base, "--figure", "--size", size, names=["--figure", "--size"])
        self.fails(2, *base, "--title", "t", names=["--figure"])
        self.fails(2, *base, "--figure", "--font-size", "3", names=["--font-size"])
        self.fails(2, *base, "--unit", "m", names=["--figure"])
        self.fails(2, *base, "--figure", "--axes", "both", names=["--axes", "coordinates"])
        self.fails(2, *base, "--figure", "--bar-ticks", "x", names=["--bar-ticks", "number of ticks"])
        for words in [["--color", "1,0,0"], ["--show", "validity"], ["--contours", "3", "--contours-only"]]:
            self.fails(2, *base, "--figure", "--unit", "m", *words, names=["--unit", "no effect", "bar"])
        done = self.succeeds(*base, "--figure", "--axes", "coordinates", "--view", "iso", "--length-unit", "m")
        for option in ("--axes coordinates", "--length-unit"):
            self.assertEqual(done.stderr.count(option), 1)
        self.assertIn("--bar-ticks", self.succeeds(*base, "--figure", "--bar-ticks", "5,6").stderr)
        self.fails(2, *base, "--figure", "--size", "40000x100", names=["--figure", "32767", "40000"])
        self.fails(2, *base, "--edges", "0.5pt", names=["--edges", "points", "--size"])
        self.fails(2, *base, "--edges", "40pt", "--size", "85x70mm", names=["--edges", "167 pixels", "32"])


if __name__ == "__main__":
    unittest.main()
