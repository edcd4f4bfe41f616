#!/usr/bin/env python3
"""Checks that sources use the terms that replaced unclear words, and that comments are sentences.

Usage: check_words.py [PROJECT_ROOT]

Prints one line per offence, `file:line: word, write ...`, and exits with 1 if there was any.
"""

import re
import sys
from pathlib import Path

FOLDERS = ["Module", "Filters", "Rendering", "ParaView"]
# What is found, and what to write.
WORDS = {
    r"\btold\b|\btells?\b|\bTell[A-Z]\w*": "report, classify or contain",
    r"\bhalv(e|es|ed|ing)\b|\w*Halv\w*": "subdivide, child or level",
    r"\bk(Most|Least|Usual|Deepest|Some)([A-Z_]\w*)?\b": "kMax, kMin or kDefault",
    r"\bThe[A-Z]\w+\b(?=\s*(;|\.|->|\(|=|\[|\)|,))": "the member without its article",
    r"\b\w*(Judge|Settler|Referee|Knobs|Looks)\b": "Classifier, Refiner, Fallback, Quality",
    r"\banew\b": "again or recompute",
    r"\bmay be spent\b|\bis spent\b": "work budget",
    r"^\s*///?\s*(Of|What|Whose|Whether it is) [^\n]*\.\s*$": "a sentence with a verb",
}


def offences(path):
    lines = path.read_text(encoding="utf-8").splitlines()
    for number, line in enumerate(lines, 1):
        for pattern, instead in WORDS.items():
            match = re.search(pattern, line)
            if match:
                yield f"{path}:{number}: '{match[0].strip()}', write {instead}"


def main(root):
    found = [
        offence
        for folder in FOLDERS
        for path in sorted((root / folder).rglob("*"))
        if path.suffix in (".h", ".cxx")
        for offence in offences(path)
    ]
    print("\n".join(found))
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(Path(sys.argv[1] if len(sys.argv) > 1 else ".")))
