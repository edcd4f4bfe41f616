# SPDX-License-Identifier: BSD-3-Clause
"""Headless Chromium, driven by the W3C's WebDriver protocol.

PIXELEXACT_SCREENSHOTS=FOLDER keeps pictures of pages.
"""

import base64
import json
import os
import shutil
import subprocess
import tempfile
import time
import urllib.request
from pathlib import Path

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

    def wait(self, condition, seconds=60, note="''"):
        """Waits until the JavaScript expression is true. Throws AssertionError with the value of `note`."""
        end = time.monotonic() + seconds
        while not self.run(f"return Boolean({condition})"):
            if time.monotonic() > end:
                raise AssertionError(f"{condition}: {self.run(f'return {note}')}")
            time.sleep(0.02)

    def enter_frame(self, selector):
        """Scripts run in the frame that the CSS selector finds; None: in the page."""
        frame = None if selector is None else self._call("/element", {"using": "css selector", "value": selector})
        self._call("/frame", {"id": frame})

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
