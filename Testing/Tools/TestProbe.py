# SPDX-License-Identifier: BSD-3-Clause
"""pixelexact probe: values, gradients and verdicts at the points of a table."""

import unittest

import numpy as np

from tool import (
    CASES,
    CUBE,
    DATA,
    ToolTest,
    case,
    columns,
    oracle,
    plain_grid,
    read_csv,
    unit_cube_grid,
)


class ProbeTest(ToolTest):
    def write(self, name, text):
        path = self.folder / name
        path.write_bytes(text.encode("utf-8"))
        return path

    def probe(self, source, points, *options, field="u"):
        """The output's rows."""
        out = self.folder / "out.csv"
        if not hasattr(points, "exists"):
            points = self.write("points.csv", points)
        table = ["--points", points, "--output", out]
        self.succeeds("probe", source, "--field", field, *table, *options)
        return read_csv(out)


class Names(ProbeTest):
    def test_tables_under_the_name_of_another_format(self):
        table = ["probe", case("toroid_hex_g3_p6"), "--field", "u", "--line", "0,1,0,1,0,0,2"]
        for name in ("out.npy", "out.VTP", "out.tsv"):
            out = self.folder / name
            self.fails(2, *table, "--output", out, names=["--output", out, ".csv"])
            self.assertFalse(out.exists())
        for name in ("out.csv", "out.txt", "out"):
            self.succeeds(*table, "--output", self.folder / name)
            self.assertEqual(len(read_csv(self.folder / name)), 2)


class AgainstOracles(ProbeTest):
    def test_values_gradients_and_elements(self):
        for name in CASES:
            with self.subTest(name=name):
                truth = oracle(name)
                found = columns(
                    self.probe(case(name), DATA / f"{name}.oracle.csv", "--gradient")
                )
                scale = np.ptp(truth["u"])
                self.assertTrue((found["verdict"] == "inside").all())
                self.assertLess(np.abs(found["value"] - truth["u"]).max(), 1e-11 * scale)
                self.assertTrue((found["element"] == truth["element"]).all())
                for d in "xyz":
                    self.assertTrue((found[d] == truth[d]).all())
                    if f"dud{d}" in truth:
                        slope = np.abs(truth[f"dud{d}"]).max()
                        error = np.abs(found[f"value_{d}"] - truth[f"dud{d}"]).max()
                        self.assertLess(error, 1e-9 * slope)

    def test_summary(self):
        name = "toroid_hex_g3_p6"
        summary = self.summary(
            "probe", case(name), "--field", "u", "--points", DATA / f"{name}.oracle.csv",
            "--output", self.folder / "out.csv",
        )
        self.assertEqual(summary["points"], 200)
        self.assertEqual(summary["inside"], 200)
        self.assertEqual(summary["outside"] + summary["unknown"] + summary["non_finite"], 0)

    def test_any_number_of_threads_gives_the_same_bytes(self):
        outputs = []
        for threads in [1, 2]:
            self.probe(
                case("escher_tet_g3_p3"), DATA / "escher_tet_g3_p3.oracle.csv", "--threads", threads
            )
            outputs.append((self.folder / "out.csv").read_bytes())
        self.assertEqual(*outputs)

    def test_outside(self):
        rows = self.probe(
            case("toroid_hex_g3_p6"), "x,y,z\n0,0,0\n1,0,0\n9,9,9\nnan,0,0\ninf,0,0\n", "--gradient"
        )
        self.assertEqual(
            [row["verdict"] for row in rows], ["outside", "inside"] + 3 * ["outside"]
        )
        for row in rows[:1] + rows[2:]:
            for name in ["value", "value_x", "value_y", "value_z", "xi_0", "xi_1", "xi_2"]:
                self.assertEqual(row[name], "nan")
            self.assertEqual(row["element"], "-1")


