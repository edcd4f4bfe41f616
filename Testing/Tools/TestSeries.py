# SPDX-License-Identifier: BSD-3-Clause
"""Time series and grids in pieces: which step is read, and what does not go together."""

import unittest

from tool import CUBE, MIDDLE, ToolTest, plain_grid, read_csv, run


def slab(x, factor):
    """The unit cube moved by x, with the field u = factor * (its x)."""
    points = [[corner[0] + x, corner[1], corner[2]] for corner in CUBE]
    return plain_grid(points, [(12, list(range(8)))], [("u", [factor * p[0] for p in points])])


class SeriesTest(ToolTest):
    def write(self, name, text):
        path = self.folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
        return path

    def collection(self, entries, name="series.pvd"):
        sets = "".join(f'<DataSet timestep="{t}" part="0" file="{file}"/>\n' for t, file in entries)
        text = '<VTKFile type="Collection"><Collection>\n' + sets + "</Collection></VTKFile>\n"
        return self.write(name, text)

    def pieces(self, name, sources):
        text = '<VTKFile type="PUnstructuredGrid"><PUnstructuredGrid GhostLevel="0">\n'
        text += "".join(f'<Piece Source="{source}"/>\n' for source in sources)
        return self.write(name, text + "</PUnstructuredGrid></VTKFile>\n")

    def value(self, *inputs, at="0.5,0.25,0.25"):
        """The value of u that the tool finds at a point."""
        points = self.write("points.csv", "x,y,z\n" + at + "\n")
        out = self.folder / "out.csv"
        self.succeeds("probe", *inputs, "--field", "u", "--points", points, "--output", out)
        return float(read_csv(out)[0]["value"])

    def three_steps(self):
        for step in range(3):
            self.write(f"u_{step}.vtu", slab(0.0, step + 1.0))
        return self.collection([(0.25 * step, f"u_{step}.vtu") for step in range(3)])


class Collections(SeriesTest):
    def test_steps_are_told(self):
        series = self.three_steps()
        summary = self.summary("info", series)
        self.assertEqual(summary["times"], [0, 0.25, 0.5])
        self.assertEqual((summary["time_step"], summary["time"]), (0, 0))
        text = self.succeeds("info", series, "--time-step", 2).stdout
        self.assertIn("0.5, step 2 of 3 from 0 to 0.5", text)
        self.assertNotIn("time_step", self.summary("info", self.folder / "u_0.vtu"))

    def test_steps_are_read(self):
        series = self.three_steps()
        self.assertAlmostEqual(self.value(series), 0.5, delta=1e-15)
        for step in range(3):
            expected = 0.5 * (step + 1)
            self.assertAlmostEqual(self.value(series, "--time-step", step), expected, delta=1e-14)
            self.assertAlmostEqual(self.value(series, "--time", 0.25 * step), expected, delta=1e-14)
        # The nearest one.
        self.assertAlmostEqual(self.value(series, "--time", 0.3), 1.0, delta=1e-14)
        self.assertAlmostEqual(self.value(series, "--time", 0.4), 1.5, delta=1e-14)

    def test_every_command(self):
        series = self.three_steps()
        render = ["render", series, "--field", "u", *MIDDLE, "--size", "9x9", "--time-step", 1]
        plane = ["--plane", "0.5,0.5,0.5,0,0,1"]
        image = self.folder / "out.png"
        summary = self.summary(*render[:4], *plane, *render[-4:], "--output", image)
        self.assertEqual((summary["time_step"], summary["time"]), (1, 0.25))
        bench = ["bench", series, "--field", "u", *plane, "--size", "9x9", "--repeat", 1]
        self.assertEqual(self.summary(*bench, "--time", 0.5)["time_step"], 2)

    def test_no_such_step(self):
        series = self.three_steps()
        self.fails(1, "info", series, "--time-step", 3, names=["--time-step", series, "3"])
        self.fails(1, "info", series, "--time", 0.6, names=["--time", "0 to 0.5"])
        self.fails(1, "info", series, "--time", -0.1, names=["--time", "0 to 0.5"])
        alone = self.folder / "u_0.vtu"
        self.fails(1, "info", alone, "--time", 0, names=[alone, "no time steps"])
        self.fails(1, "info", alone, "--time-step", 1, names=[alone, "no time steps"])
        self.succeeds("info", alone, "--time-step", 0)
        for option in [("--time-step", "-1"), ("--time-step", "x"), ("--time", "soon")]:
            self.fails(2, "info", series, *option)
        self.fails(2, "info", series, "--time", 0, "--time-step", 0)

    def test_damaged_collections(self):
        for text in ["no XML", "<VTKFile/>", '<VTKFile type="Collection"><Collection/></VTKFile>']:
            path = self.write("damaged.pvd", text)
            self.fails(1, "info", path, names=[path])
        path = self.collection([(0, "absent.vtu")])
        self.fails(1, "info", path, names=["absent.vtu", path, "no such file"])
        path = self.collection([("soon", "absent.vtu")])
        self.fails(1, "info", path, names=["soon", path])
        self.write("noise.vtu", "noise")
        path = self.collection([(0, "noise.vtu")])
        self.fails(1, "info", path, names=["noise.vtu", path])
        text = self.three_steps().read_text(encoding="utf-8")
        for length in range(0, len(text) - 1, 7):
            done = run("info", self.write("cut.pvd", text[:length]))
            self.assertEqual(done.returncode, 1, f"{length}: {done.stdout}")

    def test_alone(self):
        series = self.three_steps()
        self.fails(2, "info", series, self.folder / "u_0.vtu", names=[series])


