#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What frames of curved surfaces cost beside those of planes, on real data.

surfaces.py PIXELEXACT DIR [--size N] [--repeat N]

For every case in DIR a plane, a sphere, a cylinder and a torus through the middle of the mesh, in
one run, seen by the same camera: nanoseconds of all threads for each pixel of the image, and for
each that shows the field, and how much of it is the rays' share. A Markdown table on stdout.
"""

import argparse
import pathlib
import statistics
import sys

from suite import ask, bounds_of, inputs_of


def surfaces(lower, upper):
    """Options by name. Each cuts through most of the mesh's box."""
    size = [b - a for a, b in zip(lower, upper)]
    centre = [0.5 * (a + b) + 0.013 * s for a, b, s in zip(lower, upper, size)]
    least, most = min(size), max(size)
    at = ",".join(repr(c) for c in centre)
    # Thin meshes are cut by what is large beside them.
    far = ",".join(repr(c) for c in (*centre[:2], centre[2] - most))
    return {
        "plane": ["--plane", f"{at},0.2,0.3,1"],
        "sphere": ["--sphere", f"{far},{most!r}"],
        "cylinder": ["--cylinder", f"{far},0.3,1,0.1,{most!r}"],
        "torus": ["--torus", f"{at},0.2,0.1,1,{0.35 * most!r},{min(0.45 * least, 0.2 * most)!r}"],
    }


def measure(tool, inputs, field, options, arguments):
    side = arguments.size
    frame = ask(
        tool, "bench", *inputs, "--field", field, *options, "--size", f"{side}x{side}",
        "--repeat", str(arguments.repeat), "--lights", "off",
    )
    seconds = frame["median_frame_seconds"] * frame["threads"]
    return {
        "shown": frame["points"],
        "pixel": 1e9 * seconds / side**2,
        "point": 1e9 * seconds / max(frame["points"], 1),
        "rays": 1e9 * frame["stages"]["rays and hits"] / side**2,
    }


def camera(lower, upper):
    """From the side, the same for all surfaces."""
    middle = [0.5 * (a + b) for a, b in zip(lower, upper)]
    reach = max(b - a for a, b in zip(lower, upper))
    eye = [m + reach * d for m, d in zip(middle, (0.4, -0.7, 1.6))]
    place = ",".join(repr(v) for v in eye)
    focus = ",".join(repr(v) for v in middle)
    return ["--camera-position", place, "--focal-point", focus, "--view-up", "0,1,0",
            "--view-angle", "40"]


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("tool")
    parser.add_argument("directory", type=pathlib.Path)
    parser.add_argument("--size", type=int, default=600)
    parser.add_argument("--repeat", type=int, default=5)
    arguments = parser.parse_args()
    names = ["sphere", "cylinder", "torus"]
    print("| case | plane ns/pixel | " + " | ".join(f"{n} ns/pixel" for n in names) + " | "
          + " | ".join(f"{n} over plane, per pixel shown" for n in names) + " |")
    print("|---|" + "---|" * (1 + 2 * len(names)))
    ratios = {name: [] for name in names}
    for case in sorted(path for path in arguments.directory.iterdir() if path.is_dir()):
        inputs = inputs_of(case)
        if not inputs:
            continue
        try:
            facts = ask(arguments.tool, "info", *inputs)
            lower, upper = bounds_of(facts)
            rows = {
                name: measure(arguments.tool, inputs, facts["fields"][0]["name"],
                              [*options, *camera(lower, upper)], arguments)
                for name, options in surfaces(lower, upper).items()
            }
        except (RuntimeError, IndexError, KeyError) as error:
            print(f"{case.name}: {error}", file=sys.stderr)
            continue
        cells = [f"{rows['plane']['pixel']:.0f}"]
        cells += [f"{rows[name]['pixel']:.0f} (rays {rows[name]['rays']:.0f})" for name in names]
        for name in names:
            if min(rows[name]["shown"], rows["plane"]["shown"]) < 1000:
                cells.append("-")
                continue
            ratio = rows[name]["point"] / rows["plane"]["point"]
            ratios[name].append(ratio)
            cells.append(f"{ratio:.2f}")
        print(f"| {case.name} | " + " | ".join(cells) + " |", flush=True)
    medians = [f"{statistics.median(ratios[name]):.2f}" if ratios[name] else "-" for name in names]
    print("| median |" + " |" * (1 + len(names)) + " " + " | ".join(medians) + " |")


if __name__ == "__main__":
    main()
