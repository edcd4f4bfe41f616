# SPDX-License-Identifier: BSD-3-Clause
"""--plot of probe and integrate: the lines are where the numbers are, formats, refusals; legends of figures."""

import json
import unittest

import numpy as np

from tool import CUBE, ToolTest, case, read_image, unit_cube_grid

BLUE = (0, 114, 178)
ORANGE = (213, 94, 0)


class Plots(ToolTest):
    def setUp(self):
        super().setUp()
        self.cube = self.grid("cube.vtu", 1.0)
        self.csv = self.folder / "line.csv"

    def grid(self, name, scale):
        path = self.folder / name
        path.write_text(
            unit_cube_grid([("u", [scale * p[0] for p in CUBE]), ("w", [1.0 - p[0] for p in CUBE])]), encoding="utf-8")
        return path

    def series(self):
        """Three time steps, u = k x at time k / 2."""
        for k in (1, 2, 4):
            self.grid(f"step{k}.vtu", float(k))
        path = self.folder / "run.pvd"
        rows = "".join(f'<DataSet timestep="{k / 2}" file="step{k}.vtu"/>' for k in (1, 2, 4))
        path.write_text(
            f'<?xml version="1.0"?><VTKFile type="Collection"><Collection>{rows}</Collection></VTKFile>', encoding="utf-8")
        return path

    def places(self, path, color):
        """Of each column of pixels that has the colour, the middle of its rows, from below."""
        image = read_image(path)[..., :3].astype(int)
        hit = np.all(np.abs(image - np.array(color)) <= 2, axis=2)
        hit[:, int(0.85 * hit.shape[1]):] = False  # without the legend
        columns = np.flatnonzero(hit.any(axis=0))
        return columns, np.array([np.flatnonzero(hit[:, c]).mean() for c in columns])

    def test_lines_are_where_the_values_are(self):
        plot = self.folder / "line.png"
        self.succeeds("probe", self.cube, "--field", "u", "--field", "w", "--line", "0,0.5,0.5,1,0.5,0.5,11",
            "--output", self.csv, "--plot", plot)
        up = self.places(plot, BLUE)
        down = self.places(plot, ORANGE)
        for (columns, rows), sign in ((up, 1.0), (down, -1.0)):
            self.assertGreater(len(columns), 400)
            slope, offset = np.polyfit(columns, rows, 1)
            self.assertGreater(sign * slope, 0.3)
            self.assertLess(np.abs(rows - (slope * columns + offset)).max(), 3.0)
        self.assertTrue(self.csv.exists())

    def test_time(self):
        run, plot = self.series(), self.folder / "time.png"
        self.succeeds("integrate", run, "--field", "u", "--plane", "z=0.5", "--time-step", "all", "--plot", plot)
        columns, rows = self.places(plot, BLUE)
        # The integral is k / 2 at time k / 2: a straight line.
        slope, offset = np.polyfit(columns, rows, 1)
        self.assertGreater(slope, 0.3)
        self.assertLess(np.abs(rows - (slope * columns + offset)).max(), 6.0)
        points = self.folder / "at.csv"
        points.write_text("x,y,z\n0.5,0.5,0.5\n", encoding="utf-8")
        self.succeeds("probe", run, "--field", "u", "--points", points, "--time-step", "all", "--output", self.csv, "--plot", plot)
        self.assertGreater(len(self.places(plot, BLUE)[0]), 400)
        self.fails(1, "integrate", run, "--field", "u", "--plane", "z=0.5", "--time-step", "all", "--plot", plot,
            "--plot-quantity", "Volume", names=["--plot-quantity", "Volume", "Area", "Mean"])

    def test_histogram(self):
        plot = self.folder / "h.png"
        found = self.summary("integrate", self.cube, "--field", "u*u", "--plane", "z=0.5", "--statistics", "4", "--plot", plot)
        image = read_image(plot)[..., :3].astype(int)
        hit = np.all(np.abs(image - np.array(BLUE)) <= 2, axis=2)
        heights = hit.sum(axis=0)
        columns = np.flatnonzero(heights)
        width = (columns[-1] - columns[0] + 1) / 4
        parts = [(one["lower"] + one["upper"]) / 2 for one in found["surfaces"][0]["histogram"]]
        tall = [heights[int(columns[0] + (k + 0.25) * width)] for k in range(4)]
        for k in range(4):
            self.assertAlmostEqual(tall[k] / tall[0], parts[k] / parts[0], delta=0.02)

    def test_formats(self):
        for suffix, begin in (("png", b"\x89PNG"), ("svg", b"<?xml"), ("pdf", b"%PDF-")):
            plot = self.folder / f"line.{suffix}"
            self.succeeds("probe", self.cube, "--field", "u", "--line", "0,0.5,0.5,1,0.5,0.5,11", "--output", self.csv,
                "--plot", plot, "--plot-size", "80x60mm", "--plot-title", "u along x")
            self.assertTrue(plot.read_bytes().startswith(begin))
        self.assertIn(b"<path", (self.folder / "line.svg").read_bytes())

    def test_refusals(self):
        line = ("--line", "0,0.5,0.5,1,0.5,0.5,11")
        self.fails(2, "probe", self.cube, "--field", "u", *line, "--output", self.csv, "--plot", self.folder / "a.txt", names=["--plot"])
        points = self.folder / "at.csv"
        points.write_text("x,y,z\n0.5,0.5,0.5\n", encoding="utf-8")
        self.fails(1, "probe", self.cube, "--field", "u", "--points", points, "--output", self.csv, "--plot", self.folder / "a.png", names=["--line"])
        self.fails(2, "integrate", self.cube, "--field", "u", "--plane", "z=0.5", "--plot", self.folder / "a.png", names=["--statistics"])
        self.fails(2, "probe", self.cube, "--field", "u", *line, "--plot-title", "t", names=["--plot"])


