# SPDX-License-Identifier: BSD-3-Clause
"""pixelexact info --norms: closed forms, Gauss's theorem by integrals over the boundary, and NumPy."""

import math
import unittest

import numpy as np

import lagrange
from tool import CUBE, DATA, ToolTest, case, plain_grid, read_csv, unit_cube_grid

KOVASZNAY = DATA / "nek_plane_kovasznay_p7"
FLOW = [KOVASZNAY / "nek_plane_kovasznay_p7.xml", KOVASZNAY / "nek_plane_kovasznay_p7.rst"]
LAMBDA = "0.96374054419576697"


class Norms(ToolTest):
    def norms(self, *arguments):
        return self.summary("info", *arguments)["norms"]["fields"]

    def flux(self, path, vector):
        """The flux out of the mesh, with its proven bounds."""
        summary = self.summary(
            "integrate", path, "--boundary", "--field", vector, "--tolerance", "1e-8")
        return next(row for row in summary["surfaces"][0]["rows"] if row["quantity"] == "Flux")

    def holds(self, flux, value, error):
        self.assertGreaterEqual(value + error, flux["lower"])
        self.assertLessEqual(value - error, flux["upper"])
        self.assertLess(flux["error_bound"], 1e-6 * abs(value))

    def test_a_cube(self):
        path = self.folder / "cube.vtu"
        path.write_text(unit_cube_grid([("u", [p[0] for p in CUBE])]), encoding="utf-8")
        u, off, vector = self.norms(
            path, "--norms", "u", "--norms", "u - 1/3", "--norms", "vec(x, 2*y, 0*z)")
        for found, volume in ((u, 1.0), (off, 1.0), (vector, 1.0)):
            self.assertAlmostEqual(found["volume"]["value"], volume, delta=1e-12)
            self.assertEqual(found["elements_with_90_percent"], 1)
        self.assertAlmostEqual(u["l1"]["value"], 0.5, delta=1e-12)
        self.assertAlmostEqual(u["l2"]["value"], math.sqrt(1 / 3), delta=1e-12)
        self.assertTrue(u["linf"]["proven"])
        self.assertLessEqual(u["linf"]["attained"], 1.0)
        self.assertGreaterEqual(u["linf"]["bound"], 1.0)
        self.assertAlmostEqual(off["l1"]["value"], 5 / 18, delta=1e-5)
        self.assertLess(off["l1"]["error_estimate"], 1e-4)
        self.assertAlmostEqual(off["l2"]["value"], 1 / 3, delta=1e-12)
        self.assertAlmostEqual(off["integrals"][0]["value"], 1 / 6, delta=1e-12)
        self.assertAlmostEqual(vector["l2"]["value"], math.sqrt(5 / 3), delta=1e-12)
        self.assertAlmostEqual(vector["linf"]["bound"], math.sqrt(5), delta=1e-3)
        self.assertAlmostEqual(vector["integrals"][1]["value"], 1.0, delta=1e-12)

    def test_gauss_theorem(self):
        for name in ("toroid_hex_g3_p6", "escher_tet_g3_p3", "toroid_prism_g3_p4"):
            with self.subTest(name=name):
                path = case(name)
                one, x = self.norms(path, "--norms", "1 + 0*x", "--norms", "x")
                self.holds(self.flux(path, "coords/3"), one["volume"]["value"], 1e-12)
                self.assertAlmostEqual(one["l1"]["value"], one["volume"]["value"], delta=1e-12)
                self.holds(self.flux(path, "vec(x^3/3, 0*x, 0*x)"), x["l2"]["value"] ** 2, 1e-12)
                self.assertTrue(one["tolerance_met"])

    def test_the_error_of_a_flow(self):
        """The norms of a formula over a rectangle, and the solution that is near it."""
        bounds = self.summary("info", *FLOW)["bounds"]
        formula = f"1 - exp(-{LAMBDA}*x)*cos(2*pi*y)"
        error, exact, u, divergence = self.norms(
            *FLOW, "--norms", f"u - ({formula})", "--norms", formula, "--norms", "u",
            "--norms", "div(vec(u,v))")
        points, weights = np.polynomial.legendre.leggauss(40)
        x = bounds[0] + (bounds[1] - bounds[0]) * (points + 1) / 2
        y = bounds[2] + (bounds[3] - bounds[2]) * (points + 1) / 2
        scale = (bounds[1] - bounds[0]) * (bounds[3] - bounds[2]) / 4
        f = 1 - np.exp(-float(LAMBDA) * x[:, None]) * np.cos(2 * np.pi * y[None, :])
        square = scale * np.sum(weights[:, None] * weights[None, :] * f**2)
        self.assertAlmostEqual(exact["area"]["value"], 4 * scale, delta=1e-12)
        self.assertAlmostEqual(exact["l2"]["value"], math.sqrt(square), delta=1e-11)
        self.assertLess(error["l2"]["value"], 1e-5)
        self.assertLessEqual(abs(u["l2"]["value"] - exact["l2"]["value"]), error["l2"]["value"])
        # Norms are ordered: |f|_1^2 <= area |f|_2^2, |f|_2^2 <= area max^2.
        self.assertLessEqual(error["l1"]["value"] ** 2, 4 * scale * error["l2"]["value"] ** 2)
        self.assertLessEqual(error["l2"]["value"] ** 2, 4 * scale * error["linf"]["bound"] ** 2)
        self.assertLess(divergence["l2"]["value"], 1e-3)

    def test_the_table_of_elements(self):
        table = self.folder / "norms.csv"
        field = f"u - (1 - exp(-{LAMBDA}*x)*cos(2*pi*y))"
        facts = self.summary("info", *FLOW, "--norms", field, "--norms-table", table)
        found = facts["norms"]["fields"][0]
        rows = read_csv(table)
        self.assertEqual(len(rows), facts["elements"])
        self.assertEqual({int(row["element"]) for row in rows}, set(range(len(rows))))
        squares = np.array([float(row["l2"]) for row in rows]) ** 2
        self.assertTrue(np.all(np.diff(squares) <= 0))
        self.assertAlmostEqual(math.sqrt(squares.sum()), found["l2"]["value"], delta=1e-12 * found["l2"]["value"])
        most = int(np.searchsorted(np.cumsum(squares), 0.9 * squares.sum())) + 1
        self.assertEqual(found["elements_with_90_percent"], most)
        self.assertEqual(int(rows[0]["element"]), found["worst"][0]["element"])
        self.assertAlmostEqual(sum(float(row["area"]) for row in rows), found["area"]["value"], delta=1e-12)

    def test_what_is_not_finite_or_folded(self):
        cube = self.folder / "cube.vtu"
        cube.write_text(unit_cube_grid([("u", [p[0] - 1 / 3 for p in CUBE])]), encoding="utf-8")
        pole = self.norms(cube, "--norms", "log(u)")[0]
        self.assertEqual(pole["not_finite_elements"], 1)
        self.assertFalse(pole["linf"]["proven"])
        points = [[0.9, 0.9, 0.9]] + CUBE[1:]
        path = self.folder / "folded.vtu"
        path.write_text(
            plain_grid(points, [(12, list(range(8)))], [("u", [p[0] for p in points])]), encoding="utf-8")
        self.assertEqual(self.norms(path, "--norms", "u")[0]["folded_elements"], 1)
        self.assertIn("det J <= 0 in 1 element", self.succeeds("info", path, "--norms", "u").stdout)

    def test_numpy_quadrature(self):
        for name in ("toroid_hex_g3_p6", "periodic_hex_dg_g3_p4"):
            found = self.norms(case(name), "--norms", "u")[0]
            volume, l2 = lagrange.norms(lagrange.read_hexahedra(case(name)))
            self.assertAlmostEqual(found["volume"]["value"], volume, delta=1e-12 * volume)
            self.assertAlmostEqual(found["l2"]["value"], l2, delta=1e-12 * l2)

    def test_a_series_over_the_elements_length(self):
        paths = [self.folder / f"n{n}" / "u.vtu" for n in (2, 4, 8)]
        for path, n in zip(paths, (2, 4, 8), strict=True):
            path.parent.mkdir()
            path.write_text(lagrange.lagrange_grid(lagrange.sine, n, 2), encoding="utf-8")
        error = f"u - {lagrange.SINE}"
        plot = self.folder / "plot.svg"
        # In any order.
        found = self.summary("info", paths[1], "--with", paths[2], "--with", paths[0], "--norms", error,
            "--norms", "u", "--plot", plot)["norms"]  # fmt: skip
        series = found["series"]
        self.assertEqual(series["over"], "relative_length")
        self.assertEqual([one["solution"] for one in series["solutions"]], ["n2/u.vtu", "n4/u.vtu", "n8/u.vtu"])
        self.assertEqual([one["elements"] for one in series["solutions"]], [8, 64, 512])
        self.assertEqual(series["solutions"][1]["norms"][0]["l2"], found["fields"][0]["l2"]["value"])
        alone = self.norms(paths[2], "--norms", error)[0]
        self.assertEqual(series["solutions"][2]["norms"][0]["l2"], alone["l2"]["value"])
        for norm in ("l1", "l2", "linf"):
            self.assertAlmostEqual(series["orders"][0][norm]["last"], 3.0, delta=0.15)
            self.assertEqual(series["orders"][0][norm]["solutions"], 3)
        self.assertAlmostEqual(series["orders"][1]["l2"]["last"], 0.0, delta=0.01)
        text = plot.read_text(encoding="utf-8")
        self.assertIn("<svg", text)
        report = self.succeeds("info", paths[0], "--with", paths[1], "--norms", error).stdout
        self.assertRegex(report, r"slope of L2: [23]\.\d\d, at the end [23]\.\d\d, over the elements' length")

    def test_a_series_over_orders(self):
        paths = [DATA / "sine_series" / f"p{order}.vtu" for order in (1, 2, 3, 4)]
        others = [word for path in paths[1:] for word in ("--with", path)]
        series = self.summary("info", paths[0], *others, "--norms", f"u - {lagrange.SINE}")["norms"]["series"]
        self.assertEqual(series["over"], "modes")
        self.assertEqual([one["modes"] for one in series["solutions"]], [64, 216, 512, 1000])
        errors = np.array([one["norms"][0]["l2"] for one in series["solutions"]])
        steps = np.array([64.0, 216.0, 512.0, 1000.0]) ** (-1 / 3)
        slope = np.polyfit(np.log(steps), np.log(errors), 1)[0]
        self.assertAlmostEqual(series["orders"][0]["l2"]["overall"], slope, delta=1e-10)

    def test_a_series_states_what_is_not_finite(self):
        paths = []
        for name, last in (("whole", 1.0), ("half", float("nan"))):
            points = [[x + dx, y, z] for dx in (0.0, 1.0) for x, y, z in CUBE]
            fields = [("u", [p[0] for p in points[:-1]] + [last * points[-1][0]])]
            paths.append(self.folder / f"{name}.vtu")
            cells = [(12, list(range(8))), (12, list(range(8, 16)))]
            paths[-1].write_text(plain_grid(points, cells, fields), encoding="utf-8")
        words = ["info", paths[0], "--with", paths[1], "--norms"]
        series = self.summary(*words, "u")["norms"]["series"]
        found = {one["solution"]: one["norms"][0]["not_finite_elements"] for one in series["solutions"]}
        self.assertEqual(found, {"whole.vtu": 0, "half.vtu": 1})
        self.assertIn("not finite in 1 element, left out of the norms", self.succeeds(*words, "u").stdout)
        nothing = self.summary(*words, "u/0")["norms"]["series"]["solutions"]
        self.assertEqual([one["norms"][0]["l2"] for one in nothing], [None, None])

    def test_refusals_of_a_series(self):
        path = case("toroid_hex_g3_p6")
        self.fails(2, "info", path, "--with", path, names=["--norms"])
        self.fails(2, "info", path, "--norms", "u", "--plot", self.folder / "p.png", names=["--plot", "--with"])
        self.fails(1, "info", path, "--with", case("nothing"), "--norms", "u", names=["nothing"])
        self.fails(2, "info", path, "--norms", "u", "--with", path, "--plot", "p.txt", names=["--plot", "p.txt"])

    def test_refusals(self):
        path = case("toroid_hex_g3_p6")
        self.fails(1, "info", path, "--norms", "nothing", names=["nothing"])
        self.fails(1, "info", path, "--norms", "jump(u)", names=["jump"])
        self.fails(2, "info", path, "--norms-table", self.folder / "t.csv", names=["--norms"])
        self.fails(1, "info", path, "--norms", "u", "--norms-table", self.folder / "no" / "t.csv", names=["cannot write"])

    def test_the_report(self):
        text = self.succeeds("info", case("periodic_hex_dg_g3_p4"), "--norms", "u").stdout
        self.assertRegex(text, r"norms +u over a volume of [0-9.]+ \+- .* \(numeric\)")
        self.assertRegex(text, r"L2 +[0-9.]+ \+- .* \(numeric\)")
        self.assertRegex(text, r"Linf +proven between [0-9.]+ and [0-9.]+")
        self.assertRegex(text, r"90 % of L2 squared are in \d+ of \d+ elements")


if __name__ == "__main__":
    unittest.main()
