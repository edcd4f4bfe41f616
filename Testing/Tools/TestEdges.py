# SPDX-License-Identifier: BSD-3-Clause
"""Lines between elements: --edges."""

import unittest

import numpy as np

from tool import ToolTest, View, case, read_buffers, read_image

# A torus in a toroid, seen askew, in white.
TORUS = ["--torus", "0,0,0,0,0,1,1,0.3", "--layer", "1:color=1:1:1,lights=off"]


PLANE = ["--plane", "0,0,0.05,0.1,0.2,1", "--layer", "1:color=1:1:1"]


def view(size):
    return View([2.5, -3.0, 3.5], [0.0, 0.0, 0.0], [0.1, 0.2, 1.0], size, size, scale=1.6)


class Edges(ToolTest):
    def setUp(self):
        super().setUp()
        self.source = case("toroid_hex_g3_p6")

    def picture(self, size, *options, look=TORUS):
        image, buffers = self.folder / "image.png", self.folder / "buffers.vti"
        outputs = ["--output", image, "--buffers", buffers]
        words = ["--field", "u", *look, *options, *view(size).options(), *outputs]
        self.succeeds("render", self.source, *words)
        return read_buffers(buffers), read_image(image)

    def test_lines_are_between_the_elements_of_a_finer_picture(self):
        size, finer, width = 200, 8, 2.0
        buffers, image = self.picture(size, "--edges", str(width), "--edge-color", "0,0,0", look=PLANE)
        fine, _ = self.picture(size * finer, look=PLANE)
        element = np.where(fine["Verdict"] == 1, fine["Element"], -1)
        # Where two elements meet in the finer picture, and where the mesh ends.
        points, ends = [], []
        for axis, (a, b) in enumerate(
            [(element[:-1], element[1:]), (element[:, :-1], element[:, 1:])]
        ):
            shown = (a >= 0) & (b >= 0)
            for found, where in [(points, shown & (a != b)), (ends, (a >= 0) != (b >= 0))]:
                half = 0.5 * np.eye(2)[axis]
                found.append((np.argwhere(where) + 0.5 + half) / finer)
        points, ends = np.concatenate(points), np.concatenate(ends)
        rows, columns = np.nonzero(buffers["Verdict"] == 1)
        centres = np.stack([rows, columns], axis=1) + 0.5

        def to(places):
            return np.array([np.hypot(*(places - centre).T).min() for centre in centres])

        nearest, inner = to(points), to(ends) > width + 1
        cover = 1 - image[rows, columns, 0] / 255
        self.assertGreater((inner & (nearest < 0.5)).sum(), 100)
        # Pixels all in the line, and pixels that have none of it: the diagonal is 0.71.
        self.assertGreater(cover[inner & (nearest < width / 2 - 0.71 - 0.1)].min(), 0.95)
        self.assertEqual(cover[inner & (nearest > width / 2 + 0.71 + 0.1)].max(), 0.0)
        middle = inner & (np.abs(nearest - width / 2) < 0.1)
        self.assertAlmostEqual(cover[middle].mean(), 0.5, delta=0.05)
        self.assertLess(np.abs(cover[middle] - 0.5).max(), 0.3)

    def test_width_and_colour(self):
        plain, unlined = self.picture(300)
        sums = []
        for options in [["--edges=1"], ["--edges=2"], ["--edges", "2", "--samples", "4"]]:
            buffers, image = self.picture(300, *options)
            np.testing.assert_array_equal(buffers["Element"], plain["Element"])
            sums.append((1 - image[plain["Verdict"] == 1] / 255).sum() / 3)
        self.assertAlmostEqual(sums[1] / sums[0], 2.0, delta=0.15)
        self.assertGreater(sums[2], 0.95 * sums[1])
        _, red = self.picture(300, "--edges", "--edge-color", "1,0,0")
        self.assertTrue((red[..., 0] == unlined[..., 0]).all())
        self.assertGreater((red[..., 1] < 128).sum(), 100)

    def test_an_input_may_follow(self):
        options = [*TORUS, *view(40).options(), "--output", self.folder / "i.png"]
        self.succeeds("render", "--edges", self.source, *options)

    def test_what_is_refused(self):
        options = ["render", self.source, *TORUS, "--output", self.folder / "i.png"]
        for width in ("0", "-1", "100"):
            self.fails(2, *options, "--edges", width, names=["--edges", "0.1 to 32"])
        self.fails(2, *options, "--edges=thick", names=["--edges", "thick"])
        self.fails(2, *options, "--edge-color", "1,0,0", names=["--edges"])
        self.fails(2, *options, "--edges", "--edge-color", "2,0,0", names=["--edge-color"])
        self.fails(2, *options, "--edges", "--outlines", names=["--edges", "--outlines"])


if __name__ == "__main__":
    unittest.main()
