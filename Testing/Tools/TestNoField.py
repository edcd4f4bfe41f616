# SPDX-License-Identifier: BSD-3-Clause
"""Inputs without a field, and commands that name none: the mesh is cut, located, counted; of fields
the first is taken and named."""

import unittest

import numpy as np

from tool import (
    CUBE,
    DATA,
    MIDDLE,
    ToolTest,
    columns,
    read_buffers,
    read_csv,
    read_image,
    run,
    strict_json,
    unit_cube_grid,
)

HALF = ("--plane", "0,0,0.5,0,0,1")


class NoFieldTest(ToolTest):
    def setUp(self):
        super().setUp()
        self.bare = self.write("bare.vtu", unit_cube_grid([]))
        self.cube = self.write("cube.vtu", unit_cube_grid())
        self.image, self.buffers = self.folder / "i.png", self.folder / "b.vti"
        self.size = ["--size", "40x30"]

    def write(self, name, text):
        path = self.folder / name
        path.write_text(text, encoding="utf-8")
        return path

    def render(self, source, *options):
        outputs = ["--output", self.image, "--buffers", self.buffers]
        summary = self.summary("render", source, *HALF, *self.size, *outputs, *options)
        return summary, read_buffers(self.buffers), read_image(self.image)


class NoField(NoFieldTest):
    def test_a_cut_is_of_one_colour(self):
        _, known, _ = self.render(self.cube, "--field", "u")
        for options, color in [([], [153, 179, 204]), (["--color", "1,0.5,0"], [255, 128, 0])]:
            summary, buffers, image = self.render(self.bare, *options)
            self.assertIsNone(summary["field"])
            self.assertIsNone(summary["component"])
            self.assertIsNone(summary["value_range"])
            self.assertIsNone(summary["color_range"])
            self.assertNotIn("Value", buffers)
            for name in ["Verdict", "Element", "Xi", "Position", "Depth"]:
                np.testing.assert_array_equal(buffers[name], known[name])
            exact = buffers["Verdict"] == 1
            self.assertGreater(exact.sum(), 100)
            self.assertTrue((image[exact] == color).all())
            self.assertTrue((image[~exact] == 255).all())

    def test_pictures_of_soundness(self):
        for options in [["--owners"], ["--show", "validity"]]:
            told, known, picture = self.render(self.cube, "--field", "u", *options)
            summary, buffers, image = self.render(self.bare, *options)
            np.testing.assert_array_equal(image, picture)
            self.assertEqual(set(known) - set(buffers), {"Value"})
            for name in ["coverage", "validity"]:
                self.assertEqual(summary.get(name), told.get(name))

    def test_several_surfaces(self):
        options = ["--sphere", "0.5,0.5,0.5,0.3", "--layer", "2:opacity=0.5,color=1:0:0"]
        _, buffers, _ = self.render(self.bare, *options, "--samples", "4", "--outlines")
        self.assertEqual(set(np.unique(buffers["Layer"])), {0, 1, 255})

    def test_solvers_meshes(self):
        mesh = DATA / "mfem_escher_tet_darcy_p3" / "mfem_escher_tet_darcy_p3.mesh"
        done = self.succeeds("render", mesh, *MIDDLE, *self.size, "--output", self.image)
        self.assertIn("none", done.stdout)
        self.assertEqual(done.stderr, "")

    def test_what_needs_a_field_is_refused(self):
        base = [self.bare, *HALF, *self.size, "--output", self.image]
        for option in [
            ["--field", "u"],
            ["--component", "0"],
            ["--range", "0,1"],
            ["--colormap", "jet"],
            ["--log"],
            ["--nan-color", "1,0,0"],
            ["--precision", "float"],
            ["--enclosures"],
            ["--show-undecided"],
            ["--show", "jumps"],
        ]:
            self.fails(1, "render", *base, *option, names=["no field"])
        self.fails(1, "render", *base, "--layer", "1:range=0:1", names=["--layer", "no field"])
        arrays = ["--buffers", self.buffers, "--arrays", "Value"]
        self.fails(1, "render", *base, *arrays, names=["Value", "no field"])
        self.fails(1, "bench", self.bare, *HALF, names=["no field"])

    def test_points_are_located(self):
        points = self.write("p.csv", "x,y,z\n0.25,0.5,0.75\n2,0,0\n")
        out = self.folder / "o.csv"
        base = ["probe", self.bare, "--points", points, "--output", out]
        summary = self.summary(*base, "--owners")
        self.assertIsNone(summary["field"])
        self.assertEqual((summary["inside"], summary["outside"]), (1, 1))
        found = columns(read_csv(out))
        self.assertNotIn("value", found)
        self.assertEqual(list(found["verdict"]), ["inside", "outside"])
        xi = [found[f"xi_{d}"][0] for d in range(3)]
        np.testing.assert_allclose(xi, [-0.5, 0.0, 0.5], atol=1e-15)
        self.assertEqual(list(found["owners"]), [1, 0])
        for option in ["--gradient", "--enclosures"]:
            self.fails(1, *base, option, names=[option, "no field"])
        self.fails(1, *base, "--field", "u", names=["'u'", "no fields"])


class FirstField(NoFieldTest):
    def test_is_taken_and_named(self):
        points = self.write("p.csv", "x,y,z\n0.25,0.5,0.75\n")
        fields = [("v", [3 * p[1] for p in CUBE]), ("u", [p[0] for p in CUBE])]
        several = self.write("several.vtu", unit_cube_grid(fields))
        picture = ["--output", self.image, *HALF, *self.size]
        table = ["--points", points, "--output", self.folder / "o.csv"]
        for source, field, names in [(self.cube, "u", ["'u'"]), (several, "v", ["'v'", "'u'"])]:
            for words in [["render", source, *picture], ["probe", source, *table],
                          ["bench", source, *HALF, *self.size]]:
                done = run(*words, "--json")
                self.assertEqual(done.returncode, 0, done.stderr)
                self.assertEqual(strict_json(done.stdout)["field"], field)
                for name in names:
                    self.assertIn(name, done.stderr)
                self.assertEqual("--field" in done.stderr, len(names) > 1)
        self.succeeds("probe", several, *table)
        self.assertEqual(float(read_csv(self.folder / "o.csv")[0]["value"]), 1.5)

    def test_nothing_is_said_where_it_is_named(self):
        done = self.succeeds("render", self.cube, "--field", "u", *HALF, *self.size,
                             "--output", self.image)
        self.assertEqual(done.stderr, "")


if __name__ == "__main__":
    unittest.main()
