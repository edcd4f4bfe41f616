# SPDX-License-Identifier: BSD-3-Clause
"""pixelexact render: boundaries, iso-surfaces and patches, against closed forms."""

import unittest

import numpy as np

from rendering import EXACT, SurfaceTest, numbers
from tool import CUBE, View, case, plain_grid, read_buffers, read_image, unit_cube_grid

EYE = View([2.6, -2.1, 1.9], [0.5, 0.5, 0.5], [0.1, 0.2, 1.0], 60, 48, angle=32.0)
VTK_TRIQUADRATIC_HEXAHEDRON = 29


def slabs(view, lower, upper):
    """Where rays enter and leave a box, enter > leave where they miss it."""
    origin, direction = view.rays()
    ends = np.stack([(np.asarray(end) - origin) / direction for end in (lower, upper)])
    return ends.min(axis=0).max(axis=-1), ends.max(axis=0).min(axis=-1)


def along(view, t):
    origin, direction = view.rays()
    return origin + t[..., None] * direction


def sphere_hits(view, centre, radius):
    """The nearer and the farther root along each ray, NaN where there is none."""
    origin, direction = view.rays()
    off = origin - np.asarray(centre)
    half = (off * direction).sum(axis=-1)
    square = half**2 - (off**2).sum(axis=-1) + radius**2
    root = np.sqrt(np.where(square >= 0, square, np.nan))
    return -half - root, -half + root


def quadratic_cube(function):
    """[-1,1]^3 in 8 hexahedra of order 2, whose field u interpolates `function`."""
    corners = np.array(CUBE)
    edges = [(0, 1), (1, 2), (2, 3), (3, 0), (4, 5), (5, 6), (6, 7), (7, 4)]
    edges += [(k, k + 4) for k in range(4)]
    faces = [(0, 3, 7, 4), (1, 2, 6, 5), (0, 1, 5, 4), (3, 2, 6, 7), (0, 1, 2, 3), (4, 5, 6, 7)]
    groups = [[k] for k in range(8)] + edges + faces + [range(8)]
    nodes = np.array([corners[list(group)].mean(axis=0) for group in groups])
    points = np.concatenate([nodes - corner for corner in CUBE])
    cells = [
        (VTK_TRIQUADRATIC_HEXAHEDRON, list(range(27 * k, 27 * (k + 1)))) for k in range(len(CUBE))
    ]
    return plain_grid(points.tolist(), cells, [("u", [function(p) for p in points])])


class CurvedTest(SurfaceTest):
    def setUp(self):
        super().setUp()
        self.cube = self.folder / "cube.vtu"
        fields = [("u", [x for x, _, _ in CUBE]), ("v", CUBE)]
        self.cube.write_text(unit_cube_grid(fields), encoding="utf-8")

    def check_hits(self, buffers, view, t, delta=1e-13):
        """Exact where t is finite, and there at t; returns that mask."""
        hit = np.isfinite(t)
        np.testing.assert_array_equal(buffers["Verdict"] == EXACT, hit)
        self.assertEqual((buffers["Verdict"] == EXACT).sum() + (buffers["Verdict"] == 0).sum(), hit.size)
        self.assertGreater(hit.sum(), 200)
        self.assertLess(np.abs(buffers["Depth"] - t)[hit].max(), delta)
        self.assertLess(np.abs(buffers["Position"] - along(view, t))[hit].max(), delta)
        return hit

    def check_elements(self, source, buffers, delta):
        """Values and reference coordinates are those of `probe` at the positions, where it finds
        the same element."""
        exact = buffers["Verdict"] == EXACT
        found = self.probe(source, buffers["Position"][exact])
        inside = found["verdict"] == "inside"
        self.assertGreater(inside.sum(), 0.9 * exact.sum())
        same = inside & (found["element"] == buffers["Element"][exact])
        self.assertGreater(same.sum(), 0.9 * inside.sum())
        xi = np.stack([found[f"xi_{d}"] for d in range(3)], axis=-1)
        self.assertLess(np.abs(xi - buffers["Xi"][exact])[same].max(), delta)
        self.assertLess(np.abs(found["value"] - buffers["Value"][exact])[inside].max(), delta)


