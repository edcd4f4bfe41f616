# SPDX-License-Identifier: BSD-3-Clause
"""pixelexact render: what its buffers hold is true of every pixel."""

import unittest

import numpy as np

from tool import (
    CASES,
    MIDDLE,
    ToolTest,
    View,
    case,
    columns,
    plain_grid,
    read_buffers,
    read_csv,
    read_image,
    run,
    strict_json,
    unit,
    unit_cube_grid,
)

NOTHING, EXACT, UNKNOWN = 0, 1, 2


def numbers(values):
    return ",".join(repr(float(v)) for v in values)


class RenderTest(ToolTest):
    def write(self, name, text):
        path = self.folder / name
        path.write_text(text, encoding="utf-8")
        return path

    def render(self, source, planes, *options, field="u"):
        """Summary, buffers and picture."""
        image, buffers = self.folder / "image.png", self.folder / "buffers.vti"
        cuts = [word for plane in planes for word in ("--plane", numbers(plane))]
        outputs = ["--output", image, "--buffers", buffers]
        summary = self.summary("render", source, "--field", field, *cuts, *options, *outputs)
        return summary, read_buffers(buffers), read_image(image)

    def probe(self, source, positions, field="u"):
        points, out = self.folder / "points.csv", self.folder / "out.csv"
        lines = "".join(numbers(position) + "\n" for position in positions)
        points.write_text("x,y,z\n" + lines, encoding="utf-8")
        self.succeeds("probe", source, "--field", field, "--points", points, "--output", out)
        return columns(read_csv(out))

    def check_geometry(self, buffers, view, planes):
        """Each hit lies on a plane and on its pixel's ray, as far along it as its depth says."""
        hit = buffers["Verdict"] != NOTHING
        origin, direction = view.rays()
        position, depth = buffers["Position"], buffers["Depth"]
        along = origin + np.where(hit, depth, 0)[..., None] * direction
        size = 1 + np.abs(view.position).max()
        self.assertLess(np.abs((position - along)[hit]).max(), 1e-13 * size)
        planes = np.asarray(planes)
        off = np.min([np.abs((position - p[:3]) @ unit(p[3:])) for p in planes], axis=0)
        self.assertLess(off[hit].max(), 1e-14 * size)
        self.assertTrue(np.isnan(position[~hit]).all())
        self.assertTrue(np.isposinf(depth[~hit]).all())
        exact = buffers["Verdict"] == EXACT
        self.assertTrue((buffers["Element"][exact] >= 0).all())
        self.assertTrue((buffers["Element"][~hit] == -1).all())
        self.assertTrue(np.isnan(buffers["Value"][~exact]).all())
        self.assertTrue(np.isnan(buffers["Xi"][~exact]).all())
        self.assertTrue((buffers["Color"][~hit] == 0).all())
        self.assertTrue((buffers["Color"][hit][:, 3] == 255).all())


