# SPDX-License-Identifier: BSD-3-Clause
"""Surfaces in space: triangles and quadrilaterals of any order, against closed forms on a graph."""

import json
import unittest

import numpy as np

from exodus import exodus
from shells import Patches
from tool import CUBE, ToolTest, View, columns, plain_grid, read_buffers, read_csv, read_image, run, unit_cube_grid


def height(x, y):
    return 0.4 * x * x - 0.3 * x * y + 0.2 * y**3


def slopes(x, y):
    return 0.8 * x - 0.3 * y, -0.3 * x + 0.6 * y * y


def value(x, y):
    return 1 + x - 2 * y + 3 * x * y * y


def graph(x, y):
    return [x, y, height(x, y)]


def over_square(function, points=40):
    """The integral over [0, 1]^2 by Gauss's rule."""
    nodes, weights = np.polynomial.legendre.leggauss(points)
    x, y = np.meshgrid((nodes + 1) / 2, (nodes + 1) / 2)
    return float(np.sum(np.outer(weights, weights) / 4 * function(x, y)))


def area_element(x, y):
    gx, gy = slopes(x, y)
    return np.sqrt(1 + gx * gx + gy * gy)


VIEW = View([0.5, 0.5, 5], [0.5, 0.5, 0], [0, 1, 0], 90, 90, scale=0.55)


def squares_seen():
    """The (x, y) of the pixels of VIEW, and whether they are over the square."""
    origins, _ = VIEW.rays()
    x, y = origins[..., 0], origins[..., 1]
    return x, y, (x > 0) & (x < 1) & (y > 0) & (y < 1)


def crossings(level, x, y):
    """Whether the value crosses a level on one of the four edges of each pixel."""
    half = 0.5 * (x[0, 1] - x[0, 0])
    along = np.linspace(-half, half, 25)[:, None, None]
    crossed = np.zeros(x.shape, bool)
    for side in (-half, half):
        for a, b in ((along, side), (side, along)):
            signs = np.sign(value(x + a, y + b) - level)
            crossed |= signs.min(axis=0) != signs.max(axis=0)
    return crossed


class ShellTest(ToolTest):
    def patches(self, order=3, n=3, shapes="mixed", surface=graph):
        made = Patches(order, n, surface, shapes)
        fields = [("u", [value(x, y) for x, y, _ in made.points]),
                  ("up", [[0.0, 0.0, 1.0]] * len(made.points))]
        path = self.folder / f"{shapes}{order}.vtu"
        path.write_text(plain_grid(made.points, made.cells, fields), encoding="utf-8")
        return path

    def integrals(self, *options):
        rows = self.summary("integrate", *options)["surfaces"][0]["rows"]
        return {row["quantity"]: row for row in rows}

    def shown(self, file, *options):
        out = self.folder / "out.vti"
        summary = self.summary("render", file, *VIEW.options(), *options, "--output",
                               self.folder / "out.png", "--buffers", out)
        return summary, read_buffers(out)


