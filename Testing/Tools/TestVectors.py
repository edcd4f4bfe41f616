# SPDX-License-Identifier: BSD-3-Clause
"""render --arrows, where arrows begin and end, read back from an SVG; and --lic, by correlations of its texture."""

import re
import unittest
import xml.etree.ElementTree as ElementTree

import numpy as np

from tool import CUBE, ToolTest, View, case, plain_grid, read_buffers, read_image, unit_cube_grid

SVG = "{http://www.w3.org/2000/svg}"
WIDTH, HEIGHT = 300, 200
# v = (y, -2 x, 0.5), which the unit cube's corners determine.
VECTORS = [[p[1], -2.0 * p[0], 0.5] for p in CUBE]


def vector(x):
    return np.column_stack([x[:, 1], -2.0 * x[:, 0], np.full(len(x), 0.5)])


def project(view, x):
    """Pixels from the lower left."""
    forward = view.focal_point - view.position
    forward /= np.linalg.norm(forward)
    right = np.cross(forward, view.view_up)
    right /= np.linalg.norm(right)
    away = x - view.position
    half = view.scale if view.scale is not None else np.tan(np.radians(view.angle) / 2) * (away @ forward)[:, None]
    return [WIDTH / 2, HEIGHT / 2] + away @ np.column_stack([right, np.cross(right, forward)]) * (HEIGHT / 2) / half