class Format(ProbeTest):
    def setUp(self):
        super().setUp()
        self.cube = self.write("cube.vtu", unit_cube_grid())

    def test_columns(self):
        rows = self.probe(self.cube, "x,y,z\n.5,.25,.75\n")
        self.assertEqual(
            list(rows[0]), ["x", "y", "z", "value", "element", "xi_0", "xi_1", "xi_2", "verdict"]
        )
        rows = self.probe(self.cube, "x,y,z\n.5,.25,.75\n", "--gradient")
        self.assertEqual(list(rows[0])[3:7], ["value", "value_x", "value_y", "value_z"])

    def test_vectors(self):
        vectors = [[x, 2 * y, 3 * z + x] for x, y, z in CUBE]
        cube = self.write("vector.vtu", unit_cube_grid([("v", vectors)]))
        row = self.probe(cube, "x,y,z\n.5,.25,.75\n", "--gradient", field="v")[0]
        values = [f"value_{c}" for c in range(3)]
        slopes = [f"value_{c}_{d}" for c in range(3) for d in "xyz"]
        self.assertEqual([name for name in row if name.startswith("value")], values + slopes)
        expected = [0.5, 0.5, 2.75, 1, 0, 0, 0, 2, 0, 1, 0, 3]
        for name, value in zip(values + slopes, expected):
            self.assertAlmostEqual(float(row[name]), value, delta=1e-14)

    def test_17_digits_and_the_order_of_rows(self):
        points = np.random.default_rng(3).random((50, 3))
        text = "x,y,z\n" + "".join(",".join(repr(float(v)) for v in p) + "\n" for p in points)
        found = columns(self.probe(self.cube, text))
        for d, name in enumerate("xyz"):
            self.assertTrue((found[name] == points[:, d]).all())

    def test_other_columns_quotes_and_line_ends(self):
        plain = self.probe(self.cube, "x,y,z\n0.5,0.25,0.75\n0.25,0.5,0.125\n")
        for text in [
            "x,y,z\r\n0.5,0.25,0.75\r\n0.25,0.5,0.125\r\n",
            "\ufeffx,y,z\n0.5,0.25,0.75\n0.25,0.5,0.125",
            '"x","y","z"\n"0.5","0.25","0.75"\n0.25,"0.5",0.125\n',
            'name,z,y,x\n"a, ""b""",0.75,0.25,0.5\nb,0.125,0.5,0.25\n',
            " x , y , z \n 0.5 , +0.25 ,0.75\n\n2.5e-1,5E-1,.125\n\n",
            "x;y;z\n0.5;0.25;0.75\n0.25;0.5;0.125\n",
            '"x";"name";"y";"z"\n0.5;"a; ""b"", c";0.25;0.75\n0.25;b;0.5;0.125\n',
            "x\ty\tz\tname\n0.5\t0.25\t0.75\t\n0.25\t0.5\t0.125\ta, b\n",
            '"u","Points:0","Points:1","Points:2"\n9,0.5,0.25,0.75\n9,0.25,0.5,0.125\n',
            "Point ID,Points_0,Points_1,Points_2,Points_Magnitude\n0,0.5,0.25,0.75,1\n1,0.25,0.5,0.125,1\n",
            # A field of theirs may be called x and y; all three go before ParaView's.
            "x,y,Points:0,Points:1,Points:2\n9,9,0.5,0.25,0.75\n9,9,0.25,0.5,0.125\n",
            "Points:0,Points:1,Points:2,x,y,z\n9,9,9,0.5,0.25,0.75\n9,9,9,0.25,0.5,0.125\n",
        ]:
            with self.subTest(text):
                self.assertEqual(self.probe(self.cube, text), plain)

    def test_tables_of_vtk(self):
        try:
            from vtkmodules.vtkIOCore import vtkDelimitedTextWriter
        except ImportError:
            self.skipTest("there are no VTK modules for Python")
        from vtkmodules.vtkCommonDataModel import vtkTable
        from vtkmodules.util.numpy_support import numpy_to_vtk

        points = np.random.default_rng(4).random((20, 3))
        lines = "".join(",".join(repr(float(v)) for v in p) + "\n" for p in points)
        plain = self.probe(self.cube, "x,y,z\n" + lines)
        table = vtkTable()
        for name, numbers in (("u", points[:, 0] + 5), ("Points", points)):
            array = numpy_to_vtk(numbers, deep=True)
            array.SetName(name)
            table.AddColumn(array)
        for separator in (",", ";", "\t"):
            writer = vtkDelimitedTextWriter()
            writer.SetInputData(table)
            writer.SetFieldDelimiter(separator)
            writer.SetFileName(str(self.folder / "vtk.csv"))
            writer.Write()
            self.assertIn('"Points:0"', (self.folder / "vtk.csv").read_text(encoding="utf-8"))
            found = self.probe(self.cube, self.folder / "vtk.csv")
            for d in "xyz":
                # The writer has fewer digits than doubles.
                np.testing.assert_allclose(columns(found)[d], columns(plain)[d], atol=1e-5)

    def test_no_points(self):
        self.assertEqual(self.probe(self.cube, "x,y,z\n"), [])
        self.assertTrue((self.folder / "out.csv").read_text().startswith("x,y,z,value"))


