#!/usr/bin/env python3
"""How long events wait in a window with a cut. Usage: latency.py [CASE...]

A second process moves the X server's pointer 60 times a second: it turns the scene, lets it go, then
hovers over the cut, whose values are read. The window is set as that of `pixelexact view`. Needs the
package, a display, libXtst, and the larger cases beside the project; prints a table.
"""

import ctypes
import math
import os
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

SHARED = Path(__file__).resolve().parent.parent.parent.parent / "shared" / "data"
CASES = ["mfem_escher_tet_21k_p3", "mfem_toroid_hex_g3_p16", "nek_ns_cylinder_paperscale_p3"]
SIZE = (800, 600)
MOVES, HOVERS, EVERY, PAUSE = 120, 60, 1.0 / 60.0, 2.0


def send(log):
    """Moves the pointer; writes where it was when, by the clock that all processes share."""
    x11, xtst = ctypes.CDLL("libX11.so.6"), ctypes.CDLL("libXtst.so.6")
    x11.XOpenDisplay.restype = ctypes.c_void_p
    display = ctypes.c_void_p(x11.XOpenDisplay(None))

    def move(x, y):
        xtst.XTestFakeMotionEvent(display, -1, int(x), int(y), 0)
        x11.XFlush(display)
        log.write(f"{int(x)} {int(y)} {time.monotonic()}\n")
        log.flush()

    def button(down):
        xtst.XTestFakeButtonEvent(display, 1, int(down), 0)
        x11.XFlush(display)
        log.write(f"{'press' if down else 'release'} 0 {time.monotonic()}\n")
        log.flush()

    middle = SIZE[0] // 2, SIZE[1] // 2
    move(*middle)
    time.sleep(PAUSE)
    button(True)
    for i in range(MOVES):
        # A spiral: no place twice.
        angle, radius = 0.1 * i, 20 + i
        move(middle[0] + radius * math.cos(angle), middle[1] + radius * math.sin(angle))
        time.sleep(EVERY)
    button(False)
    time.sleep(PAUSE)
    for i in range(HOVERS):
        move(middle[0] - 150 + 5 * i, middle[1] + 3)
        time.sleep(EVERY)
    time.sleep(PAUSE)


def files_of(folder):
    """A mesh and a field."""
    names = sorted(file for file in folder.iterdir() if file.is_file())
    for mesh, fields in ((".mesh", (".gf",)), (".xml", (".fld", ".chk")), (".vtu", ())):
        found = [file for file in names if file.suffix == mesh]
        if found:
            return found[0], [file for file in names if file.suffix in fields][:1]
    raise SystemExit(f"{folder}: no mesh")


def told(seconds):
    """Median, 99 % and the longest, in milliseconds."""
    if not seconds:
        return "-"
    ordered = sorted(1e3 * each for each in seconds)
    return f"{statistics.median(ordered):.0f}, {ordered[math.ceil(0.99 * len(ordered)) - 1]:.0f}, {ordered[-1]:.0f}"


def measure(name):
    import pixelexact
    import vtkmodules.vtkRenderingOpenGL2  # noqa: F401
    from vtkmodules.vtkInteractionStyle import vtkInteractorStyleTrackballCamera
    from vtkmodules.vtkRenderingCore import vtkRenderer, vtkRenderWindow, vtkRenderWindowInteractor

    mesh, fields = files_of(SHARED / name)
    cut = pixelexact.cut(pixelexact.read(mesh, *fields))
    renderer = vtkRenderer()
    renderer.AddActor(cut.actor)
    window = vtkRenderWindow()
    window.SetMultiSamples(0)
    window.SetSize(*SIZE)
    window.AddRenderer(renderer)
    interactor = vtkRenderWindowInteractor()
    interactor.SetRenderWindow(window)
    style = vtkInteractorStyleTrackballCamera()
    interactor.SetInteractorStyle(style)
    if hasattr(cut.mapper, "SetStillSeconds"):
        cut.mapper.SetStillSeconds(0.03)
        interactor.SetDesiredUpdateRate(1.0 / 0.03)
    else:
        window.AddObserver("AbortCheckEvent", lambda *_: window.GetEventPending() and window.SetAbortRender(1))
    picker = pixelexact.vtkHighOrderPicker()
    window.Render()
    window.SetPosition(0, 0)
    interactor.Initialize()

    # Renders are timed, for a style that turns the scene keeps its events to itself.
    held = {"turning": [], "still": [], "hovering": []}
    shown, exact, complete = [], [], []
    state = {"begin": 0.0, "hovering": False}

    def begin(*_):
        if not state["hovering"]:
            state["begin"] = time.monotonic()

    def rendered(*_):
        now = time.monotonic()
        kind = "turning" if style.GetState() else "hovering" if state["hovering"] else "still"
        held[kind].append(now - state["begin"])
        shown.append((kind, interactor.GetEventPosition(), now))
        if kind == "turning":
            exact.append(cut.mapper.IsFrameComplete())
        elif cut.mapper.IsFrameComplete():
            complete.append(now)

    def hover(*_):
        if not style.GetState():
            state["begin"], state["hovering"] = time.monotonic(), True
            picker.Pick(*interactor.GetEventPosition(), 0.0, renderer)
            window.Render()
            state["hovering"] = False

    def tick(*_):
        if sender.poll() is not None:
            interactor.ExitCallback()

    window.AddObserver("StartEvent", begin)
    window.AddObserver("EndEvent", rendered)
    interactor.AddObserver("MouseMoveEvent", hover, -1.0)
    interactor.AddObserver("TimerEvent", tick)
    interactor.CreateRepeatingTimer(100)
    with tempfile.NamedTemporaryFile("r", suffix=".txt") as log:
        sender = subprocess.Popen([sys.executable, __file__, "--send", log.name])
        interactor.Start()
        sent, released = {}, math.inf
        for line in log.read().splitlines():
            x, y, when = line.split()
            if x == "release":
                released = float(when)
            elif x != "press":
                sent[int(x), SIZE[1] - 1 - int(y)] = float(when)
    late = {kind: [now - sent[at] for which, at, now in shown if which == kind and at in sent]
        for kind in ("turning", "hovering")}
    until = 1e3 * (min((at for at in complete if at > released), default=math.nan) - released)
    print(f"| `{name}` | {told(held['turning'])} | {told(late['turning'])} | {sum(exact)} of {len(exact)} | "
        f"{until:.0f} | {told(held['still'])} | {told(held['hovering'])} | {told(late['hovering'])} |", flush=True)


def main():
    if sys.argv[1:2] == ["--send"]:
        with open(sys.argv[2], "w", encoding="utf-8") as log:
            send(log)
        return
    if sys.argv[1:2] == ["--measure"]:
        measure(sys.argv[2])
        return
    print(f"{SIZE[0]} x {SIZE[1]}, load {os.getloadavg()[0]:.1f}; ms: median, 99 %, longest")
    print("| case | turning: a render | event to picture | exact | let go: until exact | a render | "
        "hovering: pick and render | event to picture |")
    print("|---|---|---|---|---|---|---|---|")
    sys.stdout.flush()
    for name in sys.argv[1:] or CASES:
        # Each in a process of its own, as the window's connection goes with the window.
        subprocess.run([sys.executable, __file__, "--measure", name], check=True)


if __name__ == "__main__":
    main()
