# SPDX-License-Identifier: BSD-3-Clause
"""render --volume: every pixel is within its own bound of integrals in closed form."""

import json
import math
import unittest

import numpy as np

from tool import CUBE, DATA, View, plain_grid, read_buffers, read_image
from rendering import SurfaceTest, slabs

EYE = View([2.6, -2.1, 1.9], [0.5, 0.5, 0.5], [0.1, 0.2, 1.0], 48, 40, angle=32.0)
PARALLEL = View([3.1, 1.2, 2.3], [0.5, 0.5, 0.5], [0.0, 0.3, 1.0], 40, 36, scale=0.95)
UNIT = 0.4
# Values with colours; values with opacities, which jump at 0.3.
COLORS = [(0.0, 0.0, 0.0, 1.0), (0.4, 1.0, 0.2, 0.0), (1.0, 1.0, 1.0, 0.5)]
OPACITIES = [(0.0, 0.1), (0.3, 0.6), (0.3, 0.05), (1.0, 0.8)]
HALF_LEVEL = 1.0 / 512.0


def places():
    return sorted({row[0] for row in COLORS} | {row[0] for row in OPACITIES})


def between(rows, u, middle):
    """The values of a list of points at u, in the part in which `middle` lies."""
    xs = [row[0] for row in rows]
    if middle <= xs[0]:
        return np.asarray(rows[0][1:])
    if middle >= xs[-1]:
        return np.asarray(rows[-1][1:])
    k = max(i for i in range(len(xs) - 1) if xs[i] <= middle and xs[i] < xs[i + 1])
    share = (u - xs[k]) / (xs[k + 1] - xs[k])
    return (1 - share) * np.asarray(rows[k][1:]) + share * np.asarray(rows[k + 1][1:])


def depth_over(alpha0, alpha1, length, unit):
    """The optical depth of a path along which the opacity is linear."""
    q0, q1 = 1 - alpha0, 1 - alpha1
    if abs(q1 - q0) < 1e-7:
        return -math.log(0.5 * (q0 + q1)) * length / unit
    return -((q1 * math.log(q1) - q1) - (q0 * math.log(q0) - q0)) / (q1 - q0) * length / unit


NODES, WEIGHTS = np.polynomial.legendre.leggauss(16)


class Light:
    """Emission and absorption, front to back."""

    def __init__(self, unit=UNIT):
        self.unit = unit
        self.color = np.zeros(3)
        self.through = 1.0

    def add(self, length, u0, u1):
        """A path along which u is linear."""
        cuts = [0.0, 1.0]
        if u1 != u0:
            cuts += [s for s in ((x - u0) / (u1 - u0) for x in places()) if 0 < s < 1]
        cuts.sort()
        for a, b in zip(cuts[:-1], cuts[1:]):
            self.add_part((b - a) * length, u0 + a * (u1 - u0), u0 + b * (u1 - u0))

    def add_part(self, length, u0, u1):
        middle = 0.5 * (u0 + u1)
        alpha0, alpha1 = (float(between(OPACITIES, u, middle)[0]) for u in (u0, u1))
        total = depth_over(alpha0, alpha1, length, self.unit)
        for node, weight in zip(NODES, WEIGHTS):
            s = 0.5 * (1 + node)
            alpha = alpha0 + s * (alpha1 - alpha0)
            before = depth_over(alpha0, alpha, s * length, self.unit)
            rate = -math.log(1 - alpha) / self.unit
            color = between(COLORS, u0 + s * (u1 - u0), middle)
            self.color += self.through * math.exp(-before) * rate * color * 0.5 * weight * length
        self.through *= math.exp(-total)

    def add_layer(self, color, alpha):
        self.color += self.through * alpha * np.asarray(color)
        self.through *= 1 - alpha

    def result(self):
        return [*self.color, 1 - self.through]


