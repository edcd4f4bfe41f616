#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Frames of real data against the bare kernel: three plane cuts of every case of a folder.

    suite.py PIXELEXACT FOLDER [--size WxH] [--repeat N] [--threads N] [--only TEXT] [--json FILE]

A case is a folder with a mesh file (.mesh, .mesh.gz, .xml, or else .vtu, .vtk) and its field files.
A Markdown table on stdout: nanoseconds a point and thread, of the kernel and of the frame; what the
project aims for (60 + 8 times the kernel's, and 8 for each pixel that meets nothing); shares of the
time in the tiles; the first frame, for which elements are bounded and trees grown. Of N frames the
least counts, in processor time: what a machine with other work adds is not the frame's. The shares
are of one frame, by the clock.
"""
import argparse
import json
import pathlib
import subprocess
import sys

NORMALS = ((0.1, 0.2, 1.0), (1.0, 0.15, -0.1), (-0.2, 1.0, 0.3))
MESHES = (".mesh", ".mesh.gz", ".xml", ".vtu", ".vtk")
FIELDS = (".gf", ".gf.gz", ".fld", ".rst", ".chk")


def ask(tool, *arguments):
    done = subprocess.run([tool, *map(str, arguments), "--json"], capture_output=True, text=True)
    if done.returncode:
        raise RuntimeError(done.stderr.strip().splitlines()[-1] if done.stderr else "failed")
    return json.loads(done.stdout)


def inputs_of(case):
    """The mesh and the field files of a folder; nothing where it holds no mesh."""
    files = sorted(p for p in case.iterdir() if p.is_file())
    for suffix in MESHES:
        meshes = [p for p in files if p.name.endswith(suffix)]
        if meshes:
            native = suffix in (".mesh", ".mesh.gz", ".xml")
            fields = [p for p in files if p.name.endswith(FIELDS)] if native else []
            return [meshes[0], *fields[:1]]
    return []


def bounds_of(facts):
    """The lower and the upper corner of the nodes."""
    box = facts["node_bounds"]
    return (box[0::2], box[1::2]) if len(box) == 6 else box


def measure(tool, inputs, arguments):
    """Rows of three planes: pixels and seconds."""
    facts = ask(tool, "info", *inputs)
    names = [field["name"] for field in facts["fields"]]
    if not names:
        raise RuntimeError("no field")
    lower, upper = bounds_of(facts)
    centre = [0.5 * (a + b) + 0.013 * (b - a) for a, b in zip(lower, upper)]
    rows = []
    for normal in NORMALS:
        plane = ",".join(repr(v) for v in (*centre, *normal))
        rows.append(
            ask(tool, "bench", *inputs, "--field", names[0], f"--plane={plane}",
                "--size", arguments.size, "--repeat", arguments.repeat,
                *(["--threads", arguments.threads] if arguments.threads else [])))
    return rows


def line(name, rows):
    """One line for the three planes together."""
    threads = rows[0]["threads"]
    points = sum(r["points"] for r in rows)
    pixels = sum(r["width"] * r["height"] for r in rows)
    if points == 0:
        return f"| {name} | 0 |" + " |" * 10
    frame = sum(min(r["frame_processor_seconds"]) for r in rows)
    whole = sum(min(r["frame_seconds"]) for r in rows)
    first = sum(r.get("first_frame_seconds", 0.0) for r in rows)
    kernel = sum(r["least_kernel_seconds"] for r in rows)
    each = 1e9 / points
    kernel *= threads
    aim = 60 + 8 * kernel * each + 8 * (pixels - points) / points
    stages = {s: sum(r["stages"][s] for r in rows) for s in rows[0]["stages"]}
    total = sum(stages.values())
    shares = ", ".join(
        f"{s} {100 * v / total:.0f} %" for s, v in sorted(stages.items(), key=lambda p: -p[1])
        if v >= 0.03 * total and s != "careful path")
    return (f"| {name} | {points} | {sum(r.get('unknown', 0) for r in rows)} | {kernel * each:.1f} "
            f"| {frame * each:.0f} | {aim:.0f} | {frame / kernel:.0f} | {first / whole:.1f} "
            f"| {100 * stages['careful path'] / total:.1f} % | {shares} "
            f"| {max(r.get('tree_bytes', 0) for r in rows) / 2**20:.1f} |")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("pixelexact")
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--size", default="1000x1000")
    parser.add_argument("--repeat", default=3, type=int)
    parser.add_argument("--threads", type=int, help="default: as the machine has")
    parser.add_argument("--only", default="")
    parser.add_argument("--json", type=pathlib.Path)
    arguments = parser.parse_args()
    print("| case | points | unknown | kernel ns | frame ns | aim ns | frame / kernel | first / "
          "frame | careful path | other stages | trees, MiB |\n" + "|---" * 11 + "|")
    kept = {}
    for case in sorted(p for p in arguments.folder.iterdir() if p.is_dir()):
        inputs = inputs_of(case) if arguments.only in case.name else []
        if not inputs:
            continue
        try:
            kept[case.name] = measure(arguments.pixelexact, inputs, arguments)
            print(line(case.name, kept[case.name]), flush=True)
        except (RuntimeError, KeyError) as error:
            print(f"| {case.name} | {error} |" + " |" * 9, flush=True)
    if arguments.json:
        arguments.json.write_text(json.dumps(kept, indent=1))
    return 0


if __name__ == "__main__":
    sys.exit(main())
