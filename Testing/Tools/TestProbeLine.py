# SPDX-License-Identifier: BSD-3-Clause
"""pixelexact probe along lines, and of several fields at once."""

import csv
import io
import unittest

import numpy as np

from tool import CUBE, ToolTest, columns, run, unit_cube_grid

LINE = ["--line", "0.1,0.2,0.3,0.5,0.8,1.5,7"]


class ProbeLine(ToolTest):
    def setUp(self):
        super().setUp()
        self.cube = self.folder / "cube.vtu"
        fields = [
            ("u", [p[0] for p in CUBE]),
            ("v", [[p[1], 2.0 * p[2], 3.0] for p in CUBE]),
            ("a,&quot;b&quot;", [p[2] for p in CUBE]),
        ]
        self.cube.write_text(unit_cube_grid(fields), encoding="utf-8")

    def rows(self, *arguments):
        """On standard output, where nothing else is named."""
        done = self.succeeds("probe", self.cube, *arguments)
        return columns(list(csv.DictReader(io.StringIO(done.stdout))))

    def test_line(self):
        rows = self.rows("--field", "u", *LINE)
        x = np.array([rows["x"], rows["y"], rows["z"]]).T
        expected = np.linspace([0.1, 0.2, 0.3], [0.5, 0.8, 1.5], 7)
        np.testing.assert_allclose(x, expected, rtol=0, atol=1e-15)
        distance = np.linalg.norm(expected - expected[0], axis=1)
        np.testing.assert_allclose(rows["distance"], distance, rtol=0, atol=1e-15)
        inside = expected[:, 2] <= 1.0
        np.testing.assert_allclose(
            rows["value"], np.where(inside, expected[:, 0], np.nan), rtol=0, atol=1e-15)
        self.assertEqual(list(rows["verdict"]), ["inside" if i else "outside" for i in inside])

    def test_a_table_has_no_distance(self):
        points = self.folder / "points.csv"
        points.write_text("x,y,z\n0.5,0.5,0.5\n", encoding="utf-8")
        self.assertNotIn("distance", self.rows("--field", "u", "--points", points))

    def test_fields(self):
        rows = self.rows("--field", "v", "--field", "u", "--field", 'a,"b"', "--gradient", *LINE)
        inside = rows["z"] <= 1.0
        for name, values in {"v_0": rows["y"], "v_1": 2.0 * rows["z"], "v_2": 3.0 + 0.0 * rows["x"],
                             "u": rows["x"], 'a,"b"': rows["z"], "v_1_z": 2.0 + 0.0 * rows["x"],
                             "u_x": 1.0 + 0.0 * rows["x"]}.items():
            np.testing.assert_allclose(
                rows[name], np.where(inside, values, np.nan), rtol=0, atol=1e-14)
        one = self.rows("--field", "u", *LINE)
        np.testing.assert_array_equal(rows["u"], one["value"])

    def test_summary(self):
        output = ["--output", self.folder / "out.csv"]
        found = self.summary(
            "probe", self.cube, "--field", "u", "--field", "v", "--enclosures", *LINE, *output)
        self.assertEqual([f["field"] for f in found["fields"]], ["u", "v"])
        self.assertEqual([f["components"] for f in found["fields"]], [1, 3])
        self.assertEqual((found["field"], found["points"]), ("u", 7))
        self.assertLess(found["fields"][1]["enclosures"]["largest_width"], 1e-12)
        self.assertNotIn("fields", self.summary("probe", self.cube, "--field", "u", *LINE, *output))

    def test_several_solutions(self):
        """The same line through solutions whose fields are named after their files, and whose names are
        those of their folders."""
        paths = [self.cube]
        for k, name in enumerate(("p", "q"), 2):
            path = self.folder / name / "cube.vtu"
            path.parent.mkdir()
            path.write_text(unit_cube_grid([(name, [k * p[0] for p in CUBE])]), encoding="utf-8")
            paths.append(path)
        others = ["--with", paths[1], "--with", paths[2]]
        plot = self.folder / "plot.svg"
        rows = self.rows("--field", "u", *LINE, *others, "--plot", plot)
        names = [f"{self.folder.name}/cube.vtu", "p/cube.vtu", "q/cube.vtu"]
        self.assertEqual(list(rows["solution"]), [name for name in names for _ in range(7)])
        one = self.rows("--field", "u", *LINE)["value"]
        np.testing.assert_allclose(rows["value"], np.concatenate([one, 2 * one, 3 * one]), rtol=1e-15, atol=0)
        self.assertIn("<svg", plot.read_text(encoding="utf-8"))
        found = self.summary("probe", self.cube, "--field", "u", *LINE, *others, "--output", self.folder / "o.csv")
        self.assertEqual([one["solution"] for one in found["solutions"]], names)
        twice = self.rows("--field", "u", *LINE, "--with", self.cube)["solution"]
        self.assertEqual([name[-4:] for name in twice[[0, -1]]], [" (1)", " (2)"])
        # Files after one --with are time steps of one solution, which its name states.
        for step in (0, 1):
            series = self.folder / f"r_{step}.vtu"
            series.write_text(unit_cube_grid([("u", [(step + 4) * p[0] for p in CUBE])]), encoding="utf-8")
        rows = self.rows("--field", "u", *LINE, "--with", self.folder / "r_0.vtu", self.folder / "r_1.vtu")
        self.assertEqual(rows["solution"][-1], "r_0.vtu to r_1.vtu, step 0")
        np.testing.assert_allclose(rows["value"][7:], 4 * one, rtol=1e-15, atol=0)
        base = ["probe", self.cube, *LINE, "--with", paths[1], "--field"]
        self.fails(1, *base, "v", names=["--with 'p/cube.vtu'", "components"])
        done = run(*base, "2*u")
        self.assertEqual(done.returncode, 1)
        self.assertIn("'p/cube.vtu': nothing is named 'u'", done.stderr)
        self.fails(1, "probe", self.cube, "--field", "u", *LINE, "--with", self.folder / "no.vtu", names=["no.vtu"])

    def test_refused(self):
        base = ["probe", self.cube, "--field", "u"]
        for text in ["1,2,3,4,5,6", "0,0,0,1,1,1,1", "0,0,0,1,1,1,2.5", "0,0,0,1,1,nan,5",
                     "0,0,0,1,1,1,-5"]:
            self.fails(2, *base, "--line", text, names=["--line", "x0,y0,z0,x1,y1,z1,n"])
        self.fails(2, *base, names=["--points", "--line"])
        self.fails(2, *base, *LINE, "--points", "p.csv", names=["--points"])
        self.fails(2, *base, "--field", "u", *LINE, names=["twice"])
        self.fails(1, *base, "--field", "w", *LINE, names=["no field 'w'"])
        self.assertIn("--json", run(*base, *LINE, "--json").stderr)


if __name__ == "__main__":
    unittest.main()
