"""The Python package offers every public class."""

import unittest

import pixelexact

# Bases of others, which cannot be made themselves.
ABSTRACT = ["vtkHighOrderFileReader"]
CLASSES = [
    "vtkGLVisReader",
    "vtkHighOrderCertifier",
    "vtkHighOrderGrid",
    "vtkHighOrderLayer",
    "vtkHighOrderLinearResample",
    "vtkHighOrderMapper",
    "vtkHighOrderPicker",
    "vtkHighOrderProbe",
    "vtkHighOrderRayPass",
    "vtkHighOrderSeriesReader",
    "vtkImplicitTorus",
    "vtkMFEMReader",
    "vtkNektarReader",
    "vtkUnstructuredGridToHighOrderGrid",
]


class Import(unittest.TestCase):
    def test_classes_can_be_made(self):
        for name in CLASSES:
            with self.subTest(name):
                self.assertEqual(getattr(pixelexact, name)().GetClassName(), name)

    def test_nothing_else_is_there(self):
        found = [name for name in dir(pixelexact) if name.startswith("vtk")]
        self.assertEqual(found, sorted(ABSTRACT + CLASSES))

    def test_version(self):
        self.assertRegex(pixelexact.__version__, r"^\d+\.\d+\.\d+$")


if __name__ == "__main__":
    unittest.main()
