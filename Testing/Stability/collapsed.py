#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Hexahedra, prisms and pyramids whose faces or edges have collapsed, against 60 digits.

usage: collapsed.py ASKPOINTS [--points N] [--seed N] [--only WORD] [--keep DIRECTORY]

As mesh generators write them: straight, bent, and bent with coefficients that doubles round, of
orders 1 to 4. Points are on the edge or vertex that is left, and within 1e-16 to 1e-1 of it: one
half on all sides, one half images of a xi that far from what has collapsed. Each is asked alone, of
a locator of its own.

Wrong is: `outside` or `none` with a preimage in the shape; `inside` where Phi(xi) misses the point
by more than five uncertainties (four are promised, one is for rounding here and there) or xi the
shape by more than four tolerances; `several`, for the maps are injective but where they collapse.
`Farthest` is how far beyond the shape the xi of an `inside` is: by the tolerance at most, which is
large where the map nearly collapses.
Prints tables in Markdown and, to stderr, wrong answers and points that take more than 10 ms; with
--keep, their questions are written. Exits with 1 if an answer is wrong.
"""
import argparse
import math
import pathlib
import random
import subprocess
import sys
from fractions import Fraction

from mpmath import matrix, mp, mpf

from adversary_maps import margin
from collapsed_maps import SHAPES, Element, kinds

SLOWEST = 10.0  # ms
MOST_MISS, MOST_BEYOND = 5, 4
STRAIGHT = [[1, 0, 0], [0, 1, 0], [0, 0, 1]]
TURNED = [[1, Fraction(1, 2), 0], [Fraction(1, 4), 1, -Fraction(1, 2)], [0, Fraction(1, 2), 1]]
STYLES = {"straight": (0, STRAIGHT, False), "bent": (Fraction(1, 8), STRAIGHT, False),
          "rounded": (Fraction(1, 8), TURNED, True)}


def special_point(kind, element, distance, from_xi, chance):
    """At about this distance from what has collapsed."""
    eta = [mpf(chance.uniform(-1, 1)) for _ in range(3)]
    for d, end in kind.ends.items():
        eta[d] = mpf(end)
    if from_xi and distance:
        for d, end in kind.ends.items():
            eta[d] -= end * 2 * mpf(distance) * chance.uniform(0, 1)
        return [float(v) for v in element.value_at(eta)]
    x = matrix(element.value_at(eta))
    away = matrix([chance.gauss(0, 1) for _ in range(3)])
    if kind.along is not None:
        tangent = matrix([row[kind.along].value(eta) for row in element.slopes])
        length = sum(t * t for t in tangent)
        away -= tangent * (sum(a * t for a, t in zip(away, tangent)) / length) if length else 0
    return [float(v) for v in x + away * (distance / mp.norm(away))]


def question(element, points):
    numbers = [SHAPES.index(element.shape), *[element.order] * 3, element.apart,
               *(c for row in element.modes for c in row), len(points),
               *(v for x in points for v in x)]
    return " ".join(map(repr, numbers)) + "\n"


def judge(element, x, answer):
    """Whether the shape holds the point, how far beyond it the answer's xi is, what is wrong."""
    verdict, *numbers, coverage = answer
    held = [xi for xi, exact in element.preimages(x) if exact and margin(element.shape, xi) >= 0]
    wrong, beyond = [], 0
    if verdict == "outside" and held:
        wrong.append("outside")
    if coverage == "none" and held or coverage == "several":
        wrong.append(coverage)
    if verdict == "inside":
        xi = [mpf(v) for v in numbers]
        miss = max(abs(mpf(a) - b) / u
                   for a, b, u in zip(x, element.value(xi), element.uncertainty))
        if miss > MOST_MISS:
            wrong.append(f"inside, misses by {mp.nstr(miss, 3)} uncertainties")
        beyond = -margin(element.shape, xi)
        if beyond > 0 and beyond > MOST_BEYOND * element.tolerance(xi):
            wrong.append(f"inside, {mp.nstr(beyond, 3)} beyond a face")
    return bool(held), float(max(beyond, 0)), wrong


