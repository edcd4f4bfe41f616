# SPDX-License-Identifier: BSD-3-Clause
"""pixelexact info --certify: proven ranges against samples and closed forms."""

import unittest

from tool import CASES, CUBE, ToolTest, case, oracle, unit_cube_grid


class Certify(ToolTest):
    def certified(self, source, *options):
        return self.summary("info", source, "--certify", *options)

    def check_range(self, known):
        self.assertTrue(known["tolerance_met"])
        self.assertEqual(known["unbounded_elements"], 0)
        self.assertLessEqual(known["lower"], known["attained_lower"])
        self.assertLessEqual(known["attained_upper"], known["upper"])
        self.assertLess(known["relative_excess"], 2e-3 + 1e-12)

    def test_ranges_hold_the_solvers_values_and_elements_are_valid(self):
        for name in CASES:
            with self.subTest(name=name):
                truth = oracle(name)["u"]
                facts = self.certified(case(name))
                field = next(f for f in facts["fields"] if f["name"] == "u")
                known = field["certified"]["components"][0]
                self.check_range(known)
                self.assertLessEqual(known["lower"], truth.min())
                self.assertGreaterEqual(known["upper"], truth.max())
                self.check_range(field["certified"]["gradient_magnitude"])
                jacobian = facts["jacobian"]
                self.assertEqual(jacobian["valid"], facts["elements"])
                self.assertEqual(jacobian["inverted_elements"], [])
                self.assertEqual(jacobian["undecided_elements"], [])
                self.assertGreater(jacobian["lower"], 0.0)

    def test_closed_form(self):
        cube = self.folder / "cube.vtu"
        cube.write_text(unit_cube_grid(), encoding="utf-8")
        facts = self.certified(cube)
        # The unit cube from [-1,1]^3, u = x.
        jacobian = facts["jacobian"]
        self.assertAlmostEqual(jacobian["lower"], 0.125, delta=1e-12)
        self.assertAlmostEqual(jacobian["upper"], 0.125, delta=1e-12)
        known = facts["fields"][0]["certified"]
        self.assertAlmostEqual(known["components"][0]["lower"], 0.0, delta=1e-12)
        self.assertAlmostEqual(known["components"][0]["upper"], 1.0, delta=1e-12)
        self.assertAlmostEqual(known["gradient_magnitude"]["lower"], 1.0, delta=1e-12)
        self.assertAlmostEqual(known["gradient_magnitude"]["upper"], 1.0, delta=1e-12)

    def test_expressions(self):
        truth = oracle("toroid_hex_g3_p6")
        slope = (truth["dudx"]**2 + truth["dudy"]**2 + truth["dudz"]**2)**0.5
        facts = self.certified(
            case("toroid_hex_g3_p6"), "--field", "mag(grad(u))", "--field", "u^2 + x")
        self.assertNotIn("certified", facts["fields"][0])
        for one, values in zip(facts["expressions"], (slope, truth["u"]**2 + truth["x"]), strict=True):
            known = one["certified"]["components"][0]
            self.assertLessEqual(known["lower"], values.min())
            self.assertGreaterEqual(known["upper"], values.max())
            self.check_range(known)
        done = self.succeeds("info", case("toroid_hex_g3_p6"), "--certify", "--field", "u^2 + x")
        self.assertIn("u^2 + x in [", done.stdout)
        self.fails(2, "info", case("toroid_hex_g3_p6"), "--field", "u", names=["--certify"])
        self.fails(1, "info", case("toroid_hex_g3_p6"), "--certify", "--field", "jump(u)",
            names=["jump"])

    def test_the_table_rounds_outwards(self):
        name = "escher_tet_g3_p3"
        facts = self.certified(case(name))
        known = next(f for f in facts["fields"] if f["name"] == "u")["certified"]["components"][0]
        done = self.succeeds("info", case(name), "--certify")
        line = next(x for x in done.stdout.splitlines() if "u in [" in x)
        lower, upper = line.split("in [")[1].split("]")[0].split(",")
        self.assertLessEqual(float(lower), known["lower"])
        self.assertGreaterEqual(float(upper), known["upper"])
        self.assertIn("42 valid, 0 inverted, 0 undecided", done.stdout)

    def test_any_number_of_threads_gives_the_same_answer(self):
        answers = []
        for threads in [1, 2]:
            facts = self.certified(case("toroid_prism_g3_p4"), "--threads", threads)
            del facts["certify_seconds"]
            answers.append(facts)
        self.assertEqual(*answers)

    def test_nothing_is_said_of_what_is_not_finite(self):
        cube = self.folder / "cube.vtu"
        values = [float("nan")] + [point[0] for point in CUBE[1:]]
        cube.write_text(unit_cube_grid([("u", values)]), encoding="utf-8")
        known = self.certified(cube)["fields"][0]["certified"]["components"][0]
        self.assertEqual(known["not_finite_elements"], 1)
        self.assertIsNone(known["lower"])

    def test_without_it_nothing_is_proven(self):
        facts = self.summary("info", case("escher_tet_g3_p3"))
        self.assertNotIn("jacobian", facts)
        self.assertNotIn("certified", facts["fields"][0])


if __name__ == "__main__":
    unittest.main()
