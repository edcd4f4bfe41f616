# SPDX-License-Identifier: BSD-3-Clause
"""Two-dimensional meshes, and the pieces of parallel runs, on the command line."""

import json
import math
import unittest

import numpy as np

from tool import DATA, ToolTest, columns, plain_grid, read_buffers, read_csv, run

KOVASZNAY = DATA / "nek_plane_kovasznay_p7"


def square(left):
    """The unit square right of x = left, as MFEM's text."""
    corners = "\n".join(f"{left + x} {y}" for x, y in ((0, 0), (1, 0), (1, 1), (0, 1)))
    return (f"MFEM mesh v1.0\n\ndimension\n2\n\nelements\n1\n1 3 0 1 2 3\n\nboundary\n1\n7 1 0 1\n\n"
            f"vertices\n4\n2\n{corners}\n")


def linear(left, slope=1.0):
    """slope x + 10 y on it."""
    values = [slope * (left + x) + 10 * y for x, y in ((0, 0), (1, 0), (1, 1), (0, 1))]
    return ("FiniteElementSpace\nFiniteElementCollection: H1_2D_P1\nVDim: 1\nOrdering: 0\n\n" +
            "\n".join(map(str, values)) + "\n")


class PlaneTest(ToolTest):
    def write(self, name, text):
        path = self.folder / name
        path.parent.mkdir(exist_ok=True)
        path.write_text(text, encoding="utf-8")
        return path

    def mfem(self):
        return [self.write("a.mesh", square(0)), self.write("u.gf", linear(0))]

    def points(self):
        return self.write("points.csv", "x,y\n0.25,0.5\n0.75,0.125\n1.5,0.5\n")


