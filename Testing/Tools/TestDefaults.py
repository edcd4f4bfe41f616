# SPDX-License-Identifier: BSD-3-Clause
"""What render chooses where it is told nothing, and what it says of that."""

import json
import shlex
import unittest

import numpy as np

from tool import ToolTest, plain_grid, read_buffers, read_image, run

# The corners of a box of sides 2, 1 and 4, about (5, 0, 0).
BOX = [[5 + x, y / 2, 2 * z] for z in (-1.0, 1.0)
       for x, y in ((-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0))]


class Defaults(ToolTest):
    def setUp(self):
        super().setUp()
        self.box = self.folder / "box.vtu"
        self.box.write_text(
            plain_grid(BOX, [(12, list(range(8)))], [("u", [p[2] for p in BOX])]), encoding="utf-8")

    def render(self, *arguments, status=0):
        size = [] if "--size" in arguments else ["--size", "40x40"]
        done = run("render", *size, *arguments, folder=self.folder)
        self.assertEqual(done.returncode, status, done.stderr)
        return done

    def buffers(self, *arguments):
        self.render(self.box, *arguments, "--buffers", "cut.vti")
        return read_buffers(self.folder / "cut.vti")

    def test_nothing_but_a_file(self):
        done = self.render(self.box)
        self.assertIn("field 'u'", done.stderr)
        self.assertIn("--plane 0,0,0,0,1,0", done.stderr)
        self.assertIn("box.png", done.stderr)
        pixels = read_image(self.folder / "box.png")
        # What it says repeats it.
        repeat = next(l for l in done.stdout.splitlines() if l.startswith("repeat"))
        words = shlex.split(repeat.removeprefix("repeat"))
        self.assertEqual(words[0], "pixelexact")
        self.assertLess({"--field", "u", "--plane=0,0,0,0,1,0", "--output", "box.png"}, set(words))
        (self.folder / "box.png").unlink()
        again = run(*words[1:], folder=self.folder)
        self.assertEqual(again.returncode, 0, again.stderr)
        self.assertEqual(again.stderr, "")
        self.assertNotIn("repeat", again.stdout)
        np.testing.assert_array_equal(read_image(self.folder / "box.png"), pixels)

    def test_command_in_the_summary(self):
        done = self.render(self.box, "--json")
        words = json.loads(done.stdout)["command"]
        self.assertEqual(words[:3], ["pixelexact", "render", "--size"])
        self.assertEqual(words[-2:], ["--output", "box.png"])
        done = self.render("--json", "--", self.box)
        words = json.loads(done.stdout)["command"]
        self.assertEqual(words[-2:], ["--", str(self.box)])
        self.assertEqual(run(*words[1:], folder=self.folder).returncode, 0)

    def test_quiet(self):
        done = self.render(self.box, "--quiet")
        self.assertEqual((done.stdout, done.stderr), ("", ""))
        done = self.render(self.box, "-q", "--plane", "z=9")
        self.assertEqual(done.stdout, "")
        self.assertIn("warning: no pixel meets the mesh", done.stderr)
        self.assertIn("pixels", json.loads(self.render(self.box, "-q", "--json").stdout))

    def test_planes_by_axis(self):
        for text, axis, at in [("x", 0, 5.0), ("y", 1, 0.0), ("z", 2, 0.0), ("z=0.25", 2, 0.25),
                               ("x=10%", 0, 4.2), ("z=75%", 2, 1.0), ("y=-0.5", 1, -0.5),
                               ("x=6e0", 0, 6.0)]:
            found = self.buffers("--plane", text)
            position = found["Position"][found["Element"] == 0]
            self.assertGreater(len(position), 10, text)
            np.testing.assert_allclose(position[:, axis], at, rtol=0, atol=1e-14)

    def test_planes_refused(self):
        for text in ["w", "x=", "x=a", "x=101%", "x=-1%", "xy", "z0.2", "x=%", "x=nan", "1,2,3"]:
            done = self.render(self.box, "--plane", text, status=2)
            self.assertIn("--plane: expected", done.stderr, text)
        self.render(self.box, "--plane", "0,0,0,0,0,0", status=2)

    def test_views(self):
        towards = {"+x": (1, 0, 0), "-x": (-1, 0, 0), "+y": (0, 1, 0), "-y": (0, -1, 0),
                   "+z": (0, 0, 1), "-z": (0, 0, -1), "iso": (1, 1, 1)}
        for name, direction in towards.items():
            done = self.render(self.box, "--boundary", f"--view={name}", "--json")
            camera = json.loads(done.stdout)["camera"]
            seen = np.subtract(camera["position"], camera["focal_point"])
            np.testing.assert_allclose(
                seen / np.linalg.norm(seen), direction / np.linalg.norm(direction), atol=1e-14)
        self.render(self.box, "--view", "up", status=2)
        self.render(self.box, "--view", "+x", "--camera-position", "1,2,3", "--focal-point",
            "0,0,0", status=2)

    def test_framing(self):
        """What is cut fills most of a side, and is in the middle."""
        long = self.folder / "long.vtu"
        long.write_text(plain_grid([[13 * x, 1.1 * y, z] for x, y, z in BOX],
            [(12, list(range(8)))], [("u", [p[2] for p in BOX])]), encoding="utf-8")
        for name, arguments in [
            ("box", ["--plane", "x"]), ("box", ["--plane", "x=95%", "--view", "iso"]),
            ("box", ["--sphere", "5,0,0,0.3"]), ("long", []), ("long", ["--plane", "y=10%"]),
            ("long", ["--boundary", "--view", "iso"]), ("box", ["--plane", "y", "--view-angle", 70]),
        ]:
            self.render(f"{name}.vtu", *arguments, "--size", "160x60", "--buffers", "cut.vti")
            rows, columns = np.nonzero(read_buffers(self.folder / "cut.vti")["Element"] >= 0)
            filled = max(np.ptp(rows) / 60, np.ptp(columns) / 160)
            self.assertGreater(filled, 0.8, arguments)
            self.assertLess(filled, 0.97, arguments)
            self.assertAlmostEqual(rows.min() + rows.max(), 59, delta=8, msg=arguments)
            self.assertAlmostEqual(columns.min() + columns.max(), 159, delta=8, msg=arguments)

    def test_components_by_name(self):
        rows = [[p[0], 2.0 * p[1], 3.0 * p[2]] for p in BOX]
        (self.folder / "v.vtu").write_text(
            plain_grid(BOX, [(12, list(range(8)))], [("v", rows)]), encoding="utf-8")
        for name, number in [("x", 0), ("y", 1), ("z", 2)]:
            values = []
            for component in [name, number]:
                self.render("v.vtu", "--component", component, "--buffers", "cut.vti")
                values.append(read_buffers(self.folder / "cut.vti")["Value"])
            np.testing.assert_array_equal(*values)
        self.assertIn("--component", self.render("v.vtu", "--component", "w", status=2).stderr)

    def test_names(self):
        """A picture of somebody else's is not written over."""
        other = self.folder / "box.png"
        other.write_bytes(b"\x89PNG\r\n\x1a\n of somebody")
        done = self.render(self.box, status=2)
        self.assertIn("box.png", done.stderr)
        self.assertEqual(other.read_bytes(), b"\x89PNG\r\n\x1a\n of somebody")
        self.render(self.box, "--output", "box.png")
        self.render(self.box)

    def test_misspelt(self):
        for word, meant in [("--colourmap", "--colormap"), ("--contour", "--contours"),
                            ("--feild", "--field"), ("--plan", "--plane")]:
            self.assertIn(f"did you mean {meant}?", self.render(self.box, word, status=2).stderr)
        self.assertNotIn("did you mean", self.render(self.box, "--xyzzy", status=2).stderr)
        self.assertIn("did you mean render?", run("redner", self.box).stderr)


if __name__ == "__main__":
    unittest.main()
