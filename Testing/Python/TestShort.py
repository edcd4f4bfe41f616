# SPDX-License-Identifier: BSD-3-Clause
"""read, cut, probe, render, contours: values of the solvers, and what is refused."""

import csv
import os
import resource
import shutil
import signal
import tempfile
import threading
import time
import unittest
import warnings
from pathlib import Path

import numpy as np
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkBox, vtkSphere, vtkUnstructuredGrid
from vtkmodules.vtkIOImage import vtkPNGReader
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader
from vtkmodules.vtkRenderingCore import vtkRenderer, vtkRenderWindow

import pixelexact

DATA = Path(os.environ["PIXELEXACT_DATA_DIR"])
TORUS = DATA / "toroid_hex_g3_p6.vtu"


def oracle(name):
    with open(DATA / f"{name}.oracle.csv", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    points = np.array([[float(row[key]) for key in "xyz"] for row in rows])
    return points, np.array([float(row["u"]) for row in rows])


class Read(unittest.TestCase):
    def test_solvers_files(self):
        folder = DATA / "mfem_escher_tet_darcy_p3"
        grid = pixelexact.read(folder / "mfem_escher_tet_darcy_p3.mesh", folder / "flux.gf")
        self.assertIsInstance(grid, pixelexact.vtkHighOrderGrid)
        self.assertEqual(grid.GetHighOrderFieldName(0), "flux")

    def test_plain_grids_are_converted(self):
        reader = vtkXMLUnstructuredGridReader()
        reader.SetFileName(str(TORUS))
        reader.Update()
        points, values = oracle("toroid_hex_g3_p6")
        found = pixelexact.probe(reader.GetOutput(), "u", points)
        np.testing.assert_allclose(found.values, values, rtol=0, atol=1e-13)
        # As PyVista hands a grid on: another type, with the same arrays.
        plain = vtkUnstructuredGrid()
        plain.ShallowCopy(pixelexact.read(TORUS))
        again = pixelexact.probe(plain, "u", points)
        np.testing.assert_array_equal(again.values, found.values)

    def test_refused(self):
        field = DATA / "mfem_escher_tet_darcy_p3" / "flux.gf"
        with self.assertRaisesRegex(FileNotFoundError, "nowhere"):
            pixelexact.read("nowhere.vtu")
        with self.assertRaisesRegex(ValueError, "without its mesh"):
            pixelexact.read(field)
        with self.assertRaisesRegex(ValueError, "suffixes are"):
            pixelexact.read(DATA / "README.md")
        with self.assertRaisesRegex(IndexError, "no time steps"):
            pixelexact.read(TORUS, time_step=2)
        with tempfile.TemporaryDirectory() as folder:
            broken = Path(folder) / "broken.mesh"
            broken.write_text("MFEM mesh v1.0\n\ndimension\n7\n", encoding="utf-8")
            with self.assertRaisesRegex(pixelexact.Error, "broken.mesh"):
                pixelexact.read(broken)

    def test_time_steps(self):
        folder = Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, folder)
        steps = [folder / f"torus_{step}.vtu" for step in range(3)]
        for step in steps:
            step.symlink_to(TORUS)
        self.assertEqual(pixelexact.times(*steps), [0, 1, 2])
        for step in (0, 2, -1):
            grid = pixelexact.read(*steps, time_step=step)
            when = grid.GetInformation().Get(grid.DATA_TIME_STEP())
            self.assertEqual(when, step % 3)
        with self.assertRaisesRegex(IndexError, "3 time steps"):
            pixelexact.read(*steps, time_step=3)


