"""Selections and picks find the cut's elements, never the mesh's outside, which is not seen."""

import unittest

import numpy
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkCollection

import scene

TORUS = "toroid_hex_g3_p6.vtu"


class Selection(unittest.TestCase):
    def setUp(self):
        self.view = scene.view()
        self.grid = simple.PixelExactGridReader(FileName=[scene.data(TORUS)])
        self.shown = simple.Show(self.grid)
        self.shown.SetRepresentationType("PixelExact")
        self.shown.CutFunction.Origin = [0, 0, 0]
        self.shown.CutFunction.Normal = [0, 0, 1]
        simple.ColorBy(self.shown, ("POINTS", "u"))
        self.shown.SetScalarBarVisibility(self.view, False)
        simple.Render(self.view)

    def tearDown(self):
        simple.ResetSession()

    def probed(self, places):
        """What the probe knows where rays through pixels meet the plane z = 0."""
        begin, ahead = scene.rays(self.view, places)
        return scene.probe(self.grid, begin - numpy.outer(begin[:, 2] / ahead[2], ahead))

    def selected_cells(self, corners):
        """Of how many representations, and which cells."""
        representations, selections = vtkCollection(), vtkCollection()
        self.view.SMProxy.SelectSurfaceCells(corners, representations, selections, 0)
        cells = set()
        for i in range(selections.GetNumberOfItems()):
            ids = servermanager._getPyProxy(selections.GetItemAsObject(i)).IDs
            cells.update(list(ids)[1::2])  # pairs of process and cell
        return representations.GetNumberOfItems(), cells

    def test_pixels_elements(self):
        rows, columns = numpy.mgrid[20:220:20, 40:280:20]
        places = numpy.stack([columns.ravel(), rows.ravel()], axis=1)
        found = self.probed(places)
        hits = 0
        for place, verdict, element in zip(places, found["Verdict"], found["Element"]):
            x, y = (int(part) for part in place)
            count, cells = self.selected_cells([x, y, x, y])
            if verdict == 1:
                hits += 1
                self.assertEqual(cells, {int(element)})
                self.assertEqual(count, 1)
            else:
                self.assertEqual(cells, set())
        self.assertGreater(hits, 15)

    def test_a_rectangle_has_what_is_seen_in_it(self):
        corners = [60, 60, 140, 160]
        rows, columns = numpy.mgrid[60:161, 60:141]
        places = numpy.stack([columns.ravel(), rows.ravel()], axis=1)
        found = self.probed(places)
        expected = set(found["Element"][found["Verdict"] == 1].tolist())
        _, cells = self.selected_cells(corners)
        self.assertEqual(cells, expected)
        total = self.grid.GetDataInformation().GetNumberOfCells()
        self.assertLess(len(cells), total)

    def test_behind_a_filter_the_cells_are_its_own(self):
        # These are not the source's numbers, which elements keep for reports.
        part = simple.Threshold(
            Input=simple.PixelExactPack(Input=self.grid), Scalars=["POINTS", "u"]
        )
        part.LowerThreshold, part.UpperThreshold = -0.7, 0.5
        simple.Hide(self.grid)
        shown = simple.Show(part)
        shown.SetRepresentationType("PixelExact")
        shown.CutFunction.Origin = [0, 0, 0]
        shown.CutFunction.Normal = [0, 0, 1]
        simple.Render(self.view)
        self.assertLess(part.GetDataInformation().GetNumberOfCells(), 48)
        cells_of_source, cells_of_part = servermanager.Fetch(self.grid), servermanager.Fetch(part)
        told = []
        for x in range(40, 280, 20):
            shown.PickedPixel = [x, 120]
            simple.Render(self.view)
            shown.UpdatePropertyInformation()
            verdict, element, *_ = shown.GetProperty("Picked")
            if verdict != 1:
                continue
            _, cells = self.selected_cells([x, 120, x, 120])
            (cell,) = cells
            seen, marked = (
                vtk_to_numpy(grid.GetCell(int(number)).GetPoints().GetData()).copy()
                for grid, number in ((cells_of_source, element), (cells_of_part, cell))
            )
            numpy.testing.assert_array_equal(marked, seen)
            told.append((element, cell))
        self.assertTrue(any(element != cell for element, cell in told))

    def test_points_are_not_selected(self):
        representations, selections = vtkCollection(), vtkCollection()
        self.view.SMProxy.SelectSurfacePoints([10, 10, 300, 220], representations, selections, 0)
        self.assertEqual(selections.GetNumberOfItems(), 0)

    def test_picks(self):
        places = numpy.array([[90, 120], [230, 120], [160, 120], [2, 2]])
        found = self.probed(places)
        told = 0
        for i, (x, y) in enumerate(places.tolist()):
            self.shown.PickedPixel = [x, y]
            simple.Render(self.view)
            self.shown.UpdatePropertyInformation()
            picked = list(self.shown.GetProperty("Picked"))
            text = str(self.shown.GetProperty("PickedText")[0])
            self.assertEqual(picked[0], found["Verdict"][i])
            if picked[0] != 1:
                self.assertEqual(picked[1], -1)
                self.assertEqual(text, "")
                continue
            told += 1
            self.assertEqual(picked[1], found["Element"][i])
            self.assertAlmostEqual(picked[5], found["u"][i], delta=1e-12)
            self.assertLessEqual(picked[6], picked[5])
            self.assertLessEqual(picked[5], picked[7])
            self.assertLess(picked[7] - picked[6], 1e-9)
            self.assertIn(f"element {found['Element'][i]}, xi (", text)
            self.assertIn("u = ", text)
        self.assertGreater(told, 0)
        self.assertEqual(self.shown.GetProperty("UnknownPixels")[0], 0)


class PlotOverLine(unittest.TestCase):
    def tearDown(self):
        simple.ResetSession()

    def test_values_and_boundaries(self):
        grid = simple.PixelExactGridReader(FileName=[scene.data(TORUS)])
        line = simple.PixelExactPlotOverLine(
            Input=grid, Point1=[-1.5, -0.1, 0.05], Point2=[1.5, 0.2, 0.05], Resolution=200
        )
        found = servermanager.Fetch(line)
        data = found.GetPointData()
        points = vtk_to_numpy(found.GetPoints().GetData())
        self.assertGreater(len(points), 201)
        length = vtk_to_numpy(data.GetArray("arc_length"))
        self.assertTrue((numpy.diff(length) >= 0).all())
        self.assertAlmostEqual(length[-1], numpy.linalg.norm(points[-1] - points[0]), delta=1e-14)
        probed = scene.probe(grid, points)
        numpy.testing.assert_array_equal(vtk_to_numpy(data.GetArray("u")), probed["u"])

    def test_defaults_are_the_meshs(self):
        grid = simple.PixelExactGridReader(FileName=[scene.data(TORUS)])
        grid.UpdatePipeline()
        line = simple.PixelExactPlotOverLine(Input=grid)
        bounds = grid.GetDataInformation().GetBounds()
        numpy.testing.assert_allclose(list(line.Point1), bounds[0::2])
        numpy.testing.assert_allclose(list(line.Point2), bounds[1::2])


if __name__ == "__main__":
    scene.main()
