#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Reads sources with clang-tidy: those that changed, those that include what changed, and a third
of the rest, so that three runs in a row read everything.

    tidy.py BUILD [--all]    BUILD holds compile_commands.json; --all: every source
    tidy.py --advance        before a new piece of work: what is committed now has been read,
                             and the next third is due

tidy.json records the commit up to which changes have been read, and which third is due. Everything
is read where clang-tidy's configuration or version or the dependencies changed, and where the
record is too old to say.
"""

import argparse
import json
import pathlib
import re
import subprocess
import sys
import zlib

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "Testing" / "Layers"))
from check_layers import INCLUDE, INCLUDE_ROOTS, SUFFIXES, resolve  # noqa: E402

RECORD = ROOT / "Testing" / "Scripts" / "tidy.json"
PARTS = 3
# A record that nobody advances must not leave two thirds unread for ever.
MAX_COMMITS = 100
# What every source depends on.
CONFIGURATION = {
    ".clang-tidy",
    "Module/CMake/PixelExactDependencies.cmake",
    "Testing/Scripts/install-dependencies.sh",
    "Testing/Scripts/tidy.py",
}
OWN_SOURCE = re.compile(r"(Module|Filters|Rendering)/.*\.cxx$")
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
    """Paths that differ from `base`, uncommitted ones included; None where that cannot be told."""
    if git("merge-base", "--is-ancestor", base, "HEAD") is None:
        return None
    if int(git("rev-list", "--count", f"{base}..HEAD")) > MAX_COMMITS:
        return None
    tracked = git("diff", "--name-only", base)
    new = git("ls-files", "--others", "--exclude-standard")
    return set((tracked + "\n" + new).split())


def includers():
    """For each file of the project, those that include it directly."""
    found = {}
    for top in INCLUDE_ROOTS:
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


def select(sources, record):
    """The sources to read, and why as a sentence."""
    changed = changed_since(record["base"])
    if changed is None:
        return sources, "everything: no recent record of what has been read"
    reasons = sorted(changed & CONFIGURATION)
    if record["clang-tidy"] != version():
        reasons.append(f"clang-tidy {version()}")
    if reasons:
        return sources, "everything: changed is " + ", ".join(reasons)
    reached = with_includers(changed)
    own = [s for s in sources if s in reached]
    due = [s for s in sources if zlib.crc32(s.encode()) % PARTS == record["part"]]
    chosen = sorted(set(own) | set(due))
    return chosen, f"{len(own)} changed or including what changed, and part {record['part']}"


def advance(record):
    record["base"] = git("rev-parse", "HEAD")
    record["part"] = (record["part"] + 1) % PARTS
    record["clang-tidy"] = version()
    RECORD.write_text(json.dumps(record, indent=2) + "\n", encoding="utf-8")


def read(build, choose_all):
    commands = json.loads((build / "compile_commands.json").read_text(encoding="utf-8"))
    for command in commands:
        command["command"] = PRECOMPILED.sub("", command["command"])
    folder = build / "tidy"
    folder.mkdir(exist_ok=True)
    (folder / "compile_commands.json").write_text(json.dumps(commands), encoding="utf-8")
    relative = {
        pathlib.Path(c["file"]).resolve().relative_to(ROOT).as_posix()
        for c in commands
        if pathlib.Path(c["file"]).resolve().is_relative_to(ROOT)
    }
    sources = sorted(path for path in relative if OWN_SOURCE.match(path))
    record = json.loads(RECORD.read_text(encoding="utf-8"))
    chosen, reason = (sources, "all were asked for") if choose_all else select(sources, record)
    print(f"{len(chosen)} of {len(sources)} sources: {reason}", flush=True)
    if not chosen:
        return 0
    # One of Highway's instruction sets is enough to read a kernel.
    return subprocess.run(
        ["run-clang-tidy", "-quiet", "-p", str(folder), "-extra-arg=-DHWY_COMPILE_ONLY_STATIC"]
        + [f"^{re.escape(str(ROOT / path))}$" for path in chosen],
        check=False,
    ).returncode


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("build", nargs="?", type=pathlib.Path)
    parser.add_argument("--all", action="store_true")
    parser.add_argument("--advance", action="store_true")
    arguments = parser.parse_args()
    if arguments.advance:
        advance(json.loads(RECORD.read_text(encoding="utf-8")))
        return 0
    if arguments.build is None:
        parser.error("BUILD is missing")
    return read(arguments.build.resolve(), arguments.all)


if __name__ == "__main__":
    sys.exit(main())