class Errors(ProbeTest):
    def refuses(self, points, *names, field="u", output=None):
        path = self.write("points.csv", points)
        self.fails(
            1, "probe", case("escher_tet_g3_p3"), "--field", field, "--points", path,
            "--output", output or self.folder / "out.csv", names=names,
        )

    def test_tables(self):
        self.refuses("x,y,z\n1,2,3\n1,two,3\n", "points.csv", "line 3", "two")
        self.refuses("x,y,z\n1,2,3\n\n1,,3\n", "line 4")
        self.refuses("x,y,z\n1,2,3\n1,2\n", "line 3", "no z")
        self.refuses("x,y,z\n1,2,0x3\n", "line 2")
        self.refuses("x,y,z\n1,2,3 4\n", "line 2")
        self.refuses("x,y,z\n1,5,2,3\n", "line 2", "4 values under 3 columns")
        self.refuses('x,y,z\n1,2,"3\n', "line 2", "quote")
        self.refuses("x,y\n1,2\n", "line 1", "'z'")
        self.refuses("x,y,z,x\n1,2,3,4\n", "line 1", "'x' twice")
        self.refuses("1,2,3\n", "'x'", "Points:0", "semicolons")
        self.refuses("x;y;z\n0,5;1;2\n", "line 2", "'0,5'", "point")
        self.refuses("x;y;z\n1,2,3\n", "line 2")
        self.refuses("x\ty\tz\n\t\t\n", "line 2")
        self.refuses("x,y;z\n1,2;3\n", "line 1", "'y'")
        self.refuses("Points:0,Points:1\n1,2\n", "line 1")
        self.refuses("Points:0,Points:1,Points:2,Points:0\n1,2,3,4\n", "'Points:0' twice")
        self.refuses("", "header")

    def test_files(self):
        table = ["--points", self.folder / "none.csv", "--output", self.folder / "out.csv"]
        source = case("escher_tet_g3_p3")
        self.fails(1, "probe", source, "--field", "u", *table, names=["none.csv"])
        self.refuses("x,y,z\n", "absent", output=self.folder / "absent" / "out.csv")

    def test_field(self):
        self.refuses("x,y,z\n", "'w'", "'u'", field="w")


class SavedGrids(ProbeTest):
    """A file that carries coefficients is used as it is."""

    def saved(self, change=None):
        try:
            from pixelexact import vtkUnstructuredGridToHighOrderGrid
        except ImportError:
            self.skipTest("built without Python")
        from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader, vtkXMLUnstructuredGridWriter

        reader = vtkXMLUnstructuredGridReader()
        reader.SetFileName(str(case("toroid_hex_g3_p6")))
        converter = vtkUnstructuredGridToHighOrderGrid()
        converter.SetInputConnection(reader.GetOutputPort())
        converter.Update()
        grid = converter.GetOutput()
        if change:
            change(grid)
        writer = vtkXMLUnstructuredGridWriter()
        writer.SetFileName(str(self.folder / "saved.vtu"))
        writer.SetInputData(grid)
        writer.SetDataModeToBinary()
        writer.Write()
        return self.folder / "saved.vtu"

    def test_same_values(self):
        saved = self.saved()
        points = DATA / "toroid_hex_g3_p6.oracle.csv"
        self.assertEqual(
            self.probe(saved, points), self.probe(case("toroid_hex_g3_p6"), points)
        )
        self.assertFalse(self.summary("info", saved)["converted"])

    def test_moved_points_are_noticed(self):
        def move(grid):
            grid.GetPoints().SetPoint(0, 5.0, 5.0, 5.0)
            grid.GetPoints().Modified()

        self.fails(1, "info", self.saved(move), names=["saved.vtu"])


class NonFinite(ProbeTest):
    def test_a_value_that_is_no_number(self):
        points = [*np.eye(4, 3), [1.0, 1.0, 1.0]]
        cells = [(10, [0, 1, 2, 3]), (10, [0, 1, 2, 4])]
        text = plain_grid(points, cells, [("u", [0.0, 1.0, 2.0, 3.0, float("nan")])])
        source = self.write("nan.vtu", text)
        rows = self.probe(source, "x,y,z\n.4,.3,.1\n.7,.7,.5\n")
        verdicts = [(row["verdict"], row["value"]) for row in rows]
        self.assertEqual([v for v, _ in verdicts], ["inside", "inside"])
        self.assertNotEqual(verdicts[0][1], "nan")
        self.assertEqual(verdicts[1][1], "nan")
        summary = self.summary("info", source)
        self.assertEqual(summary["fields"][0]["non_finite_elements"], 1)


if __name__ == "__main__":
    unittest.main()
