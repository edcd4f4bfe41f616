# SPDX-License-Identifier: BSD-3-Clause
"""Cuts by the triangles of files."""

import struct
import unittest

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkFiltersGeneral import vtkTransformPolyDataFilter
from vtkmodules.vtkFiltersSources import vtkPlaneSource, vtkSphereSource
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

from tool import ToolTest, case, read_buffers

EXACT = 1
VIEW = ["--camera-position", "2.5,-3,3.5", "--focal-point", "0,0,0", "--view-up", "0,0,1"]


def ascii_stl(triangles):
    lines = ["solid made"]
    for triangle in triangles:
        lines += ["facet normal 0 0 0", "outer loop"]
        lines += ["vertex " + " ".join(str(x) for x in corner) for corner in triangle]
        lines += ["endloop", "endfacet"]
    return "\n".join([*lines, "endsolid made", ""])


class TriangleFiles(ToolTest):
    def save(self, name, source):
        writer = vtkXMLPolyDataWriter()
        writer.SetInputConnection(source.GetOutputPort())
        writer.SetFileName(str(self.folder / name))
        writer.Write()
        return self.folder / name

    def buffers(self, *options):
        outputs = ["--output", self.folder / "i.png", "--buffers", self.folder / "b.vti"]
        source = case("toroid_hex_g3_p6")
        self.succeeds("render", source, *options, *VIEW, "--size", "60x50", *outputs)
        return read_buffers(self.folder / "b.vti")

    def test_a_plane_of_triangles_is_the_plane(self):
        plane = vtkPlaneSource()
        plane.SetOrigin(-3, -3, 0)
        plane.SetPoint1(3, -3, 0)
        plane.SetPoint2(-3, 3, 0)
        plane.SetResolution(7, 5)
        tilt = vtkTransform()
        tilt.RotateX(30)
        moved = vtkTransformPolyDataFilter()
        moved.SetTransform(tilt)
        moved.SetInputConnection(plane.GetOutputPort())
        moved.SetOutputPointsPrecision(1)
        triangles = self.buffers("--surface", self.save("plane.vtp", moved))
        normal = [0, -0.5, np.sqrt(0.75)]
        closed = self.buffers("--plane", ",".join(repr(float(x)) for x in [0, 0, 0, *normal]))
        np.testing.assert_array_equal(triangles["Verdict"], closed["Verdict"])
        exact = closed["Verdict"] == EXACT
        self.assertGreater(exact.sum(), 300)
        for name in ["Value", "Depth"]:
            np.testing.assert_allclose(
                triangles[name][exact], closed[name][exact], rtol=0, atol=1e-12
            )

    def test_positions_lie_on_the_triangles(self):
        ball = vtkSphereSource()
        ball.SetCenter(0.9, 0.2, 0.0)
        ball.SetRadius(0.6)
        ball.SetThetaResolution(12)
        ball.SetPhiResolution(9)
        ball.SetOutputPointsPrecision(1)
        ball.Update()
        buffers = self.buffers("--surface", self.save("ball.vtp", ball))
        exact = buffers["Verdict"] == EXACT
        self.assertGreater(exact.sum(), 50)
        points = vtk_to_numpy(ball.GetOutput().GetPoints().GetData())
        faces = vtk_to_numpy(ball.GetOutput().GetPolys().GetConnectivityArray()).reshape(-1, 3)
        a, b, c = (points[faces[:, k]] for k in range(3))
        normals = np.cross(b - a, c - a)
        normals /= np.linalg.norm(normals, axis=1)[:, None]
        for x, normal in zip(buffers["Position"][exact], buffers["Normal"][exact]):
            # Of a convex body the faces that hold a point are those that it is not beyond.
            beyond = np.einsum("ij,ij->i", normals, x - a)
            self.assertLess(abs(beyond.max()), 1e-12)
            self.assertGreater(abs(normals[beyond.argmax()] @ normal), 1 - 1e-12)

    def test_stl(self):
        corners = [(-2, -2, 0.1), (2, -2, 0.1), (2, 2, 0.1), (-2, 2, 0.1)]
        stl = self.folder / "square.stl"
        stl.write_text(ascii_stl([corners[:3], [corners[0], *corners[2:]]]), encoding="ascii")
        triangles = self.buffers("--surface", stl)
        closed = self.buffers("--plane", "0,0,0.1,0,0,1")
        np.testing.assert_array_equal(triangles["Verdict"], closed["Verdict"])
        heights = triangles["Position"][triangles["Verdict"] == EXACT][:, 2]
        self.assertLess(abs(heights - 0.1).max(), 1e-15)  # no floats
        stl.write_text(ascii_stl([corners[:3], corners[1:]])[:-60], encoding="ascii")
        self.fails(1, "render", case("toroid_hex_g3_p6"), "--surface", stl, "--output", self.folder / "i.png",
                   names=[stl, "triangle"])

    def test_a_binary_stl_that_is_cut_short(self):
        corners = np.array([[(-2, -2, 0), (2, -2, 0), (2, 2, 0)], [(-2, -2, 0), (2, 2, 0), (-2, 2, 0)]])
        records = [struct.pack("<12fH", 0, 0, 1, *corner.ravel(), 0) for corner in corners]
        whole = bytes(80) + struct.pack("<I", 2) + b"".join(records)
        stl = self.folder / "binary.stl"
        stl.write_bytes(whole)
        triangles = self.buffers("--surface", stl)
        closed = self.buffers("--plane", "0,0,0,0,0,1")
        np.testing.assert_array_equal(triangles["Verdict"], closed["Verdict"])
        for size in (len(whole) - 1, len(whole) - 50):
            stl.write_bytes(whole[:size])
            self.fails(
                *(1, "render", case("toroid_hex_g3_p6"), "--output", self.folder / "i.png"),
                *("--surface", stl),
                names=[stl, "cut short", "2 triangles", "holds 1"],
            )

    def test_bad_files_are_named(self):
        base = ["render", case("toroid_hex_g3_p6"), "--output", self.folder / "i.png"]
        bad = {
            "missing.vtp": (None, ["no such file"]),
            "plane.obj": ("v 0 0 0", [".vtp", ".stl"]),
            "empty.vtp": ("", ["empty.vtp"]),
            "empty.stl": (ascii_stl([]), ["no triangles"]),
            "nan.stl": (
                ascii_stl([[(0, 0, 0), (1, 0, 0), (0, 1, 0)], [(0, 0, "nan"), (1, 0, 0), (0, 1, 0)]]),
                ["triangle 1", "not finite"],
            ),
        }
        for name, (text, parts) in bad.items():
            with self.subTest(name):
                if text is not None:
                    (self.folder / name).write_text(text, encoding="ascii")
                self.fails(1, *base, "--surface", self.folder / name, names=[name, *parts])


if __name__ == "__main__":
    unittest.main()