class Boundaries(CurvedTest):
    def test_a_cube(self):
        _, buffers, _ = self.render(self.cube, "--boundary", *EYE.options())
        enter, leave = slabs(EYE, [0, 0, 0], [1, 1, 1])
        hit = self.check_hits(buffers, EYE, np.where(enter < leave, enter, np.nan))
        position, normal = buffers["Position"][hit], buffers["Normal"][hit]
        self.assertLess(np.abs(buffers["Value"][hit] - position[:, 0]).max(), 1e-15)
        # The normal is that of the face that the position is on.
        axis = np.abs(normal).argmax(axis=-1)
        self.assertLess(np.abs(np.abs(normal) - np.eye(3)[axis]).max(), 1e-15)
        on_face = np.take_along_axis(position, axis[:, None], axis=-1)[:, 0]
        self.assertLess(np.minimum(np.abs(on_face), np.abs(on_face - 1)).max(), 1e-14)
        self.assertEqual(set(axis), {0, 1, 2})
        self.check_elements(self.cube, buffers, 1e-13)

    def test_seen_from_within(self):
        """Faces have two sides."""
        view = View([0.4, 0.5, 0.3], [1.0, 0.4, 0.5], [0.1, 0.2, 1.0], 40, 40, angle=100.0)
        _, buffers, _ = self.render(self.cube, "--boundary", *view.options())
        _, leave = slabs(view, [0, 0, 0], [1, 1, 1])
        self.check_hits(buffers, view, leave)

    def test_a_translucent_cube_shows_its_far_side(self):
        look = ["--layer", "1:opacity=0.25,color=0:0:1,lights=off"]
        _, buffers, image = self.render(self.cube, "--boundary", *look, *EYE.options())
        enter, leave = slabs(EYE, [0, 0, 0], [1, 1, 1])
        hit = self.check_hits(buffers, EYE, np.where(enter < leave, enter, np.nan))
        # Two sheets over white.
        expected = np.round(255 * 0.75**2)
        self.assertLess(np.abs(image[hit][:, :2] - expected).max(), 1.01)
        self.assertTrue((image[hit][:, 2] == 255).all())

    def test_neighbours_share_no_boundary(self):
        source = case("toroid_hex_g3_p6")
        view = View([2.5, -3.0, 3.5], [0.0, 0.0, 0.0], [0.1, 0.2, 1.0], 80, 64, angle=36.0)
        summary, buffers, _ = self.render(source, "--boundary", *view.options())
        self.assertEqual(summary["pixels"]["unknown"], 0)
        self.check_elements(source, buffers, 1e-11)
        # All faces of all elements: from outside the same pixels.
        elements = "element:" + ",".join(map(str, range(48)))
        _, all_faces, _ = self.render(source, f"--boundary={elements}", *view.options())
        np.testing.assert_array_equal(all_faces["Verdict"], buffers["Verdict"])
        both = buffers["Verdict"] == EXACT
        off = all_faces["Depth"][both] - buffers["Depth"][both]
        self.assertLess(np.abs(off).max(), 1e-12)

    def test_smooth_silhouettes(self):
        look = ["--layer", "1:color=0:0:0,lights=off"]
        _, _, jagged = self.render(self.cube, "--boundary", *look, *EYE.options())
        self.assertEqual(set(np.unique(jagged)), {0, 255})
        _, _, image = self.render(self.cube, "--boundary", *look, "--samples", "16", *EYE.options())
        self.assertGreater(len(np.unique(image)), 12)
        # The covered area is that of many more rays.
        fine = View(EYE.position, EYE.focal_point, EYE.view_up, 600, 480, angle=EYE.angle)
        enter, leave = slabs(fine, [0, 0, 0], [1, 1, 1])
        self.assertAlmostEqual(1 - image.mean() / 255, (enter < leave).mean(), delta=1e-3)


