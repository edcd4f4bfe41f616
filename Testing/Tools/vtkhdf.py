#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Writes unstructured grids in VTK's HDF format, by its specification.

    vtkhdf.py IN.vtu OUT.vtkhdf
    vtkhdf.py OUT.vtkhdf            writes Data/vtkhdf_steps.vtkhdf
"""

import sys

import numpy as np
from hdf5 import Writer

DATA = ["PointData", "CellData"]
# Arrays by which VTK finds what its cells are; the names are those of the attributes.
PURPOSES = ["RationalWeights", "HigherOrderDegrees"]


def read_grid(path):
    """The unstructured grid of a .vtu."""
    from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader

    reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(str(path))
    reader.Update()
    return reader.GetOutput()


class Part:
    """A part of a grid: its arrays."""

    def __init__(self, points, types, offsets, connectivity, point_data=None, cell_data=None, field_data=None):
        self.points = points
        self.types = np.asarray(types, np.uint8)
        self.offsets = np.asarray(offsets, np.int64)
        self.connectivity = np.asarray(connectivity, np.int64)
        self.data = {"PointData": point_data or {}, "CellData": cell_data or {}, "FieldData": field_data or {}}

    @classmethod
    def of(cls, grid):
        """Of a vtkUnstructuredGrid."""
        from vtkmodules.util.numpy_support import vtk_to_numpy

        cells = grid.GetCells()
        arrays = [
            {data.GetArrayName(i): vtk_to_numpy(data.GetArray(i)) for i in range(data.GetNumberOfArrays())}
            for data in (grid.GetPointData(), grid.GetCellData())
        ]
        return cls(vtk_to_numpy(grid.GetPoints().GetData()), vtk_to_numpy(grid.GetCellTypesArray()),
                   vtk_to_numpy(cells.GetOffsetsArray()), vtk_to_numpy(cells.GetConnectivityArray()), *arrays)

    def cells(self, first, last):
        """Some of its cells with the points that they have."""
        ids = self.connectivity[self.offsets[first]:self.offsets[last]]
        used, places = np.unique(ids, return_inverse=True)
        return Part(self.points[used], self.types[first:last], self.offsets[first:last + 1] - self.offsets[first],
                    places, {name: array[used] for name, array in self.data["PointData"].items()},
                    {name: array[first:last] for name, array in self.data["CellData"].items()})


def write_block(file, root, parts, *, steps=None, moving=True, version=(2, 0), kind="UnstructuredGrid", chunk=None,
                marks="array", field_data=None, index=None, cells=None, counted=True):
    """Writes a grid at `root`. `parts`: its parts, or for `steps`, times, a list of parts for each of them. Where
    the mesh is not `moving` it is written once, at the first step. `marks`: where purposes of arrays are stated:
    "array", "group" or None. `cells`: a number of cells for each part that need not be true. `counted`: steps state
    their numbers of parts."""
    every = parts if steps is not None else [parts]
    meshes = every if moving else every[:1]
    flat = [part for step in meshes for part in step]
    whole = [part for step in every for part in step]
    file.group(root)
    file.attribute(root, "Version", np.array(version))
    file.attribute(root, "Type", kind)
    if index is not None:
        file.attribute(root, "Index", np.array([index]))
    file.dataset(f"{root}/NumberOfPoints", np.array([len(part.points) for part in flat]))
    file.dataset(f"{root}/NumberOfCells", np.array([cells or len(part.types) for part in flat]))
    file.dataset(f"{root}/NumberOfConnectivityIds", np.array([len(part.connectivity) for part in flat]))
    file.dataset(f"{root}/Points", np.concatenate([part.points for part in flat]), chunk)
    for name in ["types", "offsets", "connectivity"]:
        file.dataset(f"{root}/{name.capitalize()}", np.concatenate([getattr(part, name) for part in flat]), chunk)
    for group in DATA:
        file.group(f"{root}/{group}")
        for name in whole[0].data[group]:
            path = f"{root}/{group}/{name}"
            file.dataset(path, np.concatenate([part.data[group][name] for part in whole]), chunk)
            if name in PURPOSES and marks:
                file.attribute(path if marks == "array" else f"{root}/{group}",
                               "Attribute" if marks == "array" else name, name)
    file.group(f"{root}/FieldData")
    for name, values in (field_data or {}).items():
        file.dataset(f"{root}/FieldData/{name}", values)
    if steps is not None:
        write_steps(file, root, every, steps, moving, counted)


def write_steps(file, root, every, times, moving, counted=True):
    """The group Steps."""
    def before(count):
        return np.concatenate([[0], np.cumsum([sum(count(part) for part in step) for step in every])[:-1]])

    mesh = 1 if moving else 0
    file.group(f"{root}/Steps")
    file.attribute(f"{root}/Steps", "NSteps", np.array(len(times)))
    file.dataset(f"{root}/Steps/Values", np.array(times, float))
    if counted:
        file.dataset(f"{root}/Steps/NumberOfParts", np.array([len(step) for step in every]))
    file.dataset(f"{root}/Steps/PartOffsets", mesh * before(lambda part: 1))
    file.dataset(f"{root}/Steps/PointOffsets", mesh * before(lambda part: len(part.points)))
    file.dataset(f"{root}/Steps/CellOffsets", mesh * before(lambda part: len(part.types))[:, None])
    file.dataset(f"{root}/Steps/ConnectivityIdOffsets", mesh * before(lambda part: len(part.connectivity))[:, None])
    for group, count in zip(DATA, [lambda part: len(part.points), lambda part: len(part.types)]):
        file.group(f"{root}/Steps/{group}Offsets")
        for name in every[0][0].data[group]:
            file.dataset(f"{root}/Steps/{group}Offsets/{name}", before(count))


def write(path, parts, **more):
    with Writer(path) as file:
        write_block(file, "/VTKHDF", parts, **more)


def write_collection(path, blocks, kind="PartitionedDataSetCollection"):
    """Blocks: names and keyword arguments of write_block, among them `parts`."""
    with Writer(path) as file:
        file.group("/VTKHDF")
        file.attribute("/VTKHDF", "Version", np.array([2, 1]))
        file.attribute("/VTKHDF", "Type", kind)
        file.group("/VTKHDF/Assembly")
        for number, (name, arguments) in enumerate(blocks.items()):
            write_block(file, f"/VTKHDF/{name}", index=number, **arguments)
            file.link(f"/VTKHDF/Assembly/{name}", f"/VTKHDF/{name}")


def lagrange_cube(x, u):
    """A hexahedron of order 2 from x to x + 1, and the values of the function u at its 27 points."""
    from vtkmodules.vtkCommonDataModel import vtkLagrangeHexahedron

    points = np.zeros((27, 3))
    for place in np.ndindex(3, 3, 3):
        points[vtkLagrangeHexahedron.PointIndexFromIJK(*place, [2, 2, 2])] = np.array(place) / 2
    points[:, 0] += x
    return Part(points, [72], [0, 27], range(27), {"u": u(*points.T)}, {"number": np.array([int(x)])})


def example(path):
    """Three cubes in two parts, and three steps of a field, which is a polynomial of order 2."""
    def cube(x, t):
        return lagrange_cube(x, lambda x, y, z: 1 + t * x - 2 * y * z + (t + 1) * x * x)

    def joined(a, b):
        return Part(np.concatenate([a.points, b.points]), [*a.types, *b.types], [0, 27, 54], range(54),
                    *({name: np.concatenate([a.data[group][name], b.data[group][name]]) for name in a.data[group]}
                      for group in DATA))

    times = [0.0, 0.5, 1.0]
    write(path, [[joined(cube(0, t), cube(1, t)), cube(2, t)] for t in times], steps=times, moving=False)


if __name__ == "__main__":
    if len(sys.argv) == 2:
        example(sys.argv[1])
    else:
        write(sys.argv[2], [Part.of(read_grid(sys.argv[1]))])
