"""The Python package offers every public class."""

import unittest

import pixelexact

# Bases of others, which cannot be made themselves.
ABSTRACT = [
    "vtkHighOrderContourMapper",
    "vtkHighOrderDataSurface",
    "vtkHighOrderFileReader",
    "vtkHighOrderGridAlgorithm",
    "vtkHighOrderSceneMapper",
    "vtkHighOrderSurface",
]
CLASSES = [
    "vtkFlexiReader",
    "vtkGLVisReader",
    "vtkGmshReader",
    "vtkHighOrderBoundarySurface",
    "vtkHighOrderCalculator",
    "vtkHighOrderCertifier",
    "vtkHighOrderComparison",
    "vtkHighOrderContour",
    "vtkHighOrderDifference",
    "vtkHighOrderExtremes",
    "vtkHighOrderGrid",
    "vtkHighOrderIntegrate",
    "vtkHighOrderIsoSurface",
    "vtkHighOrderJumpWalls",
    "vtkHighOrderLayer",
    "vtkHighOrderLinearCut",
    "vtkHighOrderLinearResample",
    "vtkHighOrderMapper",
    "vtkHighOrderNorms",
    "vtkHighOrderPack",
    "vtkHighOrderPatchSurface",
    "vtkHighOrderPicker",
    "vtkHighOrderPicture",
    "vtkHighOrderPlotOverLine",
    "vtkHighOrderProbe",
    "vtkHighOrderRayPass",
    "vtkHighOrderSeriesReader",
    "vtkHighOrderSubdivide",
    "vtkHighOrderTriangleSurface",
    "vtkHighOrderTruncate",
    "vtkHighOrderUnpack",
    "vtkHighOrderWarp",
    "vtkImplicitCallback",
    "vtkImplicitTorus",
    "vtkMFEMReader",
    "vtkNekReader",
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

    def test_help_names_the_arrays(self):
        # The wrapping takes out what looks like a tag.
        for name, arrays in {
            "vtkHighOrderProbe": ["`FIELD`", "`FIELD_Gradient`", "`FIELD_lower`", "`FIELD_upper`"],
            "vtkHighOrderContour": ["`Element`", "`Xi`", "`Gradient`", "`Closed`", "`Certified`"],
            "vtkHighOrderCertifier": ["`FIELD_lower`", "`FIELD_upper`", "`Verdict`"],
        }.items():
            for array in arrays:
                self.assertIn(array, getattr(pixelexact, name).__doc__)
        for name in ABSTRACT + CLASSES:
            for text in [getattr(pixelexact, name), *vars(getattr(pixelexact, name)).values()]:
                self.assertNotRegex(text.__doc__ or "", "``|`_", name)

    def test_version(self):
        self.assertRegex(pixelexact.__version__, r"^\d+\.\d+\.\d+$")


if __name__ == "__main__":
    unittest.main()
