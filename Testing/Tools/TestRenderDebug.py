# SPDX-License-Identifier: BSD-3-Clause
"""pixelexact render: pictures that debug a mesh and buffers that prove values."""

import unittest

import numpy as np

from TestRender import EXACT, NOTHING, RenderTest, tetrahedra_of_cube
from tool import CASES, MIDDLE, View, case, plain_grid, unit, unit_cube_grid

NONE, ONCE, SEVERAL, UNDECIDED, NOT_COVERED = 0, 1, 2, 3, 255
GREY, BLUE, ORANGE, RED = [64, 64, 64], [168, 212, 240], [230, 159, 0], [213, 60, 0]
DEBUG_BUFFERS = {"Owners", "Coverage", "Value_lower", "Value_upper", "Jump"}


def extruded(*quads):
    """Linear hexahedra over quadrilaterals in x, y, from z = 0 to 1, with u = x."""
    points = [[x, y, z] for quad in quads for z in (0.0, 1.0) for x, y in quad]
    cells = [(12, list(range(8 * i, 8 * i + 8))) for i in range(len(quads))]
    return plain_grid(points, cells, [("u", [point[0] for point in points])])


def square(x0, x1):
    return [(x0, 0.0), (x1, 0.0), (x1, 1.0), (x0, 1.0)]


def preimages(quad, x):
    """How many (r, s) in the unit square the quadrilateral's bilinear map takes to each of the
    points; and whether a root lies too near the square's border, or another root, to say."""
    quad = np.asarray(quad, float)
    a, b, c = quad[0], quad[1] - quad[0], quad[3] - quad[0]
    d = quad[2] - quad[1] - quad[3] + quad[0]

    def cross(v, w):
        return v[..., 0] * w[..., 1] - v[..., 1] * w[..., 0]

    # x - a - s c is parallel to b + s d.
    y = x - a
    k0, k1, k2 = cross(y, b), cross(y, d) - cross(c, b), np.full(y.shape[:-1], -cross(c, d))
    root = np.sqrt(np.maximum(k1**2 - 4 * k2 * k0, 0))
    real = k1**2 - 4 * k2 * k0 > 0
    count = np.zeros(y.shape[:-1], int)
    doubtful = np.abs(k1**2 - 4 * k2 * k0) < 1e-9
    for sign in (-1, 1):
        s = (-k1 + sign * root) / (2 * k2)
        along = b + s[..., None] * d
        r = ((y - s[..., None] * c) * along).sum(-1) / (along**2).sum(-1)
        margin = np.minimum(np.minimum(r, 1 - r), np.minimum(s, 1 - s))
        count += real & (margin > 0)
        doubtful |= real & (np.abs(margin) < 1e-9)
    return count, doubtful


