#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Makes the figures of Module/Documentation/cookbook.md: runs each line of it that is a command.

Usage: Examples/cookbook.py [PROGRAM]   (default: build/bin/pixelexact)
Pictures are left in ./pictures.
"""

import shlex
import subprocess
import sys
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent


def commands():
    """The page's commands, as words."""
    page = (ROOT / "Module/Documentation/cookbook.md").read_text(encoding="utf-8")
    lines = [line.strip() for line in page.splitlines() if line.startswith("    ")]
    return [shlex.split(line) for line in lines if line.startswith("pixelexact ")]


def main():
    program = sys.argv[1] if len(sys.argv) > 1 else str(ROOT / "build/bin/pixelexact")
    Path("pictures").mkdir(exist_ok=True)
    for words in commands():
        # The data are the repository's, wherever this runs.
        words = [str(ROOT / word) if word.startswith("Data/") else word for word in words]
        begin = time.monotonic()
        subprocess.run([program, *words[1:], "--quiet", "--no-config"], check=True)
        print(f"{words[-1]}: {time.monotonic() - begin:.1f} s")


if __name__ == "__main__":
    main()
