#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Ratios of one run of PixelExactBenchmarks, as a Markdown table.

usage: PixelExactBenchmarks --benchmark_format=json > run.json; table.py run.json
"""
import json
import sys


def main():
    with open(sys.argv[1], encoding="utf-8") as file:
        runs = [r for r in json.load(file)["benchmarks"] if "ns_per_point" in r]
    kernel = {r["label"]: r["ns_per_point"] for r in runs if r["name"].startswith("BareKernel")}
    print("| data set | what | ns per point inside | over the bare kernel | points | notes |")
    print("|---|---|---|---|---|---|")
    for run in sorted(runs, key=lambda r: r["label"]):
        notes = []
        if "tbb_threads" in run:
            notes.append(f"{run['tbb_threads']:.0f} threads")
        if "lost_percent" in run:
            notes.append(f"{run['lost_percent']:.1f} % of the points lost")
            notes.append(f"largest error {run['error_of_range']:.1e} of the range")
        ratio = run["ns_per_point"] / kernel[run["label"]]
        print(f"| {run['label']} | {run['name'].split('/iterations')[0]} |"
              f" {run['ns_per_point']:.3g} | {ratio:.3g} | {run['points']:.0f} |"
              f" {', '.join(notes)} |")


if __name__ == "__main__":
    main()
