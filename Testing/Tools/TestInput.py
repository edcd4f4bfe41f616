# SPDX-License-Identifier: BSD-3-Clause
"""Input files that are missing, damaged or of the wrong kind end with status 1 and one message."""

import os
import re
import unittest

import numpy as np

from tool import CASES, DATA, ToolTest, case, plain_grid, read_csv, run, unit_cube_grid


class FileTest(ToolTest):
    def write(self, name, text):
        path = self.folder / name
        if isinstance(text, bytes):
            path.write_bytes(text)
        else:
            path.write_text(text, encoding="utf-8")
        return path

    def refuses(self, path, *names):
        self.fails(1, "info", path, names=[path, *names])


class BadFiles(FileTest):
    def test_paths(self):
        self.refuses(self.folder / "absent.vtu", "no such file")
        self.refuses(self.folder, "folder")
        folder = self.folder / "folder.vtu"
        folder.mkdir()
        self.refuses(folder, "folder")
        self.refuses(self.write("empty.vtu", ""), "empty")
        self.refuses(self.write("mesh.stl", "solid"), ".vtu")
        self.refuses(self.write("mesh", "solid"), ".vtu")

    def test_unknown_suffixes_are_recognised_by_the_beginning(self):
        self.refuses(self.write("grid.dat", unit_cube_grid()), "VTK XML (.vtu)")
        self.refuses(self.write("mesh.dat", "MFEM mesh v1.0\n"), "MFEM (.mesh)")
        self.refuses(self.write("gmsh", "$MeshFormat\n4.1 0 8\n"), "Gmsh (.msh)")
        self.refuses(self.write("hdf.dat", b"\x89HDF\r\n\x1a\n"), "VTKHDF (.vtkhdf)")
        self.refuses(self.write("table.txt", "time,solution\nMFEM 1\n"), "none of the marks")
        self.refuses(self.folder / "table.txt", "'HDF' (VTKHDF; Exodus II; CGNS; FLEXI, HOPR), 'CDF' (Exodus II)")

    def test_pipes_without_a_writer(self):
        """Nobody is waited for, whatever the suffix, and wherever the pipe stands."""
        for suffix in (".vtu", ".pvtu", ".pvd", ".vtk", ".e", ".e.1.0", ".g", ".cgns", ".mesh", ".mfem_root",
                       ".000000", ".saved", ".msh", ".xml", ".nekg"):
            pipe = self.folder / f"pipe{suffix}"
            os.mkfifo(pipe)
            self.refuses(pipe, "device")
        pipe = self.folder / "pipe.gf"
        os.mkfifo(pipe)
        self.fails(1, "info", DATA / "mfem49_tinyzoo_g3_p5" / "mfem49_tinyzoo_g3_p5.mesh", pipe, names=[pipe, "device"])
        collection = self.write("a.pvd", '<VTKFile type="Collection"><Collection><DataSet timestep="0" '
                                         'file="pipe.vtu"/></Collection></VTKFile>')
        self.fails(1, "info", collection, names=["pipe.vtu", "device"])
        pieces = self.write("a.pvtu", '<VTKFile type="PUnstructuredGrid"><PUnstructuredGrid>'
                                      '<Piece Source="pipe.vtu"/></PUnstructuredGrid></VTKFile>')
        self.fails(1, "info", pieces, names=["pipe.vtu", "device"])
        for suffix in (".stl", ".vtp"):
            pipe = self.folder / f"pipe{suffix}"
            os.mkfifo(pipe)
            self.fails(1, "render", case("dolfinx_hex_g2_p4"), "--surface", pipe, "--output",
                       self.folder / "a.png", names=[pipe, "device"])
        pipe = self.folder / "pipe.csv"
        os.mkfifo(pipe)
        self.fails(1, "probe", case("dolfinx_hex_g2_p4"), "--points", pipe, "--output", self.folder / "a.csv",
                   names=[pipe, "writes"])

    @unittest.skipIf(os.geteuid() == 0, "everything is readable to root")
    def test_permissions(self):
        path = self.write("secret.vtu", unit_cube_grid())
        path.chmod(0)
        self.refuses(path, "permissions")

    def test_noise_in_solvers_files(self):
        for suffix in ["mesh", "msh", "saved", "xml"]:
            self.refuses(self.write("text." + suffix, "x"))
            self.refuses(self.write("noise." + suffix, bytes(range(256)) * 10))

    def test_field_files_need_their_mesh(self):
        for suffix in ["gf", "fld", "chk", "rst"]:
            path = self.write("field." + suffix, "x")
            self.fails(2, "info", path, names=[path, "mesh"])

    def test_wrong_content(self):
        self.refuses(self.write("noise.vtu", bytes(range(256)) * 10))
        self.refuses(self.write("text.vtu", "no XML here\n"))
        self.refuses(self.write("other.vtu", "<html><body>404</body></html>"))
        self.refuses(self.write("noise.vtk", bytes(range(256)) * 10))
        self.refuses(self.write("text.vtk", "no VTK here\n"))
        other = unit_cube_grid().replace("UnstructuredGrid", "PolyData")
        self.refuses(self.write("polydata.vtu", other))
        image = (
            "# vtk DataFile Version 3.0\nx\nASCII\nDATASET STRUCTURED_POINTS\nDIMENSIONS 1 1 1\n"
            "ORIGIN 0 0 0\nSPACING 1 1 1\n"
        )
        self.refuses(self.write("image.vtk", image))

    def test_malformed_xml(self):
        sound = unit_cube_grid()
        for find, replacement in [
            ("</Points>", ""),
            ("</VTKFile>", ""),
            ("<Cells>", "<Cells"),
            ('Name="connectivity"', 'Name="connect"'),
            ('Name="offsets"', 'Name="off"'),
            ('Name="types"', 'Name="type"'),
            ('NumberOfPoints="8"', 'NumberOfPoints="9"'),
            ('NumberOfPoints="8"', 'NumberOfPoints="7"'),
            ('NumberOfPoints="8"', 'NumberOfPoints="-8"'),
            ('NumberOfPoints="8"', 'NumberOfPoints="many"'),
            ('NumberOfCells="1"', 'NumberOfCells="2"'),
            ('NumberOfCells="1"', 'NumberOfCells="1000000"'),
            ('type="Float64" Name="Points"', 'type="Quadruple" Name="Points"'),
            ('format="ascii"', 'format="binary"'),
        ]:
            with self.subTest(find=find, replacement=replacement):
                self.assertIn(find, sound)
                self.refuses(self.write("damaged.vtu", sound.replace(find, replacement, 1)))

    def test_cells_beyond_the_points(self):
        points = np.eye(4, 3)
        for ids in [[0, 1, 2, 4], [0, 1, 2, -1], [0, 1, 2, 10**12]]:
            path = self.write("beyond.vtu", plain_grid(points, [(10, ids)]))
            self.refuses(path, "point")
        # A cell with fewer points than its type has.
        self.fails(1, "info", self.write("few.vtu", plain_grid(points, [(10, [0, 1, 2])])))
        self.fails(1, "info", self.write("few.vtu", plain_grid(points, [(71, [0, 1, 2, 3, 0])])))

    def test_arrays_of_wrong_size(self):
        points = np.eye(4, 3)
        for size in [0, 1, 3]:
            fields = [("u", np.arange(float(size)))]
            self.refuses(self.write("size.vtu", plain_grid(points, [(10, [0, 1, 2, 3])], fields)))

    def test_coordinates_that_are_no_numbers(self):
        for bad in ["nan", "inf", "-inf"]:
            points = np.eye(4, 3)
            text = plain_grid(points, [(10, [0, 1, 2, 3])])
            text = text.replace("1.0 0.0 0.0", f"{bad} 0.0 0.0", 1)
            done = run("info", self.write("nan.vtu", text))
            self.assertIn(done.returncode, [0, 1])
            self.assertNotEqual(done.stdout + done.stderr, "")

    def test_legacy_files(self):
        head = "# vtk DataFile Version 3.0\nx\nASCII\nDATASET UNSTRUCTURED_GRID\n"
        points = "POINTS 4 double\n0 0 0 1 0 0 0 1 0 0 0 1\n"
        cells = "CELLS 1 5\n4 0 1 2 3\nCELL_TYPES 1\n10\n"
        field = "POINT_DATA 4\nSCALARS u double 1\nLOOKUP_TABLE default\n0 1 2 3\n"
        sound = self.write("sound.vtk", head + points + cells + field)
        self.assertIn("u", self.succeeds("info", sound).stdout)
        self.refuses(self.write("cut.vtk", head + points[:30]))
        self.refuses(self.write("ids.vtk", head + points + cells.replace("2 3", "2 7")), "point")

    def test_legacy_file_cut_short(self):
        head = "# vtk DataFile Version 3.0\nx\nASCII\nDATASET UNSTRUCTURED_GRID\n"
        points = "POINTS 4 double\n0 0 0 1 0 0 0 1 0 0 0 1\n"
        text = head + points + "CELLS 1 5\n4 0 1 2 3\nCELL_TYPES 1\n10\n"
        for length in range(0, len(text), 7):
            done = run("info", self.write("cut.vtk", text[:length]))
            self.assertIn(done.returncode, [0, 1], f"{length}: {done.stderr}")


