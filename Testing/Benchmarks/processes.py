#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Memory and time of each process of `mpirun -n N pixelexact render`.

    processes.py PIXELEXACT FILE... [--processes 1 2 4] [--size 1000x1000] [--options WORD...]

A plane through the middle of FILE (pieces_g2.pvtu of large_files.py, for instance), one thread each,
all buffers written. A Markdown table on stdout: of each rank the largest resident set and the user
time; and whether picture and buffers are, byte for byte, those of the first number of processes.
"""
import argparse
import filecmp
import json
import os
import pathlib
import subprocess
import sys
import tempfile


def measure(log, command):
    """One rank: runs the command, and writes what it used beside the others' logs."""
    rank = os.environ.get("OMPI_COMM_WORLD_RANK", os.environ.get("PMI_RANK", "0"))
    process = subprocess.Popen(command)
    _, status, usage = os.wait4(process.pid, 0)
    used = {"memory": 1024 * usage.ru_maxrss, "user": usage.ru_utime, "system": usage.ru_stime}
    pathlib.Path(f"{log}.{rank}").write_text(json.dumps(used), encoding="utf-8")
    return os.waitstatus_to_exitcode(status)


def run(arguments, processes, folder):
    """What each rank used, and the files that the first one wrote."""
    log = folder / f"log_{processes}"
    written = [folder / f"of_{processes}{suffix}" for suffix in (".png", ".vti")]
    command = [sys.executable, __file__, "--rank", str(log), arguments.tool, "render"]
    command += [*arguments.files, "--size", arguments.size, "--threads", "1", "--quiet"]
    command += ["--output", str(written[0]), "--buffers", str(written[1]), *arguments.options]
    start = ["mpirun", "--oversubscribe", "--bind-to", "none", "-n", str(processes)]
    subprocess.run(start + command if processes > 1 else command, check=True)
    used = [json.loads(pathlib.Path(f"{log}.{rank}").read_text(encoding="utf-8"))
            for rank in range(processes)]
    return used, written


def row(processes, used, same):
    def span(key, scale, form):
        rest = sorted(one[key] / scale for one in used[1:])
        first = format(used[0][key] / scale, form)
        if not rest:
            return first, ""
        low, high = format(rest[0], form), format(rest[-1], form)
        return first, low if low == high else f"{low} to {high}"

    memory, user = span("memory", 1e6, ".0f"), span("user", 1.0, ".1f")
    total = sum(one["memory"] for one in used) / 1e6
    return (f"| {processes} | {memory[0]} MB | {memory[1]} | {total:.0f} MB | {user[0]} s | {user[1]} |"
            f" {same} |")


def main():
    if len(sys.argv) > 2 and sys.argv[1] == "--rank":
        return measure(sys.argv[2], sys.argv[3:])
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("tool")
    parser.add_argument("files", nargs="+")
    parser.add_argument("--processes", nargs="+", type=int, default=[1, 2, 4])
    parser.add_argument("--size", default="1000x1000")
    parser.add_argument("--options", nargs=argparse.REMAINDER, default=[])
    arguments = parser.parse_args()
    print("| processes | memory of the first | of the others | of all | user time of the first |"
          " of the others | files |\n|---|---|---|---|---|---|---|")
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        first = None
        for processes in arguments.processes:
            used, written = run(arguments, processes, folder)
            first = first or written
            same = all(filecmp.cmp(a, b, shallow=False) for a, b in zip(first, written))
            print(row(processes, used, "the same" if same else "differ"), flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