class Truth(RenderTest):
    def test_every_pixel_of_every_case(self):
        """Value, element and xi are those of a probe at the position, bit for bit."""
        planes = [[0.05, -0.1, 0.03, 0.3, -0.2, 1.0]]
        planes_of = {"dolfinx_hex_g2_p4": [[1.0, 0.5, -1.0, 0.3, 1.0, 0.2]]}
        for name in CASES:
            with self.subTest(name=name):
                cut = planes_of.get(name, planes)
                summary, buffers, _ = self.render(case(name), cut, "--size", "90x70")
                view = View.of_summary(summary["camera"], 90, 70)
                self.check_geometry(buffers, view, cut)
                exact = buffers["Verdict"] == EXACT
                self.assertGreater(exact.sum(), 200)
                self.assertEqual(summary["pixels"]["exact"], exact.sum())
                unknown = (buffers["Verdict"] == UNKNOWN).sum()
                self.assertEqual(summary["pixels"]["unknown"], unknown)
                found = self.probe(case(name), buffers["Position"][exact])
                self.assertTrue((found["verdict"] == "inside").all())
                self.assertTrue((found["value"] == buffers["Value"][exact]).all())
                self.assertTrue((found["element"] == buffers["Element"][exact]).all())
                for d in range(3):
                    self.assertTrue((found[f"xi_{d}"] == buffers["Xi"][exact][:, d]).all())
                low, high = summary["value_range"]
                self.assertEqual((found["value"].min(), found["value"].max()), (low, high))

    def test_given_cameras(self):
        plane = [0.0, 0.0, 0.1, 0.2, 0.1, 1.0]
        for zoom in [{"angle": 35.0}, {"scale": 1.7}]:
            for size in [(80, 50), (40, 70), (33, 33)]:
                view = View([2, -3, 4], [0.1, 0.05, 0], [0.1, 0.2, 1], *size, **zoom)
                _, buffers, _ = self.render(case("toroid_hex_g3_p6"), [plane], *view.options())
                self.check_geometry(buffers, view, [plane])
                self.assertTrue(np.allclose(
                    buffers["Normal"][buffers["Verdict"] == EXACT], unit(plane[3:]), atol=1e-15
                ))

    def test_default_camera_sees_everything(self):
        """The whole data set, along the normal."""
        for normal in [[0, 0, 1], [1, 0, 0], [0, -2, 0], [1, 1, 1], [0, 0, -1]]:
            summary, buffers, _ = self.render(
                case("toroid_hex_g3_p6"), [[0, 0, 0, *normal]], "--size", "60x60"
            )
            camera = summary["camera"]
            toward = unit(np.subtract(camera["position"], camera["focal_point"]))
            self.assertTrue(np.allclose(toward, unit(normal), atol=1e-12))
            verdict = buffers["Verdict"]
            self.assertGreater((verdict == EXACT).sum(), 50)
            for edge in [verdict[0], verdict[-1], verdict[:, 0], verdict[:, -1]]:
                self.assertTrue((edge == NOTHING).all())

    def test_planes_in_front_of_each_other(self):
        """The nearest hit inside of the mesh is seen, through whatever lies before it outside."""
        cube = self.write("cube.vtu", unit_cube_grid())
        view = View([0.5, 0.5, 5], [0.5, 0.5, 0], [0, 1, 0], 20, 20, scale=0.6)
        near, far, outside = [0, 0, 0.75, 0, 0, 1], [0, 0, 0.25, 0, 0, 1], [0, 0, 2, 0, 0, 1]
        half = [0.5, 0.5, 0.5, 1, 0, 1]
        _, first, _ = self.render(cube, [near], *view.options())
        for planes in [[near, far], [far, near], [outside, near, far]]:
            _, buffers, _ = self.render(cube, planes, *view.options())
            self.assertTrue((buffers["Depth"] == first["Depth"]).all())
        _, buffers, _ = self.render(cube, [half, far], *view.options())
        exact = buffers["Verdict"] == EXACT
        z = buffers["Position"][exact][:, 2]
        x = buffers["Position"][exact][:, 0]
        self.assertTrue(np.allclose(z, np.maximum(1 - x, 0.25), atol=1e-14))

    def test_threads_do_not_matter(self):
        outputs = []
        for threads in [1, 2]:
            self.render(case("escher_tet_g3_p3"), [[0, 0, 0, 0.3, 0.2, 1]], "--size", "150x120",
                        "--threads", threads)
            outputs.append([(self.folder / f).read_bytes() for f in ["image.png", "buffers.vti"]])
        self.assertEqual(*outputs)


def tetrahedra_of_cube(n):
    """[0,1]^3 as 6 n^3 tetrahedra with u = x + 2 y - 3 z."""
    side = np.linspace(0.0, 1.0, n + 1)
    points = [[x, y, z] for z in side for y in side for x in side]

    def number(i, j, k):
        return (k * (n + 1) + j) * (n + 1) + i

    cells = []
    for i, j, k in np.ndindex(n, n, n):
        for axes in [(0, 1, 2), (0, 2, 1), (1, 0, 2), (1, 2, 0), (2, 0, 1), (2, 1, 0)]:
            corner = np.array([i, j, k])
            ids = [number(*corner)]
            for axis in axes:
                corner[axis] += 1
                ids.append(number(*corner))
            cells.append((10, [int(v) for v in ids]))
    return plain_grid(points, cells, [("u", [x + 2 * y - 3 * z for x, y, z in points])])


class SinglePrecision(RenderTest):
    def test_values_alone_differ_and_it_is_told_by_how_much(self):
        planes = [(0, 0, 0.1, 0, 0.2, 1)]
        for name in ["toroid_hex_g3_p6", "escher_tet_g3_p3"]:
            _, exact, _ = self.render(case(name), planes, "--size", "90x70")
            summary, buffers, _ = self.render(
                case(name), planes, "--size", "90x70", "--precision", "float"
            )
            for array in ["Verdict", "Element", "Xi", "Position"]:
                np.testing.assert_array_equal(buffers[array], exact[array])
            inside = exact["Verdict"] == EXACT
            difference = np.abs(buffers["Value"] - exact["Value"])[inside].max()
            told = summary["float"]["largest_difference"]
            self.assertGreater(summary["float"]["checked"], 0)
            self.assertGreater(told, 0)
            self.assertGreaterEqual(difference, told)
            # A part of the pixels was looked at.
            self.assertLess(difference, 5 * told)
            self.assertLess(difference, 1e-5 * np.ptp(exact["Value"][inside]))
        render = ["render", case("escher_tet_g3_p3"), "--field", "u", *MIDDLE]
        for option in ("--show-undecided", "--enclosures"):
            for floats in (["--precision", "float"], ["--layer", "1:precision=float"]):
                self.fails(
                    2, *render, *floats, option, "--output", self.folder / "i.png",
                    names=[option, "single precision", floats[1].split(":")[-1]],
                )


