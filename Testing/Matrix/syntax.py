#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Has another compiler read what a build folder compiles, warnings as errors, and makes nothing.

    syntax.py BUILD COMPILER [PATTERN] [--jobs N] [--skip PATTERN]

Of the sources in BUILD/compile_commands.json whose names PATTERN finds (default: all but those that
the build generates, which must be there). Without precompiled headers, and without the warnings that
need an optimiser. Exit status 1 where a file fails; the last line counts them.
"""
import argparse
import concurrent.futures
import json
import pathlib
import re
import shlex
import subprocess
import sys


def command_for(entry, compiler):
    words = shlex.split(entry["command"])
    while pathlib.Path(words[0]).name in ("ccache", "sccache"):
        words = words[1:]
    out = words.index("-o")
    words[out:out + 2] = []
    kept = []
    for word in words[1:]:
        if word.endswith("cmake_pch.hxx"):
            kept.pop()  # -include
        elif word not in ("-c", "-Winvalid-pch"):
            kept.append(word)
    return [compiler, "-fsyntax-only", "-Werror", *kept]


def read(entry, compiler):
    done = subprocess.run(command_for(entry, compiler), cwd=entry["directory"],
                          capture_output=True, text=True, check=False)
    return entry["file"], done.returncode, done.stderr


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("compiler")
    parser.add_argument("pattern", nargs="?", default="")
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--skip", default="(?!)")
    arguments = parser.parse_args()
    entries = json.loads((arguments.build / "compile_commands.json").read_text(encoding="utf-8"))
    build = str(arguments.build.resolve())
    wanted = {entry["file"]: entry for entry in entries
              if re.search(arguments.pattern, entry["file"])
              and not re.search(arguments.skip, entry["file"])
              and not entry["file"].startswith(build)}
    failed = 0
    with concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
        for file, status, said in pool.map(lambda e: read(e, arguments.compiler), wanted.values()):
            failed += status != 0
            print("failed" if status else "read  ", file, flush=True)
            if status:
                print(said[-3000:], flush=True)
    print(f"{arguments.compiler}: {len(wanted)} files, {failed} failed")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