class Sums:
    """Of some points: those the shape holds, those it does not; the slowest."""

    def __init__(self):
        self.count, self.unknown, self.undecided = [0, 0], [0, 0], [0, 0]
        self.wrong, self.beyond, self.slowest, self.owners, self.slow = 0, 0.0, 0.0, 0.0, 0

    def add(self, held, answer, milliseconds, beyond, wrong):
        self.count[held] += 1
        self.unknown[held] += answer[0] == "unknown"
        self.undecided[held] += answer[-1] == "undecided"
        self.wrong += bool(wrong)
        self.beyond = max(self.beyond, beyond)
        self.slow += max(milliseconds) > SLOWEST
        self.slowest = max(self.slowest, milliseconds[0])
        self.owners = max(self.owners, milliseconds[1])

    def row(self):
        def share(part, of):
            return f"{100 * part / of:.1f} %" if of else "-"
        cells = []
        for held in (1, 0):
            of = self.count[held]
            cells += [of, share(self.unknown[held], of), share(self.undecided[held], of)]
        cells += [self.wrong, f"{self.beyond:.0e}", f"{self.slowest:.1f}", f"{self.owners:.1f}",
                  self.slow]
        return " | ".join(map(str, cells))


def print_table(first, rows):
    print(f"| {first} | in the shape | unknown | undecided | beyond it | unknown | undecided "
          "| wrong | farthest xi | slowest, ms | owners, ms | over 10 ms |")
    print("|---|" + "---:|" * 11)
    for title, sums in rows.items():
        print(f"| {title} | {sums.row()} |")


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("program")
    parser.add_argument("--points", type=int, default=136)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--only", default="")
    parser.add_argument("--keep", type=pathlib.Path)
    options = parser.parse_args()
    chance = random.Random(options.seed)
    by_distance = {"0": Sums(), **{f"1e{p} to 1e{p + 1}": Sums() for p in range(-16, -1)}}
    by_element = {}
    failures = 0
    for kind in kinds():
        for style, (bend, shear, rounded) in STYLES.items():
            for order in range(max(kind.least, 2 if bend else 1), 5):
                name = f"{kind.shape}, {kind.name}, {style}, order {order}"
                if options.only not in name:
                    continue
                element = Element(kind.shape, order, kind.make(order, bend), kind.solved, shear,
                                  rounded)
                points, bins = [], []
                for k in range(options.points):
                    power = chance.uniform(-16, -1)
                    distance = 0 if k % 17 == 0 else 10 ** power
                    points.append(special_point(kind, element, distance, k % 2 == 0, chance))
                    bins.append(f"1e{math.floor(power)} to 1e{math.floor(power) + 1}"
                                if distance else "0")
                run = subprocess.run([options.program], input=question(element, points),
                                     capture_output=True, text=True, check=True)
                sums = by_element.setdefault(f"{kind.shape}, {kind.name}, {style}", Sums())
                for x, where, line in zip(points, bins, run.stdout.splitlines()):
                    verdict, *numbers, coverage, sample, owners = line.split()
                    answer = [verdict, *map(float, numbers), coverage]
                    milliseconds = [float(sample), float(owners)]
                    held, beyond, wrong = judge(element, x, answer)
                    failures += bool(wrong)
                    slow = max(milliseconds) > SLOWEST
                    for each in (sums, by_distance[where]):
                        each.add(held, answer, milliseconds, beyond, wrong)
                    if wrong or slow:
                        told = ", ".join(wrong + [f"{sample} ms, owners {owners} ms"] * slow)
                        print(f"{name}, {where}: {','.join(map(repr, x))}: {told}", file=sys.stderr)
                        if options.keep:
                            options.keep.mkdir(parents=True, exist_ok=True)
                            count = len(list(options.keep.iterdir()))
                            (options.keep / f"{count:03d}.txt").write_text(
                                question(element, [x]), encoding="ascii")
    print("By the distance from what has collapsed:\n")
    print_table("distance", by_distance)
    print("\nBy element, orders 1 to 4:\n")
    print_table("element", by_element)
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
