# SPDX-License-Identifier: BSD-3-Clause
"""Writes meshes of HOPR and states of FLEXI, by their descriptions, without these programs."""

import numpy as np
from hdf5 import Writer
from nek5000 import gauss_lobatto

CONDITIONS = ["wall", "inflow", "side", "outflow", "left", "top"]


def gauss(n):
    return np.polynomial.legendre.leggauss(n)[0]


def bent(points):
    """The place of points in the unit box, curved with order 2."""
    x, y, z = points
    return np.array([x + 0.125 * y * y, y, z + 0.25 * x * y])


def lattice(lines):
    """The points of a product of lines, the first one fastest: rows x, y, z."""
    axes = np.meshgrid(*reversed(lines), indexing="ij")
    return np.array([axis.ravel() for axis in reversed(axes)])


def elements(counts, lines, place=bent):
    """The nodes of the elements of a grid of the unit box: an array (element, 3, node)."""
    local = (lattice(lines) + 1) / 2
    corners = [corner[::-1] for corner in np.ndindex(*reversed(counts))]
    return np.array([place((local + np.array(corner)[:, None]) / np.array(counts)[:, None]) for corner in corners])


def write_mesh(path, counts, order, *, place=bent, kinds=None, sides=True, **changes):
    """A mesh of counts[0] x counts[1] x counts[2] hexahedra. The box' sides have the conditions 1 to 6, in the
    order -z, -y, x, y, -x, z. `changes`: other values of data sets and attributes; None leaves one out."""
    nodes = elements(counts, [np.linspace(-1, 1, order + 1)] * 3, place)
    each = nodes.shape[2]
    number = len(nodes)
    info, conditions = np.zeros((number, 6), np.int32), []
    corners = [corner[::-1] for corner in np.ndindex(*reversed(counts))]
    for e, (i, j, k) in enumerate(corners):
        info[e] = [208, 1 + (i > 0), 6 * e, 6 * (e + 1), each * e, each * (e + 1)]
        ends = [k == 0, j == 0, i == counts[0] - 1, j == counts[1] - 1, i == 0, k == counts[2] - 1]
        conditions += [[24, 0, 0, 0, c + 1 if end else 0] for c, end in enumerate(ends)]
    info[:, 0] = kinds if kinds is not None else info[:, 0]
    rows = nodes.transpose(0, 2, 1).reshape(-1, 3)
    _, numbers = np.unique(rows.round(9), axis=0, return_inverse=True)
    values = {"Ngeo": np.array([order], np.int32), "nElems": np.array([number], np.int32), "ElemInfo": info,
              "NodeCoords": rows, "GlobalNodeIDs": (numbers + 1).astype(np.int32)}
    if sides:
        values["SideInfo"] = np.array(conditions, np.int32)
        values["BCNames"] = [name.ljust(255) for name in CONDITIONS]
    write(path, {**values, **changes}, ["Ngeo", "nElems"])


def state_values(counts, n, fields, *, nodes="GAUSS", across=None, place=bent):
    """DG_Solution: functions of x, y, z at the nodes, as (element, k, j, i, variable)."""
    line = gauss(n) if nodes == "GAUSS" else gauss_lobatto(n)
    points = elements(counts, [line, line, np.zeros(1) if across == 1 else line], place)
    values = np.array([[function(*element) for function in fields] for element in points])
    return values.transpose(0, 2, 1).reshape(len(points), across or n, n, n, len(fields))


def write_state(path, counts, n, fields, *, nodes="GAUSS", time=0.0, mesh="box_mesh.h5", across=None, place=bent,
                **changes):
    """A state of `fields`, a dictionary of functions of x, y, z. `changes` as for write_mesh."""
    attributes = {"N": np.array([n - 1], np.int32), "NodeType": nodes.ljust(255), "Time": np.array([time]),
                  "MeshFile": [mesh.ljust(255)], "VarNames": [name.ljust(255) for name in fields],
                  "Program": "Flexi".ljust(255), "File_Type": "State".ljust(255), "Project_Name": "box".ljust(255)}
    solution = state_values(counts, n, fields.values(), nodes=nodes, across=across, place=place)
    write(path, {**attributes, "DG_Solution": solution, **changes}, [*attributes, "VarNamesAdd", "VarNamesAddField"])


def write(path, values, attributes):
    with Writer(path) as file:
        for name, value in values.items():
            if value is None:
                continue
            if name in attributes:
                file.attribute("/", name, value)
            else:
                file.dataset(f"/{name}", value)
