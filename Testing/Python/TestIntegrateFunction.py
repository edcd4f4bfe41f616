# SPDX-License-Identifier: BSD-3-Clause
"""pixelexact.integrate: the numbers of the program, and closed forms."""

import json
import os
import subprocess
import unittest
from pathlib import Path

import numpy as np
from vtkmodules.vtkCommonDataModel import vtkSphere

import pixelexact

DATA = Path(os.environ["PIXELEXACT_DATA_DIR"])
TORUS = DATA / "toroid_hex_g3_p6.vtu"


class Integrate(unittest.TestCase):
    def test_the_numbers_are_the_programs(self):
        found = pixelexact.integrate(
            TORUS, "u", origin=0.1, norms=True, extremes=True, statistics=4, tolerance=1e-4)
        done = subprocess.run(
            [os.environ["PIXELEXACT_TOOL"], "integrate", TORUS, "--field", "u", "--plane", "z=0.1", "--norms", "--extremes",
             "--statistics", "4", "--tolerance", "1e-4", "--json"], capture_output=True, text=True, check=True)
        known = json.loads(done.stdout)["surfaces"][0]
        for row in known["rows"]:
            self.assertEqual(
                tuple(found[row["quantity"]]), (row["value"], row["error_bound"], row["lower"], row["upper"]))
        for k, one in enumerate(known["histogram"]):
            self.assertEqual((found[f"Class {k + 1}"].lower, found[f"Class {k + 1}"].upper), (one["lower"], one["upper"]))
        rows = {row["quantity"]: row for row in known["rows"]}
        self.assertEqual(list(found.maximum_point), rows["Maximum"]["at"])
        self.assertTrue(found.met)

    def test_surfaces(self):
        sphere = vtkSphere()
        sphere.SetCenter(1.0, 0.0, 0.0)
        sphere.SetRadius(0.1)
        found = pixelexact.integrate(TORUS, lambda x: x, surface=sphere, extremes=True)
        self.assertLessEqual(found["Area"].lower, 0.04 * np.pi)
        self.assertGreaterEqual(found["Area"].upper, 0.04 * np.pi)
        self.assertLessEqual(found["Maximum"].lower, 1.1)
        self.assertGreaterEqual(found["Maximum"].upper, 1.1)
        # The volume by Gauss's theorem is that of the norms.
        flux = pixelexact.integrate(TORUS, "coords/3", boundary=True, tolerance=1e-7)["Flux"]
        volume = pixelexact.norms(TORUS, "u").volume
        self.assertLessEqual(flux.lower, volume + 1e-12)
        self.assertGreaterEqual(flux.upper, volume - 1e-12)

    def test_refusals(self):
        with self.assertRaises(ValueError):
            pixelexact.integrate(TORUS, "u", statistics=1)
        with self.assertRaises(ValueError):
            pixelexact.integrate(TORUS, "u", boundary=True, origin=0.1)
        with self.assertRaisesRegex(pixelexact.Error, "scalar"):
            pixelexact.integrate(TORUS, "grad(u)", statistics=3)


if __name__ == "__main__":
    unittest.main()
