#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Time and memory from file to first picture: the made large files and real ones.

    loading.py PIXELEXACT MADE [REAL] [--against OLD] [--repeat N] [--only TEXT...]

MADE is a folder of large_files.py, REAL one of cases (as of suite.py). A Markdown table on stdout:
seconds of the processor until the picture of 600 x 600 pixels is written, the largest resident set,
and this over the bytes of the coefficients, geometry's and fields'. Of N runs the least counts.
With --against another program's time and memory stand beside, measured in turns with the first.
"""
import argparse
import os
import pathlib
import subprocess
import tempfile

from suite import ask, inputs_of

MEGA = 1e6


def made_inputs(folder):
    """Mesh and field of each made file."""
    for mesh in sorted(folder.iterdir()):
        if mesh.suffix in (".vtu", ".msh", ".mesh", ".xml"):
            fields = [mesh.with_suffix(s) for s in (".gf", ".fld")]
            yield mesh.stem, [mesh, *(f for f in fields if f.exists())]


def real_inputs(folder):
    for case in sorted(p for p in folder.iterdir() if p.is_dir()):
        inputs = inputs_of(case)
        if inputs:
            yield case.name, inputs


def run(tool, inputs, picture):
    """Seconds of the processor, by the clock, and bytes of the largest resident set."""
    command = [tool, "render", *map(str, inputs), "--size", "600x600", "--output", picture]
    process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    _, status, usage = os.wait4(process.pid, 0)
    if status:
        raise RuntimeError("render failed: " + " ".join(command))
    return usage.ru_utime + usage.ru_stime, 1024.0 * usage.ru_maxrss


def best(runs):
    return min(r[0] for r in runs), min(r[1] for r in runs)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("tool")
    parser.add_argument("made", type=pathlib.Path)
    parser.add_argument("real", type=pathlib.Path, nargs="?")
    parser.add_argument("--against")
    parser.add_argument("--repeat", type=int, default=2)
    parser.add_argument("--only", nargs="*", default=[])
    arguments = parser.parse_args()
    cases = list(made_inputs(arguments.made))
    cases += real_inputs(arguments.real) if arguments.real else []
    before = " | before: s | MB | times" if arguments.against else ""
    print(f"| file | coefficients, MB | files, MB | s | MB | times the coefficients{before} |")
    print("|---|" + "---|" * (5 + (3 if arguments.against else 0)))
    tools = [arguments.tool] + ([arguments.against] if arguments.against else [])
    with tempfile.TemporaryDirectory() as scratch:
        picture = os.path.join(scratch, "cut.png")
        for name, inputs in cases:
            if arguments.only and not any(part in name for part in arguments.only):
                continue
            held = ask(arguments.tool, "info", *inputs)["coefficient_bytes"]
            size = sum(f.stat().st_size for f in inputs)
            runs = {tool: [] for tool in tools}
            for _ in range(arguments.repeat):
                for tool in tools:
                    runs[tool].append(run(tool, inputs, picture))
            line = f"| `{name}` | {held / MEGA:.1f} | {size / MEGA:.1f}"
            for tool in tools:
                seconds, peak = best(runs[tool])
                line += f" | {seconds:.2f} | {peak / MEGA:.0f} | {peak / held:.2f}"
            print(line + " |", flush=True)


if __name__ == "__main__":
    main()