class NoPinholes(RenderTest):
    def test_pixels_on_shared_faces_and_edges(self):
        """Cuts through the faces of a cube of tetrahedra, pixel centres on their edges: no pixel of
        the cube is missing, none beyond it is there, every value is the linear function's."""
        source = self.write("tets.vtu", tetrahedra_of_cube(4))
        for origin, normal, up in [
            ([0, 0, 0.5], [0, 0, 1], [0, 1, 0]),
            ([0.25, 0, 0], [1, 0, 0], [0, 0, 1]),
            ([0, 0.75, 0], [0, 1, 0], [0, 0, 1]),
            ([0, 0, 0], [1, -1, 0], [0, 0, 1]),
            ([0.5, 0.5, 0.5], [1, 1, 1], [0, 0, 1]),
            ([0.5, 0.5, 0.5], [1, 2, -0.5], [0, 0, 1]),
        ]:
            with self.subTest(origin=origin, normal=normal):
                # 65 pixels over 1.3 units: centres at multiples of 0.02 from the cube's centre.
                centre = np.array([0.5, 0.5, 0.5])
                view = View(centre + 5 * unit(normal), centre, up, 65, 65, scale=0.65)
                plane = [*origin, *normal]
                _, buffers, _ = self.render(source, [plane], *view.options())
                self.check_geometry(buffers, view, [plane])
                start, direction = view.rays()
                t = (np.subtract(origin, start) @ normal) / (direction @ normal)
                x = start + t[..., None] * direction
                margin = np.minimum(x, 1 - x).min(axis=-1)
                self.assertTrue((buffers["Verdict"][margin > 1e-12] == EXACT).all())
                self.assertTrue((buffers["Verdict"][margin < -1e-12] == NOTHING).all())
                self.assertFalse((buffers["Verdict"] == UNKNOWN).any())
                exact = buffers["Verdict"] == EXACT
                error = buffers["Value"][exact] - buffers["Position"][exact] @ [1, 2, -3]
                self.assertLess(np.abs(error).max(), 1e-14)

    def test_no_lone_missing_pixel_in_curved_meshes(self):
        for name in CASES:
            plane = [0, 0.01, 0.02, 0.1, 1, 0.3]
            _, buffers, _ = self.render(case(name), [plane], "--size", "200x200")
            seen = np.pad(buffers["Verdict"] == EXACT, 1)
            around = np.ones(buffers["Verdict"].shape, bool)
            for dy, dx in [(0, 1), (0, -1), (1, 0), (-1, 0)]:
                around &= np.roll(seen, (dy, dx), (0, 1))[1:-1, 1:-1]
            lone = around & (buffers["Verdict"] != EXACT)
            self.assertFalse(lone.any(), f"{name}: {np.argwhere(lone)[:5]}")
            self.assertFalse((buffers["Verdict"] == UNKNOWN).any(), name)


