# SPDX-License-Identifier: BSD-3-Clause
"""Formats of several blocks: Exodus II, and CGNS by VTK's own reader."""

import random
import struct
import unittest

import numpy as np

from exodus import FLOAT, INT64, exodus
from tool import CUBE, DATA, ToolTest, columns, read_buffers, read_csv, run

EXODUS = DATA / "exodus_quadratic.e"
SIDES = DATA / "exodus_sides.e"
NETCDF4 = DATA / "exodus_netcdf4.e"
CGNS = DATA / "cgns_hexa27.cgns"
CUBIC = DATA / "cgns_hexa64.cgns"
ORDERS = DATA / "cgns_orders.cgns"
PENTAHEDRA = DATA / "cgns_pentahedra.cgns"
PYRAMID = DATA / "cgns_pyramid14.cgns"
BOUNDARIES = DATA / "cgns_boundaries.cgns"


def known(file, reader):
    return f"has no reader of {reader}" not in run("info", file).stderr


def means(*groups):
    """Nodes in the middle of these of the first nodes, as Exodus' document has them: "12" is the
    middle of the first two."""
    return lambda corners: [np.mean([corners[int(n, 16) - 1] for n in g], axis=0) for g in groups]


HEXAHEDRON = np.array(CUBE)
SIMPLEX = np.array([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)], dtype=float)
WEDGE = np.array([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (0, 1, 1)], dtype=float)
HEX_EDGES = ["12", "23", "34", "41", "15", "26", "37", "48", "56", "67", "78", "85"]
TET_EDGES = ["12", "23", "31", "14", "24", "34"]
WEDGE_EDGES = ["12", "23", "31", "14", "25", "36", "45", "56", "64"]
# By type: corners in the reference element, and of the other nodes whose middle they are.
ELEMENTS = {
    "HEX20": (HEXAHEDRON, means(*HEX_EDGES)),
    "HEX27": (HEXAHEDRON, means(*HEX_EDGES, "12345678", "1234", "5678", "1584", "2376", "1265", "3487")),
    "TETRA10": (SIMPLEX, means(*TET_EDGES)),
    "TETRA15": (SIMPLEX, means(*TET_EDGES, "123", "234", "134", "124", "1234")),
    "WEDGE15": (WEDGE, means(*WEDGE_EDGES)),
    "WEDGE18": (WEDGE, means(*WEDGE_EDGES, "1254", "2365", "1364")),
    "WEDGE21": (WEDGE, means(*WEDGE_EDGES, "123456", "123", "456", "2365", "1364", "1254")),
}


