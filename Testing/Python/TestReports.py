# SPDX-License-Identifier: BSD-3-Clause
"""figure, info and compare: what the program makes, by keywords; and the text of a grid."""

import importlib.util
import json
import os
import re
import subprocess
import sys
import tempfile
import unittest
import xml.dom.minidom
from pathlib import Path

import numpy as np
import pixelexact
from pixelexact import _tool
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

DATA = Path(os.environ["PIXELEXACT_DATA_DIR"])
TORUS = DATA / "toroid_hex_g3_p6.vtu"
PRISMS = DATA / "toroid_prism_g3_p4.vtu"
TOOL = os.environ["PIXELEXACT_TOOL"]
SIZE = (400, 300)


def pixels(content):
    with tempfile.NamedTemporaryFile(suffix=".png") as file:
        file.write(content)
        file.flush()
        reader = vtkPNGReader()
        reader.SetFileName(file.name)
        reader.Update()
    image = reader.GetOutput()
    width, height, _ = image.GetDimensions()
    return vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, -1)[::-1]


class InFolder(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="pixelexact-")
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)


class Figures(InFolder):
    def test_files_are_those_of_the_program(self):
        """Byte for byte, but the date of a PDF, by the command that the report states."""
        def undated(content):
            return re.sub(rb"D:\d{14}Z", b"", content)

        for suffix, beginning in ((".png", b"\x89PNG"), (".pdf", b"%PDF"), (".svg", b"<?xml"), (".tiff", b"II*\0")):
            with self.subTest(suffix):
                file = self.folder / f"a{suffix}"
                made = pixelexact.figure(TORUS, "u", plane="z=0.1", contours=[-0.25, 0.25], cmap="vik",
                                         clim="symmetric", size=SIZE, output=file)
                self.assertEqual(made.path, str(file))
                self.assertTrue(made.content.startswith(beginning))
                self.assertTrue(file.read_bytes() == made.content)
                file.unlink()
                subprocess.run([TOOL, *made.report["command"][1:]], check=True, stdout=subprocess.DEVNULL)
                self.assertTrue(undated(file.read_bytes()) == undated(made.content))

    def test_pixels_are_those_of_render(self):
        made = pixelexact.figure(TORUS, "u", plane="z=0.1", size=SIZE)
        self.assertIsNone(made.path)
        width, height = made.report["width"], made.report["height"]
        picture = pixelexact.render(TORUS, "u", normal="z", origin=0.1, size=(width, height))
        counts = [int((picture.verdicts == verdict).sum()) for verdict in range(3)]
        self.assertEqual(list(made.report["pixels"].values()), [counts[1], counts[0], counts[2]])
        self.assertEqual(pixels(made.content).shape[:2], (300, 400))

    def test_grids_in_memory(self):
        grid = pixelexact.read(TORUS)
        one, other = (pixelexact.figure(each, "u", plane="z=0.1", size=SIZE) for each in (grid, TORUS))
        np.testing.assert_array_equal(pixels(one.content), pixels(other.content))

    def test_shown_in_notebooks(self):
        """A PNG shows itself, an SVG as such, and others as the PNG of the same figure."""
        options = {"plane": "z=0.1", "size": SIZE}
        png = pixelexact.figure(TORUS, "u", **options)
        self.assertTrue(png._repr_png_() is png.content)
        self.assertIsNone(png._repr_svg_())
        svg = pixelexact.figure(TORUS, "u", output=self.folder / "a.svg", **options)
        self.assertIsNone(svg._repr_png_())
        self.assertEqual(xml.dom.minidom.parseString(svg._repr_svg_()).documentElement.tagName, "svg")
        pdf = pixelexact.figure(TORUS, "u", output=self.folder / "a.pdf", **options)
        np.testing.assert_array_equal(pixels(pdf._repr_png_()), pixels(png.content))
        self.assertIn("a.pdf", repr(pdf))
        jpeg = pixelexact.figure(TORUS, "u", output=self.folder / "a.jpg", jpeg_quality=50, **options)
        self.assertIsNone(jpeg._repr_png_())
        self.assertTrue(jpeg._repr_jpeg_().startswith(b"\xff\xd8"))

    def test_display_writes_no_other_files(self):
        buffers = self.folder / "b.vti"
        made = pixelexact.figure(TORUS, "u", plane="z=0.1", size=SIZE, output=self.folder / "a.tif", buffers=buffers)
        buffers.unlink()
        self.assertTrue(made._repr_png_().startswith(b"\x89PNG"))
        self.assertFalse(buffers.exists())

    def test_keywords(self):
        words = _tool.words_of({
            "field": "u", "clip": [[0, 0, 0, 1, 0, 0], (0, 0.5, 0, 0, 1, 0)], "contours": [1], "size": (80, 60),
            "contours_only": True, "edges": False, "range": None, "cmap": "vik", "clim": np.array([0.5, 2]),
            "plane": ["z=10%", "x=0"], "boundary": np.array([1, 2]), "output": Path("a.png"), "bands": np.int64(7),
            "with_": [["m.mesh", "u.gf"], "other.vtu"]})
        self.assertEqual(words, [
            "--field=u", "--clip=0,0,0,1,0,0", "--clip=0,0.5,0,0,1,0", "--contours=1,", "--size=80x60",
            "--contours-only", "--colormap=vik", "--range=0.5,2.0", "--plane=z=10%", "--plane=x=0", "--boundary=1,2",
            "--output=a.png", "--bands=7", "--with", "m.mesh", "u.gf", "--with=other.vtu"])

    def test_threads_are_those_of_the_package(self):
        before = pixelexact.get_threads()
        try:
            pixelexact.set_threads(1)
            self.assertEqual(_tool.words_of({}), ["--threads=1"] if before != 1 else [])
            self.assertEqual(_tool.words_of({"threads": 2}), ["--threads=2"])
        finally:
            pixelexact.set_threads(None)
        self.assertEqual(_tool.words_of({}), [])

    def test_refused(self):
        for options, error, word in (
            ({"nonsense": 3}, pixelexact.Error, "--nonsense"),
            ({"cmap": "virids"}, pixelexact.Error, "did you mean viridis"),
            ({"output": self.folder / "a.bmp"}, pixelexact.Error, ".png"),
            ({"output": self.folder / "none" / "a.png"}, pixelexact.Error, "a.png"),
            ({"cmap": object()}, TypeError, "cmap"),
            ({"time_step": "all"}, ValueError, "time_step"),
            ({"sweep": "z=0:1:9"}, ValueError, "sweep"),
        ):
            with self.subTest(options), self.assertRaisesRegex(error, word):
                pixelexact.figure(TORUS, "u", **options)
        with self.assertRaisesRegex(pixelexact.Error, "nothing"):
            pixelexact.figure(TORUS, "nothing")
        with self.assertRaisesRegex(TypeError, "figure: .* not int"):
            pixelexact.figure(3)
        self.assertEqual(list(self.folder.iterdir()), [])

    def test_without_the_program(self):
        """A copy of the package without a program beside it, and an empty PATH."""
        script = ("import pixelexact\n"
                  "try:\n  pixelexact.info('a.vtu')\nexcept pixelexact.Error as error:\n  print(error)\n")
        package = self.folder / "lib" / "python3" / "dist-packages" / "pixelexact"
        package.mkdir(parents=True)
        for file in Path(pixelexact.__file__).parent.iterdir():
            if file.suffix == ".py":
                (package / file.name).write_bytes(file.read_bytes())
            elif file.suffix == ".so":
                (package / file.name).symlink_to(file)
        done = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, check=False,
                              env={**os.environ, "PATH": str(self.folder), "PYTHONPATH": str(package.parent),
                                   "LD_LIBRARY_PATH": str(Path(pixelexact.__file__).parents[3])})
        self.assertIn("info: the program pixelexact is neither installed", done.stdout, done.stderr)