class Nodes(FileTest):
    """Lagrange cells whose nodes are not where VTK has them."""

    def test_gauss_lobatto_nodes(self):
        # A hexahedron of order 3, [0,1]^3, with u = x^3; nodes by VTK's classes.
        from vtkmodules.vtkCommonDataModel import vtkLagrangeHexahedron

        g = [0.0, (1 - 5**-0.5) / 2, (1 + 5**-0.5) / 2, 1.0]
        points = np.zeros((64, 3))
        for i, j, k in np.ndindex(4, 4, 4):
            index = vtkLagrangeHexahedron.PointIndexFromIJK(i, j, k, [3, 3, 3])
            points[index] = g[i], g[j], g[k]
        text = plain_grid(points, [(72, list(range(64)))], [("u", points[:, 0] ** 3)])
        # VTK's readers renumber the nodes of files before version 2.2.
        path = self.write("gll.vtu", text.replace('"1.0" byte_order', '"2.2" byte_order'))
        self.assertIn("--nodes gll", self.succeeds("info", path).stderr)
        self.assertEqual(self.succeeds("info", path, "--nodes", "gll").stderr, "")
        at = self.write("points.csv", "x,y,z\n.3,.4,.6\n")
        out = self.folder / "out.csv"
        probe = ["probe", path, "--field", "u", "--points", at, "--output", out]
        self.succeeds(*probe, "--nodes", "gll")
        self.assertAlmostEqual(float(read_csv(out)[0]["value"]), 0.3**3, delta=1e-15)
        self.succeeds(*probe, "--nodes", "equispaced")
        self.assertGreater(abs(float(read_csv(out)[0]["value"]) - 0.3**3), 1e-3)
        self.fails(2, "info", path, "--nodes", "fekete", names=["--nodes"])

    def test_mirrored_wedges_that_are_not_there(self):
        path = self.write("cube.vtu", unit_cube_grid())
        done = self.succeeds("info", path, "--mirrored-wedges")
        self.assertIn("--mirrored-wedges has no effect", done.stderr)
        prisms = DATA / "toroid_prism_g3_p4.vtu"
        self.assertNotIn("no effect", self.succeeds("info", prisms, "--mirrored-wedges").stderr)

    def test_coefficients_have_no_nodes(self):
        folder = DATA / "mfem49_tinyzoo_g3_p5"
        mesh = folder / f"{folder.name}.mesh"
        self.fails(1, "info", mesh, "--nodes", "gll", names=[mesh, "--nodes"])
        self.fails(1, "info", mesh, "--mirrored-wedges", names=[mesh, "--mirrored-wedges"])


