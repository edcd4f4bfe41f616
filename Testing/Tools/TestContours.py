# SPDX-License-Identifier: BSD-3-Clause
"""Contour lines: --contours."""

import unittest

import numpy as np

from tool import (
    CUBE,
    DATA,
    ToolTest,
    View,
    case,
    plain_grid,
    read_buffers,
    read_image,
    unit_cube_grid,
)

HALF = ("--plane", "0,0,0.5,0,0,1")
WHITE = ("--layer", "1:color=1:1:1")
# A unit square of 100 x 100 pixels in an image of 120 x 120.
VIEW = View([0.5, 0.5, 3.0], [0.5, 0.5, 0.0], [0.0, 1.0, 0.0], 120, 120, scale=0.6).options()


class Contours(ToolTest):
    def setUp(self):
        super().setUp()
        self.cube = self.folder / "cube.vtu"
        # u = x.
        self.cube.write_text(unit_cube_grid(), encoding="utf-8")

    def words(self, *options, source=None):
        outputs = ["--output", self.folder / "i.png", "--buffers", self.folder / "b.vti"]
        return ["render", source or self.cube, *options, *outputs]

    def picture(self, *options, look=WHITE, view=VIEW, source=None):
        summary = self.summary(*self.words("--field", "u", *HALF, *look, *view, *options,
                                           source=source))
        return summary, read_buffers(self.folder / "b.vti"), read_image(self.folder / "i.png")

    def columns(self, image):
        """The part that lines cover, by column, away from the ends of the square."""
        return (1 - image[15:105, :, 0] / 255).mean(axis=0)

    def test_lines_are_where_the_field_has_the_values(self):
        for width in [0.5, 1.5, 3.0]:
            _, _, image = self.picture("--contours", "0.233,0.5,0.71", "--contour-width", str(width))
            cover = self.columns(image)
            column = np.arange(120)
            wanted = np.zeros(120)
            for value in [0.233, 0.5, 0.71]:
                middle = 10 + 100 * value
                ends = np.minimum(column + 1, middle + width / 2), np.maximum(column, middle - width / 2)
                wanted += np.maximum(0, ends[0] - ends[1])
            # A line that is off by a twentieth of a pixel covers as much more on one side.
            np.testing.assert_allclose(cover, wanted, atol=0.02)
            self.assertAlmostEqual(cover.sum(), 3 * width, delta=0.01 * 3 * width)

    def test_a_face_with_the_value_is_in_however_far_from_the_origin(self):
        """As of a wall on which the solution is prescribed, cut along it: values there are zero up
        to the rounding of coordinates."""
        for offset in [0.0, 5.0, 40.0, 1e4]:
            with self.subTest(offset):
                points = [[x, y, z + offset] for x, y, z in CUBE]
                grid = plain_grid(points, [(12, list(range(8)))], [("u", [z for _, _, z in CUBE])])
                self.cube.write_text(grid, encoding="utf-8")
                plane = ("--plane", f"0,0,{offset},0,0,1")
                wall = ["--field", "u", *plane, "--size", "40x40", "--contours"]
                shown = self.summary(*self.words(*wall, "0.0"))
                self.assertGreater(shown["pixels"]["exact"], 1000)
                self.assertEqual(shown["contours"]["pixels"]["in"], shown["pixels"]["exact"])
                beside = self.summary(*self.words(*wall, "1e-6,1e-3"))
                self.assertEqual(beside["contours"]["pixels"]["out"], 40 * 40)

    def test_a_count_has_no_lines_where_one_value_is_seen(self):
        """Values between the roundings of one value are none that anybody means."""
        own = ["--field", "u", "--isosurface", "u=0.4", "--size", "40x40", "--contours"]
        words = self.words(*own, "7")
        summary = self.summary(*words)
        self.assertEqual(summary["contours"]["values"], [])
        self.assertEqual(summary["contours"]["pixels"]["out"], 40 * 40)
        self.assertIn("one value", self.succeeds(*words).stderr)
        itself = self.summary(*self.words(*own, "0.4"))
        self.assertGreaterEqual(
            itself["contours"]["pixels"]["in"], itself["pixels"]["exact"])
        # All of it is the line, and not what rounding makes of one.
        image = read_image(self.folder / "i.png")
        exact = read_buffers(self.folder / "b.vti")["Verdict"] == 1
        self.assertGreater((image[exact][:, :3] == 0).all(axis=1).mean(), 0.9)

    def test_a_count_is_of_round_values_inside_the_range(self):
        for count, limits, wanted in [(6, "0.125,0.75", [0.2, 0.3, 0.4, 0.5, 0.6, 0.7]),
                (9, "0,1", [0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9]), (3, "0,1", [0.25, 0.5, 0.75]),
                (1, "0,1", [0.5]), (4, "-1,1", [-0.75, -0.25, 0.25, 0.75])]:
            for text in (str(count), f"round{count}"):
                summary, buffers, _ = self.picture("--contours", text, f"--range={limits}", look=())
                self.assertEqual(summary["contours"]["values"], wanted)
                # Some of these lines are where pixels meet.
                pixels = summary["contours"]["pixels"]
                self.assertGreater(pixels["in"] + pixels["undecided"], 50)
        # Over the values that the picture shows, and by powers of ten.
        summary, _, _ = self.picture("--contours", "3", look=())
        low, high = summary["color_range"]
        values = summary["contours"]["values"]
        self.assertTrue(len(values) == 3 and low < values[0] and values[-1] < high, values)
        summary, _, _ = self.picture("--contours", "1", "--log", "--range", "0.01,1", look=())
        self.assertEqual(summary["contours"]["values"], [0.1])
        summary, _, _ = self.picture("--plane", "0.5,0,0,1,0,0", "--contours", "0.5", "--range", "0.125,0.75",
            "--layer", "2:contours=6", look=())
        self.assertEqual(summary["contours"]["values"], [[0.5], [0.2, 0.3, 0.4, 0.5, 0.6, 0.7]])

    def test_what_is_no_count(self):
        for word in ["round", "round0", "round-1", "round2.5", "roundx"]:
            self.fails(2, *self.words("--contours", word), names=["--contours", "round"])

    def test_what_is_a_count_and_what_a_value(self):
        for text, values in [("1.0", [1.0]), ("0", [0.0]), ("-3", [-3.0]), ("2.", [2.0]),
                             ("1e-1", [0.1]), ("0.5,0.25", [0.25, 0.5]),
                             ("1,", [1.0]), ("0.5,", [0.5]), ("3,1", [1.0, 3.0])]:
            summary, _, _ = self.picture("--contours", text)
            self.assertEqual(summary["contours"]["values"], values)

    def test_buffer_and_counts(self):
        summary, buffers, _ = self.picture("--contours", "0.5025,0.25")
        contour = buffers["Contour"]
        self.assertEqual(contour.dtype, np.uint8)
        pixels = summary["contours"]["pixels"]
        self.assertEqual(sorted(pixels), ["in", "jumps", "out", "undecided"])
        self.assertEqual((contour == 1).sum(), pixels["in"])
        self.assertEqual((contour == 2).sum(), pixels["undecided"])
        # x = 0.5025 is a quarter of a pixel within one.
        self.assertTrue((contour[15:105, 60] == 1).all())
        self.assertFalse((contour[15:105, 62:100] == 1).any())
        self.succeeds(*self.words(*HALF, *VIEW, "--contours", "3", "--arrays", "Contour"))
        self.assertEqual(list(read_buffers(self.folder / "b.vti")), ["Contour"])
        _, buffers, _ = self.picture()
        self.assertNotIn("Contour", buffers)
        self.fails(2, *self.words(*HALF, "--arrays", "Contour"), names=["Contour", "--contours"])

    def test_loops_inside_of_pixels(self):
        plain, _, _ = self.picture("--contours", "0.5025,0.25")
        summary, buffers, _ = self.picture("--contours", "0.5025,0.25", "--interior")
        pixels = summary["contours"]["pixels"]
        self.assertEqual(sorted(pixels), ["in", "jumps", "loops", "out", "undecided"])
        self.assertEqual(pixels["loops"], 0)
        self.assertEqual(pixels["in"], plain["contours"]["pixels"]["in"])
        self.assertEqual((buffers["Contour"] == 1).sum(), pixels["in"])
        self.fails(2, *self.words(*HALF, "--contours", "3", "--interior", "--certifier",
                                  "interval"), names=["--interior", "--certifier"])
        self.fails(2, *self.words(*HALF, "--interior"), names=["--interior", "--contours"])

    def test_effort(self):
        usual, _, _ = self.picture("--contours", "7")
        more, _, _ = self.picture("--contours", "7", "--contour-effort", "8")
        little, _, _ = self.picture("--contours", "7", "--contour-effort", "0.001")
        undecided = [told["contours"]["pixels"]["undecided"] for told in (little, usual, more)]
        self.assertEqual(undecided, sorted(undecided, reverse=True))
        self.assertNotIn("spent_tiles", usual["contours"])
        for factor in ("0", "-1", "2000", "nan"):
            self.fails(2, *self.words(*HALF, "--contours", "3", "--contour-effort", factor),
                       names=["--contour-effort"])
        self.fails(2, *self.words(*HALF, "--contours", "3", "--contour-effort", "2", "--certifier",
                                  "interval"), names=["--contour-effort", "--certifier"])
        self.fails(2, *self.words(*HALF, "--contour-effort", "2"), names=["--contour-effort"])

    def test_values_that_are_not_seen(self):
        summary, buffers, image = self.picture("--contours", "-1,0.5,2")
        self.assertEqual(summary["contours"]["outside"], 2)
        result = self.succeeds(*self.words(*HALF, *VIEW, *WHITE, "--contours", "-1.5,2"))
        self.assertIn("there are no lines", result.stderr)
        self.assertIn("2 values, 2 of them not among those that are seen", result.stdout)
        self.assertTrue((read_image(self.folder / "i.png") == 255).all())

    def test_a_line_between_the_values_at_centres_is_not_denied(self):
        # One pixel from x = 0.1 to 0.9.
        pixel = View([0.5, 0.5, 3.0], [0.5, 0.5, 0.0], [0.0, 1.0, 0.0], 1, 1, scale=0.4).options()
        result = self.succeeds(*self.words(*HALF, *pixel, *WHITE, "--contours", "0.75"))
        self.assertIn("1 pixel in", result.stdout)
        self.assertLess(read_image(self.folder / "i.png").min(), 255)
        self.assertNotIn("no lines", result.stderr)

    def test_colours(self):
        red, green = [255, 0, 0], [0, 255, 0]
        base = ["--contours", "0.755,0.255", "--contour-width", "3"]
        _, _, image = self.picture(*base, "--contour-color", "1,0,0")
        self.assertEqual([image[60, c].tolist() for c in (35, 85)], [red, red])
        _, _, image = self.picture(*base, "--contour-color", "1:0:0,0:1:0")
        self.assertEqual([image[60, c].tolist() for c in (35, 85)], [green, red])
        # By the map: the colours that the surface has there.
        _, _, plain = self.picture("--range", "0,1", look=())
        _, _, image = self.picture(*base, "--contour-color", "map", "--range", "0,1", look=())
        for column in (35, 85):
            off = np.abs(image[60, column].astype(int) - plain[60, column].astype(int)).max()
            self.assertLessEqual(off, 2)

    def test_lines_alone(self):
        base = ["--contours", "0.5,0.75", "--contour-width", "3"]
        _, buffers, image = self.picture(*base, "--contours-only", "--background", "0,0,1",
                                         "--contour-color", "1,1,0", look=())
        self.assertEqual(image[60, 40].tolist(), [0, 0, 255])
        self.assertEqual(image[60, 60].tolist(), [255, 255, 0])
        self.assertEqual(image[2, 2].tolist(), [0, 0, 255])
        for option in [["--colormap", "jet"], ["--color", "1,0,0"], ["--lights", "on"],
                       ["--nan-color", "1,0,0"], ["--layer", "1:opacity=0.5"], ["--range", "0,1"],
                       ["--log"], ["--layer", "1:range=0:1"], ["--samples", "4"]]:
            self.fails(2, *self.words(*HALF, *base, "--contours-only", *option),
                       names=[option[0], "no effect", "--contours-only"])
        self.succeeds(*self.words(*HALF, *VIEW, *base, "--contours-only", "--contour-color", "map",
                                  "--colormap", "jet", "--range", "0,1"))
        # By a range, values are spaced.
        self.succeeds(*self.words(*HALF, *VIEW, "--contours", "3", "--contours-only", "--range",
                                  "0.1,1", "--log"))
        two = ["--plane", "0.5,0,0,1,0,0", "--contours", "3", "--contours-only", "--range", "0,1"]
        self.succeeds(*self.words(*HALF, *VIEW, *two, "--layer", "1:contours=0.5"))
        self.fails(2, *self.words(*HALF, *two, "--layer", "1:contours=0.5,range=0:2"),
                   names=["--layer", "no effect", "--contours-only"])

    def test_layers_with_contours_of_their_own(self):
        two = ["--plane", "0.5,0,0,1,0,0"]
        summary, _, _ = self.picture("--contours", "0.5,0.75", *two, "--layer", "2:contours=off",
                                     look=())
        self.assertEqual(summary["contours"]["values"], [[0.5, 0.75], []])
        summary, _, _ = self.picture("--contours", "0.5,0.75", *two,
                                     "--layer", "2:contours=0.1:0.3", look=())
        self.assertEqual(summary["contours"]["values"], [[0.5, 0.75], [0.1, 0.3]])
        self.fails(2, *self.words(*HALF, "--layer", "1:contours=3"), names=["--contours"])
        self.fails(2, *self.words(*HALF, "--contours", "3", "--layer", "1:contours=4"),
                   names=["--contours", "no effect"])

    def test_mistakes_are_refused_by_name(self):
        for text in ["", "a", "nan", "1,inf", "1,,2", "1;2", "0.1,x", ",", "1,2,", "1,,", ",1"]:
            self.fails(2, *self.words(*HALF, "--contours", text), names=["--contours"])
        self.fails(2, *self.words(*HALF, "--contours", "10001"), names=["--contours", "10000"])
        self.fails(2, *self.words(*HALF, "--contours", "99999999999"), names=["10000"])
        self.fails(2, *self.words(*HALF, "--contours", "1.5,1.5"), names=["1.5", "twice"])
        given = ["--contours", "3"]
        for width in ["0", "33", "-1", "nan", "x"]:
            self.fails(2, *self.words(*HALF, *given, "--contour-width", width),
                       names=["--contour-width", "0.1", "32"])
        for color in ["1,0", "2,0,0", "red", "1:0:0,1:0", "nan,0,0"]:
            self.fails(2, *self.words(*HALF, *given, "--contour-color", color),
                       names=["--contour-color"])
        self.fails(2, *self.words(*HALF, *given, "--contour-color", "1:0:0,0:1:0"),
                   names=["--contour-color", "2", "3"])
        for option in [["--contour-width", "2"], ["--contour-color", "1,0,0"], ["--contours-only"],
                       ["--show-undecided-contours"]]:
            self.fails(2, *self.words(*HALF, *option), names=[option[0], "--contours"])
        self.fails(2, *self.words(*HALF, *given, "--undecided-contour-color", "1,0,0"),
                   names=["--show-undecided-contours"])
        for picture in [["--owners"], ["--show", "validity"]]:
            self.fails(2, *self.words(*HALF, *given, *picture), names=["--contours", picture[0]])

    def test_labels(self):
        source = case("toroid_hex_g3_p6")
        base = ["--plane", "0,0,0,0,0,1", "--size", "500x500", "--contours", "9",
                "--layer", "1:color=1:1:1"]
        plain = self.summary(*self.words(*base, source=source))
        self.assertNotIn("labels", plain["contours"])
        image, buffers = read_image(self.folder / "i.png"), read_buffers(self.folder / "b.vti")
        labelled = self.summary(*self.words(*base, "--contour-labels", source=source))
        self.assertGreater(labelled["contours"]["labels"], 4)
        del labelled["contours"]["labels"]
        self.assertEqual(labelled["contours"], plain["contours"])
        written = read_image(self.folder / "i.png")
        # Some of the lines is away, some letters are there, and nothing else is changed.
        self.assertGreater((written > image.astype(int) + 100).sum(), 100)
        self.assertGreater((written < image.astype(int) - 100).sum(), 100)
        self.assertLess((written != image).any(axis=-1).mean(), 0.1)
        found = read_buffers(self.folder / "b.vti")
        for name in ("Value", "Verdict", "Contour"):
            np.testing.assert_array_equal(found[name], buffers[name])
        self.succeeds(*self.words(*base, "--contour-labels=20", source=source))
        for size in ["5", "73", "12.5", "x"]:
            self.fails(2, *self.words(*base, f"--contour-labels={size}", source=source),
                       names=["--contour-labels"])
        self.fails(2, *self.words(*HALF, "--contour-labels"), names=["--contours"])

    def test_fields_of_h_div_are_proven_and_labelled(self):
        folder = DATA / "mfem_escher_tet_darcy_p3"
        base = ["render", folder / "mfem_escher_tet_darcy_p3.mesh", folder / "flux.gf",
                "--plane=0.013,0.017,0.011,0.1,0.2,1", "--size", "300x300", "--contours", "7",
                "--contour-labels=8", "--output", self.folder / "flux.png"]
        summary = self.summary(*base)
        self.assertGreater(summary["contours"]["pixels"]["in"], 500)
        self.assertLess(summary["contours"]["pixels"]["undecided"], 200)
        self.assertGreater(summary["contours"]["labels"], 2)

    def test_without_a_field(self):
        source = self.folder / "bare.vtu"
        source.write_text(unit_cube_grid([]), encoding="utf-8")
        self.fails(1, *self.words(*HALF, "--contours", "3", source=source),
                   names=["--contours", "no field"])

    def test_threads_change_nothing(self):
        source = case("toroid_hex_g3_p6")
        torus = ["--torus", "0,0,0,0,0,1,1,0.3", "--size", "150x130", "--contours", "9"]
        images = []
        for threads in ["1", "4"]:
            self.succeeds(*self.words(*torus, "--threads", threads, source=source))
            images.append(read_image(self.folder / "i.png"))
        np.testing.assert_array_equal(*images)


if __name__ == "__main__":
    unittest.main()
