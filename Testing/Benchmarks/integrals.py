#!/usr/bin/env python3
"""Integrals over planes across z: proven bounds, sums over pixels, and linear cells.

Usage: integrals.py PIXELEXACT FOLDER-OF-FIELDS [TOLERANCE]

Prints a table in Markdown. Pixel sums take the values of `render --buffers` in a parallel view,
each times a pixel's area: what the integrals would be if each pixel were of one value.
"""

import json
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLImageDataReader

EXACT = 1
# Files, field, plane across z, and half of the side that holds the cut.
CASES = [
    (["mfem_toroid_hex_g3_p6/mfem_toroid_hex_g3_p6.mesh", "mfem_toroid_hex_g3_p6/u.gf"],
     "u", "z=0.1", 1.6),
    (["mfem_toroid_prism_g3_p4/mfem_toroid_prism_g3_p4.mesh", "mfem_toroid_prism_g3_p4/u.gf"],
     "u", "z=0.05", 1.6),
    (["mfem_escher_tet_p8/mfem_escher_tet_p8.mesh", "mfem_escher_tet_p8/u.gf"], "u", "z=0.1", 4.0),
    (["mfem_fichera_hex_g3_p4/mfem_fichera_hex_g3_p4.mesh", "mfem_fichera_hex_g3_p4/u.gf"],
     "u", "z=0.3", 1.5),
    (["nek_ns_kovasznay_tet_p9/nek_ns_kovasznay_tet_p9.xml",
      "nek_ns_kovasznay_tet_p9/nek_ns_kovasznay_tet_p9.fld"], "u", "z=0.3", 3.0),
    (["nek_ns_cylinder_hexprism_p4/nek_ns_cylinder_hexprism_p4.xml",
      "nek_ns_cylinder_hexprism_p4/nek_ns_cylinder_hexprism_p4.fld"], "p", "z=0.7", 12.0),
]
SIZES = [500, 1000, 2000]


def tool(program, *arguments):
    done = subprocess.run([program, *map(str, arguments), "--json", "--quiet"],
                          capture_output=True, text=True, check=False)
    if done.returncode != 0:
        sys.exit(done.stderr)
    return json.loads(done.stdout)


def pixels(program, files, field, plane, scale, size):
    with tempfile.TemporaryDirectory() as folder:
        buffers = Path(folder) / "cut.vti"
        tool(program, "render", *files, "--field", field, "--plane", plane, "--view", "+z",
             "--parallel-scale", scale, "--size", f"{size}x{size}", "--lights", "off",
             "--output", Path(folder) / "cut.png", "--buffers", buffers, "--arrays",
             "Value,Verdict")
        reader = vtkXMLImageDataReader()
        reader.SetFileName(str(buffers))
        reader.Update()
        data = reader.GetOutput().GetPointData()
        value = vtk_to_numpy(data.GetArray("Value"))
        inside = np.isfinite(value) & (vtk_to_numpy(data.GetArray("Verdict")) == EXACT)
    pixel = (2.0 * scale / size) ** 2
    return inside.sum() * pixel, value[inside].sum() * pixel


def main():
    program, data = sys.argv[1], Path(sys.argv[2])
    tolerance = sys.argv[3] if len(sys.argv) > 3 else "1e-6"
    print("| case | quantity | value | bound | pixels, off at", ", ".join(map(str, SIZES)),
          "| linear, level 2, off | elements | boxes | seconds |")
    print("|---|---|---|---|---|---|---|---|---|")
    for names, field, plane, scale in CASES:
        files = [data / name for name in names]
        found = tool(program, "integrate", *files, "--field", field, "--plane", plane,
                     "--tolerance", tolerance, "--seconds", 60, "--linear", 2)
        surface = found["surfaces"][0]
        rows = {row["quantity"]: row for row in surface["rows"]}
        sums = [pixels(program, files, field, plane, scale, size) for size in SIZES]
        for k, quantity in enumerate(["Area", "Integral"]):
            row = rows[quantity]
            off = ", ".join(f"{one[k] - row['value']:.1e}" for one in sums)
            print(f"| `{Path(names[0]).stem}`, {plane} | {quantity} of {field} | "
                  f"{row['value']:.12g} | {row['error_bound']:.1e} | {off} | "
                  f"{row['linear'] - row['value']:.1e} | {surface['elements']} | "
                  f"{surface['boxes']} | {found['seconds']['integrate']:.1f} |", flush=True)


if __name__ == "__main__":
    main()
