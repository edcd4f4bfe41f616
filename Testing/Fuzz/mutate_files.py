#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Opens files with changed or missing bytes: 200 of each kind.

    mutate_files.py TOOL [COUNT]     TOOL: build/bin/pixelexact

The fuzzers leave the HDF5 library and VTK out, so the readers of VTKHDF, FLEXI, HOPR and Exodus are
tested by this script, and those of Nek5000 and of MFEM's quadrature functions with the rest of the
program. A file may be read, or refused with exit status 1. Where the program ends otherwise, takes
more than two minutes or more than 2 GB, the file is kept in the working folder, and the exit status
is 1.
"""

import random
import resource
import shutil
import subprocess
import sys
import tempfile
from collections import Counter
from pathlib import Path

import numpy as np

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "Testing" / "Tools"))
from exodus import exodus  # noqa: E402
from flexi import write_mesh, write_state  # noqa: E402
from nek5000 import grid, step_bytes  # noqa: E402
from vtkhdf import example  # noqa: E402

MAX_MEMORY = 2 << 20  # kB
SQUARE = "MFEM mesh v1.0\ndimension\n2\nelements\n1\n1 3 0 1 2 3\nboundary\n0\nvertices\n4\n2\n0 0\n1 0\n1 1\n0 1\n"
QUADRATURE = "QuadratureSpace\nType: default_quadrature\nOrder: 3\nVDim: 1\n\n1\n2\n3\n4\n"


def mutated(whole, kind, chance):
    """Kinds 0 to 2 change 1, 8 or 40 bytes; kind 3 cuts the file."""
    if kind == 3:
        return whole[:chance.randrange(len(whole))]
    changed = bytearray(whole)
    for _ in range([1, 8, 40][kind]):
        changed[chance.randrange(len(whole))] = chance.choice([0, 128, 255, chance.randrange(256)])
    return bytes(changed)


def files(folder):
    """The files that are changed, each with the command's arguments."""
    names = ("box_State_0.h5", "box_mesh.h5", "grid.vtkhdf", "step0.f00000", "shells.e", "s.mesh", "q.gf")
    state, mesh, hdf, nek, shells, square, quadrature = (folder / name for name in names)
    write_mesh(mesh, (2, 1, 1), 2)
    write_state(state, (2, 1, 1), 3, {"a": lambda x, y, z: x, "b": lambda x, y, z: y}, ElemData=np.zeros((2, 1)),
                VarNamesAdd=["e"])
    example(hdf)
    nek.write_bytes(step_bytes(grid((2, 1, 1), 4), 4, [("U", lambda x, y, z: [x, y, z]), ("P", lambda x, y, z: x)]))
    points = [[0, 0, 0], [1, 0, 0], [1, 1, 1], [0, 1, 1], [3, 0, 0], [4, 0, 0], [3, 1, 0], [3, 0, 1]]
    shells.write_bytes(exodus(points, [(7, "SHELL4", [[0, 1, 2, 3]]), (3, "TETRA4", [[4, 5, 6, 7]])],
                              [("u", [float(x) for x, _, _ in points])]))
    square.write_text(SQUARE, encoding="utf-8")
    quadrature.write_text(QUADRATURE, encoding="utf-8")
    return [(hdf, [hdf, "--time-step", "2"]), (state, [state]), (mesh, [state]), (nek, [nek]),
            (shells, [shells, "--surface-elements"]), (quadrature, [square, quadrature])]


def main(tool, count):
    chance = random.Random(5)
    done = Counter()
    with tempfile.TemporaryDirectory() as name:
        for file, arguments in files(Path(name)):
            whole = file.read_bytes()
            for number in range(count):
                file.write_bytes(mutated(whole, number % 4, chance))
                before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss
                try:
                    status = subprocess.run([tool, "info", *arguments], capture_output=True, timeout=120,
                                            check=False).returncode
                except subprocess.TimeoutExpired:
                    status = "timeout"
                if MAX_MEMORY < resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss > before:
                    status = "memory"
                done[file.name, status] += 1
                if status not in (0, 1):
                    shutil.copy(file, f"bad{number}_{file.name}")
            file.write_bytes(whole)
    for (file, status), number in sorted(done.items(), key=str):
        print(f"{file}: {number} with status {status}")
    print(f"largest memory: {resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss // 1024} MB")
    return int(any(status not in (0, 1) for _, status in done))


if __name__ == "__main__":
    sys.exit(main(sys.argv[1], int(sys.argv[2]) if len(sys.argv) > 2 else 200))
