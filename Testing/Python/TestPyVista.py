# SPDX-License-Identifier: BSD-3-Clause
"""Grids, cuts and lines in PyVista, where it is installed."""

import importlib.util
import os
import unittest
from pathlib import Path

import numpy as np
import pixelexact

TORUS = Path(os.environ["PIXELEXACT_DATA_DIR"]) / "toroid_hex_g3_p6.vtu"


@unittest.skipUnless(importlib.util.find_spec("pyvista"), "PyVista is not installed")
class PyVista(unittest.TestCase):
    def test_a_plotter_shows_it(self):
        import pyvista

        grid = pixelexact.read(TORUS)
        theirs = pyvista.UnstructuredGrid(grid)
        points = np.random.default_rng(5).uniform(-1, 1, (1000, 3))
        np.testing.assert_array_equal(
            pixelexact.probe(theirs, "u", points).values, pixelexact.probe(grid, "u", points).values
        )
        cut = pixelexact.cut(theirs, "u", contours=5, edges=True)
        plotter = pyvista.Plotter(off_screen=True, window_size=(200, 150))
        plotter.add_actor(cut.actor)
        plotter.add_actor(cut.scalar_bar)
        plotter.view_xy()
        picture = plotter.screenshot(return_img=True)
        self.assertGreater(len(np.unique(picture.reshape(-1, picture.shape[-1]), axis=0)), 100)

    def test_lines(self):
        import pyvista

        lines = pyvista.wrap(pixelexact.contours(TORUS, "u", [0.1]))
        self.assertGreater(lines.n_cells, 0)
        self.assertLess(np.abs(lines.point_data["u"] - 0.1).max(), 1e-12)


if __name__ == "__main__":
    unittest.main()
