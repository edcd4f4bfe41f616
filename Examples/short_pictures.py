#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Planes through a field, and what they show. Needs no display. Usage: short_pictures.py [FOLDER [WIDTH]]"""

import sys
from pathlib import Path

import numpy as np
import pixelexact

DATA = Path(__file__).resolve().parent.parent / "Data"
folder = Path(sys.argv[1] if len(sys.argv) > 1 else "pictures")
width = int(sys.argv[2]) if len(sys.argv) > 2 else 600
folder.mkdir(parents=True, exist_ok=True)

grid = pixelexact.read(DATA / "toroid_hex_g3_p6.vtu")
for z in (-0.2, -0.1, 0.0, 0.1, 0.2):
    picture = pixelexact.render(
        grid,
        "u",
        normal="z",
        origin=z,
        clim=(-0.85, 0.85),
        contours=9,
        edges=True,
        size=(width, width),
        output=folder / f"z{z:+.1f}.png",
    )
    values = picture.values[picture.verdicts == 1]
    unknown = np.count_nonzero(picture.verdicts == 2)
    print(f"z = {z:+.1f}: {values.min():+.6f} to {values.max():+.6f}, {unknown} pixels unknown")
