#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What frames of faces, patches, triangles and iso-surfaces cost beside those of planes.

    pieces.py PIXELEXACT FOLDER [--before OTHER] [--size N] [--repeat N] [--rounds N] [--only TEXT,...]
        [--lights curved|on|off]

For every case in FOLDER a plane through the middle of the mesh, its boundary, a bicubic patch and a
wave of triangles within it, and the iso-surface of a value at 60 % of the field's range, all seen
from (1, 1, 1) by one thread. A Markdown table on stdout: of each the least processor time of a frame
for each pixel that shows the field, and over the plane's of the same run. With OTHER, another build
of the program, both are run in turns, and times before and after are given. Lights are the program's
own (curved: on all but the plane) unless they are chosen, for all alike.
"""
import argparse
import math
import pathlib
import sys
import tempfile

from suite import ask, bounds_of, inputs_of

KINDS = ("plane", "boundary", "patch", "triangles", "isosurface")
# Of the mesh's box, along each axis.
INSIDE = 0.42


def patch(lower, upper, path):
    """A saddle within the box."""
    with open(path, "w", encoding="ascii") as out:
        for i in range(4):
            for j in range(4):
                at = ((2 * i - 3) / 3, (2 * j - 3) / 3, (i - 1.5) * (j - 1.5) / 2.25)
                out.write(" ".join(
                    repr(0.5 * (a + b) + INSIDE * s * (b - a) * t)
                    for a, b, s, t in zip(lower, upper, (1, 1, 0.5), at)) + "\n")


def wave(lower, upper, path, parts):
    """Triangles along a wave within the box."""
    def corner(i, j):
        x, y = 2 * i / parts - 1, 2 * j / parts - 1
        at = (x, y, 0.4 * math.sin(3 * x) * math.cos(2 * y))
        return " ".join(f"{0.5 * (a + b) + INSIDE * (b - a) * t!r}"
                        for a, b, t in zip(lower, upper, at))

    with open(path, "w", encoding="ascii") as out:
        out.write("solid wave\n")
        for i in range(parts):
            for j in range(parts):
                a, b, c, d = corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)
                for face in ((a, b, c), (a, c, d)):
                    out.write("facet normal 0 0 1\nouter loop\n"
                              + "".join(f"vertex {v}\n" for v in face) + "endloop\nendfacet\n")
        out.write("endsolid wave\n")


def surfaces(facts, field, folder):
    lower, upper = bounds_of(facts)
    saddle, triangles = folder / "saddle.txt", folder / "wave.stl"
    patch(lower, upper, saddle)
    wave(lower, upper, triangles, 50)
    centre = ",".join(repr(0.5 * (a + b) + 0.013 * (b - a)) for a, b in zip(lower, upper))
    least, most = field["ranges"][0]
    value = least + 0.6 * (most - least)
    return {
        "plane": [f"--plane={centre},0.2,0.3,1"],
        "boundary": ["--boundary"],
        "patch": ["--patch", saddle],
        "triangles": ["--surface", triangles],
        "isosurface": [f"--isosurface={field['name']}={value!r}"],
    }


def nanoseconds(tool, inputs, field, options, arguments):
    """Of a pixel that shows the field; nothing where too few do."""
    frame = ask(tool, "bench", *inputs, "--field", field, *options, "--view", "iso", "--threads", 1,
                "--lights", arguments.lights,
                "--size", f"{arguments.size}x{arguments.size}", "--repeat", arguments.repeat)
    if frame["points"] < 1000:
        raise RuntimeError("less than 1000 pixels show the field")
    return 1e9 * min(frame["frame_processor_seconds"]) / frame["points"]


def row(case, arguments, folder):
    inputs = inputs_of(case)
    tools = [arguments.before, arguments.tool] if arguments.before else [arguments.tool]
    facts = ask(arguments.tool, "info", *inputs)
    field = next(f for f in facts["fields"] if f["components"] == 1)
    least = {}
    for _ in range(arguments.rounds):
        for kind, options in surfaces(facts, field, folder).items():
            for number, tool in enumerate(tools):
                try:
                    took = nanoseconds(tool, inputs, field["name"], options, arguments)
                except RuntimeError as error:
                    print(f"{case.name}, {kind}: {error}", file=sys.stderr)
                    continue
                key = kind, number
                least[key] = min(took, least.get(key, took))
    last = len(tools) - 1
    cells = []
    for kind in KINDS:
        times = [least.get((kind, n)) for n in range(len(tools))]
        if None in times or ("plane", last) not in least:
            cells.append("-")
            continue
        over = "" if kind == "plane" else f" ({times[-1] / least['plane', last]:.1f})"
        cells.append(" to ".join(f"{t:.0f}" for t in times) + over)
    return f"| {case.name} | {field['name']} | " + " | ".join(cells) + " |"


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("tool")
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--before")
    parser.add_argument("--size", type=int, default=600)
    parser.add_argument("--repeat", type=int, default=9)
    parser.add_argument("--rounds", type=int, default=3)
    parser.add_argument("--only", default="")
    parser.add_argument("--lights", choices=("curved", "on", "off"), default="curved")
    arguments = parser.parse_args()
    print("| case | field | " + " | ".join(f"{k}, ns" for k in KINDS) + " |")
    print("|---|---|" + "---|" * len(KINDS))
    with tempfile.TemporaryDirectory() as folder:
        for case in sorted(path for path in arguments.folder.iterdir() if path.is_dir()):
            if not inputs_of(case) or not any(t in case.name for t in arguments.only.split(",")):
                continue
            try:
                print(row(case, arguments, pathlib.Path(folder)), flush=True)
            except (RuntimeError, StopIteration, KeyError) as error:
                print(f"{case.name}: {error!r}", file=sys.stderr)


if __name__ == "__main__":
    main()