class Plane(PlaneTest):
    def test_info_says_two_dimensions(self):
        summary = self.summary("info", *self.mfem())
        self.assertEqual(summary["dimension"], 2)
        self.assertEqual(summary["shapes"], {"quadrilateral": 1})
        self.assertEqual(summary["slab"], {"z": 0.0, "thickness": 1 / 32})
        self.assertEqual(summary["fields"][0]["orders_per_direction"], {"1": 1})
        self.assertEqual(summary["boundary_attributes"], {"7": 1})
        done = run("info", *self.mfem())
        self.assertIn("2-D, at z = 0", done.stdout)

    def test_shapes_are_those_of_the_plane(self):
        points = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 1.0, 0.0], [2.0, 0.0, 0.0]]
        cells = [(5, [0, 1, 2]), (5, [1, 3, 2]), (5, [1, 3, 4])]  # the last one is clockwise
        done = self.succeeds("info", self.write("a.vtu", plain_grid(points, cells)))
        self.assertIn("3 triangles", done.stdout)
        self.assertIn("of shape triangle are inside out", done.stderr)
        self.assertNotIn("prism", done.stdout + done.stderr)

    def test_shown_without_a_plane(self):
        done = run("render", *self.mfem(), "--size", "60x60", "--buffers", "cut.vti",
                   folder=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("--plane 0,0,0,0,0,1", done.stderr)
        buffers = read_buffers(self.folder / "cut.vti")
        exact = buffers["Verdict"] == 1
        self.assertGreater(np.count_nonzero(exact), 2500)
        self.assertEqual(np.count_nonzero(buffers["Verdict"] == 2), 0)
        x = buffers["Position"][exact]
        np.testing.assert_array_equal(x[:, 2], 0.0)
        np.testing.assert_allclose(buffers["Value"][exact], x[:, 0] + 10 * x[:, 1], rtol=0,
                                   atol=1e-14)

    def test_probed_with_two_columns(self):
        out = self.folder / "out.csv"
        self.succeeds("probe", *self.mfem(), "--points", self.points(), "--output", out,
                      "--gradient")
        found = columns(read_csv(out))
        np.testing.assert_array_equal(found["z"], 0.0)
        np.testing.assert_allclose(found["value"][:2], [5.25, 2.0], rtol=0, atol=1e-15)
        self.assertEqual(list(found["verdict"]), ["inside", "inside", "outside"])
        np.testing.assert_allclose(found["value_z"][:2], 0.0, atol=1e-13)
        self.succeeds("probe", *self.mfem(), "--line", "0,0.5,1,0.5,3", "--output", out)
        np.testing.assert_allclose(columns(read_csv(out))["value"], [5.0, 5.5, 6.0], atol=1e-15)
        solid = DATA / "escher_tet_g3_p3.vtu"
        self.fails(1, "probe", solid, "--points", self.points(), names=["line 1", "'z'"])
        self.fails(2, "probe", solid, "--line", "0,0.5,1,0.5,3", names=["3-D", "x0,y0,z0"])

    def test_triangles_of_vtk(self):
        # A quadratic triangle with a curved edge, in z = 2; u = x^2 - x y at the nodes.
        nodes = [[0, 0, 2], [1, 0, 2], [0, 1, 2], [0.5, 0, 2], [0.5, 0.5, 2], [0, 0.5, 2]]
        u = [x * x - x * y for x, y, _ in nodes]
        file = self.write("t.vtu", plain_grid(nodes, [(22, list(range(6)))], [("u", u)]))
        summary = self.summary("info", file)
        self.assertEqual((summary["dimension"], summary["slab"]["z"]), (2, 2.0))
        self.assertEqual(summary["shapes"], {"triangle": 1})
        self.assertEqual(summary["stored_geometry_orders"], {"2": 1})
        self.assertEqual(summary["geometry_orders"], {"1": 1})
        out = self.folder / "out.csv"
        self.succeeds("probe", file, "--points", self.points(), "--output", out)
        found = columns(read_csv(out))
        np.testing.assert_array_equal(found["z"], 2.0)
        np.testing.assert_allclose(found["value"][:2], [0.0625 - 0.125, 0.5625 - 0.75 / 8],
                                   atol=1e-15)

    def test_nektar_meets_the_exact_solution(self):
        """Kovasznay's flow at Re = 40, by 12 elements of order 7."""
        rate = 20 - math.sqrt(400 + 4 * math.pi**2)
        random = np.random.default_rng(7)
        x, y = random.uniform(-0.5, 1.0, 300), random.uniform(-0.5, 1.5, 300)
        points = self.write("p.csv", "x,y\n" + "\n".join(f"{a!r},{b!r}" for a, b in
                                                         zip(x.tolist(), y.tolist())))
        name = KOVASZNAY.name
        files = [KOVASZNAY / f"{name}.xml", KOVASZNAY / f"{name}.rst"]
        for field, exact in (("u", 1 - np.exp(rate * x) * np.cos(2 * math.pi * y)),
                             ("v", rate / (2 * math.pi) * np.exp(rate * x) *
                              np.sin(2 * math.pi * y))):
            out = self.folder / "out.csv"
            self.succeeds("probe", *files, "--field", field, "--points", points, "--output", out)
            found = columns(read_csv(out))
            self.assertEqual(set(found["verdict"]), {"inside"})
            np.testing.assert_allclose(found["value"], exact, rtol=0, atol=1e-5)


class Pieces(PlaneTest):
    def pieces(self):
        for k in (0, 1):
            self.write(f"mesh.00000{k}", square(k))
            self.write(f"u.00000{k}", linear(k))
        return [self.folder / "mesh.000000", self.folder / "u.000000"]

    def test_one_stands_for_all(self):
        files = self.pieces()
        everything = [self.folder / f"{name}.00000{k}" for name in ("mesh", "u") for k in (0, 1)]
        for given in (files, everything):
            summary = self.summary("info", *given)
            self.assertEqual(summary["elements"], 2)
            self.assertEqual([field["name"] for field in summary["fields"]], ["u"])
        out = self.folder / "out.csv"
        self.succeeds("probe", *files, "--points", self.points(), "--output", out)
        np.testing.assert_allclose(columns(read_csv(out))["value"], [5.25, 2.0, 6.5], atol=1e-15)
        # What is between the pieces is no boundary.
        done = run("render", *files, "--edges", "2", "--edges-by-kind", "--size", "60x40",
                   "--buffers", "cut.vti", folder=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        (self.folder / "u.000001").unlink()
        self.fails(1, "info", *files, names=["u.000001 is missing"])
        (self.folder / "mesh.000000").unlink()
        self.fails(1, "info", self.folder / "mesh.000001", names=["mesh.000000 is missing"])

    def test_root_files_are_time_steps(self):
        roots = []
        for cycle, time in ((0, 0.0), (10, 0.5)):
            run_folder = f"run_{cycle:06d}"
            self.write(f"{run_folder}/mesh.000000", square(0))
            self.write(f"{run_folder}/u.000000", linear(0, slope=1 + time))
            tags = {"assoc": "nodes", "comps": "1"}
            main = {"cycle": cycle, "time": time, "domains": 1,
                    "mesh": {"path": f"{run_folder}/mesh.%06d", "tags": {}},
                    "fields": {"u": {"path": f"{run_folder}/u.%06d", "tags": tags}}}
            roots.append(self.write(f"{run_folder}.mfem_root", json.dumps({"dsets":
                                                                           {"main": main}})))
        self.assertEqual(self.summary("info", *reversed(roots))["times"], [0.0, 0.5])
        out = self.folder / "out.csv"
        for step, slope in enumerate((1.0, 1.5)):
            self.succeeds("probe", *roots, "--time-step", str(step), "--points", self.points(),
                          "--output", out)
            found = columns(read_csv(out))
            np.testing.assert_allclose(found["value"][0], slope * 0.25 + 5, atol=1e-15)
        self.fails(1, "info", roots[0], roots[0].with_name("run_000010.mfem_root"),
                   roots[1].with_name("other.mfem_root"), names=["other.mfem_root"])


if __name__ == "__main__":
    unittest.main()
