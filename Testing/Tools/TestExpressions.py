# SPDX-License-Identifier: BSD-3-Clause
"""Expressions wherever the tool takes a field's name, against closed forms and the solver."""

import unittest

import numpy as np

from tool import (
    CUBE,
    DATA,
    ToolTest,
    columns,
    plain_grid,
    read_buffers,
    read_csv,
    run,
    unit_cube_grid,
)

TORUS = DATA / "toroid_hex_g3_p6.vtu"
ORACLE = DATA / "toroid_hex_g3_p6.oracle.csv"
SIZE = ["--size", "80x60"]


class Expressions(ToolTest):
    def probe(self, expression, *arguments):
        output = self.folder / "probed.csv"
        self.succeeds("probe", TORUS, "--points", ORACLE, "--field", expression, "--output", output,
                      *arguments)
        return columns(read_csv(output))

    def setUp(self):
        super().setUp()
        self.oracle = columns(read_csv(ORACLE))

    def test_gradients_are_the_solvers(self):
        found = self.probe("grad(u)")
        inside = found["verdict"] == "inside"
        self.assertGreater(inside.mean(), 0.95)
        for component, name in enumerate(["dudx", "dudy", "dudz"]):
            exact = self.oracle[name]
            error = np.abs(found[f"value_{component}"] - exact)[inside].max()
            self.assertLess(error, 1e-10 * np.abs(exact).max())

    def test_errors_against_a_formula_are_enclosed(self):
        found = self.probe("u - sin(x)*exp(y/3)", "--enclosures")
        exact = self.oracle["u"] - np.sin(self.oracle["x"]) * np.exp(self.oracle["y"] / 3)
        inside = found["verdict"] == "inside"
        np.testing.assert_allclose(found["value"][inside], exact[inside], rtol=0, atol=1e-12)
        width = found["value_upper"] - found["value_lower"]
        self.assertLess(np.median(width[inside]), 1e-11)
        self.assertTrue((found["value_lower"] <= found["value"])[inside].all())
        self.assertTrue((found["value"] <= found["value_upper"])[inside].all())

    def test_names_of_paraviews_calculator(self):
        """Unit vectors, coordinates, ln and components as ParaView's menus write them."""
        for theirs, ours in [("dot(iHat + 2*jHat - kHat, coords)", "x + 2*y - z"),
                             ("coordsX + 2*coordsY - coordsZ", "x + 2*y - z"),
                             ("ln(1 + u^2)", "log(1 + u^2)")]:
            np.testing.assert_array_equal(self.probe(theirs)["value"], self.probe(ours)["value"], theirs)
        name = "mfem_escher_tet_darcy_p3"
        inputs = [DATA / name / f"{name}.mesh", DATA / name / "flux.gf"]
        values = {}
        for text in ("flux_X + 2*flux_Z", "flux.x + 2*flux.z", "'flux_0' + 2*flux_2"):
            output = self.folder / "flux.csv"
            self.succeeds("probe", *inputs, "--line", "0.1,0.1,0.1,0.9,0.8,0.7,50", "--field", text,
                          "--output", output)
            values[text] = columns(read_csv(output))["value"]
        first, *others = values.values()
        self.assertGreater(np.isfinite(first).sum(), 10)
        for other in others:
            np.testing.assert_array_equal(other, first)
    def test_pictures(self):
        buffers = self.folder / "out.vti"
        found = self.summary("render", TORUS, "--field", "u^2 + 1", "--plane", "z", *SIZE,
                             "--contours", "3", "--output", self.folder / "a.png",
                             "--buffers", buffers)
        self.assertGreater(found["pixels"]["exact"], 1000)
        self.assertGreaterEqual(found["value_range"][0], 1.0)
        self.assertGreater(found["contours"]["pixels"]["in"], 200)
        self.assertLess(found["contours"]["pixels"]["undecided"], 20)

    def test_contours_against_dense_samples(self):
        """Pixels are in where 24 samples on an edge lie on either side of a value, and out where
        none of the four edges has such samples."""
        pixels, samples = 70, 24
        for text, values in [("u^2 + x*y", [-0.2, 0.0, 0.1, 0.3]),
                             ("mag(grad(u))", [1.0, 2.0, 3.5, 5.0]),
                             ("2 - exp(u)", [0.1, 0.6, 1.3]),
                             ("abs(u) - 0.1*x", [0.05, 0.2, 0.4])]:
            buffers = self.folder / "out.vti"
            found = self.summary(
                "render", TORUS, "--field", text, "--plane", "0,0,0.05,0,0,1",
                "--contours", ",".join(map(str, values)), "--size", f"{pixels}x{pixels}",
                "--output", self.folder / "a.png", "--buffers", buffers)
            counts = found["contours"]["pixels"]
            self.assertLess(counts["undecided"], 0.005 * pixels * pixels, text)
            read = read_buffers(buffers)
            verdict = read["Contour"].reshape(pixels, pixels)
            exact = (read["Verdict"] == 1).reshape(pixels, pixels)
            x = read["Position"].reshape(pixels, pixels, 3)
            row, column = np.argwhere(exact[:-1, :-1] & exact[1:, :-1] & exact[:-1, 1:])[0]
            right = x[row, column + 1] - x[row, column]
            up = x[row + 1, column] - x[row, column]
            inner = exact.copy()
            for shift in [(1, 0), (-1, 0), (0, 1), (0, -1)]:
                inner &= np.roll(exact, shift, (0, 1))
            t = np.linspace(-0.5, 0.5, samples)
            ways = [(a, b) for side in (-0.5, 0.5)
                    for a, b in [(t, np.full(samples, side)), (np.full(samples, side), t)]]
            at = [x[inner][:, None] + a[:, None] * right + b[:, None] * up for a, b in ways]
            points = np.stack(at, 1)
            source = self.folder / "edges.csv"
            np.savetxt(source, points.reshape(-1, 3), "%.17g", ",", header="x,y,z", comments="")
            output = self.folder / "edges_out.csv"
            self.succeeds("probe", TORUS, "--field", text, "--points", source, "--output", output)
            probed = columns(read_csv(output))
            inside = (probed["verdict"] == "inside").reshape(points.shape[:3])
            value = np.where(inside, probed["value"].astype(float).reshape(points.shape[:3]), np.nan)
            known = inside.all((1, 2))
            crossed = np.zeros(len(known), bool)
            near = np.zeros(len(known), bool)
            low, high = value.min(2), value.max(2)
            for one in values:
                crossed |= ((low < one) & (one < high)).any(1)
                slack = 0.02 * (high - low)
                near |= ((low - slack < one) & (one < high + slack)).any(1)
            verdict = verdict[inner]
            self.assertGreater((verdict[known] == 1).sum(), 100, text)
            self.assertEqual((crossed & known & (verdict == 0)).sum(), 0, text)
            self.assertEqual((~near & known & (verdict == 1)).sum(), 0, text)

    def test_certified_ranges(self):
        base = ["render", TORUS, *SIZE, "--plane", "z", "--output", self.folder / "a.png"]
        for text in ["2*u", "mag(grad(u))", "u^2 + x*y"]:
            low, high = self.summary(*base, "--field", text, "--range", "field")["color_range"]
            found = self.probe(text)
            value = found["value"][found["verdict"] == "inside"].astype(float)
            self.assertLess(low, value.min())
            self.assertGreater(high, value.max())
            self.assertLess(high - low, 2.0 * np.ptp(value), text)
        self.fails(1, *base, "--field", "1/u", "--range", "field", names=["'1/u'", "bounded"])

    def test_jumps_on_faces(self):
        """Two cubes that share x = 1, with u = 1 + 2x + y in the first and x - 3y in the second."""
        points, values = [], []
        for k, u in enumerate([lambda p: 1 + 2 * p[0] + p[1], lambda p: p[0] - 3 * p[1]]):
            moved = [[p[0] + k, p[1], p[2]] for p in CUBE]
            points += moved
            values += [float(u(p)) for p in moved]
        source = self.folder / "two.vtu"
        cells = [(12, list(range(8))), (12, list(range(8, 16)))]
        source.write_text(plain_grid(points, cells, [("u", values)]), encoding="utf-8")
        buffers = self.folder / "jumps.vti"
        shot = ["--output", self.folder / "a.png", "--buffers", buffers, *SIZE]
        for element, side, sign in [(0, "+x", 1), (1, "-x", -1)]:
            for field, jump in [("jump(u)", lambda x, y: -1 - x - 4 * y),
                                ("jump(grad(u).y)", lambda x, y: -4 + 0 * y),
                                ("jump(grad(u))[0]", lambda x, y: -1 + 0 * y),
                                ("jump(dot(grad(u), n))", lambda x, y: sign * (-1 + 0 * y))]:
                self.summary("render", source, "--field", field,
                             f"--boundary=element:{element}", "--view", side, *shot)
                found = read_buffers(buffers)
                on = found["Verdict"] == 1
                x, y = found["Position"][on][:, 0], found["Position"][on][:, 1]
                self.assertGreater(on.sum(), 1000)
                np.testing.assert_allclose(found["Value"][on], sign * jump(x, y), rtol=0,
                                           atol=1e-13)
        done = self.succeeds("render", source, "--field", "jump(u)", "--plane", "z", *shot)
        self.assertIn("--show jumps", done.stderr)
        done = run("render", source, "--field", "grad(jump(u))", "--plane", "z", *shot)
        self.assertEqual(done.returncode, 1)
        self.assertIn("jump(grad(u))", done.stderr)

    def test_normals_are_the_surfaces(self):
        cube = self.folder / "cube.vtu"
        cube.write_text(unit_cube_grid([("u", [p[0] for p in CUBE])]), encoding="utf-8")

        def values(expression, *surface):
            buffers = self.folder / "out.vti"
            self.succeeds("render", cube, "--field", expression, *surface, *SIZE, "--output",
                          self.folder / "a.png", "--buffers", buffers)
            found = read_buffers(buffers)
            seen = found["Verdict"] == 1
            self.assertGreater(seen.sum(), 100)
            return found["Value"][seen], found["Position"][seen]

        flux, _ = values("dot(vec(1, 2, 3), n)", "--plane", "0.5,0.5,0.5,0,0,1")
        self.assertEqual(set(flux), {3.0})
        flux, at = values("dot(coords - 0.5*vec(1, 1, 1), n)", "--sphere", "0.5,0.5,0.5,0.4")
        np.testing.assert_allclose(flux, 0.4, rtol=0, atol=1e-12)
        flux, _ = values("dot(coords - 0.5*vec(1, 1, 1), n)", "--boundary", "--view", "iso")
        np.testing.assert_allclose(flux, 0.5, rtol=0, atol=1e-12)
        for surface in [["--boundary", "--view", "iso"], ["--isosurface", "u=0.1"], ["--plane", "z=0.1"]]:
            buffers = self.folder / "out.vti"
            self.succeeds("render", TORUS, "--field", "x", *surface, *SIZE, "--output",
                          self.folder / "a.png", "--buffers", buffers)
            found = read_buffers(buffers)
            seen = found["Verdict"] == 1
            np.testing.assert_array_equal(found["Value"][seen], found["Position"][seen][:, 0])
        self.fails(1, "probe", cube, "--field", "n", "--line", "0,0,0,1,1,1,3",
                   names=["needs the normal of a surface"])
        self.fails(1, "integrate", cube, "--field", "n", "--plane", "z=0.5",
                   names=["needs the normal of a surface"])

    def test_stress_carries_the_load(self):
        """Through each cross-section of the beam go the force at its end and its moment."""
        beam = DATA / "mfem_beam_hex_elast_p4"
        shear, moment = "(grad(displacement)[0,{0}] + grad(displacement)[{0},0])", "*z"
        stress = "(tr(grad(displacement)) + 2*grad(displacement)[0,0])"
        for at, lame in [(2.1, 50), (6.3, 1)]:
            for text, load in [(shear.format(2), -0.01), (shear.format(1), -0.006), (stress, 0.0),
                               (stress + moment, 0.01 * (8 - at))]:
                found = self.summary("integrate", beam / "mfem_beam_hex_elast_p4.mesh",
                                     beam / "displacement.gf", "--plane", f"x={at}", "--field",
                                     f"{lame}*{text}")
                through = {row["quantity"]: row["value"] for row in found["surfaces"][0]["rows"]}
                self.assertAlmostEqual(through["Integral"], load, delta=1e-7)

    def test_enclosures_hold_what_follows_from_nan(self):
        points = self.folder / "points.csv"
        points.write_text("x,y,z\n-1,0.1,0.05\n")
        output = self.folder / "probed.csv"
        for condition in ["abs(sqrt(x))>=0", "sqrt(x)*sqrt(x)>=0", "min(2,sqrt(x))<3",
                          "mag(vec(sqrt(x),1,2))>0", "abs(asin(5*x))>=0", "sin(1/(x-x))<2",
                          "-1<abs(log(x))", "sqrt(x)==0 || u>9"]:
            self.succeeds("probe", TORUS, "--field", f"where({condition},1,2)", "--points", points,
                          "--enclosures", "--output", output)
            found = columns(read_csv(output))
            value = found[next(name for name in found if "value" in name and "_" not in name)]
            lower, upper = (next(found[name] for name in found if end in name)
                            for end in ("lower", "upper"))
            self.assertEqual(value[0], 2)
            self.assertTrue(lower[0] <= 2 <= upper[0], condition)

    def test_layers_have_expressions(self):
        def values(*options):
            buffers = self.folder / "out.vti"
            self.succeeds("render", TORUS, "--plane", "z=0.1", *options, *SIZE, "--output",
                          self.folder / "a.png", "--buffers", buffers)
            return read_buffers(buffers)["Value"]

        text = "where(x>0,max(u,0.1),vec(x,y)[1])"
        np.testing.assert_array_equal(
            values("--layer", f"1:field={text},range=0:1", "--field", "u"), values("--field", text))

    def test_parameters_are_told(self):
        flow = DATA / "nek_plane_kovasznay_p7" / "nek_plane_kovasznay_p7"
        told = self.summary("info", f"{flow}.xml", f"{flow}.rst")
        self.assertAlmostEqual(told["parameters"]["Kinvis"], 0.025)
        self.assertEqual(told["defined"], {})

    def test_isosurfaces_are_numeric(self):
        found = self.summary("render", TORUS, "--field", "u", "--isosurface", "u^2=0.09", *SIZE,
                             "--output", self.folder / "a.png")
        self.assertGreater(found["pixels"]["exact"], 100)
        self.assertLess(abs(found["value_range"][1] - 0.3), 1e-9)
        self.assertLess(abs(found["value_range"][0] + 0.3), 1e-9)
        self.assertGreater(found["hits"]["numeric"], 100)

    def test_isosurfaces_end_where_the_mesh_does(self):
        """Seen at all pixels but some at the silhouette; none where the expression jumps."""
        def hits(isosurface):
            buffers = self.folder / "out.vti"
            self.succeeds("render", TORUS, "--field", "u", "--isosurface", isosurface, *SIZE, "--output",
                          self.folder / "a.png", "--buffers", buffers)
            return read_buffers(buffers)["Verdict"] == 1

        proven, numeric = hits("u=0.05"), hits("u*1=0.05")
        self.assertGreater(proven.sum(), 1000)
        self.assertLess((proven != numeric).sum(), 0.002 * proven.sum())
        # On faces between elements.
        on_plane = hits("z+0*u=1e-9").sum()
        for value in ["0", "1e-14"]:
            self.assertLess(abs(hits(f"z=" + value).sum() - on_plane), 0.002 * on_plane)
        self.assertEqual(hits("where(z > 0.1, 1, 0)=0.5").sum(), 0)
        self.assertEqual(hits("1/(z - 0.1)=0").sum(), 0)

    def test_hits_have_the_value(self):
        buffers = self.folder / "out.vti"
        self.succeeds("render", DATA / "escher_tet_g3_p3.vtu", "--field", "grad(u).z", "--isosurface",
                      "grad(u).z=0.3", "--camera-position", "-4,2,-3", "--focal-point", "0,0,0", *SIZE,
                      "--output", self.folder / "a.png", "--buffers", buffers)
        found = read_buffers(buffers)
        seen = found["Verdict"] == 1
        self.assertGreater(seen.sum(), 1000)
        np.testing.assert_allclose(found["Value"][seen], 0.3, rtol=0, atol=1e-12)

    def test_parameters_of_the_session(self):
        flow = DATA / "nek_plane_kovasznay_p7"
        output = self.folder / "probed.csv"
        self.succeeds("probe", flow / "nek_plane_kovasznay_p7.xml",
                      flow / "nek_plane_kovasznay_p7.rst", "--field", "1/Kinvis + t + 0*u",
                      "--line", "0,0,0.5,0.5,3", "--output", output)
        np.testing.assert_allclose(columns(read_csv(output))["value"], 40.1, rtol=1e-15)

    def test_kovasznay(self):
        """Vorticity and divergence of the flow, against its formula."""
        flow = DATA / "nek_plane_kovasznay_p7"
        rate = 20 - np.sqrt(400 + 4 * np.pi**2)
        output = self.folder / "probed.csv"
        self.succeeds("probe", flow / "nek_plane_kovasznay_p7.xml",
                      flow / "nek_plane_kovasznay_p7.rst", "--field", "vorticity(vec(u,v))",
                      "--field", "div(vec(u,v))", "--field", "grad(p)", "--line",
                      "-0.4,-0.4,0.9,1.4,50", "--output", output)
        found = columns(read_csv(output))
        x, y = found["x"], 2 * np.pi * found["y"]
        exact = np.exp(rate * x) * np.sin(y) * (rate**2 / (2 * np.pi) - 2 * np.pi)
        # As exact as the solution of order 7.
        self.assertLess(np.abs(found["vorticity(vec(u,v))"] - exact).max(), 2e-4)
        self.assertLess(np.abs(found["div(vec(u,v))"]).max(), 2e-4)
        slope = -rate * np.exp(2 * rate * x)
        self.assertLess(np.abs(found["grad(p)_0"] - slope).max(), 2e-2)
        self.assertLess(np.abs(found["grad(p)_1"]).max(), 2e-2)

    def test_integrals_are_proven(self):
        cube = self.folder / "cube.vtu"
        cube.write_text(unit_cube_grid([("u", [p[0] for p in CUBE])]), encoding="utf-8")

        def integral(*arguments):
            found = self.summary("integrate", *arguments)["surfaces"][0]
            return found, {row["quantity"]: row for row in found["rows"]}

        def holds(row, exact, width):
            self.assertTrue(row["lower"] <= exact <= row["upper"], row)
            self.assertLess(row["upper"] - row["lower"], width)

        found, rows = integral(cube, "--plane", "z=0.3", "--field", "exp(u)*y")
        self.assertTrue(not found["numeric"] and found["tolerance_met"])
        holds(rows["Integral"], (np.e - 1) / 2, 1e-7)
        # Out of the cube, of a field with the divergence 2 x + 1.
        _, rows = integral(cube, "--boundary", "--field", "vec(u^2, y, sin(u))")
        holds(rows["Flux"], 2.0, 1e-7)
        # Kinks and steps have wider bounds, which hold.
        _, rows = integral(cube, "--plane", "z=0.3", "--field", "abs(x-y)", "--seconds", "2")
        holds(rows["Integral"], 1 / 3, 1e-2)
        _, rows = integral(cube, "--plane", "z=0.3", "--field", "where(x<0.25,2,0)", "--seconds", "2")
        holds(rows["Integral"], 0.5, 1e-2)
        # Undefined in a half.
        _, rows = integral(cube, "--plane", "z=0.3", "--field", "sqrt(x-0.5)", "--seconds", "1")
        self.assertIsNone(rows["Integral"]["value"])
        # Beside what is proven of the field itself.
        proven, exact = integral(TORUS, "--plane", "z", "--field", "u")
        self.assertFalse(proven["numeric"])
        _, rows = integral(TORUS, "--plane", "z", "--field", "u + 0*x")
        self.assertLess(abs(rows["Integral"]["value"] - exact["Integral"]["value"]), 1e-8)
        holds(rows["Integral"], exact["Integral"]["value"], 1e-6)

    def test_integrals_that_are_numeric_say_so(self):
        found = self.summary("integrate", DATA / "toroid_prism_g3_p4.vtu", "--plane", "z=0.05", "--field", "laplacian(u)",
                             "--seconds", "1")["surfaces"][0]
        self.assertTrue(found["numeric"])
        self.assertIn("the errors are estimates", found["notes"][0])

    def test_proofs_are_refused(self):
        self.fails(1, "integrate", TORUS, "--isosurface", "u^2=0.1", "--field", "u",
                   names=["integrals over iso-surfaces", "'u^2'", "choose a field"])

    def test_what_knows_polynomials_alone(self):
        base = ["render", TORUS, *SIZE, "--plane", "0,0,0,0,0,1", "--output",
                self.folder / "a.png", "--field", "2*u"]
        for options, names in [
            (["--certifier", "interval", "--contours", "3"], ["contours by intervals", "'2*u'"]),
            (["--truncate-order", "2"], ["--truncate-order", "'2*u' is an expression"]),
        ]:
            self.fails(1, *base, *options, names=names)
        for options in (["--precision", "float"], ["--layer", "1:precision=float"]):
            self.fails(2, *base, *options, names=["'2*u'", "double precision", "leave it out"])

    def test_measures_of_elements(self):
        """attribute, elementSize, and bounds of det J, which hold all samples in each element."""
        beam = DATA / "mfem_beam_hex_elast_p4"
        buffers = self.folder / "out.vti"

        def render(field, *files):
            self.succeeds("render", *files, "--field", field, "--boundary", "--size", "120x90", "--view", "iso",
                "--output", self.folder / "a.png", "--buffers", buffers)  # fmt: skip
            found = read_buffers(buffers)
            exact = found["Verdict"] == 1
            return found["Value"][exact], found["Element"][exact]

        files = [beam / "mfem_beam_hex_elast_p4.mesh", beam / "displacement.gf"]
        value, element = render("attribute", *files)
        np.testing.assert_array_equal(value, np.where(element < 32, 1, 2))
        np.testing.assert_allclose(render("elementSize", *files)[0], 0.5, rtol=1e-14)
        for text, sampled in [("minScaledJacobian", "scaledJacobian"), ("minDetJ", "detJ")]:
            bound, element = render(text, TORUS)
            sample, same = render(sampled, TORUS)
            np.testing.assert_array_equal(element, same)
            self.assertTrue((bound <= sample).all())
            for e in np.unique(element):
                self.assertEqual(len(np.unique(bound[element == e])), 1)
                # The bound aims at a hundredth of the range, and some samples come near.
                self.assertGreater(bound[element == e][0], 0.5 * sample[element == e].min())
        # They are fields: parts of expressions, with proven extremes.
        found = self.summary("info", TORUS, "--extremes", "minScaledJacobian", "--extremes", "2*minScaledJacobian")
        one, two = (field["components"][0]["minimum"]["value"] for field in found["extremes"]["fields"])
        self.assertAlmostEqual(two, 2 * one, delta=1e-15)
        # A bound of a folded element is not positive; elementSize is the third root of its volume.
        points = [[0.9, 0.9, 0.9]] + CUBE[1:]
        path = self.folder / "folded.vtu"
        path.write_text(
            plain_grid(points, [(12, list(range(8)))], [("u", [p[0] for p in points])]), encoding="utf-8")
        found = self.summary("info", path, "--extremes", "minScaledJacobian")["extremes"]["fields"][0]
        self.assertLess(found["components"][0]["maximum"]["value"], 0.0)
        self.assertGreaterEqual(found["components"][0]["minimum"]["value"], -1.0)
        # A quoted name of a field may contain a measure's.
        path.write_text(plain_grid(CUBE, [(12, list(range(8)))], [("my attribute", [1.0] * 8)]), encoding="utf-8")
        self.summary("info", path, "--extremes", '"my attribute"*2')
        self.fails(1, "info", path, "--extremes", "attribute", names=["attributes", "element"])

    def test_orders_by_direction(self):
        folder = DATA / "nek_hex_aniso_p3p5p7"
        files = [folder / f"{folder.name}.xml", folder / f"{folder.name}.fld"]
        texts = ["order(u)", "order(u, 0)", "order(u, 1)", "order(u, 2)"]
        words = [word for text in texts for word in ("--extremes", text)]
        found = self.summary("info", *files, *words)["extremes"]["fields"]
        orders = [field["components"][0]["maximum"]["value"] for field in found]
        self.assertEqual(orders, [7, 3, 5, 7])
        for text in ("order(u, 3)", "order(u, -1)", "order(u, 0.5)"):
            done = run("info", *files, "--extremes", text)
            self.assertEqual(done.returncode, 1)
            self.assertIn("is no direction of order; write 0, 1 or 2", done.stderr)

    def test_places_are_those_asked_for(self):
        found = self.probe("min(x, y)", "--enclosures")
        inside = found["verdict"] == "inside"
        exact = np.minimum(self.oracle["x"], self.oracle["y"])
        for column in ["value", "value_lower", "value_upper"]:
            np.testing.assert_array_equal(found[column][inside], exact[inside])

    def test_wrong_texts_have_their_place(self):
        base = ["render", TORUS, *SIZE, "--output", self.folder / "a.png", "--field"]
        for text, message in [
            ("mag(grad(u)", "something is missing at the end\n  mag(grad(u)\n             ^"),
            ("u + w", "nothing is named 'w'"),
            ("curl(u)", "curl takes vectors"),
            ("norm(coords)", "write mag(v) for the length of v"),
            ("u_X + 1", "nothing is named 'u_X'"),
            ("iHat_X + 1", "nothing is named 'iHat_X'"),
        ]:
            done = run(*base, text)
            self.assertEqual(done.returncode, 1)
            self.assertIn(message, done.stderr)
        self.assertFalse((self.folder / "a.png").exists())


if __name__ == "__main__":
    unittest.main()
