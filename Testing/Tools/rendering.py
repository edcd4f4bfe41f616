# SPDX-License-Identifier: BSD-3-Clause
"""What the tests of surfaces share: pictures with their buffers, rays in closed form."""

import numpy as np

from tool import CUBE, ToolTest, View, columns, read_buffers, read_csv, read_image, unit_cube_grid

EXACT = 1
# On the unit cube.
EYE = View([2.6, -2.1, 1.9], [0.5, 0.5, 0.5], [0.1, 0.2, 1.0], 60, 48, angle=32.0)


def numbers(values):
    return ",".join(repr(float(v)) for v in values)


class SurfaceTest(ToolTest):
    def render(self, source, *options, field="u"):
        image, buffers = self.folder / "image.png", self.folder / "buffers.vti"
        outputs = ["--output", image, "--buffers", buffers]
        summary = self.summary("render", source, "--field", field, *options, *outputs)
        return summary, read_buffers(buffers), read_image(image)

    def probe(self, source, positions):
        points, out = self.folder / "points.csv", self.folder / "out.csv"
        lines = "".join(numbers(position) + "\n" for position in positions)
        points.write_text("x,y,z\n" + lines, encoding="utf-8")
        self.succeeds("probe", source, "--field", "u", "--points", points, "--output", out)
        return columns(read_csv(out))


def slabs(view, lower, upper):
    """Where rays enter and leave a box, enter > leave where they miss it."""
    origin, direction = view.rays()
    ends = np.stack([(np.asarray(end) - origin) / direction for end in (lower, upper)])
    return ends.min(axis=0).max(axis=-1), ends.max(axis=0).min(axis=-1)


def along(view, t):
    origin, direction = view.rays()
    return origin + t[..., None] * direction


def sphere_hits(view, centre, radius):
    """The nearer and the farther root along each ray, NaN where there is none."""
    origin, direction = view.rays()
    off = origin - np.asarray(centre)
    half = (off * direction).sum(axis=-1)
    square = half**2 - (off**2).sum(axis=-1) + radius**2
    root = np.sqrt(np.where(square >= 0, square, np.nan))
    return -half - root, -half + root


class CurvedTest(SurfaceTest):
    """Of the unit cube, with the fields u = x and v = (x, y, z)."""

    def setUp(self):
        super().setUp()
        self.cube = self.folder / "cube.vtu"
        fields = [("u", [x for x, _, _ in CUBE]), ("v", CUBE)]
        self.cube.write_text(unit_cube_grid(fields), encoding="utf-8")

    def check_hits(self, buffers, view, t, delta=1e-13):
        """Exact where t is finite, and there at t; returns that mask."""
        hit = np.isfinite(t)
        np.testing.assert_array_equal(buffers["Verdict"] == EXACT, hit)
        self.assertEqual((buffers["Verdict"] == EXACT).sum() + (buffers["Verdict"] == 0).sum(), hit.size)
        self.assertGreater(hit.sum(), 200)
        self.assertLess(np.abs(buffers["Depth"] - t)[hit].max(), delta)
        self.assertLess(np.abs(buffers["Position"] - along(view, t))[hit].max(), delta)
        return hit

    def check_elements(self, source, buffers, delta):
        """Values and reference coordinates are those of `probe` at the positions, where it finds
        the same element."""
        exact = buffers["Verdict"] == EXACT
        found = self.probe(source, buffers["Position"][exact])
        inside = found["verdict"] == "inside"
        self.assertGreater(inside.sum(), 0.9 * exact.sum())
        same = inside & (found["element"] == buffers["Element"][exact])
        self.assertGreater(same.sum(), 0.9 * inside.sum())
        xi = np.stack([found[f"xi_{d}"] for d in range(3)], axis=-1)
        self.assertLess(np.abs(xi - buffers["Xi"][exact])[same].max(), delta)
        self.assertLess(np.abs(found["value"] - buffers["Value"][exact])[inside].max(), delta)