class Arrows(ToolTest):
    def setUp(self):
        super().setUp()
        self.cube = self.folder / "cube.vtu"
        self.cube.write_text(unit_cube_grid([("u", [p[0] for p in CUBE]), ("v", VECTORS)]), encoding="utf-8")
        self.svg = self.folder / "a.svg"

    def draw(self, view, *words, plane="z"):
        """The report, and begins and ends of the arrows in pixels from the lower left."""
        found = self.summary("render", self.cube, "--field", "u", "--plane", plane, *view.options(), "--arrows", "v",
            "-o", self.svg, "--buffers", self.folder / "a.vti", *words)
        root = ElementTree.parse(self.svg).getroot()
        height = float(root.get("height").rstrip("pt"))
        begins, ends = [], []
        for element in root.iter(SVG + "path"):
            style = (element.get("style") or "") + f"fill:{element.get('fill')}"
            numbers = [float(n) for n in re.findall(r"-?\d+\.?\d*(?:e-?\d+)?", element.get("d"))]
            if "fill:rgb(0%,0%,0%)" not in style.replace(" ", "") or len(numbers) < 14:
                continue
            points = np.reshape(numbers[:14], (-1, 2))
            points = np.column_stack([points[:, 0], height - points[:, 1]]) * 300 / 72
            begins.append(0.5 * (points[0] + points[6]))
            ends.append(points[3])
        return found["arrows"], np.array(begins), np.array(ends)

    def check(self, view, *words, plane="z", change=lambda v: v):
        report, begins, ends = self.draw(view, *words, plane=plane)
        # Arrows along the ray are dots.
        self.assertLessEqual(len(begins), report["count"])
        self.assertGreaterEqual(len(begins), report["count"] - 2)
        buffers = read_buffers(self.folder / "a.vti")
        pixel = np.floor(begins).astype(int)
        x = buffers["Position"][pixel[:, 1], pixel[:, 0]]
        self.assertTrue((buffers["Verdict"][pixel[:, 1], pixel[:, 0]] == 1).all())
        v = change(vector(x))
        self.assertAlmostEqual(report["longest"], np.linalg.norm(v, axis=1).max(), delta=1e-12)
        np.testing.assert_allclose(begins, project(view, x), atol=0.02)
        np.testing.assert_allclose(ends, project(view, x + report["scale"] * v), atol=0.05)
        return report, begins, ends

    def test_begins_and_ends(self):
        parallel = View([0.5, 0.5, 3.0], [0.5, 0.5, 0.5], [0.0, 1.0, 0.0], WIDTH, HEIGHT, scale=0.7)
        oblique = View([2.5, -1.5, 2.0], [0.5, 0.5, 0.5], [0.0, 0.0, 1.0], WIDTH, HEIGHT, angle=30)
        for view in (parallel, oblique):
            report, begins, ends = self.check(view)
            self.assertGreater(report["count"], 50)
            # The longest arrow has 1.4 times the spacing.
            self.assertAlmostEqual(np.linalg.norm(ends - begins, axis=1).max(), 1.4 * WIDTH / 30, delta=1.0)
        report, begins, _ = self.check(parallel, "--arrow-spacing", "20", "--arrow-scale", "0.05")
        self.assertEqual(report["scale"], 0.05)
        places = (begins - 10.0) / 20.0
        self.assertLess(np.abs(places - places.round()).max(), 0.05)

    def test_tangential(self):
        view = View([2.5, -1.5, 2.0], [0.5, 0.5, 0.5], [0.0, 0.0, 1.0], WIDTH, HEIGHT, angle=30)
        self.check(view, "--arrows-tangential", change=lambda v: v * [1.0, 1.0, 0.0])

    def test_vectors_are_those_of_the_pixels_element(self):
        """Two elements with a jump between them: the face belongs to one of them."""
        points = [[x, y, z] for part in (0, 1) for x, y, z in [[p[0] + part, p[1], p[2]] for p in CUBE]]
        vectors = [[1.0, 0.0, 0.0]] * 8 + [[0.0, 1.0, 0.0]] * 8
        cells = [(12, list(range(8))), (12, list(range(8, 16)))]
        self.cube.write_text(plain_grid(points, cells, [("u", [p[0] for p in points]), ("v", vectors)]), encoding="utf-8")
        view = View([-3.0, 0.8, 2.5], [1.0, 0.5, 0.5], [0.0, 0.0, 1.0], WIDTH, HEIGHT, angle=30)
        report, begins, ends = self.draw(view, "--boundary=element:1", plane="z=9")
        buffers = read_buffers(self.folder / "a.vti")
        pixel = np.floor(begins).astype(int)
        x = buffers["Position"][pixel[:, 1], pixel[:, 0]]
        self.assertGreater((np.abs(x[:, 0] - 1.0) < 1e-9).sum(), 20)
        np.testing.assert_allclose(ends, project(view, x + report["scale"] * np.array([0.0, 1.0, 0.0])), atol=0.05)

    def test_width_and_colour(self):
        image = self.folder / "a.png"
        base = ["render", self.cube, "--field", "u", "--plane", "z", "--size", "200x200", "--colormap", "grayscale", "-o", image]
        self.succeeds(*base)
        plain = read_image(image).astype(int)
        counts = []
        for width in (1, 4):
            self.succeeds(*base, "--arrows", "v", "--arrow-color", "1,0,0", "--arrow-width", str(width))
            pixels = read_image(image).astype(int)
            red = (pixels[..., 0] > 200) & (pixels[..., 1] < 60)
            counts.append(red.sum())
            # The pixels off the arrows are those of the picture.
            self.assertGreater((pixels == plain).all(axis=2).mean(), 0.3)
        self.assertGreater(counts[1], 1.2 * counts[0])
        self.assertGreater(counts[0], 100)

    def test_points_without_a_vector_have_none(self):
        view = View([0.5, 0.5, 3.0], [0.5, 0.5, 0.5], [0.0, 1.0, 0.0], WIDTH, HEIGHT, scale=0.7)
        vectors = [[float("nan")] * 3 if p[0] > 0 else [1.0, 0.0, 0.0] for p in CUBE]
        self.cube.write_text(unit_cube_grid([("u", [p[0] for p in CUBE]), ("n", vectors)]), encoding="utf-8")
        report = self.summary("render", self.cube, "--field", "u", "--plane", "z", *view.options(), "--arrows", "n",
            "-o", self.svg)["arrows"]
        self.assertEqual((report["count"], report["longest"]), (0, 0))

    def test_legend_and_expressions(self):
        source = case("toroid_hex_g3_p6")
        for words in [[], ["--view", "iso", "--boundary"]]:
            found = self.summary("render", source, "--field", "u", "--arrows", "grad(u)", "--figure", "--plane", "z",
                "--size", "600x500", "-o", self.folder / "a.png", *words)
            self.assertEqual(found["arrows"]["field"], "grad(u)")
            self.assertGreater(found["arrows"]["count"], 100)

    def test_refused(self):
        base = ["render", self.cube, "--field", "u", "--plane", "z", "-o", self.folder / "a.png", "-q"]
        self.fails(1, *base, "--arrows", "u", names=["--arrows", "'u'", "1 component", "3"])
        self.fails(1, *base, "--arrows", "w", names=["'w'"])
        self.fails(2, *base, "--arrow-scale", "2", names=["--arrow-scale", "--arrows"])
        self.fails(2, *base, "--arrows", "v", "--arrow-width", "1pt", names=["--arrow-width", "points"])


