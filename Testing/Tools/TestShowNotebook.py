# SPDX-License-Identifier: BSD-3-Clause
"""show in Jupyter's notebook, in headless Chromium. Where notebook, ipykernel and Chromium with its driver are."""

import importlib.util
import json
import os
import socket
import subprocess
import sys
import tempfile
import time
import unittest
import urllib.error
import urllib.request
from pathlib import Path

from chromium import CHROMIUM, DRIVER, UP, DOWN, WAIT, Chromium, pointer, to
from tool import case

TORUS = case("toroid_hex_g3_p6")
MISSING = [name for name in ("notebook", "ipykernel") if importlib.util.find_spec(name) is None]
MISSING += [name for name, found in (("chromium", CHROMIUM), ("chromedriver", DRIVER)) if not found]
TOKEN = "0123456789abcdef"
FRAME = "div.output_area iframe"


def free_port():
    with socket.socket() as one:
        one.bind(("127.0.0.1", 0))
        return one.getsockname()[1]


@unittest.skipIf(MISSING, f"not installed: {', '.join(MISSING)}")
class Notebook(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="pixelexact-")
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        cells = [f"import pixelexact\nshown = pixelexact.show({str(TORUS)!r}, 'u', plane='z=40%', contours=9, size=(800, 480))\nshown"]
        self.file = self.folder / "page.ipynb"
        self.file.write_text(json.dumps({
            "cells": [{"cell_type": "code", "execution_count": None, "metadata": {}, "outputs": [], "source": cell} for cell in cells],
            "metadata": {"kernelspec": {"display_name": "Python 3", "language": "python", "name": "python3"}},
            "nbformat": 4, "nbformat_minor": 4}), encoding="utf-8")
        self.port = free_port()
        command = [sys.executable, "-m", "notebook", "--no-browser", "--allow-root", "--ip=127.0.0.1", f"--port={self.port}",
                   "--port-retries=0", f"--NotebookApp.token={TOKEN}", f"--notebook-dir={self.folder}"]
        # Jupyter's own files stay in the folder.
        environment = {**os.environ, "HOME": str(self.folder), "JUPYTER_RUNTIME_DIR": str(self.folder / "runtime")}
        self.log = open(self.folder / "log.txt", "w+", encoding="utf-8")
        self.addCleanup(self.log.close)
        self.jupyter = subprocess.Popen(command, env=environment, stdout=self.log, stderr=subprocess.STDOUT)
        self.addCleanup(self.stop)
        self.wait_for_jupyter()
        self.page = Chromium(1200, 900)
        self.addCleanup(self.page.close)

    def wait_for_jupyter(self):
        end = time.monotonic() + 60
        while True:
            try:
                urllib.request.urlopen(f"http://127.0.0.1:{self.port}/api?token={TOKEN}", timeout=30).close()
                return
            except (urllib.error.URLError, ConnectionError):
                if self.jupyter.poll() is not None or time.monotonic() > end:
                    self.log.seek(0)
                    self.fail(f"Jupyter does not start: {self.log.read()}")
                time.sleep(0.1)

    def stop(self):
        # With SIGTERM it ends its kernels, and these the servers of pages.
        self.jupyter.terminate()
        self.jupyter.wait(timeout=60)

    def open(self):
        self.page.open(f"http://127.0.0.1:{self.port}/notebooks/page.ipynb?token={TOKEN}")
        self.page.wait("window.Jupyter && Jupyter.notebook && Jupyter.notebook.kernel && Jupyter.notebook.kernel.is_connected()")

    def saved_output(self):
        cell = json.loads(self.file.read_text(encoding="utf-8"))["cells"][0]
        return cell["outputs"][0]["data"] if cell["outputs"] else None

    def test_page_in_a_notebook(self):
        self.open()
        self.page.run("Jupyter.notebook.execute_all_cells()")
        self.page.wait(f"document.querySelector('{FRAME}')", note="document.body.innerText")
        address = self.page.run(f"return document.querySelector('{FRAME}').src")
        self.page.enter_frame(FRAME)
        self.page.wait("document.body.dataset.exact > 0", note="document.body.innerText")
        before = self.page.run("return state.command")
        x, y = self.page.run("const b = canvas.getBoundingClientRect(); return [b.x + b.width / 2, b.y + b.height / 2]")
        self.page.act(pointer("m", to(x, y), WAIT, DOWN, to(x + 60, y + 20, 150), UP))
        self.page.wait(f"state.command !== {json.dumps(before)}", note="state.command")
        self.page.enter_frame(None)
        self.page.screenshot("notebook.png")
        self.page.run("Jupyter.notebook.save_checkpoint()")
        self.page.wait("!Jupyter.notebook.dirty")
        data = self.saved_output()
        self.assertIn("image/png", data)
        self.assertIn("data:image/png;base64,", "".join(data["text/html"]))
        # Without a kernel the picture stays, also where the address leads nowhere.
        self.page.run("Jupyter.notebook.kernel.restart()")
        self.wait_until_gone(address)
        self.open()
        self.page.wait("document.querySelector('div.output_area img') && document.querySelector('div.output_area img').naturalWidth == 800",
                       note="document.body.innerText")
        self.assertFalse(self.page.run(f"return Boolean(document.querySelector('{FRAME}'))"))
        self.page.screenshot("notebook-saved.png")

    def wait_until_gone(self, address):
        """The end of the kernel ends the server of its page."""
        end = time.monotonic() + 60
        while time.monotonic() < end:
            try:
                urllib.request.urlopen(address, timeout=30).close()
            except (urllib.error.URLError, ConnectionError):
                return
            time.sleep(0.2)
        self.fail("the server of the page outlives the kernel")


if __name__ == "__main__":
    unittest.main()
