#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Opens HDF5 files with changed or missing bytes: 200 of each format.

    mutate_hdf5.py TOOL [COUNT]     TOOL: build/bin/pixelexact

The fuzzers leave the HDF5 library out, so the readers of VTKHDF, FLEXI and HOPR are tested by this
script. A file may be read, or refused with exit status 1. Where the program ends otherwise or takes
more than two minutes, the file is kept in the working folder, and the exit status is 1.
"""

import random
import shutil
import subprocess
import sys
import tempfile
from collections import Counter
from pathlib import Path

import numpy as np

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "Testing" / "Tools"))
from flexi import write_mesh, write_state  # noqa: E402
from vtkhdf import example  # noqa: E402


def mutated(whole, kind, chance):
    """Kinds 0 to 2 change 1, 8 or 40 bytes; kind 3 cuts the file."""
    if kind == 3:
        return whole[:chance.randrange(len(whole))]
    changed = bytearray(whole)
    for _ in range([1, 8, 40][kind]):
        changed[chance.randrange(len(whole))] = chance.choice([0, 128, 255, chance.randrange(256)])
    return bytes(changed)


def main(tool, count):
    chance = random.Random(5)
    done = Counter()
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        state, mesh, grid = folder / "box_State_0.h5", folder / "box_mesh.h5", folder / "grid.vtkhdf"
        write_mesh(mesh, (2, 1, 1), 2)
        write_state(state, (2, 1, 1), 3, {"a": lambda x, y, z: x, "b": lambda x, y, z: y}, ElemData=np.zeros((2, 1)),
                    VarNamesAdd=["e"])
        example(grid)
        for file, arguments in [(grid, [grid, "--time-step", "2"]), (state, [state]), (mesh, [state])]:
            whole = file.read_bytes()
            for number in range(count):
                file.write_bytes(mutated(whole, number % 4, chance))
                try:
                    status = subprocess.run([tool, "info", *arguments], capture_output=True, timeout=120,
                                            check=False).returncode
                except subprocess.TimeoutExpired:
                    status = "timeout"
                done[file.name, status] += 1
                if status not in (0, 1):
                    shutil.copy(file, f"bad{number}_{file.name}")
            file.write_bytes(whole)
    for (file, status), number in sorted(done.items(), key=str):
        print(f"{file}: {number} with status {status}")
    return int(any(status not in (0, 1) for _, status in done))


if __name__ == "__main__":
    sys.exit(main(sys.argv[1], int(sys.argv[2]) if len(sys.argv) > 2 else 200))
