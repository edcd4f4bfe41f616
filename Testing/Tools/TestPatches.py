# SPDX-License-Identifier: BSD-3-Clause
"""pixelexact render: Bezier patches, and surfaces of several kinds, against closed forms."""

import unittest

import numpy as np

from rendering import EXACT, EYE, CurvedTest, along, numbers, sphere_hits
from tool import View, read_buffers, read_image


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

    def test_of_two_in_one_place_the_first_shows(self):
        for pair in [["--boundary", "--boundary=all"], ["--isosurface", "u=0.4", "--isosurface", "u.0=0.4"]]:
            _, once, _ = self.render(self.cube, *pair[: len(pair) // 2], *EYE.options())
            _, twice, _ = self.render(self.cube, *pair, *EYE.options())
            exact = once["Verdict"] == EXACT
            self.assertGreater(exact.sum(), 200)
            self.assertTrue((twice["Layer"][exact] == 0).all())
            for name in ("Verdict", "Depth", "Value", "Normal", "Element"):
                np.testing.assert_array_equal(twice[name], once[name])


if __name__ == "__main__":
    unittest.main()
