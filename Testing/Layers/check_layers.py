#!/usr/bin/env python3
"""Checks that no #include runs against the direction in which the project is built.

Usage: check_layers.py [PROJECT_ROOT]

Prints one line per offence, `file:line: what`, and exits with 1 if there was any.
"""

import os
import re
import sys
from pathlib import Path, PurePosixPath

# A file of a layer may include its own layer and those before it.
CORE_LAYERS = [
    "Base",
    "Math",
    "Shape",
    "Basis",
    "Bernstein",
    "Element",
    "Bounds",
    "Tree",
    "Index",
    "Questions",
    "Location",
    "Faces",
    "Contour",
    "Integral",
]

# The same of the program, whose window and main functions may include all of them.
TOOL_LAYERS = [
    "Base",
    "Drawing",
    "Input",
    "Scene",
    "Picture",
    "Bench",
    "Trade",
    "Commands",
]

# What the files of each room may include. Filters and Rendering do not know each other, and nothing
# includes the programs that stand on top.
ALLOWED = {
    "Core": {"Core"},
    "DataModel": {"Core", "DataModel"},
    "Formats": {"Core", "Formats"},
    "Filters": {"Core", "DataModel", "Formats", "Filters"},
    "Trace": {"Core", "Trace"},
    "Rendering": {"Core", "DataModel", "Trace", "Rendering"},
    "Tools": {"Core", "DataModel", "Formats", "Filters", "Trace", "Rendering", "Tools"},
    "ParaView": {"Core", "DataModel", "Filters", "Trace", "Rendering", "ParaView"},
}
VTK_FREE = {"Core", "Formats", "Trace"}

# Folders from which the compiler resolves includes, and those whose sources are checked.
INCLUDE_ROOTS = ["Module", "Filters", "Rendering", "Rendering/Tools", "ParaView/Representation"]
CHECKED = ["Module", "Filters", "Rendering", "ParaView/Representation"]
SUFFIXES = {".h", ".cxx", ".txx"}

INCLUDE = re.compile(r'^\s*#\s*include\s*[<"]([^>"]+)[>"]')


def room(path):
    """The room of a file given by its path below the project root, or None outside of all."""
    parts = PurePosixPath(path).parts
    if parts[0] == "Module":
        return "Core" if parts[1] == "Core" else "DataModel"
    if parts[0] == "Filters":
        return "Formats" if parts[1] == "Formats" else "Filters"
    if parts[0] == "Rendering":
        return parts[1] if parts[1] in ("Trace", "Tools") else "Rendering"
    if parts[0] == "ParaView":
        return "ParaView"
    return None


def layer(path, layers):
    """The layer of a file of Core or Tools, or None if it lies in no known one."""
    parts = PurePosixPath(path).parts
    name = parts[2] if len(parts) > 3 else None
    return name if name in layers else None


def resolve(root, path, name):
    """The project's file that `path` means by including `name`, as a path below root, or None."""
    for folder in [os.path.dirname(path)] + INCLUDE_ROOTS:
        candidate = os.path.normpath(os.path.join(folder, name))
        if (root / candidate).is_file() and not candidate.startswith(".."):
            return PurePosixPath(candidate).as_posix()
    return None


def check_external(path, name):
    """What is wrong with `path` including the foreign header `name`, or None."""
    base = PurePosixPath(path).name
    if room(path) in VTK_FREE and re.match(r"vtk[^/]*\.h$", PurePosixPath(name).name):
        return f"{room(path)} is free of VTK, but this includes {name}"
    if name.startswith("hwy/"):
        lanes = path.startswith("Module/Core/Math/Lanes")
        # Highway compiles a kernel once per instruction set by letting it include itself.
        kernel = room(path) in VTK_FREE and base.endswith("Kernels.cxx")
        kernel = kernel or (path.startswith("Module/Core/Element/") and base.endswith(".cxx"))
        if not lanes and not (kernel and name in ("hwy/foreach_target.h", "hwy/highway.h")):
            return f"only Core/Math/Lanes*.h knows Highway, but this includes {name}"
    if re.match(r"embree\d*/", name) and not path.startswith("Module/Core/Index/Embree"):
        return f"only Core/Index/Embree* knows Embree, but this includes {name}"
    return None


def check_internal(path, target):
    """What is wrong with `path` including the project's file `target`, or None."""
    to = room(target)
    if to not in ALLOWED[room(path)]:
        return f"{room(path)} may not include {target}" + (f" ({to})" if to else "")
    if to == room(path) == "Core":
        if layer(target, CORE_LAYERS) is None:
            return f"{target} lies in no layer of Core"
        return check_order(path, target, CORE_LAYERS)
    if to == room(path) == "Tools":
        return check_order(path, target, TOOL_LAYERS)
    return None


def check_order(path, target, layers):
    """What is wrong with `path` including `target` of the same room, or None."""
    own, other = layer(path, layers), layer(target, layers)
    if own is None:
        return None
    if other is None or layers.index(other) > layers.index(own):
        above = f"layer {other}" if other else "what starts the programs"
        return f"layer {own} may not include {target} ({above} is above)"
    return None


def offences(root):
    """Yields (path, line, what) for each include that runs the wrong way."""
    root = Path(root)
    files = sorted(
        file.relative_to(root).as_posix()
        for top in CHECKED
        for file in (root / top).rglob("*")
        if file.suffix in SUFFIXES
    )
    for path in files:
        if room(path) == "Core" and layer(path, CORE_LAYERS) is None:
            yield path, 1, "lies in no layer of Core: " + ", ".join(CORE_LAYERS)
            continue
        text = (root / path).read_text(encoding="utf-8")
        for number, line in enumerate(text.splitlines(), 1):
            match = INCLUDE.match(line)
            if not match:
                continue
            target = resolve(root, path, match[1])
            what = check_internal(path, target) if target else check_external(path, match[1])
            if what:
                yield path, number, what


def main():
    root = sys.argv[1] if len(sys.argv) > 1 else "."
    found = list(offences(root))
    for path, number, what in found:
        print(f"{path}:{number}: {what}")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
