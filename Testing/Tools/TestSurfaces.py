# SPDX-License-Identifier: BSD-3-Clause
"""pixelexact render: surfaces in closed form, layers, lights, smooth edges."""

import unittest

import numpy as np

from rendering import EXACT, SurfaceTest, numbers
from tool import View, case, run, unit, unit_cube_grid


def quadratic(form, origin, direction):
    """Of x' Q x + 2 b x + k with form (Q, b, k): the polynomial along each ray."""
    q, b, k = (np.asarray(part, dtype=float) for part in form)
    second = np.einsum("...i,ij,...j", direction, q, direction)
    first = 2 * (np.einsum("...i,ij,...j", direction, q, origin) + direction @ b)
    none = np.einsum("...i,ij,...j", origin, q, origin) + 2 * (origin @ b) + k
    return np.stack([none, first, second], axis=-1)


def shifted(q, centre, k):
    """(x - c)' Q (x - c) + k"""
    q, c = np.asarray(q, dtype=float), np.asarray(centre, dtype=float)
    return q, -q @ c, c @ q @ c + k


def sphere(c, r):
    return lambda o, d: quadratic(shifted(np.eye(3), c, -r * r), o, d)


def cylinder(p, a, r):
    a = unit(a)
    return lambda o, d: quadratic(shifted(np.eye(3) - np.outer(a, a), p, -r * r), o, d)


def cone(p, a, degrees):
    a = unit(a)
    steep = 1 / np.cos(np.radians(degrees)) ** 2
    return lambda o, d: quadratic(shifted(np.eye(3) - steep * np.outer(a, a), p, 0), o, d)


def general(a):
    q = [[a[0], a[3] / 2, a[5] / 2], [a[3] / 2, a[1], a[4] / 2], [a[5] / 2, a[4] / 2, a[2]]]
    return lambda o, d: quadratic((q, [a[6] / 2, a[7] / 2, a[8] / 2], a[9]), o, d)


def product(p, q):
    """Of polynomials, lowest coefficients first."""
    result = np.zeros((*p.shape[:-1], p.shape[-1] + q.shape[-1] - 1))
    for i in range(p.shape[-1]):
        result[..., i : i + q.shape[-1]] += p[..., i : i + 1] * q
    return result


def torus(c, a, big, small):
    a = unit(a)

    def along(o, d):
        whole = quadratic(shifted(np.eye(3), c, big * big - small * small), o, d)
        across = quadratic(shifted(np.eye(3) - np.outer(a, a), c, 0), o, d)
        square = product(whole, whole)
        square[..., :3] -= 4 * big * big * across
        return square

    return along


# Options that say the surface, and the same as a polynomial along rays.
SURFACES = {
    "--sphere": ([0.4, -0.2, 0.1, 0.7], sphere([0.4, -0.2, 0.1], 0.7)),
    "--cylinder": (
        [0.2, 0.1, 0.0, 1.0, -2.0, 0.5, 0.6],
        cylinder([0.2, 0.1, 0.0], [1.0, -2.0, 0.5], 0.6),
    ),
    "--cone": ([0.1, 0.0, 0.4, 0.2, 0.3, -1.0, 55.0], cone([0.1, 0, 0.4], [0.2, 0.3, -1.0], 55.0)),
    "--quadric": (
        [1.0, 0.8, -0.5, 0.2, -0.1, 0.3, 0.1, -0.2, 0.05, -0.6],
        general([1.0, 0.8, -0.5, 0.2, -0.1, 0.3, 0.1, -0.2, 0.05, -0.6]),
    ),
    "--torus": (
        [0.05, -0.05, 0.0, 0.1, 0.2, 1.0, 0.9, 0.25],
        torus([0.05, -0.05, 0.0], [0.1, 0.2, 1.0], 0.9, 0.25),
    ),
}


