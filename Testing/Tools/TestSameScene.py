# SPDX-License-Identifier: BSD-3-Clause
"""One scene by the program and by Python: the same buffers, byte for byte; the same files read, and the
same words where they are refused."""

import re
import unittest
import warnings

import numpy as np
import pixelexact
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkLookupTable
from vtkmodules.vtkCommonDataModel import vtkSphere

from tool import CUBE, DATA, ToolTest, case, read_buffers, run, unit_cube_grid

SIZE = (90, 70)
BUFFERS = ("Value", "Verdict", "Element", "Contour", "Color")


def vectors():
    """The cube with a vector whose components, magnitude and their ranges all differ."""
    rows = [[0.5 + x, 3.0 * y - 1.0, 2.0 * z + x * y] for x, y, z in CUBE]
    return unit_cube_grid([("w", [x - 0.2 for x, _, _ in CUBE]), ("displacement", rows)])


class SameScene(ToolTest):
    def compare(self, source, field, words, options):
        """What both make of a scene; `words`, `options`: of the program and of Python."""
        buffers = self.folder / "b.vti"
        summary = self.summary(
            "render", source, "--field", field, "--size", f"{SIZE[0]}x{SIZE[1]}", *words,
            "--output", self.folder / "i.png", "--buffers", buffers,
        )
        found = read_buffers(buffers)
        picture = pixelexact.render(source, field, size=SIZE, background=None, **options)
        self.assertEqual(list(picture.range), summary["color_range"])
        for name in BUFFERS:
            if name in found:
                other = picture.array(name)[::-1].reshape(found[name].shape)
                np.testing.assert_array_equal(found[name], other, name)
                self.assertEqual(found[name].tobytes(), other.tobytes(), name)
        if "contours" in summary:
            self.assertEqual(summary["contours"]["values"], picture.contour_values)
        self.assertGreater(summary["pixels"]["exact"], 500)
        return summary, picture

    def test_scalars(self):
        source = case("toroid_hex_g3_p6")
        for words, options in [
            ([], {}),
            (["--range", "cut"], {"clim": "cut"}),
            (["--range", "field"], {"clim": "field"}),
            (["--range=-0.5,0.25"], {"clim": (-0.5, 0.25)}),
            (["--colormap", "plasma"], {"cmap": "plasma"}),
        ]:
            with self.subTest(words):
                self.compare(source, "u", ["--plane", "z=0.1", *words], {"origin": 0.1, **options})

    def test_components_of_vectors(self):
        source = self.folder / "v.vtu"
        source.write_text(vectors(), encoding="utf-8")
        plane = ["--plane", "0,0,0.5,0,0,1"]
        seen = {}
        for words, component in [
            ([], None), (["--component", "magnitude"], "magnitude"), (["--component", "x"], "x"),
            (["--component", "1"], 1), (["--component", "z"], "z"),
        ]:
            for ranges, clim in [([], None), (["--range", "field"], "field")]:
                with self.subTest([*words, *ranges]):
                    summary, picture = self.compare(
                        source, "displacement", [*plane, *words, *ranges],
                        {"component": component, "clim": clim, "origin": (0, 0, 0.5)},
                    )
            seen[component] = picture
        # The oracle is the field: linear along each edge of a cube.
        exact = seen[None].verdicts == 1
        x, y, z = seen[None].positions[exact].T
        parts = [0.5 + x, 3 * y - 1, 2 * z + x * y]
        norm = np.sqrt(sum(part**2 for part in parts))
        for component, wanted in [(None, norm), ("magnitude", norm), ("x", parts[0]), (1, parts[1]),
                                  ("z", parts[2])]:
            np.testing.assert_allclose(seen[component].values[exact], wanted, atol=1e-14)

    def test_a_table_of_ones_own_does_not_choose_the_component(self):
        source = self.folder / "v.vtu"
        source.write_text(vectors(), encoding="utf-8")
        wanted = pixelexact.render(source, "displacement", size=(20, 20)).values
        table = vtkLookupTable()  # VTK's default is a component
        found = pixelexact.render(source, "displacement", size=(20, 20), cmap=table).values
        np.testing.assert_array_equal(found, wanted)
        # A mapper without a table, and with a map by name, shows the magnitude, too.
        cut = pixelexact.cut(source, "displacement")
        mapper = pixelexact.vtkHighOrderMapper()
        mapper.SetInputData(pixelexact.read(source))
        mapper.SetFieldName("displacement")
        mapper.SetCutFunction(cut.surface)
        cut.actor.SetMapper(mapper)
        for name in (None, "jet"):
            if name:
                mapper.SetColorMap(name)
            picture = pixelexact.vtkHighOrderPicture()
            picture.SetActor(cut.actor)
            picture.SetSize(20, 20)
            picture.AllBuffersOn()
            picture.ViewAlong((0, 0, 1))
            picture.Update()
            shown = vtk_to_numpy(picture.GetOutput().GetPointData().GetArray("Value"))
            np.testing.assert_array_equal(shown.reshape(20, 20)[::-1], wanted)

    def test_contours(self):
        source = case("toroid_hex_g3_p6")
        for words, contours in [
            ("1", 1), ("2", 2), ("9", 9), ("9", np.int64(9)), ("23", 23), ("7,", [7]), ("0.1,", [0.1]),
            ("0.25", [0.25]), ("0.1,-0.2,0.3", [0.1, -0.2, 0.3]),
        ]:
            for ranges, clim in [([], None), (["--range", "field"], "field"),
                                 (["--range=-0.5,0.25"], (-0.5, 0.25))]:
                with self.subTest([words, *ranges]):
                    summary, picture = self.compare(
                        source, "u", ["--plane", "z=0.1", f"--contours={words}", *ranges],
                        {"origin": 0.1, "contours": contours, "clim": clim},
                    )
                    low, high = picture.range
                    values = picture.contour_values
                    if not isinstance(contours, list):
                        self.assertEqual(len(values), contours)
                        self.assertTrue(low < values[0] and values[-1] < high, (low, values, high))
        self.assertGreater((picture.contours == 1).sum(), 50)

    def test_contours_of_vectors_and_of_one_value(self):
        source = self.folder / "v.vtu"
        source.write_text(vectors(), encoding="utf-8")
        plane = ["--plane", "0,0,0.5,0,0,1", "--contours", "5"]
        self.compare(source, "displacement", plane, {"contours": 5, "origin": (0, 0, 0.5)})
        iso = pixelexact.vtkHighOrderIsoSurface()
        iso.SetFieldName("w")
        iso.SetValue(0.3)
        words = ["--isosurface", "w=0.3", "--contours", "5", "--lights", "off"]
        summary = self.summary("render", source, "--field", "w", "--size", "60x60", *words,
                               "--output", self.folder / "i.png")
        self.assertEqual(summary["contours"]["values"], [])
        picture = pixelexact.render(source, "w", surface=iso, contours=5, size=(60, 60))
        self.assertEqual(picture.contour_values, [])
        self.assertFalse(picture.contours.any())

    def test_views(self):
        source = case("toroid_hex_g3_p6")
        for view in ("iso", "+z", "-z"):
            with self.subTest(view):
                self.compare(source, "u", ["--plane", "z=0.1", f"--view={view}", "--contours", "4"],
                             {"origin": 0.1, "view": view, "contours": 4})
        ball = vtkSphere()
        ball.SetCenter(1, 0, 0)
        ball.SetRadius(0.2)
        # A surface without a normal is seen from (1, 1, 1) by both.
        buffers = self.folder / "b.vti"
        self.succeeds("render", source, "--field", "u", "--size", "60x60", "--sphere", "1,0,0,0.2",
                      "--output", self.folder / "i.png", "--buffers", buffers)
        picture = pixelexact.render(source, "u", surface=ball, size=(60, 60))
        found = read_buffers(buffers)
        for name in ("Value", "Verdict"):
            other = picture.array(name)[::-1].reshape(found[name].shape)
            np.testing.assert_array_equal(found[name], other, name)

    def test_lines(self):
        """contours(count=N) has the values of render's --contours N."""
        source = case("toroid_hex_g3_p6")
        summary = self.summary("render", source, "--field", "u", "--plane", "z=0.1", "--contours", "6",
                               "--size", "1000x1000", "--output", self.folder / "i.png")
        lines = pixelexact.contours(source, "u", count=6, origin=0.1)
        values = vtk_to_numpy(lines.GetCellData().GetArray("ContourValue"))
        self.assertEqual(sorted(set(values)), summary["contours"]["values"])
        lines = pixelexact.contours(source, "u", [0.1], origin=0.1)
        self.assertGreater(lines.GetNumberOfCells(), 0)

    def test_a_number_is_no_list(self):
        source = case("toroid_hex_g3_p6")
        for make in (
            lambda: pixelexact.contours(source, "u", values=9),
            lambda: pixelexact.contours(source, "u", 0.1),
            lambda: pixelexact.contours(source, "u", np.float32(0.1)),
            lambda: pixelexact.render(source, "u", contours=0.1),
            lambda: pixelexact.render(source, "u", contours=True),
        ):
            with self.assertRaisesRegex(TypeError, r"a list of values, not the number .*=\[.*=N"):
                make()
        for wrong in ({}, {"values": [1], "count": 2}, {"values": [1], "clim": "field"}):
            with self.assertRaises(TypeError):
                pixelexact.contours(source, "u", **wrong)
        for wrong in (0, -1, 10001):
            with self.assertRaises(ValueError):
                pixelexact.contours(source, "u", count=wrong)
            with self.assertRaises(ValueError):
                pixelexact.render(source, "u", contours=wrong)