class Owners(RenderTest):
    def owners(self, source, view, *options, plane=(0, 0, 0.5, 0, 0, 1)):
        """Summary, buffers and picture; the buffers, the picture and the counts agree."""
        summary, buffers, image = self.render(
            source, [plane], *view.options(), "--owners", *options
        )
        coverage, owners = buffers["Coverage"], buffers["Owners"]
        self.assertEqual((coverage.dtype, owners.dtype), (np.uint8, np.int32))
        names = ["none", "once", "several", "undecided"]
        counts = {name: int((coverage == i).sum()) for i, name in enumerate(names)}
        self.assertEqual(summary["coverage"], counts)
        colors = {NOT_COVERED: [255] * 3, NONE: GREY, ONCE: BLUE}
        for value, color in colors.items():
            self.assertTrue((image[coverage == value] == color).all())
        several = coverage == SEVERAL
        self.assertTrue((image[several & (owners == 2)] == ORANGE).all())
        self.assertTrue((image[several & (owners > 2)] == RED).all())
        self.assertTrue((owners[coverage == NOT_COVERED] == -1).all())
        self.assertTrue((owners[coverage == NONE] == 0).all())
        return buffers

    def test_gaps_and_overlaps(self):
        quads = [square(0.0, 1.0), square(0.5, 1.5), square(0.75, 1.25), square(2.0, 3.0)]
        source = self.write("overlap.vtu", extruded(*quads))
        view = View([1.507, 0.5, 5], [1.507, 0.5, 0], [0, 1, 0], 87, 41, scale=0.83)
        buffers = self.owners(source, view)
        origin, _ = view.rays()
        x, y = origin[..., 0], origin[..., 1]
        held = sum(((x > q[0][0]) & (x < q[1][0])).astype(int) for q in quads)
        inside = (y > 0) & (y < 1) & (x > 0) & (x < 3)
        held = np.where(inside, held, -1)
        self.assertTrue((buffers["Owners"] == held).all())
        expected = np.select(
            [held < 0, held == 0, held == 1], [NOT_COVERED, NONE, ONCE], default=SEVERAL
        )
        self.assertTrue((buffers["Coverage"] == expected).all())
        self.assertEqual(set(np.unique(held)), {-1, 0, 1, 2, 3})

    def test_a_fold_covers_twice(self):
        quad = [(0.0, 0.0), (1.0, 0.0), (0.1, 0.15), (0.0, 1.0)]
        source = self.write("fold.vtu", extruded(quad))
        view = View([0.5, 0.5, 5], [0.5, 0.5, 0], [0, 1, 0], 120, 120, scale=0.6)
        buffers = self.owners(source, view)
        origin, _ = view.rays()
        count, doubtful = preimages(quad, origin[..., :2])
        self.assertGreater((count == 2).sum(), 50)
        sure = ~doubtful
        self.assertTrue((np.maximum(buffers["Owners"], 0) == count)[sure].all())
        self.assertTrue(((buffers["Coverage"] == SEVERAL) == (count == 2))[sure].all())

    def test_faces_that_are_shared_are_no_overlap(self):
        """Pixel centres on faces, edges and vertices of tetrahedra."""
        source = self.write("tets.vtu", tetrahedra_of_cube(4))
        for origin, normal in [([0, 0, 0.5], [0, 0, 1]), ([0.5, 0.5, 0.5], [1, 1, 1])]:
            centre = np.array([0.5, 0.5, 0.5])
            view = View(centre + 5 * unit(normal), centre, [0, 1, 0], 65, 65, scale=0.65)
            buffers = self.owners(source, view, plane=[*origin, *normal])
            seen = buffers["Verdict"] == EXACT
            self.assertTrue((buffers["Coverage"][seen] == ONCE).all())
            self.assertGreater(buffers["Owners"][seen].max(), 2)

    def test_sound_meshes_are_covered_once(self):
        for name in CASES:
            with self.subTest(name=name):
                plane = [0.05, -0.1, 0.03, 0.3, -0.2, 1.0]
                if name.startswith("dolfinx"):
                    plane = [1.0, 0.5, -1.0, 0.3, 1.0, 0.2]
                summary, buffers, _ = self.render(
                    case(name), [plane], "--size", "60x60", "--owners"
                )
                seen = buffers["Verdict"] == EXACT
                self.assertGreater(seen.sum(), 100)
                self.assertTrue((buffers["Coverage"][seen] == ONCE).all())
                self.assertEqual(summary["coverage"]["once"], seen.sum())
                self.assertEqual(summary["coverage"]["several"], 0)
                self.assertEqual(summary["coverage"]["undecided"], 0)


