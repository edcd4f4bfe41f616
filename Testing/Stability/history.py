#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Whether the answers for points depend on what else was asked: one hash for each case.

usage: history.py PIXELEXACT FOLDER... [--points N] [--runs N] [--seed N] [--only WORD]

A case is a .vtu file of a folder or of its folder `adversarial`, or a folder with a mesh file and
its field files. Points are those beside it (oracles, .points.csv), points within 1e-16 to 1e-1 of
them, and points anywhere in the box. They are asked in order; then, so many runs, shuffled, on one
thread and on two, together and in batches of processes of their own; at last some alone. Verdict,
element, xi, value, gradient, enclosure and coverage are to have the same digits each time.
Prints a table in Markdown. Exits with 1 if a case has more than one hash.
"""
import argparse
import csv
import hashlib
import json
import pathlib
import random
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "Benchmarks"))
from suite import ask, bounds_of, inputs_of  # noqa: E402

BATCHES = 5
ALONE = 5


def cases(folder):
    """Name, input files, and the tables of points beside them."""
    for place in (folder, folder / "adversarial"):
        for mesh in sorted(place.glob("*.vtu")):
            tables = [mesh.with_suffix(end) for end in (".oracle.csv", ".points.csv")]
            yield mesh.name, [mesh], tables
    for place in sorted(p for p in folder.iterdir() if p.is_dir() and p.name != "adversarial"):
        inputs = inputs_of(place)
        if inputs:
            yield place.name, inputs, sorted(place.glob("oracle*.csv"))


def read_points(tables):
    points = []
    for table in tables:
        if table.exists():
            with open(table, encoding="utf-8") as file:
                points += [[float(row[c]) for c in "xyz"] for row in csv.DictReader(file)]
    return points


def make_points(known, lower, upper, count, chance):
    size = max(b - a for a, b in zip(lower, upper))
    chance.shuffle(known)
    points = known[:count // 2]
    beside = list(points)
    while len(points) < count:
        if beside and chance.random() < .5:
            apart = size * 10 ** chance.uniform(-16, -1)
            points.append([v + apart * chance.uniform(-1, 1) for v in chance.choice(beside)])
        else:
            points.append([chance.uniform(a - size / 50, b + size / 50)
                           for a, b in zip(lower, upper)])
    return points


def probe(program, inputs, field, points, threads, scratch):
    """The lines of the table that the tool writes."""
    table, out = scratch / "points.csv", scratch / "out.csv"
    table.write_text("x,y,z\n" + "".join(",".join(map(repr, x)) + "\n" for x in points))
    subprocess.run([program, "probe", *map(str, inputs), "--field", field, "--points", str(table),
                    "--output", str(out), "--threads", str(threads), "--gradient", "--enclosures",
                    "--owners"], capture_output=True, check=True)
    return out.read_text(encoding="utf-8").splitlines()[1:]


def hash_of(lines):
    return hashlib.sha256("\n".join(lines).encode("utf-8")).hexdigest()[:12]


def study(program, inputs, facts, tables, options, scratch):
    """The first run's lines and the hashes of all runs."""
    chance = random.Random(options.seed)
    field = facts["fields"][0]["name"]
    points = make_points(read_points(tables), *bounds_of(facts), options.points, chance)

    def run(which, threads):
        return probe(program, inputs, field, [points[i] for i in which], threads, scratch)
    wanted = run(range(len(points)), 1)
    hashes = {hash_of(wanted)}
    for number in range(1, options.runs):
        order = list(range(len(points)))
        chance.shuffle(order)
        batches = BATCHES if number % 4 == 0 else 1
        lines = [""] * len(points)
        for first in range(batches):
            which = order[first::batches]
            for i, line in zip(which, run(which, 1 + number % 2)):
                lines[i] = line
        hashes.add(hash_of(lines))
    lines = list(wanted)
    for i in chance.sample(range(len(points)), ALONE):
        lines[i], = run([i], 1)
    hashes.add(hash_of(lines))
    return wanted, hashes


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("program")
    parser.add_argument("folders", nargs="+", type=pathlib.Path)
    parser.add_argument("--points", type=int, default=600)
    parser.add_argument("--runs", type=int, default=20)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--only", default="")
    options = parser.parse_args()
    failures = 0
    print("| case | points | inside | outside | unknown | undecided | hashes | |")
    print("|---|" + "---:|" * 6 + "---|")
    with tempfile.TemporaryDirectory() as folder:
        for place in options.folders:
            for name, inputs, tables in cases(place):
                if options.only not in name:
                    continue
                try:
                    facts = ask(options.program, "info", *inputs)
                except RuntimeError:
                    print(f"| {name} | not read |" + " |" * 6, flush=True)
                    continue
                lines, hashes = study(options.program, inputs, facts, tables, options,
                                      pathlib.Path(folder))
                counts = [sum(f",{word}" in line for line in lines)
                          for word in ("inside", "outside", "unknown", "undecided")]
                print(f"| {name} | " + " | ".join(map(str, [len(lines), *counts, len(hashes)]))
                      + f" | {' '.join(sorted(hashes))} |", flush=True)
                failures += len(hashes) > 1
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
