#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Writes large files of made, curved hexahedra, as solvers and meshers write them.

    large_files.py FOLDER [--boxes N] [--only NAME...]

N^3 hexahedra of the unit cube (default 58: 195,112), each direction bent by a sine, with a smooth
field. Files that are there already are kept. Needs numpy.

    lagrange_g3.vtu       Lagrange cells of order 3, raw appended data
    quadratic.vtu         quadratic cells of 20 nodes (N^3), zlib
    mfem_l2_g2.mesh, .gf  text, nodes and field discontinuous, of order 2: the longest for what it holds
    gmsh_text_g2.msh      4.1, complete hexahedra of order 2 with a view of the nodes
    gmsh_binary_g2.msh    the same, binary
    nektar_p3.xml, .fld   straight hexahedra in compressed XML, Modified_A of order 3
    pieces_g2.pvtu        Lagrange cells of order 2 in eight files, one after the other in z
"""
import argparse
import base64
import pathlib
import zlib

import numpy as np


def field(x, y, z):
    return np.sin(5 * x) * np.cos(4 * y) + z * z


class Lattice:
    """The nodes of `order` on n^3 boxes that share them, x fastest; or on `layers` of them in z."""

    def __init__(self, n, order, layers=None):
        self.n, self.order, self.side = n, order, n * order + 1
        first, last = layers or (0, n)
        self.layers, self.cells = last - first, n * n * (last - first)
        axis = np.linspace(0.0, 1.0, self.side)
        z, y, x = np.meshgrid(axis[first * order:last * order + 1], axis, axis, indexing="ij")
        bent = [a + 0.01 * np.sin(3 * b) * np.cos(c)
                for a, b, c in ((x, y, z), (y, z, x), (z, x, y))]
        self.points = np.stack([b.ravel() for b in bent], axis=1)
        self.values = field(*self.points.T)

    def nodes(self, places):
        """The node at each (i, j, k) of `places` of every box, boxes x places."""
        box = np.arange(self.n) * self.order
        z, y, x = np.meshgrid(box[:self.layers], box, box, indexing="ij")
        first = ((z * self.side + y) * self.side + x).ravel()
        steps = np.array([(k * self.side + j) * self.side + i for i, j, k in places])
        return first[:, None] + steps[None, :]


CORNERS = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)]


def between(a, b, order):
    """The places inside of an edge, from the corner a to b."""
    return [tuple(u * (order - s) + v * s for u, v in zip(a, b)) for s in range(1, order)]


def edges(pairs, order):
    return [p for a, b in pairs for p in between(CORNERS[a], CORNERS[b], order)]


def vtk_places(order):
    """VTK's Lagrange hexahedron (files of version 1.0)."""
    n = order
    inner = range(1, n)
    pairs = [(0, 1), (1, 2), (3, 2), (0, 3), (4, 5), (5, 6), (7, 6), (4, 7),
             (0, 4), (1, 5), (3, 7), (2, 6)]
    places = [tuple(n * c for c in corner) for corner in CORNERS] + edges(pairs, n)
    places += [(e, j, k) for e in (0, n) for k in inner for j in inner]
    places += [(i, e, k) for e in (0, n) for k in inner for i in inner]
    places += [(i, j, e) for e in (0, n) for j in inner for i in inner]
    return places + [(i, j, k) for k in inner for j in inner for i in inner]


def quadratic_places():
    pairs = [(0, 1), (1, 2), (2, 3), (3, 0), (4, 5), (5, 6), (6, 7), (7, 4),
             (0, 4), (1, 5), (2, 6), (3, 7)]
    return [tuple(2 * c for c in corner) for corner in CORNERS] + edges(pairs, 2)


def gmsh_places():
    """Gmsh's complete hexahedron of order 2 (type 12)."""
    pairs = [(0, 1), (0, 3), (0, 4), (1, 2), (1, 5), (2, 3), (2, 6), (3, 7), (4, 5), (4, 7),
             (5, 6), (6, 7)]
    faces = [(1, 1, 0), (1, 0, 1), (0, 1, 1), (2, 1, 1), (1, 2, 1), (1, 1, 2)]
    corners = [tuple(2 * c for c in corner) for corner in CORNERS]
    return corners + edges(pairs, 2) + faces + [(1, 1, 1)]


