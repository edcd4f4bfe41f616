# SPDX-License-Identifier: BSD-3-Clause
"""The command line: help, version, and wrong usage, which ends with status 2."""

import unittest

from tool import DATA, MIDDLE, ToolTest, case, run, strict_json, unit_cube_grid

COMMANDS = ["info", "probe", "render", "bench", "compare", "integrate", "view", "serve"]


class Help(ToolTest):
    def test_help_everywhere(self):
        self.assertIn("render", self.succeeds("--help").stdout)
        for command in COMMANDS:
            text = self.succeeds(command, "--help").stdout
            self.assertIn("--threads", text)
            self.assertIn("--json", text)

    def test_version_everywhere(self):
        for arguments in [["--version"]] + [[command, "--version"] for command in COMMANDS]:
            self.assertRegex(self.succeeds(*arguments).stdout, r"^pixelexact \d+\.\d+\.\d+")


class Words(ToolTest):
    """What CLI11 would pass over, or tell in its own words."""

    def setUp(self):
        super().setUp()
        self.cube = self.folder / "cube.vtu"
        self.cube.write_text(unit_cube_grid(), encoding="utf-8")

    def test_commands_that_are_none(self):
        for word in ["foo", "INFO", "inf", str(self.cube)]:
            self.fails(2, word, names=[f"'{word}'", *COMMANDS])
        self.fails(2, names=["name a command", *COMMANDS])
        self.fails(2, "--threads", "2", "info", self.cube, names=["--threads", "before the command"])

    def test_help_is_a_word_too(self):
        self.assertEqual(self.succeeds("help").stdout, self.succeeds("--help").stdout)
        for command in COMMANDS:
            told = self.succeeds("help", command).stdout
            self.assertEqual(told, self.succeeds(command, "--help").stdout)
            self.assertIn("--threads", told)
        self.fails(2, "help", "foo", names=["'foo'"])

    def test_options_that_are_none(self):
        for word in ["--foo", "--foo=3", "-x", "-file.vtu"]:
            name = word.split("=", maxsplit=1)[0]
            self.fails(2, "info", self.cube, word, names=["info has no option", f"'{name}'"])

    def test_numbers_with_blanks_between(self):
        plane = ["--plane", "-0.5", "-0.2", "0", "0", "0", "1"]
        self.fails(2, "render", self.cube, *plane, names=["'-0.2'", "commas"])

    def test_flags_take_no_value(self):
        for words in [["info", self.cube, "--certify=0"], ["info", self.cube, "--json=1"]]:
            self.fails(2, *words, names=[words[-1], "no value"])

    def test_a_value_that_may_be_left_out_is_joined(self):
        output = ["--output", self.folder / "i.png"]
        for words in [["--boundary", self.cube], [self.cube, "--boundary=all"]]:
            self.succeeds("render", *words, *output, "--size", "9x9")
        self.fails(2, "render", self.cube, *output, "--boundary=", names=["--boundary", "missing"])

    def test_an_option_twice(self):
        base = ["render", self.cube, "--field", "u", *MIDDLE]
        image = self.folder / "i.png"
        for twice in [["--size", "9x9", "--size=8x8"], ["-o", image, "--output", image]]:
            self.fails(2, *base, *twice, names=["more than once", twice[2].split("=")[0]])

    def test_a_value_that_is_missing(self):
        base = ["render", self.cube, "--field", "u", *MIDDLE]
        for option in ["-o", "--output", "--size"]:
            for next_one in [[], ["--log"]]:
                name = "--output" if option == "-o" else option
                self.fails(2, *base, option, *next_one, names=[name, "missing"])

    def test_values_name_what_is_expected(self):
        render = ["render", self.cube, "--field", "u", *MIDDLE, "--output", self.folder / "i.png"]
        for option, value, expected in [
            ("--threads", "two", "whole number from 1"),
            ("--samples", "0", "from 1 to 1024"),
            ("--precision", "half", "double, float"),
            ("--view-angle", "nan", "a finite number"),
            ("--time", "soon", "a finite number"),
            ("--time-step", "every", "number of a step"),
            ("--time-step", "-1", "number of a step"),
        ]:
            done = self.fails(2, *render, option, value, names=[option, f"'{value}'", expected])
            self.assertLess(len(done.stderr), 250)

    def test_short_output(self):
        base = ["render", self.cube, "--field", "u", *MIDDLE, "--size", "9x9"]
        for words in [["-o", "-a.png"], ["-ob.png"], ["-o=c.png"]]:
            done = run(*base, *words, folder=self.folder)
            self.assertEqual(done.returncode, 0, done.stderr)
        for name in ["-a.png", "b.png", "c.png"]:
            self.assertTrue((self.folder / name).exists(), name)

    def test_files_that_do_not_go_together(self):
        table, other = self.folder / "points.csv", self.folder / "sphere.vtu"
        table.write_text("x,y,z\n0,0,0\n", encoding="utf-8")
        other.write_text(unit_cube_grid(), encoding="utf-8")
        mesh = DATA / "mfem_escher_tet_darcy_p3" / "mfem_escher_tet_darcy_p3.mesh"
        for files in [(self.cube, table), (self.cube, other, table), (mesh, table)]:
            self.fails(2, "info", *files, names=[f"'{table}'", "--points"])
        self.fails(2, "info", self.cube, other, names=[f"and '{other}' is no other time step"])
        self.fails(2, "info", self.cube, mesh, names=["VTK XML", "MFEM", mesh])
        self.fails(2, "info", mesh, mesh, names=["two meshes"])
        flux = mesh.with_name("flux.gf")
        for files in [(self.cube, self.cube), (mesh, flux, flux)]:
            self.fails(2, "info", *files, names=[f"'{files[-1]}'", "more than once"])

    def test_the_error_is_told_in_json_too(self):
        for words in [["info", "--json"], ["--json"], ["paint", "--json"], ["render", "--json"]]:
            done = run(*words)
            self.assertEqual(done.returncode, 2)
            self.assertIn(strict_json(done.stdout)["error"], done.stderr)