class IsoSurfaces(CurvedTest):
    def test_of_a_linear_field_a_plane(self):
        for text, axis, value in [("u=0.375", 0, 0.375), ("v.1=0.7", 1, 0.7), ("v.2=0.1", 2, 0.1)]:
            with self.subTest(text):
                _, buffers, _ = self.render(self.cube, "--isosurface", text, *EYE.options())
                origin, direction = EYE.rays()
                t = (value - origin[..., axis]) / direction[..., axis]
                within = along(EYE, t)
                t[~((within >= 0) & (within <= 1)).all(axis=-1)] = np.nan
                hit = self.check_hits(buffers, EYE, t)
                normal = np.abs(buffers["Normal"][hit])
                self.assertLess(np.abs(normal - np.eye(3)[axis]).max(), 1e-14)
                self.check_elements(self.cube, buffers, 1e-13)

    def test_of_a_quadratic_field_a_sphere(self):
        source = self.folder / "quadratic.vtu"
        source.write_text(quadratic_cube(lambda p: float(p @ p)), encoding="utf-8")
        view = View([2.6, -2.1, 1.9], [0, 0, 0], [0.1, 0.2, 1.0], 60, 48, angle=36.0)
        summary, buffers, _ = self.render(source, "--isosurface", "u=0.81", *view.options())
        self.assertEqual(summary["pixels"]["unknown"], 0)
        hit = self.check_hits(buffers, view, sphere_hits(view, [0, 0, 0], 0.9)[0], delta=1e-11)
        self.assertLess(np.abs(buffers["Value"][hit] - 0.81).max(), 1e-13)
        radial = buffers["Position"][hit] / 0.9
        off = np.minimum(*(np.abs(buffers["Normal"][hit] - s * radial).max(-1) for s in (1, -1)))
        self.assertLess(off.max(), 1e-12)
        self.check_elements(source, buffers, 1e-12)

    def test_of_a_magnitude_a_sphere(self):
        """v = x: where |v| = 0.8 about the cube's corner."""
        view = View([3.0, 2.6, 2.2], [0.4, 0.4, 0.4], [0.0, 0.0, 1.0], 60, 48, angle=26.0)
        _, buffers, _ = self.render(self.cube, "--isosurface", "v=0.8", *view.options(), field="v")
        t = sphere_hits(view, [0, 0, 0], 0.8)[0]
        first = along(view, t)
        t[~((first >= 0) & (first <= 1)).all(axis=-1)] = np.nan
        hit = self.check_hits(buffers, view, t, delta=1e-12)
        self.assertLess(np.abs(buffers["Value"][hit] - 0.8).max(), 1e-14)

    def test_rounding_is_not_spread_over_the_colours(self):
        """Its own field has one value there: one colour, whichever value."""
        for surface in [["--isosurface", "u=0.3"], ["--isosurface", "v.2=0"], ["--plane", "0.3,0,0,1,0,0"]]:
            field = surface[1][0] if surface[0] == "--isosurface" else "u"
            component = ["--component", "2"] if field == "v" else []
            options = [*surface, *component, "--lights", "off", *EYE.options()]
            summary, buffers, image = self.render(self.cube, *options, field=field)
            exact = buffers["Verdict"] == EXACT
            self.assertEqual(len({tuple(pixel) for pixel in image[exact].tolist()}), 1)
            self.assertEqual(summary["beyond_range"], {"below": 0, "above": 0})
        source = case("toroid_hex_g3_p6")
        view = View([2.5, -3.0, 3.5], [0.0, 0.0, 0.0], [0.1, 0.2, 1.0], 80, 64, angle=36.0)
        options = ["--isosurface", "u=0", "--lights", "off", *view.options()]
        _, buffers, image = self.render(source, *options)
        colors = {tuple(pixel) for pixel in image[buffers["Verdict"] == EXACT].tolist()}
        self.assertEqual(len(colors), 1)

    def test_another_field_than_is_shown(self):
        options = ["--isosurface", "v.1=0.7", *EYE.options()]
        _, buffers, _ = self.render(self.cube, *options, field="u")
        exact = buffers["Verdict"] == EXACT
        self.assertGreater(exact.sum(), 200)
        self.assertLess(np.abs(buffers["Position"][exact][:, 1] - 0.7).max(), 1e-14)
        off = buffers["Value"][exact] - buffers["Position"][exact][:, 0]
        self.assertLess(np.abs(off).max(), 1e-15)

    def test_of_a_solution(self):
        source = case("toroid_hex_g3_p6")
        view = View([2.5, -3.0, 3.5], [0.0, 0.0, 0.0], [0.1, 0.2, 1.0], 80, 64, angle=36.0)
        summary, buffers, _ = self.render(source, "--isosurface", "u=0.3", *view.options())
        self.assertEqual(summary["pixels"]["unknown"], 0)
        exact = buffers["Verdict"] == EXACT
        self.assertGreater(exact.sum(), 300)
        self.assertLess(np.abs(buffers["Value"][exact] - 0.3).max(), 1e-11)
        self.check_elements(source, buffers, 1e-10)


