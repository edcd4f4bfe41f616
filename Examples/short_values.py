#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Values, gradients and enclosures along a line, as a table. Usage: short_values.py [MESH [TABLE.csv]]"""

import sys
from pathlib import Path

import numpy as np
import pixelexact

DATA = Path(__file__).resolve().parent.parent / "Data"
mesh = sys.argv[1] if len(sys.argv) > 1 else DATA / "toroid_hex_g3_p6.vtu"
table = sys.argv[2] if len(sys.argv) > 2 else "values.csv"

grid = pixelexact.read(mesh)
lower, upper = np.array(grid.GetBounds()).reshape(3, 2).T
points = np.linspace(lower, upper, 1001)  # across the mesh, from corner to corner
found = pixelexact.probe(grid, None, points, gradients=True, enclosures=True)

inside = found.inside
columns = [points[inside], found.values[inside], found.lower[inside], found.upper[inside]]
columns += [found.gradients[inside], found.elements[inside]]
np.savetxt(
    table,
    np.column_stack(columns),
    delimiter=",",
    header=f"x,y,z,{found.field},lower,upper,d/dx,d/dy,d/dz,element",
    comments="",
    fmt="%.17g",
)
width = (found.upper - found.lower)[inside].max()
print(f"{inside.sum()} of {len(points)} points are inside; widest enclosure {width:.1e}")
print("wrote", table)
