# SPDX-License-Identifier: BSD-3-Clause
"""Where the mesh is, drawn over a cut."""

import unittest

import numpy as np

from rendering import EYE
from tool import ToolTest, View, read_image, unit_cube_grid

RED = ["--mesh-outline-color", "1,0,0", "--color", "0,0,1"]


def project(view, point):
    """In pixels from the lower left."""
    forward = view.focal_point - view.position
    forward /= np.linalg.norm(forward)
    right = np.cross(forward, view.view_up)
    right /= np.linalg.norm(right)
    up = np.cross(right, forward)
    off = np.asarray(point, float) - view.position
    half = np.tan(np.radians(view.angle) / 2) * (off @ forward)
    width, height = view.size
    return width / 2 + off @ right / half * height / 2, height / 2 + off @ up / half * height / 2


def distances(shape, segments):
    """From pixels' centres to the nearest of some segments."""
    height, width = shape
    y, x = np.mgrid[0:height, 0:width] + 0.5
    nearest = np.full(shape, np.inf)
    for (ax, ay), (bx, by) in segments:
        dx, dy = bx - ax, by - ay
        s = np.clip(((x - ax) * dx + (y - ay) * dy) / (dx * dx + dy * dy), 0, 1)
        nearest = np.minimum(nearest, np.hypot(x - ax - s * dx, y - ay - s * dy))
    return nearest


# Corners by their coordinates' bits; the edges of the unit cube.
CORNERS = [np.array([k & 1, k >> 1 & 1, k >> 2 & 1], float) for k in range(8)]
EDGES = [(k, k | bit) for k in range(8) for bit in (1, 2, 4) if not k & bit]


class Outline(ToolTest):
    def setUp(self):
        super().setUp()
        self.cube = self.folder / "cube.vtu"
        self.cube.write_text(unit_cube_grid(), encoding="utf-8")
        self.view = View(EYE.position, EYE.focal_point, EYE.view_up, 300, 240, angle=EYE.angle)

    def lines(self, *arguments):
        """Of each pixel, how red it is: 0 to 1."""
        image = self.folder / "a.png"
        self.succeeds("render", self.cube, *self.view.options(), *RED, *arguments, "-o", image)
        pixels = read_image(image).astype(float) / 255.0
        # White, blue, and red over them.
        return np.minimum(pixels[..., 0], 1.0 - pixels[..., 1])

    def segments(self, hidden):
        """Edges as they are seen; those at the corner farthest from the eye are hidden."""
        far = np.argmax([np.linalg.norm(corner - self.view.position) for corner in CORNERS])
        return [(project(self.view, CORNERS[a]), project(self.view, CORNERS[b]))
                for a, b in EDGES if hidden or far not in (a, b)]

    def test_boundary(self):
        lines = self.lines("--plane", "z", "--mesh-outline")
        near = distances(lines.shape, self.segments(hidden=False))
        # A width of 1.5, to half a pixel.
        self.assertTrue((lines[near > 2.3] == 0).all())
        self.assertGreater(lines[near < 0.25].min(), 0.2)
        self.assertGreater(lines[near < 0.25].mean(), 0.85)

    def test_box(self):
        lines = self.lines("--plane", "z", "--mesh-outline=box", "--mesh-outline-width", 3)
        near = distances(lines.shape, self.segments(hidden=True))
        self.assertTrue((lines[near > 2.6] == 0).all())
        # All that the plane does not hide: it does so with the edges at the far corner alone.
        seen = distances(lines.shape, self.segments(hidden=False))
        self.assertGreater(lines[seen < 0.5].min(), 0.9)
        bare = read_image(self.folder / "a.png")
        inside = (near < 0.5) & (seen > 4.0)
        self.assertGreater((bare[inside][:, 2] == 255).sum(), 10)  # blue or white, not red
        self.assertGreater((lines[inside] > 0.9).sum(), 10)

    def test_undeformed(self):
        before = self.lines("--plane", "z", "--mesh-outline")
        warp = ["--warp", "u=0.2", "--warp-direction", "1,0,0"]
        after = self.lines("--plane", "z", "--mesh-outline=undeformed", *warp)
        np.testing.assert_array_equal(after, before)
        self.assertGreater(
            np.abs(self.lines("--plane", "z", "--mesh-outline", *warp) - before).max(), 0.9)
        self.fails(2, "render", self.cube, "--field", "u", "--plane", "z",
            "--mesh-outline=undeformed", "-o", self.folder / "a.png", names=["--warp"])

    def test_camera_sees_all_of_it(self):
        image = self.folder / "a.png"
        for kind in ["--mesh-outline", "--mesh-outline=box"]:
            self.succeeds("render", self.cube, "--plane", "z", "--view", "iso", "--size", "120x90",
                *RED, kind, "-o", image)
            pixels = read_image(image).astype(float) / 255.0
            red = np.minimum(pixels[..., 0], 1.0 - pixels[..., 1]) > 0.5
            self.assertFalse(red[[0, -1]].any() or red[:, [0, -1]].any())
            rows = np.flatnonzero(red.any(axis=1))
            self.assertGreater(rows[-1] - rows[0], 70)

    def test_transparent_background(self):
        image = self.folder / "a.png"
        self.succeeds("render", self.cube, *self.view.options(), "--plane", "z", "--mesh-outline",
            "--background", "none", "-o", image)
        pixels = read_image(image)
        near = distances(pixels.shape[:2], self.segments(hidden=False))
        self.assertGreater(pixels[near < 0.25][:, 3].mean(), 200)

    def test_refused(self):
        base = ["render", self.cube, "-o", self.folder / "a.png"]
        self.fails(2, *base, "--mesh-outline=all", names=["--mesh-outline", "box"])
        self.fails(2, *base, "--mesh-outline-width", 2, names=["--mesh-outline"])
        for width in ["0", "-1", "1000"]:
            self.fails(2, *base, "--mesh-outline", "--mesh-outline-width", width,
                names=["--mesh-outline-width"])


if __name__ == "__main__":
    unittest.main()