class Texture(ToolTest):
    """White surfaces, whose pixels are the texture alone."""

    def setUp(self):
        super().setUp()
        self.cube = self.folder / "cube.vtu"
        # Streamlines on a cut across z are circles about (0.5, 0.5).
        turning = [[0.5 - p[1], p[0] - 0.5, 0.3] for p in CUBE]
        opposite = [[-c for c in v] for v in turning]
        fields = [("u", [p[0] for p in CUBE]), ("v", turning), ("w", opposite), ("z", [[0.0, 0.0, 1.0]] * 8)]
        self.cube.write_text(unit_cube_grid(fields), encoding="utf-8")
        self.image = self.folder / "a.png"

    def draw(self, field, *words):
        report = self.summary("render", self.cube, "--field", "u", "--plane", "z", "--color", "1,1,1", "--background",
            "1,0,0", "--size", "300x300", "--camera-position", "0.5,0.5,3", "--focal-point", "0.5,0.5,0.5",
            "--parallel-scale", "0.5", "--lic", field, "-o", self.image, *words)
        pixels = read_image(self.image).astype(float)
        return report["lic"], pixels[..., 0]

    @staticmethod
    def correlations(texture, length):
        """Of points and others that are so many pixels along a circle, and across it."""
        rows, columns = np.mgrid[0:300, 0:300]
        x, y = columns - 149.5, rows - 149.5
        radius, angle = np.hypot(x, y), np.arctan2(y, x)
        chosen = (radius > 50) & (radius < 130)
        radius, angle = radius[chosen], angle[chosen]
        found = []
        for r, a in [(radius, angle + length / radius), (radius + length, angle)]:
            there = texture[np.round(149.5 + r * np.sin(a)).astype(int), np.round(149.5 + r * np.cos(a)).astype(int)]
            found.append(np.corrcoef(texture[chosen], there)[0, 1])
        return found

    def test_streaks_run_along_the_field(self):
        for field in ("v", "w", "vec(0.5-y,x-0.5,0)"):
            report, texture = self.draw(field)
            self.assertGreater(report["pixels"], 89000)
            # Each vector serves many pixels.
            self.assertLess(report["samples"], 40 * report["pixels"])
            along, across = self.correlations(texture, 8)
            self.assertGreater(along, 0.5, field)
            self.assertLess(abs(across), 0.1, field)
        lengths = [self.correlations(self.draw("v", "--lic-length", n)[1], 16)[0] for n in ("6", "40")]
        self.assertLess(lengths[0], 0.15)
        self.assertGreater(lengths[1], 0.5)

    def test_strength(self):
        _, texture = self.draw("v")
        self.assertAlmostEqual(texture.mean() / 255, 1 - 0.6 * 0.5, delta=0.02)
        self.assertGreaterEqual(texture.min(), 0.4 * 255 - 1)
        _, none = self.draw("v", "--lic-strength", "0")
        self.assertTrue((none == 255).all())

    def test_threads_do_not_matter(self):
        textures = [self.draw("v", "--threads", n)[1] for n in ("1", "2")]
        np.testing.assert_array_equal(*textures)

    def test_no_direction(self):
        """A vector along the normal has no tangential part."""
        report, texture = self.draw("z")
        self.assertEqual(report["pixels"], 0)
        self.assertTrue((texture == 255).all())
        # What remains of it by rounding on an oblique or curved surface is no direction.
        for surface, field in [(["--plane", "0.5,0.5,0.5,0.3,0.4,1"], "vec(0.3,0.4,1)"),
                               (["--sphere", "0.5,0.5,0.5,0.3"], "vec(coords.x-0.5,coords.y-0.5,coords.z-0.5)")]:
            found = self.summary("render", self.cube, "--field", "u", *surface, "--size", "100x100", "--lic", field,
                "-o", self.image)
            self.assertGreater(found["pixels"]["exact"], 1000)
            self.assertLess(found["lic"]["pixels"], 0.001 * found["pixels"]["exact"])

    def test_lines_and_colours_without_values_stay(self):
        words = ["--contours", "0.25,0.5", "--contour-color", "1,0,1", "--contour-width", "4", "--edges", "3",
            "--edge-color", "0,0,1"]
        found = []
        for more in ([], ["--lic", "v"]):
            self.succeeds("render", self.cube, "--field", "u", "--plane", "z", "--colormap", "grayscale", "--size",
                "200x200", "-o", self.image, *words, *more)
            pixels = read_image(self.image)
            found.append((pixels == [255, 0, 255]).all(axis=2).sum())
        self.assertGreater(found[0], 300)
        self.assertEqual(*found)
        self.cube.write_text(unit_cube_grid([("u", [float("nan")] * 8), ("v", VECTORS)]), encoding="utf-8")
        self.succeeds("render", self.cube, "--field", "u", "--plane", "z", "--nan-color", "0,1,0", "--lic", "v",
            "--size", "60x60", "-o", self.image, "-q")
        colors = np.unique(read_image(self.image).reshape(-1, 3), axis=0)
        np.testing.assert_array_equal(colors, [[0, 255, 0], [255, 255, 255]])

    def test_streaks_end_at_other_surfaces(self):
        """A disc one pixel in front of a plane: noise on both sides of its edge is independent."""
        pixel = 1.0 / 300
        for gap in (1.2, 4.0):
            _, texture = self.draw("vec(1,0,0)", "--disc", f"0.5,0.5,{0.5 + gap * pixel},0,0,1,0.25", "--component", "0")
            inside, across = [], []
            for row in range(100, 200, 3):
                edge = 149.5 + np.sqrt((0.25 / pixel) ** 2 - (row - 149.5) ** 2)
                left, right = int(edge) - 3, int(edge) + 4
                across.append((texture[row, left], texture[row, right]))
                inside.append((texture[row, 147], texture[row, 154]))
            self.assertGreater(np.corrcoef(np.transpose(inside))[0, 1], 0.6)
            self.assertLess(abs(np.corrcoef(np.transpose(across))[0, 1]), 0.5)

    def test_on_the_boundary(self):
        found = self.summary("render", case("toroid_hex_g3_p6"), "--boundary", "--view", "iso", "--lic", "vec(-y,x,u)",
            "--size", "200x150", "-o", self.image)
        self.assertGreater(found["lic"]["pixels"], 0.98 * found["pixels"]["exact"])

    def test_refused(self):
        base = ["render", self.cube, "--field", "u", "--plane", "z", "-o", self.image, "-q"]
        self.fails(1, *base, "--lic", "u", names=["--lic", "'u'", "1 component"])
        self.fails(2, *base, "--lic-length", "9", names=["--lic-length", "--lic"])
        self.fails(2, *base, "--lic", "v", "--lic-strength", "2", names=["--lic-strength"])
        self.fails(2, *base, "--lic", "v", "--owners", names=["--lic", "--owners"])
        for option in ("--lic", "--arrows"):
            self.fails(2, "render", self.cube, "--volume", "u", option, "v", "-o", self.image, names=[option, "surface"])


if __name__ == "__main__":
    unittest.main()
