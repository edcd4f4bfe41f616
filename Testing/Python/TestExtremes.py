# SPDX-License-Identifier: BSD-3-Clause
"""pixelexact.extremes: the numbers of the program, and closed forms."""

import json
import os
import subprocess
import unittest
from pathlib import Path

import numpy as np

import pixelexact

DATA = Path(os.environ["PIXELEXACT_DATA_DIR"])
TORUS = DATA / "toroid_hex_g3_p6.vtu"


class Extremes(unittest.TestCase):
    def test_the_point_and_the_bounds(self):
        grid = pixelexact.read(TORUS)
        found = pixelexact.extremes(grid, "u")
        self.assertTrue(found.met)
        self.assertEqual((found.unbounded, found.not_finite, found.inverted, found.undecided), (0, 0, 0, 0))
        for end, sign in ((found.minimum, 1.0), (found.maximum, -1.0)):
            self.assertLessEqual(sign * end.bound, sign * end.value)
            self.assertLessEqual(sign * end.bound, sign * end.attained)
            probed = pixelexact.probe(grid, "u", [end.position])
            self.assertAlmostEqual(probed.values[0], end.value, delta=1e-12)
        random = np.random.default_rng(5)
        points = random.uniform([-1.4, -1.4, -0.4], [1.4, 1.4, 0.4], (5000, 3))
        values = pixelexact.probe(grid, "u", points).values
        self.assertGreaterEqual(np.nanmin(values), found.minimum.bound)
        self.assertLessEqual(np.nanmax(values), found.maximum.bound)

    def test_components_and_expressions(self):
        grid = pixelexact.read(TORUS)
        found = pixelexact.extremes(grid, "vec(2 + 0*x, 0*x, 1 + 0*x)")
        self.assertAlmostEqual(found.minimum.value, np.sqrt(5.0), delta=1e-12)
        found = pixelexact.extremes(grid, lambda u, x: 0 * u + 4, component=0)
        self.assertAlmostEqual(found.maximum.value, 4.0, delta=1e-12)
        with self.assertRaisesRegex(pixelexact.Error, "jump"):
            pixelexact.extremes(grid, "jump(u)")
        with self.assertRaisesRegex(pixelexact.Error, "no component 2"):
            pixelexact.extremes(grid, "u", component=2)

    def test_the_numbers_are_the_programs(self):
        done = subprocess.run(
            [os.environ["PIXELEXACT_TOOL"], "info", TORUS, "--extremes", "u", "--json"], capture_output=True, text=True, check=True)
        known = json.loads(done.stdout)["extremes"]["fields"][0]["components"][0]
        found = pixelexact.extremes(TORUS, "u")
        for name in ("minimum", "maximum"):
            end = getattr(found, name)._asdict()
            end["position"], end["xi"] = list(end["position"]), list(end["xi"])
            self.assertEqual(end, known[name])


if __name__ == "__main__":
    unittest.main()
