"""The plugin is there when ParaView starts, and beside it there is no other VTK's PixelExact."""

import os
import re
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
        with open("/proc/self/maps", encoding="utf-8") as maps:
            has_own = "libvtkCommonCore-pv" in maps.read()
        program = "try:\n  import pixelexact\nexcept ImportError as error:\n  print(error)\n"
        path = os.pathsep.join([package, os.environ["PYTHONPATH"]])
        done = subprocess.run(
            ["pvpython", "-c", program],
            env=os.environ | {"PYTHONPATH": path},
            capture_output=True,
            text=True,
        )
        self.assertEqual(done.returncode, 0, done.stderr)
        if not has_own:
            # Debian's ParaView 6.1 uses the system's VTK, as the package does.
            self.assertEqual(done.stdout, "")
            return
        from vtkmodules.vtkCommonCore import vtkVersion

        # Other versions, or other libraries of one version.
        found = rf"found (another )?VTK {re.escape(vtkVersion.GetVTKVersion())}"
        for part in r"built with .*\bVTK ", found, "the plugin":
            self.assertRegex(done.stdout, part)


if __name__ == "__main__":
    scene.main()