class Probe(unittest.TestCase):
    def setUp(self):
        self.grid = pixelexact.read(TORUS)

    def test_oracle(self):
        points, values = oracle("toroid_hex_g3_p6")
        found = pixelexact.probe(self.grid, "u", points, gradients=True, enclosures=True)
        np.testing.assert_allclose(found.values, values, rtol=0, atol=1e-13)
        self.assertTrue(found.inside.all())
        self.assertTrue((found.lower <= values + 1e-15).all())
        self.assertTrue((found.upper >= values - 1e-15).all())
        step = 1e-6
        for axis in range(3):
            shift = np.eye(3)[axis] * step
            ahead = pixelexact.probe(self.grid, "u", points + shift)
            behind = pixelexact.probe(self.grid, "u", points - shift)
            both = ahead.inside & behind.inside
            both &= ahead.elements == behind.elements
            slope = (ahead.values - behind.values) / (2 * step)
            np.testing.assert_allclose(
                found.gradients[both, axis], slope[both], rtol=1e-5, atol=1e-5
            )
            self.assertGreater(both.sum(), 10)

    def test_nothing_is_copied(self):
        points = np.array([[1.0, 0.0, 0.0], [9.0, 9.0, 9.0], [np.nan, 0.0, 0.0]])
        from pixelexact._probe import _cloud

        shared = vtk_to_numpy(_cloud(points).GetPoints().GetData())
        self.assertTrue(np.shares_memory(shared, points))
        found = pixelexact.probe(self.grid, None, points)
        self.assertEqual(found.field, "u")
        self.assertEqual(found.verdicts.tolist(), [1, 0, 0])
        self.assertEqual(found.elements[1:].tolist(), [-1, -1])
        self.assertTrue(np.isnan(found.values[1:]).all())
        self.assertIsNone(found.gradients)
        self.assertFalse(found.values.flags.owndata)

    def test_masked_points_are_outside(self):
        points = np.ma.masked_array([[1.0, 0.0, 0.0], [1.0, 0.0, 0.0]], [[0, 0, 0], [0, 1, 0]])
        self.assertEqual(pixelexact.probe(self.grid, "u", points).verdicts.tolist(), [1, 0])

    def test_refused(self):
        with self.assertRaisesRegex(pixelexact.Error, "no field 'w'; choose one of 'u'"):
            pixelexact.probe(self.grid, "w", [[0, 0, 0]])
        with self.assertRaisesRegex(TypeError, "complex"):
            pixelexact.probe(self.grid, "u", np.array([[1.0 + 1j, 0.0, 0.0]]))
        with self.assertRaisesRegex(ValueError, r"shape \(n, 3\)"):
            pixelexact.probe(self.grid, "u", [[0, 0]])
        with self.assertRaisesRegex(TypeError, "file's name"):
            pixelexact.probe(3, "u", [[0, 0, 0]])


