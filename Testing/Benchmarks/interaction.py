#!/usr/bin/env python3
"""What somebody who drags a cut in a window waits for. Usage: interaction.py [REPEAT]

Needs the package, a display, and the larger cases beside the project; prints a table.
"""

import os
import statistics
import sys
import time
from pathlib import Path

import pixelexact
import vtkmodules.vtkInteractionStyle  # noqa: F401
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401
from vtkmodules.vtkRenderingCore import vtkRenderer, vtkRenderWindow, vtkRenderWindowInteractor

SHARED = Path(__file__).resolve().parent.parent.parent.parent / "shared" / "data"
CASES = [
    ("mfem_escher_tet_21k_p3", "21,504 curved tetrahedra, order 3"),
    ("mfem_toroid_hex_g3_p16", "curved hexahedra, order 16"),
    ("nek_ns_cylinder_paperscale_p3", "prisms and hexahedra of Nektar++, order 3"),
]
SIZE = (800, 600)
RATE = 15.0  # frames a second, as VTK's interactors want them while somebody drags


def files_of(folder):
    """A mesh and its fields."""
    names = sorted(file for file in folder.iterdir() if file.is_file())
    for mesh, fields in ((".mesh", (".gf",)), (".xml", (".fld", ".chk")), (".vtu", ())):
        found = [file for file in names if file.suffix == mesh]
        if found:
            beside = [file for file in names if file.suffix in fields]
            return found[0], beside[:1]
    raise SystemExit(f"{folder}: no mesh")


def seconds(work):
    begin = time.perf_counter()
    work()
    return time.perf_counter() - begin


def both(times):
    return f"{1e3 * min(times):.0f}, {1e3 * statistics.median(times):.0f}"


def main():
    repeat = int(sys.argv[1]) if len(sys.argv) > 1 else 20
    print(f"{SIZE[0]} x {SIZE[1]}, {pixelexact.get_threads()} threads, load {os.getloadavg()[0]:.1f}")
    print("Least time, and the median of what was repeated.")
    print("| case | read, s | first picture, s | dragged, ms | exact | released, ms | recoloured, ms |")
    print("|---|---|---|---|---|---|---|")
    for name, what in CASES:
        mesh, fields = files_of(SHARED / name)
        grid = None

        def read():
            nonlocal grid
            grid = pixelexact.read(mesh, *fields)

        reading = seconds(read)
        cut = pixelexact.cut(grid)
        renderer = vtkRenderer()
        renderer.AddActor(cut.actor)
        window = vtkRenderWindow()
        window.SetOffScreenRendering(True)
        window.SetMultiSamples(0)
        window.SetSize(*SIZE)
        window.AddRenderer(renderer)
        interactor = vtkRenderWindowInteractor()
        interactor.SetRenderWindow(window)
        window.SetDesiredUpdateRate(1e-4)
        first = seconds(window.Render)
        camera = renderer.GetActiveCamera()
        dragged, exact, released = [], 0, []
        for i in range(repeat):
            window.SetDesiredUpdateRate(RATE)
            camera.Azimuth(2.0)
            camera.Elevation(1.0 if i % 2 else -1.0)
            renderer.ResetCameraClippingRange()
            dragged.append(seconds(window.Render))
            exact += cut.mapper.IsFrameComplete()
            window.SetDesiredUpdateRate(1e-4)
            released.append(seconds(window.Render))
            assert cut.mapper.IsFrameComplete()
        recoloured = []
        for i in range(repeat):
            cut.mapper.SetColorMap("plasma" if i % 2 else "viridis")
            recoloured.append(seconds(window.Render))
        print(
            f"| {name} ({what}) | {reading:.2f} | {first:.2f} | {both(dragged)} | "
            f"{exact} of {repeat} | {both(released)} | {both(recoloured)} |",
            flush=True,
        )


if __name__ == "__main__":
    main()
