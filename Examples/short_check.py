#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Is it what the solver says? Values of Data's solutions against those that their solvers wrote.

Usage: short_check.py
"""

import csv
from pathlib import Path

import numpy as np
import pixelexact

DATA = Path(__file__).resolve().parent.parent / "Data"
for table in sorted(DATA.glob("*.oracle.csv")):
    mesh = DATA / table.name.replace(".oracle.csv", ".vtu")
    with open(table, encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    if not mesh.exists() or "u" not in rows[0]:
        continue
    points = np.array([[float(row[key]) for key in "xyz"] for row in rows])
    solver = np.array([float(row["u"]) for row in rows])
    found = pixelexact.probe(mesh, "u", points)
    worst = np.abs(found.values - solver).max()
    print(f"{mesh.name}: {len(rows)} points, largest difference {worst:.1e}")
