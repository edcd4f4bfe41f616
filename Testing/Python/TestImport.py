"""The Python package offers every public class."""

import unittest

import pixelexact

CLASSES = [
    "vtkHighOrderGrid",
    "vtkHighOrderLinearResample",
    "vtkHighOrderMapper",
    "vtkHighOrderProbe",
    "vtkHighOrderRayPass",
    "vtkUnstructuredGridToHighOrderGrid",
]


class Import(unittest.TestCase):
    def test_classes_can_be_made(self):
        for name in CLASSES:
            with self.subTest(name):
                self.assertEqual(getattr(pixelexact, name)().GetClassName(), name)

    def test_nothing_else_is_there(self):
        found = [name for name in dir(pixelexact) if name.startswith("vtk")]
        self.assertEqual(found, CLASSES)

    def test_version(self):
        self.assertRegex(pixelexact.__version__, r"^\d+\.\d+\.\d+$")


if __name__ == "__main__":
    unittest.main()