class AllSteps(SeriesTest):
    """--time-step all gives what each step alone gives."""

    def rows(self, *arguments):
        out = self.folder / "out.csv"
        self.succeeds("probe", *arguments, "--output", out)
        return out.read_text(encoding="utf-8").splitlines()

    def test_probe(self):
        series = self.three_steps()
        points = self.write("points.csv", "x,y,z\n0.5,0.25,0.25\n0.1,0.9,0.3\n2,0,0\n")
        for options in (["--points", points], ["--line", "0,0.5,0.5,1,0.5,0.5,4", "--gradient", "--owners"]):
            header, *rows = self.rows(series, "--field", "u", *options, "--time-step", "all")
            alone = [self.rows(series, "--field", "u", *options, "--time-step", k) for k in range(3)]
            self.assertEqual(header, "step,time," + alone[0][0])
            wanted = [f"{k},{0.25 * k:g},{row}" for k in range(3) for row in alone[k][1:]]
            self.assertEqual(rows, wanted)

    def test_probe_reports_a_list(self):
        series = self.three_steps()
        options = ["--field", "u", "--line", "0,0.5,0.5,1,0.5,0.5,4", "--output", self.folder / "out.csv"]
        steps = self.summary("probe", series, *options, "--time-step", "all")["steps"]
        for k, step in enumerate(steps):
            alone = self.summary("probe", series, *options, "--time-step", k)
            del alone["seconds"]
            self.assertEqual(step, alone)
        self.assertEqual([step["time"] for step in steps], [0, 0.25, 0.5])

    def test_integrate(self):
        series = self.three_steps()
        options = ["--field", "u", "--plane", "x=0.5", "--boundary"]
        steps = self.summary("integrate", series, *options, "--time-step", "all")["steps"]
        self.assertEqual(len(steps), 3)
        for k, step in enumerate(steps):
            alone = self.summary("integrate", series, *options, "--time-step", k)
            del alone["seconds"]
            self.assertEqual(step, alone)
        text = self.succeeds("integrate", series, *options, "--time-step", "all").stdout
        lines = [line for line in text.splitlines() if line.startswith("step ")]
        self.assertEqual(len(lines), 6)
        self.assertRegex(lines[2], r"step 2 +time 0\.5: Area 1 \+-.*, Integral 1\.5 \+-.*, Mean 1\.5 \+-")

    def test_inputs_without_steps_are_refused(self):
        self.three_steps()
        alone = self.folder / "u_0.vtu"
        self.fails(1, "probe", alone, "--field", "u", "--line", "0,0,0,1,1,1,3", "--time-step", "all",
            names=["--time-step all", alone, "no time steps"])
        self.fails(1, "integrate", alone, "--plane", "x=0.5", "--time-step", "all",
            names=["--time-step all", alone, "no time steps"])
        self.fails(2, "info", self.folder / "series.pvd", "--time-step", "all", names=["--time-step"])

    def test_steps_with_other_components_are_refused(self):
        self.write("a.vtu", slab(0.0, 1.0))
        points = [list(corner) for corner in CUBE]
        self.write("b.vtu", plain_grid(points, [(12, list(range(8)))], [("u", points)]))
        series = self.collection([(0, "a.vtu"), (1, "b.vtu")])
        out = self.folder / "out.csv"
        self.fails(1, "probe", series, "--field", "u", "--line", "0,0,0,1,1,1,3", "--time-step", "all",
            "--output", out, names=["step 1", "components"])
        self.assertFalse(out.exists())