class Infos(unittest.TestCase):
    def test_is_the_report_of_the_program(self):
        done = subprocess.run([TOOL, "info", str(TORUS), "--json"], stdout=subprocess.PIPE, check=True)
        self.assertEqual(dict(pixelexact.info(TORUS)), json.loads(done.stdout))
        self.assertEqual(pixelexact.info(TORUS, certify=True, extremes="u").keys() - json.loads(done.stdout).keys(),
                         {"jacobian", "certify_seconds", "extremes"})
        self.assertEqual(pixelexact.info(pixelexact.read(TORUS))["elements"], 48)

    def test_text(self):
        text = repr(pixelexact.info(TORUS))
        self.assertIn("48 hexahedra; order 3", text)
        self.assertIn("u: scalar, order 6, continuous, values -0.883067 to 0.862496", text)
        many = pixelexact.calculate(TORUS, **{f"f{i}": f"{i}*u" for i in range(12)})
        for grid in (many, DATA / "mfem49_tinyzoo_g3_p5" / "mfem49_tinyzoo_g3_p5.mesh"):
            self.assertLessEqual(len(repr(pixelexact.info(grid)).splitlines()), 10)

    def test_refused(self):
        with self.assertRaisesRegex(pixelexact.Error, "there is no such file"):
            pixelexact.info(DATA / "none.vtu")
        with self.assertRaisesRegex(pixelexact.Error, "--plane"):
            pixelexact.info(TORUS, plane="z=0")


