# SPDX-License-Identifier: BSD-3-Clause
"""Formats of several blocks, read by VTK's own readers."""

import random
import struct
import unittest

import numpy as np

from tool import DATA, ToolTest, columns, read_buffers, read_csv, run

EXODUS = DATA / "exodus_quadratic.e"
SIDES = DATA / "exodus_sides.e"
CGNS = DATA / "cgns_hexa27.cgns"
CUBIC = DATA / "cgns_hexa64.cgns"
ORDERS = DATA / "cgns_orders.cgns"
BOUNDARIES = DATA / "cgns_boundaries.cgns"


def known(file, reader):
    return f"has no reader of {reader}" not in run("info", file).stderr


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

    @unittest.skipUnless(known(EXODUS, "Exodus"), "VTK has no reader of Exodus II")
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

    @unittest.skipUnless(known(EXODUS, "Exodus"), "VTK has no reader of Exodus II")
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

    @unittest.skipUnless(known(EXODUS, "Exodus"), "VTK has no reader of Exodus II")
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

    @unittest.skipUnless(known(EXODUS, "Exodus"), "VTK has no reader of Exodus II")
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

    @unittest.skipUnless(known(EXODUS, "Exodus"), "VTK has no reader of Exodus II")
    def test_exodus_with_a_node_that_is_not_there(self):
        data = EXODUS.read_bytes()
        nodes = struct.pack(">4i", 1, 2, 3, 4)  # the first hexahedron's
        self.assertEqual(data.count(nodes), 1)
        damaged = self.folder / "damaged.e"
        damaged.write_bytes(data.replace(nodes, struct.pack(">4i", 1, 2, 3, 4000)))
        self.fails(1, "info", damaged, names=[damaged, "damaged"])

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
