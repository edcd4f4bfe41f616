# SPDX-License-Identifier: BSD-3-Clause
"""Deformed meshes in Python: the function warp, and the keyword of read, render, cut and probe."""

import os
import unittest
from pathlib import Path

import numpy as np
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401

import pixelexact

TORUS = Path(os.environ["PIXELEXACT_DATA_DIR"]) / "toroid_hex_g3_p6.vtu"
POINTS = np.array([[0.9, 0.1, 0.05], [1.0, -0.2, -0.1], [-0.7, 0.7, 0.0]])
UP = (0.0, 0.0, 1.0)


class Warp(unittest.TestCase):
    def setUp(self):
        self.grid = pixelexact.read(TORUS)
        self.u = pixelexact.probe(self.grid, "u", POINTS)
        self.moved = POINTS + 0.02 * self.u.values[:, None] * np.array(UP)

    def test_function_and_keywords_are_the_same(self):
        grid = pixelexact.warp(self.grid, "u", 0.02, direction=UP)
        for found in (
            pixelexact.probe(grid, "u", self.moved),
            pixelexact.probe(self.grid, "u", self.moved, warp="u=0.02", warp_direction=UP),
            pixelexact.probe(self.grid, "u", self.moved, warp=("u", 0.02), warp_direction=UP),
            pixelexact.probe(
                pixelexact.read(TORUS, warp="u=0.02", warp_direction=UP), "u", self.moved),
        ):
            self.assertTrue(found.inside.all())
            np.testing.assert_allclose(found.values, self.u.values, atol=1e-12)
        one = pixelexact.render(grid, "u", size=(60, 40))
        other = pixelexact.render(self.grid, "u", size=(60, 40), warp="u=0.02", warp_direction=UP)
        np.testing.assert_array_equal(one.image, other.image)

    def test_wrong_use(self):
        with self.assertRaisesRegex(pixelexact.Error, "'u' is a scalar"):
            pixelexact.warp(self.grid, "u")
        with self.assertRaisesRegex(ValueError, "a finite number"):
            pixelexact.warp(self.grid, "u", float("nan"), direction=UP)
        with self.assertRaisesRegex(ValueError, "must not be zero"):
            pixelexact.warp(self.grid, "u", direction=(0, 0, 0))
        with self.assertRaisesRegex(ValueError, "warp_direction has no effect"):
            pixelexact.render(self.grid, "u", size=(2, 2), warp_direction=UP)
        with self.assertRaisesRegex(ValueError, "FIELD=SCALE"):
            pixelexact.render(self.grid, "u", size=(2, 2), warp="u=much")


if __name__ == "__main__":
    unittest.main()