class Patches(CurvedTest):
    """Control points at thirds of the square and a height make x and y the parameters."""

    def patch(self, height):
        """The file of z = a bicubic polynomial with these control heights over [0,1]^2."""
        file = self.folder / "patch.txt"
        lines = [f"{i / 3!r} {j / 3!r} {height[i][j]!r}" for i in range(4) for j in range(4)]
        file.write_text("\n".join(lines) + "\n", encoding="utf-8")
        return file

    def test_flat(self):
        file = self.patch(np.full((4, 4), 0.4).tolist())
        _, buffers, _ = self.render(self.cube, "--patch", file, *EYE.options())
        origin, direction = EYE.rays()
        t = (0.4 - origin[..., 2]) / direction[..., 2]
        at = along(EYE, t)[..., :2]
        t[~((at >= 0) & (at <= 1)).all(axis=-1)] = np.nan
        self.check_hits(buffers, EYE, t)

    def test_curved(self):
        """z = 1/2 + (x - x^2) (y - y^2): no bicubic patch is flatter at its rim."""
        b = [0, 1 / 3, 1 / 3, 0]  # of x - x^2
        file = self.patch([[0.5 + p * q for q in b] for p in b])
        view = View([0.4, 0.6, 3.0], [0.5, 0.5, 0.5], [0, 1, 0], 60, 60, angle=30.0)
        _, buffers, _ = self.render(self.cube, "--patch", file, *view.options())
        exact = buffers["Verdict"] == EXACT
        self.assertGreater(exact.sum(), 1000)
        self.assertEqual((buffers["Verdict"] == 2).sum(), 0)
        x, y, z = np.moveaxis(buffers["Position"][exact], -1, 0)
        self.assertLess(np.abs(z - 0.5 - (x - x * x) * (y - y * y)).max(), 1e-14)
        normal = np.stack([-(1 - 2 * x) * (y - y * y), -(1 - 2 * y) * (x - x * x), 1 + 0 * x], -1)
        normal /= np.linalg.norm(normal, axis=-1, keepdims=True)
        sign = np.sign(buffers["Normal"][exact][:, 2:])
        self.assertLess(np.abs(sign * buffers["Normal"][exact] - normal).max(), 1e-13)
        # Within the rim, where the square is seen.
        origin, direction = view.rays()
        on_rim = along(view, (0.5 - origin[..., 2]) / direction[..., 2])[..., :2]
        self.assertTrue(exact[((on_rim > 0.05) & (on_rim < 0.95)).all(axis=-1)].all())
        self.assertFalse(exact[((on_rim < -0.05) | (on_rim > 1.05)).any(axis=-1)].any())
        self.check_elements(self.cube, buffers, 1e-13)

    def test_seams_are_tight(self):
        """Two patches that share the line x = y: every pixel between them is met."""
        halves = [[(0, 0, 0.4), (1, 1, 0.6)], [(0, 1, 0.5), (0, 1, 0.5)], [(1, 0, 0.5), (1, 0, 0.5)]]
        lines = []
        for corner in halves[1:]:
            for i in range(4):
                a, b = (np.array(end, float) for end in halves[0])
                middle = a + (b - a) * i / 3
                for j in range(4):
                    point = middle + (np.array(corner[0]) - middle) * j / 3
                    lines.append(numbers(point).replace(",", " "))
        file = self.folder / "two.txt"
        file.write_text("\n".join(lines) + "\n", encoding="utf-8")
        view = View([0.5, 0.5, 3.0], [0.5, 0.5, 0.5], [1, 1, 0], 81, 81, angle=20.0)
        _, buffers, _ = self.render(self.cube, "--patch", file, *view.options())
        seam = np.abs(buffers["Position"][..., 0] - buffers["Position"][..., 1]) < 1e-9
        self.assertTrue((buffers["Verdict"][10:70, 40] == EXACT).all())
        self.assertTrue((buffers["Verdict"] != 2).all())
        self.assertGreater((seam & (buffers["Verdict"] == EXACT)).sum(), 50)


