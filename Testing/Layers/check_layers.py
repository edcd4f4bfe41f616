#!/usr/bin/env python3
"""Checks that no #include runs against the direction in which the project is built.

Usage: check_layers.py [PROJECT_ROOT]

Prints one line per offence, `file:line: what`, and exits with 1 if there was any.
"""

import os
import re
import sys
from pathlib import Path, PurePosixPath

# Folders within a room, or within a format of Formats: a file may include its own folder and those
# before it.
LAYERS = {
    "Core": [
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
        "Expression",
        "Contour",
        "Integral",
    ],
    "Filters": ["Grids", "Cells", "Conversion", "Parts", "Files", "Cuts"],
    "Rendering": ["Views", "Surfaces", "Frames"],
    "Tools": ["Base", "Drawing", "Input", "Scene", "Picture", "Serve", "Bench", "Trade", "Commands"],
    "MFEM": ["Text", "Elements", "Meshes", "Nurbs"],
    "Nektar": ["Files", "Geometry", "Homogeneous", "Fields"],
}
# VTK's classes stand beside the folders; those and what is in the folders may know each other.
WITH_CLASSES = {"Filters", "Rendering"}

# What the files of each room may include. Filters and Rendering do not know each other, and nothing
# includes the programs that stand on top but the Python package, which reads files as they do.
ALLOWED = {
    "Core": {"Core"},
    "DataModel": {"Core", "DataModel"},
    "Formats": {"Core", "Formats"},
    "Filters": {"Core", "DataModel", "Formats", "Filters"},
    "Trace": {"Core", "Trace"},
    "Rendering": {"Core", "DataModel", "Trace", "Rendering"},
    "Tools": {"Core", "DataModel", "Formats", "Filters", "Trace", "Rendering", "Tools"},
    "Python": {"Core", "DataModel", "Formats", "Filters", "Trace", "Rendering", "Tools", "Python"},
    "ParaView": {"Core", "DataModel", "Formats", "Filters", "Trace", "Rendering", "ParaView"},
}
VTK_FREE = {"Core", "Formats", "Trace"}

# Folders from which the compiler resolves includes, and those whose sources are checked.
INCLUDE_ROOTS = [
    "Module",
    "Filters",
    "Rendering",
    "Rendering/Tools",
    "ParaView/Readers",
    "ParaView/Filters",
    "ParaView/Representation",
]
CHECKED = ["Module", "Filters", "Rendering", "ParaView"]
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
        return parts[1] if parts[1] in ("Trace", "Tools", "Python") else "Rendering"
    if parts[0] == "ParaView":
        return "ParaView"
    return None


def stack(path):
    """The key in LAYERS of what a file belongs to, or None, and the folders that it lies in there."""
    parts = PurePosixPath(path).parts
    where = room(path)
    if where == "Formats":
        return (parts[2], parts[3:-1]) if parts[2] in LAYERS else (None, ())
    if where not in LAYERS:
        return None, ()
    return where, parts[2:-1] if where in ("Core", "Tools") else parts[1:-1]


def layer(path):
    """The layer of a file in its stack, or None if it lies in no known one."""
    name, folders = stack(path)
    return folders[0] if folders and folders[0] in LAYERS[name] else None


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
    name = stack(target)[0]
    if name is None or name != stack(path)[0]:
        return None
    own, other = layer(path), layer(target)
    if name == "Core" and other is None:
        return f"{target} lies in no layer of Core"
    if own is None or (other is None and name in WITH_CLASSES):
        return None
    if other is None or LAYERS[name].index(other) > LAYERS[name].index(own):
        above = f"layer {other}" if other else f"what stands on the layers of {name}"
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
        if room(path) == "Core" and layer(path) is None:
            yield path, 1, "lies in no layer of Core: " + ", ".join(LAYERS["Core"])
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
