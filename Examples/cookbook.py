#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Runs the lines of Module/Documentation/cookbook.md that are commands, or those that are Python.

Usage: Examples/cookbook.py [PROGRAM]   (default: build/bin/pixelexact)
       Examples/cookbook.py --python    (with the package pixelexact in PYTHONPATH)
Pictures are left in ./pictures.
"""

import shlex
import subprocess
import sys
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent


def lines_after(prompt):
    """What follows the prompt in the page's indented lines that begin with it."""
    page = (ROOT / "Module/Documentation/cookbook.md").read_text(encoding="utf-8")
    lines = [line.strip() for line in page.splitlines() if line.startswith("    ")]
    return [line.removeprefix(prompt) for line in lines if line.startswith(prompt)]


def run_python():
    """Runs the lines of Python one after the other, and prints the value of each."""
    names = {}
    for line in lines_after(">>> "):
        # The data are the repository's, wherever this runs.
        code = line.replace('"Data/', f'"{ROOT}/Data/')
        try:
            value = eval(code, names)
        except SyntaxError:
            exec(code, names)
            continue
        print(f"{line}: {value}".replace("\n", " "))


def main():
    Path("pictures").mkdir(exist_ok=True)
    if sys.argv[1:] == ["--python"]:
        run_python()
        return
    program = sys.argv[1] if len(sys.argv) > 1 else str(ROOT / "build/bin/pixelexact")
    for words in map(shlex.split, lines_after("pixelexact ")):
        words = [str(ROOT / word) if word.startswith("Data/") else word for word in words]
        begin = time.monotonic()
        # Reports and tables would hide the times.
        subprocess.run([program, *words, "--quiet", "--no-config"], check=True, stdout=subprocess.DEVNULL)
        print(f"{words[0]} {words[-1]}: {time.monotonic() - begin:.1f} s")


if __name__ == "__main__":
    main()