class Shells(ShellTest):
    def test_info_states_a_surface(self):
        file = self.patches()
        summary = self.summary("info", file)
        self.assertEqual(summary["dimension"], 2)
        self.assertEqual(summary["shapes"], {"triangle": 8, "quadrilateral": 5})
        self.assertNotIn("slab", summary)
        np.testing.assert_allclose(summary["bounds"], [0, 1, 0, 1, 0, 0.4], atol=2e-3)
        self.assertIn("in space", run("info", file).stdout)
        field = self.summary("info", file, "--certify", "--field", "u")
        self.assertTrue(field)

    def test_values_and_normals_are_those_of_the_graph(self):
        x, y, inside = squares_seen()
        for order in (3, 5):
            for shapes in ("triangles", "quadrilaterals", "mixed"):
                with self.subTest(order=order, shapes=shapes):
                    _, seen = self.shown(self.patches(order, 3, shapes), "--field", "u")
                    np.testing.assert_array_equal(seen["Verdict"] == 1, inside)
                    at = seen["Position"][inside]
                    np.testing.assert_allclose(at[:, 2], height(at[:, 0], at[:, 1]), atol=1e-14)
                    np.testing.assert_allclose(at[:, 0], x[inside], atol=1e-14)
                    np.testing.assert_allclose(seen["Value"][inside], value(x, y)[inside], atol=2e-14)
                    gx, gy = slopes(x[inside], y[inside])
                    normal = np.stack([-gx, -gy, np.ones_like(gx)], axis=1)
                    normal /= np.linalg.norm(normal, axis=1, keepdims=True)
                    found = seen["Normal"][inside]
                    found = found * np.sign(np.sum(found * normal, axis=1))[:, None]
                    np.testing.assert_allclose(found, normal, atol=1e-12)

    def test_flat_elements_of_order_one(self):
        def tilted(x, y):
            return [x, y, 0.5 * x - 0.25 * y]

        x, y, inside = squares_seen()
        made = Patches(1, 4, tilted, "mixed")
        file = self.folder / "flat.vtu"
        file.write_text(plain_grid(made.points, made.cells,
                                   [("u", [2 * a - b for a, b, _ in made.points])]), encoding="utf-8")
        _, seen = self.shown(file)
        np.testing.assert_array_equal(seen["Verdict"] == 1, inside)
        np.testing.assert_allclose(seen["Value"][inside], (2 * x - y)[inside], atol=1e-15)

    def test_contours_are_proven(self):
        x, y, inside = squares_seen()
        levels = [0.5, 1.0, 1.5]
        _, seen = self.shown(self.patches(), "--field", "u", "--contours",
                             ",".join(map(str, levels)))
        crossed = np.any([crossings(level, x, y) for level in levels], axis=0)
        # Only pixels whose neighbours are over the square as well: others see its rim.
        whole = inside.copy()
        whole[1:-1, 1:-1] &= inside[:-2, 1:-1] & inside[2:, 1:-1] & inside[1:-1, :-2] & inside[1:-1, 2:]
        contour = seen["Contour"]
        self.assertFalse(np.any(whole & (contour == 0) & crossed))
        self.assertFalse(np.any(whole & (contour == 1) & ~crossed))
        self.assertLess(np.count_nonzero(contour == 2), 5)
        self.assertGreater(np.count_nonzero(contour == 1), 100)

    def test_integrals_hold_the_closed_forms(self):
        area = over_square(area_element)
        total = over_square(lambda x, y: value(x, y) * area_element(x, y))
        for options in ((), ("--boundary",)):
            rows = self.integrals(self.patches(), "--field", "u", *options)
            for name, exact in (("Area", area), ("Integral", total)):
                row = rows[name]
                self.assertAlmostEqual(row["value"], exact, delta=1e-7)
                self.assertLessEqual(abs(row["value"] - exact), row["error_bound"] + 1e-14)
        # The constant field (0, 0, 1) flows through the projection of the graph.
        flux = self.integrals(self.patches(), "--field", "up")["Flux"]
        self.assertAlmostEqual(flux["value"], 1.0, delta=1e-7)

    def test_probes_find_the_surface_alone(self):
        random = np.random.default_rng(5)
        x, y = random.uniform(0.0, 1.0, (2, 50))
        rows = [(a, b, height(a, b)) for a, b in zip(x, y)]
        rows += [(a, b, height(a, b) + off) for a, b in zip(x[:5], y[:5]) for off in (1e-3, -1e-5, -1e-3)]
        points, out = self.folder / "p.csv", self.folder / "o.csv"
        points.write_text("x,y,z\n" + "\n".join(",".join(repr(float(v)) for v in row) for row in rows),
                          encoding="utf-8")
        self.succeeds("probe", self.patches(), "--field", "u", "--points", points, "--output", out)
        table = read_csv(out)
        verdicts = [row["verdict"] for row in table]
        self.assertEqual(verdicts, ["inside"] * 50 + ["outside"] * 15)
        np.testing.assert_allclose(columns(table[:50])["value"], value(x, y), atol=1e-13)

    def test_expressions_take_values_alone(self):
        x, y, inside = squares_seen()
        _, seen = self.shown(self.patches(), "--field", "u^2 + z*dot(n, up)")
        gx, gy = slopes(x, y)
        exact = value(x, y) ** 2 + height(x, y) / np.sqrt(1 + gx * gx + gy * gy)
        np.testing.assert_allclose(seen["Value"][inside], exact[inside], atol=1e-12)
        for text in ("grad(u).x", "detJ", "mag(curl(up))", "jump(u)"):
            self.fails(1, "render", self.patches(), "--field", text, "--output",
                       self.folder / "no.png", names=["surface in space"])

    def test_a_surface_that_bends_back_over_itself(self):
        """A hairpin: the solid of its one element reaches its other leg."""
        def hairpin(x, y):
            t = 2 * x - 1
            return [1 - t * t, y, 0.03 * t]

        made = Patches(3, 1, hairpin, "quadrilaterals")
        file = self.folder / "hairpin.vtu"
        file.write_text(plain_grid(made.points, made.cells, [("u", [p[2] for p in made.points])]),
                        encoding="utf-8")
        t, y = np.meshgrid(np.linspace(-0.95, 0.95, 20), np.linspace(0.1, 0.9, 5))
        points = np.stack([1 - t * t, y, 0.03 * t], axis=-1).reshape(-1, 3)
        table, out = self.folder / "p.csv", self.folder / "o.csv"
        table.write_text("x,y,z\n" + "\n".join(",".join(map(repr, p)) for p in points.tolist()),
                         encoding="utf-8")
        self.succeeds("probe", file, "--points", table, "--owners", "--output", out)
        rows = read_csv(out)
        self.assertEqual({row["verdict"] for row in rows}, {"inside"})
        self.assertEqual({row["owners"] for row in rows}, {"1"})
        np.testing.assert_allclose(columns(rows)["value"], points[:, 2], atol=1e-12)

    def test_deformed(self):
        """Lifted by u, the graph is that of height + u."""
        area = over_square(lambda x, y: np.sqrt(1 + (0.8 * x - 0.3 * y + 1 + 3 * y * y) ** 2 +
                                                (-0.3 * x + 0.6 * y * y - 2 + 6 * x * y) ** 2))
        rows = self.integrals(self.patches(), "--field", "u", "--warp", "u", "--warp-direction", "0,0,1")
        self.assertAlmostEqual(rows["Area"]["value"], area, delta=1e-6)
        _, seen = self.shown(self.patches(), "--field", "u", "--warp", "u", "--warp-direction", "0,0,1")
        at = seen["Position"][seen["Verdict"] == 1]
        np.testing.assert_allclose(at[:, 2], (height(at[:, 0], at[:, 1]) + value(at[:, 0], at[:, 1])),
                                   atol=2e-14)

    def test_ranges_of_expressions_of_coordinates(self):
        for option in ("--certify", "--extremes"):
            options = ["--certify", "--field", "u*z"] if option == "--certify" else ["--extremes", "u*z"]
            self.fails(1, "info", self.patches(), *options, names=["surface in space", "coordinates"])
        found = self.summary("integrate", self.patches(), "--field", "u*u", "--extremes")
        self.assertTrue(found["surfaces"])

    def test_what_needs_solids_is_refused(self):
        file = self.patches()
        out = ["--output", self.folder / "no.png"]
        for options in (["--plane", "z=0.1"], ["--sphere", "0,0,0,1"], ["--isosurface", "u=1"],
                        ["--faces"]):
            self.fails(1, "render", file, *options, *out, names=["surface in space", "--boundary"])
        self.fails(1, "integrate", file, "--field", "u", "--plane", "z=0.1", names=["surface in space"])
        self.fails(1, "info", file, "--jumps", "u", names=["surface in space"])
        points = self.folder / "p.csv"
        points.write_text("x,y,z\n0,0,0\n", encoding="utf-8")
        self.fails(1, "probe", file, "--points", points, "--gradient", names=["surface in space"])

    def test_a_half_cylinder_of_one_element(self):
        """Its normal turns by 180 degrees within an element; the area is that of the polynomial."""
        def arc(x, y):
            return [-np.cos(np.pi * x), y, np.sin(np.pi * x)]

        made = Patches(8, 1, arc, "quadrilaterals")
        file = self.folder / "arc.vtu"
        file.write_text(plain_grid(made.points, made.cells, [("u", [p[2] for p in made.points])]),
                        encoding="utf-8")
        area = self.integrals(file, "--field", "u")["Area"]["value"]
        self.assertAlmostEqual(area, np.pi, delta=1e-4)
        _, seen = self.shown(file)
        hit = seen["Verdict"] == 1
        self.assertGreater(np.count_nonzero(hit), 1000)
        np.testing.assert_allclose(seen["Value"][hit], seen["Position"][hit][:, 2], atol=1e-13)


