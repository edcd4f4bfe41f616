"""The plugin is there when ParaView starts, and beside it there is no other VTK's PixelExact."""

import os
import subprocess
import sys
import unittest

from paraview import simple

import scene


class Plugin(unittest.TestCase):
    def test_it_is_loaded(self):
        grid = simple.UnstructuredCellTypes()
        representation = simple.Show(grid)
        self.assertIn("PixelExact", representation.GetProperty("Representation").Available)

    def test_another_vtk(self):
        package = os.environ["PIXELEXACT_PACKAGE"]
        if not os.path.exists(os.path.join(package, "pixelexact")):
            self.skipTest(f"there is no pixelexact in {package}")
        program = "try:\n  import pixelexact\nexcept ImportError as error:\n  print(error)\n"
        path = os.pathsep.join([package, os.environ["PYTHONPATH"]])
        done = subprocess.run(
            ["pvpython", "-c", program],
            env=os.environ | {"PYTHONPATH": path},
            capture_output=True,
            text=True,
        )
        self.assertEqual(done.returncode, 0, done.stderr)
        from vtkmodules.vtkCommonCore import vtkVersion

        for part in "built with VTK ", f"found VTK {vtkVersion.GetVTKVersion()}", "the plugin":
            self.assertIn(part, done.stdout)


if __name__ == "__main__":
    scene.main()
