# SPDX-License-Identifier: BSD-3-Clause
"""The page of serve in headless Chromium: each control does what it says. Where Chromium and its driver are.

PIXELEXACT_SCREENSHOTS=FOLDER keeps pictures of the page.
"""

import base64
import json
import os
import shutil
import subprocess
import tempfile
import time
import unittest
import urllib.request
from pathlib import Path

from browser import Server
from tool import case

TORUS = case("toroid_hex_g3_p6")
DRIVER = shutil.which("chromedriver")
CHROMIUM = shutil.which("chromium")
SCREENSHOTS = os.environ.get("PIXELEXACT_SCREENSHOTS")


class Chromium:
    """A browser driven by the W3C's WebDriver protocol."""

    def __init__(self, width, height, touch=False):
        self.profile = tempfile.mkdtemp(prefix="pixelexact-")
        self.driver = subprocess.Popen([DRIVER, "--port=0"], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        port = None
        for line in self.driver.stdout:
            if "started successfully on port" in line:
                port = int(line.rstrip(" .\n").rsplit(" ", 1)[1])
                break
        self.base = f"http://127.0.0.1:{port}"
        chrome = {
            "binary": CHROMIUM,
            "args": ["--headless=new", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage",
                     f"--window-size={width},{height}", f"--user-data-dir={self.profile}"],
            "prefs": {"download.default_directory": self.profile},
        }
        if touch:
            chrome["mobileEmulation"] = {"deviceMetrics": {"width": width, "height": height, "pixelRatio": 2, "touch": True}}
        answer = self._call("/session", {"capabilities": {"alwaysMatch": {"goog:chromeOptions": chrome}}})
        self.base += "/session/" + answer["sessionId"]

    def _call(self, path, body=None):
        data = None if body is None else json.dumps(body).encode()
        with urllib.request.urlopen(urllib.request.Request(self.base + path, data=data), timeout=120) as answer:
            return json.load(answer)["value"]

    def open(self, address):
        self._call("/url", {"url": address})

    def run(self, script, *arguments):
        return self._call("/execute/sync", {"script": script, "args": list(arguments)})

    def act(self, *sources):
        self._call("/actions", {"actions": list(sources)})

    def screenshot(self, name):
        content = base64.b64decode(self._call("/screenshot"))
        if SCREENSHOTS:
            Path(SCREENSHOTS, name).write_bytes(content)
        return content

    def close(self):
        try:
            urllib.request.urlopen(urllib.request.Request(self.base, method="DELETE"), timeout=60).close()
        finally:
            self.driver.terminate()
            self.driver.communicate()
            shutil.rmtree(self.profile, ignore_errors=True)


def pointer(name, *steps, kind="mouse"):
    return {"type": "pointer", "id": name, "parameters": {"pointerType": kind}, "actions": list(steps)}


def to(x, y, duration=0):
    return {"type": "pointerMove", "x": int(x), "y": int(y), "duration": duration}


DOWN = {"type": "pointerDown", "button": 0}
UP = {"type": "pointerUp", "button": 0}
WAIT = {"type": "pause", "duration": 50}


@unittest.skipUnless(DRIVER and CHROMIUM, "chromium or chromium-driver is not installed")
class PageTest(unittest.TestCase):
    width, height, touch = 1200, 800, False
    options = ["--plane", "z=40%", "--field", "u"]

    def setUp(self):
        self.server = Server(TORUS, *self.options)
        self.addCleanup(self.server.stop)
        self.page = Chromium(self.width, self.height, self.touch)
        self.addCleanup(self.page.close)
        self.page.open(self.server.address)
        self.wait("document.body.dataset.exact > 0")

    def wait(self, condition, seconds=60):
        end = time.monotonic() + seconds
        while not self.page.run(f"return Boolean({condition})"):
            if time.monotonic() > end:
                self.fail(f"{condition}: {self.page.run('return $(`message`).textContent')}")
            time.sleep(0.02)

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

    def test_failures_are_shown(self):
        self.page.run("$('field').value = 'nothing'; $('field').dispatchEvent(new Event('change'))")
        self.wait("document.body.dataset.failures == 1")
        self.assertIn("nothing", self.page.run("return $('message').textContent"))
        self.assertEqual(self.page.run("return $('field').value"), "u")
        self.server.stop()
        self.wait("$('state').textContent === 'not connected'")


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
