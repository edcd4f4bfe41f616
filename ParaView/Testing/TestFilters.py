"""The filters' numbers, against the solver's library, the program and closed forms."""

import unittest

import numpy
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy

import scene

NAME = "toroid_hex_g3_p6"


def cell_array(source, name):
    return vtk_to_numpy(servermanager.Fetch(source).GetCellData().GetArray(name))


class Filters(unittest.TestCase):
    def setUp(self):
        self.table = scene.oracle(f"{NAME}.oracle.csv")
        self.points = scene.numbers(self.table, "x", "y", "z")
        self.plain = simple.XMLUnstructuredGridReader(FileName=[scene.data(f"{NAME}.vtu")])

    def tearDown(self):
        simple.ResetSession()

    def test_convert(self):
        converted = simple.PixelExactConvert(self.plain)
        converted.UpdatePipeline()
        self.assertIn("PixelExact.Field.u.Coefficients", converted.FieldData.keys())
        found = scene.probe(converted, self.points)
        inside = found["Verdict"] == 1
        values = scene.numbers(self.table, "u")[:, 0]
        self.assertLess(numpy.abs(found["u"] - values)[inside].max(), 1e-9 * abs(values).max())

    def test_probe(self):
        found = scene.probe(self.plain, self.points, ComputeGradients=1, Enclosures=1)
        inside = found["Verdict"] == 1
        self.assertGreater(inside.mean(), 0.95)
        values = scene.numbers(self.table, "u")[:, 0]
        gradients = scene.numbers(self.table, "dudx", "dudy", "dudz")
        self.assertTrue((found["u_lower"] <= found["u"])[inside].all())
        self.assertTrue((found["u"] <= found["u_upper"])[inside].all())
        off = numpy.abs(found["u_Gradient"] - gradients)[inside].max()
        self.assertLess(off, 1e-8 * abs(gradients).max())
        theirs = scene.tool_values([scene.data(f"{NAME}.vtu")], "u", self.points)
        if theirs is not None:
            self.assertTrue(numpy.array_equal(found["u"][inside], theirs[inside, 0]))
        self.assertLess(numpy.abs(found["u"] - values)[inside].max(), 1e-9 * abs(values).max())

    def test_calculator(self):
        """The field is the expression itself, and not what is between its values at the points."""
        slope = simple.PixelExactCalculator(
            self.plain, ResultArrayName="slope", Function="mag(grad(u))")
        slope.UpdatePipeline()
        self.assertIn("slope", slope.PointData.keys())
        found = scene.probe(slope, self.points)
        inside = found["Verdict"] == 1
        gradients = scene.numbers(self.table, "dudx", "dudy", "dudz")
        expected = numpy.linalg.norm(gradients, axis=1)
        self.assertLess(numpy.abs(found["slope"] - expected)[inside].max(), 1e-9 * expected.max())

    def test_calculator_of_paraviews_words(self):
        """What the buttons and menus of ParaView's Calculator insert, against NumPy."""
        name = "mfem_escher_tet_darcy_p3"
        reader = simple.PixelExactMFEMReader(FileName=scene.data(f"{name}/{name}.mesh"))
        reader.UpdatePipeline()
        box = reader.GetDataInformation().GetBounds()
        points = numpy.random.default_rng(5).uniform(box[::2], box[1::2], (500, 3))
        plain = scene.probe(reader, points)
        inside = plain["Verdict"] == 1
        self.assertGreater(inside.sum(), 50)
        (x, y, z), flux, p = points.T, plain["flux"], plain["pressure"]
        for text, expected in (
            ("flux_X", flux[:, 0]),
            ("flux_Y*coordsX - flux_Z^2", flux[:, 1] * x - flux[:, 2] ** 2),
            ("dot(flux,iHat+2*jHat-kHat)", flux @ [1, 2, -1]),
            ("mag(cross(coords,flux))", numpy.linalg.norm(numpy.cross(points, flux), axis=1)),
            ("ln(1+abs(pressure))+log10(2+coordsZ^2)", numpy.log(1 + abs(p)) + numpy.log10(2 + z * z)),
            ("asin(sin(coordsY)/2)+sinh(pressure)+floor(coordsX)", numpy.arcsin(numpy.sin(y) / 2)
             + numpy.sinh(p) + numpy.floor(x)),
        ):
            with self.subTest(text):
                made = simple.PixelExactCalculator(reader, ResultArrayName="made", Function=text)
                found = scene.probe(made, points)["made"][inside]
                numpy.testing.assert_allclose(found, expected[inside], rtol=1e-12, atol=1e-12)
        refused = simple.PixelExactCalculator(reader, ResultArrayName="made", Function="norm(flux)")
        with scene.messages() as heard:
            refused.UpdatePipeline()
        self.assertIn("v/mag(v)", heard[0])

    def test_warp(self):
        """Moved along a constant direction by its own values, a point has the value that it had."""
        moved = simple.PixelExactWarp(
            self.plain, Displacement="u", ScaleFactor=0.01, Direction=[0.0, 0.0, 1.0])
        moved.UpdatePipeline()
        u = scene.numbers(self.table, "u")
        there = self.points + 0.01 * u * numpy.array([0.0, 0.0, 1.0])
        before, after = scene.probe(self.plain, self.points), scene.probe(moved, there)
        both = (before["Verdict"] == 1) & (after["Verdict"] == 1)
        self.assertGreater(both.mean(), 0.95)
        self.assertLess(numpy.abs(after["u"] - before["u"])[both].max(), 1e-9 * abs(u).max())

    def test_probe_along_a_line(self):
        line = simple.Line(Point1=[-2, 0, 0], Point2=[2, 0, 0], Resolution=100)
        probe = simple.PixelExactProbe(Input=line, Source=self.plain)
        probe.UpdatePipeline()
        self.assertEqual(probe.GetDataInformation().GetNumberOfPoints(), 101)
        self.assertEqual(tuple(probe.PointData["Verdict"].GetRange()), (0.0, 1.0))

    def test_certify(self):
        certified = simple.PixelExactCertify(self.plain, Field="u")
        certified.UpdatePipeline()
        self.assertEqual(tuple(certified.CellData["Verdict"].GetRange()), (0.0, 0.0))
        lower, upper = cell_array(certified, "u_lower"), cell_array(certified, "u_upper")
        element = scene.numbers(self.table, "element")[:, 0].astype(int)
        values = scene.numbers(self.table, "u")[:, 0]
        self.assertTrue((lower[element] <= values + 1e-12).all())
        self.assertTrue((values <= upper[element] + 1e-12).all())
        self.assertGreater(cell_array(certified, "JacobianLower").min(), 0.0)

    def test_lists_of_fields(self):
        """Panels offer the input's fields."""
        self.plain.UpdatePipeline()
        other = simple.PixelExactConvert(self.plain)
        other.UpdatePipeline()
        for made, names in (
            (simple.PixelExactWarp(Input=self.plain), ["Displacement"]),
            (simple.PixelExactCertify(Input=self.plain), ["Field"]),
            (simple.PixelExactContour(Input=self.plain), ["ContourBy"]),
            (simple.PixelExactIntegrate(Input=other), ["Field", "IsoField"]),
            (simple.PixelExactDifference(Input=other, Other=other), ["Field", "OtherField"]),
        ):
            for name in names:
                domain = made.SMProxy.GetProperty(name).FindDomain("vtkSMArrayListDomain")
                offered = [domain.GetString(i) for i in range(domain.GetNumberOfStrings())]
                self.assertIn("u", offered, name)
                self.assertEqual("Same Name" in offered, name == "OtherField")

    def test_warp_by_an_expression(self):
        """It replaces the field of the list: u moves points along z alone."""
        moved = [
            simple.PixelExactWarp(Input=self.plain, ScaleFactor=0.01, **chosen)
            for chosen in (
                {"Displacement": "u", "Direction": [0.0, 0.0, 1.0]},
                {"Displacement": "attribute", "Expression": "vec(0,0,u)"},
            )
        ]
        points = self.points + [0.0, 0.0, 0.005]
        values = [scene.probe(one, points)["u"] for one in moved]
        self.assertGreater(numpy.isfinite(values[0]).sum(), 50)
        numpy.testing.assert_allclose(values[1], values[0], rtol=0, atol=1e-9)

    def test_certify_no_field(self):
        """What is chosen before the input is known, too, is no field."""
        self.plain.UpdatePipeline()
        chosen = simple.PixelExactCertify(self.plain, Field="None")
        early = simple.PixelExactCertify(simple.OpenDataFile(self.plain.FileName[0]))
        for certified in [chosen, early]:
            self.assertEqual(certified.Field, "None")
            certified.UpdatePipeline()
            self.assertEqual(tuple(certified.CellData["Verdict"].GetRange()), (0.0, 0.0))
            self.assertIsNone(certified.CellData["u_lower"])

    def test_subdivide(self):
        cells = simple.PixelExactSubdivide(self.plain, Level=2)
        data = servermanager.Fetch(cells)
        self.assertEqual(data.GetNumberOfCells(), 48 * 4**3)
        nodes = numpy.array([data.GetPoint(i) for i in range(0, data.GetNumberOfPoints(), 37)])
        values = vtk_to_numpy(data.GetPointData().GetArray("u"))[::37]
        found = scene.probe(self.plain, nodes)
        inside = found["Verdict"] == 1
        self.assertGreater(inside.mean(), 0.9)
        self.assertLess(numpy.abs(found["u"] - values)[inside].max(), 1e-12)

    def test_linear_cut(self):
        cut = simple.PixelExactLinearCut(self.plain, Resolution=32)
        cut.CutFunction.Origin = [0, 0, 0.1]
        cut.CutFunction.Normal = [0, 0, 1]
        data = servermanager.Fetch(cut)
        self.assertGreater(data.GetNumberOfCells(), 500)
        nodes = numpy.array([data.GetPoint(i) for i in range(data.GetNumberOfPoints())])
        self.assertLess(numpy.abs(nodes[:, 2] - 0.1).max(), 1e-12)

    def difference(self, first, second):
        found = simple.PixelExactDifference(
            Input=first, Other=second, Field="u", Size=[120, 100]
        )
        found.CutFunction.Origin = [0, 0, 0.1]
        found.CutFunction.Normal = [0, 0, 1]
        return servermanager.Fetch(found)

    def test_truncate_and_difference(self):
        converted = simple.PixelExactConvert(self.plain)
        truncated = simple.PixelExactTruncate(converted, Order=3)
        image = self.difference(converted, truncated)
        side = vtk_to_numpy(image.GetPointData().GetArray("Side"))
        value = vtk_to_numpy(image.GetPointData().GetArray("Value"))[side == 1]
        self.assertGreater((side == 1).sum(), 1000)
        bounds = servermanager.Fetch(truncated).GetFieldData().GetArray("u_LargestChange")
        self.assertLessEqual(numpy.abs(value).max(), bounds.GetValue(0))
        self.assertGreater(numpy.abs(value).max(), 0.02 * bounds.GetValue(0))

    def test_integrate(self):
        found = simple.PixelExactIntegrate(self.plain, Field="u", Tolerance=1e-4)
        found.CutFunction.Origin = [0, 0, 0.1]
        found.CutFunction.Normal = [0, 0, 1]
        table = servermanager.Fetch(found)
        # By the program's `integrate`, proven to 6.1e-10.
        self.assertEqual(table.GetValueByName(0, "Quantity").ToString(), "Area")
        area = table.GetValueByName(0, "Value").ToDouble()
        bound = table.GetValueByName(0, "ErrorBound").ToDouble()
        self.assertLess(abs(area - 3.78253205771), bound + 1e-9)
        self.assertLess(bound, 1e-3)
        found.Over = "Boundary"
        found.Tolerance = 1e-2
        boundary = servermanager.Fetch(found)
        self.assertGreater(boundary.GetValueByName(0, "Lower").ToDouble(), 2.0 * area)

    def test_comparison(self):
        converted = simple.PixelExactConvert(self.plain)
        cuts = [simple.PixelExactLinearCut(converted, Resolution=n) for n in (16, 64)]
        found = simple.PixelExactComparison(
            Input=converted, Surfaces=cuts, Field="u", Size=[120, 100]
        )
        for cut in [*cuts, found]:
            cut.CutFunction.Origin = [0, 0, 0.1]
            cut.CutFunction.Normal = [0, 0, 1]
        table = servermanager.Fetch(found)
        self.assertEqual(table.GetNumberOfRows(), 2)
        means = vtk_to_numpy(table.GetColumnByName("MeanError"))
        self.assertGreater(means[0], 4.0 * means[1])

    def test_linear_resample(self):
        image = simple.PixelExactLinearResample(self.plain, Dimensions=[9, 10, 11])
        data = servermanager.Fetch(image)
        self.assertEqual(data.GetDimensions(), (9, 10, 11))
        arrays = data.GetPointData()
        valid = vtk_to_numpy(arrays.GetArray("vtkValidPointMask")) == 1
        values = vtk_to_numpy(arrays.GetArray("u"))
        nodes = numpy.array([data.GetPoint(i) for i in range(data.GetNumberOfPoints())])
        self.assertTrue(numpy.isnan(values[~valid]).all())
        self.assertGreater(valid.sum(), 20)
        found = scene.probe(self.plain, nodes[valid])
        self.assertTrue(numpy.array_equal(found["u"], values[valid]))

    def test_contour(self):
        lines = simple.PixelExactContour(self.plain)
        lines.CutFunction.Origin = [0, 0, 0]
        lines.CutFunction.Normal = [0, 0, 1]
        lines.ContourBy = ["POINTS", "u"]
        lines.ContourValues = [-0.3, 0.3]
        data = servermanager.Fetch(lines)
        self.assertGreater(data.GetNumberOfCells(), 2)
        self.assertTrue((vtk_to_numpy(data.GetCellData().GetArray("Certified")) == 1).all())
        points = vtk_to_numpy(data.GetPoints().GetData())
        self.assertLess(numpy.abs(points[:, 2]).max(), 1e-12)
        found = scene.probe(self.plain, points)
        inside = found["Verdict"] == 1
        self.assertGreater(inside.mean(), 0.9)
        off = numpy.abs(numpy.abs(found["u"][inside]) - 0.3)
        self.assertLess(off.max(), 1e-6)


if __name__ == "__main__":
    scene.main()