class Enclosures(RenderTest):
    def setUp(self):
        super().setUp()
        self.cube = self.write("cube.vtu", unit_cube_grid())
        self.view = View([0.5, 0.5, 5], [0.5, 0.5, 0], [0, 1, 0], 41, 31, scale=0.6)
        self.plane = [[0, 0, 0.5, 0.1, 0.2, 1]]

    def test_they_hold_the_value(self):
        """u = x exactly: so the exact value is the hit's x, a double."""
        summary, buffers, _ = self.render(
            self.cube, self.plane, *self.view.options(), "--enclosures"
        )
        exact = buffers["Verdict"] == EXACT
        lower, upper = buffers["Value_lower"], buffers["Value_upper"]
        x = buffers["Position"][..., 0]
        self.assertTrue(((lower <= x) & (x <= upper))[exact].all())
        self.assertTrue(np.isnan(lower[~exact]).all() and np.isnan(upper[~exact]).all())
        width = (upper - lower)[exact]
        self.assertLess(width.max(), 1e-13)
        self.assertEqual(summary["enclosures"], {"widest": width.max(), "unbounded": 0})

    def test_magnitudes_and_components(self):
        vectors = [[x, 2 * x, -2 * x] for x in [0.0, 1.0, 1.0, 0.0] * 2]
        source = self.write("vector.vtu", unit_cube_grid([("v", vectors)]))
        for options, factor in [([], 3), (["--component", "2"], -2)]:
            _, buffers, _ = self.render(
                source, self.plane, *self.view.options(), "--enclosures", *options, field="v"
            )
            exact = buffers["Verdict"] == EXACT
            value = factor * buffers["Position"][exact][:, 0].astype(np.longdouble)
            self.assertTrue((buffers["Value_lower"][exact] <= value).all())
            self.assertTrue((value <= buffers["Value_upper"][exact]).all())

    def test_curved_meshes(self):
        for name in CASES:
            with self.subTest(name=name):
                plane = [0.05, -0.1, 0.03, 0.3, -0.2, 1.0]
                if name.startswith("dolfinx"):
                    plane = [1.0, 0.5, -1.0, 0.3, 1.0, 0.2]
                summary, buffers, _ = self.render(
                    case(name), [plane], "--size", "60x60", "--enclosures"
                )
                self.assertEqual(summary["enclosures"]["unbounded"], 0)
                low, high = summary["value_range"]
                self.assertLess(summary["enclosures"]["widest"], 1e-9 * (high - low))
                exact = buffers["Verdict"] == EXACT
                slack = 1e-13 * (high - low)
                value = buffers["Value"][exact]
                self.assertTrue((value >= buffers["Value_lower"][exact] - slack).all())
                self.assertTrue((value <= buffers["Value_upper"][exact] + slack).all())

    def test_colours_that_are_not_decided(self):
        """The whole map lies within an ulp of 0.5: where x is 0.5, the column in the middle of the
        picture, no enclosure decides; everywhere else one end of the map is right."""
        flat = [[0, 0, 0.5, 0, 0, 1]]
        colors = ["--range", "0.5,0.5000000000000001", "--undecided-color", "0,1,0"]
        summary, buffers, image = self.render(
            self.cube, flat, *self.view.options(), "--show-undecided", *colors
        )
        middle = (buffers["Verdict"] == EXACT) & (buffers["Position"][..., 0] == 0.5)
        self.assertEqual(middle.sum(), (buffers["Verdict"][:, 20] == EXACT).sum())
        self.assertTrue(((image == [0, 255, 0]).all(-1) == middle).all())
        self.assertEqual(summary["color_undecided"], middle.sum())
        # A range that doubles resolve leaves hardly any.
        off = ["--range", "-0.0131,1.0177"]
        summary, _, _ = self.render(self.cube, flat, *self.view.options(), "--show-undecided", *off)
        self.assertLess(summary["color_undecided"], 0.01 * summary["pixels"]["exact"])


class Validity(RenderTest):
    def test_elements_by_verdict(self):
        crossed = [(2.0, 0.0), (3.0, 1.0), (3.0, 0.0), (2.0, 1.0)]
        source = self.write("two.vtu", extruded(square(0.0, 1.0), crossed))
        view = View([1.5, 0.5, 5], [1.5, 0.5, 0], [0, 1, 0], 90, 30, scale=0.6)
        summary, buffers, image = self.render(
            source, [[0, 0, 0.5, 0, 0, 1]], *view.options(), "--show", "validity"
        )
        exact = buffers["Verdict"] == EXACT
        for element, color in [(0, BLUE), (1, RED)]:
            its = exact & (buffers["Element"] == element)
            self.assertGreater(its.sum(), 50)
            self.assertTrue((image[its] == color).all())
        counts = [int((exact & (buffers["Element"] == e)).sum()) for e in (0, 1)]
        self.assertEqual(
            summary["validity"], {"valid": counts[0], "inverted": counts[1], "undecided": 0}
        )
        self.assertTrue((image[buffers["Verdict"] == NOTHING] == 255).all())


