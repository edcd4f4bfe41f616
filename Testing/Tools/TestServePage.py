# SPDX-License-Identifier: BSD-3-Clause
"""The page of serve in headless Chromium: each control does what it says. Where Chromium and its driver are."""

import tempfile
import time
import unittest
from pathlib import Path

from browser import Server
from chromium import CHROMIUM, DOWN, DRIVER, UP, WAIT, Chromium, pointer, to
from tool import CUBE, case, unit_cube_grid

TORUS = case("toroid_hex_g3_p6")


@unittest.skipUnless(DRIVER and CHROMIUM, "chromium or chromium-driver is not installed")
class PageTest(unittest.TestCase):
    width, height, touch = 1200, 800, False
    file = TORUS
    options = ["--plane", "z=40%", "--field", "u"]

    def setUp(self):
        self.server = Server(self.file, *self.options)
        self.addCleanup(self.server.stop)
        self.page = Chromium(self.width, self.height, self.touch)
        self.addCleanup(self.page.close)
        self.page.open(self.server.address)
        self.wait("document.body.dataset.exact > 0")

    def wait(self, condition, seconds=60):
        self.page.wait(condition, seconds, note="$('message').textContent")

    def still(self):
        """Waits until the last change is drawn exactly."""
        before = -1
        while (now := int(self.page.run("return document.body.dataset.exact"))) != before:
            before = now
            time.sleep(0.6)

    def change(self, control, value, event="change"):
        """Sets a control and returns the options of the next exact picture."""
        count = self.page.run("return document.body.dataset.exact")
        kind = "checked" if isinstance(value, bool) else "value"
        self.page.run(f"const c = $(arguments[0]); c.{kind} = arguments[1]; c.dispatchEvent(new Event(arguments[2]))",
                      control, value, event)
        self.wait(f"document.body.dataset.exact > {count}")
        self.assertEqual(self.page.run("return $('message').textContent"), "")
        return self.page.run("return state.options")

    def command(self):
        return self.page.run("return state.command")

    def middle(self):
        box = self.page.run("const b = canvas.getBoundingClientRect(); return [b.x + b.width / 2, b.y + b.height / 2]")
        return box[0], box[1]