class Comparisons(InFolder):
    def test_report(self):
        found = pixelexact.compare(TORUS, "u", plane="z=0.1", resolutions=[8, 16], size=(80, 60),
                                   output=self.folder / "trade")
        self.assertEqual(found.page, str(self.folder / "trade" / "report.html"))
        self.assertIn("<html", Path(found.page).read_text(encoding="utf-8"))
        self.assertEqual(found.rows, found["settings"])
        rows = {row["setting"]: row for row in found.rows}
        self.assertEqual(rows["exact"]["largest_error"], 0)
        self.assertGreater(rows["cut-8"]["largest_error"], rows["cut-16"]["largest_error"])
        self.assertIn("report.html", repr(found))

    def test_solutions(self):
        scene = {"plane": "z=0.1", "size": (200, 200)}
        one = pixelexact.compare(TORUS, "u", with_=PRISMS, output=self.folder / "a.png", **scene)
        self.assertEqual(one["solution"], PRISMS.name)
        self.assertEqual((one.rows, one.page), ([], None))
        self.assertIn("a.png", repr(one))
        several = pixelexact.compare(TORUS, "u", with_=[PRISMS, TORUS], output=self.folder / "b", **scene)
        self.assertEqual([row["solution"] for row in several.rows], [PRISMS.name, TORUS.name])
        self.assertEqual(several.rows[0]["pixels"], one["pixels"])
        self.assertEqual(several.rows[1]["pixels"]["largest"], 0)
        steps = TORUS.parent / "vtkhdf_steps.vtkhdf"
        times = pixelexact.compare(
            steps, "u", with_=steps, with_time_step=0, time_step="all", plane="z=0.5", output=self.folder / "c")
        self.assertEqual([row["time"] for row in times.rows], [0.0, 0.5, 1.0])
        self.assertGreater(times.rows[2]["pixels"]["largest"], 11.0)

    def test_refused(self):
        with self.assertRaisesRegex(pixelexact.Error, "--resolutions"):
            pixelexact.compare(TORUS, "u", resolutions="many", output=self.folder / "trade")


