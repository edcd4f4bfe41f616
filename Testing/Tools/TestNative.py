# SPDX-License-Identifier: BSD-3-Clause
"""Solvers' own files on the command line."""

import gzip
import unittest

import numpy as np

from tool import DATA, ToolTest, columns, read_csv, run

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


if __name__ == "__main__":
    unittest.main()
