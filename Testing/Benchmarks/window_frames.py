#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Times of frames while gestures drive the window of pixelexact view, and a screenshot of each.

    with-display.sh window_frames.py TOOL FOLDER INPUT... [options of view]

TOOL: the program pixelexact, beside pixelexact-view; FOLDER: of the screenshots. A frame's time is
the interval between two calls of glXSwapBuffers while xdotool moves the pointer 100 times a second.
The table has the median and the longest of each gesture, and the time from the release of the
button to the last frame. Run it without other work. Needs xdotool, cc, Pillow and NumPy.
"""

import os
import re
import shlex
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import numpy as np
from PIL import ImageGrab

MOVES = 120
PAUSE = 0.01  # seconds between two movements
MARK = (40, 100, 180)  # colour of sliders
LISTENER = """
#define _GNU_SOURCE
#include <dlfcn.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>
void glXSwapBuffers(void* display, unsigned long window)
{
  static void (*swap)(void*, unsigned long);
  static FILE* out;
  if (!swap)
  {
    swap = (void (*)(void*, unsigned long))dlsym(RTLD_NEXT, "glXSwapBuffers");
    out = fopen(getenv("SWAPS"), "w");
  }
  swap(display, window);
  struct timespec now;
  clock_gettime(CLOCK_MONOTONIC, &now);
  fprintf(out, "%.6f\\n", now.tv_sec + 1e-9 * now.tv_nsec);
  fflush(out);
}
"""


def xdotool(*words):
    return subprocess.run(["xdotool", *map(str, words)], stdout=subprocess.PIPE, text=True, check=False).stdout


def screen():
    return np.asarray(ImageGrab.grab(xdisplay=os.environ["DISPLAY"]).convert("RGB")).astype(int)


class Window:
    def __init__(self, tool, pictures, words, folder):
        self.pictures = pictures
        self.swaps = folder / "swaps.txt"
        self.out = folder / "out.txt"
        source = folder / "listener.c"
        source.write_text(LISTENER, encoding="utf-8")
        library = source.with_suffix(".so")
        subprocess.run(["cc", "-shared", "-fPIC", "-o", library, source, "-ldl"], check=True)
        # Not for the tool itself, which starts the window.
        environment = dict(os.environ, LD_PRELOAD=str(library), SWAPS=str(self.swaps))
        program = Path(tool).with_name("pixelexact-view")
        self.process = subprocess.Popen(
            [program, "view", *words], env=environment, stdout=open(self.out, "w", encoding="utf-8"))
        while not xdotool("search", "--name", "^PixelExact$"):
            if self.process.poll() is not None:
                sys.exit("the window did not open")
            time.sleep(0.2)
        xdotool("windowmove", xdotool("search", "--name", "^PixelExact$").split()[-1], 0, 0)
        self.settle()

    def times(self):
        return np.array(self.swaps.read_text(encoding="utf-8").split(), dtype=float)

    def settle(self):
        """Waits until there is no frame for 3 seconds."""
        time.sleep(3)
        while time.monotonic() - self.times()[-1] < 3:
            time.sleep(0.3)

    def options(self):
        before = self.out.read_text(encoding="utf-8")
        xdotool("key", "c")
        while self.out.read_text(encoding="utf-8") == before:
            time.sleep(0.1)
        line = self.out.read_text(encoding="utf-8").splitlines()[-1]
        return dict(w[2:].split("=", 1) for w in shlex.split(line) if w.startswith("--") and "=" in w)

    def ball(self):
        """The lowest orange ball in the window, which moves a plane that lies below its arrow."""
        orange = np.abs(screen() - (240, 120, 20)).sum(axis=2) < 100
        wide = orange[:, :-4] & orange[:, 4:] & np.roll(orange, -4, axis=0)[:, 2:-2]
        places = np.argwhere(wide)
        return (int(places[-1][1]) + 2, int(places[-1][0])) if len(places) else None

    def knobs(self):
        width = int(re.match(r"\d+", self.options()["size"])[0])
        mark = np.abs(screen()[:, width:] - MARK).sum(axis=2) < 30
        counts = mark.sum(axis=1)
        rows = [y for y in range(1, len(counts)) if 3 <= counts[y] <= 30 and not 3 <= counts[y - 1] <= 30]
        return [(width + int(np.flatnonzero(mark[y + 2]).mean()), y + 4) for y in rows if mark[y + 2].any()]

    def measure(self, name, at, by, button=True):
        self.settle()
        xdotool("mousemove", *at)
        time.sleep(1)
        if button:
            xdotool("mousedown", 1)
        words = []
        for k in range(1, MOVES + 1):
            part = np.sin(2 * np.pi * k / MOVES)
            words += ["mousemove", round(at[0] + by[0] * part), round(at[1] + by[1] * part), "sleep", PAUSE]
        begin = time.monotonic()
        xdotool(*words)
        end = time.monotonic()
        ImageGrab.grab(xdisplay=os.environ["DISPLAY"]).save(self.pictures / f"{name}.png")
        if button:
            xdotool("mouseup", 1)
        self.settle()
        times = self.times()
        frames = np.diff(times[(times > begin) & (times < end)]) * 1e3
        last = max(0.0, times[-1] - end)
        if len(frames) == 0:
            print(f"{name:10} {0:6}")
            return
        print(f"{name:10} {len(frames):6} {np.median(frames):10.1f} {frames.max():11.1f} {last:10.2f}", flush=True)

    def key(self, name, key):
        self.settle()
        begin = time.monotonic()
        xdotool("key", key)
        self.settle()
        times = self.times()
        last = times[times > begin]
        ImageGrab.grab(xdisplay=os.environ["DISPLAY"]).save(self.pictures / f"{name}.png")
        print(f"{name:10} {len(last):6} {'':10} {'':11} {last[-1] - begin if len(last) else 0:10.2f}", flush=True)


def main():
    tool, pictures, *words = sys.argv[1:]
    Path(pictures).mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory() as folder:
        window = Window(tool, Path(pictures), words, Path(folder))
        print(f"{'gesture':10} {'frames':>6} {'median ms':>10} {'longest ms':>11} {'complete s':>10}")
        width, height = (int(n) for n in window.options()["size"].split("x"))
        middle = (round(0.27 * width), round(0.48 * height))
        window.measure("hover", middle, (80, 40), button=False)
        window.measure("camera", middle, (80, 40))
        if ball := window.ball():
            window.measure("handle", ball, (0, 50))
        for number, knob in enumerate(window.knobs()):
            window.measure(f"slider-{number}", knob, (50, 0))
        for name, key in [("contours", "l"), ("edges", "e"), ("outline", "o"), ("range", "r"), ("field", "f"),
            ("help", "h")]:
            window.key(name, key)
        xdotool("key", "q")
        window.process.wait()


if __name__ == "__main__":
    main()
