# SPDX-License-Identifier: BSD-3-Clause
"""render --arrows: where arrows begin and end, read back from an SVG."""

import re
import unittest
import xml.etree.ElementTree as ElementTree

import numpy as np

from tool import CUBE, ToolTest, View, case, read_buffers, read_image, unit_cube_grid

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


if __name__ == "__main__":
    unittest.main()