class Wide(PageTest):
    def test_each_control(self):
        for control, value, option, expected in (
            ("field", "u*u", "--field", "u*u"),
            ("field", "u", "--field", "u"),
            ("colormap", "coolwarm", "--colormap", "coolwarm"),
            ("reversed", True, "--colormap", "coolwarm_r"),
            ("colormap", "romaO", "--colormap", "romaO_r"),
            ("reversed", False, "--colormap", "romaO"),
            ("bands", "7", "--bands", "7"),
            ("bands", "", "--bands", None),
            ("contours", "9", "--contours", "9"),
            ("labels", True, "--contour-labels", True),
            ("contours", "", "--contour-labels", None),
            ("edges", True, "--edges", True),
            ("samples", "2", "--samples", "2"),
            ("samples", "1", "--samples", "1"),
            ("axis", "x", "--plane", None),
            ("figure", True, "--figure", True),
            ("figure", False, "--figure", None),
            ("warp", "vec(u,u,u)", "--warp", "vec(u,u,u)=1"),
            ("scale", "0.01", "--warp", "vec(u,u,u)=0.01"),
            ("warp", "", "--warp", None),
        ):
            with self.subTest(control=control, value=value):
                options = self.change(control, value, "input" if control == "axis" else "change")
                if control == "axis":
                    self.assertTrue(options["--plane"].startswith("x="))
                else:
                    self.assertEqual(options.get(option), expected)
        self.page.screenshot("wide-lines.png")

    def test_surfaces_and_sliders(self):
        options = self.change("place", "62.5", "input")
        self.assertEqual(options["--plane"], "z=62.5%")
        options = self.change("kind", "--isosurface")
        self.assertTrue(options["--isosurface"].startswith("u="))
        self.assertNotIn("--plane", options)
        before = options["--isosurface"]
        self.assertNotEqual(self.change("isoslider", "0.7", "input")["--isosurface"], before)
        self.page.screenshot("wide-iso.png")
        self.assertEqual(self.change("isovalue", "0.1")["--isosurface"], "u=0.1")
        self.assertEqual(self.change("kind", "--boundary")["--boundary"], "all")
        self.assertIn("--plane", self.change("kind", "--plane"))

    def test_range(self):
        self.page.run("$('from').value = '-0.5'; $('to').value = '0.5'")
        self.assertEqual(self.change("to", "0.5")["--range"], "-0.5,0.5")
        self.assertEqual(self.page.run("return $('high').textContent"), "0.5")
        count = self.page.run("return document.body.dataset.exact")
        self.page.run("$('fit').click()")
        self.wait(f"document.body.dataset.exact > {count}")
        self.assertNotIn("--range", self.page.run("return state.options"))

    def test_mouse(self):
        x, y = self.middle()
        views = [self.command()]
        for keys in ([], ["\ue008"]):  # plain, and with Shift
            sources = [pointer("m", to(x, y), WAIT, DOWN, to(x + 90, y + 40, 200), UP)]
            if keys:
                sources.append({"type": "key", "id": "k", "actions": [{"type": "keyDown", "value": keys[0]}] + [WAIT] * 3 +
                                [{"type": "keyUp", "value": keys[0]}]})
            self.page.act(*sources)
            self.still()
            views.append(self.command())
        self.page.act({"type": "wheel", "id": "w", "actions": [{"type": "scroll", "x": int(x), "y": int(y), "deltaX": 0,
                                                               "deltaY": -120, "duration": 0}]})
        self.still()
        views.append(self.command())
        self.assertEqual(len(set(views)), 4)
        self.assertGreater(int(self.page.run("return document.body.dataset.coarse")), 2)

        def focus(command):
            return command.split("--focal-point=")[1].split()[0]

        self.assertEqual(focus(views[0]), focus(views[1]))
        self.assertNotEqual(focus(views[1]), focus(views[2]))
        self.page.act(pointer("m", to(x + 10, y + 10), WAIT, to(x + 12, y + 10), WAIT))
        self.wait("$('value').textContent")
        self.page.screenshot("wide.png")

    def test_value_under_the_pointer(self):
        x, y = self.middle()
        for dx in range(-400, 400, 23):
            self.page.act(pointer("m", to(x + dx, y), WAIT))
            self.wait("$('value').textContent")
            text = self.page.run("return $('value').textContent")
            if "exact" in text:
                break
        self.assertRegex(text, r"^u = -?[0-9.e-]+, exact\nelement \d+, xi = .*\nx = ")

    def test_buttons(self):
        views = {self.command()}
        for name in ("iso", "+x", "-y", "-z"):
            count = self.page.run("return document.body.dataset.exact")
            self.page.run("[...$('views').children].find(b => b.textContent === arguments[0]).click()", name)
            self.wait(f"document.body.dataset.exact > {count}")
            views.add(self.command())
        self.assertEqual(len(views), 5)

    def test_save(self):
        for number, suffix in enumerate(("png", "svg", "vti"), 1):
            self.page.run("$('format').value = arguments[0]; $('save').click()", suffix)
            self.wait(f"document.body.dataset.files == {number}")
            self.assertTrue(self.page.run("return document.body.dataset.file").endswith("_view." + suffix))
            self.assertGreater(int(self.page.run("return document.body.dataset.bytes")), 1000)

    def test_no_phase_without_complex_fields(self):
        self.assertTrue(self.page.run("return $('phase').parentElement.hidden"))

    def test_failures_are_shown(self):
        self.page.run("$('field').value = 'nothing'; $('field').dispatchEvent(new Event('change'))")
        self.wait("document.body.dataset.failures == 1")
        self.assertIn("nothing", self.page.run("return $('message').textContent"))
        self.assertEqual(self.page.run("return $('field').value"), "u")
        self.server.stop()
        self.wait("$('state').textContent === 'not connected'")


class Phases(PageTest):
    options = ["--plane", "z=0.5"]

    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="pixelexact-")
        self.addCleanup(folder.cleanup)
        self.file = Path(folder.name) / "cube.vtu"
        fields = [("p_real", [p[0] for p in CUBE]), ("p_imag", [p[1] for p in CUBE])]
        self.file.write_text(unit_cube_grid(fields), encoding="utf-8")
        super().setUp()

    def test_controls(self):
        self.assertFalse(self.page.run("return $('phase').parentElement.hidden"))
        options = self.change("phase", "30")
        self.assertEqual((options["--phase"], options["--field"]), ("30", "p"))
        self.page.screenshot("phase.png")
        options = self.change("phaseslider", "75", "input")
        self.assertEqual((options["--phase"], options["--field"]), ("75", "p"))
        options = self.change("phase", "")
        self.assertEqual((options.get("--phase"), options["--field"]), (None, "p_real"))


class Phone(PageTest):
    width, height, touch = 390, 780, True

    def test_fits_and_pinches(self):
        self.assertLessEqual(self.page.run("return document.documentElement.scrollWidth"), self.width)
        x, y = self.middle()
        before = self.command()
        self.page.act(pointer("f", to(x, y), DOWN, to(x + 60, y + 10, 150), UP, kind="touch"))
        self.still()
        turned = self.command()
        self.assertNotEqual(turned, before)
        self.page.act(
            pointer("f", to(x - 30, y), DOWN, WAIT, to(x - 90, y, 200), UP, kind="touch"),
            pointer("g", to(x + 30, y), DOWN, WAIT, to(x + 90, y, 200), UP, kind="touch"),
        )
        self.still()
        self.assertNotEqual(self.command(), turned)
        self.page.screenshot("phone.png")


if __name__ == "__main__":
    unittest.main()
