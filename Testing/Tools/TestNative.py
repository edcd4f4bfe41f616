# SPDX-License-Identifier: BSD-3-Clause
"""Solvers' own files on the command line."""

import gzip
import json
import unittest

import numpy as np

from tool import DATA, ToolTest, View, columns, read_csv, read_image, run

ZOO = DATA / "mfem49_tinyzoo_g3_p5"
DARCY = DATA / "mfem_escher_tet_darcy_p3"
GMSH = DATA / "gmsh_zoo_g2"
ANISOTROPIC = DATA / "nek_hex_aniso_p3p5p7"


class Native(ToolTest):
    def probe(self, files, field, oracle):
        out = self.folder / "out.csv"
        self.succeeds("probe", *files, "--field", field, "--points", oracle, "--output", out)
        return columns(read_csv(oracle)), columns(read_csv(out))

    def test_mfem_scalar_on_all_shapes(self):
        files = [ZOO / "mfem49_tinyzoo_g3_p5.mesh", ZOO / "u.gf"]
        oracle, found = self.probe(files, "u", ZOO / "oracle_u.csv")
        self.assertEqual(set(found["verdict"]), {"inside"})
        np.testing.assert_allclose(found["value"], oracle["u"], rtol=0, atol=1e-12)

    def test_mfem_vector_elements(self):
        files = [DARCY / "mfem_escher_tet_darcy_p3.mesh", DARCY / "pressure.gf", DARCY / "flux.gf"]
        oracle, found = self.probe(files, "flux", DARCY / "oracle_flux.csv")
        for k in range(3):
            np.testing.assert_allclose(found[f"value_{k}"], oracle[f"u{k}"], rtol=0, atol=1e-11)

    def test_pieces_of_a_nurbs_mesh(self):
        folder = DATA / "mfem_nurbs_pieces"
        files = [folder / f"{name}.000000" for name in ["mesh", "u", "h"]]
        for field in ["u", "h"]:
            oracle, found = self.probe(files, field, folder / f"oracle_{field}.csv")
            self.assertEqual(set(found["verdict"]), {"inside"})
            np.testing.assert_allclose(found["value"], oracle["u"], rtol=0, atol=1e-13)
        summary = self.summary("info", *files)
        self.assertEqual(summary["elements"], 64)
        self.assertEqual({field["continuity"] for field in summary["fields"]}, {"continuous"})

    def test_compressed_files_and_streams(self):
        mesh = (ZOO / "mfem49_tinyzoo_g3_p5.mesh").read_bytes()
        field = (ZOO / "u.gf").read_bytes()
        packed = [self.folder / "zoo.mesh.gz", self.folder / "u.gf.gz"]
        for path, data in zip(packed, [mesh, field]):
            path.write_bytes(gzip.compress(data))
        stream = self.folder / "zoo.saved"
        stream.write_bytes(b"solution\n" + mesh + b"\n" + field + b"\nkeys AaRjlm\n")
        oracle, found = self.probe(packed, "u", ZOO / "oracle_u.csv")
        np.testing.assert_allclose(found["value"], oracle["u"], rtol=0, atol=1e-12)
        oracle, found = self.probe([stream], "solution", ZOO / "oracle_u.csv")
        np.testing.assert_allclose(found["value"], oracle["u"], rtol=0, atol=1e-12)

    def test_gmsh(self):
        file = GMSH / "gmsh_zoo_g2.msh"
        for field in ["u", "d", "m"]:
            oracle, found = self.probe([file], field, GMSH / "oracle.csv")
            np.testing.assert_allclose(found["value"], oracle[field], rtol=0, atol=1e-13)
            np.testing.assert_array_equal(found["element"], oracle["element"])

    def test_gmsh_steps_and_groups(self):
        file = GMSH / "gmsh_zoo_g2.msh"
        text = self.succeeds("info", file, "--time-step", 2).stdout
        for word in ["step 2 of 3", "9 'side' (2 elements)", "3 'floor' (1 face)", "discontinuous"]:
            self.assertIn(word, text)
        out = self.folder / "out.csv"
        self.succeeds("probe", file, "--field", "u", "--time", 0.5, "--points", GMSH / "oracle.csv",
                      "--output", out)
        oracle = columns(read_csv(GMSH / "oracle.csv"))
        # The field of the last step is twice that of the first.
        np.testing.assert_allclose(columns(read_csv(out))["value"], 2 * np.array(oracle["u"]),
                                   rtol=0, atol=1e-13)

    def test_gmsh_mesh_alone(self):
        mesh = self.folder / "straight.msh.gz"
        straight = (DATA / "gmsh_straight_g6" / "gmsh_straight_g6.msh").read_bytes()
        mesh.write_bytes(gzip.compress(straight))
        summary = self.summary("info", mesh)
        self.assertEqual(summary["geometry_orders"], {"6": 4})
        self.assertEqual(summary["fields"], [])
        picture = self.folder / "straight.png"
        self.succeeds("render", mesh, "--plane", "0,0.5,0,0,1,0", "--size", "100x100", "--output",
                      picture)
        self.assertGreater(picture.stat().st_size, 500)

    def test_gmsh_views_in_files_of_their_own(self):
        zoo = (DATA / "gmsh_zoo_g4" / "gmsh_zoo_g4.msh").read_text()
        cut = zoo.index("$NodeData")
        mesh, views = self.folder / "zoo.msh", self.folder / "views.msh"
        mesh.write_text(zoo[:cut])
        views.write_text("$MeshFormat\n4.1 0 8\n$EndMeshFormat\n" + zoo[cut:])
        oracle, found = self.probe([mesh, views], "u", DATA / "gmsh_zoo_g4" / "oracle.csv")
        np.testing.assert_allclose(found["value"], oracle["u"], rtol=0, atol=1e-13)
        self.fails(1, "info", views, names=["views.msh", "no $Nodes"])
        other = self.folder / "other.msh"
        other.write_text(zoo[:cut])
        self.fails(1, "info", mesh, other, names=["other.msh", "mesh of its own"])

    def test_nektar(self):
        name = ANISOTROPIC.name
        files = [ANISOTROPIC / f"{name}.xml", ANISOTROPIC / f"{name}.fld"]
        oracle, found = self.probe(files, "u", ANISOTROPIC / "oracle.csv")
        np.testing.assert_allclose(found["value"], oracle["u"], rtol=0, atol=1e-13)
        np.testing.assert_array_equal(found["element"], oracle["element"])

    def test_nektar_hdf5(self):
        session = DATA / "nek_hdf5" / "Tet_channel_m4_per_hdf5.xml"
        done = run("info", session)
        if "without the HDF5 library" in done.stderr:
            self.skipTest("built without the HDF5 library")
        summary = self.summary("info", session)
        self.assertEqual(summary["shapes"], {"tetrahedron": 6})
        alone = self.summary("info", session.with_suffix(".nekg"))
        self.assertEqual(alone["node_bounds"], summary["node_bounds"])
        name = "nek_tet_varp"
        files = [DATA / name / f"{name}.xml", DATA / "nek_hdf5" / f"{name}.fld"]
        oracle, found = self.probe(files, "u", DATA / name / "oracle.csv")
        np.testing.assert_allclose(found["value"], oracle["u"], rtol=0, atol=1e-13)

    def test_nektar_homogeneous(self):
        folder = DATA / "nek_homogeneous_chan"
        files = [folder / f"{folder.name}.xml", folder / f"{folder.name}.fld"]
        oracle, found = self.probe(files, "u", folder / "oracle.csv")
        np.testing.assert_allclose(found["value"], oracle["u"], rtol=0, atol=1e-13)
        done = self.succeeds("info", *files)
        for word in ["length 1, 8 Fourier functions", "3 layers", "off by at most"]:
            self.assertIn(word, done.stderr)

    def test_info(self):
        name = ANISOTROPIC.name
        files = [ANISOTROPIC / f"{name}.xml", ANISOTROPIC / f"{name}.fld"]
        summary = self.summary("info", *files)
        self.assertEqual(summary["fields"][0]["orders_per_direction"], {"3 x 5 x 7": 8})
        self.assertEqual(summary["fields"][0]["basis"], "Modified_A x Modified_A x Modified_A")
        self.assertEqual(summary["attributes"], {"0": 8})
        self.assertEqual(sum(summary["boundary_attributes"].values()), 24)
        self.assertFalse(summary["converted"])

    def test_groups_in_words(self):
        text = self.succeeds("info", DARCY / "mfem_escher_tet_darcy_p3.mesh", DARCY / "flux.gf").stdout
        for word in ["1 (42 elements)", "1 (1 face)", "36 more", "H(div)"]:
            self.assertIn(word, text)

    def test_picture_of_a_flux(self):
        picture = self.folder / "flux.png"
        self.succeeds("render", DARCY / "mfem_escher_tet_darcy_p3.mesh", DARCY / "flux.gf", "--field",
                      "flux", "--plane", "0,0,0,0,0,1", "--size", "200x200", "--output", picture)
        self.assertGreater(picture.stat().st_size, 1000)

    def test_field_of_another_mesh(self):
        self.fails(1, "info", ZOO / "mfem49_tinyzoo_g3_p5.mesh", DARCY / "pressure.gf",
                   names=["pressure.gf"])


