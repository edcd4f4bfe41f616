#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What the time from Enter to a figure goes into, on five files of solvers.

    figures.py PIXELEXACT FOLDER [--repeat N] [-- OPTIONS...]

FOLDER holds the cases that Data/ is too small for; those that are not there are left out. All files
are drawn one after the other, N times: of each the run that took least counts, by the clock. "start"
is the time outside of the stages that the program reports: loading libraries, options, the end of the
process. A Markdown table on stdout, in milliseconds.
"""
import argparse
import json
import pathlib
import subprocess
import sys
import tempfile
import time

DATA = pathlib.Path(__file__).resolve().parent.parent.parent / "Data"
STAGES = ("start", "read", "convert", "bounds+bvh", "camera", "rays", "colours", "provenance", "figure", "encode",
          "write")


def cases(folder):
    """Names and input files."""
    large = {
        "mfem_toroid_hex_g3_p16": ("mfem_toroid_hex_g3_p16.mesh", "u.gf"),
        "mfem_escher_tet_21k_p3": ("mfem_escher_tet_21k_p3_zlib.vtu",),
        "nek_ns_cylinder_paperscale_p3": ("nek_ns_cylinder_paperscale_p3.xml", "nek_ns_cylinder_paperscale_p3_u.fld"),
    }
    small = DATA / "mfem_escher_tet_darcy_p3"
    yield "toroid_hex_g3_p6", [DATA / "toroid_hex_g3_p6.vtu"]
    yield small.name, [small / f"{small.name}.mesh", small / "pressure.gf"]
    for name, files in large.items():
        if (folder / name).is_dir():
            yield name, [folder / name / file for file in files]


def measure(tool, files, options, scratch):
    """Milliseconds of one figure, by stage."""
    words = [tool, "render", *files, "--figure", "--output", scratch / "figure.png", "--no-config", "--json", *options]
    begin = time.perf_counter()
    done = subprocess.run(list(map(str, words)), capture_output=True, text=True, check=False)
    whole = time.perf_counter() - begin
    if done.returncode:
        raise RuntimeError(done.stderr.strip())
    summary = json.loads(done.stdout)
    row = {name: 1e3 * seconds for name, seconds in summary["seconds"].items()}
    row.update(all=1e3 * whole, elements=summary["elements"])
    row["start"] = row["all"] - 1e3 * sum(summary["seconds"].values())
    return row


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("tool")
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--repeat", type=int, default=5)
    parser.add_argument("options", nargs="*")
    arguments = parser.parse_args()
    rows = {}
    with tempfile.TemporaryDirectory() as scratch:
        for _ in range(arguments.repeat):
            for name, files in cases(arguments.folder):
                row = measure(arguments.tool, files, arguments.options, pathlib.Path(scratch))
                if name not in rows or row["all"] < rows[name]["all"]:
                    rows[name] = row
    print("| file | elements | all | " + " | ".join(STAGES) + " |")
    print("|---|---|---" + "|---" * len(STAGES) + "|")
    for name, row in rows.items():
        cells = " | ".join(f"{row.get(stage, 0.0):.0f}" for stage in STAGES)
        print(f"| `{name}` | {row['elements']} | {row['all']:.0f} | {cells} |")


if __name__ == "__main__":
    sys.exit(main())