class TestVolume(SurfaceTest):
    def setUp(self):
        super().setUp()
        self.transfer = self.folder / "transfer.json"
        self.write_transfer()

    def write_transfer(self, **changes):
        points = [value for u, alpha in OPACITIES for value in (u, alpha, 0.5, 0.0)]
        one = {
            "Name": "test",
            "ColorSpace": "RGB",
            "RGBPoints": [value for row in COLORS for value in row],
            "Points": points,
            **changes,
        }
        self.transfer.write_text(json.dumps([one]), encoding="utf-8")

    def write(self, name, *grid):
        path = self.folder / name
        path.write_text(plain_grid(*grid), encoding="utf-8")
        return path

    def draw(self, source, view, *options, field="u"):
        image, buffers = self.folder / "image.png", self.folder / "buffers.vti"
        summary = self.summary(
            "render", source, "--volume", field, "--transfer", self.transfer,
            "--opacity-unit", UNIT, *view.options(), "--background", "none",
            "--output", image, "--buffers", buffers, *options,
        )
        found = read_buffers(buffers)
        rgba = np.concatenate([found["VolumeColor"], found["VolumeOpacity"][..., None]], axis=-1)
        return summary, rgba, found["VolumeBound"] / 255.0, read_image(image)

    def check(self, rgba, bound, expected):
        """Every pixel is within its bound; most are proven."""
        off = np.abs(rgba - expected).max(axis=-1)
        self.assertFalse((off > bound + 1e-9).any(), f"{off.max()} {bound.max()}")
        return off

    def check_cube(self, view, path, field="u", value=lambda x: x[..., 0], options=(), share=1.0):
        near, far = slabs(view, [0, 0, 0], [1, 1, 1])
        origin, direction = view.rays()
        summary, rgba, bound, image = self.draw(path, view, *options, field=field)
        expected = np.zeros(rgba.shape)
        for at in np.argwhere(far > near):
            at = tuple(at)
            u0, u1 = (value(origin[at] + t * direction[at]) for t in (near[at], far[at]))
            light = Light()
            light.add(far[at] - near[at], u0, u1)
            expected[at] = light.result()
        self.check(rgba, bound, expected)
        proven = (bound <= HALF_LEVEL).mean()
        print(f"{path.name}: {100 * proven:.1f} % of the pixels are proven")
        self.assertGreaterEqual(proven, share)
        self.assertEqual(summary["volume"]["unproven"], int((bound > HALF_LEVEL).sum()))
        self.assertEqual(summary["volume"]["proven"], int((bound <= HALF_LEVEL).sum()))
        self.assertLessEqual(summary["volume"]["largest_bound"], 255 * HALF_LEVEL)
        self.assertGreater((far > near).sum(), 200)
        # Bytes with straight colours.
        alpha = np.rint(255 * expected[..., 3])
        self.assertLessEqual(np.abs(image[..., 3] - alpha).max(), 1)
        return expected

    def test_linear_field_in_a_cube(self):
        path = self.write("cube.vtu", CUBE, [(12, list(range(8)))], [("u", [p[0] for p in CUBE])])
        for view in (EYE, PARALLEL):
            self.check_cube(view, path)

    def test_affine_elements(self):
        """Sheared hexahedra and tetrahedra that fill the same body."""
        shear = np.array([[1.0, 0.2, 0.1], [0.0, 0.9, -0.3], [0.1, 0.0, 0.8]])
        points = (np.asarray(CUBE) @ shear.T).tolist()
        u = [0.5 + 0.4 * p[0] - 0.3 * p[1] + 0.2 * p[2] for p in points]
        hexahedron = [(12, list(range(8)))]
        # Six tetrahedra around the diagonal from corner 0 to corner 6.
        ring = [1, 2, 3, 7, 4, 5]
        tetrahedra = [(10, [0, ring[k], ring[(k + 1) % 6], 6]) for k in range(6)]
        inverse = np.linalg.inv(shear)
        for name, cells in (("hexahedron", hexahedron), ("tetrahedra", tetrahedra)):
            path = self.write(f"{name}.vtu", points, cells, [("u", u)])
            for view in (EYE, PARALLEL):
                origin, direction = view.rays()
                summary, rgba, bound, _ = self.draw(path, view)
                o, d = origin @ inverse.T, direction @ inverse.T
                with np.errstate(divide="ignore"):
                    ends = np.stack([(end - o) / d for end in (0.0, 1.0)])
                near, far = ends.min(axis=0).max(axis=-1), ends.max(axis=0).min(axis=-1)
                expected = np.zeros(rgba.shape)
                slope = np.array([0.4, -0.3, 0.2])
                for at in np.argwhere(far > near):
                    at = tuple(at)
                    light = Light()
                    light.add(
                        far[at] - near[at],
                        *(0.5 + slope @ (origin[at] + t * direction[at]) for t in (near[at], far[at])),
                    )
                    expected[at] = light.result()
                self.check(rgba, bound, expected)
                self.assertGreater((bound <= HALF_LEVEL).mean(), 0.99)

    def curved_cube(self):
        """[0,1]^3 as two triquadratic hexahedra with curved maps, whose common face is curved; the
        field is x, which their maps take on as well."""
        order = [(0, 0, 0), (2, 0, 0), (2, 2, 0), (0, 2, 0), (0, 0, 2), (2, 0, 2), (2, 2, 2), (0, 2, 2),
                 (1, 0, 0), (2, 1, 0), (1, 2, 0), (0, 1, 0), (1, 0, 2), (2, 1, 2), (1, 2, 2), (0, 1, 2),
                 (0, 0, 1), (2, 0, 1), (2, 2, 1), (0, 2, 1), (0, 1, 1), (2, 1, 1), (1, 0, 1), (1, 2, 1),
                 (1, 1, 0), (1, 1, 2), (1, 1, 1)]
        points, cells = [], []
        for cell in range(2):
            ids = []
            for i, j, k in order:
                x = np.array([0.5 * cell + i / 4, j / 2, k / 2])
                bubble = 16 * x[1] * (1 - x[1]) * x[2] * (1 - x[2])
                inner = math.sin(math.pi * x[0])
                x[0] += 0.09 * inner * bubble
                x[1] += 0.05 * math.sin(math.pi * x[1]) * inner * (0.5 - x[2])
                ids.append(len(points))
                points.append(x.tolist())
            cells.append((29, ids))
        return points, cells

    def test_curved_map(self):
        points, cells = self.curved_cube()
        vector = [[0.6 * p[0], 0.0, 0.8 * p[0]] for p in points]
        path = self.write("curved.vtu", points, cells, [("u", [p[0] for p in points]), ("v", vector)])
        self.check_cube(EYE, path, share=0.98)
        self.check_cube(PARALLEL, path, share=0.98)
        self.check_cube(EYE, path, field="v", share=0.95)
        self.check_cube(EYE, path, field="v.z", value=lambda x: 0.8 * x[..., 0], share=0.98)

    def test_curved_boundary(self):
        """Against brute force: positions along rays, located by probe."""
        view = View([2.6, -3.1, 2.4], [0.1, 0.0, 0.0], [0.1, 0.2, 1.0], 6, 4, angle=24.0)
        for name in ("toroid_hex_g3_p6", "toroid_prism_g3_p4", "escher_tet_g3_p3"):
            with self.subTest(name):
                self.check_by_steps(DATA / f"{name}.vtu", view)

    def check_by_steps(self, case, view, steps=6000, near=1.6, far=7.6):
        summary, rgba, bound, _ = self.draw(case, view)
        self.assertLess(summary["volume"]["unproven"], 3)
        origin, direction = view.rays()
        width = (far - near) / steps
        t = near + width * (np.arange(steps) + 0.5)
        positions = origin[..., None, :] + t[:, None] * direction[..., None, :]
        found = self.probe(case, positions.reshape(-1, 3))
        inside = (found["verdict"] == "inside").reshape(-1, steps)
        values = np.asarray(found["value"], float).reshape(-1, steps)
        opacity = [[p[0] for p in OPACITIES[:2]], [p[1] for p in OPACITIES[:2]]]
        beyond = [[p[0] for p in OPACITIES[2:]], [p[1] for p in OPACITIES[2:]]]
        hit = 0
        for ray, (row, along) in enumerate(zip(inside, values)):
            hit += row.any()
            u = along[row]
            alpha = np.where(u < 0.3, np.interp(u, *opacity), np.interp(u, *beyond))
            depth = -np.log1p(-alpha) * width / UNIT
            before = np.exp(-np.concatenate([[0.0], np.cumsum(depth)]))
            absorbed = before[:-1] - before[1:]
            color = [
                (np.interp(u, [p[0] for p in COLORS], [p[c] for p in COLORS]) * absorbed).sum()
                for c in (1, 2, 3)
            ]
            off = np.abs(rgba.reshape(-1, 4)[ray] - [*color, 1 - before[-1]]).max()
            # An end of the matter is off by half a step at most.
            self.assertLess(off, bound.reshape(-1)[ray] + 6 * width)
        self.assertGreater(hit, 6)

    def test_surfaces(self):
        """In front of, inside and behind; opaque and translucent."""
        path = self.write("cube.vtu", CUBE, [(12, list(range(8)))], [("u", [p[0] for p in CUBE])])
        near, far = slabs(EYE, [0, 0, 0], [1, 1, 1])
        origin, direction = EYE.rays()
        for alpha in (1.0, 0.4):
            opacity = ["--layer", f"1:opacity={alpha}"] if alpha < 1 else []
            summary, rgba, bound, _ = self.draw(
                path, EYE, "--plane", "0.5,0.5,0.6,0.1,0.2,1", "--color", "1,0,0", "--lights", "off", *opacity)
            normal = np.array([0.1, 0.2, 1.0])
            t = ((np.array([0.5, 0.5, 0.6]) - origin) @ normal) / (direction @ normal)
            meets = (t > near) & (t < far)
            self.assertGreater(meets.sum(), 100)
            expected = np.zeros(rgba.shape)
            for at in np.argwhere(far > near):
                at = tuple(at)
                x = lambda s: (origin[at] + s * direction[at])[0]
                light = Light()
                if meets[at]:
                    light.add(t[at] - near[at], x(near[at]), x(t[at]))
                    light.add_layer([1, 0, 0], alpha)
                    light.add(far[at] - t[at], x(t[at]), x(far[at]))
                else:
                    light.add(far[at] - near[at], x(near[at]), x(far[at]))
                expected[at] = light.result()
            self.check(rgba, bound, expected)
            self.assertEqual(summary["volume"]["unproven"], 0)
        # On the boundary an opaque surface leaves nothing of the volume.
        _, rgba, _, image = self.draw(path, EYE, "--boundary", "--color", "0,1,0", "--lights", "off")
        hit = far > near + 1e-6
        np.testing.assert_allclose(rgba[hit], np.broadcast_to([0, 1, 0, 1], rgba[hit].shape), atol=1e-6)
        self.assertTrue((image[hit] == [0, 255, 0, 255]).all())

    def test_clip(self):
        path = self.write("cube.vtu", CUBE, [(12, list(range(8)))], [("u", [p[0] for p in CUBE])])
        _, rgba, bound, _ = self.draw(path, EYE, "--clip", "0.4,0,0,1,0,0")
        near, far = slabs(EYE, [0.4, 0, 0], [1, 1, 1])
        origin, direction = EYE.rays()
        expected = np.zeros(rgba.shape)
        for at in np.argwhere(far > near):
            at = tuple(at)
            light = Light()
            light.add(far[at] - near[at], *((origin[at] + t * direction[at])[0] for t in (near[at], far[at])))
            expected[at] = light.result()
        self.check(rgba, bound, expected)

    def two_cubes(self, shift):
        points = CUBE + [[p[0] + shift, p[1], p[2]] for p in CUBE]
        return points, [(12, list(range(8))), (12, list(range(8, 16)))]

    def test_jump_of_the_field(self):
        points, cells = self.two_cubes(1.0)
        path = self.write("jump.vtu", points, cells, [("u", [0.2] * 8 + [0.7] * 8)])
        view = View([4.6, -3.1, 2.4], [1.0, 0.5, 0.5], [0.1, 0.2, 1.0], 44, 32, angle=28.0)
        summary, rgba, bound, _ = self.draw(path, view)
        ends = [slabs(view, [k, 0, 0], [k + 1, 1, 1]) for k in range(2)]
        expected = np.zeros(rgba.shape)
        for at in np.ndindex(rgba.shape[:2]):
            light = Light()
            for near, far, u in sorted((ends[k][0][at], ends[k][1][at], (0.2, 0.7)[k]) for k in range(2)):
                if far > near:
                    light.add(far - near, u, u)
            expected[at] = light.result()
        self.check(rgba, bound, expected)
        self.assertEqual(summary["volume"]["unproven"], 0)

    def test_overlap_and_nan(self):
        points, cells = self.two_cubes(0.5)
        path = self.write("overlap.vtu", points, cells, [("u", [0.2] * 8 + [0.7] * 8)])
        done = self.succeeds("render", path, "--volume", "u", "--size", "40x30", "--output", self.folder / "o.png")
        self.assertRegex(done.stderr, r"\d+ pixels of the volume are not proven")
        near, far = slabs(EYE, [0.5, 0, 0], [1, 1, 1])
        _, _, bound, _ = self.draw(path, EYE)
        self.assertTrue(np.isinf(bound[far > near + 1e-3]).all())
        path = self.write("nan.vtu", points, cells, [("u", [0.2] * 8 + [math.nan] * 8)])
        summary, _, bound, _ = self.draw(path, EYE)
        self.assertGreater(summary["volume"]["unproven"], 100)

    def test_overlap_in_the_dark(self):
        """What lies behind 4095 of 4096 parts of the light is left out, but an overlap in front of it is not."""
        points, cells = self.two_cubes(0.5)
        path = self.write("overlap.vtu", points, cells, [("u", [0.2] * 8 + [0.7] * 8)])
        self.write_transfer(Points=[0.0, 0.999, 0.5, 0.0, 1.0, 0.999, 0.5, 0.0])
        near, far = slabs(EYE, [0.5, 0, 0], [1, 1, 1])
        _, _, bound, _ = self.draw(path, EYE)
        self.assertTrue(np.isinf(bound[far > near + 1e-3]).all())

    def test_magnitude_about_zero(self):
        """Magnitudes have no second derivative at 0, and no point of the transfer function is there."""
        self.write_transfer(Points=[0.1, 0.9, 0.5, 0.0, 1.0, 0.9, 0.5, 0.0])
        near, far = slabs(EYE, [0, 0, 0], [1, 1, 1])
        right = 1 - 0.1 ** (np.maximum(far - near, 0.0) / UNIT)
        for name, vector in (("zero", [[0.0] * 3] * 8), ("middle", [[0.5 - c for c in p] for p in CUBE])):
            path = self.write(f"{name}.vtu", CUBE, [(12, list(range(8)))], [("v", vector)])
            summary, rgba, bound, _ = self.draw(path, EYE, field="v")
            off = np.abs(rgba[..., 3] - right)
            self.assertFalse((off > bound + 1e-9).any(), f"{off.max()} {bound.max()}")
            self.assertEqual(summary["volume"]["unproven"], 0)

    def test_preset_and_default_camera(self):
        path = self.write("cube.vtu", CUBE, [(12, list(range(8)))], [("u", [p[0] for p in CUBE])])
        output = self.folder / "preset.png"
        summary = self.summary("render", path, "--volume", "u", "--size", "60x50", "--output", output)
        self.assertEqual(summary["volume"]["unproven"], 0)
        self.assertAlmostEqual(summary["volume"]["opacity_unit"], math.sqrt(3) / 10, places=4)
        image = read_image(output).astype(int)
        self.assertGreater((image[..., :3].sum(axis=-1) < 700).mean(), 0.1)
        # The camera shows all of the cube: the picture's edge is background.
        edge = np.concatenate([image[0], image[-1], image[:, 0], image[:, -1]])
        self.assertTrue((edge[:, :3] == 255).all())

    def test_refusals(self):
        path = self.write("cube.vtu", CUBE, [(12, list(range(8)))], [("u", [p[0] for p in CUBE])])
        out = ["--output", self.folder / "x.png"]
        self.fails(1, "render", path, "--volume", "w", *out, names=["w"])
        self.fails(1, "render", path, "--volume", "u^2", *out, names=["u^2"])
        self.fails(2, "render", path, "--volume", "u", "--transfer", "nosuchmap", *out, names=["nosuchmap"])
        self.fails(2, "render", path, "--volume", "u", "--samples", 4, *out, names=["--samples"])
        self.fails(2, "render", path, "--volume", "u", "--opacity-unit", 0, *out, names=["--opacity-unit"])
        self.fails(2, "render", path, "--transfer", "viridis", *out, names=["--volume"])
        for idle in (["--field", "u"], ["--contours", "3"], ["--colormap", "plasma"]):
            self.fails(2, "render", path, "--volume", "u", *idle, *out, names=[idle[0], "no effect"])
        for changes, text in (
            ({"Points": [0.0, 0.1, 0.5]}, "four numbers"),
            ({"Points": [0.0, 1.5, 0.5, 0.0, 1.0, 0.5, 0.5, 0.0]}, "between 0 and 1"),
            ({"Points": [1.0, 0.5, 0.5, 0.0, 0.0, 0.5, 0.5, 0.0]}, "ascending"),
            ({"Points": [0.0, 0.1, 0.5, 0.4, 1.0, 0.5, 0.5, 0.0]}, "sharpness"),
        ):
            self.write_transfer(**changes)
            self.fails(1, "render", path, "--volume", "u", "--transfer", self.transfer, *out, names=[text])
        self.write_transfer(UseLogScale=1)
        self.fails(1, "render", path, "--volume", "u", "--transfer", self.transfer, *out, names=["UseLogScale"])
        self.write_transfer()
        self.fails(2, "render", path, "--volume", "u", "--transfer", self.transfer, "--range", "0,2", *out,
                   names=["--range", "--transfer"])
        self.fails(2, "render", path, "--volume", "u", "--range", "10%,20%", *out, names=["--range"])
        self.fails(1, "render", path, "--volume", "u", "--transfer", "nosuch.json", *out,
                   names=["--transfer: 'nosuch.json'"])
        self.write_transfer(ColorSpace="HSV")
        self.succeeds("render", path, "--volume", "u", "--transfer", self.transfer, *out)
        self.transfer.write_text("{ not json", encoding="utf-8")
        self.fails(1, "render", path, "--volume", "u", "--transfer", self.transfer, *out, names=["JSON"])


if __name__ == "__main__":
    unittest.main()