GMSH = """$MeshFormat
2.2 0 8
$EndMeshFormat
$PhysicalNames
2
2 3 "left"
2 4 "right"
$EndPhysicalNames
$Nodes
6
1 0 0 0
2 1 0 0
3 1 1 1
4 0 1 1
5 2 0 0
6 2 1 1
$EndNodes
$Elements
2
1 3 2 3 1 1 2 3 4
2 3 2 4 1 2 5 6 3
$EndElements
$NodeData
1
"u"
1
0.0
3
0
1
6
1 0
2 1
3 1
4 0
5 2
6 2
$EndNodeData
"""

MFEM = """MFEM mesh v1.0

dimension
2

elements
2
3 3 0 1 2 3
4 3 1 4 5 2

boundary
0

vertices
6
3
0 0 0
1 0 0
1 1 1
0 1 1
2 0 0
2 1 1
"""
MFEM_FIELD = "FiniteElementSpace\nFiniteElementCollection: H1_2D_P1\nVDim: 1\nOrdering: 0\n\n0\n1\n1\n0\n2\n2\n"


class ShellFormats(ShellTest):
    def files(self):
        gmsh, mesh, field = (self.folder / name for name in ("s.msh", "s.mesh", "u.gf"))
        gmsh.write_text(GMSH, encoding="utf-8")
        mesh.write_text(MFEM, encoding="utf-8")
        field.write_text(MFEM_FIELD, encoding="utf-8")
        return [[gmsh], [mesh, field]]

    def test_parts_by_attributes(self):
        for files in self.files():
            with self.subTest(files[0].name):
                whole = self.integrals(*files, "--field", "u")
                self.assertAlmostEqual(whole["Area"]["value"], 2 * np.sqrt(2), delta=1e-12)
                self.assertAlmostEqual(whole["Integral"]["value"], 2 * np.sqrt(2), delta=1e-9)
                right = self.integrals(*files, "--field", "u", "--boundary=4")
                self.assertAlmostEqual(right["Integral"]["value"], 1.5 * np.sqrt(2), delta=1e-9)

    def test_pictures_of_both_are_the_same(self):
        seen = [self.shown(*files, "--field", "u")[1] for files in self.files()]
        np.testing.assert_array_equal(seen[0]["Value"], seen[1]["Value"])