class Legends(ToolTest):
    def test_colours_beyond_the_range_are_named(self):
        cube = self.folder / "cube.vtu"
        cube.write_text(unit_cube_grid([("u", [p[0] for p in CUBE])]), encoding="utf-8")
        colors = self.folder / "map.json"
        colors.write_text(json.dumps([{"Name": "m", "RGBPoints": [0, 1, 0, 1, 1, 0, 1, 0]}]), encoding="utf-8")

        def swatches(*arguments):
            image = self.folder / "a.png"
            self.succeeds("render", cube, "--field", "u", "--plane", "z", "--figure", "--size", "600x450",
                "--colormap", colors, "--samples", "1", "-o", image, *arguments)
            column = read_image(image)[:, 460:, :3]
            return [int(np.all(column == c, axis=2).sum()) for c in ([255, 0, 255], [0, 255, 0])]

        low, high = swatches("--range", "0,1")
        lower, higher = swatches("--range", "0.25,0.75")
        self.assertGreater(lower, low + 40)
        self.assertGreater(higher, high + 40)
        # Above alone.
        same, above = swatches("--range", "0,0.75")
        self.assertLess(same, low + 20)
        self.assertGreater(above, high + 40)

    def test_marks_of_extremes(self):
        cube = self.folder / "cube.vtu"
        cube.write_text(unit_cube_grid([("u", [p[0] + 0.5 * p[1] for p in CUBE])]), encoding="utf-8")
        images = []
        for more in ((), ("--mark-extremes",)):
            image = self.folder / "a.png"
            self.succeeds("render", cube, "--field", "u", "--plane", "z", "--figure", "--size", "600x450", "--view", "+z", "-o", image, *more)
            images.append(read_image(image)[..., :3].astype(int))
        changed = np.argwhere(np.abs(images[1] - images[0]).max(axis=2) > 40)
        # Rings at the lower left and the upper right corner of the square, and nothing in its middle.
        self.assertGreater(len(changed), 100)
        middle = (images[0].shape[0] // 2, 215)
        distance = np.hypot(changed[:, 0] - middle[0], changed[:, 1] - middle[1])
        self.assertGreater(distance.min(), 60)
        self.fails(2, "render", cube, "--plane", "z", "--mark-extremes", "-o", self.folder / "a.png", names=["--figure"])
        done = self.succeeds("render", case("toroid_hex_g3_p6"), "--field", "u", "--boundary", "--figure",
            "--mark-extremes", "--view", "iso", "--size", "400x300", "-o", self.folder / "b.png")
        self.assertEqual(done.stderr.count("is not visible"), done.stderr.count("--mark-extremes"))


if __name__ == "__main__":
    unittest.main()
