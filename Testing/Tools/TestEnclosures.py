# SPDX-License-Identifier: BSD-3-Clause
"""pixelexact probe --enclosures: intervals against the values that the solvers computed."""

import unittest
from fractions import Fraction

import numpy as np

from tool import CASES, CUBE, DATA, ToolTest, case, columns, oracle, read_csv, unit_cube_grid


class EnclosureTest(ToolTest):
    def probe(self, source, points, *options, field="u"):
        out = self.folder / "out.csv"
        table = ["--points", points, "--output", out, "--enclosures"]
        self.succeeds("probe", source, "--field", field, *table, *options)
        return columns(read_csv(out))

    def points(self, text):
        path = self.folder / "points.csv"
        path.write_text(text, encoding="utf-8")
        return path


class AgainstOracles(EnclosureTest):
    def test_hold_the_solvers_values(self):
        for name in CASES:
            with self.subTest(name=name):
                truth = oracle(name)
                found = self.probe(case(name), DATA / f"{name}.oracle.csv")
                scale = np.abs(truth["u"]).max()
                self.assertTrue((found["value_lower"] <= truth["u"]).all())
                self.assertTrue((found["value_upper"] >= truth["u"]).all())
                self.assertTrue((found["value_lower"] <= found["value"]).all())
                self.assertTrue((found["value_upper"] >= found["value"]).all())
                width = found["value_upper"] - found["value_lower"]
                self.assertLess(width.max(), 1e-11 * scale)

    def test_summary(self):
        name = "toroid_prism_g3_p4"
        summary = self.summary(
            "probe", case(name), "--field", "u", "--points", DATA / f"{name}.oracle.csv",
            "--output", self.folder / "out.csv", "--enclosures",
        )["enclosures"]
        self.assertEqual(summary["unbounded"], 0)
        self.assertLess(0, summary["median_width"])
        self.assertLessEqual(summary["median_width"], summary["largest_width"])
        self.assertLess(summary["largest_width"], 1e-11)

    def test_any_number_of_threads_gives_the_same_bytes(self):
        outputs = []
        for threads in [1, 2]:
            self.probe(
                case("escher_tet_g3_p3"), DATA / "escher_tet_g3_p3.oracle.csv", "--threads", threads
            )
            outputs.append((self.folder / "out.csv").read_bytes())
        self.assertEqual(*outputs)


class Table(EnclosureTest):
    def setUp(self):
        super().setUp()
        self.cube = self.folder / "cube.vtu"
        vectors = [[x, 2 * y, 3 * z + x] for x, y, z in CUBE]
        self.cube.write_text(unit_cube_grid([("v", vectors)]), encoding="utf-8")

    def test_columns_of_vectors(self):
        points = self.points("x,y,z\n.5,.25,.75\n9,9,9\n")
        found = self.probe(self.cube, points, "--gradient", field="v")
        names = [f"value_{c}_{end}" for c in range(3) for end in ("lower", "upper")]
        self.assertEqual([n for n in found if n.endswith(("lower", "upper"))], names)
        self.assertTrue(all(np.isnan(found[name][1]) for name in names))

    def test_an_affine_field_is_held_exactly(self):
        rows = np.random.default_rng(5).random((200, 3))
        text = "x,y,z\n" + "".join(",".join(repr(float(v)) for v in p) + "\n" for p in rows)
        found = self.probe(self.cube, self.points(text), field="v")
        for i, (x, y, z) in enumerate(rows):
            x, y, z = Fraction(x), Fraction(y), Fraction(z)
            for c, value in enumerate([x, 2 * y, 3 * z + x]):
                self.assertLessEqual(Fraction(found[f"value_{c}_lower"][i]), value)
                self.assertGreaterEqual(Fraction(found[f"value_{c}_upper"][i]), value)

    def test_nothing_is_added_unasked(self):
        out = self.folder / "out.csv"
        points = self.points("x,y,z\n.5,.25,.75\n")
        self.succeeds("probe", self.cube, "--field", "v", "--points", points, "--output", out)
        self.assertFalse([name for name in read_csv(out)[0] if "lower" in name or "upper" in name])


class Owners(EnclosureTest):
    def test_counts(self):
        inside = DATA / "toroid_hex_g3_p6.oracle.csv"
        found = self.probe(case("toroid_hex_g3_p6"), inside, "--owners")
        self.assertEqual(list(found)[-3:], ["verdict", "owners", "coverage"])
        self.assertTrue((found["coverage"] == "once").all())
        self.assertTrue((found["owners"] >= 1).all())
        outside = self.points("x,y,z\n0,0,0\n9,9,9\nnan,0,0\n")
        found = self.probe(case("toroid_hex_g3_p6"), outside, "--owners")
        self.assertTrue((found["coverage"] == "none").all())
        self.assertTrue((found["owners"] == 0).all())

    def test_summary(self):
        points = self.points("x,y,z\n1,0,0\n9,9,9\n")
        summary = self.summary(
            "probe", case("toroid_hex_g3_p6"), "--field", "u", "--points", points,
            "--output", self.folder / "out.csv", "--owners",
        )
        expected = {"none": 1, "once": 1, "several": 0, "undecided": 0}
        self.assertEqual(summary["coverage"], expected)


if __name__ == "__main__":
    unittest.main()