def beside(points):
    """The unit cube's corners, moved away from the surfaces, after these points."""
    return list(points) + [[x + 2.0, y, z] for x, y, z in CUBE]


class BendingSeries(ShellTest):
    """A series that begins flat, which a plane shows, and then bends."""

    def test_the_command_repeats_all_pictures(self):
        sets = ""
        for step, surface in enumerate((lambda x, y: [x, y, 0.0], graph)):
            made = Patches(3, 2, surface, "mixed")
            fields = [("u", [value(x, y) for x, y, _ in made.points])]
            (self.folder / f"b_{step}.vtu").write_text(plain_grid(made.points, made.cells, fields), encoding="utf-8")
            sets += f'<DataSet timestep="{step}" part="0" file="b_{step}.vtu"/>'
        series = self.folder / "series.pvd"
        series.write_text(f'<VTKFile type="Collection"><Collection>{sets}</Collection></VTKFile>', encoding="utf-8")
        done = self.succeeds("render", series, "--time-step", "all", *VIEW.options(), "--output",
                             self.folder / "f_%d.png", "--json")
        self.assertIn("no surface was given; each picture shows its own mesh", done.stderr)
        command = json.loads(done.stdout)["command"]
        self.assertFalse([word for word in command if word.startswith(("--plane", "--boundary"))])
        self.assertIn("--field", " ".join(command))
        first = [read_image(self.folder / f"f_{step}.png") for step in range(2)]
        repeated = [word.replace("f_%d", "g_%d") for word in command if word != "--json"]
        self.succeeds(*(repeated[1:] if repeated[0].endswith("pixelexact") else repeated))
        for step, picture in enumerate(first):
            np.testing.assert_array_equal(read_image(self.folder / f"g_{step}.png"), picture)
        self.assertFalse(np.array_equal(*first))