SQUARES = """MFEM mesh v1.0

dimension
2

elements
2
1 3 0 1 2 3
1 3 1 4 5 2

boundary
0

vertices
6
2
0 0
1 0
1.25 1
0 0.75
2 0
2.5 1.25
"""
TRIANGLES = SQUARES.replace("1 3 0 1 2 3", "1 2 0 1 2").replace("1 3 1 4 5 2", "1 2 1 4 5")
CUBE_OF_MFEM = """MFEM mesh v1.0

dimension
3

elements
1
1 5 0 1 2 3 4 5 6 7

boundary
0

vertices
8
3
0 0 0
1 0 0
1 1 0
0 1 0
0 0 1
1 0 1
1 1 1
0 1 1
"""


def quadrature_file(order, rows):
    """As MFEM's QuadratureFunction::Save writes it; rows: the components at each point."""
    rows = np.atleast_2d(np.transpose(rows)).T
    return (f"QuadratureSpace\nType: default_quadrature\nOrder: {order}\nVDim: {rows.shape[1]}\n\n" +
            "\n".join(" ".join(repr(float(v)) for v in row) for row in rows) + "\n")


def values_at(x, y):
    return np.sin(3 * x) + np.exp(y)


class QuadratureFunctions(ToolTest):
    """Values at Gauss-Legendre points, the first coordinate fastest, element by element."""

    def squares(self, order):
        """The files, and the points of both elements."""
        corners = np.array([[0, 0], [1, 0], [1.25, 1], [0, 0.75], [2, 0], [2.5, 1.25]])
        t = (np.polynomial.legendre.leggauss(order // 2 + 1)[0] + 1) / 2
        s, r = (a.ravel() for a in np.meshgrid(t, t, indexing="ij"))
        weights = np.stack([(1 - r) * (1 - s), r * (1 - s), r * s, (1 - r) * s], axis=1)
        points = np.concatenate([weights @ corners[element] for element in ([0, 1, 2, 3], [1, 4, 5, 2])])
        mesh, q, v = (self.folder / name for name in ("s.mesh", "q.gf", "v.gf"))
        mesh.write_text(SQUARES, encoding="utf-8")
        x, y = points.T
        q.write_text(quadrature_file(order, values_at(x, y)), encoding="utf-8")
        v.write_text(quadrature_file(order, np.stack([x * y, values_at(x, y)], axis=1)), encoding="utf-8")
        return [mesh, q, v], points

    def test_values_at_the_points(self):
        for order in (0, 1, 5, 8, 15):
            with self.subTest(order=order):
                files, points = self.squares(order)
                table, out = self.folder / "p.csv", self.folder / "o.csv"
                table.write_text("x,y\n" + "\n".join(f"{x!r},{y!r}" for x, y in points.tolist()), encoding="utf-8")
                self.succeeds("probe", *files, "--field", "q", "--field", "v", "--points", table, "--output", out)
                found = columns(read_csv(out))
                x, y = points.T
                self.assertEqual(set(found["verdict"]), {"inside"})
                np.testing.assert_allclose(found["q"], values_at(x, y), rtol=0, atol=2e-13)
                np.testing.assert_allclose(found["v_0"], x * y, rtol=0, atol=2e-13)
                np.testing.assert_allclose(found["v_1"], values_at(x, y), rtol=0, atol=2e-13)

    def test_info_states_the_points(self):
        files, _ = self.squares(5)
        done = self.succeeds("info", *files)
        self.assertIn("values at 3 Gauss-Legendre points in each direction; between them it is the polynomial",
                      done.stderr)
        self.assertIn("3 Gauss-Legendre points in each direction", done.stdout)

    def test_dots_have_the_colours_of_the_values(self):
        files, points = self.squares(5)
        view = View([1.25, 0.6, 5], [1.25, 0.6, 0], [0, 1, 0], 300, 200, scale=0.9)
        options = ["--field", "q", *view.options(), "--range", "0,5", "--colormap", "grayscale"]
        found = self.summary("render", *files, *options, "--dots", "--output", self.folder / "d.png")
        self.assertEqual(found["dots"], {"field": "q", "points": 18, "visible": 18})
        self.succeeds("render", *files, *options, "--output", self.folder / "e.png")
        done = self.succeeds("render", *files, "--field", "q", "--dots", *view.options(), "--range", "1,2", "--output",
                             self.folder / "f.png")
        beyond = np.count_nonzero((values_at(*points.T) < 1) | (values_at(*points.T) > 2))
        self.assertIn(f"{beyond} dots with values beyond the range", done.stderr)
        picture, plain = (read_image(self.folder / name) for name in ("d.png", "e.png"))
        for x, y in points:
            column, row = int(150 + (x - 1.25) / 0.9 * 100), int(100 + (y - 0.6) / 0.9 * 100)
            exact = 255 * values_at(x, y) / 5
            self.assertAlmostEqual(float(picture[row, column, 0]), exact, delta=1.0)
            around = (slice(row - 4, row + 5), slice(column - 4, column + 5))
            self.assertFalse(np.array_equal(picture[around], plain[around]))

    def test_dots_that_a_surface_hides(self):
        mesh, q = self.folder / "c.mesh", self.folder / "q.gf"
        mesh.write_text(CUBE_OF_MFEM, encoding="utf-8")
        q.write_text(quadrature_file(3, np.arange(8.0)), encoding="utf-8")
        options = ["render", mesh, q, "--dots", "--plane", "0,0,0.5,0,0,1", "--view", "+z", "--size", "100x100"]
        for clip, visible in (([], 4), (["--clip", "0.5,0,0,1,0,0"], 2)):
            for name in ("a.png", "a.svg"):
                found = self.summary(*options, *clip, "--output", self.folder / name)
                self.assertEqual((found["dots"]["points"], found["dots"]["visible"]), (8, visible))

    def test_a_stream(self):
        files, _ = self.squares(3)
        stream = self.folder / "q.saved"
        stream.write_text("quadrature\n" + files[0].read_text(encoding="utf-8") + "\n" +
                          files[1].read_text(encoding="utf-8"), encoding="utf-8")
        self.assertEqual(self.summary("info", stream)["fields"][0]["name"], "solution")

    def test_a_collection(self):
        """Quadrature functions that are not read are left out of it."""
        files, _ = self.squares(3)
        root, folder = self.folder / "run_0.mfem_root", self.folder / "run_0"
        folder.mkdir()
        root.write_text(json.dumps({"dsets": {"main": {
            "cycle": 0, "time": 0.5, "time_step": 0.5, "domains": 1,
            "mesh": {"path": "run_0/mesh.%06d", "tags": {}},
            "fields": {"q": {"path": "run_0/q.%06d", "tags": {"assoc": "elements", "comps": "1"}}}}}}),
            encoding="utf-8")
        (folder / "q.000000").write_bytes(files[1].read_bytes())
        for mesh, fields in ((SQUARES, ["q"]), (TRIANGLES, [])):
            (folder / "mesh.000000").write_text(mesh, encoding="utf-8")
            found = self.succeeds("info", root)
            self.assertEqual([field["name"] for field in self.summary("info", root)["fields"]], fields)
            self.assertEqual("It is left out" in found.stderr, not fields)

    def test_what_is_refused(self):
        files, _ = self.squares(3)
        mesh, q = files[:2]
        triangle = self.folder / "t.mesh"
        triangle.write_text(TRIANGLES, encoding="utf-8")
        self.fails(1, "info", triangle, q, names=["q.gf", "quadrilaterals and hexahedra", "project the function to L2"])
        alone = self.folder / "q.000000"
        alone.write_bytes(q.read_bytes())
        self.fails(1, "info", alone, names=["q.000000", "name the mesh before it"])
        self.fails(1, "render", mesh, self.field_of_nodes(), "--field", "u", "--plane", "z=0", "--dots", "-o",
                   self.folder / "no.png", names=["--dots", "quadrature function"])
        text = q.read_text(encoding="utf-8")
        for changed, names in ((text.replace("QuadratureSpace", "FaceQuadratureSpace"), ["on faces", "project"]),
                               (text + "7\n", ["q.gf"]), (text.replace("Order: 3", "Order: -3"), ["q.gf", "order"]),
                               (text.replace("Order: 3", "Order: 999"), ["q.gf"]),
                               (text.replace("default_quadrature", "other"), ["default_quadrature"])):
            q.write_text(changed, encoding="utf-8")
            self.fails(1, "info", mesh, q, names=names)

    def field_of_nodes(self):
        path = self.folder / "u.gf"
        path.write_text("FiniteElementSpace\nFiniteElementCollection: H1_2D_P1\nVDim: 1\nOrdering: 0\n\n" +
                        "1\n" * 6, encoding="utf-8")
        return path


if __name__ == "__main__":
    unittest.main()
