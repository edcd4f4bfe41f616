# SPDX-License-Identifier: BSD-3-Clause
"""The figures of the cookbook's page are made by its lines."""

import subprocess
import sys
import unittest
from pathlib import Path

import numpy as np

from tool import TOOL, ToolTest, read_image

SCRIPT = Path(__file__).resolve().parent.parent.parent / "Examples" / "cookbook.py"


class Cookbook(ToolTest):
    def test_all_lines(self):
        done = subprocess.run([sys.executable, SCRIPT, TOOL], cwd=self.folder, stdout=subprocess.PIPE,
            stderr=subprocess.PIPE, text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(len(done.stdout.splitlines()), 20)
        pictures = sorted((self.folder / "pictures").iterdir())
        self.assertEqual(len(pictures), 24)
        for picture in pictures:
            if picture.suffix == ".png":
                colors = np.unique(read_image(picture).reshape(-1, read_image(picture).shape[2]), axis=0)
                self.assertGreater(len(colors), 10, picture)
            else:
                self.assertEqual(picture.read_bytes()[:5], b"%PDF-")


if __name__ == "__main__":
    unittest.main()