class Pieces(SeriesTest):
    def test_pieces_of_processes(self):
        """The layout of MFEM's ParaViewDataCollection."""
        entries = []
        for cycle in range(2):
            folder = f"Cycle00000{cycle}"
            for rank in range(3):
                self.write(f"{folder}/proc00000{rank}.vtu", slab(rank, cycle + 1.0))
            self.pieces(f"{folder}/data.pvtu", [f"proc00000{rank}.vtu" for rank in range(3)])
            entries.append((cycle, f"{folder}/data.pvtu"))
        series = self.collection(entries)
        self.assertEqual(self.summary("info", series)["elements"], 3)
        for x in [0.5, 1.5, 2.5]:
            for cycle in range(2):
                found = self.value(series, "--time-step", cycle, at=f"{x},0.5,0.5")
                self.assertAlmostEqual(found, (cycle + 1) * x, delta=1e-14)
        alone = self.folder / "Cycle000001/data.pvtu"
        self.assertAlmostEqual(self.value(alone, at="2.5,0.5,0.5"), 5.0, delta=1e-14)

    def test_what_is_left_out_is_told(self):
        self.write("a.vtu", slab(0.0, 1.0))
        self.write("wall.vtu", plain_grid([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [(5, [0, 1, 2])]))
        both = self.pieces("both.pvtu", ["a.vtu", "wall.vtu"])
        done = self.succeeds("info", both)
        self.assertIn("wall.vtu", done.stderr)
        self.assertEqual(len(self.summary("info", both)["diagnostics"]), 1)

    def test_damaged_pieces(self):
        path = self.pieces("absent.pvtu", ["absent.vtu"])
        self.fails(1, "info", path, names=["absent.vtu", path])
        path = self.pieces("own.pvtu", ["own.pvtu"])
        self.fails(1, "info", path, names=[path, "only .vtu"])
        self.write("a.vtu", slab(0.0, 1.0))
        self.write("b.vtu", slab(1.0, 1.0).replace("5 6 7", "5 6 77"))
        path = self.pieces("beyond.pvtu", ["a.vtu", "b.vtu"])
        self.fails(1, "info", path, names=["b.vtu", path, "point"])


class NumberedFiles(SeriesTest):
    def test_are_a_series_by_their_numbers(self):
        names = {1: "u1.vtu", 2: "u2.vtu", 10: "u10.vtu"}
        for number, name in names.items():
            self.write(name, slab(0.0, float(number)))
        # As a shell gives them: u1, u10, u2.
        files = [self.folder / name for name in sorted(names.values())]
        self.assertEqual(self.summary("info", *files)["times"], [0, 1, 2])
        for step, number in enumerate(names):
            found = self.value(*files, "--time-step", step)
            self.assertAlmostEqual(found, 0.5 * number, delta=1e-14)

    def test_leading_zeros(self):
        for number in [8, 9, 10, 11]:
            self.write(f"run2_u.{number:04}.vtu", slab(0.0, float(number)))
        files = sorted(self.folder.glob("*.vtu"), reverse=True)
        self.assertAlmostEqual(self.value(*files, "--time", 3), 5.5, delta=1e-14)

    def test_other_names_are_no_series(self):
        for name in ["u_1.vtu", "v_1.vtu", "u_1_2.vtu", "u_2.pvtu", "u_x.vtu"]:
            self.write(name, slab(0.0, 1.0))
        for other in ["v_1.vtu", "u_1_2.vtu", "u_2.pvtu", "u_x.vtu"]:
            first = self.folder / "u_1.vtu"
            self.fails(2, "info", first, self.folder / other, names=[first])


if __name__ == "__main__":
    unittest.main()