class Warnings(FileTest):
    """What VTK warns of is handed on, and the file is read."""

    KEY = "Could not locate key vtkUnknownReader::GLOBAL_TEMPORAL_VARIABLE"

    def reads_with_a_warning(self, path):
        done = self.succeeds("info", path)
        self.assertEqual(done.stderr.count(self.KEY), 1, done.stderr)
        self.assertIn(f"pixelexact: warning: '{path}': ", done.stderr)
        self.assertIn("u: scalar", done.stdout)
        self.assertEqual(len(self.summary("info", path)["diagnostics"]), 1)

    def test_keys_of_modules_that_are_not_there(self):
        # As ParaView saves what readers of its own have read.
        key = (
            '<InformationKey name="GLOBAL_TEMPORAL_VARIABLE" location="vtkUnknownReader">0'
            "</InformationKey>\n</DataArray>"
        )
        text = unit_cube_grid([("u", np.arange(8.0)), ("v", np.arange(8.0))])
        head, points = text.split("</PointData>")
        text = head.replace("</DataArray>", key) + "</PointData>" + points
        self.reads_with_a_warning(self.write("exodus.vtu", text))
        # The one that many of ParaView's files have.
        path = self.write("known.vtu", text.replace("vtkUnknownReader", "vtkExodusIIReader"))
        self.assertNotIn("locate key", self.succeeds("info", path).stderr)
        head = "# vtk DataFile Version 5.1\nx\nASCII\nDATASET UNSTRUCTURED_GRID\n"
        points = "POINTS 4 double\n0 0 0 1 0 0 0 1 0 0 0 1\n"
        cells = (
            "CELLS 2 4\nOFFSETS vtktypeint64\n0 4\nCONNECTIVITY vtktypeint64\n0 1 2 3\n"
            "CELL_TYPES 1\n10\n"
        )
        field = (
            "POINT_DATA 4\nSCALARS u double 1\nLOOKUP_TABLE default\n0 1 2 3\nMETADATA\n"
            "INFORMATION 1\nNAME GLOBAL_TEMPORAL_VARIABLE LOCATION vtkUnknownReader\nDATA 0\n\n"
        )
        self.reads_with_a_warning(self.write("exodus.vtk", head + points + cells + field))

    def test_data_that_cannot_be_read_stay_an_error(self):
        head = "# vtk DataFile Version 3.0\nx\nASCII\nDATASET UNSTRUCTURED_GRID\n"
        points = "POINTS 4 double\n0 0 0 1 0 0 0 1 0 0 0 1\n"
        cells = "CELLS 1 5\n4 0 1 2 3\nCELL_TYPES 1\n10\n"
        field = "POINT_DATA 4\nSCALARS u double 1\nLOOKUP_TABLE default\n0 1 "
        for rest in ["", "x 3\n", "2,5 3\n", "2.5x 3\n"]:
            self.refuses(self.write("field.vtk", head + points + cells + field + rest))
        for broken in ["0,5", "0.5x", "x"]:
            text = head + points.replace("0 1 0", f"0 {broken} 0") + cells
            self.refuses(self.write("points.vtk", text))
            sound = unit_cube_grid()
            self.refuses(self.write("points.vtu", sound.replace("1.0 0.0 0.0", f"1.0 {broken} 0.0")))


