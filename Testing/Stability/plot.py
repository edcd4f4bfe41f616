#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Plots of the stability study's tables, beside them.

usage: plot.py DIRECTORY    (with rows.csv, location.csv, evaluation.csv)
"""
import csv
import math
import pathlib
import sys

try:
    import matplotlib
except ImportError:
    print("plot.py: no matplotlib (Debian: python3-matplotlib), so no plots; the tables are there.")
    sys.exit(0)
matplotlib.use("Agg")
from matplotlib import pyplot  # noqa: E402: the backend comes first

SHAPES = ["hexahedron", "prism", "tetrahedron", "pyramid", "pyramid, Tensor"]
COLORS = dict(zip(SHAPES, ["#0072b2", "#e69f00", "#009e73", "#cc79a7", "#d55e00"]))
NOT_MEASURABLE = 1e-3
# Sums that cancel altogether have no condition.
LARGEST_CONDITION = 1e30


def read(path):
    with open(path, encoding="utf-8") as file:
        return [{k: number(v) for k, v in row.items()} for row in csv.DictReader(file)]


def number(text):
    try:
        return float(text)
    except ValueError:
        return text


def scatter(points, title, unit, path):
    """Errors against condition, with the largest bound of any point at about that condition."""
    figure, axes = pyplot.subplots(figsize=(7, 4.5))
    points = [p for p in points if p["condition"] < LARGEST_CONDITION]
    for shape in SHAPES:
        some = [p for p in points if p["shape"] == shape]
        axes.plot([p["condition"] for p in some],
                  [max(p["error"], NOT_MEASURABLE) for p in some],
                  ".", markersize=2, alpha=0.5, color=COLORS[shape], label=shape)
    bounds = {}
    for point in points:
        key = round(4 * decade(point["condition"]))
        bounds[key] = max(bounds.get(key, 0.0), point["bound"])
    keys = sorted(bounds)
    axes.plot([10 ** (k / 4) for k in keys], [bounds[k] for k in keys],
              "k-", linewidth=1, label="largest bound")
    axes.set(xscale="log", yscale="log", title=title, xlabel="condition", ylabel=unit)
    axes.legend(fontsize=8, markerscale=5)
    axes.grid(alpha=0.3)
    save(figure, path)


def decade(value):
    return math.log10(max(value, 1.0))


def orders(rows, path):
    """Errors of value and gradient against the order, coefficients of one size."""
    figure, both = pyplot.subplots(1, 2, figsize=(10, 4), sharex=True)
    for axes, key, title in zip(both, ["value_magnitude_ulps", "gradient_magnitude_ulps"],
                                ["value", "gradient by xi"]):
        for shape in SHAPES:
            some = [r for r in rows if r["sweep"] == "equal coefficients" and r["shape"] == shape]
            axes.plot([r["order"] for r in some], [r[key] for r in some],
                      ".-", color=COLORS[shape], label=shape)
        axes.set(title=title, xlabel="order", ylabel="error, ulps of sum |c| |mode|")
        axes.grid(alpha=0.3)
        axes.legend(fontsize=8)
    save(figure, path)


def nodes(rows, path):
    figure, axes = pyplot.subplots(figsize=(7, 4.5))
    for sweep, shape, style in [("equispaced nodes", "hexahedron", ".-"),
                                ("equispaced nodes", "tetrahedron", ".-"),
                                ("Gauss-Lobatto nodes", "hexahedron", ".--")]:
        some = [r for r in rows if r["sweep"] == sweep and r["shape"] == shape]
        axes.plot([r["order"] for r in some], [2.0 ** -52 * r["value_ulps"] for r in some],
                  style, color=COLORS[shape], label=f"{shape}, {sweep}")
    axes.axhline(1.0, color="black", linewidth=1)
    axes.set(yscale="log", title="Interpolation of values rounded to double",
             xlabel="order", ylabel="largest error over the largest value")
    axes.grid(alpha=0.3)
    axes.legend(fontsize=8)
    save(figure, path)


def sweeps(rows, path):
    """The location's errors along each sweep, over what rounding and conditioning allow."""
    names = list(dict.fromkeys(r["sweep"] for r in rows if r["backward_over_bound"] > 0))
    columns = 3
    lines = -(-len(names) // columns)
    figure, grid = pyplot.subplots(lines, columns, figsize=(12, 2.8 * lines), squeeze=False)
    for axes, name in zip(grid.flat, names):
        some = [r for r in rows if r["sweep"] == name]
        for shape in SHAPES:
            mine = [r for r in some if r["shape"] == shape]
            axes.plot([r["at"] for r in mine], [r["xi_over_bound"] for r in mine],
                      ".-", color=COLORS[shape], label=shape)
            axes.plot([r["at"] for r in mine], [r["backward_over_bound"] for r in mine],
                      ":", color=COLORS[shape])
        values = [r["at"] for r in some]
        if min(values) > 0 and max(values) > 100 * min(values):
            axes.set_xscale("log")
        axes.set(title=name, xlabel=some[0]["parameter"], ylim=(0, 1.05))
        axes.grid(alpha=0.3)
    for axes in list(grid.flat)[len(names):]:
        axes.axis("off")
    grid.flat[0].legend(fontsize=7)
    figure.supylabel("error over its bound: xi (line), Phi(xi) - x (dotted)")
    save(figure, path)


def save(figure, path):
    figure.tight_layout()
    figure.savefig(path, dpi=100)
    pyplot.close(figure)
    print(path)


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    folder = pathlib.Path(sys.argv[1])
    rows = read(folder / "rows.csv")
    scatter(read(folder / "location.csv"), "Location: error of xi against condition",
            "error of xi, units of 2^-53", folder / "location.png")
    scatter(read(folder / "evaluation.csv"), "Evaluation: error of the value against condition",
            "error, ulps of the value", folder / "evaluation.png")
    orders(rows, folder / "orders.png")
    nodes(rows, folder / "nodes.png")
    sweeps(rows, folder / "sweeps.png")


if __name__ == "__main__":
    main()
