#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Elements made to break location's proofs, against a reference of its own with 60 digits.

usage: adversary.py PIXELEXACT [--points N] [--seed N] [--only WORD] [--keep DIRECTORY]

Writes small .vtu files of elements that are nearly singular on a face, a sheet, a line or at a
point, that fold with up to 64 preimages, of noise, of coefficients that cancel, folded cones, and
pairs with a gap or an overlap. Probes points next to what is special about each, and judges every
verdict. All preimages are known: the maps can be solved one variable after the other, and the nodes
are exact in double. Of noise, those are known that the points were made from, and that there is no
other where the map is injective.

Wrong is: `outside` or `none` with a preimage in the shape; `inside` where Phi(xi) misses the point,
or xi the shape, beyond the documented tolerance; `once` with two preimages off the faces; `several`
with less than two. Slow is a point that takes more than 10 ms alone, in a new process. Prints a
table in Markdown and, to stderr, each wrong or slow point. Exits with 1 if a verdict is wrong.
"""
import argparse
import csv
import json
import pathlib
import random
import subprocess
import sys
import tempfile

from mpmath import mp, mpf

from adversary_maps import (HEXAHEDRON, PRISM, PYRAMID, PYRAMID5, TETRAHEDRON, Cell, Cone,
                            Noise, margin, noise_cell, polynomial_cell)

SLOWEST = 10e-3
# Phi(xi) may miss by four uncertainties (kMostMiss); the rest is for the reference's coarser ones.
MOST_MISS = 8
# A root that is this many tolerances off a face is no root of the face; two such are not one.
CLEAR = 32
# The study's cases: names, cells, and what makes a xi next to what is special.
SHEARS = [[[1, 0, 0], [0, 1, 0], [0, 0, 1]], [[1, .5, 0], [.25, 1, -.5], [0, .5, 1]]]
BACKWARDS = ((2, 2), (1, 1), (0, 0))  # z is solved for c, then y for b, then x for a
Y = {(0, 1, 0): 1}
Z = {(0, 0, 1): 1}


def cases(chance):
    def near(value=0.0, least=-12):
        return value + chance.choice([-1, 1]) * 10 ** chance.uniform(least, 0)

    def anywhere(_):
        return [chance.uniform(-1, 1) for _ in range(3)]

    def first(value):
        return lambda _: [near(value), chance.uniform(-1, 1), chance.uniform(-1, 1)]

    for shear in SHEARS:
        for bits in (10, 20, 30, 40):
            eps = 2.0 ** -bits
            for sign in (1, -1) if bits in (10, 30) else (1,):
                name = f"eps = {'-' if sign < 0 else ''}2^-{bits}"
                e = sign * eps
                cubic = {(3, 0, 0): 1, (1, 0, 0): e}
                yield "sheet", name, [polynomial_cell(
                    HEXAHEDRON, 4, [cubic, {**Y, (1, 0, 0): .125}, Z],
                    ((2, 2), (0, 0), (1, 1)), shear)], first(0)
                yield "line", name, [polynomial_cell(
                    HEXAHEDRON, 4, [{**cubic, (1, 2, 0): 1}, Y, Z], BACKWARDS, shear)], \
                    lambda _: [near(), near(), chance.uniform(-1, 1)]
                yield "point", name, [polynomial_cell(
                    HEXAHEDRON, 4, [{**cubic, (1, 2, 0): 1, (1, 0, 2): 1}, Y, Z], BACKWARDS,
                    shear)], lambda _: [near(), near(), near()]
                for shape in (HEXAHEDRON, PRISM, TETRAHEDRON):
                    face = {(2, 0, 0): .5, (1, 0, 0): 1 + e, (0, 1, 0): .25}
                    yield f"face of a {shape}", name, [polynomial_cell(
                        shape, 2, [face, Y, Z], BACKWARDS, shear)], first(-1)
        for shape in (HEXAHEDRON, PRISM, TETRAHEDRON):
            t2 = [{(2, 0, 0): 2, (0, 1, 0): .25}, {(0, 2, 0): 2, (0, 0, 1): .25}, {(0, 0, 2): 2}]
            yield f"folded {shape}", "to 8 preimages", [polynomial_cell(
                shape, 2, t2, BACKWARDS, shear)], anywhere
        t4 = [{tuple(4 if d == n else 0 for d in range(3)): 8,
               tuple(2 if d == n else 0 for d in range(3)): -8} for n in range(3)]
        yield "folded hexahedron", "to 64 preimages", [polynomial_cell(
            HEXAHEDRON, 4, t4, BACKWARDS, shear)], anywhere
        for bits in (20, 35, 50):
            large = 2.0 ** bits
            tall = {(1, 0, 0): 1, (0, 2, 0): large, (0, 0, 0): -large / 4}
            yield "cancels", f"2^{bits}", [polynomial_cell(
                HEXAHEDRON, 2, [tall, Y, Z], BACKWARDS, SHEARS[0])], \
                lambda _: [chance.uniform(-1, 1), chance.choice([-.5, .5]) + near(0, -16) / 64,
                           chance.uniform(-1, 1)]
        for bits in (10, 20, 30, 40):
            for sign, kind in ((1, "gap"), (-1, "overlap")):
                width = sign * 2.0 ** -bits
                pair = [polynomial_cell(HEXAHEDRON, 2, [
                    {(1, 0, 0): 1, (0, 2, 0): .25, (0, 0, 0): start}, Y, Z],
                    BACKWARDS, shear) for start in (0, 2 + width)]
                yield kind, f"2^-{bits}", pair, lambda cell, w=width: [
                    (1 if cell == 0 else -1) + chance.uniform(-1.5, 1.5) * abs(w),
                    chance.uniform(-1, 1), chance.uniform(-1, 1)]
    for name, fold in (("straight", 0), ("nearly flat", .49), ("folded", .75), ("crossed", 1.25)):
        for _ in range(2):
            twist = [chance.randrange(-64, 64) / 256 for _ in range(12)]
            corners = [[-1, -1, 0], [1, -1, 0], [1 - 2 * fold, 1 - 2 * fold, 0], [-1, 1, 0]]
            base = [[corner[c] + twist[3 * n + c] for c in range(3)]
                    for n, corner in enumerate(corners)]
            apex = [.125, -.25, 1]
            cone = Cell(PYRAMID, PYRAMID5, 1, Cone(base, apex), base + [apex])

            def ray(_):
                h = 10 ** chance.uniform(-15, 0)
                return [chance.uniform(0, 2) * h - 1, chance.uniform(0, 2) * h - 1, 1 - 2 * h]
            yield "cone", name, [cone], ray
    for order in (8, 16, 32):
        for name, part in (("injective", .3), ("wild", 3.0)):
            yield f"noise of order {order}", name, \
                [noise_cell(order, part / order, chance)], anywhere


def reference_point(cell, special, number, chance):
    """One half next to what is special, a quarter next to a face, a quarter anywhere."""
    while True:
        xi = special(number)
        if chance.random() < .5:
            xi = [chance.uniform(-1, 1) for _ in range(3)]
            if chance.random() < .5:
                apart = chance.choice([-1, 1]) * 10 ** chance.uniform(-16, -1)
                xi[chance.randrange(3)] = apart - 1
        if margin(cell.shape, xi) > -.2:
            return [mpf(v) for v in xi]


def write_vtu(path, cells):
    nodes = [node for cell in cells for node in cell.nodes]
    ends = [sum(len(c.nodes) for c in cells[:n + 1]) for n in range(len(cells))]

    def array(kind, name, numbers, extra=""):
        return (f'<DataArray type="{kind}" Name="{name}"{extra} format="ascii">'
                + " ".join(map(repr, numbers)) + "</DataArray>")
    path.write_text(
        '<?xml version="1.0"?>\n<VTKFile type="UnstructuredGrid" version="2.2" '
        'byte_order="LittleEndian"><UnstructuredGrid>'
        f'<Piece NumberOfPoints="{len(nodes)}" NumberOfCells="{len(cells)}">\n<PointData>'
        + array("Float64", "u", [1.0] * len(nodes)) + "</PointData>\n<Points>"
        + array("Float64", "Points", [v for n in nodes for v in n], ' NumberOfComponents="3"')
        + "</Points>\n<Cells>" + array("Int64", "connectivity", range(len(nodes)))
        + array("Int64", "offsets", ends) + array("UInt8", "types", [c.type for c in cells])
        + "</Cells></Piece></UnstructuredGrid></VTKFile>\n", encoding="ascii")


def probe(program, mesh, points, scratch, owners):
    table, out = scratch / "points.csv", scratch / "out.csv"
    table.write_text("x,y,z\n" + "".join(",".join(map(repr, x)) + "\n" for x in points))
    command = [program, "probe", str(mesh), "--field", "u", "--points", str(table), "--output",
               str(out), "--threads", "1", "--json"] + (["--owners"] if owners else [])
    run = subprocess.run(command, capture_output=True, text=True, check=True)
    seconds = json.loads(run.stdout)["seconds"]
    with open(out, encoding="utf-8") as file:
        return list(csv.DictReader(file)), seconds["bounds+bvh"] + seconds["probe"], \
            seconds.get("owners", 0.0)


def judge(cells, x, roots, row):
    """What is wrong with a row of the probe's table, or nothing. `roots`: (cell, xi, exact)."""
    wrong = []
    exact_point = [mpf(v) for v in x]
    held = [r for r in roots if r[2] and margin(cells[r[0]].shape, r[1]) >= 0]
    maybe, clear = 0, []
    for number, xi, exact in roots:
        cell = cells[number]
        inside = margin(cell.shape, xi)
        reach = CLEAR * cell.tolerance(xi) + mpf(10) ** -12 if exact else mpf("inf")
        maybe += inside >= -reach
        if inside > reach and all(n != number or max(abs(a - b) for a, b in zip(xi, other)) > reach
                                  for n, other in clear):
            clear.append((number, xi))
    if row["verdict"] == "outside" and held:
        wrong.append("outside")
    if row["verdict"] == "inside":
        cell = cells[int(row["element"])]
        xi = [mpf(float(row[f"xi_{d}"])) for d in range(3)]
        miss = max(abs(a - b) for a, b in zip(cell.known.value(xi), exact_point))
        if miss > MOST_MISS * cell.uncertainty:
            wrong.append(f"inside, misses by {mp.nstr(miss / cell.uncertainty, 3)} uncertainties")
        elif margin(cell.shape, xi) < -MOST_MISS * cell.tolerance(xi):
            wrong.append("inside, beyond a face")
    complete = all(cell.injective or not isinstance(cell.known, Noise) for cell in cells)
    coverage = row["coverage"]
    if coverage == "none" and held or coverage == "once" and len(clear) > 1 or \
            coverage == "several" and complete and maybe < 2:
        wrong.append(f"{coverage} with {len(clear)} to {maybe} preimages")
    return wrong


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("program")
    parser.add_argument("--points", type=int, default=40)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--only", default="")
    parser.add_argument("--keep", type=pathlib.Path)
    options = parser.parse_args()
    chance = random.Random(options.seed)
    failures = 0
    rows = {}
    with tempfile.TemporaryDirectory() as folder:
        scratch = pathlib.Path(folder)
        keep = options.keep or scratch
        keep.mkdir(parents=True, exist_ok=True)
        for count, (family, name, cells, special) in enumerate(cases(chance)):
            if options.only not in f"{family}, {name}":
                continue
            points, made = [], []
            noise = isinstance(cells[0].known, Noise)  # whose reference is slow
            for _ in range(2 * options.points // cells[0].known.order if noise else options.points):
                number = chance.randrange(len(cells))
                xi = reference_point(cells[number], special, number, chance)
                points.append([float(v) for v in cells[number].known.value(xi)])
                made.append(xi)
            mesh = keep / f"{count:03d}.vtu"
            write_vtu(mesh, cells)
            table, seconds, owner_seconds = probe(options.program, mesh, points, scratch, True)

            def tell(what, x, at=f"{mesh}: {family}, {name}"):
                print(f"{at}: {','.join(map(repr, x))}: {what}", file=sys.stderr)
            slowest = slowest_owner = 0.0
            if seconds <= SLOWEST and owner_seconds <= SLOWEST:
                slowest, slowest_owner = seconds, owner_seconds
            else:
                for x in points:
                    _, alone, owners = probe(options.program, mesh, [x], scratch, True)
                    if max(alone, owners) > SLOWEST:  # what else ran is not the point's
                        _, again, owners2 = probe(options.program, mesh, [x], scratch, True)
                        alone, owners = min(alone, again), min(owners, owners2)
                    slowest, slowest_owner = max(slowest, alone), max(slowest_owner, owners)
                    if max(alone, owners) > SLOWEST:
                        tell(f"slow: {alone * 1e3:.1f} ms, owners {owners * 1e3:.1f} ms", x)
            title = family
            if family.startswith(("cancels", "cone", "noise")):
                title += f", {name}"
            sums = rows.setdefault(title, [0] * 9 + [0.0, 0.0])
            for x, xi, row in zip(points, made, table):
                if noise:
                    root = cells[0].known.refine(xi, x)
                    miss = max(abs(a - b) for a, b in zip(cells[0].known.value(root), x))
                    roots = [(0, root, True)] if miss < 1e-40 else []
                else:
                    roots = [(n, *root) for n, cell in enumerate(cells)
                             for root in cell.known.preimages(x)]
                wrong = judge(cells, x, roots, row)
                for what in wrong:
                    tell(what, x)
                failures += len(wrong) > 0
                sums[0] += 1
                for k, verdict in enumerate(("inside", "outside", "unknown")):
                    sums[1 + k] += row["verdict"] == verdict
                for k, coverage in enumerate(("none", "once", "several", "undecided")):
                    sums[4 + k] += row["coverage"] == coverage
                sums[8] += len(wrong) > 0
            sums[9], sums[10] = max(sums[9], slowest), max(sums[10], slowest_owner)
    print("| element | points | inside | outside | unknown | none | once | several | undecided "
          "| wrong | slowest, ms | owners |")
    print("|---|" + "---:|" * 11)
    for title, sums in rows.items():
        times = [f"{1e3 * s:.2f}" for s in sums[9:]]
        print("| " + " | ".join([title, *map(str, sums[:9]), *times]) + " |")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