class Blocks(ToolTest):
    """Both files hold the map and the field below at the nodes of quadratic elements."""

    def check(self, file, height):
        stream = random.Random(4)
        points, values = [], []
        for _ in range(50):
            r, s, t = stream.random(), stream.random(), height * stream.random()
            points.append((r + 0.125 * s * s, s - 0.0625 * t * t, t + 0.125 * r * s))
            values.append(r * r - 2 * s * t + 0.5 * r)
        table = self.folder / "points.csv"
        table.write_text("x,y,z\n" + "".join(",".join(map(repr, p)) + "\n" for p in points))
        out = self.folder / "values.csv"
        self.succeeds("probe", file, "--field", "u", "--points", table, "--output", out)
        found = columns(read_csv(out))
        self.assertEqual(set(found["verdict"]), {"inside"})
        np.testing.assert_allclose(found["value"], values, rtol=0, atol=1e-14)

    def test_exodus(self):
        self.check(EXODUS, 2.0)
        summary = self.summary("info", EXODUS)
        self.assertEqual(summary["shapes"], {"hexahedron": 2, "tetrahedron": 1})
        self.assertEqual(summary["attributes"], {"3": 1, "7": 2})
        self.assertEqual(summary["times"], [0.0])
        self.fails(1, "info", EXODUS, "--time-step", "1", names=["1 time step"])
        for name in ("a.exo", "a.ex2", "a.exii", "a.g"):
            (self.folder / name).write_bytes(EXODUS.read_bytes())
            self.succeeds("info", self.folder / name)

    def test_exodus_side_sets(self):
        """Set 10 + k holds side k of each element: nodes as the format's document has them."""
        box = [(0, 0, 0), (1, 0, 0), (1, 2, 0), (0, 2, 0), (0, 0, 3), (1, 0, 3), (1, 2, 3), (0, 2, 3)]
        simplex = [(0, 0, 0), (1, 0, 0), (0, 2, 0), (0, 0, 3), (1, 0, 3), (0, 2, 3)]
        pyramid = box[:4] + [(0.5, 1, 3)]
        # By where elements begin along x: corners, and of each side three of its nodes.
        elements = {
            0: (box, ["126", "237", "348", "158", "143", "567"]),
            10: (simplex, ["125", "236", "146", "132", "456"]),
            20: (simplex, ["124", "234", "143", "132"]),
            30: (pyramid, ["125", "235", "345", "154", "143"]),
        }
        for k in range(6):
            table = self.folder / "buffers.vti"
            self.succeeds("render", SIDES, f"--boundary={11 + k}", "--view", "iso", "--size", "500x500",
                          "--buffers", table, "--output", self.folder / "a.png")
            buffers = read_buffers(table)
            points = buffers["Position"][buffers["Verdict"] == 1]
            seen = points[:, 0] // 10 * 10
            expected = [begin for begin, (_, sides) in elements.items() if k < len(sides)]
            self.assertEqual(sorted(set(seen)), expected)
            for begin in expected:
                corners, sides = elements[begin]
                a, b, c = (np.array(corners[int(n) - 1]) + (begin, 0, 0) for n in sides[k])
                normal = np.cross(b - a, c - a)
                off = (points[seen == begin] - a) @ (normal / np.linalg.norm(normal))
                self.assertLess(abs(off).max(), 1e-12)
        summary = self.summary("info", SIDES)
        self.assertEqual(summary["boundary_attributes"], {"11": 4, "12": 4, "13": 4, "14": 4, "15": 3, "16": 1})
        self.assertEqual(summary["groups"], [
            {"id": 5, "name": "wedges", "boundary": False},
            {"id": 9, "name": "solid tetrahedra", "boundary": False},
            {"id": 11, "name": "first", "boundary": True},
            {"id": 12, "name": "second", "boundary": True},
            {"id": 16, "name": "sixth", "boundary": True},
        ])
        self.assertIn("1 node set", self.succeeds("info", SIDES).stderr)

    def test_exodus_parts(self):
        """A mesh in parts has the elements and side sets of all; one that is missing is named."""
        for part, source in enumerate((EXODUS, SIDES)):
            (self.folder / f"a.e.2.{part}").write_bytes(source.read_bytes())
        first, second = self.folder / "a.e.2.0", self.folder / "a.e.2.1"
        alone = self.summary("info", SIDES)
        for files in ([first], [second], [second, first]):
            summary = self.summary("info", *files)
            self.assertEqual(summary["elements"], alone["elements"] + 3)
            self.assertEqual(summary["boundary_attributes"], alone["boundary_attributes"])
            self.assertEqual(summary["groups"], alone["groups"])
        seen = []
        for files in ([SIDES], [first]):
            table = self.folder / "buffers.vti"
            self.succeeds("render", *files, "--boundary=16", "--view", "iso", "--size", "200x200",
                          "--buffers", table, "--output", self.folder / "a.png")
            buffers = read_buffers(table)
            seen.append(buffers["Position"][buffers["Verdict"] == 1][:, 2].mean())
        self.assertAlmostEqual(seen[0], seen[1])
        second.unlink()
        self.fails(1, "info", first, names=[second, "2 parts", "beside"])
        second.write_bytes(b"no netCDF")
        self.fails(1, "info", first, names=[second, "Exodus"])
        self.fails(2, "info", first, SIDES, names=[SIDES, "one series"])

    def test_exodus_series(self):
        """Meshes of an adaptive run are time steps; one alone tells that there are more."""
        first, second = self.folder / "a.e", self.folder / "a.e-s002"
        first.write_bytes(EXODUS.read_bytes())
        data = SIDES.read_bytes()
        second.write_bytes(data)
        self.assertIn(str(second), self.succeeds("info", first).stderr)
        self.assertEqual(self.summary("info", first)["elements"], 3)
        self.assertEqual(self.summary("info", second)["elements"], 4)
        for step, elements in enumerate((3, 4)):
            summary = self.summary("info", second, first, "--time-step", step)
            self.assertEqual(summary["elements"], elements)
            self.assertEqual(summary["times"], [0.0, 1.0])
        self.fails(1, "info", first, second, "--time-step", 2, names=["2 time steps"])

    def test_exodus_with_a_node_that_is_not_there(self):
        data = EXODUS.read_bytes()
        nodes = struct.pack(">4i", 1, 2, 3, 4)  # the first hexahedron's
        self.assertEqual(data.count(nodes), 1)
        damaged = self.folder / "damaged.e"
        damaged.write_bytes(data.replace(nodes, struct.pack(">4i", 1, 2, 3, 4000)))
        self.fails(1, "info", damaged, names=[damaged, "damaged"])

    def values(self, file, field, points):
        """Values and verdicts at points."""
        table, out = self.folder / "points.csv", self.folder / "values.csv"
        table.write_text("x,y,z\n" + "".join(",".join(repr(float(x)) for x in p) + "\n" for p in points))
        self.succeeds("probe", file, "--field", field, "--points", table, "--output", out)
        found = columns(read_csv(out))
        return found["value"], found["verdict"]

    def test_exodus_keeps_doubles(self):
        """Coordinates of a place on Earth, in metres, of which single precision keeps decimetres."""
        offset = np.array([448251.123, 5411932.457, 117.3])
        nodes = [list(offset + 10 * np.array(c)) for c in CUBE]
        file = self.folder / "a.e"
        for options in ({}, {"integer": INT64, "version": 5}, {"version": 1}):
            file.write_bytes(exodus(nodes, [(1, "HEX8", [range(8)])], [("u", [p[0] - offset[0] for p in nodes])],
                                    **options))
            stream = random.Random(6)
            points = [offset + 10 * np.array([stream.random() for _ in range(3)]) for _ in range(20)]
            found, verdicts = self.values(file, "u", points)
            self.assertEqual(set(verdicts), {"inside"})
            np.testing.assert_allclose(found, [p[0] - offset[0] for p in points], rtol=0, atol=1e-9)
        self.assertNotIn("448251.125", self.succeeds("info", file).stdout)

    def test_exodus_in_single_precision(self):
        """Coordinates that the file holds in single precision have its rounding as their error: a point that is
        beside the element by less is within the tolerance at faces, which counts as inside."""
        file = self.folder / "a.e"
        file.write_bytes(exodus(CUBE, [(1, "HEX8", [range(8)])], [("u", [p[0] for p in CUBE])], real=FLOAT))
        near = 1 + 1e-9
        self.assertEqual(self.values(file, "u", [(near, 0.5, 0.5), (0.5, 0.5, 0.5)])[1].tolist(),
                         ["inside", "inside"])
        file.write_bytes(exodus(CUBE, [(1, "HEX8", [range(8)])], [("u", [p[0] for p in CUBE])]))
        self.assertEqual(self.values(file, "u", [(near, 0.5, 0.5)])[1].tolist(), ["outside"])

    def test_nodes_of_exodus(self):
        """Every type of order 2, curved, its nodes as the format's document has them."""
        def place(r, begin):
            return (begin + r[0] + 0.125 * r[2] ** 2, r[1] - 0.0625 * r[0] * r[2], r[2] + 0.125 * r[0] * r[1])

        def value(r):
            return r[0] ** 2 - 2 * r[1] * r[2] + 0.5 * r[0] + r[1] ** 2

        stream = random.Random(7)
        nodes, blocks, field, points, expected = [], [], [], [], []
        for number, (kind, (corners, others)) in enumerate(ELEMENTS.items(), 1):
            own = [*corners, *others(corners)]
            self.assertEqual(len(own), int(kind.lstrip("HEXTRAWDG")))
            blocks.append((number, kind, [range(len(nodes), len(nodes) + len(own))]))
            nodes += [place(r, 10 * number) for r in own]
            field += [value(r) for r in own]
            for _ in range(20):
                weights = np.array([stream.expovariate(1) for _ in corners])
                r = weights / weights.sum() @ corners
                points.append(place(r, 10 * number))
                expected.append(value(r))
        file = self.folder / "a.e"
        file.write_bytes(exodus(nodes, blocks, [("u", field)]))
        found, verdicts = self.values(file, "u", points)
        self.assertEqual(set(verdicts), {"inside"})
        np.testing.assert_allclose(found, expected, rtol=0, atol=2e-13)
        self.assertNotIn("warning", self.succeeds("info", "--certify", file).stderr)

    def test_exodus_types_that_no_cell_has(self):
        file = self.folder / "a.e"
        file.write_bytes(exodus([*CUBE, (0.5, 0.5, 0.5)], [(4, "HEX9", [range(9)])]))
        self.fails(1, "info", file, names=[file, "block 4", "HEX9", "9 nodes"])

    def test_fields_of_some_blocks(self):
        """Where a block has no values of a field, there are none."""
        nodes = [[x + 2 * k, y, z] for k in (0, 1) for x, y, z in CUBE]
        blocks = [(1, "HEX8", [range(8)]), (2, "HEX8", [range(8, 16)])]
        file = self.folder / "a.e"
        file.write_bytes(exodus(nodes, blocks, elemental=[("T", {1: [5.0]}), ("both", {1: [1.0], 2: [2.0]}),
                                                          ("none", {})]))
        done = self.succeeds("info", file)
        self.assertIn("'T' has no values in block 2", done.stderr)
        self.assertIn("'none' has values in no block", done.stderr)
        points = [(0.5, 0.5, 0.5), (2.5, 0.5, 0.5)]
        np.testing.assert_array_equal(self.values(file, "T", points)[0], [5, np.nan])
        np.testing.assert_array_equal(self.values(file, "both", points)[0], [1, 2])

    def test_damaged_exodus(self):
        """Whatever is damaged is refused, or the rest is read; nothing ends the program."""
        stream = random.Random(8)
        for source in (SIDES, NETCDF4):
            sound = source.read_bytes()
            for number in range(25):
                data = bytearray(sound)
                for _ in range(3):
                    data[stream.randrange(len(data) if number % 2 else 1000)] = stream.choice((0, 127, 255))
                file = self.folder / "a.e"
                file.write_bytes(data)
                self.assertIn(run("info", file).returncode, (0, 1), number)

    @unittest.skipUnless(known(CGNS, "CGNS"), "VTK has no reader of CGNS")
    def test_cgns_with_any_damage(self):
        stream = random.Random(9)
        for number in range(25):
            data = bytearray((BOUNDARIES if number % 2 else CGNS).read_bytes())
            for _ in range(3):
                data[stream.randrange(len(data))] = stream.choice((0, 127, 255))
            file = self.folder / "a.cgns"
            file.write_bytes(data)
            self.assertIn(run("info", file).returncode, (0, 1), number)

    @unittest.skipUnless(known(CGNS, "CGNS"), "VTK has no reader of CGNS")
    def test_cgns(self):
        self.check(CGNS, 1.0)

    @unittest.skipUnless(known(CGNS, "CGNS"), "VTK has no reader of CGNS")
    def test_cubic_cgns(self):
        stream = random.Random(5)
        points, values = [], []
        for _ in range(50):
            r, s, t = stream.random(), stream.random(), stream.random()
            points.append((r + 0.125 * s**3, s - 0.0625 * t**3, t + 0.125 * r * s))
            values.append(r**3 - 2 * s * t + 0.5 * r)
        table = self.folder / "points.csv"
        table.write_text("x,y,z\n" + "".join(",".join(map(repr, p)) + "\n" for p in points))
        out = self.folder / "values.csv"
        self.succeeds("probe", CUBIC, "--field", "u", "--points", table, "--output", out)
        found = columns(read_csv(out))
        self.assertEqual(set(found["verdict"]), {"inside"})
        np.testing.assert_allclose(found["value"], values, rtol=0, atol=1e-13)

    @unittest.skipUnless(known(CGNS, "CGNS"), "VTK has no reader of CGNS")
    def test_cubic_simplices_of_cgns(self):
        """TETRA_20 and PENTA_40, straight, their nodes as the format's document has them."""
        stream = random.Random(3)
        corners = [
            [(0, 0, 0), (1, 0.1, 0), (0.2, 0.9, 0.1), (0.1, 0.2, 1)],
            [(2, 0, 0), (3, 0.1, 0), (2.2, 0.9, 0.1), (2.1, 0.2, 1), (3.1, 0.3, 1), (2.3, 1.1, 1.1)],
        ]
        points = []
        for cell in corners:
            for _ in range(25):
                weights = np.array([stream.expovariate(1) for _ in range(3 if len(cell) == 6 else 4)])
                weights /= weights.sum()
                if len(cell) == 6:
                    height = stream.random()
                    weights = np.concatenate([weights * (1 - height), weights * height])
                points.append(weights @ np.array(cell))
        table = self.folder / "points.csv"
        table.write_text("x,y,z\n" + "".join(",".join(map(repr, map(float, p))) + "\n" for p in points))
        out = self.folder / "values.csv"
        result = self.succeeds("probe", ORDERS, "--field", "u", "--points", table, "--output", out)
        self.assertNotIn("warning", result.stderr)
        found = columns(read_csv(out))
        self.assertEqual(set(found["verdict"]), {"inside"})
        x, y, z = np.array(points).T
        values = x**3 - 2 * x * y * z + 0.5 * y * y * z - z * z + 0.25 * x
        np.testing.assert_allclose(found["value"], values, rtol=0, atol=5e-14)

    @unittest.skipUnless(known(CGNS, "CGNS"), "VTK has no reader of CGNS")
    def test_quadratic_pentahedra_of_cgns(self):
        """PENTA_15 at x = 0 and PENTA_18 at x = 3, curved, their nodes as the format's document has them."""
        stream = random.Random(6)
        points, values = [], []
        for begin in (0, 3):
            for _ in range(25):
                r, s = sorted((stream.random(), stream.random()))
                s, t = 1 - s, stream.random()
                points.append((begin + r + t * t / 8, s - r * t / 16, t + r * s / 8))
                values.append(r * r - 2 * s * t + r / 2)
        table = self.folder / "points.csv"
        table.write_text("x,y,z\n" + "".join(",".join(map(repr, p)) + "\n" for p in points))
        out = self.folder / "values.csv"
        result = self.succeeds("probe", PENTAHEDRA, "--field", "u", "--points", table, "--output", out)
        self.assertNotIn("warning", result.stderr)
        found = columns(read_csv(out))
        self.assertEqual(set(found["verdict"]), {"inside"})
        np.testing.assert_allclose(found["value"], values, rtol=0, atol=1e-14)

    @unittest.skipUnless(known(CGNS, "CGNS"), "VTK has no reader of CGNS")
    def test_pyramids_of_14_nodes_are_refused_by_name(self):
        """The format defines no functions on them, and VTK's reader takes them for cells of 13 nodes."""
        result = self.fails(1, "info", PYRAMID, names=["PYRA_14", "PYRA_5"])
        self.assertNotIn("damaged", result.stderr)

    @unittest.skipUnless(known(CGNS, "CGNS"), "VTK has no reader of CGNS")
    def test_boundary_conditions_of_cgns(self):
        """Of two boxes with sides as elements, and of a grid of 3 x 2 x 1 cells from x = 10 on."""
        summary = self.summary("info", BOUNDARIES)
        self.assertEqual(summary["boundary_attributes"], {"1": 3, "2": 1, "3": 3, "4": 2, "5": 4, "6": 2})
        self.assertEqual([group["name"] for group in summary["groups"]],
                         ["low", "high", "walls", "floor", "roof", "far"])
        self.assertIn("'nowhere'", self.succeeds("info", BOUNDARIES).stderr)
        where = {
            1: lambda x, y, z: (x == 0) | (x == 10),
            2: lambda x, y, z: x == 2,
            3: lambda x, y, z: (y == 0) | ((z == 1) & (x <= 1)),
            4: lambda x, y, z: (z == 0) & (x <= 2),
            5: lambda x, y, z: (z == 1) & (x >= 11),
            6: lambda x, y, z: x == 13,
        }
        for attribute, holds in where.items():
            table = self.folder / "buffers.vti"
            self.succeeds("render", BOUNDARIES, f"--boundary={attribute}", "--view", "iso", "--size", "300x300",
                          "--buffers", table, "--output", self.folder / "a.png")
            buffers = read_buffers(table)
            seen = np.round(buffers["Position"][buffers["Verdict"] == 1], 9)
            self.assertGreater(len(seen), 20)
            self.assertTrue(holds(*seen.T).all(), attribute)

    @unittest.skipUnless(known(CGNS, "CGNS"), "VTK has no reader of CGNS")
    def test_damaged_cgns(self):
        """Its library ends the program where VTK's reader meets what it cannot read."""
        damaged = self.folder / "damaged.cgns"
        for file in (CGNS, BOUNDARIES):
            data = file.read_bytes()
            for count in (600, len(data) // 5, len(data) // 2, len(data) - 3000):
                damaged.write_bytes(data[:count])
                self.fails(1, "info", damaged, names=[damaged, "damaged"])

    def test_others_are_refused_by_name(self):
        for suffix, name in ((".e", "Exodus"), (".cgns", "CGNS")):
            wrong = self.folder / ("wrong" + suffix)
            wrong.write_text("a file of another kind\n")
            self.fails(1, "info", wrong, names=[wrong, name])
            wrong.write_text("version https://git-lfs.github.com/spec/v1\noid sha256:1\nsize 7\n")
            self.fails(1, "info", wrong, names=[wrong, "git lfs pull"])
        self.fails(2, "info", EXODUS, EXODUS, names=["once"])


if __name__ == "__main__":
    unittest.main()
