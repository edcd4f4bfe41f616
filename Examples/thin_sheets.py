#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Two sheets of an iso-surface that lie close together, exact and by linear pieces.

w = (z - 0.15 x)^2 is a polynomial that the mesh's elements of order 6 hold exactly: w = 0.00001 are
two planes, 0.0063 apart, in a mesh of size 2.8. Cut into linear cells, as for vtkContourFilter, the
field has few corners at which w is that small, and most of the sheets are lost.

Usage: thin_sheets.py [IMAGE.png [WIDTHxHEIGHT]]
Prints the pixels that the linear surfaces lack; from left to right the picture has the exact one,
and those of elements cut into 8^3 and 16^3 cells.
"""

import csv
import os
import subprocess
import sys
import tempfile
from pathlib import Path

from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkFiltersCore import vtkImageAppend
from vtkmodules.vtkIOImage import vtkPNGReader, vtkPNGWriter
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader, vtkXMLUnstructuredGridWriter

ROOT = Path(__file__).resolve().parent.parent
MESH = ROOT / "Data" / "toroid_hex_g3_p6.vtu"
TOOL = os.environ.get("PIXELEXACT_TOOL", ROOT / "build" / "bin" / "pixelexact")
LEVELS = (3, 4)  # each edge of an element becomes 2^level


def write_field(path):
    """The mesh with w at its nodes."""
    reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(str(MESH))
    reader.Update()
    grid = reader.GetOutput()
    x = vtk_to_numpy(grid.GetPoints().GetData())
    w = numpy_to_vtk((x[:, 2] - 0.15 * x[:, 0]) ** 2, deep=True)
    w.SetName("w")
    grid.GetPointData().AddArray(w)
    writer = vtkXMLUnstructuredGridWriter()
    writer.SetFileName(str(path))
    writer.SetInputData(grid)
    writer.Write()


def side_by_side(images, path):
    append = vtkImageAppend()
    for image in images:
        reader = vtkPNGReader()
        reader.SetFileName(str(image))
        append.AddInputConnection(reader.GetOutputPort())
    writer = vtkPNGWriter()
    writer.SetFileName(str(path))
    writer.SetInputConnection(append.GetOutputPort())
    writer.Write()


def main():
    image = sys.argv[1] if len(sys.argv) > 1 else "thin_sheets.png"
    size = sys.argv[2] if len(sys.argv) > 2 else "400x240"
    with tempfile.TemporaryDirectory() as folder:
        mesh, report = Path(folder) / "sheets.vtu", Path(folder) / "report"
        write_field(mesh)
        command = [TOOL, "compare", mesh, "--field", "u", "--isosurface", "w=0.00001"]
        command += ["--levels", ",".join(map(str, LEVELS)), "--truncate-orders", "none"]
        command += ["--camera-position", "1.9,-2.3,1.4", "--focal-point", "-0.05,0,-0.05"]
        command += ["--view-up", "0,0,1", "--view-angle", "33", "--colormap", "coolwarm"]
        command += ["--size", size, "--repeat", "1", "--quiet", "--output", report]
        subprocess.run(list(map(str, command)), check=True)
        with open(report / "trade.csv", encoding="utf-8") as table:
            rows = {row["setting"]: row for row in csv.DictReader(table)}
        shown = ["exact"] + [f"subdivide-{level}" for level in LEVELS]
        exact = rows["exact"]
        print(f"exact: {exact['shown']} pixels, first in {float(exact['first_seconds']):.1f} s")
        for name in shown[1:]:
            row = rows[name]
            share = int(row["missing"]) / int(row["shown"])
            print(f"{name}: {row['triangles']} triangles, {share:.1%} of the pixels missing")
        side_by_side([report / f"{name}.png" for name in shown], image)


if __name__ == "__main__":
    main()
