#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Lagrange hexahedra: written as interpolants, and evaluated by NumPy from the nodes of a .vtu, beside
the program's own bases.

    lagrange.py         writes Data/sine_series, interpolants of SINE of orders 1 to 4; the environment is
                        that of the tests
"""

import itertools
import math

import numpy as np
from tool import DATA, plain_grid
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkLagrangeHexahedron
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader, vtkXMLUnstructuredGridWriter

SINE = "sin(pi*x)*sin(pi*y)*sin(pi*z)"


def sine(x, y, z):
    return math.sin(math.pi * x) * math.sin(math.pi * y) * math.sin(math.pi * z)


def lagrange_grid(function, cells, order):
    """The text of a .vtu: [0,1]^3 of cells^3 Lagrange hexahedra with the interpolant of `function`."""
    nodes = (order + 1) ** 3
    points, elements = [], []
    for cell in np.ndindex(cells, cells, cells):
        own = [None] * nodes
        for ijk in np.ndindex(order + 1, order + 1, order + 1):
            at = vtkLagrangeHexahedron.PointIndexFromIJK(*ijk, [order, order, order])
            own[at] = [(c + a / order) / cells for c, a in zip(cell, ijk, strict=True)]
        elements.append((72, list(range(len(points), len(points) + nodes))))
        points += own
    values = [float(function(*point)) for point in points]
    text = plain_grid(points, elements, [("u", values)])
    # VTK's readers renumber the nodes of files before version 2.2.
    return text.replace('"1.0" byte_order', '"2.2" byte_order')


def read_hexahedra(path, field="u"):
    """For each cell an array of its nodes, [i, j, k] along xi, with x, y, z and the field."""
    reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(str(path))
    reader.Update()
    grid = reader.GetOutput()
    points = vtk_to_numpy(grid.GetPoints().GetData()).astype(float)
    nodes = np.column_stack([points, vtk_to_numpy(grid.GetPointData().GetArray(field)).astype(float)])
    cells = []
    for c in range(grid.GetNumberOfCells()):
        ids = grid.GetCell(c).GetPointIds()
        n = round(ids.GetNumberOfIds() ** (1 / 3)) - 1
        cell = np.empty((n + 1, n + 1, n + 1, 4))
        for i, j, k in itertools.product(range(n + 1), repeat=3):
            cell[i, j, k] = nodes[ids.GetId(vtkLagrangeHexahedron.PointIndexFromIJK(i, j, k, (n, n, n)))]
        cells.append(cell)
    return cells


def basis(n, s):
    """Values and derivatives at s of Lagrange's polynomials of n + 1 equispaced nodes, [point, node]."""
    nodes = np.linspace(-1, 1, n + 1)
    to_monomials = np.linalg.inv(np.vander(nodes, increasing=True))
    powers = np.vander(s, n + 1, increasing=True)
    slopes = np.column_stack([np.zeros(len(s)), powers[:, :-1] * np.arange(1, n + 1)])
    return powers @ to_monomials, slopes @ to_monomials


def evaluate(cell, s, t, r):
    """Nodes' quantities on the lattice of s, t and r, and their derivatives by xi: [i, j, k, quantity]."""
    n = cell.shape[0] - 1
    (a, da), (b, db), (c, dc) = (basis(n, one) for one in (s, t, r))

    def along(one, two, three):
        return np.einsum("ai,bj,ck,ijkf->abcf", one, two, three, cell, optimize=True)

    return along(a, b, c), (along(da, b, c), along(a, db, c), along(a, b, dc))


def norms(cells, count=14):
    """Volume, L1 (as far as |u| is smooth), L2 by Gauss quadrature with count points along each direction."""
    points, weights = np.polynomial.legendre.leggauss(count)
    w = weights[:, None, None] * weights[None, :, None] * weights[None, None, :]
    sums = np.zeros(2)
    for cell in cells:
        values, slopes = evaluate(cell, points, points, points)
        jacobian = np.linalg.det(np.stack([one[..., :3] for one in slopes], axis=-1))
        sums += [np.sum(w * np.abs(jacobian)), np.sum(w * np.abs(jacobian) * values[..., 3] ** 2)]
    return sums[0], np.sqrt(sums[1])


def jumps(cells, count=14):
    """The area of the faces that two cells share, and the L2 norm over them of the difference of u."""
    points, weights = np.polynomial.legendre.leggauss(count)
    w = weights[:, None] * weights[None, :]
    end, faces, sums = np.ones(1), {}, np.zeros(2)
    for number, cell in enumerate(cells):
        for direction in range(3):
            for side in (-1, 1):
                at = [points, points, points]
                at[direction] = side * end
                values, slopes = evaluate(cell, *at)
                others = [slopes[d].reshape(count, count, 4)[..., :3] for d in range(3) if d != direction]
                area = w * np.linalg.norm(np.cross(*others), axis=-1)
                face = np.column_stack([values.reshape(-1, 4), area.ravel()])
                # Both cells have the same points on a face, in orders of their own.
                face = face[np.lexsort(np.round(face[:, 2::-1], 7).T)]
                middle = tuple(np.round(face[:, :3].mean(axis=0), 7) + 0.0)
                other = faces.setdefault(middle, (number, face))
                if other[0] != number:
                    np.testing.assert_allclose(other[1][:, :3], face[:, :3], rtol=0, atol=1e-12)
                    square = (other[1][:, 3] - face[:, 3]) ** 2
                    sums += [face[:, 4].sum(), np.sum(face[:, 4] * square)]
    return sums[0], np.sqrt(sums[1])


def main():
    folder = DATA / "sine_series"
    folder.mkdir(exist_ok=True)
    for order in (1, 2, 3, 4):
        path = folder / f"p{order}.vtu"
        path.write_text(lagrange_grid(sine, 2, order), encoding="utf-8")
        reader, writer = vtkXMLUnstructuredGridReader(), vtkXMLUnstructuredGridWriter()
        reader.SetFileName(str(path))
        reader.Update()
        writer.SetFileName(str(path))
        writer.SetInputConnection(reader.GetOutputPort())
        if writer.Write() != 1:
            raise OSError(f"cannot write '{path}'")


if __name__ == "__main__":
    main()
