#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What contours add to frames of real data, and how many pixels they leave undecided.

    contours.py PIXELEXACT FOLDER [--size N] [--repeat N] [--only TEXT] [--seconds N]
    contours.py PIXELEXACT FOLDER --levels [...]

Cases are those of suite.py, cut by a plane through the middle. Of 1 and of 10 values: times of a
frame over one without, first frame and later ones, taken in turns. --levels: pixels undecided and
times of the paper's algorithm (figures 5 and 6) at several subdivisions, beside the project's own.
A case that takes longer than --seconds is reported as such. Markdown tables on stdout.
"""

import argparse
import json
import pathlib
import subprocess

from suite import ask, bounds_of, inputs_of

LEVELS = (0, 1, 2, 3, 8)


def shot(tool, inputs):
    """Options of a cut through the middle, and the values that it shows: least and greatest."""
    facts = ask(tool, "info", *inputs)
    if not facts["fields"]:
        raise RuntimeError("no field")
    lower, upper = bounds_of(facts)
    centre = [0.5 * (a + b) + 0.013 * (b - a) for a, b in zip(lower, upper)]
    plane = ",".join(repr(v) for v in (*centre, 0.1, 0.2, 1.0))
    return [*inputs, "--field", facts["fields"][0]["name"], f"--plane={plane}"]


def measure(tool, options, contours, arguments, *how):
    done = subprocess.run(
        [tool, "bench", *map(str, options), "--contours", contours, *how, "--json",
         "--size", f"{arguments.size}x{arguments.size}", "--repeat", str(arguments.repeat)],
        capture_output=True, text=True, timeout=arguments.seconds, check=False)
    if done.returncode:
        raise RuntimeError(done.stderr.strip().splitlines()[-1] if done.stderr else "failed")
    return json.loads(done.stdout)


def inner(count, lower, upper):
    """Evenly spaced values, none of them at an end of the range, where a plateau may be."""
    return ",".join(repr(lower + (upper - lower) * (i + 1) / (count + 1)) for i in range(count))


def range_of(tool, options, folder):
    """Of the values that the cut shows."""
    facts = ask(tool, "render", *options, "--size", "100x100", "-o", folder / "cut.png")
    if facts["value_range"] is None:
        raise RuntimeError("the cut shows no value")
    return facts["value_range"]


def settled(contours, pixels):
    """Shares of pixels: by blocks of them, by whole edges, by subdivided ones; in per cent."""
    return " | ".join(f"{100 * contours[by] / pixels:.1f}"
                      for by in ("by_blocks", "by_edges", "by_parts"))


def speed(tool, options, span, arguments):
    one = measure(tool, options, inner(1, *span), arguments)
    ten = measure(tool, options, inner(10, *span), arguments)
    a, b = one["contours"], ten["contours"]
    seen = max(one["points"], 1)
    return (f"{1e3 * one['median_frame_seconds']:.0f} | {a['first_ratio_to_frame']:.1f} "
            f"| {a['ratio_to_frame']:.1f} | {b['first_ratio_to_frame']:.1f} "
            f"| {b['ratio_to_frame']:.1f} | {b['in']} | {b['undecided']} "
            f"| {100 * b['undecided'] / seen:.4f} % | {settled(b, arguments.size ** 2)} |")


def levels(tool, options, span, arguments):
    values = inner(10, *span)
    own = measure(tool, options, values, arguments)["contours"]
    cells = [f"{own['undecided']} ({own['median_frame_seconds']:.2f} s)"]
    for level in LEVELS:
        paper = measure(tool, options, values, arguments, "--certifier", "interval",
                        "--subdivisions", str(level))["contours"]
        cells.append(f"{paper['undecided']} ({paper['median_frame_seconds']:.2f} s)")
    return f"{own['in']} | " + " | ".join(cells) + " |"


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("tool")
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--levels", action="store_true")
    parser.add_argument("--size", type=int, default=1000)
    parser.add_argument("--repeat", type=int, default=3)
    parser.add_argument("--only", nargs="*", default=[""])
    parser.add_argument("--seconds", type=float, default=300)
    parser.add_argument("--scratch", type=pathlib.Path, default=pathlib.Path("/tmp"))
    arguments = parser.parse_args()
    row = levels if arguments.levels else speed
    heads = (
        ["in", "undecided"] + [f"paper, {k}" for k in LEVELS] if arguments.levels else
        ["frame, ms", "1 value, first", "next", "10 values, first", "next", "in", "undecided",
         "of those seen", "by blocks, %", "edges", "halved"])
    print("| case | " + " | ".join(heads) + " |\n" + "|---" * (1 + len(heads)) + "|")
    for case in sorted(p for p in arguments.folder.iterdir() if p.is_dir()):
        inputs = inputs_of(case) if any(text in case.name for text in arguments.only) else []
        if not inputs:
            continue
        try:
            options = shot(arguments.tool, inputs)
            span = range_of(arguments.tool, options, arguments.scratch)
            told = row(arguments.tool, options, span, arguments)
        except subprocess.TimeoutExpired:
            told = f"more than {arguments.seconds:.0f} s |"
        except (RuntimeError, KeyError, TypeError) as error:
            told = f"{error} |"
        print(f"| {case.name} | {told}", flush=True)


if __name__ == "__main__":
    main()