class FullDisk(ToolTest):
    """What is printed and lost is no success."""

    def test_standard_output(self):
        source = case("escher_tet_g3_p3")
        made = ["bench", "--elements", 6, "--repeat", 1, "--size", "9x9"]
        with open("/dev/full", "w", encoding="utf-8") as full:
            for words in [
                ["--help"],
                ["--version"],
                ["help", "render"],
                ["info", source],
                ["info", source, "--json"],
                ["bench", source, "--field", "u", *MIDDLE, "--size", "9x9"],
                made,
                [*made, "--json"],
            ]:
                done = run(*words, stdout=full)
                self.assertEqual(done.returncode, 1, f"{words}: {done.stderr}")
                self.assertIn("standard output: No space left on device", done.stderr)


class WrongUsage(ToolTest):
    def setUp(self):
        super().setUp()
        self.cube = self.folder / "cube.vtu"
        self.cube.write_text(unit_cube_grid(), encoding="utf-8")
        self.image = self.folder / "image.png"

    def render(self, *options):
        return ["render", self.cube, "--field", "u", "--output", self.image, *options]

    def test_commands(self):
        self.fails(2)
        self.fails(2, "paint")
        self.fails(2, "--paint")
        self.fails(2, "info")
        self.fails(2, "info", self.cube, "--paint")
        self.fails(1, "probe", self.cube, "--field", "u", "--points", "p.csv")
        self.fails(2, "probe", self.cube, "--field", "u")
        self.fails(2, "probe", self.cube, "--output", "o.csv")

    def test_threads(self):
        for number in ["0", "-1", "two", "1.5", ""]:
            self.fails(2, "info", self.cube, "--threads", number)

    def test_numbers_are_read_whole(self):
        # 010 is ten, not the eight of C.
        self.succeeds("info", self.cube, "--threads", "010")
        for number in ["0x2", "2x", "1e1", "+-2", "2 3", "99999999999"]:
            self.fails(2, "info", self.cube, "--threads", number, names=["--threads", number])
            self.fails(2, "info", self.cube, "--time-step", number, names=["--time-step"])
        for number in ["0x1p3", "1x", "1,5", "nan", "inf", "1e999", "1 2", ""]:
            self.fails(2, "info", self.cube, "--time", number, names=["--time"])
            self.fails(2, *self.render(*MIDDLE, "--view-angle", number), names=["--view-angle"])

    def test_sizes(self):
        for size in ["0x5", "5x0", "5", "x", "5x", "-5x5", "5x5x5", "5.0x5", "5 x 5", "", "5X5"]:
            self.fails(2, *self.render(*MIDDLE, "--size", size), names=["--size"])
        self.fails(2, *self.render(*MIDDLE, "--size", "99999999999x2"))
        self.fails(2, *self.render(*MIDDLE, "--size", "2000000x2000000"))

    def test_planes(self):
        for plane in ["", "0,0,0,0,0", "0,0,0,0,0,1,2", "0,0,0,0,0,a", "0,0,0,0,0,1,"]:
            self.fails(2, *self.render("--plane", plane), names=["--plane"])
        for plane in ["nan,0,0,0,0,1", "0,0,0,inf,0,1", "0,0,0,0,0,1e999", "0,0,0,0x1,0,1"]:
            self.fails(2, *self.render("--plane", plane), names=["--plane"])
        for plane in ["0,0,0,0,0,0", "1,2,3,-0,0,-0.0"]:
            self.fails(2, *self.render("--plane", plane), names=["--plane"])
        self.fails(2, *self.render("--plane"))

    def test_cameras(self):
        plane = ["--plane", "0.5,0,0,1,0,0"]
        for wrong in [
            ["--camera-position", "1,2"],
            ["--camera-position", "5,0,0"],
            ["--focal-point", "5,0,0"],
            ["--camera-position", "5,0,0", "--focal-point", "5,0,0"],
            ["--camera-position", "5,0,0", "--focal-point", "0,0,0", "--view-up", "2,0,0"],
            ["--view-angle", "0"],
            ["--view-angle", "180"],
            ["--view-angle", "nan"],
            ["--parallel-scale", "0"],
            ["--parallel-scale", "-1"],
            ["--view-angle", "30", "--parallel-scale", "1"],
            ["--view-up", "-2,0,0"],
            ["--view-up", "0,0,0"],
        ]:
            self.fails(2, *self.render(*plane, *wrong))

    def test_a_view_up_that_is_nearly_the_normal_is_kept(self):
        plane = ["--plane", "0.5,0,0,1,0,0", "--size", "9x9"]
        camera = self.summary(*self.render(*plane, "--view-up", "1,0.01,0"))["camera"]
        up = camera["view_up"]
        self.assertAlmostEqual(up[1] / up[0], 0.01, delta=1e-12)

    def test_colours(self):
        plane = ["--plane", "0.5,0,0,1,0,0"]
        for wrong in [
            ["--range", "1"],
            ["--range", "1,0"],
            ["--range", "1,1"],
            ["--range", "nan,1"],
            ["--colormap", "no such map"],
            ["--component", "w"],
            ["--component", "-1"],
            ["--background", "1,2"],
            ["--background", "2,0,0"],
            ["--nan-color", "0,0,-1"],
            ["--log", "--range", "0,1"],
            ["--log", "--range", "-1,1"],
        ]:
            self.fails(2, *self.render(*plane, *wrong))

    def test_outputs_of_another_kind(self):
        base = ["render", self.cube, "--field", "u", *MIDDLE]
        self.fails(2, *base, "--output", self.folder / "image.gif", names=["--output", ".png"])
        image = ["--output", self.image]
        self.fails(2, *base, *image, "--buffers", self.image, names=["--buffers", ".vti"])

    def test_an_input_too_many(self):
        self.fails(2, "info", self.cube, self.cube, names=["cube.vtu"])


