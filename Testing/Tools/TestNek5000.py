# SPDX-License-Identifier: BSD-3-Clause
"""Fields of Nek5000, nekRS and neko on the command line, against closed forms."""

import unittest

import numpy as np

from nek5000 import bent, grid, list_bytes, step_bytes
from tool import DATA, ToolTest, columns, read_csv, run

BENT = DATA / "nek5000_bent"

# The values of all fields: polynomials of x, y, z that are of order 5 on a bent grid.
FIELDS = {
    "velocity": lambda x, y, z: np.array([y * y, x, z - 2 * x]),
    "pressure": lambda x, y, z: x * x * y - z,
    "temperature": lambda x, y, z: 1 + x * y + z,
    "s1": lambda x, y, z: z * y - x,
    "s2": lambda x, y, z: 4 * y + 0 * x,
}
LETTERS = ["U", "P", "T", "S", "S"]
ALL = list(zip(LETTERS, FIELDS.values()))
PLANE = {
    "velocity": lambda x, y: np.array([y * y, x - y]),
    "pressure": lambda x, y: x * y + y,
    "temperature": lambda x, y: 3 * x + 0 * y,
    "s1": lambda x, y: x * x,
}


def places(dimension, count=60):
    """Points inside of a bent grid."""
    return bent(np.random.default_rng(5).uniform(0.01, 0.99, (dimension, count)))