class Together(CurvedTest):
    def test_the_nearest_within_the_mesh_shows(self):
        """An iso-surface, a patch and a sphere, each before the others somewhere."""
        file = self.folder / "patch.txt"
        rows = [f"{i / 3!r} {2 * j / 3 - 0.5!r} 0.4" for i in range(4) for j in range(4)]
        file.write_text("\n".join(rows) + "\n", encoding="utf-8")
        options = ["--sphere", "0.5,0.5,0.5,0.6", "--patch", file, "--isosurface", "u=0.6"]
        _, buffers, _ = self.render(self.cube, *options, *EYE.options())
        origin, direction = EYE.rays()
        near, far = sphere_hits(EYE, [0.5, 0.5, 0.5], 0.6)
        patch = (0.4 - origin[..., 2]) / direction[..., 2]
        iso = (0.6 - origin[..., 0]) / direction[..., 0]
        t = np.stack([near, far, patch, iso])
        at = origin + t[..., None] * direction
        t[~((at >= 0) & (at <= 1)).all(axis=-1)] = np.inf
        t[np.isnan(t)] = np.inf
        which = np.array([0, 0, 1, 2])[t.argmin(axis=0)]
        t = t.min(axis=0)
        hit = self.check_hits(buffers, EYE, np.where(np.isinf(t), np.nan, t))
        np.testing.assert_array_equal(buffers["Layer"][hit], which[hit])
        self.assertEqual(set(which[hit]), {0, 1, 2})

    def test_layers_have_looks_of_their_own(self):
        options = ["--isosurface", "u=0.5", "--boundary"]
        options += ["--layer", "1:field=v,component=2", "--layer", "2:opacity=0.5,color=1:0:0"]
        summary, buffers, image = self.render(self.cube, *options, *EYE.options())
        self.assertEqual([layer["field"] for layer in summary["layers"]], ["v", "u"])
        exact = buffers["Verdict"] == EXACT
        # The boundary is nearest everywhere; what is seen through it is no pure red.
        self.assertTrue((buffers["Layer"][exact] == 1).all())
        colors = {tuple(pixel) for pixel in image[exact].tolist()}
        self.assertGreater(len(colors), 50)

    def test_buffers_name_what_was_hit(self):
        out = self.folder / "some.vti"
        options = ["--arrays", "Value,Verdict,Element", "--buffers", out]
        image = self.folder / "i.png"
        base = ["render", self.cube, "--field", "u", "--isosurface", "u=0.5", "--output", image]
        self.succeeds(*base, *options, *EYE.options())
        buffers = read_buffers(out)
        self.assertEqual(set(buffers), {"Value", "Verdict", "Element"})
        exact = buffers["Verdict"] == EXACT
        self.assertTrue((buffers["Element"][exact] == 0).all())
        self.assertTrue((buffers["Element"][~exact] == -1).all())
        self.assertTrue((read_image(image)[~exact] == 255).all())


if __name__ == "__main__":
    unittest.main()
