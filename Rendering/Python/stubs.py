#!/usr/bin/env python3
"""Writes stubs (.pyi) of wrapped modules from their help texts.

Usage: stubs.py FOLDER MODULE...
"""

import importlib
import re
import sys
from pathlib import Path

# Names that VTK's wrapping writes for Python's own types.
_PLAIN = {"int", "float", "str", "bool", "None", "Any"}
_HEAD = """# Made by stubs.py: the classes as VTK wraps them.
from typing import Any, Sequence

"""


def type_of(text, known):
    """The type of a parameter or result; Any if the help text does not state it."""
    text = text.strip()
    if text in _PLAIN or text in known:
        return text
    if text.startswith("(") or text.startswith("["):
        numbers = re.findall(r"\w+", text)
        inner = numbers[0] if numbers and set(numbers) <= {"int", "float"} else "Any"
        return f"Sequence[{inner}]" if text.startswith("(") else "Any"
    return "Any"


def split(parameters):
    """Splits at commas outside brackets."""
    parts, depth, word = [], 0, ""
    for letter in parameters:
        depth += letter in "([" or -(letter in ")]")
        if letter == "," and depth == 0:
            parts.append(word)
            word = ""
        else:
            word += letter
    return [part for part in [*parts, word] if part.strip()]


def signatures(name, text, known):
    """Lines of definitions, without their indentation, of a method's text."""
    joined = re.sub(r"\s*\n\s+", " ", text)
    for line in re.findall(rf"^{name}\((.*?)\)(?: -> ([^\n]*?))?(?=\s*$|\s+C\+\+:)", joined, re.M):
        words = []
        for i, parameter in enumerate(split(line[0])):
            word, _, kind = parameter.strip().partition(":")
            if word == "self":
                words.append("self")
                continue
            # Names of parameters differ between releases, and VTK takes none by name.
            words.append(f"__a{i}: {type_of(kind.split('=')[0], known)}")
        yield words, type_of(line[1] or "Any", known)


def method(name, text, known):
    """The definition, or definitions where it is overloaded."""
    found = list(dict.fromkeys((tuple(w), r) for w, r in signatures(name, text or "", known)))
    if len(found) != 1:
        # Overloads that only differ in what is Any would be refused.
        return [f"    def {name}(self, *arguments: Any) -> Any: ..."]
    words, result = found[0]
    if not words or words[0] != "self":
        return ["    @staticmethod", f"    def {name}({', '.join(words)}) -> {result}: ..."]
    return [f"    def {name}({', '.join(words)}) -> {result}: ..."]


def stub(module):
    known = {name for name in dir(module) if name.startswith("vtk")}
    own = {name for name in known if getattr(module, name).__module__ == module.__name__}
    lines = []
    imports = set()
    for name in sorted(own, key=lambda each: (len(getattr(module, each).__mro__), each)):
        kind = getattr(module, name)
        base = kind.__mro__[1]
        parent = base.__name__
        if base.__module__ != module.__name__:
            imports.add(f"from {base.__module__} import {base.__name__} as {base.__name__}")
        lines.append(f"class {name}({parent}):")
        members = []
        for member, value in sorted(vars(kind).items()):
            if member.startswith("_"):
                continue
            if isinstance(value, int):
                members.append(f"    {member}: int")
            elif callable(value) or type(value).__name__ in ("staticmethod", "classmethod"):
                members += method(member, getattr(kind, member).__doc__, own)
        lines += members or ["    ..."]
    return _HEAD + "\n".join(sorted(imports)) + "\n\n" + "\n".join(lines) + "\n"


def main():
    folder = Path(sys.argv[1])
    for name in sys.argv[2:]:
        module = importlib.import_module(f"pixelexact.{name}")
        (folder / f"{name}.pyi").write_text(stub(module), encoding="utf-8")


if __name__ == "__main__":
    main()
