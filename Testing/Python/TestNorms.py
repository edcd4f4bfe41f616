# SPDX-License-Identifier: BSD-3-Clause
"""pixelexact.norms: the numbers of the program, and closed forms."""

import json
import os
import subprocess
import unittest
from pathlib import Path

import numpy as np

import pixelexact

DATA = Path(os.environ["PIXELEXACT_DATA_DIR"])
TORUS = DATA / "toroid_hex_g3_p6.vtu"


class Norms(unittest.TestCase):
    def test_closed_forms(self):
        found = pixelexact.norms(TORUS, lambda u, x: 3.0 + 0 * u)
        self.assertAlmostEqual(found.l1, 3 * found.volume, delta=1e-12)
        self.assertAlmostEqual(found.l2, 3 * np.sqrt(found.volume), delta=1e-12)
        self.assertLessEqual(found.linf[0], 3.0)
        self.assertGreaterEqual(found.linf[1], 3.0)
        self.assertTrue(found.met)
        self.assertEqual((found.not_finite, found.folded), (0, 0))
        self.assertAlmostEqual(found.elements["Volume"].sum(), found.volume, delta=1e-12)
        np.testing.assert_allclose(
            found.elements["L2"] ** 2, 9 * found.elements["Volume"], rtol=1e-12)
        with self.assertRaisesRegex(pixelexact.Error, "jump"):
            pixelexact.norms(TORUS, "jump(u)")

    def test_the_numbers_are_the_programs(self):
        done = subprocess.run(
            [os.environ["PIXELEXACT_TOOL"], "info", TORUS, "--norms", "u", "--json"], capture_output=True, text=True, check=True)
        known = json.loads(done.stdout)["norms"]["fields"][0]
        found = pixelexact.norms(TORUS, "u")
        self.assertEqual((found.volume, found.volume_error), tuple(known["volume"].values()))
        self.assertEqual((found.l1, found.l1_error), tuple(known["l1"].values()))
        self.assertEqual((found.l2, found.l2_error), tuple(known["l2"].values()))
        self.assertEqual(found.linf, (known["linf"]["attained"], known["linf"]["bound"]))
        self.assertEqual(found.most, known["elements_with_90_percent"])


if __name__ == "__main__":
    unittest.main()
