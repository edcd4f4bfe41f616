# SPDX-License-Identifier: BSD-3-Clause
"""What the tests of the command-line tool share: running it, small meshes, its buffers."""

import csv
import json
import math
import os
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

import numpy as np

TOOL = os.environ["PIXELEXACT_TOOL"]
DATA = Path(os.environ["PIXELEXACT_DATA_DIR"])

# Files of Data/ and the order of their field u.
CASES = {
    "toroid_hex_g3_p6": 6,
    "escher_tet_g3_p3": 3,
    "toroid_prism_g3_p4": 4,
    "fichera_hex_g3_p4": 4,
    "periodic_hex_dg_g3_p4": 4,
    "dolfinx_hex_g2_p4": 4,
}


# The corners of [0,1]^3 in the order of VTK's hexahedron.
CUBE = [[x, y, z] for z in (0.0, 1.0) for x, y in ((0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0))]
# A cut through each of them.
MIDDLE = ("--plane", "0,0,0,0,0,1")


def run(*arguments, folder=None, given="", text=True, stdout=subprocess.PIPE):
    """The tool's run, in `folder`, without a display, so that a touch of OpenGL would end it;
    `given` is its standard input. stdout is bytes where not `text`."""
    environment = {name: value for name, value in os.environ.items() if name != "DISPLAY"}
    return subprocess.run(
        [TOOL, *map(str, arguments)],
        env=environment,
        input=given if text else given.encode(),
        stdout=stdout,
        stderr=subprocess.PIPE,
        text=text,
        cwd=folder,
        timeout=300,
        check=False,
    )


def case(name):
    return DATA / f"{name}.vtu"


def oracle(name):
    """The oracle's rows as a dictionary of columns: numbers where they are numbers."""
    with open(DATA / f"{name}.oracle.csv", encoding="utf-8", newline="") as stream:
        return columns(list(csv.DictReader(stream)))


def columns(rows):
    """Columns of csv.DictReader's rows, as arrays of float where every entry is a number."""
    result = {}
    for name in rows[0] if rows else []:
        texts = [row[name] for row in rows]
        try:
            result[name] = np.array([float(text) for text in texts])
        except ValueError:
            result[name] = np.array(texts)
    return result


def read_csv(path):
    with open(path, encoding="utf-8", newline="") as stream:
        return list(csv.DictReader(stream))


def strict_json(text):
    """json.loads that refuses NaN and Infinity, which JSON does not know."""

    def refuse(constant):
        raise ValueError(f"{constant} is not JSON")

    return json.loads(text, parse_constant=refuse)


class ToolTest(unittest.TestCase):
    """A test with a folder of its own."""

    def setUp(self):
        self.folder = Path(tempfile.mkdtemp(prefix="pixelexact-"))
        self.addCleanup(shutil.rmtree, self.folder)

    def succeeds(self, *arguments):
        done = run(*arguments)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done

    def summary(self, *arguments):
        """The JSON summary of a run that succeeds."""
        return strict_json(self.succeeds(*arguments, "--json").stdout)

    def fails(self, status, *arguments, names=()):
        """A run that fails with this status and one line that names what it is about."""
        done = run(*arguments)
        self.assertEqual(done.returncode, status, f"{arguments}: {done.stdout}{done.stderr}")
        for name in names:
            self.assertIn(str(name), done.stderr)
        self.assertEqual(len(done.stderr.strip().splitlines()), 1, done.stderr)
        self.assertTrue(done.stderr.startswith("pixelexact: "), done.stderr)
        return done


def plain_grid(points, cells, fields=(), cell_fields=()):
    """The text of an ascii .vtu: cells as (type, point ids), fields as (name, rows of values)."""

    def array(name, kind, rows, per_row=1):
        text = "\n".join(" ".join(repr(v) for v in np.atleast_1d(row).tolist()) for row in rows)
        return (
            f'<DataArray type="{kind}" Name="{name}" NumberOfComponents="{per_row}" '
            f'format="ascii">\n{text}\n</DataArray>\n'
        )

    def data(section, arrays):
        body = "".join(
            array(name, "Float64", rows, len(np.atleast_1d(rows[0])) if len(rows) else 1)
            for name, rows in arrays
        )
        return f"<{section}>\n{body}</{section}>\n"

    offsets = np.cumsum([len(ids) for _, ids in cells]) if cells else []
    return (
        '<?xml version="1.0"?>\n'
        '<VTKFile type="UnstructuredGrid" version="1.0" byte_order="LittleEndian" '
        'header_type="UInt64">\n<UnstructuredGrid>\n'
        f'<Piece NumberOfPoints="{len(points)}" NumberOfCells="{len(cells)}">\n'
        + data("PointData", fields)
        + data("CellData", cell_fields)
        + "<Points>\n"
        + array("Points", "Float64", points, 3)
        + "</Points>\n<Cells>\n"
        + array("connectivity", "Int64", [ids for _, ids in cells])
        + array("offsets", "Int64", offsets)
        + array("types", "UInt8", [kind for kind, _ in cells])
        + "</Cells>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n"
    )