# By cell of `quarters`: the constant, d/dx, d/dy and d2/dxdy of u.
DISCONTINUOUS = np.array([[1, 2, 3, 0], [1.5, -1, 2, 0.5], [0, 0.25, 3, 1], [7, 1, 1, -2]])
CONTINUOUS = np.tile([0.1, 0.3, -0.7, 0.9], (4, 1))
# Equal on x = 1, with other slopes beside it.
BROKEN = np.array([[0, 1, 0, 0], [-1, 2, 0, 0]] * 2)


def bilinear(coefficients, x, y):
    a, b, c, d = np.moveaxis(coefficients, -1, 0)
    return a + b * x + c * y + d * x * y


def quarters(coefficients):
    """Four cubes of [0,2] x [0,2] x [0,1], cell 2 j + i at x from i and y from j, each with points
    and a polynomial of its own."""
    points, values = [], []
    for cell, polynomial in enumerate(coefficients):
        i, j = cell % 2, cell // 2
        for z in (0.0, 1.0):
            for x, y in [(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)]:
                points.append([float(x), float(y), z])
                values.append(float(bilinear(polynomial, x, y)))
    return plain_grid(points, [(12, list(range(8 * k, 8 * k + 8))) for k in range(4)],
                      [("u", values)])


class Jumps(RenderTest):
    VIEW = View([1, 1, 5], [1, 1, 0], [0, 1, 0], 71, 53, scale=1.1)
    PLANE = [[0, 0, 0.5, 0.1, 0.2, 1]]

    def show(self, coefficients, *options, field="u", plane=None):
        source = self.write("quarters.vtu", quarters(coefficients))
        return self.render(source, plane or self.PLANE, *self.VIEW.options(), "--show", "jumps",
                           *options, field=field)

    def expected(self, coefficients, buffers):
        """The jump of each pixel in closed form; NaN where no face is beside it."""
        jump = np.full(buffers["Verdict"].shape, np.nan)
        x, y = buffers["Position"][..., 0], buffers["Position"][..., 1]
        element = buffers["Element"]
        self.assertGreater(np.nanmean(np.diff(y, axis=0)), 0)  # rows go upwards
        for axis in (1, 0):
            here, there = [slice(None)] * 2, [slice(None)] * 2
            here[axis], there[axis] = slice(None, -1), slice(1, None)
            here, there = tuple(here), tuple(there)
            a, b = element[here], element[there]
            crosses = (a >= 0) & (b >= 0) & (a != b)
            # Where the way from hit to hit is at x = 1, or at y = 1.
            along = (x if axis == 1 else y)
            part = (1 - along[here]) / (along[there] - along[here])
            at_x = x[here] + part * (x[there] - x[here])
            at_y = y[here] + part * (y[there] - y[here])
            size = np.abs(bilinear(coefficients[b], at_x, at_y)
                          - bilinear(coefficients[a], at_x, at_y))
            jump[here] = np.fmax(jump[here], np.where(crosses, size, np.nan))
        return jump

    def test_discontinuous_fields_in_closed_form(self):
        summary, buffers, image = self.show(DISCONTINUOUS)
        wanted = self.expected(DISCONTINUOUS, buffers)
        found = buffers["Jump"]
        self.assertGreater(np.isfinite(wanted).sum(), 80)
        self.assertTrue((np.isnan(found) == np.isnan(wanted)).all())
        low, high = summary["value_range"]
        error = np.nanmax(np.abs(found - wanted))
        self.assertLess(error, 1e-12 * (high - low))
        self.assertTrue((image[np.isnan(found) & (buffers["Verdict"] == EXACT)] == 225).all())
        self.assertTrue((image[found == np.nanmax(found)] == [75, 0, 80]).all())
        jumps = summary["jumps"]
        self.assertEqual((jumps["continuous"], jumps["not_finite"], jumps["not_found"]), (0, 0, 0))
        self.assertGreaterEqual(jumps["jumping"], np.isfinite(found).sum())
        largest = jumps["largest"]
        self.assertEqual(largest["value"], np.nanmax(found))
        a, b = largest["elements"]
        x, y, _ = largest["position"]
        self.assertLess(min(abs(x - 1), abs(y - 1)), 1e-12)
        difference = bilinear(DISCONTINUOUS[b], x, y) - bilinear(DISCONTINUOUS[a], x, y)
        self.assertAlmostEqual(abs(difference), largest["value"], delta=1e-12 * (high - low))

    def test_continuous_fields_are_continuous(self):
        summary, buffers, image = self.show(CONTINUOUS)
        found = buffers["Jump"]
        self.assertTrue((found[np.isfinite(found)] == 0).all())
        self.assertTrue((image[found == 0] == BLUE).all())
        self.assertGreater(summary["jumps"]["continuous"], 80)
        self.assertEqual(summary["jumps"]["jumping"], 0)
        self.assertIsNone(summary["jumps"]["largest"])

    def test_slopes_of_a_continuous_field(self):
        """u has no jump, and grad(u) has one of 1 at x = 1 alone."""
        summary, _, _ = self.show(BROKEN)
        self.assertEqual(summary["jumps"]["jumping"], 0)
        summary, buffers, _ = self.show(BROKEN, field="mag(grad(u))")
        found = buffers["Jump"]
        np.testing.assert_allclose(found[found > 0], 1, rtol=0, atol=1e-12)
        self.assertEqual(summary["jumps"]["jumping"], (found > 0).sum())
        self.assertGreater((found == 0).sum(), 40)
        self.assertGreater(summary["jumps"]["jumping"], 30)

    def test_the_boundary_and_several_layers(self):
        """The boundary's upper side is plane, so that it crosses faces where the plane does."""
        source = self.write("quarters.vtu", quarters(DISCONTINUOUS))
        summary, buffers, _ = self.render(source, [], "--boundary", *self.VIEW.options(),
                                          "--show", "jumps")
        wanted = self.expected(DISCONTINUOUS, buffers)
        self.assertTrue((np.isnan(buffers["Jump"]) == np.isnan(wanted)).all())
        self.assertLess(np.nanmax(np.abs(buffers["Jump"] - wanted)), 1e-11)
        self.assertEqual(summary["jumps"]["not_found"], 0)
        # Where one layer hides the other there is no face.
        _, two, _ = self.render(source, [[0.5, 0, 0.5, 1, 0, 0.2]], "--plane", "0,0,0.5,0,0,1",
                                *self.VIEW.options(), "--show", "jumps")
        self.assertGreater(np.isfinite(two["Jump"]).sum(), 80)

    def test_report_and_refusals(self):
        source = self.write("quarters.vtu", quarters(DISCONTINUOUS))
        base = ["render", source, "--field", "u", "--plane", "0,0,0.5,0,0,1", "--size", "30x30",
                "--output", self.folder / "i.png"]
        done = self.succeeds(*base, "--show", "jumps")
        for word in ["jumps", "continuous", "largest", "between elements", "dark purple"]:
            self.assertIn(word, done.stdout)
        for options in [["--show", "jumps", "--owners"], ["--show", "jumps", "--samples", "4"],
                        ["--buffers", self.folder / "b.vti", "--arrays", "Jump"]]:
            self.fails(2, *base, *options)


