#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What a build folder's last run of ctest, or its build, has to say.

    report.py tests BUILD    failures, the ten slowest tests, and "N passed, N failed, N skipped"
    report.py list BUILD     the names of the tests that ran
    report.py files BUILD    the ten files that took longest to compile

A GoogleTest program runs as several processes, each with its share of the tests, and each leaves a
JSON file; a process that died before it could write one counts as one failed test. All else is in
ctest's own report (--output-junit BUILD/Testing/junit.xml).
"""

import json
import pathlib
import re
import sys
import xml.etree.ElementTree

SHOWN = 10
# Of a failed process: from the first line that names an error on, at most so many lines.
OUTPUT_LINES = 120
ERROR = re.compile(r"ERROR: |runtime error|\[  FAILED  \]|Segmentation|terminate called|Error")


class Test:
    def __init__(self, name, seconds, outcome, message=""):
        self.name = name
        self.seconds = seconds
        self.outcome = outcome  # passed, failed or skipped
        self.message = message


def google_tests(program, path):
    for suite in json.loads(path.read_text(encoding="utf-8"))["testsuites"]:
        for test in suite["testsuite"]:
            failures = "\n".join(f["failure"] for f in test.get("failures", []))
            outcome = "passed"
            if failures:
                outcome = "failed"
            elif test["result"] == "SKIPPED":
                outcome = "skipped"
            name = f"{program}.{suite['name']}.{test['name']}"
            yield Test(name, float(test["time"].rstrip("s")), outcome, failures)


def excerpt(output):
    lines = output.splitlines()
    first = next((i for i, line in enumerate(lines) if ERROR.search(line)), 0)
    first = max(0, min(first, len(lines) - 20))
    return "\n".join(lines[first : first + OUTPUT_LINES])


def all_tests(build):
    report = xml.etree.ElementTree.parse(build / "Testing" / "junit.xml").getroot()
    for case in report.iter("testcase"):
        name = case.get("name")
        results = build / "Testing" / "Results" / f"{name}.json"
        failed = case.get("status") == "fail"
        found = []
        if results.exists():
            found = list(google_tests(name.rsplit(".", 1)[0], results))
        yield from found
        if failed and not any(test.outcome == "failed" for test in found):
            output = case.findtext("system-out") or ""
            yield Test(name, float(case.get("time")), "failed", excerpt(output))
        elif not results.exists() and not failed:
            skipped = case.get("status") != "run"
            yield Test(name, float(case.get("time")), "skipped" if skipped else "passed")


def report_tests(build):
    tests = list(all_tests(build))
    for test in tests:
        if test.outcome == "failed":
            print(f"FAILED {test.name}\n{test.message}\n")
    print("slowest tests:")
    for test in sorted(tests, key=lambda t: -t.seconds)[:SHOWN]:
        print(f"{test.seconds:8.2f} s  {test.name}")
    counts = [sum(t.outcome == o for t in tests) for o in ("passed", "failed", "skipped")]
    print("{} passed, {} failed, {} skipped".format(*counts))


def list_tests(build):
    for name in sorted(test.name for test in all_tests(build)):
        print(name)


def report_files(build):
    seconds = {}
    for line in (build / ".ninja_log").read_text(encoding="utf-8").splitlines()[1:]:
        start, end, _, output, _ = line.split("\t")
        if output.endswith((".o", ".gch")):
            seconds[output] = (int(end) - int(start)) / 1000.0
    print("slowest files:")
    for output in sorted(seconds, key=lambda o: -seconds[o])[:SHOWN]:
        print(f"{seconds[output]:8.2f} s  {re.sub(r'CMakeFiles/[^/]*/', '', output)}")
    print(f"{sum(seconds.values()):8.2f} s  all {len(seconds)}, one after the other")


def main():
    commands = {"tests": report_tests, "list": list_tests, "files": report_files}
    if len(sys.argv) != 3 or sys.argv[1] not in commands:
        sys.exit(__doc__)
    commands[sys.argv[1]](pathlib.Path(sys.argv[2]))


if __name__ == "__main__":
    main()