class Nek5000(ToolTest):
    def write(self, name, data):
        path = self.folder / name
        path.parent.mkdir(exist_ok=True)
        path.write_bytes(data)
        return path

    def check(self, files, fields, dimension, tolerance, *options):
        """Probes all fields of the files at points."""
        points = places(dimension)
        table = self.folder / "points.csv"
        rows = "\n".join(",".join(repr(float(x)) for x in point) for point in points.T)
        table.write_text(",".join("xyz"[:dimension]) + "\n" + rows + "\n")
        for name, function in fields.items():
            out = self.folder / "out.csv"
            self.succeeds("probe", *files, "--field", name, "--points", table, "--output", out, *options)
            found = columns(read_csv(out))
            self.assertEqual(set(found["verdict"]), {"inside"}, name)
            expected = np.atleast_2d(function(*points))
            for k, row in enumerate(expected):
                column = found["value" if len(expected) == 1 else f"value_{k}"]
                np.testing.assert_allclose(column, row, rtol=0, atol=tolerance, err_msg=name)

    def test_all_fields_in_both_precisions_and_byte_orders(self):
        nodes = grid((2, 2, 1), 6)
        for word, order, tolerance in [(8, "<", 1e-13), (8, ">", 1e-13), (4, "<", 4e-6), (4, ">", 4e-6)]:
            with self.subTest(word=word, order=order):
                data = step_bytes(nodes, 6, ALL, word=word, order=order, ranges=order == ">")
                self.check([self.write("x0.f00012", data)], FIELDS, 3, tolerance)

    def test_single_precision_keeps_the_stored_digits(self):
        """At a node the value is the stored one."""
        nodes = grid((1, 1, 1), 3, place=lambda points: points)
        third = [("P", lambda x, y, z: x / 3)]
        file = self.write("x0.f00000", step_bytes(nodes, 3, third, word=4))
        points, out = self.write("points.csv", b"x,y,z\n1,1,1\n"), self.folder / "out.csv"
        self.succeeds("probe", file, "--field", "pressure", "--points", points, "--output", out)
        self.assertAlmostEqual(columns(read_csv(out))["value"][0], float(np.float32(1 / 3)), delta=1e-15)

    def test_plane(self):
        nodes = grid((3, 2), 5)
        fields = list(zip(LETTERS, PLANE.values()))
        file = self.write("x0.f00000", step_bytes(nodes, 5, fields))
        self.check([file], PLANE, 2, 1e-13)
        summary = self.summary("info", file)
        self.assertEqual(summary["elements"], 6)
        self.assertEqual([field["name"] for field in summary["fields"]], list(PLANE))
        self.assertIn("2-D", self.succeeds("info", file).stdout)

    def test_steps_of_which_one_has_the_mesh(self):
        """The elements of the second step stand in another order."""
        nodes = grid((2, 1, 1), 6)
        for step in range(3):
            order = [1, 0] if step == 1 else [0, 1]
            fields = [("P", lambda x, y, z, scale=step + 1: scale * (x * y - z))]
            data = step_bytes([nodes[e] for e in order], 6, fields, mesh=step == 0, time=0.5 * step,
                              numbers=[e + 1 for e in order])
            self.write(f"x0.f{step + 4:05d}", data)
        series = self.write("x.nek5000", list_bytes("x%01d.f%05d", 4, 3))
        files = sorted(self.folder.glob("x0.f*"))
        for given in [[series], files]:
            for step in range(3):
                fields = {"pressure": lambda x, y, z, scale=step + 1: scale * (x * y - z)}
                self.check(given, fields, 3, 1e-13, "--time-step", step)
        self.assertIn("step 1 of 3", self.succeeds("info", series, "--time", 0.5).stdout)
        self.fails(1, "info", files[1], names=[files[1], "mesh"])
        self.fails(1, "info", series, files[0], names=["leave out"])
        files[2].unlink()
        self.fails(1, "info", series, names=[f"{files[2]} is missing", "numtimesteps"])

    def test_parts_in_folders(self):
        nodes = grid((2, 2, 1), 6)
        for part in range(2):
            data = step_bytes(nodes[2 * part:2 * part + 2], 6, ALL, numbers=[2 * part + 1, 2 * part + 2], total=4,
                              part=part, parts=2, word=8, order="<>"[part])
            self.write(f"A{part:02d}/x{part:02d}.f00001", data)
        series = self.write("x.nek5000", list_bytes("A%02d/x%02d.f%05d", 1, 1))
        self.check([series], FIELDS, 3, 1e-13)
        last = self.folder / "A01" / "x01.f00001"
        self.check([last], {"s1": FIELDS["s1"]}, 3, 1e-13)
        last.unlink()
        self.fails(1, "info", series, names=[f"{last} is missing", "2 parts"])

    def test_info(self):
        summary = self.summary("info", BENT / "bent.nek5000")
        self.assertEqual(summary["shapes"], {"hexahedron": 2})
        self.assertEqual([field["name"] for field in summary["fields"]], ["velocity", "pressure"])
        self.assertEqual({field["continuity"] for field in summary["fields"]}, {"continuous"})
        self.assertEqual({field["basis"] for field in summary["fields"]},
                         {"Nek5000, Gauss-Lobatto-Legendre nodes"})
        self.assertFalse(summary["converted"])

    def test_picture(self):
        picture = self.folder / "bent.png"
        self.succeeds("render", BENT / "bent1.f00000", "--field", "velocity", "--plane", "0,0.5,0,0,1,0", "--size",
                      "100x100", "--output", picture)
        self.assertGreater(picture.stat().st_size, 500)

    def test_notes(self):
        nodes = grid((2, 1, 1), 3)
        fields = [("P", lambda x, y, z: np.where(x > 0.9, np.nan, x)), ("T", lambda x, y, z: y)]
        file = self.write("x0.f00000", step_bytes(nodes, 3, fields))
        done = self.succeeds("info", file)
        self.assertIn("'pressure' is NaN or infinite at nodes of 1 of 2 elements", done.stderr)
        file = self.write("x0.f00000", step_bytes(nodes, 3, fields, tail="  1.0000000E+00 T"))
        done = self.succeeds("info", file)
        self.assertIn("the pressure has values at other nodes", done.stderr)
        self.assertNotIn("pressure", done.stdout)
        series = self.write("x.nek5000", list_bytes("x%d.f%05d", 0, 1) + b"colour: red\n")
        self.assertIn("line 4: 'colour' is not known here", self.succeeds("info", series).stderr)

    def test_refusals(self):
        nodes = grid((1, 1, 1), 3)
        whole = step_bytes(nodes, 3, ALL)
        old = b"    8    6    6    6  0.50000E+00   100 X U P T".ljust(200)
        for data, words in [
            (whole[:-1], ["cut short"]),
            (whole + b"1234", ["damaged"]),
            (whole[:132] + b"1234" + whole[136:], ["6.54321"]),
            (old, [".fld", "before 2008", "param(66)"]),
            (step_bytes(nodes, 3, ALL, codes="XUPTQ02"), ["'Q' is not known"]),
            (step_bytes(nodes, 3, ALL, numbers=[2]), ["number 2", "missing"]),
            (whole.replace(b" 3  3  3 ", b"40  3  3 "), ["40 nodes", "at most 33"]),
        ]:
            file = self.write("x0.f00000", data)
            self.fails(1, "info", file, names=[file, *words])
        done = run("info", self.write("y0.f00000", b"x"))
        self.assertIn("does not begin with '#std'", done.stderr)


if __name__ == "__main__":
    unittest.main()