class MixedFiles(ShellTest):
    """Files that mix surfaces with solids: these are shown, or the surfaces where they are chosen."""

    def cube(self, first):
        return 12, list(range(first, first + 8))

    def mixed(self):
        made = Patches(3, 3, graph, "mixed")
        points = beside(made.points)
        path = self.folder / "mixed.vtu"
        path.write_text(plain_grid(points, [self.cube(len(made.points)), *made.cells, (3, [0, 1])],
                                   [("u", [value(x, y) for x, y, _ in points])]), encoding="utf-8")
        return path

    def check_surface(self, *files):
        rows = self.integrals(*files, "--field", "u", "--surface-elements")
        total = over_square(lambda x, y: value(x, y) * area_element(x, y))
        self.assertAlmostEqual(rows["Area"]["value"], over_square(area_element), delta=1e-7)
        self.assertAlmostEqual(rows["Integral"]["value"], total, delta=1e-7)

    def test_each_kind_of_a_grid(self):
        file = self.mixed()
        done = self.succeeds("info", file)
        self.assertIn("13 surface elements", done.stderr)
        self.assertIn("--surface-elements", done.stderr)
        self.assertEqual(self.summary("info", file)["shapes"], {"hexahedron": 1})
        chosen = self.summary("info", file, "--surface-elements")
        self.assertEqual(chosen["shapes"], {"triangle": 8, "quadrilateral": 5})
        self.assertEqual(chosen["skipped_cells"], 2)
        self.check_surface(file)
        # Parts of a grid by the cells' attributes.
        made = Patches(3, 3, graph, "mixed")
        kinds = np.arange(len(made.cells)) % 2 + 5
        parts = self.folder / "parts.vtu"
        parts.write_text(plain_grid(made.points, made.cells, (), [("Attribute", kinds.astype(float))]), encoding="utf-8")
        areas = [self.integrals(parts, "--field", "Attribute", f"--boundary={k}")["Area"]["value"] for k in (5, 6)]
        self.assertAlmostEqual(sum(areas), over_square(area_element), delta=1e-7)
        x, y, inside = squares_seen()
        _, seen = self.shown(file, "--field", "u", "--surface-elements")
        np.testing.assert_array_equal(seen["Verdict"] == 1, inside)
        np.testing.assert_allclose(seen["Value"][inside], value(x, y)[inside], atol=2e-14)
        self.assertEqual(np.unique(seen["Element"][inside]).min(), 1)  # the cube is cell 0
        points, out = self.folder / "p.csv", self.folder / "o.csv"
        points.write_text("x,y,z\n2.5,0.5,0.5\n", encoding="utf-8")
        self.succeeds("probe", file, "--field", "u", "--points", points, "--output", out)
        self.assertEqual(read_csv(out)[0]["verdict"], "inside")

    def test_parts_of_which_some_are_surfaces(self):
        made = Patches(3, 3, graph, "mixed")
        texts = {"a": plain_grid(made.points, made.cells, [("u", [value(x, y) for x, y, _ in made.points])]),
                 "b": plain_grid(CUBE, [self.cube(0)], [("u", [0.0] * 8)])}
        for name, text in texts.items():
            (self.folder / f"{name}.vtu").write_text(text, encoding="utf-8")
        whole = self.folder / "whole.pvd"
        whole.write_text('<VTKFile type="Collection"><Collection>' + "".join(
            f'<DataSet timestep="0" part="{k}" file="{name}.vtu"/>' for k, name in enumerate(texts)) +
            "</Collection></VTKFile>", encoding="utf-8")
        done = self.succeeds("info", whole)
        self.assertIn("a.vtu' holds no volume and is left out; --surface-elements", done.stderr)
        self.check_surface(whole)

    def test_gmsh_with_a_volume(self):
        text = GMSH.replace("$Nodes\n6", "$Nodes\n7").replace("6 2 1 1\n$End", "6 2 1 1\n7 0 0 5\n$End", 1)
        text = text.replace("$Elements\n2\n", "$Elements\n3\n3 4 2 9 1 1 2 4 7\n")
        file = self.folder / "m.msh"
        file.write_text(text, encoding="utf-8")
        self.assertIn("--surface-elements", self.succeeds("info", file).stderr)
        self.assertEqual(self.summary("info", file)["shapes"], {"tetrahedron": 1})
        whole = self.integrals(file, "--field", "u", "--surface-elements")
        self.assertAlmostEqual(whole["Integral"]["value"], 2 * np.sqrt(2), delta=1e-9)
        right = self.integrals(file, "--field", "u", "--surface-elements", "--boundary=4")
        self.assertAlmostEqual(right["Integral"]["value"], 1.5 * np.sqrt(2), delta=1e-9)

    def shells(self, solids=True):
        points = beside([[0, 0, 0], [1, 0, 0], [1, 1, 1], [0, 1, 1], [2, 0, 0], [2, 1, 1]])
        blocks = [(7, "SHELL4", [[0, 1, 2, 3]]), (8, "SHELL4", [[1, 4, 5, 2]])]
        blocks += [(3, "HEX8", [list(range(6, 14))])] if solids else []
        path = self.folder / f"shells{solids}.e"
        path.write_bytes(exodus(points, blocks, [("u", [float(p[0]) for p in points])], [("t", {7: [3.0], 8: [5.0]})],
                                names=["web", "flange", "core"][:len(blocks)]))
        return path

    def test_exodus_shells(self):
        for solids in (True, False):
            with self.subTest(solids=solids):
                file = self.shells(solids)
                chosen = ["--surface-elements"] if solids else []
                done = self.succeeds("info", file, *chosen)
                self.assertIn("shells are surfaces without their thickness", done.stderr)
                self.assertEqual(self.summary("info", file, *chosen)["shapes"], {"quadrilateral": 2})
                rows = self.integrals(file, "--field", "u", *chosen, "--boundary=8")
                self.assertAlmostEqual(rows["Integral"]["value"], 1.5 * np.sqrt(2), delta=1e-9)
                rows = self.integrals(file, "--field", "t", *chosen)
                self.assertAlmostEqual(rows["Integral"]["value"], 8 * np.sqrt(2), delta=1e-9)
        whole = self.summary("info", self.shells())
        self.assertEqual(whole["shapes"], {"hexahedron": 1})
        surfaces = self.summary("info", self.shells(), "--surface-elements")
        self.assertEqual(surfaces["boundary_attributes"], {"7": 1, "8": 1})
        self.assertEqual({group["name"]: group["boundary"] for group in surfaces["groups"] if group["id"] != 3},
                         {"web": True, "flange": True})

    def test_without_surfaces(self):
        cube, mesh = self.folder / "cube.vtu", self.folder / "s.mesh"
        cube.write_text(unit_cube_grid(), encoding="utf-8")
        mesh.write_text(MFEM, encoding="utf-8")
        gmsh = self.folder / "v.msh"
        text = GMSH.replace("1 3 2 3 1 1 2 3 4", "1 4 2 3 1 1 2 3 4").replace("2 3 2 4 1 2 5 6 3", "2 4 2 4 1 2 5 6 3")
        gmsh.write_text(text, encoding="utf-8")
        for file in (cube, mesh, gmsh):
            self.fails(1, "info", file, "--surface-elements", names=[file, "leave out --surface-elements"])


if __name__ == "__main__":
    unittest.main()