def write_vtu(path, lattice, places, cell_type, compressed):
    cells = lattice.cells
    connectivity = lattice.nodes(places).astype("<i8")
    blocks, offset = [], 0

    def array(values, name, components):
        nonlocal offset
        data = values.tobytes()
        if compressed:
            size = 1 << 20
            parts = [zlib.compress(data[i:i + size], 1) for i in range(0, len(data), size)]
            head = np.array([len(parts), size, len(data) % size, *map(len, parts)], "<u8")
            data = head.tobytes() + b"".join(parts)
        else:
            data = np.array([len(data)], "<u8").tobytes() + data
        kind = {"f": "Float64", "i": "Int64", "u": "UInt8"}[values.dtype.kind]
        line = (f'<DataArray type="{kind}" Name="{name}" NumberOfComponents="{components}" '
                f'format="appended" offset="{offset}"/>\n')
        blocks.append(data)
        offset += len(data)
        return line

    ends = np.arange(1, cells + 1, dtype="<i8") * len(places)
    compressor = ' compressor="vtkZLibDataCompressor"' if compressed else ""
    head = ('<VTKFile type="UnstructuredGrid" version="1.0" byte_order="LittleEndian" '
            f'header_type="UInt64"{compressor}>\n<UnstructuredGrid>\n'
            f'<Piece NumberOfPoints="{len(lattice.points)}" NumberOfCells="{cells}">\n'
            '<PointData>\n' + array(lattice.values, "u", 1) + '</PointData>\n<Points>\n' +
            array(lattice.points, "Points", 3) + '</Points>\n<Cells>\n' +
            array(connectivity, "connectivity", 1) + array(ends, "offsets", 1) +
            array(np.full(cells, cell_type, "u1"), "types", 1) +
            '</Cells>\n</Piece>\n</UnstructuredGrid>\n<AppendedData encoding="raw">\n_')
    with open(path, "wb") as out:
        out.write(head.encode())
        for block in blocks:
            out.write(block)
        out.write(b"\n</AppendedData>\n</VTKFile>\n")