class Colours(RenderTest):
    def setUp(self):
        super().setUp()
        self.cube = self.write("cube.vtu", unit_cube_grid())
        self.view = View([0.5, 0.5, 5], [0.5, 0.5, 0], [0, 1, 0], 40, 30, scale=0.6)
        self.plane = [[0, 0, 0.5, 0, 0, 1]]

    def test_map_range_and_background(self):
        colors = ["--colormap", "grayscale", "--range", "-1,3", "--background", "0.2,0.4,0.6"]
        _, buffers, image = self.render(self.cube, self.plane, *self.view.options(), *colors)
        exact = buffers["Verdict"] == EXACT
        gray = 255 * (buffers["Value"][exact] + 1) / 4
        for channel in range(3):
            self.assertLessEqual(np.abs(buffers["Color"][exact][:, channel] - gray).max(), 1.0)
        self.assertTrue((image[exact] == buffers["Color"][exact][:, :3]).all())
        self.assertTrue((image[~exact] == [51, 102, 153]).all())

    def test_default_range_is_that_of_the_cut(self):
        summary, buffers, image = self.render(
            self.cube, self.plane, *self.view.options(), "--colormap", "grayscale"
        )
        exact = buffers["Verdict"] == EXACT
        self.assertEqual(summary["color_range"], summary["value_range"])
        self.assertEqual((image[exact].min(), image[exact].max()), (0, 255))
        self.assertTrue((image[~exact] == 255).all())

    def test_logarithm(self):
        fields = [("u", [10.0 ** (2 * x) for x in [0, 1, 1, 0, 0, 1, 1, 0]])]
        source = self.write("log.vtu", unit_cube_grid(fields))
        colors = ["--colormap", "grayscale", "--log", "--range", "1,100"]
        _, buffers, _ = self.render(source, self.plane, *self.view.options(), *colors)
        exact = buffers["Verdict"] == EXACT
        gray = 255 * np.log10(buffers["Value"][exact]) / 2
        self.assertLessEqual(np.abs(buffers["Color"][exact][:, 0] - gray).max(), 1.0)
        summary, _, _ = self.render(source, self.plane, *self.view.options(), "--log")
        self.assertEqual(summary["color_range"], summary["value_range"])
        # Values without logarithm.
        fields = [("u", [-1.0, 1.0, 1.0, -1.0, -1.0, 1.0, 1.0, -1.0])]
        source = self.write("sign.vtu", unit_cube_grid(fields))
        summary, buffers, _ = self.render(
            source, self.plane, *self.view.options(), "--log", "--nan-color", "1,0,0"
        )
        self.assertGreater(summary["color_range"][0], 0)
        negative = (buffers["Verdict"] == EXACT) & ~(buffers["Value"] > 0)
        self.assertTrue((buffers["Color"][negative] == [255, 0, 0, 255]).all())

    def test_values_that_are_no_numbers(self):
        nan = float("nan")
        source = self.write("nan.vtu", unit_cube_grid([("u", [nan] * 8)]))
        done = self.succeeds(
            "render", source, "--field", "u", "--plane", "0,0,.5,0,0,1", *self.view.options(),
            "--nan-color", "0,1,0", "--output", self.folder / "i.png", "--json",
        )
        summary = strict_json(done.stdout)
        self.assertEqual(summary["non_finite"], summary["pixels"]["exact"])
        self.assertGreater(summary["non_finite"], 100)
        self.assertIsNone(summary["value_range"])
        picture = read_image(self.folder / "i.png")
        self.assertEqual((picture == [0, 255, 0]).all(axis=-1).sum(), summary["non_finite"])

    def test_constant_field(self):
        source = self.write("constant.vtu", unit_cube_grid([("u", [2.5] * 8)]))
        summary, _, _ = self.render(source, self.plane, *self.view.options())
        self.assertEqual(summary["value_range"], [2.5, 2.5])

    def test_components(self):
        vectors = [[x, 2 * x, -2 * x] for x in [0.0, 1.0, 1.0, 0.0] * 2]
        source = self.write("vector.vtu", unit_cube_grid([("v", vectors)]))
        for options, factor in [
            ([], 3),
            (["--component", "magnitude"], 3),
            (["--component", "0"], 1),
            (["--component", "2"], -2),
        ]:
            options += self.view.options()
            _, buffers, _ = self.render(source, self.plane, *options, field="v")
            exact = buffers["Verdict"] == EXACT
            x = buffers["Position"][exact][:, 0]
            self.assertTrue(np.allclose(buffers["Value"][exact], factor * x, atol=1e-14))
        base = ["--plane", "0,0,0.5,0,0,1", "--output", self.folder / "i.png"]
        for mesh, field, component in [(source, "v", 3), (self.cube, "u", 1)]:
            options = ["--field", field, "--component", component]
            self.fails(1, "render", mesh, *base, *options, names=["--component"])


class Errors(RenderTest):
    def test_missing_field(self):
        self.fails(
            1, "render", case("escher_tet_g3_p3"), "--field", "w", "--plane", "0,0,0,0,0,1",
            "--output", self.folder / "i.png", names=["'w'", "'u'"],
        )

    def test_output_that_cannot_be_written(self):
        base = ["render", case("escher_tet_g3_p3"), "--field", "u", *MIDDLE, "--size", "9x9"]
        absent = self.folder / "absent" / "image.png"
        self.fails(1, *base, "--output", absent, names=[absent])
        folder = self.folder / "folder.png"
        folder.mkdir()
        self.fails(1, *base, "--output", folder, names=[folder])
        absent = absent.with_suffix(".vti")
        self.fails(1, *base, "--output", self.folder / "i.png", "--buffers", absent, names=[absent])

    def test_a_plane_that_misses(self):
        image = self.folder / "i.png"
        done = run("render", case("escher_tet_g3_p3"), "--field", "u", "--plane", "0,0,9,0,0,1",
                   "--size", "20x10", "--output", image, "--background", "0,0,1", "--json")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("warning", done.stderr)
        self.assertIsNone(strict_json(done.stdout)["value_range"])
        self.assertTrue((read_image(image) == [0, 0, 255]).all())

    def test_table(self):
        shot = [case("escher_tet_g3_p3"), "--field", "u", *MIDDLE, "--size", "20x10"]
        done = self.succeeds("render", *shot, "--output", self.folder / "i.png")
        for word in ["elements", "exact", "nothing", "unknown", "non-finite", "rays"]:
            self.assertIn(word, done.stdout)
        self.assertEqual(done.stderr, "")


if __name__ == "__main__":
    unittest.main()