class OnRequest(RenderTest):
    def test_a_plain_render_has_nothing_of_it(self):
        summary, buffers, _ = self.render(case("escher_tet_g3_p3"), [[0, 0, 0, 0, 0, 1]],
                                          "--size", "20x20")
        self.assertFalse(DEBUG_BUFFERS & set(buffers))
        for key in ["coverage", "validity", "jumps", "enclosures", "color_undecided"]:
            self.assertNotIn(key, summary)

    def test_options_that_exclude_each_other(self):
        base = ["render", case("escher_tet_g3_p3"), "--field", "u", *MIDDLE, "--size", "9x9",
                "--output", self.folder / "i.png"]
        for options in [
            ["--owners", "--show", "validity"],
            ["--owners", "--show-undecided"],
            ["--show", "validity", "--show-undecided"],
            ["--show", "nothing"],
            ["--undecided-color", "0,0,2"],
        ]:
            self.fails(2, *base, *options)

    def test_table(self):
        shot = [case("escher_tet_g3_p3"), "--field", "u", *MIDDLE, "--size", "20x10"]
        done = self.succeeds("render", *shot, "--output", self.folder / "i.png", "--owners",
                             "--enclosures")
        for word in ["coverage", "once", "enclosures", "widest"]:
            self.assertIn(word, done.stdout)


if __name__ == "__main__":
    unittest.main()
