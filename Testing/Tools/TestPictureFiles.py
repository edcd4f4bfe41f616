# SPDX-License-Identifier: BSD-3-Clause
"""Formats of pictures, their lengths, backgrounds and letters, read back from the files."""

import struct
import unittest
import zlib

import numpy as np

from tool import ToolTest, read_image, read_with, unit_cube_grid

from TestFigure import texts_of

INCH = 25.4


def chunks(path):
    """Of a PNG: (kind, data), with their sums checked."""
    data, at, found = path.read_bytes(), 8, []
    while at < len(data):
        length, kind = struct.unpack(">I4s", data[at : at + 8])
        body = data[at + 8 : at + 8 + length]
        (check,) = struct.unpack(">I", data[at + 8 + length : at + 12 + length])
        assert check == zlib.crc32(kind + body), kind
        found.append((kind, body))
        at += 12 + length
    return found


def tiff_tags(path):
    """Numbers and texts of a TIFF's first directory, by tag."""
    data = path.read_bytes()
    order = {b"II": "<", b"MM": ">"}[data[:2]]
    (at,) = struct.unpack(order + "I", data[4:8])
    (count,) = struct.unpack(order + "H", data[at : at + 2])
    tags = {}
    for i in range(count):
        entry = at + 2 + 12 * i
        tag, kind, number = struct.unpack(order + "HHI", data[entry : entry + 8])
        (place,) = struct.unpack(order + "I", data[entry + 8 : entry + 12])
        if kind == 2:
            begin = place if number > 4 else entry + 8
            tags[tag] = data[begin : begin + number - 1].decode()
        elif kind == 5:
            top, bottom = struct.unpack(order + "II", data[place : place + 8])
            tags[tag] = top / bottom
        elif kind == 3 and number == 1:
            (tags[tag],) = struct.unpack(order + "H", data[entry + 8 : entry + 10])
    return tags


def read_rgba(path):
    """Lower left first; by Pillow, because VTK's reader mistakes a TIFF's alpha."""
    try:
        from PIL import Image
    except ImportError as missing:
        raise unittest.SkipTest("Pillow (python3-pil) is not there") from missing
    with Image.open(path) as image:
        return np.asarray(image)[::-1]


class FileTest(ToolTest):
    def setUp(self):
        super().setUp()
        self.cube = self.folder / "cube.vtu"
        self.cube.write_text(unit_cube_grid(), encoding="utf-8")

    def render(self, name, *arguments):
        path = self.folder / name
        self.succeeds("render", self.cube, "--field", "u", "--plane", "z", "-o", path, *arguments)
        return path