class Render(unittest.TestCase):
    def setUp(self):
        self.grid = pixelexact.read(TORUS)

    def test_values_are_the_probes(self):
        picture = pixelexact.render(self.grid, "u", size=(160, 120), contours=5, edges=True)
        self.assertEqual(picture.image.shape, (120, 160, 4))
        exact = picture.verdicts == 1
        self.assertGreater(exact.sum(), 4000)
        found = pixelexact.probe(self.grid, "u", picture.positions[exact])
        np.testing.assert_array_equal(found.values, picture.values[exact])
        np.testing.assert_array_equal(found.elements, picture.elements[exact])
        self.assertGreater((picture.contours == 1).sum(), 100)
        self.assertEqual(picture.image[0, 0].tolist(), [255, 255, 255, 255])
        # Rows are from the top.
        heights = picture.positions[..., 1][exact]
        self.assertGreater(heights[0], heights[-1])

    def test_as_in_a_window(self):
        """The same camera, bit for bit, where nothing is lit."""
        cut = pixelexact.cut(self.grid, "u", origin=0.05, contours=[0.1, 0.2], edges=2)
        picture = cut.render(size=(150, 110), background=None)
        renderer = vtkRenderer()
        renderer.AddActor(cut.actor)
        renderer.SetActiveCamera(picture.camera)
        renderer.ResetCameraClippingRange()
        window = vtkRenderWindow()
        window.SetOffScreenRendering(True)
        window.SetMultiSamples(0)
        window.SetSize(150, 110)
        window.AddRenderer(renderer)
        window.Render()
        buffers = cut.mapper.GetBuffers().GetPointData()
        for name in ("Value", "Verdict", "Position", "Element", "Contour", "Color"):
            shown = vtk_to_numpy(buffers.GetArray(name))
            np.testing.assert_array_equal(
                picture.array(name)[::-1].reshape(shown.shape), shown, name
            )

    def test_surfaces(self):
        ball = vtkSphere()
        ball.SetCenter(1, 0, 0)
        ball.SetRadius(0.2)
        boundary = pixelexact.vtkHighOrderBoundarySurface()
        for surface in (ball, boundary, lambda x: x[:, 2] - 0.1 * np.sin(6 * x[:, 0])):
            picture = pixelexact.render(self.grid, "u", surface=surface, size=(80, 60))
            self.assertGreater((picture.verdicts == 1).sum(), 30)
        with self.assertRaisesRegex(ValueError, "leave them out"):
            pixelexact.cut(self.grid, "u", surface=ball, origin=0.1)
        cut = pixelexact.cut(self.grid, "u", origin=np.float32(0.25))
        self.assertEqual(cut.surface.GetOrigin()[2], 0.25)
        nan = float("nan")
        for plane in ({"origin": nan}, {"origin": (0, nan, 0)}, {"normal": (nan, 0, 1)}):
            with self.assertRaisesRegex(ValueError, f"^{next(iter(plane))}: finite numbers"):
                pixelexact.cut(self.grid, "u", **plane)

    def test_what_has_no_effect_is_warned_of(self):
        cut = pixelexact.cut(self.grid, "u")
        cut.actor.GetProperty().SetRepresentationToWireframe()
        with self.assertWarnsRegex(RuntimeWarning, "Representation"):
            cut.render(size=(20, 20))

    def test_files(self):
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "cut.png"
            picture = pixelexact.render(TORUS, "u", size=(60, 40), output=file)
            reader = vtkPNGReader()
            reader.SetFileName(str(file))
            reader.Update()
            pixels = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars())
            np.testing.assert_array_equal(pixels.reshape(40, 60, 4)[::-1], picture.image)
            picture.save(Path(folder) / "cut.vti")
            self.assertGreater((Path(folder) / "cut.vti").stat().st_size, 1000)
            with self.assertRaises(FileNotFoundError):
                picture.save(Path(folder) / "none" / "cut.png")
            with self.assertRaisesRegex(ValueError, ".png or .vti"):
                picture.save(Path(folder) / "cut.bmp")
        self.assertEqual(picture._repr_png_()[:8], b"\x89PNG\r\n\x1a\n")

    def test_no_part_of_a_file_is_left(self):
        picture = pixelexact.render(self.grid, "u", size=(80, 80))
        with tempfile.TemporaryDirectory() as folder:
            before = resource.getrlimit(resource.RLIMIT_FSIZE)
            resource.setrlimit(resource.RLIMIT_FSIZE, (1000, before[1]))
            try:
                for name in ("cut.png", "cut.vti"):
                    with self.assertRaisesRegex(OSError, f"{name}.*room"):
                        picture.save(Path(folder) / name)
            finally:
                resource.setrlimit(resource.RLIMIT_FSIZE, before)
            self.assertEqual(list(Path(folder).iterdir()), [])

    def test_sizes_and_ranges_that_are_none(self):
        for size in ((1.5, 2), (10**6, 10**6), (0, 1), (2,)):
            with self.assertRaises((TypeError, ValueError)):
                pixelexact.render(self.grid, "u", size=size)
        with self.assertRaisesRegex(ValueError, "clim"):
            pixelexact.render(self.grid, "u", size=(2, 2), clim=(0.0, np.inf))

    def test_arguments_of_another_kind_are_named(self):
        for name, value in (
            ("size", 300),
            ("contours", "12"),
            ("contours", 0.5j),
            ("edges", "yes"),
            ("camera", 3),
            ("clim", 3j),
            ("origin", "x"),
        ):
            with self.subTest(name), self.assertRaisesRegex(TypeError, f"^{name}: "):
                pixelexact.render(self.grid, "u", **{"size": (2, 2), name: value})
        with self.assertRaisesRegex(ValueError, "^view: 'iso'"):
            pixelexact.render(self.grid, "u", size=(2, 2), view="up")
        with self.assertRaisesRegex(TypeError, "^set_threads: "):
            pixelexact.set_threads("x")
        with self.assertRaisesRegex(TypeError, "^values: "):
            pixelexact.contours(self.grid, "u", "0.1")

    def test_numbers_of_numpy_are_numbers(self):
        five, values = (
            pixelexact.render(self.grid, "u", size=(20, 20), contours=contours).cut.mapper
            for contours in (np.int64(5), np.array([0.1, 0.25], dtype=np.float32))
        )
        self.assertEqual(five.GetNumberOfContours(), 5)
        self.assertEqual(values.GetContourValue(1), 0.25)
        lines = pixelexact.contours(self.grid, "u", np.array([0.25], dtype=np.float32))
        self.assertGreater(lines.GetNumberOfCells(), 0)

    def test_results_say_what_they_are(self):
        picture = pixelexact.render(self.grid, size=(20, 10))
        exact = int((picture.verdicts == 1).sum())
        self.assertEqual(
            repr(picture),
            f"<Picture of <Cut of 'u' by vtkPlane>, 20 x 10: {exact} pixels exact, "
            f"{200 - exact} nothing, 0 unknown>",
        )
        self.assertEqual(
            repr(pixelexact.probe(self.grid, "u", [[1.0, 0.0, 0.0], [9.0, 0.0, 0.0]])),
            "<Probed 'u' at 2 points: 1 inside, 1 outside, 0 unknown>",
        )
        # As os.PathLike may give it.
        self.assertEqual(pixelexact.times(os.fsencode(TORUS)), [])

    def test_ranges(self):
        picture = pixelexact.render(self.grid, "u", size=(60, 60), clim="cut")
        self.assertEqual(picture.range, (np.nanmin(picture.values), np.nanmax(picture.values)))
        for span in ((0, 2), np.array([0.0, 2.0])):
            with warnings.catch_warnings():
                warnings.simplefilter("error")
                other = pixelexact.render(self.grid, "u", size=(9, 9), clim=span)
            self.assertEqual(other.range, (0.0, 2.0))
        self.assertEqual(pixelexact.render(self.grid, "u", size=(60, 60)).range, picture.range)
        wide = pixelexact.render(self.grid, "u", size=(9, 9), clim="field").range
        self.assertLessEqual(wide[0], np.nanmin(picture.values))
        with self.assertRaisesRegex(ValueError, "clim"):
            pixelexact.cut(self.grid, "u", clim=(2, 1))
        with self.assertRaisesRegex(ValueError, "viridis"):
            pixelexact.cut(self.grid, "u", cmap="nothing")

    def test_strides_show_the_middle_pixels(self):
        options = {"normal": "z", "origin": 0.1, "size": (81, 60)}
        whole = pixelexact.render(self.grid, "u", **options).values[::-1]
        coarse = pixelexact.render(self.grid, "u", stride=4, **options)
        values = coarse.values[::-1]
        middle = whole[2::4, 2::4]
        rows, columns = middle.shape
        self.assertTrue(np.array_equal(values[::4, ::4][:rows, :columns], middle, equal_nan=True))
        self.assertTrue(np.array_equal(values[1::4], values[::4], equal_nan=True))
        # Other colours, the same pixels.
        again = pixelexact.render(self.grid, "u", stride=4, cmap="plasma", **options)
        self.assertTrue(np.array_equal(again.values, coarse.values, equal_nan=True))
        self.assertTrue((again.image != coarse.image).any())
        for wrong in ({"contours": 5}, {"edges": True}):
            with self.assertRaisesRegex(pixelexact.Error, "stride"):
                pixelexact.render(self.grid, "u", stride=2, **wrong, **options)
        with self.assertRaisesRegex(ValueError, "stride"):
            pixelexact.render(self.grid, "u", stride=0)

    def test_a_new_table_traces_nothing(self):
        cut = pixelexact.cut(self.grid, "u")
        picture = pixelexact.vtkHighOrderPicture()
        picture.SetActor(cut.actor)
        picture.SetSize(50, 50)
        picture.ViewAlong((0, 0, 1), (0, 1, 0))
        picture.Update()
        before = vtk_to_numpy(picture.GetOutput().GetPointData().GetScalars()).copy()
        self.assertEqual(picture.GetNumberOfTraces(), 1)
        cut.mapper.SetColorMap("plasma")
        picture.Update()
        after = vtk_to_numpy(picture.GetOutput().GetPointData().GetScalars())
        self.assertEqual(picture.GetNumberOfTraces(), 1)
        self.assertTrue((before != after).any())

    def test_pictures_of_nothing_are_refused(self):
        picture = pixelexact.vtkHighOrderPicture()
        with self.assertRaisesRegex(pixelexact.Error, "SetActor"):
            pixelexact._work.run(picture)
        cut = pixelexact.cut(self.grid, "u")
        picture.SetActor(cut.actor)
        with self.assertRaisesRegex(pixelexact.Error, "SetCamera"):
            pixelexact._work.run(picture)


