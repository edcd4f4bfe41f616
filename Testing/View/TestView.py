# SPDX-License-Identifier: BSD-3-Clause
"""pixelexact view in a real window of an X server, with a pointer and keys."""

import os
import shlex
import shutil
import signal
import subprocess
import sys
import time
import unittest
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "Tools"))

from tool import CUBE, TOOL, ToolTest, plain_grid, read_image, run, unit_cube_grid  # noqa: E402

WINDOW = Path(TOOL).with_name("pixelexact-view")
SIZE = (500, 400)


def grab():
    """The screen's pixels, from above."""
    from PIL import ImageGrab

    return np.asarray(ImageGrab.grab(xdisplay=os.environ["DISPLAY"]).convert("RGB")).astype(int)


def xdotool(*words):
    return subprocess.run(["xdotool", *map(str, words)], stdout=subprocess.PIPE, text=True,
        check=True).stdout.strip()


@unittest.skipUnless(WINDOW.exists(), "pixelexact-view is not built")
@unittest.skipUnless(shutil.which("xdotool"), "xdotool is not installed")
class View(ToolTest):
    def setUp(self):
        super().setUp()
        self.cube = self.folder / "cube.vtu"
        fields = [("u", [p[0] + p[1] * p[2] for p in CUBE])]
        self.cube.write_text(unit_cube_grid(fields), encoding="utf-8")
        self.process = None

    def open(self, *words):
        """Starts it, and waits for its window."""
        self.out = open(self.folder / "out.txt", "w", encoding="utf-8")
        self.err = open(self.folder / "err.txt", "w", encoding="utf-8")
        self.addCleanup(self.out.close)
        self.addCleanup(self.err.close)
        self.process = subprocess.Popen([TOOL, "view", *map(str, words), "--size", "{}x{}".format(*SIZE),
            "--background", "1,1,1"], cwd=self.folder, stdout=self.out, stderr=self.err)
        self.addCleanup(self.close)
        for _ in range(300):
            found = subprocess.run(["xdotool", "search", "--name", "^PixelExact$"],
                stdout=subprocess.PIPE, text=True, check=False).stdout.split()
            if found:
                self.window = found[-1]
                break
            self.assertIsNone(self.process.poll(), (self.folder / "err.txt").read_text(encoding="utf-8"))
            time.sleep(0.2)
        xdotool("windowmove", self.window, 0, 0)
        self.wait(lambda: (self.screen() != 255).any() and (self.screen() == 255).any())

    def close(self):
        if self.process.poll() is None:
            self.process.send_signal(signal.SIGTERM)
            self.process.wait(timeout=30)

    def screen(self):
        return grab()[: SIZE[1], : SIZE[0]]

    def wait(self, condition, seconds=40):
        end = time.time() + seconds
        while not condition():
            self.assertIsNone(self.process.poll(), (self.folder / "err.txt").read_text(encoding="utf-8"))
            self.assertLess(time.time(), end, "waited too long")
            time.sleep(0.2)

    def settled(self):
        """The picture when it does not change any more."""
        before = self.screen()
        for _ in range(60):
            time.sleep(0.4)
            now = self.screen()
            if (now == before).all():
                return now
            before = now
        return before

    def press(self, key):
        xdotool("key", key)
        time.sleep(0.3)

    def keep(self, name):
        """For people to look at."""
        folder = os.environ.get("PIXELEXACT_VIEW_PICTURES")
        if folder:
            from PIL import ImageGrab

            ImageGrab.grab(xdisplay=os.environ["DISPLAY"]).crop((0, 0, *SIZE)).save(Path(folder) / name)

    def test_keys_and_pointer(self):
        self.open(self.cube, "--field", "u", "--plane", "z", "--range", "0,2")
        xdotool("mousemove", SIZE[0] // 2, SIZE[1] // 2)
        start = self.settled()
        self.keep("start.png")
        # The value under the pointer appears.
        xdotool("mousemove", SIZE[0] // 2 + 25, SIZE[1] // 2 + 10)
        told = self.settled()
        self.assertTrue((told[SIZE[1] - 60 :] != start[SIZE[1] - 60 :]).any())
        for key in ["h", "c", "e"]:
            before = self.settled()
            self.press(key)
            after = self.settled()
            self.assertGreater((before != after).any(axis=2).sum(), 50 if key != "e" else 0, key)
            self.keep(f"key-{key}.png")

    def test_saved_figure_is_what_its_command_makes(self):
        self.open(self.cube, "--field", "u", "--plane", "z=0.3")
        xdotool("mousemove", SIZE[0] // 2, SIZE[1] // 2)
        self.settled()
        self.press("p")  # the widget would take the drag
        xdotool("mousedown", 1)
        xdotool("mousemove", SIZE[0] // 2 + 60, SIZE[1] // 2 + 40)
        xdotool("mouseup", 1)
        self.settled()
        self.press("c")
        shown = self.settled()
        self.press("s")
        saved = self.folder / "cube_view_0.png"
        self.wait(saved.exists)
        self.wait(lambda: (self.folder / "out.txt").read_text(encoding="utf-8").endswith("\n"))
        time.sleep(1.0)
        self.keep("saved-window.png")
        picture = read_image(saved)
        self.assertEqual(picture.shape, (SIZE[1], SIZE[0], 3))
        (line,) = (self.folder / "out.txt").read_text(encoding="utf-8").splitlines()
        words = shlex.split(line)
        self.assertEqual(words[:2], ["pixelexact", "render"])
        self.assertIn("--contours=10", words)
        done = run(*[w.replace("cube_view_0", "again") for w in words[1:]], folder=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        np.testing.assert_array_equal(read_image(self.folder / "again.png"), picture)
        # The window shows it, too, but for texts, the bar and edges.
        middle = slice(120, 280), slice(150, 330)
        difference = np.abs(shown[middle] - picture[::-1][middle].astype(int)).max(axis=2)
        self.assertLess(np.median(difference), 3)
        self.assertLess((difference > 40).mean(), 0.1)

    def test_window_shows_what_render_draws(self):
        styles = [
            ["--edges", "5", "--edge-color", "1,0,0", "--lights", "off"],
            ["--contours", "3", "--contour-width", "6", "--contour-color", "0,0,1", "--contour-labels"],
            ["--contours", "4", "--contours-only", "--contour-color", "map", "--contour-width", "4"],
            ["--bands", "4", "--range", "0.2,1.4", "--log", "--contours", "2"],
            ["--color", "0.2,0.8,0.4", "--contours", "3"],
        ]
        for number, style in enumerate(styles):
            with self.subTest(style=style):
                words = [self.cube, "--field", "u", "--boundary", *style]
                self.open(*words)
                xdotool("mousemove", 1, 1)
                shown = self.settled()
                self.keep(f"as-render-{number}.png")
                self.close()
                picture = self.folder / f"style_{number}.png"
                done = run("render", *words, "--size", "{}x{}".format(*SIZE), "--background", "1,1,1",
                    "--output", picture, folder=self.folder)
                self.assertEqual(done.returncode, 0, done.stderr)
                drawn = read_image(picture)[::-1].astype(int)
                # Beside the colour bar and texts at the window's edges.
                middle = slice(70, 330), slice(110, 390)
                self.assertGreater((drawn[middle] != 255).any(axis=2).sum(), 1000)
                difference = np.abs(shown[middle] - drawn[middle]).max(axis=2)
                self.assertLessEqual((difference > 1).mean(), 0.002)

    def test_plane_is_dragged(self):
        self.open(self.cube, "--field", "u", "--plane", "z=0.5", "--view", "iso")
        xdotool("mousemove", 5, 5)
        before = self.settled()
        self.keep("widget.png")
        self.press("s")
        self.wait((self.folder / "cube_view_0.png").exists)
        self.settled()
        # On the cut, away from the arrow in its middle.
        x, y = SIZE[0] // 2 - 70, SIZE[1] // 2 + 10
        xdotool("mousemove", x, y)
        time.sleep(0.5)
        xdotool("mousedown", 1)
        for step in range(1, 9):
            xdotool("mousemove", x, y - 6 * step)
            time.sleep(0.1)
        xdotool("mouseup", 1)
        after = self.settled()
        self.keep("dragged.png")
        self.assertGreater((before != after).any(axis=2).sum(), 200)
        self.press("s")
        self.wait((self.folder / "cube_view_1.png").exists)
        first, second = (self.folder / "out.txt").read_text(encoding="utf-8").splitlines()[:2]
        planes = [next(w for w in shlex.split(line) if w.startswith("--plane=")) for line in (first, second)]
        planes = [[float(n) for n in plane.split("=")[1].split(",")] for plane in planes]
        self.assertEqual(planes[0][2:], [0.5, 0, 0, 1])
        self.assertEqual(planes[1][3:], [0, 0, 1])
        self.assertGreater(planes[1][2], 0.55)
        # What roundings leave of 0 is printed as 0.
        for word in shlex.split(first) + shlex.split(second):
            self.assertNotRegex(word, r"^--.*=.*(e-1[5-9]|,-0,|,-0$)")
        # The camera stays.
        cameras = [next(w for w in shlex.split(line) if w.startswith("--camera-position=")) for line in (first, second)]
        self.assertEqual(*cameras)

    def seen(self, point):
        """Where the window shows a point, by the camera of the command that it printed last."""
        line = (self.folder / "out.txt").read_text(encoding="utf-8").splitlines()[-1]
        words = dict(w[2:].split("=", 1) for w in shlex.split(line) if w.startswith("--") and "=" in w)

        def vector(name):
            return np.array([float(n) for n in words[name].split(",")])

        eye = vector("camera-position")
        forward = vector("focal-point") - eye
        forward /= np.linalg.norm(forward)
        right = np.cross(forward, vector("view-up"))
        right /= np.linalg.norm(right)
        off = np.array(point) - eye
        pixel = SIZE[1] / 2 / np.tan(np.radians(float(words["view-angle"])) / 2) / (off @ forward)
        up = np.cross(right, forward)
        return round(SIZE[0] / 2 + off @ right * pixel), round(SIZE[1] / 2 - off @ up * pixel)

    def dragged(self, option, words, at, button=1):
        """The numbers of a surface before and after a drag by (40, -32) pixels from a point of it."""
        self.open(self.cube, "--field", "u", *words, "--view", "iso")
        xdotool("mousemove", 5, 5)
        before = self.settled()
        self.press("s")
        self.wait((self.folder / "cube_view_0.png").exists)
        self.settled()
        x, y = self.seen(at)
        xdotool("mousemove", x, y)
        time.sleep(0.5)
        xdotool("mousedown", button)
        for step in range(1, 9):
            xdotool("mousemove", x + 5 * step, y - 4 * step)
            time.sleep(0.1)
        xdotool("mouseup", button)
        after = self.settled()
        self.keep(f"dragged{option}.png")
        self.assertGreater((before != after).any(axis=2).sum(), 200)
        self.press("s")
        self.wait((self.folder / "cube_view_1.png").exists)
        self.wait(lambda: len((self.folder / "out.txt").read_text(encoding="utf-8").splitlines()) == 2)
        lines = (self.folder / "out.txt").read_text(encoding="utf-8").splitlines()
        found = []
        for line in lines:
            (word,) = [w for w in shlex.split(line) if w.startswith(option + "=")]
            found.append(np.array([float(n) for n in word.split("=")[1].split(",")]))
        self.close()
        return found

    def test_sphere_is_dragged(self):
        words = ["--sphere", "0.5,0.5,0.5,0.4"]
        first, second = self.dragged("--sphere", words, (0.73, 0.73, 0.73))
        np.testing.assert_allclose(first, [0.5, 0.5, 0.5, 0.4], atol=1e-6)
        self.assertGreater(np.abs(second[:3] - first[:3]).max(), 0.05)
        self.assertAlmostEqual(second[3], first[3], delta=1e-6)

    def test_radius_of_a_sphere_is_dragged(self):
        first, second = self.dragged("--sphere", ["--sphere", "0.5,0.5,0.5,0.4"], (0.73, 0.73, 0.73), button=3)
        np.testing.assert_allclose(second[:3], first[:3], atol=1e-6)
        self.assertGreater(abs(second[3] - first[3]), 0.02)

    def test_cylinder_is_dragged(self):
        first, second = self.dragged("--cylinder", ["--cylinder", "0.5,0.5,0.5,0,0,1,0.3"], (0.782, 0.603, 0.5))
        np.testing.assert_allclose(first, [0.5, 0.5, 0.5, 0, 0, 1, 0.3], atol=1e-6)
        self.assertGreater(np.abs(second - first).max(), 0.02)

    def test_box_is_dragged(self):
        first, second = self.dragged("--box", ["--box", "0.2,0.2,0.2,0.8,0.8,0.8"], (0.8, 0.5, 0.5))
        np.testing.assert_allclose(first, [0.2, 0.2, 0.2, 0.8, 0.8, 0.8], atol=1e-6)
        # One face alone.
        self.assertGreater(abs(second[3] - 0.8), 0.02)
        np.testing.assert_allclose(np.delete(second, 3), np.delete(first, 3), atol=1e-6)

    def test_time_steps(self):
        sets = ""
        for step in range(3):
            text = plain_grid(CUBE, [(12, list(range(8)))], [("u", [step + p[0] for p in CUBE])])
            (self.folder / f"s_{step}.vtu").write_text(text, encoding="utf-8")
            sets += f'<DataSet timestep="{step}" part="0" file="s_{step}.vtu"/>'
        series = self.folder / "series.pvd"
        series.write_text(f'<VTKFile type="Collection"><Collection>{sets}</Collection></VTKFile>',
            encoding="utf-8")
        self.open(series, "--field", "u", "--plane", "z", "--range", "0,3")
        xdotool("mousemove", SIZE[0] // 2, SIZE[1] // 2)
        before = self.settled()
        self.press("Right")
        after = self.settled()
        self.keep("step.png")
        self.assertGreater((before != after).any(axis=2).sum(), 10000)
        self.press("s")
        self.wait((self.folder / "series_view_0.png").exists)
        self.assertIn("--time-step=1", (self.folder / "out.txt").read_text(encoding="utf-8"))

    def test_it_closes(self):
        self.open(self.cube, "--field", "u")
        xdotool("mousemove", SIZE[0] // 2, SIZE[1] // 2)
        self.settled()
        self.press("q")
        self.assertEqual(self.process.wait(timeout=30), 0, (self.folder / "err.txt").read_text(encoding="utf-8"))


@unittest.skipUnless(WINDOW.exists(), "pixelexact-view is not built")
class Refused(ToolTest):
    def test_without_a_display(self):
        cube = self.folder / "cube.vtu"
        cube.write_text(unit_cube_grid(), encoding="utf-8")
        self.fails(2, "view", cube, names=["display", "render"])

    def test_wrong_usage(self):
        self.fails(2, "view", "absent.vtu", "--sise", "9x9", names=["--sise", "--size"])
        self.fails(2, "view", names=["INPUT"])


if __name__ == "__main__":
    unittest.main()