class OptionValues(ToolTest):
    def test_values_that_begin_with_a_minus_sign(self):
        source = case("toroid_hex_g3_p6")
        pictures = []
        for plane in [["--plane", "-0.5,0,0,-1,0,0"], ["--plane=-0.5,0,0,-1,0,0"]]:
            for bounds in [["--range", "-.5,1"], ["--range=-.5,1"]]:
                image = self.folder / f"{len(pictures)}.png"
                options = [*plane, *bounds, "--size", "20x20", "--output", image]
                self.succeeds("render", source, "--field", "u", *options)
                pictures.append(image.read_bytes())
        self.assertEqual(len(set(pictures)), 1)

    def test_input_after_an_option(self):
        planes = ["--plane", "-0.5,0,0,1,0,0", *MIDDLE]
        options = ["--field", "u", "--size", "9x9", "--output", self.folder / "image.png"]
        summary = self.summary("render", *planes, case("escher_tet_g3_p3"), *options)
        self.assertEqual(summary["elements"], 42)

    def test_names_that_begin_with_a_minus_sign(self):
        cube, points = self.folder / "cube.vtu", self.folder / "-points.csv"
        cube.write_text(unit_cube_grid(), encoding="utf-8")
        points.write_text("x,y,z\n.5,.5,.5\n", encoding="utf-8")
        table = ["--points", points.name, "--output", "-out.csv"]
        done = run("probe", cube, "--field", "u", *table, folder=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertTrue((self.folder / "-out.csv").exists())


class NotYet(ToolTest):
    """What the interface names and this version lacks says so, by the option's name."""

    def test_modes(self):
        source, image = case("escher_tet_g3_p3"), self.folder / "i.png"
        base = ["render", source, "--field", "u", "--output", image]
        plane = list(MIDDLE)
        self.fails(2, *base, *plane, "--precision", "half", names=["--precision"])
        for precision in ["double", "float"]:
            self.succeeds(*base, *plane, "--precision", precision, "--size", "9x9")

    def test_the_error_is_told_in_json_too(self):
        image = self.folder / "i.png"
        base = ["render", case("escher_tet_g3_p3"), "--field", "u", "--output", image, "--json"]
        done = run(*base, "--isosurface", "u=99")
        self.assertEqual(done.returncode, 1)
        self.assertIn("--isosurface", strict_json(done.stdout)["error"])


if __name__ == "__main__":
    unittest.main()
