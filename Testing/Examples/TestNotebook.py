# SPDX-License-Identifier: BSD-3-Clause
"""The notebook runs, and its cells show the pictures that scripts get. Where nbconvert and ipykernel are."""

import base64
import importlib.util
import json
import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import numpy as np
import pixelexact

EXAMPLES = Path(__file__).resolve().parent.parent.parent / "Examples"
TORUS = Path(os.environ["PIXELEXACT_DATA_DIR"]) / "toroid_hex_g3_p6.vtu"
HERE = all(importlib.util.find_spec(name) for name in ("nbconvert", "ipykernel"))


def pixels(path):
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkIOImage import vtkPNGReader

    reader = vtkPNGReader()
    reader.SetFileName(str(path))
    reader.Update()
    image = reader.GetOutput()
    width, height, _ = image.GetDimensions()
    return vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, -1)[::-1]


@unittest.skipUnless(HERE, "nbconvert or ipykernel is not installed")
class Notebook(unittest.TestCase):
    def test_cells_show_pictures(self):
        with tempfile.TemporaryDirectory() as folder:
            command = ["-m", "nbconvert", "--execute", "--to", "notebook", "--output-dir", folder]
            done = subprocess.run(
                [sys.executable, *command, str(EXAMPLES / "notebook.ipynb")],
                # Jupyter's own files are nobody else's affair.
                env={**os.environ, "HOME": folder},
                capture_output=True,
                text=True,
                timeout=300,
                check=False,
            )
            self.assertEqual(done.returncode, 0, done.stderr)
            notebook = json.loads((Path(folder) / "notebook.ipynb").read_text(encoding="utf-8"))
            outputs = {
                cell["id"]: cell["outputs"][0] for cell in notebook["cells"] if cell.get("outputs")
            }
            shown = {}
            for name in ("cut", "picture", "figure"):
                path = Path(folder) / f"{name}.png"
                path.write_bytes(base64.b64decode(outputs[name]["data"]["image/png"]))
                shown[name] = pixels(path)

        cut = pixelexact.cut(TORUS, "u", normal="z", contours=9, edges=True)
        np.testing.assert_array_equal(shown["cut"], cut.render(size=(600, 600)).image)
        picture = pixelexact.render(TORUS, "u", normal="z", origin=0.1, size=(300, 200))
        np.testing.assert_array_equal(shown["picture"], picture.image)
        figure = pixelexact.figure(
            TORUS, "u", plane="z=0.1", contours=9, cmap="vik", clim="symmetric", size=(600, 400)
        )
        with tempfile.NamedTemporaryFile(suffix=".png") as file:
            file.write(figure.content)
            file.flush()
            np.testing.assert_array_equal(shown["figure"], pixels(file.name))
        text = "".join(outputs["grid"]["data"]["text/plain"])
        self.assertIn("Cells: 48 hexahedra of order 3", text)
        self.assertLessEqual(len(text.splitlines()), 10)
        exact = np.count_nonzero(picture.verdicts == 1)
        self.assertGreater(exact, 1000)
        self.assertTrue(outputs["values"]["text"][0].startswith(f"{exact} exact pixels"))


if __name__ == "__main__":
    unittest.main()