class Contours(unittest.TestCase):
    def test_points_have_the_value(self):
        lines = pixelexact.contours(TORUS, "u", [0.1, -0.2], origin=0.05)
        points = vtk_to_numpy(lines.GetPoints().GetData())
        found = pixelexact.probe(TORUS, "u", points)
        inside = found.inside
        nearest = np.minimum(abs(found.values - 0.1), abs(found.values + 0.2))
        self.assertLess(np.nanmax(nearest), 1e-12)
        self.assertGreater(inside.mean(), 0.9)

    def test_lines_on_a_torus_are_proven(self):
        torus = pixelexact.vtkImplicitTorus()
        torus.SetTubeRadius(0.2)
        lines = pixelexact.contours(TORUS, "u", [0.1], surface=torus)
        certified = vtk_to_numpy(lines.GetCellData().GetArray("Certified"))
        self.assertGreater(len(certified), 0)
        self.assertTrue(certified.all())

    def test_lines_on_a_box_end_at_its_edges(self):
        box = vtkBox()
        box.SetBounds(-1.0, 1.0, -1.1, 1.2, -0.25, 0.2)
        lines = pixelexact.contours(TORUS, "u", [0.1, -0.2], surface=box)
        self.assertTrue(vtk_to_numpy(lines.GetCellData().GetArray("Certified")).all())
        points = vtk_to_numpy(lines.GetPoints().GetData())
        self.assertGreater(len(points), 0)
        off = [abs(box.FunctionValue(point)) for point in points]
        self.assertLess(max(off), 1e-13)

    def test_lines_elsewhere_are_refused(self):
        with self.assertRaisesRegex(pixelexact.Error, "traced on planes, .* tori, boxes"):
            pixelexact.contours(TORUS, "u", [0.1], surface=pixelexact.vtkHighOrderBoundarySurface())


