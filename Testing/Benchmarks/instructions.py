#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Counts the instructions of frames and bare kernels under callgrind, and compares the frames'
with the counts on record. Exit status 1 when one has grown by more than the tolerance, 77 where
valgrind does not know an instruction of this processor that a library uses.

    instructions.py build/bin/InstructionCounts [--record]
"""

import argparse
import json
import pathlib
import re
import subprocess
import sys
import tempfile

RECORD = pathlib.Path(__file__).with_name("instructions.json")
# The same program counts the same; another compiler or library of the same distribution, a little
# more or less.
TOLERANCE = 0.05
SKIPPED = 77


def count(program):
    """{case: {"points", "frame", "kernel"}} and the instruction set that valgrind runs."""
    with tempfile.TemporaryDirectory() as folder:
        result = subprocess.run(
            [
                "valgrind",
                "--tool=callgrind",
                "--instr-atstart=no",
                f"--callgrind-out-file={folder}/out",
                program,
            ],
            capture_output=True,
            text=True,
            check=False,
        )
        if "Illegal opcode" in result.stderr:
            print(f"valgrind does not know an instruction of this processor:\n{result.stderr[-1000:]}")
            sys.exit(SKIPPED)
        if result.returncode != 0:
            sys.exit(f"{program} failed under valgrind:\n{result.stderr[-2000:]}")
        lines = dict(line.split("\t") for line in result.stdout.splitlines())
        instruction_set = lines.pop("instruction set")
        cases = {name: {"points": int(points)} for name, points in lines.items()}
        for path in pathlib.Path(folder).iterdir():
            text = path.read_text(encoding="utf-8")
            name = re.search(r"^desc: Trigger: Client Request: (.*)\t(frame|kernel)$", text, re.M)
            total = re.search(r"^(?:summary|totals): (\d+)", text, re.M)
            if name and total:
                cases[name[1]][name[2]] = int(total[1])
    return instruction_set, cases


def compiler():
    """What the counts depend on beside the sources."""
    version = subprocess.run(["c++", "-dumpfullversion"], capture_output=True, text=True, check=True)
    return "c++ " + version.stdout.strip()


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("program")
    parser.add_argument("--record", action="store_true", help="write the counts as the new record")
    arguments = parser.parse_args()
    instruction_set, cases = count(arguments.program)
    made_by = f"{compiler()}, {instruction_set}"
    record = json.loads(RECORD.read_text(encoding="utf-8")) if RECORD.exists() else {"cases": {}}
    known = record["cases"] if record.get("made_by") == made_by else {}
    failed = False
    print(f"{'instructions a point':32} {'kernel':>8} {'frame':>8} {'ratio':>6} {'on record':>10}")
    for name, case in cases.items():
        frame = case["frame"] / case["points"]
        kernel = case["kernel"] / case["points"]
        line = f"{name:32} {kernel:8.1f} {frame:8.1f} {frame / kernel:6.2f}"
        before = known.get(name)
        if before:
            change = frame / before - 1
            line += f" {before:10.1f} {100 * change:+.1f} %"
            if change > TOLERANCE:
                failed = True
                line += "  TOO MANY"
        print(line)
    if arguments.record:
        frames = {name: round(case["frame"] / case["points"], 1) for name, case in cases.items()}
        record = {"made_by": made_by, "cases": frames}
        RECORD.write_text(json.dumps(record, indent=2) + "\n", encoding="utf-8")
    elif not known:
        print(f"nothing compared: the record was made by {record.get('made_by')}, not {made_by}")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
