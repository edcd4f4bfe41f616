# SPDX-License-Identifier: BSD-3-Clause
"""integrate --norms, --extremes, --statistics, --correlate: closed forms on cubes, and pixels."""

import math
import unittest

import numpy as np

from tool import CUBE, ToolTest, case, read_buffers, unit_cube_grid


class Statistics(ToolTest):
    def setUp(self):
        super().setUp()
        self.cube = self.folder / "cube.vtu"
        self.cube.write_text(
            unit_cube_grid([("u", [p[0] for p in CUBE]), ("w", [p[1] for p in CUBE])]), encoding="utf-8")

    def found(self, *arguments):
        summary = self.summary("integrate", *arguments)["surfaces"][0]
        return summary, {row["quantity"]: row for row in summary["rows"]}

    def holds(self, row, value, error=0.0):
        """The proven interval holds the value."""
        self.assertLessEqual(row["lower"], value + error + 1e-14, row)
        self.assertGreaterEqual(row["upper"], value - error - 1e-14, row)

    def test_norms_in_closed_form(self):
        _, rows = self.found(self.cube, "--field", "u", "--plane", "z=0.5", "--norms")
        self.holds(rows["L1"], 0.5)
        self.holds(rows["L2"], math.sqrt(1 / 3))
        self.holds(rows["Linf"], 1.0)
        for name in ("L1", "L2", "Linf"):
            self.assertLess(rows[name]["error_bound"], 1e-6)
        # A change of sign, below, and a vector.
        _, rows = self.found(self.cube, "--field", "u - 1/3", "--plane", "z=0.5", "--norms")
        self.holds(rows["L1"], 5 / 18)
        self.assertLess(rows["L1"]["error_bound"], 1e-3)
        self.holds(rows["L2"], 1 / 3)
        self.holds(rows["Linf"], 2 / 3)
        _, rows = self.found(self.cube, "--field", "u - 2", "--plane", "z=0.5", "--norms")
        self.holds(rows["L1"], 1.5)
        self.holds(rows["Linf"], 2.0)
        _, rows = self.found(self.cube, "--field", "vec(u, 2*w, 0*u)", "--plane", "z=0.5", "--norms")
        self.holds(rows["L2"], math.sqrt(5 / 3))
        self.holds(rows["Linf"], math.sqrt(5))

    def test_extremes_on_a_plane_and_on_the_boundary(self):
        field = "4 - (u - 0.25)^2 - (w - 0.75)^2 - z"
        for surface, height in ((("--plane", "z=0.5"), 0.5), (("--boundary",), 0.0)):
            summary, rows = self.found(self.cube, "--field", field, *surface, "--extremes", "--tolerance", "1e-6")
            high = rows["Maximum"]
            self.holds(high, 4.0 - height)
            self.assertLess(high["error_bound"], 1e-5)
            np.testing.assert_allclose(high["at"], [0.25, 0.75, height], rtol=0, atol=5e-3)
            self.assertLessEqual(high["value_at"], high["upper"])
            self.assertEqual(high["element"], 0)
            low = 4.0 - 2 * 0.75**2 - (0.5 if height else 1.0)
            self.holds(rows["Minimum"], low)
            np.testing.assert_allclose(rows["Minimum"]["at"][:2], [1.0, 0.0], rtol=0, atol=1e-9)
        text = self.succeeds("integrate", self.cube, "--field", "u", "--plane", "z=0.5", "--extremes").stdout
        self.assertRegex(text, r"Maximum +1\S* \+- .* at \(1, [0-9.e-]+, 0.5\), element 0")

    def test_clips_bound_the_extremes(self):
        _, rows = self.found(
            self.cube, "--field", "u + w", "--plane", "z=0.5", "--clip", "0.25,0,0,-1,0,0", "--extremes", "--tolerance", "1e-6")
        self.holds(rows["Maximum"], 1.25)
        self.assertLess(rows["Maximum"]["error_bound"], 1e-5)
        self.holds(rows["Minimum"], 0.0)

    def test_statistics_in_closed_form(self):
        summary, rows = self.found(
            self.cube, "--field", "u*u", "--plane", "z=0.5", "--statistics", "4", "--correlate", "u + w", "--tolerance", "1e-6")
        self.holds(rows["Mean"], 1 / 3)
        self.holds(rows["Variance"], 1 / 5 - 1 / 9)
        self.holds(rows["Deviation"], math.sqrt(1 / 5 - 1 / 9))
        self.assertLess(rows["Variance"]["error_bound"], 1e-6)
        for part in (0.05, 0.25, 0.5, 0.75, 0.95):
            row = rows[f"Quantile {part}"]
            self.holds(row, part**2)
            self.assertLess(row["upper"] - row["lower"], 0.03)
        classes = summary["histogram"]
        self.assertEqual(len(classes), 4)
        for k, one in enumerate(classes):
            self.assertAlmostEqual(one["from"], k / 4, delta=1e-5)
            part = math.sqrt(one["to"]) - math.sqrt(max(one["from"], 0.0))
            self.assertLessEqual(one["lower"], part + 1e-5)
            self.assertGreaterEqual(one["upper"], part - 1e-5)
            self.assertLess(one["upper"] - one["lower"], 0.02)
        # cov(u^2, u + w) = 1/4 - 1/6, var(u + w) = 1/6.
        self.holds(rows["Correlation"], (1 / 12) / math.sqrt(4 / 45 / 6))
        self.assertLess(rows["Correlation"]["error_bound"], 1e-5)

    def test_pixels(self):
        """Pixels of equal area give the mean, the deviation, the extremes and the quantiles."""
        path = case("toroid_hex_g3_p6")
        buffers = self.folder / "cut.vti"
        self.succeeds(
            *("render", path, "--field", "u", "--plane", "z=0.1", "--view", "+z", "--parallel-scale", "1.6"),
            *("--size", "500x500", "--output", self.folder / "cut.png", "--buffers", buffers))
        arrays = read_buffers(buffers)
        values = arrays["Value"][arrays["Verdict"] == 1]
        summary, rows = self.found(
            path, "--field", "u", "--plane", "z=0.1", "--statistics", "8", "--extremes", "--norms", "--tolerance", "1e-4")
        self.assertLessEqual(rows["Minimum"]["lower"], values.min() + 1e-12)
        self.assertGreaterEqual(rows["Maximum"]["upper"], values.max() - 1e-12)
        self.assertAlmostEqual(rows["Maximum"]["value"], values.max(), delta=1e-3)
        self.holds(rows["Mean"], values.mean(), 3e-3)
        self.holds(rows["Deviation"], values.std(), 3e-3)
        self.assertAlmostEqual(rows["Quantile 0.5"]["value"], np.median(values), delta=5e-3)
        area = rows["Area"]["value"]
        self.holds(rows["L1"], area * np.abs(values).mean(), 3e-3 * area)
        for one in summary["histogram"]:
            part = np.mean((values >= one["from"]) & (values < one["to"]))
            self.assertLessEqual(one["lower"], part + 5e-3)
            self.assertGreaterEqual(one["upper"], part - 5e-3)

    def test_a_constant_field(self):
        summary, rows = self.found(self.cube, "--field", "2 + 0*u", "--plane", "z=0.5", "--statistics", "3", "--norms")
        self.holds(rows["L1"], 2.0)
        self.holds(rows["Variance"], 0.0)
        self.holds(rows["Quantile 0.5"], 2.0)

    def test_refusals(self):
        self.fails(1, "integrate", self.cube, "--field", "vec(u,w,u)", "--plane", "z=0.5", "--statistics", "3", names=["scalar"])
        self.fails(1, "integrate", self.cube, "--field", "u", "--plane", "z=0.5", "--correlate", "vec(u,w,u)", names=["scalars"])
        self.fails(1, "integrate", self.cube, "--field", "u", "--plane", "z=0.5", "--correlate", "nothing", names=["nothing"])
        self.fails(2, "integrate", self.cube, "--plane", "z=0.5", "--statistics", "1", names=["--statistics"])


if __name__ == "__main__":
    unittest.main()