class SameFiles(ToolTest):
    def refused(self, *files):
        """The program's words, and the exception of Python with the same."""
        done = run("info", *files)
        self.assertNotEqual(done.returncode, 0)
        words = re.sub(r"^pixelexact: ", "", done.stderr.strip())
        with self.assertRaises(ValueError if done.returncode == 2 else pixelexact.Error) as raised:
            pixelexact.read(*files)
        self.assertEqual(str(raised.exception), words)
        return words

    def test_files_that_do_not_belong_together(self):
        torus = case("toroid_hex_g3_p6")
        folder = DATA / "mfem_escher_tet_darcy_p3"
        mesh, flux = folder / "mfem_escher_tet_darcy_p3.mesh", folder / "flux.gf"
        for files in [(torus, flux), (torus, mesh), (mesh, torus), (mesh, mesh),
                      (torus, torus), (torus, case("escher_tet_g3_p3")), (mesh, flux, flux),
                      (flux,), (flux, mesh)]:
            with self.subTest(files):
                self.refused(*files)
        table = self.folder / "p.csv"
        table.write_text("x,y,z\n", encoding="utf-8")
        self.refused(torus, table)

    def test_files_that_cannot_be_read(self):
        for name, text in [("empty.vtu", ""), ("no.vtk", "text\n"), ("no.e", "text, not netCDF"),
                           ("no.cgns", "text, not CGNS")]:
            with self.subTest(name):
                file = self.folder / name
                file.write_text(text, encoding="utf-8")
                self.refused(file)

    def test_all_that_the_program_reads(self):
        """One table of suffixes: the program's words, its help and the exception of Python."""
        unknown = self.folder / "file.unknown"
        unknown.write_text("what", encoding="utf-8")
        done = run("info", unknown)
        with self.assertRaises(ValueError) as raised:
            pixelexact.read(unknown)
        self.assertEqual(done.stderr.strip(), f"pixelexact: {raised.exception}")
        suffixes = re.search(r"suffixes are (.*), and", done.stderr)[1].split(", ")
        self.assertIn(".cgns", suffixes)
        self.assertIn(".e", suffixes)
        told = re.sub(r"\s+", " ", run("render", "--help").stdout)
        for suffix in suffixes:
            self.assertIn(suffix, told)
            self.assertIn(suffix, pixelexact.read.__doc__)

    def check_probe(self, *files, points):
        """The values of both."""
        table, out = self.folder / "p.csv", self.folder / "o.csv"
        np.savetxt(table, points, delimiter=",", header="x,y,z", comments="")
        self.succeeds("probe", *files, "--points", table, "--output", out)
        rows = np.genfromtxt(out, delimiter=",", names=True)
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            found = pixelexact.probe(pixelexact.read(*files), None, points)
        np.testing.assert_array_equal(found.values, rows["value"])
        self.assertTrue(found.inside.all())

    def test_legacy_and_collections(self):
        from vtkmodules.vtkIOLegacy import vtkUnstructuredGridWriter
        from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader

        source = self.folder / "cube.vtu"
        source.write_text(unit_cube_grid(), encoding="utf-8")
        reader = vtkXMLUnstructuredGridReader()
        reader.SetFileName(str(source))
        writer = vtkUnstructuredGridWriter()
        writer.SetInputConnection(reader.GetOutputPort())
        legacy = self.folder / "cube.vtk"
        writer.SetFileName(str(legacy))
        writer.Write()
        points = np.array([[0.25, 0.5, 0.5], [0.75, 0.25, 0.125]])
        self.check_probe(legacy, points=points)
        collection = self.folder / "all.pvd"
        collection.write_text(
            '<VTKFile type="Collection"><Collection>'
            '<DataSet timestep="0.5" file="cube.vtu"/><DataSet timestep="2" file="cube.vtu"/>'
            "</Collection></VTKFile>", encoding="utf-8",
        )
        self.assertEqual(pixelexact.times(collection), [0.5, 2.0])
        self.check_probe(collection, points=points)
        for step in (0, 1, -1):
            self.assertEqual(pixelexact.read(collection, time_step=step).GetNumberOfCells(), 1)

    def test_blocks(self):
        points = np.array([[0.5, 0.25, 0.5], [0.25, 0.5, 0.75]])
        for name, reader in [("exodus_quadratic.e", "Exodus"), ("cgns_hexa27.cgns", "CGNS")]:
            if f"has no reader of {reader}" in run("info", DATA / name).stderr:
                continue
            with self.subTest(name):
                self.check_probe(DATA / name, points=points)
                told = self.summary("info", DATA / name)
                self.assertEqual(pixelexact.times(DATA / name), told.get("times", []))

    def test_time_series(self):
        for name in ("t_1.vtu", "t_2.vtu", "t_10.vtu"):
            text = unit_cube_grid([("u", [float(name[2:-4]) for _ in CUBE])])
            (self.folder / name).write_text(text, encoding="utf-8")
        files = [self.folder / name for name in ("t_10.vtu", "t_1.vtu", "t_2.vtu")]
        times = pixelexact.times(*files)
        self.assertEqual(len(times), 3)
        for step, value in [(0, 1.0), (1, 2.0), (-1, 10.0)]:
            grid = pixelexact.read(*files, time_step=step)
            self.assertEqual(pixelexact.probe(grid, "u", [[0.5, 0.5, 0.5]]).values[0], value)
        with self.assertRaisesRegex(IndexError, "3 time steps"):
            pixelexact.read(*files, time_step=3)


if __name__ == "__main__":
    unittest.main()
