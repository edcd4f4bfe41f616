# SPDX-License-Identifier: BSD-3-Clause
"""pixelexact integrate: what it prints, against sums over pixels, what it refuses."""

import math
import unittest

import numpy as np
from rendering import EXACT
from tool import DATA, ToolTest, case
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

    def slabs(self, ends, side=1.0):
        """Squares times the intervals between these z, one hexahedron each."""
        square = [(0.0, 0.0), (side, 0.0), (side, side), (0.0, side)]
        points = [
            f"{x!r} {y!r} {z!r}"
            for pair in zip(ends, ends[1:], strict=False)
            for z in pair
            for x, y in square
        ]
        count = len(ends) - 1
        path = self.folder / "slabs.vtk"
        path.write_text(
            "# vtk DataFile Version 3.0\nslabs\nASCII\nDATASET UNSTRUCTURED_GRID\n"
            f"POINTS {len(points)} double\n" + "\n".join(points)
            + f"\nCELLS {count} {9 * count}\n"
            + "\n".join("8 " + " ".join(str(8 * k + i) for i in range(8)) for k in range(count))
            + f"\nCELL_TYPES {count}\n" + "12\n" * count
        )
        return path

    def test_planes_beside_faces_of_elements_of_different_sizes_count_once(self):
        for ends in ([0.0, 1.0, 1.01], [-0.01, 0.0, 1.0], [-1000.0, 0.0, 1e-3], [0.0, 1.0, 2.0]):
            path = self.slabs(ends)
            for off in (0.0, 1e-16, 1e-15, 3e-15, 1e-14, 1e-13, 1e-12, 1e-11):
                for z in {ends[1] + off, ends[1] - off}:
                    with self.subTest(ends=ends, z=z):
                        _, rows = self.rows(path, "--plane", f"0,0,{z!r},0,0,1")
                        self.assertLessEqual(rows["Area"]["lower"], 1.0)
                        self.assertGreaterEqual(rows["Area"]["upper"], 1.0)
                        # Rounding at 1000 hides on which side of the face the plane is.
                        most = 2.0 if min(ends) < -1.0 else 1.0
                        self.assertLess(rows["Area"]["upper"], most + 1e-6)

    def test_planes_beside_hanging_faces_count_once(self):
        """A box below four smaller ones."""
        for height in (0.5, 0.9, 1.0, 4.0):
            boxes = [(0.0, 0.0, -1.0, 1.0, 1.0, 0.0)]
            boxes += [(x, y, 0.0, x + 0.5, y + 0.5, height) for x in (0.0, 0.5) for y in (0.0, 0.5)]
            corners = [(0, 1, 2), (3, 1, 2), (3, 4, 2), (0, 4, 2), (0, 1, 5), (3, 1, 5), (3, 4, 5), (0, 4, 5)]
            path = self.folder / "boxes.vtk"
            path.write_text(
                "# vtk DataFile Version 3.0\nboxes\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 40 double\n"
                + "\n".join(" ".join(repr(box[i]) for i in corner) for box in boxes for corner in corners)
                + "\nCELLS 5 45\n"
                + "\n".join("8 " + " ".join(str(8 * k + i) for i in range(8)) for k in range(5))
                + "\nCELL_TYPES 5\n" + "12\n" * 5
            )
            for off in (0.0, 1e-15, 3e-15, 5e-15, 7e-15, 1e-14, 1e-13):
                for z in {off, -off}:
                    with self.subTest(height=height, z=z):
                        _, rows = self.rows(path, "--plane", f"0,0,{z!r},0,0,1")
                        self.assertLessEqual(rows["Area"]["lower"], 1.0)
                        self.assertGreaterEqual(rows["Area"]["upper"], 1.0)
                        if off in (0.0, 1e-13):
                            self.assertLess(rows["Area"]["error_bound"], 1e-6)

    def test_elements_thinner_than_their_uncertainty_keep_what_the_surface_may_have_there(self):
        for ends in ([0.0, 1e-15], [0.0, 1e-15, 1.0], [0.0, 3e-15, 1.0], [-1.0, 0.0, 3e-15, 1.0]):
            path = self.slabs(ends)
            z = 0.3 * max(end for end in ends if end < 0.5)
            with self.subTest(ends=ends, z=z):
                _, rows = self.rows(path, "--plane", f"0,0,{z!r},0,0,1")
                self.assertLessEqual(rows["Area"]["lower"], 1.0)
                self.assertGreaterEqual(rows["Area"]["upper"], 1.0)

    def test_sizes_that_would_underflow_are_refused(self):
        path = self.slabs([0.0, 1e-120], side=1e-120)
        self.fails(
            *(1, "integrate", path, "--plane", "0,0,3e-121,0,0,1"),
            names=("Give the mesh in other units",),
        )

    def test_faces_that_are_covered_in_part_are_told(self):
        """Two cubes, of sides 1 and 1/2, where a quarter of a face of the first is covered."""
        corners = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)]
        corners += [(x, y, 1) for x, y, _ in corners]
        points = np.concatenate([np.array(corners), 0.5 * np.array(corners) + (1.0, 0.0, 0.0)])
        path = self.folder / "cubes.vtk"
        path.write_text(
            "# vtk DataFile Version 3.0\ncubes\nASCII\nDATASET UNSTRUCTURED_GRID\n"
            "POINTS 16 double\n" + "\n".join(" ".join(map(str, p)) for p in points.tolist())
            + "\nCELLS 2 18\n8 0 1 2 3 4 5 6 7\n8 8 9 10 11 12 13 14 15\nCELL_TYPES 2\n12\n12\n"
        )
        summary, rows = self.rows(path, "--boundary")
        self.assertEqual(summary["surfaces"][0]["partly_covered"], 1)
        self.assertIn("counted whole", " ".join(summary["surfaces"][0]["notes"]))
        self.assertAlmostEqual(rows["Area"]["value"], 6.0 + 5 * 0.25, delta=1e-9)

    def test_what_misses_the_mesh_is_told(self):
        summary, rows = self.rows(case("dolfinx_hex_g2_p4"), "--plane", "0,0,1e3,0,0,1")
        self.assertLess(rows["Area"]["upper"], 1e-300)
        self.assertIn("meets no element", " ".join(summary["surfaces"][0]["notes"]))

    def test_discs_tori_boxes_triangles_and_iso_surfaces(self):
        path = case("toroid_hex_g3_p6")
        # All of them lie within the ring: closed forms.
        for surface, area in (
            (("--disc", "1,0,0.05,0,0,1,0.15"), math.pi * 0.15**2),
            (("--torus", "0,0,0,0,0,1,1,0.2"), 4.0 * math.pi**2 * 0.2),
            (("--box", "0.95,-0.05,-0.1,1.05,0.1,0.1"), 2 * (0.015 + 0.03 + 0.02)),
        ):
            with self.subTest(surface=surface[0]):
                _, rows = self.rows(path, "--field", "u", *surface, "--tolerance", "1e-3")
                found = rows["Area"]
                self.assertLessEqual(found["lower"], area)
                self.assertGreaterEqual(found["upper"], area)
                self.assertLess(found["error_bound"], 2e-3 * area)
        _, half = self.rows(
            *(path, "--disc", "1,0,0.05,0,0,1,0.15", "--clip", "1,0,0.05,1,1,0"),
            *("--tolerance", "1e-6"),
        )
        self.assertAlmostEqual(half["Area"]["value"], math.pi * 0.15**2 / 2, delta=1e-6)
        _, triangles = self.rows(
            path, "--surface", DATA / "surfaces" / "octahedron.stl", "--tolerance", "1e-4"
        )
        self.assertGreater(triangles["Area"]["lower"], 0.0)
        path = case("fichera_hex_g3_p4")
        _, iso = self.rows(path, "--field", "u", "--isosurface", "u=0.3", "--tolerance", "1e-2")
        # The field's mean on its own iso-surface.
        self.assertLessEqual(iso["Mean"]["lower"], 0.3)
        self.assertGreaterEqual(iso["Mean"]["upper"], 0.3)
        self.assertLess(iso["Mean"]["error_bound"], 0.02)

    def test_a_field_over_the_iso_surface_of_another(self):
        path = case("fichera_hex_g3_p4")
        _, rows = self.rows(
            path, "--field", "attribute", "--isosurface", "u=0.3", "--tolerance", "0.3"
        )
        # The field is 1.
        self.assertLessEqual(rows["Integral"]["lower"], rows["Area"]["upper"])
        self.assertGreaterEqual(rows["Integral"]["upper"], rows["Area"]["lower"])

    def test_what_does_not_fit_is_refused(self):
        ring = (case("toroid_hex_g3_p6"), "--field", "u")
        for option, given in (
            ("--patch", "saddle.txt"),
            ("--disc", "0,0,0,0,0,0,1"),
            ("--clip", "0,0,0,0,0,0"),
        ):
            self.fails(2, "integrate", *ring, option, given, names=[option])
        self.fails(1, "integrate", *ring, "--isosurface", "none=1", names=["none"])
        self.fails(
            *(2, "integrate", *ring, "--plane", "z", "--clip", "0,0,0,1,0,0", "--linear", "1"),
            names=["--linear", "--clip"],
        )
        path = case("dolfinx_hex_g2_p4")
        self.fails(2, "integrate", path, "--tolerance", "0", names=["--tolerance"])
        self.fails(2, "integrate", path, "--seconds", "-1", names=["--seconds"])
        self.fails(2, "integrate", path, "--boundary", "--linear", "1", names=["--linear"])
        self.fails(2, "integrate", path, "--boundary=element:3", names=["--boundary"])
        self.fails(1, "integrate", path, "--field", "none", names=["none"])


if __name__ == "__main__":
    unittest.main()