class ClosedForms(SurfaceTest):
    def test_each_pixel_shows_the_first_root_within_the_mesh(self):
        source = case("toroid_hex_g3_p6")
        view = View([2.5, -3.0, 3.5], [0.0, 0.0, 0.0], [0.1, 0.2, 1.0], 48, 36, angle=28.0)
        origin, direction = view.rays()
        for option, (given, polynomial) in SURFACES.items():
            with self.subTest(option):
                _, buffers, _ = self.render(source, option, numbers(given), *view.options())
                coefficients = polynomial(origin, direction)
                pixels, roots = [], []
                for pixel in np.ndindex(36, 48):
                    for root in np.sort_complex(np.roots(coefficients[pixel][::-1])):
                        if abs(root.imag) < 1e-9 and root.real > 0:
                            pixels.append(pixel)
                            roots.append(root.real)
                origins = np.broadcast_to(origin, direction.shape)
                at = np.array([origins[p] + t * direction[p] for p, t in zip(pixels, roots)])
                inside = self.probe(source, at)["verdict"] == "inside"
                first = {}
                for pixel, root, held in zip(pixels, roots, inside):
                    if held:
                        first.setdefault(pixel, root)
                exact = buffers["Verdict"] == EXACT
                self.assertGreater(exact.sum(), 80)
                self.assertEqual(exact.sum(), len(first))
                for pixel, root in first.items():
                    self.assertTrue(exact[pixel], pixel)
                    self.assertAlmostEqual(buffers["Depth"][pixel], root, delta=1e-9)
                    along = origins[pixel] + root * direction[pixel]
                    gap = np.abs(buffers["Position"][pixel] - along).max()
                    self.assertLess(gap, 1e-9)
                found = self.probe(source, buffers["Position"][exact])
                self.assertTrue((found["value"] == buffers["Value"][exact]).all())
                length = np.linalg.norm(buffers["Normal"][exact], axis=-1)
                self.assertLess(np.abs(length - 1).max(), 1e-14)

    def test_box(self):
        source = case("toroid_hex_g3_p6")
        lower, upper = np.array([-0.9, -0.8, -0.2]), np.array([1.2, 0.7, 0.15])
        view = View([2.5, -3.0, 3.5], [0.0, 0.0, 0.0], [0.1, 0.2, 1.0], 48, 36, angle=28.0)
        _, buffers, _ = self.render(
            source, "--box", numbers([*lower, *upper]), *view.options()
        )
        exact = buffers["Verdict"] == EXACT
        self.assertGreater(exact.sum(), 100)
        position = buffers["Position"][exact]
        self.assertTrue(((position >= lower) & (position <= upper)).all())
        on_face = (position == lower) | (position == upper)
        self.assertTrue((on_face.sum(axis=-1) >= 1).all())

    def test_disc(self):
        source = case("toroid_hex_g3_p6")
        centre, normal, radius = np.array([0.1, -0.2, 0.05]), np.array([0.2, 0.1, 1.0]), 0.9
        view = View([2.5, -3.0, 3.5], [0.0, 0.0, 0.0], [0.1, 0.2, 1.0], 48, 36, angle=28.0)
        plane = numbers([*centre, *normal])
        _, whole, full = self.render(source, "--plane", plane, *view.options())
        values = whole["Value"][whole["Verdict"] == EXACT]
        given = numbers([*centre, *normal, radius])
        # Its own range is another than the plane's.
        ranged = ["--range", numbers([values.min(), values.max()])]
        _, disc, image = self.render(source, "--disc", given, *ranged, *view.options())
        distance = np.linalg.norm(whole["Position"] - centre, axis=-1)
        within = (whole["Verdict"] == EXACT) & (distance <= radius)
        self.assertGreater(within.sum(), 80)
        self.assertLess(within.sum(), len(values) - 80)
        np.testing.assert_array_equal(disc["Verdict"] == EXACT, within)
        for name in ("Value", "Position", "Normal", "Element", "Depth"):
            np.testing.assert_array_equal(disc[name][within], whole[name][within])
        # As bright as the plane: it is flat.
        np.testing.assert_array_equal(image[within], full[within])
        self.assertTrue((image[~within] == 255).all())

    def test_what_is_no_surface_is_refused(self):
        image = self.folder / "i.png"
        for option, given, name in [
            ("--disc", "0,0,0,0,0,0,1", "normal"),
            ("--disc", "0,0,0,0,0,1,-1", "radius"),
            ("--disc", "0,0,0,0,0,1", "cx,cy,cz,nx,ny,nz,r"),
            ("--sphere", "0,0,0,0", "radius"),
            ("--sphere", "0,0,0", "cx,cy,cz,r"),
            ("--cylinder", "0,0,0,0,0,0,1", "axis"),
            ("--cone", "0,0,0,0,0,1,90", "angle"),
            ("--quadric", "0,0,0,0,0,0,0,0,0,1", "quadric"),
            ("--torus", "0,0,0,0,0,1,1,-0.5", "radius"),
            ("--box", "1,0,0,0,1,1", "box"),
        ]:
            self.fails(
                2, "render", case("toroid_hex_g3_p6"), "--field", "u", option, given, "--output",
                image, names=[option, name],
            )