class Series(unittest.TestCase):
    def test_norms_and_jumps_by_the_programs_names(self):
        folder = TORUS.parent / "sine_series"
        error = "u - sin(pi*x)*sin(pi*y)*sin(pi*z)"
        grid = pixelexact.read(folder / "p1.vtu")
        found = pixelexact.info(grid, norms=error, with_=[[folder / "p2.vtu"], [folder / "p3.vtu"]], jumps="u")
        norms = [one["norms"][0]["l2"] for one in found["norms"]["series"]["solutions"]]
        self.assertEqual(norms[0], pixelexact.norms(grid, error).l2)
        self.assertEqual(norms[2], pixelexact.norms(folder / "p3.vtu", error).l2)
        self.assertGreater(found["norms"]["series"]["orders"][0]["l2"]["overall"], 3.0)
        self.assertTrue(found["jumps"]["fields"][0]["zero_within_rounding"])
        with self.assertRaisesRegex(pixelexact.Error, "--norms"):
            pixelexact.info(grid, with_=folder / "p2.vtu")

    def test_measures_of_elements(self):
        grid = pixelexact.read(TORUS)
        least = pixelexact.extremes(grid, lambda minScaledJacobian: minScaledJacobian).minimum
        self.assertLessEqual(least.value, pixelexact.extremes(grid, "scaledJacobian").minimum.value)
        kept = pixelexact.calculate(grid, quality="minScaledJacobian")
        self.assertEqual(pixelexact.extremes(kept, "quality").minimum.value, least.value)
        sizes = pixelexact.norms(grid, "elementSize^3")
        self.assertEqual(len(sizes.elements["Volume"]), 48)
        with self.assertRaisesRegex(pixelexact.Error, "no attributes"):
            pixelexact.extremes(pixelexact.read(TORUS.parent / "sine_series" / "p1.vtu"), "attribute")


class TextsOfGrids(unittest.TestCase):
    def test_ten_lines(self):
        grid = pixelexact.read(TORUS)
        lines = str(grid).strip().splitlines()
        self.assertRegex(lines[0], r"^vtkHighOrderGrid \(0x")
        text = "\n".join(lines[1:])
        self.assertEqual(len(lines), 6)
        self.assertIn("Cells: 48 hexahedra of order 3", text)
        self.assertIn("Field u: scalar, order 6", text)
        low, high = (float(number) for number in lines[3].split("x ")[1].split(",")[0].split(" to "))
        bounds = pixelexact.info(TORUS)["bounds"]
        self.assertTrue(bounds[0] - 0.1 < low <= bounds[0] and bounds[1] <= high < bounds[1] + 0.1)

    def test_all_of_the_data(self):
        """Several shapes and orders, plane meshes, many fields, definitions, time."""
        names = ("mfem49_tinyzoo_g3_p5", "mfem_escher_tet_darcy_p3")
        for name in names:
            folder = DATA / name
            grid = pixelexact.read(folder / f"{name}.mesh", *sorted(folder.glob("*.gf")))
            self.assertLessEqual(len(str(grid).strip().splitlines()), 10)
        many = pixelexact.calculate(TORUS, **{f"f{i}": f"{i}*u" for i in range(12)})
        text = str(many).strip()
        self.assertLessEqual(len(text.splitlines()), 10)
        self.assertIn("f11 = 11*u", text)

    def test_without_coefficients(self):
        self.assertIn("vtkUnstructuredGridToHighOrderGrid", str(pixelexact.vtkHighOrderGrid()))

    @unittest.skipUnless(importlib.util.find_spec("IPython"), "IPython is not installed")
    def test_in_notebooks(self):
        script = ("from IPython.core.interactiveshell import InteractiveShell\nshell = InteractiveShell.instance()\n"
                  f"import pixelexact\ngrid = pixelexact.read({str(TORUS)!r})\n"
                  "print(shell.display_formatter.format(grid)[0]['text/plain'] == str(grid).strip())\n"
                  f"made = pixelexact.figure(grid, 'u', plane='z', size={SIZE})\n"
                  "print(sorted(shell.display_formatter.format(made)[0]))\n"
                  "print(sorted(shell.display_formatter.format(pixelexact.render(grid, 'u', size=(9, 9)))[0]))\n"
                  "text = shell.display_formatter.format(pixelexact.info(grid))[0]['text/plain']\n"
                  "print(text.startswith('elements: 48'))\n")
        with tempfile.TemporaryDirectory() as folder:
            done = subprocess.run([sys.executable, "-c", script], env={**os.environ, "HOME": folder},
                                  capture_output=True, text=True, check=False)
        self.assertEqual(done.stdout.splitlines(),
                         ["True", "['image/png', 'text/plain']", "['image/png', 'text/plain']", "True"], done.stderr)


if __name__ == "__main__":
    unittest.main()
