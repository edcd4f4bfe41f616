#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Writes files of Nek5000, nekRS and neko, without these programs.

    nek5000.py FOLDER    writes the files of Data/nek5000_bent
"""

import sys
from pathlib import Path

import numpy as np


def gauss_lobatto(n):
    """n Gauss-Lobatto-Legendre points."""
    slope = np.polynomial.legendre.Legendre.basis(n - 1).deriv()
    inner = slope.roots().real
    for _ in range(3):
        inner -= slope(inner) / slope.deriv()(inner)
    return np.concatenate([[-1.0], np.sort(inner), [1.0]])


def lattice(n, dimension):
    """The points of an element in [-1, 1]^dimension, x fastest: an array of `dimension` rows."""
    line = gauss_lobatto(n)
    axes = np.meshgrid(*[line] * dimension, indexing="ij")
    return np.array([axis.ravel() for axis in reversed(axes)])


def bent(points):
    """The place of points in the unit box, curved with order 2 in space and in the plane."""
    if len(points) == 2:
        x, y = points
        return np.array([x + 0.125 * y * y, y - 0.0625 * x * x])
    x, y, z = points
    return np.array([x + 0.125 * y * y, y, z + 0.25 * x * y])


def grid(counts, n, place=bent):
    """The nodes of the elements of a grid of the unit box, one array of rows x, y (and z) for each."""
    local = (lattice(n, len(counts)) + 1) / 2
    corners = np.ndindex(*reversed(counts))
    return [place((local.T + corner[::-1]).T / np.array(counts)[:, None]) for corner in corners]


def step_bytes(nodes, n, fields, *, mesh=True, numbers=None, total=None, word=8, order="<", time=0.0, step=0,
               part=0, parts=1, ranges=False, codes=None, tail=""):
    """A file of a step. `nodes`: the nodes of its elements. `fields`: a letter (U, P, T, or S for each scalar)
    and a function of the rows x, y and z for each block, in the order of the file."""
    dimension = len(nodes[0])
    numbers = range(1, len(nodes) + 1) if numbers is None else numbers
    blocks = [list(nodes)] if mesh else []
    blocks += [[np.atleast_2d(function(*element)) for element in nodes] for _, function in fields]
    letters = [letter for letter, _ in fields]
    scalars = letters.count("S")
    if codes is None:
        codes = "X" * mesh + "".join(letter for letter in letters if letter != "S")
        codes += f"S{scalars:02d}" if scalars else ""
    last = n if dimension == 3 else 1
    head = (f"#std {word} {n:2d} {n:2d} {last:2d} {len(nodes):10d} {total or len(nodes):10d} {time:20.13E} {step:9d}"
            f" {part:6d} {parts:6d} {codes:10s}{tail}")
    kind = np.dtype(f"{order}f{word}")
    out = head.ljust(132).encode() + np.array(6.54321, f"{order}f4").tobytes()
    out += np.array(list(numbers), f"{order}i4").tobytes()
    out += b"".join(element.astype(kind).tobytes() for block in blocks for element in block)
    if ranges:
        extremes = [[row.min(), row.max()] for block in blocks for element in block for row in element]
        out += np.array(extremes).astype(f"{order}f4").tobytes()
    return out


def list_bytes(template, first, count):
    return f"filetemplate: {template}\nfirsttimestep: {first}\nnumtimesteps: {count}\n".encode()


def main(folder):
    """Two steps in two parts, of which the first alone has the mesh: 2 x 1 x 1 elements of order 3, the
    pressure (1 + time) (x y - z). The oracle has the first step's pressure."""
    nodes = grid((2, 1, 1), 4)
    for step, time in enumerate([0.5, 1.25]):
        fields = [
            ("U", lambda x, y, z: np.array([y, x, -z])),
            ("P", lambda x, y, z, scale=1 + time: scale * (x * y - z)),
        ]
        for part in range(2):
            (folder / f"bent{part}.f{step:05d}").write_bytes(step_bytes(
                nodes[part:part + 1], 4, fields, mesh=step == 0, numbers=[part + 1], total=2, time=time, step=step,
                part=part, parts=2, ranges=True))
    (folder / "bent.nek5000").write_bytes(list_bytes("bent%01d.f%05d", 0, 2))
    rows = ["x,y,z,element,type,xi1,xi2,xi3,u"]
    for xi in np.random.default_rng(1).uniform(-1, 1, (100, 3)).round(6):
        element = len(rows) % 2 + 1
        x, y, z = bent(((xi + 1) / 2 + [element - 1, 0, 0]) / [2, 1, 1])
        place = ",".join(repr(float(number)) for number in (x, y, z))
        local = ",".join(repr(float(number)) for number in xi)
        rows.append(f"{place},{element},hex,{local},{float(1.5 * (x * y - z))!r}")
    (folder / "oracle.csv").write_text("\n".join(rows) + "\n")


if __name__ == "__main__":
    main(Path(sys.argv[1]))