class Layers(SurfaceTest):
    def setUp(self):
        super().setUp()
        self.source = self.folder / "cube.vtu"
        corners = [[x, y, z] for z in (0, 1) for x, y in ((0, 0), (1, 0), (1, 1), (0, 1))]
        fields = [
            ("u", [float(x) for x, _, _ in corners]),
            ("v", [[float(y), 2.0 + z, float(x)] for x, y, z in corners]),
        ]
        self.source.write_text(unit_cube_grid(fields), encoding="utf-8")
        self.view = View([0.5, 0.5, 5.0], [0.5, 0.5, 0.0], [0, 1, 0], 40, 40, scale=0.6)

    def test_fields_components_and_colours_of_their_own(self):
        options = ["--plane", "0,0,0.25,0,0,1", "--plane", "0.5,0,0.75,-1,0,2"]
        options += ["--layer", "1:field=v,component=1,color=0:0:1"]
        options += ["--layer", "2:opacity=0.25,color=1:0:0"]
        summary, buffers, _ = self.render(self.source, *options, *self.view.options())
        exact = buffers["Verdict"] == EXACT
        x, _, z = np.moveaxis(buffers["Position"], -1, 0)
        # The slanted plane is the nearer one wherever it is within the cube.
        second = exact & (np.abs(z - (0.75 + (x - 0.5) / 2)) < 1e-12)
        self.assertTrue((buffers["Layer"][second] == 1).all())
        self.assertTrue((buffers["Layer"][exact & ~second] == 0).all())
        self.assertTrue((buffers["Layer"][~exact] == 255).all())
        self.assertTrue(np.allclose(buffers["Value"][second], x[second], atol=1e-14))
        self.assertTrue((buffers["Color"][second] == [64, 0, 191, 255]).all())
        self.assertEqual([layer["field"] for layer in summary["layers"]], ["v", "u"])
        self.assertEqual([layer["component"] for layer in summary["layers"]], ["1", "value"])
        self.assertEqual(summary["layers"][1]["pixels"], second.sum())
        options[-1] = "2:opacity=1"
        _, buffers, _ = self.render(self.source, *options[:4], *options[4:6], *self.view.options())
        first = buffers["Layer"] == 0
        self.assertTrue(np.allclose(buffers["Value"][first], 2 + buffers["Position"][first][:, 2]))

    def test_lights(self):
        options = ["--sphere", "0.5,0.5,0,0.45", "--layer", "1:color=1:0.5:0"]
        _, buffers, _ = self.render(self.source, *options, *self.view.options())
        exact = buffers["Verdict"] == EXACT
        facing = np.abs(buffers["Normal"][exact][:, 2])
        # Ambient light gives 0.4 of the colour.
        lit = np.outer(0.4 + 0.6 * facing, [255, 127.5, 0])
        self.assertLess(np.abs(buffers["Color"][exact][:, :3] - lit).max(), 1.01)
        _, flat, _ = self.render(self.source, *options, "--lights", "off", *self.view.options())
        self.assertTrue((flat["Color"][exact][:, :3] == [255, 128, 0]).all())
        plane = ["--plane", "0.5,0.5,0.5,1,0,1", "--layer", "1:color=1:0.5:0"]
        _, plain, _ = self.render(self.source, *plane, *self.view.options())
        shown = plain["Verdict"] == EXACT
        self.assertTrue((plain["Color"][shown][:, :3] == [255, 128, 0]).all())
        _, shaded, _ = self.render(self.source, *plane, "--lights", "on", *self.view.options())
        half = np.array([255, 127.5, 0]) * (0.4 + 0.6 / np.sqrt(2))
        self.assertLess(np.abs(shaded["Color"][shown][:, :3] - half).max(), 1.01)

    def test_smooth_edges(self):
        options = ["--sphere", "0.5,0.5,0,0.45", "--layer", "1:color=0:0:0,lights=off"]
        _, rough, jagged = self.render(self.source, *options, *self.view.options())
        summary, smooth, image = self.render(
            self.source, *options, "--samples", "64", *self.view.options()
        )
        for name in ("Value", "Verdict", "Depth", "Element"):
            np.testing.assert_array_equal(rough[name], smooth[name])
        self.assertEqual(set(np.unique(jagged)), {0, 255})
        # White before black: the covered area is that of the disc.
        covered = (1 - image[..., 0] / 255).sum() * (1.2 / 40) ** 2
        self.assertAlmostEqual(covered, np.pi * 0.45**2, delta=2e-3)
        self.assertGreater(summary["refined_pixels"], 80)
        self.assertLess(summary["refined_pixels"], 200)

    def test_outlines_are_where_elements_meet(self):
        source = case("toroid_hex_g3_p6")
        options = ["--plane", "0.1,0,0.05,0.2,0.1,1", "--torus", "0,0,0,0,0,1,1,0.3"]
        look = ["--layer", "1:color=1:1:0", "--layer", "2:color=1:1:0,lights=off"]

        def view(width, height, scale):
            up, eye = [0.1, 0.2, 1.0], [2.5, -3.0, 3.5]
            return View(eye, [0.0, 0.0, 0.0], up, width, height, scale=scale)

        of_pixels = view(80, 64, 1.2).options()
        # The pixels' corners are the centres of an image that is larger by one pixel.
        of_corners = view(81, 65, 1.2 * 65 / 64).options()
        _, centres, plain = self.render(source, *options, *look, *of_pixels)
        _, corners, _ = self.render(source, *options, *look, *of_corners)
        own = np.stack([centres[name].astype(int) for name in ("Verdict", "Element", "Layer")])
        at = np.stack([corners[name].astype(int) for name in ("Verdict", "Element", "Layer")])
        around = [at[:, dy : dy + 64, dx : dx + 80] for dx in (0, 1) for dy in (0, 1)]
        shown = (own[0] == EXACT) & np.all([one[0] == EXACT for one in around], axis=0)
        expected = shown & np.any([(one != own).any(axis=0) for one in around], axis=0)
        self.assertGreater(expected.sum(), 300)
        for color, more in [([0, 0, 0], []), ([0, 0, 255], ["--outline-color", "0,0,1"])]:
            _, buffers, image = self.render(
                source, *options, *look, "--outlines", *more, *of_pixels
            )
            np.testing.assert_array_equal((image == color).all(axis=-1), expected)
            np.testing.assert_array_equal(image[~expected], plain[~expected])
            np.testing.assert_array_equal(buffers["Color"][..., :3][expected], image[expected])
            np.testing.assert_array_equal(buffers["Value"], centres["Value"])
        smooth = ["--samples", "4", "--outlines"]
        _, _, image = self.render(source, *options, *look, *smooth, *of_pixels)
        self.assertTrue((image[expected] == 0).all())
        plane = ["render", source, "--field", "u", "--plane", "0,0,0,0,0,1"]
        image = ["--output", self.folder / "i.png"]
        for given, name in [(["--outlines", "--outline-color", "2,0,0"], "between 0 and 1"),
                            (["--outline-color", "1,0,0"], "--outlines")]:
            self.fails(2, *plane, *given, *image, names=["--outline-color", name])

    def test_pictures_of_soundness_are_not_mixed(self):
        image = self.folder / "i.png"
        plane = ["--field", "u", "--plane", "0,0,0.5,0,0,1", "--samples", "4", "--output", image]
        for option in (["--owners"], ["--show", "validity"], ["--show-undecided"]):
            self.fails(2, "render", self.source, *plane, *option, names=["--samples", "legend"])
        self.succeeds("render", self.source, *plane, "--enclosures", "--outlines")

    def test_what_is_not_understood(self):
        image = self.folder / "i.png"
        for text, name in [
            ("opacity=0.5", "N:KEY=VALUE"),
            ("2:opacity=0.5", "1 surface"),
            ("0:opacity=0.5", "1 surface"),
            ("1:opacity=1.5", "opacity"),
            ("1:shine=1", "'shine=1' is none of"),
            ("1:colormap=nope", "viridis"),
            ("1:range=2:1", "below"),
            ("1:color=1:2", "red:green:blue"),
            ("1:component=w", "magnitude"),
            ("1:lights=maybe", "on or off"),
        ]:
            done = run(
                "render", self.source, "--field", "u", "--plane", "0,0,0.5,0,0,1", "--layer", text,
                "--output", image,
            )
            self.assertEqual(done.returncode, 2, text)
            self.assertIn(name, done.stderr)
            self.assertIn("--layer", done.stderr)
        self.fails(
            1, "render", self.source, "--field", "u", "--plane", "0,0,0.5,0,0,1", "--layer",
            "1:field=w", "--output", image, names=["w", "u"],
        )
        self.fails(
            1, "render", self.source, "--field", "u", "--plane", "0,0,0.5,0,0,1", "--layer",
            "1:field=v,component=3", "--output", image, names=["3 components"],
        )


if __name__ == "__main__":
    unittest.main()
