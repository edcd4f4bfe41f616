# SPDX-License-Identifier: BSD-3-Clause
"""pixelexact integrate: what it prints, against sums over pixels, what it refuses."""

import unittest

import numpy as np
from rendering import EXACT
from tool import ToolTest, case
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLImageDataReader


class Integrate(ToolTest):
    def rows(self, *arguments):
        summary = self.summary("integrate", *arguments)
        return summary, {row["quantity"]: row for row in summary["surfaces"][0]["rows"]}

    def pixels(self, path, plane, size, scale):
        """Area and integral as sums over pixels of a parallel view along z."""
        buffers = self.folder / "cut.vti"
        self.summary(
            *("render", path, "--field", "u", "--plane", plane, "--view", "+z"),
            *("--parallel-scale", scale, "--size", f"{size}x{size}"),
            *("--output", self.folder / "cut.png", "--buffers", buffers),
            *("--arrays", "Value,Verdict"),
        )
        reader = vtkXMLImageDataReader()
        reader.SetFileName(str(buffers))
        reader.Update()
        data = reader.GetOutput().GetPointData()
        verdict = vtk_to_numpy(data.GetArray("Verdict"))
        value = vtk_to_numpy(data.GetArray("Value"))
        inside = np.isfinite(value) & (verdict == EXACT)
        pixel = (2.0 * scale / size) ** 2
        return inside.sum() * pixel, value[inside].sum() * pixel

    def test_pixels_converge_to_the_integrals(self):
        path = case("toroid_hex_g3_p6")
        summary, rows = self.rows(
            path, "--field", "u", "--plane", "z=0.1", "--tolerance", "1e-6", "--linear", "2"
        )
        self.assertTrue(summary["surfaces"][0]["tolerance_met"])
        area, total = self.pixels(path, "z=0.1", 800, 1.6)
        self.assertAlmostEqual(rows["Area"]["value"], area, delta=2e-3)
        self.assertAlmostEqual(rows["Integral"]["value"], total, delta=2e-3)
        self.assertLess(rows["Area"]["error_bound"], 1e-5)
        self.assertLess(abs(rows["Area"]["linear"] - rows["Area"]["value"]), 2e-2)

    def test_threads_change_nothing(self):
        arguments = (case("toroid_prism_g3_p4"), "--plane", "z=0.05", "--tolerance", "1e-3")
        _, alone = self.rows(*arguments, "--threads", "1")
        _, all_of_them = self.rows(*arguments)
        self.assertEqual(alone, all_of_them)

    def test_the_boundary(self):
        _, rows = self.rows(case("dolfinx_hex_g2_p4"), "--boundary", "--tolerance", "1e-4")
        self.assertGreater(rows["Area"]["lower"], 0.0)

    def test_what_does_not_fit_is_refused(self):
        path = case("dolfinx_hex_g2_p4")
        self.fails(2, "integrate", path, "--tolerance", "0", names=["--tolerance"])
        self.fails(2, "integrate", path, "--seconds", "-1", names=["--seconds"])
        self.fails(2, "integrate", path, "--boundary", "--linear", "1", names=["--linear"])
        self.fails(2, "integrate", path, "--boundary=element:3", names=["--boundary"])
        self.fails(1, "integrate", path, "--field", "none", names=["none"])


if __name__ == "__main__":
    unittest.main()
