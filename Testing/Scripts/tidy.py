#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Reads sources with clang-tidy: those that changed and those that include what changed first, then
the rest, in another order for each commit, until the time is used up.

    tidy.py BUILD... [--seconds S]   each holds compile_commands.json; without S every source is read
    tidy.py --advance                before a new piece of work: what is committed now has been read

tidy.json records the commit up to which changes have been read, and by which clang-tidy. Where that
is unknown, or the configuration or the dependencies changed, no source comes first. The number of
sources that were not read is reported; it is not a failure.
"""

import argparse
import concurrent.futures
import json
import os
import pathlib
import re
import subprocess
import sys
import time
import zlib

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "Testing" / "Layers"))
from check_layers import CHECKED, INCLUDE, SUFFIXES, resolve  # noqa: E402

RECORD = ROOT / "Testing" / "Scripts" / "tidy.json"
# What every source depends on.
CONFIGURATION = {
    ".clang-tidy",
    "Module/CMake/PixelExactDependencies.cmake",
    "Testing/Scripts/install-dependencies.sh",
    "Testing/Scripts/tidy.py",
}
OWN_SOURCE = re.compile(r"(Module|Filters|Rendering|ParaView)/.*\.cxx$")
# clang cannot read what gcc precompiled, and does not know the warnings that are off with it.
PRECOMPILED = re.compile(
    r" -Winvalid-pch| -include \S*cmake_pch\.hxx| -Wno-(restrict|stringop-\w+)(?= )"
)


def git(*arguments):
    result = subprocess.run(
        ["git", "-C", str(ROOT), *arguments], capture_output=True, text=True, check=False
    )
    return result.stdout.strip() if result.returncode == 0 else None


def version():
    text = subprocess.run(["clang-tidy", "--version"], capture_output=True, text=True, check=True)
    return re.search(r"version (\S+)", text.stdout)[1]


def changed_since(base):
    """Paths that differ from `base`, uncommitted ones included; None where that is unknown."""
    if git("merge-base", "--is-ancestor", base, "HEAD") is None:
        return None
    tracked = git("diff", "--name-only", base)
    new = git("ls-files", "--others", "--exclude-standard")
    return set((tracked + "\n" + new).split())


def includers():
    """For each file of the project, those that include it directly."""
    found = {}
    for top in CHECKED:
        for file in (ROOT / top).rglob("*"):
            if file.suffix not in SUFFIXES:
                continue
            path = file.relative_to(ROOT).as_posix()
            for line in file.read_text(encoding="utf-8").splitlines():
                match = INCLUDE.match(line)
                target = resolve(ROOT, path, match[1]) if match else None
                if target:
                    found.setdefault(target, set()).add(path)
    return found


def with_includers(paths):
    by = includers()
    reached = set(paths)
    todo = list(paths)
    while todo:
        for path in by.get(todo.pop(), ()):
            if path not in reached:
                reached.add(path)
                todo.append(path)
    return reached


def order(sources, record):
    """The sources in the order in which they are read, how many of them are due, and why."""
    changed = changed_since(record["base"])
    due = set()
    if changed is None:
        reason = "no record of what has been read"
    elif record["clang-tidy"] != version():
        reason = f"clang-tidy {version()}"
    elif changed & CONFIGURATION:
        reason = "changed is " + ", ".join(sorted(changed & CONFIGURATION))
    else:
        due = with_includers(changed)
        reason = "changed, or including what changed"
    seed = git("rev-parse", "HEAD") or ""
    rest = sorted((s for s in sources if s not in due), key=lambda s: zlib.crc32((seed + s).encode()))
    first = [s for s in sources if s in due] or rest
    return first + (rest if due else []), len(first), reason


def advance():
    record = {"base": git("rev-parse", "HEAD"), "clang-tidy": version()}
    RECORD.write_text(json.dumps(record, indent=2) + "\n", encoding="utf-8")


def read_one(folder, path):
    """Whether clang-tidy is content with one source."""
    # One of Highway's instruction sets is enough to read a kernel.
    run = subprocess.run(
        ["clang-tidy", "-quiet", "-p", str(folder), "-extra-arg=-DHWY_COMPILE_ONLY_STATIC"]
        + [str(ROOT / path)],
        capture_output=True,
        text=True,
        check=False,
    )
    if run.returncode != 0:
        print(run.stdout + run.stderr, flush=True)
    return run.returncode == 0


def commands_of(builds):
    """Of each source, as the first build that has it compiles it."""
    found = {}
    for build in builds:
        for command in json.loads((build / "compile_commands.json").read_text(encoding="utf-8")):
            command["command"] = PRECOMPILED.sub("", command["command"])
            found.setdefault(command["file"], command)
    return list(found.values())


def read(builds, seconds):
    commands = commands_of(builds)
    folder = builds[0] / "tidy"
    folder.mkdir(exist_ok=True)
    (folder / "compile_commands.json").write_text(json.dumps(commands), encoding="utf-8")
    relative = {
        pathlib.Path(c["file"]).resolve().relative_to(ROOT).as_posix()
        for c in commands
        if pathlib.Path(c["file"]).resolve().is_relative_to(ROOT)
    }
    sources = sorted(path for path in relative if OWN_SOURCE.match(path))
    ordered, due, reason = order(sources, json.loads(RECORD.read_text(encoding="utf-8")))
    print(f"{due} of {len(sources)} sources are due: {reason}", flush=True)
    end = None if seconds is None else time.monotonic() + seconds

    def visit(path):
        if end is not None and time.monotonic() > end:
            return None
        return read_one(folder, path)

    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        results = list(pool.map(visit, ordered))
    wrong = [path for path, good in zip(ordered, results) if good is False]
    unread = results.count(None)
    print(f"{len(sources) - unread} read, {len(wrong)} with findings, {unread} not read for want of time")
    for path in wrong:
        print(f"  {path}")
    return 1 if wrong else 0


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("build", nargs="*", type=pathlib.Path)
    parser.add_argument("--seconds", type=float)
    parser.add_argument("--advance", action="store_true")
    arguments = parser.parse_args()
    if arguments.advance:
        advance()
        return 0
    if not arguments.build:
        parser.error("BUILD is missing")
    return read([build.resolve() for build in arguments.build], arguments.seconds)


if __name__ == "__main__":
    sys.exit(main())
