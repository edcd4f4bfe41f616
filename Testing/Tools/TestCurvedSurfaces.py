# SPDX-License-Identifier: BSD-3-Clause
"""pixelexact render: boundaries and iso-surfaces, against closed forms."""

import unittest

import numpy as np

from rendering import EXACT, EYE, CurvedTest, along, slabs, sphere_hits
from tool import CUBE, View, case, plain_grid, run

VTK_HEXAHEDRON = 12
VTK_TRIQUADRATIC_HEXAHEDRON = 29


def quadratic_cube(function):
    """[-1,1]^3 in 8 hexahedra of order 2, whose field u interpolates `function` of points, and of
    the element's corner that is not the origin."""
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
    outer = np.repeat(1 - 2 * np.array(CUBE), 27, axis=0)
    values = [function(p, corner) for p, corner in zip(points, outer)]
    return plain_grid(points.tolist(), cells, [("u", values)])


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

    def test_what_another_element_covers_is_not_there(self):
        """From within a block, at x < 0, into one of half its height and width at x > 0."""
        unit = np.array(CUBE)
        points = np.concatenate([unit * [1, 2, 2] - [1, 1, 1], unit - [0, 0.5, 0.5]])
        cells = [(VTK_HEXAHEDRON, list(range(8 * k, 8 * k + 8))) for k in range(2)]
        source = self.folder / "blocks.vtu"
        source.write_text(plain_grid(points.tolist(), cells, [("u", [0.0] * 16)]), encoding="utf-8")
        view = View([-0.9, 0.01, 0.02], [0.0, 0.01, 0.02], [0.0, 0.0, 1.0], 60, 48, angle=70.0)
        summary, buffers, _ = self.render(source, "--boundary", *view.options())
        self.assertEqual(summary["pixels"]["exact"], 60 * 48)
        origin, direction = view.rays()
        across = origin + direction * (-origin[..., :1] / direction[..., :1])
        covered = np.abs(across[..., 1:]).max(axis=-1) < 0.5
        self.assertGreater(covered.sum(), 200)
        x = buffers["Position"][..., 0]
        self.assertGreater(x[covered].min(), 1e-3)
        self.assertLess(x[~covered].max(), 1e-14)

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
        source.write_text(quadratic_cube(lambda p, _: float(p @ p)), encoding="utf-8")
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


class Walls(CurvedTest):
    view = View([2.6, -2.1, 1.9], [0, 0, 0], [0.1, 0.2, 1.0], 60, 48, angle=36.0)

    def draw(self, function, *options):
        source = self.folder / "jumps.vtu"
        source.write_text(quadratic_cube(function), encoding="utf-8")
        return self.render(source, "--isosurface", "u=0.5", *options, *self.view.options())

    def test_of_constants_a_square(self):
        """u is 0 at x < 0 and 1 at x > 0: it is 0.5 nowhere, and jumps across it at x = 0."""
        summary, buffers, image = self.draw(lambda _, corner: float(corner[0] > 0), "--jump-walls", "--lights", "off")
        enter, leave = slabs(self.view, [0, -1, -1], [0, 1, 1])
        hit = self.check_hits(buffers, self.view, np.where(enter <= leave, enter, np.nan), delta=1e-12)
        self.assertEqual(set(buffers["Layer"][hit]), {1})
        self.assertEqual(summary["jump_walls"], {"faces": 4, "pixels": int(hit.sum())})
        self.assertEqual({tuple(pixel) for pixel in image[hit].tolist()}, {(214, 94, 0)})
        normal = buffers["Normal"][hit]
        self.assertLess(np.abs(np.abs(normal) - [1, 0, 0]).max(), 1e-12)

    def test_beside_the_surface_that_they_close(self):
        """u = y, and y + 1 at x > 0: the surface is at y = 0.5 and, there, at y = -0.5."""
        summary, buffers, _ = self.draw(lambda p, corner: p[1] + float(corner[0] > 0), "--jump-walls")
        wall = buffers["Layer"] == 1
        position = buffers["Position"][wall]
        self.assertGreater(wall.sum(), 50)
        self.assertLess(np.abs(position[:, 0]).max(), 1e-12)
        self.assertLess(np.abs(position[:, 1]).max(), 0.5 + 1e-12)
        self.assertEqual(summary["jump_walls"]["pixels"], int(wall.sum()))
        self.assertEqual(summary["pixels"]["unknown"], 0)

    def test_widen_a_range_only_with_colors_of_their_own(self):
        """The surface shows 0.5 alone; on the wall u is from -1 to 0.5, or from 0.5 to 2."""

        def widths(*options):
            summary, _, _ = self.draw(lambda p, corner: p[1] + float(corner[0] > 0), "--jump-walls", *options)
            ranges = [layer["color_range"] for layer in summary["layers"]]
            return [None if ends is None else ends[1] - ends[0] for ends in ranges]

        surface, wall = widths()
        self.assertLess(surface, 1e-5)
        self.assertIsNone(wall)
        surface, wall = widths("--layer", "2:colormap=plasma")
        self.assertGreater(surface, 0.5)
        self.assertEqual(wall, surface)

    def test_of_a_field_that_is_continuous_none(self):
        summary, _, _ = self.draw(lambda p, _: p[1], "--jump-walls")
        self.assertEqual(summary["jump_walls"], {"faces": 0, "pixels": 0})

    def test_none_unless_asked_for(self):
        summary, _, _ = self.draw(lambda p, corner: p[1] + float(corner[0] > 0))
        self.assertNotIn("jump_walls", summary)

    def test_only_of_iso_surfaces(self):
        done = run("render", case("toroid_hex_g3_p6"), "--boundary", "--jump-walls")
        self.assertEqual(done.returncode, 2)
        self.assertIn("--isosurface", done.stderr)


if __name__ == "__main__":
    unittest.main()
