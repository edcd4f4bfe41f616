"""The package refuses to be loaded beside another VTK than the one that it was built with."""

import os
import subprocess
import sys
import tempfile
import unittest

from vtkmodules.vtkCommonCore import vtkVersion

THE_VERSION = vtkVersion.GetVTKVersion()
PROGRAM = """
try:
    import pixelexact
except ImportError as error:
    print(error)
else:
    print("imported")
with open("/proc/self/maps") as maps:
    print("loaded" if "libPixelExact" in maps.read() else "not loaded")
"""


def import_beside(modules):
    """What importing pixelexact says, with these modules of a package vtkmodules before others."""
    with tempfile.TemporaryDirectory() as folder:
        if modules is not None:
            os.mkdir(os.path.join(folder, "vtkmodules"))
            for name, text in modules.items():
                with open(os.path.join(folder, "vtkmodules", name), "w") as file:
                    file.write(text)
        path = os.pathsep.join([folder, os.environ["PYTHONPATH"]])
        done = subprocess.run(
            [sys.executable, "-c", PROGRAM],
            env=os.environ | {"PYTHONPATH": path},
            capture_output=True,
            text=True,
            check=True,
        )
        return done.stdout.splitlines()


def version(text):
    """A vtkCommonCore with no libraries behind it."""
    return f"class vtkVersion:\n    GetVTKVersion = staticmethod(lambda: {text!r})\n"


class VtkVersion(unittest.TestCase):
    def test_the_same(self):
        self.assertEqual(import_beside(None), ["imported", "loaded"])

    def test_another(self):
        said = import_beside({"__init__.py": "", "vtkCommonCore.py": version("9.0.3")})
        self.assertEqual(said[1:], ["not loaded"])
        for part in THE_VERSION, "9.0.3", "vtkCommonCore.py", "PYTHONPATH", "VTK_DIR":
            self.assertIn(part, said[0])

    def test_the_same_with_other_libraries(self):
        said = import_beside({"__init__.py": "", "vtkCommonCore.py": version(THE_VERSION)})
        self.assertEqual(said[1:], ["not loaded"])
        for part in THE_VERSION, "libvtkCommonCore", "vtkCommonCore.py", "PYTHONPATH", "VTK_DIR":
            self.assertIn(part, said[0])

    def test_none(self):
        said = import_beside({"__init__.py": "raise ImportError('no libGL.so.1')"})
        self.assertEqual(said[1:], ["not loaded"])
        for part in THE_VERSION, "no libGL.so.1", "VTK_DIR":
            self.assertIn(part, said[0])


if __name__ == "__main__":
    unittest.main()
