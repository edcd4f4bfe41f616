# SPDX-License-Identifier: BSD-3-Clause
"""pixelexact compare --with: differences of two solutions, and how a series converges, against
closed forms."""

import shutil
import unittest

import numpy as np

from lagrange import lagrange_grid
from tool import CUBE, DATA, ToolTest, View, case, plain_grid, read_buffers, read_csv, read_image

NOTHING, BOTH, UNKNOWN, FIRST, SECOND = range(5)
SIZE = ["--size", "300x300"]


def smooth(x, y, z):
    return np.sin(2.0 * x + 0.3) * np.cos(1.5 * y) * np.exp(0.7 * z)


class Difference(ToolTest):
    def write(self, name, text):
        path = self.folder / name
        path.write_text(text, encoding="utf-8")
        return path

    def cube(self, name, value, lower=0.0, field="u"):
        points = [[x + lower, y, z] for x, y, z in CUBE]
        cells = [(12, list(range(8)))]
        return self.write(
            name, plain_grid(points, cells, [(field, [value(*point) for point in points])])
        )

    def difference(self, *arguments):
        buffers = self.folder / "difference.vti"
        picture = self.folder / "difference.png"
        summary = self.summary("compare", *arguments, "-o", picture, "--buffers", buffers)
        return summary, read_buffers(buffers), read_image(picture)

    def test_is_that_of_the_closed_forms_where_both_meshes_are(self):
        first = self.cube("a.vtu", lambda x, y, z: 1.0 + x + 2.0 * y - z)
        second = self.cube("b.vtu", lambda x, y, z: 3.0 * x - y, lower=0.5)
        view = View([0.75, 0.5, 5.0], [0.75, 0.5, 0.25], [0.0, 1.0, 0.0], 300, 300, scale=0.9)
        summary, buffers, picture = self.difference(
            first, "--plane", "z=0.25", "--with", second, *view.options()
        )
        position, side = buffers["Position"], buffers["Side"]
        x, y = position[..., 0], position[..., 1]
        both = side == BOTH
        # Half of each square is in the other one.
        self.assertGreater(both.sum(), 3000)
        self.assertTrue(((x > 0.5) & (x < 1.0) == both)[side != NOTHING].all())
        self.assertTrue((x[side == FIRST] < 0.5).all() and (x[side == SECOND] > 1.0).all())
        expected = 1.0 + x + 2.0 * y - 0.25 - (3.0 * x - y)
        value = buffers["Value"]
        np.testing.assert_allclose(value[both], expected[both], atol=1e-14)
        self.assertTrue(np.isnan(value[~both]).all())
        self.assertTrue((buffers["Verdict"][both] == 1).all())
        self.assertTrue((buffers["Verdict"][~both] == 0).all())
        np.testing.assert_allclose(
            buffers["First"][both | (side == FIRST)],
            (0.75 + x + 2.0 * y)[both | (side == FIRST)],
            atol=1e-14,
        )
        self.assertTrue(np.isnan(buffers["First"][side == SECOND]).all())
        lower, upper = buffers["Value_lower"][both], buffers["Value_upper"][both]
        self.assertTrue(((lower <= value[both]) & (value[both] <= upper)).all())
        pixels = summary["pixels"]
        for name, kind in [
            ("both", BOTH),
            ("only_first", FIRST),
            ("only_second", SECOND),
            ("unknown", UNKNOWN),
            ("nothing", NOTHING),
        ]:
            self.assertEqual(pixels[name], (side == kind).sum(), name)
        self.assertGreater(pixels["only_first"], 3000)
        self.assertEqual(pixels["largest"], np.abs(value[both]).max())
        at = np.unravel_index(np.nanargmax(np.abs(value)), value.shape)
        np.testing.assert_array_equal(pixels["largest_at"], position[at])
        self.assertAlmostEqual(pixels["mean"], np.abs(value[both]).mean(), delta=1e-14)
        root = np.sqrt((value[both] ** 2).mean())
        self.assertAlmostEqual(pixels["l2"], root, delta=1e-14)
        self.assertLess(pixels["largest_bound"], 1e-13)
        self.assertGreaterEqual(
            pixels["largest_bound"], np.maximum(upper - value[both], value[both] - lower).max()
        )
        self.assertLessEqual(pixels["largest_true"][0], pixels["largest"])
        self.assertGreaterEqual(pixels["largest_true"][1], pixels["largest"])
        # As far to both sides of 0.
        self.assertEqual(summary["range"][0], -summary["range"][1])
        self.assertEqual(summary["range"][1], pixels["largest"])
        # Each side has a colour of its own.
        left, bottom = summary["figure"]["picture"]
        shown = picture[bottom : bottom + side.shape[0], left : left + side.shape[1]]
        colors = {kind: np.unique(shown[side == kind], axis=0) for kind in (FIRST, SECOND)}
        self.assertEqual([len(color) for color in colors.values()], [1, 1])
        self.assertFalse((colors[FIRST] == colors[SECOND]).all())
        self.assertTrue((shown[side == NOTHING] == 255).all())

    def test_of_a_solution_from_itself_is_zero(self):
        path = case("toroid_hex_g3_p6")
        summary, buffers, _ = self.difference(
            path, "--field", "u", "--plane", "z=0.1", "--with", path, *SIZE
        )
        self.assertEqual(summary["pixels"]["largest"], 0.0)
        self.assertEqual(summary["pixels"]["proven_apart"], 0)
        self.assertTrue((buffers["Value"][buffers["Side"] == BOTH] == 0.0).all())

    def test_swapped_is_the_same_with_the_other_sign(self):
        paths = [case("toroid_hex_g3_p6"), case("toroid_prism_g3_p4")]
        view = View([0.0, 0.0, 6.0], [0.0, 0.0, 0.1], [0.0, 1.0, 0.0], 300, 300, angle=30.0)
        found = [
            self.difference(
                *[a, "--field", "u", "--plane", "z=0.1", "--with", b, *view.options()]
            )[1]
            for a, b in [paths, paths[::-1]]
        ]
        np.testing.assert_array_equal(found[0]["Value"], -found[1]["Value"])
        swapped = np.array([NOTHING, BOTH, UNKNOWN, SECOND, FIRST])[found[1]["Side"]]
        np.testing.assert_array_equal(found[0]["Side"], swapped)

    def test_boundaries_are_those_of_the_first(self):
        first = self.cube("a.vtu", lambda x, y, z: x)
        second = self.cube("b.vtu", lambda x, y, z: 2.0 * x + y, lower=0.5)
        _, buffers, _ = self.difference(first, "--boundary", "--with", second, *SIZE)
        side, x = buffers["Side"], buffers["Position"]
        both = side == BOTH
        self.assertGreater(both.sum(), 1000)
        self.assertEqual((side == SECOND).sum(), 0)
        expected = -x[..., 0] - x[..., 1]
        np.testing.assert_allclose(buffers["Value"][both], expected[both], atol=1e-14)

    def test_magnitudes_are_those_of_the_difference(self):
        first = self.cube("a.vtu", lambda x, y, z: [x, y, z], field="v")
        second = self.cube("b.vtu", lambda x, y, z: [y, x, 0.0], field="v")
        summary, buffers, _ = self.difference(
            first, "--plane", "z=0.5", "--with", second, *SIZE
        )
        x, y = buffers["Position"][..., 0], buffers["Position"][..., 1]
        both = buffers["Side"] == BOTH
        expected = np.sqrt(2.0 * (x - y) ** 2 + 0.25)
        np.testing.assert_allclose(buffers["Value"][both], expected[both], atol=1e-14)
        self.assertGreater(summary["range"][0], 0.0)
        _, buffers, _ = self.difference(
            first, "--plane", "z=0.5", "--component", "x", "--with", second, *SIZE
        )
        np.testing.assert_allclose(buffers["Value"][both], (x - y)[both], atol=1e-14)

    def test_the_only_field_is_taken_and_another_is_named(self):
        first = self.cube("a.vtu", lambda x, y, z: x)
        second = self.cube("b.vtu", lambda x, y, z: y, field="w")
        summary, _, _ = self.difference(first, "--plane", "z", "--with", second, *SIZE)
        self.assertGreater(summary["pixels"]["both"], 1000)
        vector = self.cube("v.vtu", lambda x, y, z: [x, y, z], field="v")
        for arguments, name in [
            (["--with", second, "--with-field", "q"], "'q'"),
            (["--with", vector], "3 components"),
        ]:
            self.fails(1, "compare", first, "--field", "u", "--plane", "z", *arguments, names=[name])

    def test_fields_alone_go_with_the_first_mesh(self):
        from tool import DATA

        source = DATA / "mfem49_tinyzoo_g3_p5"
        mesh = next(source.glob("*.mesh"))
        field = sorted(source.glob("*.gf"))[0]
        other = self.folder / "other.gf"
        shutil.copy(field, other)
        summary, _, _ = self.difference(
            mesh, field, "--plane", "z", "--with", other, "--with-field", "other", *SIZE
        )
        self.assertEqual(summary["solution"], "other.gf")
        self.assertEqual(summary["pixels"]["largest"], 0.0)

    def test_wrong_use_is_named(self):
        path = case("toroid_hex_g3_p6")
        for arguments, name in [
            (["--with"], "FILE..."),
            (["--with", path, "--repeat", "2"], "--repeat"),
            (["--with", path, "--contours", "3"], "--contours"),
            (["--with", path, "--range", "field"], "--range field"),
            (["--with", path, "--edges", "2"], "--edges"),
            (["--with", path, "--size", "20x20"], "--figure"),
            (["--with", path, "--output", "a.gif"], "--output"),
            (["--with", path, "--with", path, "--buffers", "b.vti"], "--buffers"),
            (["--figure"], "--figure"),
            (["--buffers", "b.vti"], "--with"),
        ]:
            self.fails(2, "compare", path, "--field", "u", "--plane", "z", *arguments, names=[name])