class Files(FileTest):
    def test_formats_hold_the_same_pixels(self):
        shot = ["--size", "300x240", "--figure", "--title", "t"]
        png = read_image(self.render("a.png", *shot))
        for name in ["a.tif", "a.TIFF"]:
            # VTK's reader leaves the rows in the order of the file, which is from above.
            pixels = read_with("vtkTIFFReader", self.render(name, *shot))[::-1]
            self.assertEqual(tiff_tags(self.folder / name)[274], 1)
            np.testing.assert_array_equal(pixels, png)
        for name in ["a.jpg", "a.jpeg"]:
            pixels = read_with("vtkJPEGReader", self.render(name, *shot)).astype(int)
            self.assertEqual(pixels.shape, png.shape)
            # Letters and edges blur.
            self.assertLess(np.abs(pixels - png).mean(), 3.0)

    def test_quality_of_jpeg(self):
        base = ["--size", "300x240", "--figure"]
        bytes_of = {quality: self.render("a.jpg", *base, "--jpeg-quality", quality).read_bytes()
                    for quality in (10, 95)}
        comment = bytes_of[95].index(b"\xff\xfe")
        self.assertLess(len(bytes_of[10]), len(bytes_of[95]) / 2)
        usual = self.render("a.jpg", *base).read_bytes()
        self.assertEqual(usual[:comment], bytes_of[95][:comment])
        self.assertEqual(usual[-1000:], bytes_of[95][-1000:])
        self.fails(2, "render", self.cube, "-o", self.folder / "a.png", "--jpeg-quality", 50,
            names=["--jpeg-quality", ".jpg"])

    def test_other_suffixes(self):
        for name in ["a.gif", "a", "a.png.txt", "a.bmp"]:
            self.fails(2, "render", self.cube, "-o", self.folder / name, names=["--output", ".tif"])

    def test_lengths_become_pixels(self):
        for size, dpi, expected in [
            ("30x20mm", None, (30 / INCH * 300, 20 / INCH * 300)),
            ("30x20mm", 120, (30 / INCH * 120, 20 / INCH * 120)),
            ("1.5x0.75in", 100, (150, 75)),
            ("64x48", 100, (64, 48)),
        ]:
            image = read_image(
                self.render("a.png", "--size", size, *(["--dpi", dpi] if dpi else []))
            )
            self.assertEqual(image.shape[1::-1], tuple(round(side) for side in expected))

    def test_files_tell_their_lengths(self):
        shot = ["--size", "20x10mm", "--dpi", 254]
        physical = [body for kind, body in chunks(self.render("a.png", *shot)) if kind == b"pHYs"]
        self.assertEqual(physical, [struct.pack(">IIB", 10000, 10000, 1)])
        kinds = [kind for kind, _ in chunks(self.folder / "a.png")]
        self.assertLess(kinds.index(b"pHYs"), kinds.index(b"IDAT"))
        self.assertEqual(kinds[0], b"IHDR")
        tags = tiff_tags(self.render("a.tif", *shot))
        self.assertEqual((tags[282], tags[283], tags[296]), (254, 254, 2))
        data = self.render("a.jpg", *shot).read_bytes()
        self.assertEqual(data[6:11], b"JFIF\0")
        self.assertEqual(struct.unpack(">BHH", data[13:18]), (1, 254, 254))
        # Pixels alone have none.
        self.assertNotIn(b"pHYs", [k for k, _ in chunks(self.render("b.png", "--size", "9x9"))])
        self.assertNotIn(282, tiff_tags(self.render("b.tif", "--size", "9x9")))
        self.assertIn(b"pHYs", [k for k, _ in chunks(self.render("b.png", "--size", "9x9", "--dpi", 72))])

    def test_files_tell_where_they_come_from(self):
        shot = ["--size", "300x240", "--figure"]
        png = texts_of(self.render("a.png", *shot))
        told = tiff_tags(self.render("a.tif", *shot))
        self.assertIn("PixelExact", told[305])
        comment = self.render("a.jpg", *shot).read_bytes()
        for key in ["Source", "Pixels"]:
            self.assertIn(f"{key}: {png[key]}", told[270])
            self.assertIn(f"{key}: {png[key]}".encode(), comment)
        self.assertIn("a.tif", told[270])

    def test_refused_lengths(self):
        base = ["render", self.cube, "-o", self.folder / "a.png"]
        for size in ["20mm", "0x10mm", "-3x4mm", "20x10cm", "1e9x1e9mm", "0.01x0.01mm", "nanx3in"]:
            self.fails(2, *base, "--size", size, names=["--size"])
        for dpi in ["0", "x", "-1", "1e9"]:
            self.fails(2, *base, "--size", "20x10mm", "--dpi", dpi, names=["--dpi"])

    def test_letters_have_a_size_in_print(self):
        shot = ["--size", "80x60mm", "--figure", "--colormap", "grayscale"]
        half = read_image(self.render("a.png", *shot, "--dpi", 150))
        whole = read_image(self.render("b.png", *shot, "--dpi", 300))
        # The column is as wide in print: what is not white right of the picture.
        def left(pixels):
            dark = (pixels[:, pixels.shape[1] // 2 :] < 100).all(axis=2).any(axis=0)
            return 1.0 - np.argmax(dark) / dark.size

        self.assertAlmostEqual(left(half), left(whole), delta=0.06)
        self.fails(2, "render", self.cube, "--figure", "--font-size", "7pt", "-o",
            self.folder / "a.png", names=["--font-size", "--size"])


class Backgrounds(FileTest):
    def test_named_colours(self):
        shot = ["--size", "60x40", "--parallel-scale", "0.8"]
        for name, value in [("white", 255), ("black", 0)]:
            pixels = read_image(self.render("a.png", *shot, "--background", name))
            self.assertEqual(pixels.shape[2], 3)
            self.assertTrue((pixels[0] == value).all())

    def test_none_is_transparent(self):
        shot = ["--size", "60x40", "--parallel-scale", "0.8"]
        white = read_image(self.render("w.png", *shot))
        for name in ["a.png", "a.tif"]:
            pixels = read_rgba(self.render(name, *shot, "--background", "none"))
            self.assertEqual(pixels.shape[2], 4)
            seen = pixels[..., 3] == 255
            np.testing.assert_array_equal(seen, pixels[..., 3] > 0)
            # The cube's cut is a square of 1 in a height of 1.6.
            self.assertAlmostEqual(seen.sum(), (40 / 1.6) ** 2, delta=60)
            # Straight colours, which stay as they are.
            np.testing.assert_array_equal(pixels[seen][:, :3], white[seen])
        self.assertEqual(tiff_tags(self.folder / "a.tif")[338], 2)

    def test_figures_are_transparent_too(self):
        shot = ["--size", "600x400", "--figure", "--title", "A", "--contours", "3"]
        white = read_image(self.render("w.png", *shot)).astype(float)
        pixels = read_image(self.render("a.png", *shot, "--background", "none")).astype(float)
        alpha = pixels[..., 3:] / 255.0
        # Over white it is the figure on white.
        over = alpha * pixels[..., :3] + (1.0 - alpha) * 255.0
        self.assertLess(np.abs(over - white).max(), 2.01)
        self.assertTrue((pixels[0, :, 3] == 0).all())
        self.assertGreater((pixels[..., 3] == 255).sum(), 10000)

    def test_refused(self):
        base = ["render", self.cube, "-o", self.folder / "a.jpg"]
        self.fails(2, *base, "--background", "none", names=["--background", ".png"])
        base[-1] = self.folder / "a.png"
        for color in ["red", "1,1", "2,0,0", ""]:
            self.fails(2, *base, f"--background={color}", names=["--background"])


class Letters(FileTest):
    def test_fonts_differ(self):
        shot = ["--size", "600x400", "--figure", "--axes", "none", "--title", "Wagner 0123"]
        sans, serif = [read_image(self.render("a.png", *shot, "--font", font)) for font in ("sans", "serif")]
        np.testing.assert_array_equal(sans, read_image(self.render("b.png", *shot)))
        # The title's letters, not the picture.
        self.assertTrue((sans[370:] != serif[370:]).any())
        np.testing.assert_array_equal(sans[30:360, 30:460], serif[30:360, 30:460])
        labelled = ["--size", "400x400", "--contours", "5", "--contour-labels", "14"]
        first, second = [read_image(self.render("c.png", *labelled, "--font", font)) for font in ("sans", "serif")]
        self.assertTrue((first != second).any())

    def test_a_file(self):
        import glob

        fonts = sorted(glob.glob("/usr/share/fonts/**/*.ttf", recursive=True))
        if not fonts:
            self.skipTest("there is no font file on this machine")
        shot = ["--size", "600x400", "--figure", "--axes", "none", "--title", "Wagner 0123"]
        sans = read_image(self.render("a.png", *shot))
        mine = read_image(self.render("b.png", *shot, "--font", fonts[-1]))
        self.assertTrue((sans[370:] != mine[370:]).any())

    def test_refused(self):
        base = ["render", self.cube, "--figure", "-o", self.folder / "a.png"]
        self.fails(1, *base, "--font", self.folder / "absent.ttf", names=["--font", "absent.ttf"])
        self.fails(1, *base, "--font", self.cube, names=["--font", self.cube])


if __name__ == "__main__":
    unittest.main()