def unit_cube_grid(fields=None, **more):
    """One linear hexahedron, [0,1]^3, with the field u = x."""
    if fields is None:
        fields = [("u", [point[0] for point in CUBE])]
    return plain_grid(CUBE, [(12, list(range(8)))], fields, **more)


def read_buffers(path):
    """A .vti's arrays, by name, as (height, width[, components]) arrays."""
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkIOXML import vtkXMLImageDataReader

    reader = vtkXMLImageDataReader()
    reader.SetFileName(str(path))
    reader.Update()
    image = reader.GetOutput()
    width, height, _ = image.GetDimensions()
    data = image.GetPointData()
    buffers = {}
    for i in range(data.GetNumberOfArrays()):
        array = vtk_to_numpy(data.GetArray(i))
        buffers[data.GetArrayName(i)] = array.reshape((height, width) + array.shape[1:])
    return buffers


def read_image(path):
    """A PNG's pixels, lower left first, as (height, width, channels)."""
    return read_with("vtkPNGReader", path)


def read_with(name, path):
    """The same of what one of VTK's readers reads."""
    from vtkmodules import vtkIOImage
    from vtkmodules.util.numpy_support import vtk_to_numpy

    reader = getattr(vtkIOImage, name)()
    reader.SetFileName(str(path))
    reader.Update()
    image = reader.GetOutput()
    width, height, _ = image.GetDimensions()
    return vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, -1)


def unit(vector):
    return np.asarray(vector, float) / np.linalg.norm(vector)


class View:
    """A camera as the command line gives it, and its rays, computed here once more."""

    def __init__(self, position, focal_point, view_up, width, height, angle=None, scale=None):
        self.position = np.asarray(position, float)
        self.focal_point = np.asarray(focal_point, float)
        self.view_up = np.asarray(view_up, float)
        self.size = (width, height)
        self.angle = angle
        self.scale = scale

    @staticmethod
    def of_summary(camera, width, height):
        """From the camera that a render's JSON summary tells."""
        parallel = "parallel_scale" in camera
        return View(
            camera["position"],
            camera["focal_point"],
            camera["view_up"],
            width,
            height,
            angle=None if parallel else camera["view_angle"],
            scale=camera["parallel_scale"] if parallel else None,
        )

    def options(self):
        def numbers(vector):
            return ",".join(repr(float(v)) for v in vector)

        zoom = (
            ["--parallel-scale", self.scale]
            if self.scale is not None
            else ["--view-angle", self.angle]
        )
        return [
            "--camera-position",
            numbers(self.position),
            "--focal-point",
            numbers(self.focal_point),
            "--view-up",
            numbers(self.view_up),
            "--size",
            f"{self.size[0]}x{self.size[1]}",
            *zoom,
        ]

    def rays(self):
        """Origins and unit directions of the rays through the pixels' centres."""
        width, height = self.size
        forward = unit(self.focal_point - self.position)
        right = unit(np.cross(forward, self.view_up))
        up = np.cross(right, forward)
        u = (2 * (np.arange(width) + 0.5) / width - 1) * (width / height)
        v = 2 * (np.arange(height) + 0.5) / height - 1
        v, u = np.meshgrid(v, u, indexing="ij")
        offset = u[..., None] * right + v[..., None] * up
        if self.scale is not None:
            origin = self.position + self.scale * offset
            return origin, np.broadcast_to(forward, origin.shape)
        direction = forward + math.tan(math.radians(self.angle) / 2) * offset
        direction /= np.linalg.norm(direction, axis=-1, keepdims=True)
        return np.broadcast_to(self.position, direction.shape), direction