class Work(unittest.TestCase):
    """Progress, interruption, other threads."""

    def setUp(self):
        self.grid = pixelexact.read(TORUS)
        pixelexact.probe(self.grid, "u", [[1.0, 0.0, 0.0]])
        self.points = np.random.default_rng(3).uniform(
            (-1.4, -1.4, -0.4), (1.4, 1.4, 0.4), (400_000, 3)
        )

    def test_progress_ends_it(self):
        def enough(part):
            raise RuntimeError(f"enough at {part >= 0}")

        with self.assertRaisesRegex(RuntimeError, "enough at True"):
            pixelexact.probe(self.grid, "u", self.points, progress=enough)
        with self.assertRaisesRegex(RuntimeError, "enough at True"):
            pixelexact.render(self.grid, "u", size=(900, 900), progress=enough)
        seen = []
        pixelexact.probe(self.grid, "u", self.points, enclosures=True, progress=seen.append)
        self.assertEqual(seen, sorted(seen))
        self.assertGreater(len(seen), 1)

    def test_interrupted(self):
        many = np.tile(self.points, (8, 1))
        timer = threading.Timer(0.1, os.kill, (os.getpid(), signal.SIGINT))
        timer.start()
        with self.assertRaises(KeyboardInterrupt):
            pixelexact.probe(self.grid, "u", many, enclosures=True)
        # Nothing is broken.
        self.assertEqual(pixelexact.probe(self.grid, "u", self.points[:9]).values.shape, (9,))

    def test_other_threads_run(self):
        stop = threading.Event()
        ticks = []

        def tick():
            while not stop.is_set():
                ticks.append(time.monotonic())
                time.sleep(0.001)

        thread = threading.Thread(target=tick)
        thread.start()
        try:
            begin = time.monotonic()
            pixelexact.probe(self.grid, "u", self.points, enclosures=True)
            end = time.monotonic()
        finally:
            stop.set()
            thread.join()
        within = [tick for tick in ticks if begin + 0.01 < tick < end - 0.01]
        self.assertGreater(len(within), 5)

    def test_several_threads_ask_the_same_grid(self):
        expected = pixelexact.probe(self.grid, "u", self.points[:20_000]).values
        fresh = pixelexact.read(TORUS)
        found = []

        def ask():
            inner = []

            def progress(part):  # asks, too
                inner.append(pixelexact.probe(fresh, "u", [[1.0, 0.0, 0.0]]).values[0])

            values = pixelexact.probe(fresh, "u", self.points[:20_000], progress=progress).values
            found.append((values, inner))

        threads = [threading.Thread(target=ask) for _ in range(6)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join(60)
        self.assertEqual(len(found), 6)
        for values, inner in found:
            np.testing.assert_array_equal(values, expected)
            self.assertEqual(set(inner), {inner[0]} if inner else set())

    def test_threads_do_not_matter(self):
        all_threads = pixelexact.get_threads()
        before = pixelexact.probe(self.grid, "u", self.points[:5000]).values
        pixelexact.set_threads(1)
        self.assertEqual(pixelexact.get_threads(), 1)
        after = pixelexact.probe(self.grid, "u", self.points[:5000]).values
        pixelexact.set_threads()
        self.assertEqual(pixelexact.get_threads(), all_threads)
        np.testing.assert_array_equal(before, after)
        with self.assertRaises(ValueError):
            pixelexact.set_threads(0)


if __name__ == "__main__":
    unittest.main()