class Truncated(ToolTest):
    def test_every_file_at_many_lengths(self):
        for name in CASES:
            content = case(name).read_bytes()
            path = self.folder / "cut.vtu"
            lengths = np.unique(np.linspace(1, len(content) - 12, 24).astype(int))
            # Also inside of each of the file's tags.
            tags = [match.end() - 3 for match in re.finditer(rb"<[^>]*>", content)]
            for length in [*lengths, *tags]:
                if length >= len(content) - 2:
                    continue
                path.write_bytes(content[:length])
                done = run("info", path)
                self.assertEqual(done.returncode, 1, f"{name} cut at {length}: {done.stdout}")
                self.assertIn(str(path), done.stderr)
                self.assertLess(len(done.stderr.splitlines()), 2, done.stderr)

    def test_damaged_bytes(self):
        """Whatever a damaged file holds, the tool ends by itself: done, or with a message."""
        random = np.random.default_rng(7)
        content = bytearray(case("escher_tet_g3_p3").read_bytes())
        path = self.folder / "damaged.vtu"
        for _ in range(60):
            damaged = bytearray(content)
            for position in random.integers(0, len(content), 3):
                damaged[position] = random.integers(1, 256)
            path.write_bytes(damaged)
            done = run("info", path)
            self.assertIn(done.returncode, [0, 1], done.stderr)
            if done.returncode == 1:
                self.assertIn(str(path), done.stderr)


