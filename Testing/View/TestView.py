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
SIZE = (500, 400)  # of the figure
PICTURE = (400, 400)  # in the figure
LETTERS = 11  # height in the panel, in pixels
MARK = (40, 100, 180)  # colour of the chosen field and of sliders
BALL = (240, 120, 20)  # colour of handles


def grab():
    """The screen's pixels, from above."""
    from PIL import ImageGrab

    return np.asarray(ImageGrab.grab(xdisplay=os.environ["DISPLAY"]).convert("RGB")).astype(int)


def xdotool(*words):
    return subprocess.run(["xdotool", *map(str, words)], stdout=subprocess.PIPE, text=True,
        check=True).stdout.strip()


def vector(text):
    return np.array([float(n) for n in text.split(",")])


@unittest.skipUnless(WINDOW.exists(), "pixelexact-view is not built")
@unittest.skipUnless(shutil.which("xdotool"), "xdotool is not installed")
class View(ToolTest):
    def setUp(self):
        super().setUp()
        self.cube = self.folder / "cube.vtu"
        fields = [
            ("u", [p[0] + p[1] * p[2] for p in CUBE]),
            ("v", [p[2] - 2.0 for p in CUBE]),
            ("w", [[0.1 * p[2], 0.0, 0.0] for p in CUBE]),
        ]
        self.cube.write_text(unit_cube_grid(fields), encoding="utf-8")
        self.process = None

    def open(self, *words, size=SIZE):
        """Starts it, and waits for its window."""
        self.out = open(self.folder / "out.txt", "w", encoding="utf-8")
        self.err = open(self.folder / "err.txt", "w", encoding="utf-8")
        self.addCleanup(self.out.close)
        self.addCleanup(self.err.close)
        given = ["--size", "{}x{}".format(*size)] if size else []
        self.process = subprocess.Popen([TOOL, "view", *map(str, words), *given, "--background", "1,1,1"],
            cwd=self.folder, stdout=self.out, stderr=self.err)
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
        xdotool("mousemove", 5, 5)
        self.settled()

    def close(self):
        if self.process.poll() is None:
            self.process.send_signal(signal.SIGTERM)
            self.process.wait(timeout=30)

    def screen(self):
        """The figure."""
        return grab()[: SIZE[1], : SIZE[0]]

    def panel(self):
        return grab()[: SIZE[1], SIZE[0] : SIZE[0] + 17 * LETTERS]

    def wait(self, condition, seconds=40):
        end = time.time() + seconds
        while not condition():
            self.assertIsNone(self.process.poll(), (self.folder / "err.txt").read_text(encoding="utf-8"))
            self.assertLess(time.time(), end, "waited too long")
            time.sleep(0.2)

    def settled(self):
        """The window when it does not change any more; returns its figure."""
        before = grab()
        for _ in range(60):
            time.sleep(0.4)
            now = grab()
            if (now == before).all():
                break
            before = now
        return now[: SIZE[1], : SIZE[0]]

    def press(self, key):
        xdotool("key", key)
        time.sleep(0.3)

    def drag(self, at, by, button=1):
        xdotool("mousemove", *at)
        time.sleep(0.3)
        xdotool("mousedown", button)
        for step in range(1, 9):
            xdotool("mousemove", round(at[0] + by[0] * step / 8), round(at[1] + by[1] * step / 8))
            time.sleep(0.05)
        xdotool("mouseup", button)
        self.settled()

    def keep(self, name):
        """For people to look at."""
        folder = os.environ.get("PIXELEXACT_VIEW_PICTURES")
        if folder:
            from PIL import ImageGrab

            ImageGrab.grab(xdisplay=os.environ["DISPLAY"]).crop((0, 0, SIZE[0] + 17 * LETTERS, SIZE[1])).save(
                Path(folder) / name)

    def printed(self):
        return (self.folder / "out.txt").read_text(encoding="utf-8").splitlines()

    def command(self):
        """The words of the shown picture's command, which the window prints."""
        lines = len(self.printed())
        self.press("c")
        self.wait(lambda: len(self.printed()) > lines)
        words = shlex.split(self.printed()[-1])
        self.assertEqual(words[:2], ["pixelexact", "render"])
        return words[2:]

    def options(self):
        return dict(w[2:].split("=", 1) for w in self.command() if w.startswith("--") and "=" in w)

    def seen(self, point, options):
        """Where the window shows a point, by the camera of a command."""
        eye = vector(options["camera-position"])
        forward = vector(options["focal-point"]) - eye
        forward /= np.linalg.norm(forward)
        right = np.cross(forward, vector(options["view-up"]))
        right /= np.linalg.norm(right)
        off = np.array(point) - eye
        pixel = PICTURE[1] / 2 / np.tan(np.radians(float(options["view-angle"])) / 2) / (off @ forward)
        up = np.cross(right, forward)
        return round(PICTURE[0] / 2 + off @ right * pixel), round(PICTURE[1] / 2 - off @ up * pixel)

    def right(self, options):
        """The direction to the right on the screen."""
        forward = vector(options["focal-point"]) - vector(options["camera-position"])
        right = np.cross(forward, vector(options["view-up"]))
        return right / np.linalg.norm(right)

    def same_camera(self, one, other):
        names = ["camera-position", "focal-point", "view-up"]
        return all(np.allclose(vector(one[n]), vector(other[n]), rtol=0, atol=1e-9) for n in names)

    def rows(self, fits):
        """The middles of the panel's rows whose number of pixels of the mark's colour fits."""
        counts = (np.abs(self.panel() - MARK).sum(axis=2) < 30).sum(axis=1)
        here = np.array([fits(count) for count in counts])
        edges = np.flatnonzero(np.diff(np.concatenate([[0], here.astype(int), [0]])))
        return [(a + b - 1) / 2 for a, b in zip(edges[::2], edges[1::2]) if b - a >= 5]

    def knobs(self):
        """The places of the sliders' knobs in the window."""
        mark = np.abs(self.panel() - MARK).sum(axis=2) < 30
        return [(SIZE[0] + np.flatnonzero(mark[round(y)]).mean(), y) for y in self.rows(lambda n: 3 <= n <= 20)]

    def slide(self, number, part):
        """Moves a slider's knob to a part of its length."""
        x, y = self.knobs()[number]
        margin = 1.3 * LETTERS
        to = SIZE[0] + margin + part * (17 * LETTERS - 2 * margin)
        # Beyond the ends a slider stays at them.
        self.drag((round(x), round(y)), (to - x + 9 * (part == 1.0) - 9 * (part == 0.0), 0))

    def test_keys_and_pointer(self):
        self.open(self.cube, "--field", "u", "--plane", "z", "--range", "0,2")
        start = self.settled()
        self.keep("start.png")
        # The value under the pointer appears in the panel; the figure stays as it is.
        before = self.panel()
        xdotool("mousemove", PICTURE[0] // 2 + 45, PICTURE[1] // 2 + 10)
        after = self.settled()
        self.keep("hover.png")
        changed = (before != self.panel()).any(axis=2)
        self.assertGreater(changed[-6 * LETTERS :].sum(), 100)
        self.assertEqual(changed[: -9 * LETTERS].sum(), 0)
        self.assertEqual((start != after).sum(), 0)
        for key in ["h", "h", "l", "e", "o", "p"]:
            before = self.settled()
            self.press(key)
            after = self.settled()
            self.assertGreater((before != after).any(axis=2).sum(), 30 if key != "e" else 0, key)
            self.keep(f"key-{key}.png")

    def test_it_opens_obliquely_and_fits_the_screen(self):
        self.open(self.cube, "--plane", "z=0.3", size=None)
        width, height = map(int, xdotool("getdisplaygeometry").split())
        words = xdotool("getwindowgeometry", "--shell", self.window).split()
        shape = dict(word.split("=") for word in words)
        self.assertLessEqual(int(shape["WIDTH"]), width)
        self.assertLessEqual(int(shape["HEIGHT"]), height)
        self.assertGreater(int(shape["HEIGHT"]), 0.8 * min(height, 1000))
        options = self.options()
        direction = vector(options["camera-position"]) - vector(options["focal-point"])
        np.testing.assert_allclose(direction / np.linalg.norm(direction), np.full(3, 3**-0.5), atol=1e-6)
        self.assertEqual(options["mesh-outline"], "box")

    def test_a_cut_seen_from_its_edge_is_seen_from_another_side(self):
        self.open(self.cube, "--plane", "0.5,0.5,0.5,1,1,-2")
        options = self.options()
        direction = vector(options["camera-position"]) - vector(options["focal-point"])
        cosine = abs(direction @ [1, 1, -2]) / np.linalg.norm(direction) / 6**0.5
        self.assertGreater(cosine, 0.4)
        self.close()
        # A view that is given is taken.
        self.open(self.cube, "--plane", "0.5,0.5,0.5,1,1,-2", "--view", "+x")
        options = self.options()
        direction = vector(options["camera-position"]) - vector(options["focal-point"])
        np.testing.assert_allclose(direction / np.linalg.norm(direction), [1, 0, 0], atol=1e-6)

    def test_saved_figure_is_what_its_command_makes(self):
        self.open(self.cube, "--field", "u", "--plane", "z=0.3")
        self.drag((PICTURE[0] // 2 + 60, PICTURE[1] // 2 + 40), (50, 30))
        self.press("l")
        self.press("p")
        self.settled()
        self.press("s")
        saved = self.folder / "cube_view_0.png"
        self.wait(saved.exists)
        self.wait(self.printed)
        self.settled()
        self.keep("saved-window.png")
        picture = read_image(saved)
        self.assertEqual(picture.shape, (SIZE[1], SIZE[0], 3))
        (line,) = self.printed()
        words = shlex.split(line)
        self.assertEqual(words[:2], ["pixelexact", "render"])
        self.assertIn("--contours=10", words)
        self.assertIn("--figure", words)
        other = self.folder / "other"
        other.mkdir()
        done = run(*words[1:], folder=other)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual((other / "cube_view_0.png").read_bytes(), saved.read_bytes())
        # The window shows it, too, but for the number of samples.
        self.wait(lambda: (np.abs(self.screen() - picture[::-1].astype(int)).max(axis=2) > 40).mean() < 0.03)
        # The command names the next figure, and printing it writes no file.
        self.assertIn("--output=cube_view_1.png", self.command())
        self.assertFalse((self.folder / "cube_view_1.png").exists())

    def test_window_shows_what_render_draws(self):
        styles = [
            ["--edges", "5", "--edge-color", "1,0,0", "--lights", "off"],
            ["--contours", "3", "--contour-width", "6", "--contour-color", "0,0,1", "--contour-labels"],
            ["--contours", "4", "--contours-only", "--contour-color", "map", "--contour-width", "4"],
            ["--bands", "4", "--range", "1,3", "--log", "--contours", "2", "--field", "u+1"],
            ["--figure", "--title", "Title", "--color", "0.2,0.8,0.4", "--contours", "3"],
        ]
        for number, style in enumerate(styles):
            with self.subTest(style=style):
                field = [] if "--field" in style else ["--field", "u"]
                self.open(self.cube, "--boundary", *field, *style)
                # VTK draws other lines.
                self.press("o")
                self.settled()
                words = [w for w in self.command() if not w.startswith("--output")]
                self.assertNotIn("--mesh-outline", " ".join(words))
                picture = self.folder / f"style_{number}.png"
                samples = [] if "--contours-only" in style else ["--samples", "1"]
                done = run("render", *words, *samples, "--output", picture, folder=self.folder)
                self.assertEqual(done.returncode, 0, done.stderr)
                drawn = read_image(picture)[::-1].astype(int)
                self.assertGreater((drawn[:, : PICTURE[0]] != 255).any(axis=2).sum(), 1000)
                self.wait(lambda: (np.abs(self.screen() - drawn).max(axis=2) > 1).mean() <= 0.002)
                self.keep(f"as-render-{number}.png")
                # The bar is that of the figure.
                np.testing.assert_array_equal(self.screen()[:, PICTURE[0] :], drawn[:, PICTURE[0] :])
                self.close()

    def test_a_drag_on_the_cut_turns_the_camera(self):
        self.open(self.cube, "--field", "u", "--plane", "z=0.5")
        before = self.options()
        # On the cut, away from the balls.
        self.drag(self.seen((0.8, 0.2, 0.5), before), (40, 20))
        self.keep("turned.png")
        after = self.options()
        self.assertEqual(before["plane"], after["plane"])
        self.assertFalse(self.same_camera(before, after))
        # The handle does not turn it, where it is off.
        self.press("p")
        self.drag(self.seen((0.5, 0.5, 0.5), after), (20, 10))
        last = self.options()
        self.assertEqual(before["plane"], last["plane"])
        self.assertFalse(self.same_camera(last, after))

    def test_plane_is_dragged(self):
        self.open(self.cube, "--field", "u", "--plane", "z=0.5")
        first = self.options()
        ball = self.seen((0.5, 0.5, 0.5), first)
        self.assertGreater((np.abs(self.screen() - BALL).sum(axis=2) < 120).sum(), 50)
        self.drag(ball, (0, -50))
        self.keep("dragged.png")
        second = self.options()
        self.assertEqual(first["plane"], "0.5,0.5,0.5,0,0,1")
        plane = vector(second["plane"])
        np.testing.assert_allclose(plane[3:], [0, 0, 1])
        self.assertTrue(self.same_camera(first, second))
        # The ball follows the pointer.
        np.testing.assert_allclose(self.seen(plane[:3], second), np.array(ball) - [0, 50], atol=2)
        # The arrow's tip turns the plane about the ball.
        tip = plane[:3] + 0.18 * 3**0.5 * plane[3:]
        self.drag(self.seen(tip, second), (40, 10))
        self.keep("turned-plane.png")
        third = self.options()
        turned = vector(third["plane"])
        np.testing.assert_allclose(turned[:3], plane[:3], atol=1e-12)
        self.assertGreater(turned[3:] @ self.right(third), 0.3)
        self.assertTrue(self.same_camera(first, third))
        # What roundings leave of 0 is printed as 0.
        for line in self.printed()[:2]:
            for word in shlex.split(line):
                self.assertNotRegex(word, r"^--.*=.*(e-1[5-9]|,-0,|,-0$)")

    def test_plane_that_faces_the_viewer_is_dragged(self):
        self.open(self.cube, "--field", "u", "--plane", "z=0.5", "--view", "+z", "--figure", "--axes", "none")
        first = self.options()
        self.drag(self.seen((0.5, 0.5, 0.5), first), (0, -40))
        plane = vector(self.options()["plane"])
        np.testing.assert_allclose(plane[3:], [0, 0, 1])
        self.assertLess(plane[2], 0.45)

    def dragged(self, option, numbers, handle):
        """The numbers of a surface before and after a drag of a handle by (40, -32) pixels."""
        self.open(self.cube, "--field", "u", f"--{option}", numbers)
        first = self.options()
        at = handle(first) if callable(handle) else handle
        self.drag(self.seen(at, first), (40, -32))
        self.keep(f"dragged-{option}.png")
        second = self.options()
        self.assertTrue(self.same_camera(first, second))
        self.close()
        np.testing.assert_allclose(vector(first[option]), vector(numbers), atol=1e-12)
        return vector(first[option]), vector(second[option])

    def test_sphere_is_dragged(self):
        first, second = self.dragged("sphere", "0.5,0.5,0.5,0.4", (0.5, 0.5, 0.5))
        self.assertGreater(np.abs(second[:3] - first[:3]).max(), 0.05)
        self.assertEqual(second[3], first[3])
        first, second = self.dragged("sphere", "0.5,0.5,0.5,0.4", lambda o: 0.5 + 0.4 * self.right(o))
        np.testing.assert_array_equal(second[:3], first[:3])
        self.assertGreater(second[3], 0.45)

    def test_cylinder_is_dragged(self):
        numbers = "0.5,0.5,0.5,0,0,1,0.3"
        first, second = self.dragged("cylinder", numbers, (0.5, 0.5, 0.5))
        self.assertGreater(np.abs(second[:3] - first[:3]).max(), 0.05)
        np.testing.assert_array_equal(second[3:], first[3:])
        first, second = self.dragged("cylinder", numbers, (0.5, 0.5, 0.5 + 0.18 * 3**0.5))
        self.assertGreater(np.abs(second[3:6] - first[3:6]).max(), 0.1)
        np.testing.assert_array_equal(second[[0, 1, 2, 6]], first[[0, 1, 2, 6]])

    def test_radius_of_a_cylinder_is_dragged(self):
        first, second = self.dragged("cylinder", "0.5,0.5,0.5,0,0,1,0.3",
            lambda o: 0.5 + 0.3 * np.array([-1, 1, 0]) / 2**0.5)
        self.assertGreater(abs(second[6] - first[6]), 0.05)
        np.testing.assert_array_equal(second[:6], first[:6])

    def test_box_is_dragged(self):
        first, second = self.dragged("box", "0.2,0.2,0.2,0.8,0.8,0.8", (0.5, 0.8, 0.5))
        # One face alone.
        self.assertGreater(abs(second[4] - 0.8), 0.02)
        np.testing.assert_array_equal(np.delete(second, 4), np.delete(first, 4))

    def test_fields_are_chosen(self):
        self.open(self.cube, "--field", "u*u", "--plane", "z=0.5", "--range", "0.1,1")
        # The list has u, v, |w|, its components, and the expression.
        (y,) = self.rows(lambda n: n > 50)
        self.keep("fields.png")
        self.assertEqual(self.options()["field"], "u*u")
        row = 1.5 * LETTERS
        xdotool("mousemove", SIZE[0] + 30, round(y - 6 * row), "click", 1)
        self.settled()
        self.keep("field-u.png")
        options = self.options()
        self.assertEqual(options["field"], "u")
        (now,) = self.rows(lambda n: n > 50)
        self.assertAlmostEqual(now, y - 6 * row, delta=2)
        self.assertNotEqual(options["range"], "0.1,1")
        # Backwards from the first comes the last.
        self.press("F")
        self.settled()
        self.assertEqual(self.options()["field"], "u*u")
        self.press("f")
        self.settled()
        self.assertEqual(self.options()["field"], "u")
        self.press("F")
        self.press("F")
        self.settled()
        options = self.options()
        self.assertEqual((options["field"], options["component"]), ("w", "2"))

    def test_a_long_list_of_fields_scrolls(self):
        fields = [(f"field{k:02d}", [k + p[0] for p in CUBE]) for k in range(40)]
        self.cube.write_text(unit_cube_grid(fields), encoding="utf-8")
        self.open(self.cube, "--field", "field05", "--plane", "z=0.5")
        (y,) = self.rows(lambda n: n > 50)
        top = y - 5 * 1.5 * LETTERS
        xdotool("mousemove", SIZE[0] + 30, round(top))
        xdotool("click", "--repeat", 20, "--delay", 50, 5)
        self.settled()
        self.keep("fields-scrolled.png")
        # The list ends with the last field, and a click chooses what is there.
        xdotool("click", 1)
        self.settled()
        first = self.options()["field"]
        self.assertGreater(first, "field10")
        (now,) = self.rows(lambda n: n > 50)
        self.assertAlmostEqual(now, top, delta=2)
        # A field that is chosen by a key is visible.
        self.press("F")
        self.settled()
        self.assertEqual(int(self.options()["field"][-2:]), int(first[-2:]) - 1)
        self.assertEqual(len(self.rows(lambda n: n > 50)), 1)

    def test_number_of_contours_has_a_slider(self):
        self.open(self.cube, "--field", "u", "--plane", "z=0.5")
        self.assertEqual(self.knobs(), [])
        self.press("l")
        self.settled()
        self.assertEqual(self.options()["contours"], "10")
        before = self.screen()
        self.slide(0, 0.5)
        self.keep("slider-contours.png")
        self.assertAlmostEqual(int(self.options()["contours"]), 20, delta=1)
        self.assertGreater((before != self.settled()).any(axis=2).sum(), 200)
        # Without contours there is neither slider nor option.
        self.press("l")
        self.settled()
        self.assertEqual(self.knobs(), [])
        self.assertNotIn("contours", self.options())

    def test_a_refused_change_is_reported_and_undone(self):
        colors = "1:0:0,0:1:0,0:0:1"
        self.open(self.cube, "--field", "u", "--plane", "z=0.5", "--contours", "3", "--contour-color", colors)
        before, text = self.screen(), self.panel()
        self.slide(0, 0.5)
        self.keep("refused.png")
        self.assertGreater((text != self.panel())[-9 * LETTERS :].any(axis=2).sum(), 300)
        self.assertEqual(self.options()["contours"], "3")
        self.assertEqual((before != self.settled()).sum(), 0)

    def test_iso_value_has_a_slider(self):
        self.open(self.cube, "--field", "v", "--isosurface", "u=0.5", "--view", "+x")
        before = self.screen()
        self.slide(0, 0.7)
        self.keep("slider-iso.png")
        options = self.options()
        name, value = options["isosurface"].split("=")
        self.assertEqual(name, "u")
        self.assertAlmostEqual(float(value), 1.4, delta=0.05)
        self.assertLessEqual(len(value), 5)  # a round one
        self.assertGreater((before != self.settled()).any(axis=2).sum(), 1000)
        # The saved figure has it.
        self.press("s")
        self.wait((self.folder / "cube_view_0.png").exists)
        self.assertIn(f"--isosurface=u={value}", self.printed()[-1])

    def test_sliders_of_a_warp(self):
        self.open(self.cube, "--field", "u", "--boundary", "--warp", "w=2", "--contours", "5")
        self.assertEqual(len(self.knobs()), 2)
        before = self.screen()
        self.slide(0, 0.0)
        self.keep("slider-warp.png")
        self.assertEqual(self.options()["warp"], "w=0")
        self.assertGreater((before != self.settled()).any(axis=2).sum(), 500)
        self.slide(0, 1.0)
        self.assertEqual(self.options()["warp"], "w=4")

    def test_time_steps(self):
        sets = ""
        for step in range(3):
            fields = [("u", [step + p[0] for p in CUBE]), ("v", [p[1] for p in CUBE])]
            text = plain_grid(CUBE, [(12, list(range(8)))], fields)
            (self.folder / f"s_{step}.vtu").write_text(text, encoding="utf-8")
            sets += f'<DataSet timestep="{step}" part="0" file="s_{step}.vtu"/>'
        series = self.folder / "series.pvd"
        series.write_text(f'<VTKFile type="Collection"><Collection>{sets}</Collection></VTKFile>',
            encoding="utf-8")
        self.open(series, "--field", "u", "--plane", "z", "--range", "0,3")
        before = self.settled()
        self.press("Right")
        after = self.settled()
        self.keep("step.png")
        self.assertGreater((before != after).any(axis=2).sum(), 10000)
        self.assertEqual(self.options()["time-step"], "1")
        self.slide(0, 1.0)
        self.keep("slider-time.png")
        self.assertEqual(self.options()["time-step"], "2")
        # The last step stays, and other fields are there.
        self.press("Right")
        self.press("f")
        self.settled()
        options = self.options()
        self.assertEqual((options["time-step"], options["field"]), ("2", "v"))

    def test_size_of_the_window_is_that_of_the_figure(self):
        self.open(self.cube, "--field", "u", "--plane", "z=0.5")
        xdotool("windowsize", "--sync", self.window, 900, 500)
        self.settled()
        self.assertEqual(self.options()["size"], f"{900 - 17 * LETTERS}x500")

    def test_options_of_figures_are_named(self):
        self.open(self.cube, "--field", "u", "--plane", "z", "--figure", "--mark-extremes")
        self.assertIn("--mark-extremes: in saved figures", (self.folder / "err.txt").read_text(encoding="utf-8"))
        self.close()
        # Colours of a legend have neither a bar nor a range.
        self.open(self.cube, "--field", "u", "--plane", "z", "--show", "validity")
        self.press("e")
        self.settled()
        self.assertIn("--edges", self.command())
        self.assertFalse({"range", "figure"} & set(self.options()))
        self.press("s")
        self.wait((self.folder / "cube_view_0.png").exists)

    def test_what_windows_do_not_have_is_refused(self):
        for words, names in [
            (["--sweep", "z=0:1:3"], ["view", "--sweep"]),
            (["--stride", "2"], ["view", "--stride"]),
            (["--size", "100x100"], ["--size"]),
        ]:
            done = subprocess.run([TOOL, "view", self.cube, *words], stderr=subprocess.PIPE, text=True, check=False)
            self.assertEqual(done.returncode, 2, done.stderr)
            for name in names:
                self.assertIn(name, done.stderr)

    def test_it_closes(self):
        self.open(self.cube, "--field", "u")
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
