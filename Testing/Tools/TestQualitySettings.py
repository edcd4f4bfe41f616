# SPDX-License-Identifier: BSD-3-Clause
"""--stride and --truncate-order: what they show, that they tell it, and what they bound."""

import unittest

import numpy as np

from TestDifference import lagrange_grid
from tool import MIDDLE, ToolTest, View, case, read_buffers, read_csv

VIEW = View([0.0, 0.0, 6.0], [0.0, 0.0, 0.1], [0.0, 1.0, 0.0], 101, 90, angle=30.0)
CUT = ["--field", "u", "--plane", "z=0.1"]


class QualitySettings(ToolTest):
    def render(self, path, *options, cut=CUT):
        buffers = self.folder / "b.vti"
        summary = self.summary(
            *["render", path, *cut, *options, *VIEW.options()],
            *["--output", self.folder / "i.png", "--buffers", buffers],
        )
        return summary, read_buffers(buffers)

    def told(self):
        return (self.folder / "i.png").read_bytes()


class Stride(QualitySettings):
    def test_blocks_show_their_middle_pixel(self):
        path = case("toroid_hex_g3_p6")
        _, every = self.render(path)
        self.assertNotIn(b"Given up", self.told())
        summary, found = self.render(path, "--stride", 3)
        self.assertEqual(summary["stride"], 3)
        self.assertIn(b"stride 3", self.told())
        middle = every["Value"][1::3, 1::3]
        # 101 is no multiple of 3: of the last block the middle one is there.
        shown = np.repeat(np.repeat(middle, 3, axis=0), 3, axis=1)[:90, :101]
        np.testing.assert_array_equal(found["Value"], shown)
        self.assertEqual(summary["pixels"]["exact"], (found["Verdict"] == 1).sum())

    def test_what_is_of_each_pixel_is_refused(self):
        path = case("toroid_hex_g3_p6")
        for options in [
            ["--contours", "3"],
            ["--samples", "4"],
            ["--edges"],
            ["--outlines"],
            ["--owners"],
            ["--mesh-outline"],
        ]:
            arguments = ["render", path, *CUT, "--stride", "2", *options]
            self.fails(2, *arguments, names=["--stride", options[0]])
        self.fails(2, "render", path, *CUT, "--stride", "0", names=["--stride"])
        self.fails(2, "compare", path, *CUT, "--stride", "2", names=["--stride"])
        arguments = ["compare", path, *CUT, "--with", path, "--stride", "2"]
        self.fails(2, *arguments, names=["--stride"])


class Truncated(QualitySettings):
    def test_the_change_is_within_its_bound(self):
        for name in ["toroid_hex_g3_p6", "toroid_prism_g3_p4", "escher_tet_g3_p3"]:
            path = case(name)
            _, every = self.render(path)
            for order in [5, 3, 2, 1]:
                summary, found = self.render(path, "--truncate-order", order)
                truncated = summary["truncated"][0]
                self.assertEqual((truncated["field"], truncated["order"]), ("u", order))
                both = (every["Verdict"] == 1) & (found["Verdict"] == 1)
                np.testing.assert_array_equal(every["Verdict"], found["Verdict"])
                change = np.abs(every["Value"] - found["Value"])[both].max()
                bound = truncated["largest_change"]
                self.assertLessEqual(change, bound + 1e-14)
                # And no far one: the cut is a part of the mesh.
                self.assertLessEqual(bound, max(50.0 * change, 1e-300))
                if truncated["dropped"] > 0:
                    self.assertIn(f"truncated to order {order}".encode(), self.told())

    def test_is_the_projection_in_the_mean_square(self):
        # x^3 on [0,1], one cell: of order 2 it is x^3 less its Legendre mode, of length 1/20.
        path = self.folder / "cubic.vtu"
        path.write_text(lagrange_grid(lambda x, y, z: x**3, 1, 3), encoding="utf-8")
        view = View([0.5, 0.5, 5.0], [0.5, 0.5, 0.5], [0.0, 1.0, 0.0], 80, 80, scale=0.6)
        buffers = self.folder / "b.vti"
        summary = self.summary(
            *["render", path, "--field", "u", "--plane", "z=0.5", "--truncate-order", 2],
            *[*view.options(), "--output", self.folder / "i.png", "--buffers", buffers],
        )
        found = read_buffers(buffers)
        exact = found["Verdict"] == 1
        x = found["Position"][exact][:, 0]
        s = 2.0 * x - 1.0
        expected = x**3 - (5.0 * s**3 - 3.0 * s) / 2.0 / 20.0
        np.testing.assert_allclose(found["Value"][exact], expected, atol=1e-14)
        truncated = summary["truncated"][0]
        self.assertEqual((truncated["modes"], truncated["dropped"]), (64, 64 - 27))
        self.assertAlmostEqual(truncated["largest_change"], 1.0 / 20.0, delta=1e-3)
        self.assertGreaterEqual(truncated["largest_change"], 1.0 / 20.0 - 1e-15)

    def test_differences_from_the_whole_field_are_those_of_the_truncation(self):
        path = case("toroid_hex_g3_p6")
        summary = self.summary(
            *["compare", path, *CUT, "--truncate-order", 3, "--with", path],
            *["--size", "300x300", "-o", self.folder / "d.png"],
        )
        change = summary["truncated"][0]["largest_change"]
        self.assertGreater(summary["pixels"]["largest"], 0.0)
        self.assertLessEqual(summary["pixels"]["largest_true"][1], change)
        self.assertIn(b"truncated to order 3", (self.folder / "d.png").read_bytes())

    def test_orders_that_are_none_are_refused(self):
        path = case("toroid_hex_g3_p6")
        for value in ["-1", "33", "x"]:
            arguments = ["render", path, *CUT, "--truncate-order", value]
            self.fails(2, *arguments, names=["--truncate-order"])

    def test_compare_has_them_as_settings(self):
        folder = self.folder / "trade"
        few = ["--resolutions", "none", "--grids", "none", "--levels", "none", "--repeat", "1"]
        path = case("toroid_hex_g3_p6")
        arguments = ["compare", path, *CUT, "--size", "120x100", *few, "--output", folder]
        self.summary(*arguments)
        rows = {row["setting"]: row for row in read_csv(folder / "trade.csv")}
        errors = [float(rows[f"exact-truncate-{order}"]["largest_error"]) for order in (5, 4, 3)]
        self.assertGreater(errors[0], 0.0)
        self.assertLess(errors[0], errors[1])
        self.assertLess(errors[1], errors[2])
        self.assertGreater(float(rows["exact-stride-2"]["largest_error"]), 0.0)
        for order, error in zip((5, 4, 3), errors):
            self.assertLessEqual(error, float(rows[f"exact-truncate-{order}"]["proven_change"]))
        self.assertEqual(rows["exact"]["proven_change"], "")
        summary = self.summary(*arguments, "--truncate-orders", "1", "--target-error", "10")
        rows = {row["setting"]: row for row in read_csv(folder / "trade.csv")}
        self.assertIn("exact-truncate-1", rows)
        self.assertNotIn("exact-truncate-5", rows)
        self.assertIn(summary["recommended"]["setting"], rows)
        self.fails(2, "compare", path, *MIDDLE, "--truncate-order", "1", names=["--truncate-orders"])


if __name__ == "__main__":
    unittest.main()
