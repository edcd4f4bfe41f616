# SPDX-License-Identifier: BSD-3-Clause
"""show: the page of the program's serve, and the picture in its place."""

import base64
import os
import re
import subprocess
import sys
import tempfile
import time
import unittest
import urllib.error
import urllib.request
from pathlib import Path

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

import pixelexact

TORUS = Path(os.environ["PIXELEXACT_DATA_DIR"]) / "toroid_hex_g3_p6.vtu"
SIZE = (80, 60)


def pixels(content):
    with tempfile.NamedTemporaryFile(suffix=".png") as file:
        file.write(content)
        file.flush()
        reader = vtkPNGReader()
        reader.SetFileName(file.name)
        reader.Update()
    image = reader.GetOutput()
    width, height, _ = image.GetDimensions()
    return vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, -1)[::-1]


def status(address):
    try:
        with urllib.request.urlopen(address, timeout=30) as answer:
            return answer.status
    except urllib.error.HTTPError as error:
        return error.code
    except urllib.error.URLError:
        return None


class Show(unittest.TestCase):
    def test_page_and_picture_of_a_file(self):
        with pixelexact.show(TORUS, "u", plane="z", edges=True, size=SIZE) as shown:
            self.assertEqual(status(shown.address), 200)
            self.assertEqual(status(shown.address[:-1]), 403)
            page = shown._repr_html_()
            self.assertIn(shown.address, page)
            (picture,) = re.findall(r'base64,([^"]*)"', page)
            self.assertEqual(base64.b64decode(picture), shown._repr_png_())
            address = shown.address
        self.assertIsNone(status(address))
        self.assertEqual(repr(shown), "<Shown, closed>")
        self.assertTrue(shown._repr_png_().startswith(b"\x89PNG"))

    def test_grid_in_memory_is_the_same(self):
        options = {"plane": "z", "camera_position": (5, 4, 3), "focal_point": (0, 0, 0), "size": SIZE}
        grid = pixelexact.read(TORUS)
        with pixelexact.show(grid, "u", **options) as one, pixelexact.show(str(TORUS), "u", **options) as other:
            np.testing.assert_array_equal(pixels(one.picture), pixels(other.picture))
            folder = Path(one._folder)
            self.assertTrue(folder.is_dir())
        self.assertFalse(folder.exists())

    def test_lists_of_files(self):
        folder = TORUS.parent / "mfem_escher_tet_darcy_p3"
        files = [folder / "mfem_escher_tet_darcy_p3.mesh", folder / "flux.gf"]
        with pixelexact.show(files, size=SIZE) as shown:
            self.assertEqual(status(shown.address), 200)

    def test_ends_with_python(self):
        """Also where Python is killed."""
        script = f"import pixelexact\nprint(pixelexact.show({str(TORUS)!r}, 'u', plane='z', size={SIZE}).address, flush=True)\n"
        # Without a reference to the result, the page stays as long as Python.
        for end in ("", "\nimport os; os.kill(os.getpid(), 9)"):
            done = subprocess.run([sys.executable, "-c", script + end], capture_output=True, text=True, timeout=120, check=False)
            address = done.stdout.strip()
            self.assertTrue(address.startswith("http://127.0.0.1:"), done.stderr)
            for _ in range(200):
                if status(address) is None:
                    break
                time.sleep(0.05)
            else:
                self.fail("the server outlives Python")

    def test_refused(self):
        with self.assertRaisesRegex(pixelexact.Error, "nothing"):
            pixelexact.show(TORUS, "nothing")
        with self.assertRaisesRegex(pixelexact.Error, "--nonsense"):
            pixelexact.show(TORUS, nonsense=3)
        with self.assertRaises(TypeError):
            pixelexact.show(3)


if __name__ == "__main__":
    unittest.main()