def write_pvtu(path, n, order, count):
    """In `count` files beside it, each with its own copies of the points that it shares."""
    names = []
    for piece in range(count):
        names.append(f"{path.stem}_{piece}.vtu")
        lattice = Lattice(n, order, (n * piece // count, n * (piece + 1) // count))
        write_vtu(path.with_name(names[-1]), lattice, vtk_places(order), 72, False)
    path.write_text(
        '<VTKFile type="PUnstructuredGrid" version="1.0" byte_order="LittleEndian" header_type="UInt64">\n'
        '<PUnstructuredGrid GhostLevel="0">\n<PPointData>\n'
        '<PDataArray type="Float64" Name="u" NumberOfComponents="1"/>\n</PPointData>\n<PPoints>\n'
        '<PDataArray type="Float64" Name="Points" NumberOfComponents="3"/>\n</PPoints>\n' +
        "".join(f'<Piece Source="{name}"/>\n' for name in names) +
        "</PUnstructuredGrid>\n</VTKFile>\n")


def lines(out, array, form):
    """Rows of numbers, some at a time."""
    row = " ".join([form] * array.shape[1]) + "\n"
    for begin in range(0, len(array), 20000):
        part = array[begin:begin + 20000]
        out.write((row * len(part)) % tuple(part.ravel().tolist()))


def write_mfem_topology(out, n):
    lattice_side = n + 1
    box = np.arange(n)
    z, y, x = np.meshgrid(box, box, box, indexing="ij")
    first = ((z * lattice_side + y) * lattice_side + x).ravel()
    steps = [(k * lattice_side + j) * lattice_side + i for i, j, k in CORNERS]
    corners = first[:, None] + np.array(steps)[None, :]
    out.write(f"MFEM mesh v1.0\n\ndimension\n3\n\nelements\n{n**3}\n")
    lines(out, np.hstack([np.tile([1, 5], (n**3, 1)), corners]), "%d")
    out.write(f"\nboundary\n0\n\nvertices\n{lattice_side**3}\n\n")


def write_mfem(folder, name, n, kind):
    """Discontinuous: box by box, its nodes x fastest."""
    lattice = Lattice(n, 2)
    local = [(i, j, k) for k in range(3) for j in range(3) for i in range(3)]
    nodes = lattice.nodes(local).ravel()
    with open(folder / f"{name}.mesh", "w") as out:
        write_mfem_topology(out, n)
        out.write(f"nodes\nFiniteElementSpace\nFiniteElementCollection: {kind}\nVDim: 3\n"
                  "Ordering: 1\n\n")
        lines(out, lattice.points[nodes], "%.17g")
    with open(folder / f"{name}.gf", "w") as out:
        out.write(f"FiniteElementSpace\nFiniteElementCollection: {kind}\nVDim: 1\nOrdering: 0\n\n")
        lines(out, lattice.values[nodes][:, None], "%.17g")


def write_gmsh(path, n, binary):
    lattice = Lattice(n, 2)
    points, cells = len(lattice.points), n**3
    elements = lattice.nodes(gmsh_places()) + 1
    tags = np.arange(1, points + 1)
    low, high = lattice.points.min(axis=0), lattice.points.max(axis=0)
    with open(path, "wb") as out:
        def text(line):
            out.write(line.encode())

        def sizes(*numbers):
            out.write(np.array(numbers, "<u8").tobytes() if binary
                      else (" ".join(map(str, numbers)) + "\n").encode())

        def ints(*numbers):
            out.write(np.array(numbers, "<i4").tobytes() if binary
                      else (" ".join(map(str, numbers)) + "\n").encode())

        def table(array, form):
            row = " ".join([form] * array.shape[1]) + "\n"
            for begin in range(0, len(array), 20000):
                part = array[begin:begin + 20000]
                text((row * len(part)) % tuple(part.ravel().tolist()))

        text(f"$MeshFormat\n4.1 {int(binary)} 8\n")
        if binary:
            out.write(np.array([1], "<i4").tobytes())
            text("\n")
        text("$EndMeshFormat\n$Entities\n")
        sizes(0, 0, 0, 1)
        if binary:
            out.write(np.array([1], "<i4").tobytes())
            out.write(np.concatenate([low, high]).astype("<f8").tobytes())
            sizes(0, 0)
        else:
            text("1 " + " ".join(repr(float(v)) for v in (*low, *high)) + " 0 0\n")
        text("\n$EndEntities\n$Nodes\n")
        sizes(1, points, 1, points)
        ints(3, 1, 0)
        if binary:
            sizes(points)
            out.write(tags.astype("<u8").tobytes())
            out.write(lattice.points.astype("<f8").tobytes())
        else:
            sizes(points)
            table(tags[:, None], "%d")
            table(lattice.points, "%.16g")
        text("\n$EndNodes\n$Elements\n")
        sizes(1, cells, 1, cells)
        ints(3, 1, 12)
        sizes(cells)
        numbered = np.hstack([np.arange(1, cells + 1)[:, None], elements])
        if binary:
            out.write(numbered.astype("<u8").tobytes())
        else:
            table(numbered, "%d")
        text('\n$EndElements\n$NodeData\n1\n"u"\n1\n0\n3\n0\n1\n' + f"{points}\n")
        if binary:
            pairs = np.empty(points, dtype=[("tag", "<i4"), ("value", "<f8")])
            pairs["tag"], pairs["value"] = tags, lattice.values
            out.write(pairs.tobytes())
        else:
            for begin in range(0, points, 20000):
                some = slice(begin, begin + 20000)
                text("".join(f"{t} {v:.16g}\n" for t, v in
                             zip(tags[some].tolist(), lattice.values[some].tolist())))
        text("\n$EndNodeData\n")


def b64z(array):
    return base64.b64encode(zlib.compress(array.tobytes(), 1)).decode()


def write_nektar(folder, name, n, modes):
    """Vertices, edges and faces of a grid of boxes; the faces' first edges as Nektar++ has them."""
    side = n + 1
    axis = np.linspace(0.0, 1.0, side)

    def number(counts, i, j, k):
        return (k * counts[1] + j) * counts[0] + i

    def grid(counts):
        k, j, i = np.meshgrid(*(np.arange(c) for c in reversed(counts)), indexing="ij")
        return i.ravel(), j.ravel(), k.ravel()

    vertex_counts = (side, side, side)
    vertex = lambda i, j, k: number(vertex_counts, i, j, k)
    vi, vj, vk = grid(vertex_counts)
    vertices = np.empty(side**3, dtype=[("id", "<i8"), ("x", "<f8", 3)])
    vertices["id"] = np.arange(side**3)
    vertices["x"] = np.stack([axis[vi], axis[vj], axis[vk]], axis=1)

    edge_counts = [(n, side, side), (side, n, side), (side, side, n)]
    edge_first = np.cumsum([0] + [int(np.prod(c)) for c in edge_counts])
    edge = lambda d, i, j, k: edge_first[d] + number(edge_counts[d], i, j, k)
    edges_of = []
    for d in range(3):
        i, j, k = grid(edge_counts[d])
        step = [0, 0, 0]
        step[d] = 1
        edges_of.append(np.stack([vertex(i, j, k),
                                  vertex(i + step[0], j + step[1], k + step[2])], axis=1))
    edge_table = np.vstack(edges_of)
    edge_rows = np.hstack([np.arange(len(edge_table))[:, None], edge_table]).astype("<i8")

    face_counts = [(n, n, side), (n, side, n), (side, n, n)]  # normal to z, y, x
    face_first = np.cumsum([0] + [int(np.prod(c)) for c in face_counts])
    face = lambda d, i, j, k: face_first[d] + number(face_counts[d], i, j, k)
    faces_of = []
    i, j, k = grid(face_counts[0])
    faces_of.append([edge(0, i, j, k), edge(1, i + 1, j, k), edge(0, i, j + 1, k), edge(1, i, j, k)])
    i, j, k = grid(face_counts[1])
    faces_of.append([edge(0, i, j, k), edge(2, i + 1, j, k), edge(0, i, j, k + 1), edge(2, i, j, k)])
    i, j, k = grid(face_counts[2])
    faces_of.append([edge(1, i, j, k), edge(2, i, j + 1, k), edge(1, i, j, k + 1), edge(2, i, j, k)])
    face_table = np.vstack([np.stack(f, axis=1) for f in faces_of])
    face_rows = np.hstack([np.arange(len(face_table))[:, None], face_table]).astype("<i8")

    i, j, k = grid((n, n, n))
    solid = np.stack([np.arange(n**3), face(0, i, j, k), face(1, i, j, k), face(2, i + 1, j, k),
                      face(1, i, j + 1, k), face(2, i, j, k), face(0, i, j, k + 1)], axis=1)
    rows = solid.astype("<i8")
    packed = 'COMPRESSED="B64Z-LittleEndian" BITSIZE="64"'
    with open(folder / f"{name}.xml", "w") as out:
        out.write('<?xml version="1.0" encoding="utf-8" ?>\n<NEKTAR>\n'
                  '<GEOMETRY DIM="3" SPACE="3">\n'
                  f'<VERTEX {packed}>{b64z(vertices)}</VERTEX>\n'
                  f'<EDGE {packed}>{b64z(edge_rows)}</EDGE>\n'
                  f'<FACE><Q {packed}>{b64z(face_rows)}</Q></FACE>\n'
                  f'<ELEMENT><H {packed}>{b64z(rows)}</H></ELEMENT>\n<CURVED />\n'
                  f'<COMPOSITE><C ID="0"> H[0-{n**3 - 1}] </C></COMPOSITE>\n'
                  '<DOMAIN> C[0] </DOMAIN>\n</GEOMETRY>\n</NEKTAR>\n')
    values = np.random.default_rng(1).standard_normal(n**3 * modes**3).astype("<f8")
    with open(folder / f"{name}.fld", "w") as out:
        out.write('<?xml version="1.0" encoding="utf-8" ?>\n<NEKTAR>\n'
                  '<ELEMENTS FIELDS="u" SHAPE="Hexahedron" '
                  'BASIS="Modified_A,Modified_A,Modified_A" '
                  f'NUMMODESPERDIR="UNIORDER:{modes},{modes},{modes}" ID="0-{n**3 - 1}" '
                  f'{packed}>{b64z(values)}</ELEMENTS>\n</NEKTAR>\n')


def makers(folder, n):
    return {
        "lagrange_g3.vtu": lambda: write_vtu(
            folder / "lagrange_g3.vtu", Lattice(n, 3), vtk_places(3), 72, False),
        "quadratic.vtu": lambda: write_vtu(
            folder / "quadratic.vtu", Lattice(n, 2), quadratic_places(), 25, True),
        "mfem_l2_g2.mesh": lambda: write_mfem(folder, "mfem_l2_g2", n, "L2_T4_3D_P2"),
        "gmsh_text_g2.msh": lambda: write_gmsh(folder / "gmsh_text_g2.msh", n, False),
        "gmsh_binary_g2.msh": lambda: write_gmsh(folder / "gmsh_binary_g2.msh", n, True),
        "nektar_p3.xml": lambda: write_nektar(folder, "nektar_p3", n, 4),
        "pieces_g2.pvtu": lambda: write_pvtu(folder / "pieces_g2.pvtu", n, 2, 8),
    }


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--boxes", type=int, default=58)
    parser.add_argument("--only", nargs="*", default=[])
    arguments = parser.parse_args()
    arguments.folder.mkdir(parents=True, exist_ok=True)
    for name, make in makers(arguments.folder, arguments.boxes).items():
        wanted = not arguments.only or any(part in name for part in arguments.only)
        if wanted and not (arguments.folder / name).exists():
            make()
            print(name)


if __name__ == "__main__":
    main()