class Series(ToolTest):
    def series(self, reference, others, *arguments):
        folder = self.folder / "series"
        words = [word for other in others for word in ("--with", other)]
        summary = self.summary(
            *["compare", reference, "--plane", "z=0.43", *SIZE, *arguments, *words, "-o", folder]
        )
        return summary, read_csv(folder / "convergence.csv"), folder

    def write(self, name, *arguments):
        path = self.folder / name
        path.write_text(lagrange_grid(smooth, *arguments), encoding="utf-8")
        return path

    def test_interpolants_converge_with_the_power_that_theory_tells(self):
        # Off the smooth function by some 1e-10.
        reference = self.write("reference.vtu", 2, 8)
        for order in [1, 2, 3]:
            others = [self.write(f"p{order}_{n}.vtu", n, order) for n in (2, 4, 8)]
            # In any order.
            summary, rows, folder = self.series(reference, others[::-1])
            self.assertEqual([int(row["elements"]) for row in rows], [8, 64, 512])
            lengths = np.array([float(row["relative_length"]) for row in rows])
            np.testing.assert_allclose(lengths, [0.5, 0.25, 0.125], rtol=1e-9)
            self.assertEqual(summary["convergence"]["over"], "relative_length")
            orders = summary["convergence"]["orders"]
            self.assertAlmostEqual(orders["L2"]["last"], order + 1.0, delta=0.12)
            self.assertAlmostEqual(orders["L2"]["overall"], order + 1.0, delta=0.2)
            self.assertAlmostEqual(float(rows[-1]["order_of_l2"]), orders["L2"]["last"], delta=1e-9)
            errors = [float(row["l2"]) for row in rows]
            slope = np.polyfit(np.log(lengths), np.log(errors), 1)[0]
            self.assertAlmostEqual(orders["L2"]["overall"], slope, delta=1e-9)
            for name in ["convergence.png", "difference-1.png", "difference-3.png"]:
                self.assertGreater((folder / name).stat().st_size, 1000)

    def test_errors_are_those_of_the_closed_form(self):
        reference = self.write("reference.vtu", 2, 8)
        other = self.write("p2.vtu", 4, 2)
        buffers = self.folder / "difference.vti"
        self.summary(
            *["compare", reference, "--plane", "z=0.43", "--with", other, *SIZE],
            *["-o", self.folder / "d.png", "--buffers", buffers],
        )
        found = read_buffers(buffers)
        both = found["Side"] == BOTH
        x = found["Position"][both].T
        # The interpolant by Lagrange's formula in each direction, within a cell of a quarter.
        cell = np.minimum(np.floor(4.0 * x), 3.0)
        t = 4.0 * x - cell
        weights = np.stack([(1 - t) * (1 - 2 * t), 4 * t * (1 - t), t * (2 * t - 1)])
        expected = np.zeros(x.shape[1])
        for i, j, k in np.ndindex(3, 3, 3):
            nodes = (cell + np.array([[i], [j], [k]]) / 2.0) / 4.0
            expected += weights[i, 0] * weights[j, 1] * weights[k, 2] * smooth(*nodes)
        np.testing.assert_allclose(found["Second"][both], expected, atol=1e-13)
        np.testing.assert_allclose(found["First"][both], smooth(*x), atol=1e-9)

    def test_orders_converge_over_modes(self):
        reference = self.write("reference.vtu", 2, 8)
        others = [self.write(f"p{order}.vtu", 2, order) for order in (1, 2, 3, 4)]
        summary, rows, _ = self.series(reference, others)
        self.assertEqual(summary["convergence"]["over"], "modes")
        self.assertEqual([int(row["modes"]) for row in rows], [8 * (p + 1) ** 3 for p in (1, 2, 3, 4)])
        errors = [float(row["l2"]) for row in rows]
        # Exponential: each order gains a factor of its own.
        for finer, coarser in zip(errors[1:], errors):
            self.assertLess(finer, 0.2 * coarser)

    def test_what_is_below_the_bound_has_no_order(self):
        reference = case("toroid_hex_g3_p6")
        summary, rows, _ = self.series(reference, [reference, reference], "--field", "u")
        self.assertNotIn("orders", summary["convergence"])
        self.assertEqual([row["order_of_l2"] for row in rows], ["", ""])