class EmptyMesh(FileTest):
    """Without a volume or a plane there is nothing to cut, and every command says so."""

    def refused_by_all(self, path, why):
        points = self.write("points.csv", "x,y,z\n0,0,0\n")
        field = [path, "--field", "u", "--output", self.folder / "out.png"]
        self.refuses(path, why)
        self.fails(1, "probe", *field, "--points", points, names=[path, why])
        self.fails(1, "render", *field, "--plane", "0,0,0,0,0,1", names=[path, why])

    def test_empty_mesh(self):
        self.refused_by_all(self.write("empty.vtu", plain_grid([], [])),
                            "no two- or three-dimensional cell")

    def test_values_at_quadrature_points(self):
        """What VTK's interpolator writes: values as field data, and where those of a cell begin."""
        text = plain_grid(np.eye(4, 3), [(10, [0, 1, 2, 3])], [("u", np.arange(4.0))])
        text = text.replace("<UnstructuredGrid>", """<UnstructuredGrid>
            <FieldData><DataArray type="Float64" Name="q" NumberOfTuples="1" format="ascii">7
            <InformationKey name="QUADRATURE_OFFSET_ARRAY_NAME" location="vtkQuadratureSchemeDefinition">Offset
            </InformationKey></DataArray></FieldData>""")
        text = text.replace("<CellData>", """<CellData><DataArray type="Int64" Name="Offset" format="ascii">0
            <InformationKey name="DICTIONARY" location="vtkQuadratureSchemeDefinition"><vtkQuadratureSchemeDefinition>
            <CellType value="10"/><NumberOfNodes value="4"/><NumberOfQuadraturePoints value="1"/>
            <ShapeFunctionWeights>0.25 0.25 0.25 0.25</ShapeFunctionWeights><QuadratureWeights>1</QuadratureWeights>
            </vtkQuadratureSchemeDefinition></InformationKey></DataArray>""")
        path = self.write("points.vtu", text)
        done = self.succeeds("info", path)
        self.assertIn("'q' holds values at quadrature points, which are not read", done.stderr)
        self.assertEqual([field["name"] for field in self.summary("info", path)["fields"]], ["u"])

    def test_curves_alone(self):
        path = self.write("beam.vtu", plain_grid(np.eye(3), [(3, [0, 1]), (21, [0, 1, 2])]))
        self.refused_by_all(path, "curves are not drawn: make tubes of them")

    def test_cells_of_lower_dimension_are_skipped_and_counted(self):
        points = np.eye(4, 3)
        cells = [(5, [0, 1, 2]), (10, [0, 1, 2, 3]), (3, [0, 1])]
        path = self.write("mixed.vtu", plain_grid(points, cells, [("u", np.arange(4.0))]))
        summary = self.summary("info", path)
        self.assertEqual((summary["elements"], summary["skipped_cells"]), (1, 2))
        centre = self.write("points.csv", "x,y,z\n.2,.2,.2\n")
        out = self.folder / "out.csv"
        self.succeeds("probe", path, "--field", "u", "--points", centre, "--output", out)
        # The number of the cell in the file.
        self.assertEqual(read_csv(out)[0]["element"], "1")


if __name__ == "__main__":
    unittest.main()