class OverTime(ToolTest):
    STEPS = DATA / "vtkhdf_steps.vtkhdf"

    def test_each_step_is_compared(self):
        folder = self.folder / "out"
        view = ["--field", "u", "--plane", "z=0.5", "--size", "500x300"]
        found = self.summary("compare", self.STEPS, *view, "--time-step", "all", "--with", self.STEPS,
            "--with-time-step", "0", "-o", folder)  # fmt: skip
        steps = found["steps"]
        self.assertEqual([(step["step"], step["time"]) for step in steps], [(0, 0.0), (1, 0.5), (2, 1.0)])
        # u differs by t (x + x^2), at most 12 t for x up to 3.
        largest = [step["pixels"]["largest"] for step in steps]
        self.assertLess(largest[0], 1e-13)
        self.assertAlmostEqual(largest[1], 0.5 * largest[2], delta=1e-13)
        self.assertLess(largest[2], 12.0)
        self.assertGreater(largest[2], 11.5)
        rows = read_csv(folder / "over_time.csv")
        self.assertEqual([float(row["largest"]) for row in rows], largest)
        self.assertEqual([float(row["l2"]) for row in rows], [step["pixels"]["l2"] for step in steps])
        for name in ("difference-0", "difference-2", "over_time"):
            self.assertGreater(len(np.unique(read_image(folder / f"{name}.png").reshape(-1, 3), axis=0)), 3)
        # The other solution goes along, where no step of it is given.
        found = self.summary("compare", self.STEPS, *view, "--time-step", "all", "--with", self.STEPS, "-o", folder)
        self.assertLess(max(step["pixels"]["largest"] for step in found["steps"]), 1e-13)
        text = self.succeeds("compare", self.STEPS, *view, "--time-step", "all", "--with", self.STEPS,
            "--with-time-step", "0", "-o", folder).stdout  # fmt: skip
        self.assertRegex(text, r"step 2 +time 1: largest 11\.\d+, mean ")

    def test_refusals(self):
        base = ["compare", self.STEPS, "--field", "u", "--plane", "z=0.5", "--time-step", "all"]
        self.fails(2, *base, names=["--time-step all", "--with"])
        self.fails(2, *base, "--with", self.STEPS, "--with", self.STEPS, names=["--time-step all", "once"])
        self.fails(2, *base, "--with", self.STEPS, "--buffers", self.folder / "b.vti", names=["--buffers"])
        still = case("toroid_hex_g3_p6")
        self.fails(1, "compare", still, "--field", "u", "--plane", "z", "--time-step", "all", "--with", still,
            names=["no time steps"])  # fmt: skip


if __name__ == "__main__":
    unittest.main()
