# SPDX-License-Identifier: BSD-3-Clause
"""A view (views.py) as options of the command-line tool."""

from vtkmodules.vtkCommonDataModel import vtkCylinder


def options_of(view):
    """The options of the tool."""
    words = ["--size", "{}x{}".format(*view["size"])]
    for number, layer in enumerate(view["layers"], 1):
        kind, *numbers = layer["surface"]
        if kind == "cylinder":
            # VTK's has an axis of unit length, up to rounding.
            made = vtkCylinder()
            made.SetAxis(numbers[3:6])
            numbers[3:6] = made.GetAxis()
        if kind == "isosurface":
            words.append(f"--isosurface={numbers[0]}={numbers[1]!r}")
        else:
            words.append(f"--{kind}=" + ",".join(map(repr, numbers)) if numbers else f"--{kind}")
        told = {key: value for key, value in layer.items() if key != "surface"}
        if told:
            texts = [f"{key}={_text(value, ':')}" for key, value in told.items()]
            words += ["--layer", f"{number}:" + ",".join(texts)]
    for key, value in view.items():
        option = "--" + key.replace("_", "-")
        if key in ("case", "layers", "size", "camera"):
            continue
        if key == "clip":
            words += [f"--clip={_text(plane)}" for plane in value]
        elif value is True:
            words.append(option)
        else:
            words.append(f"{option}={_text(value)}")
    for key, value in view["camera"].items():
        words.append("--" + key.replace("_", "-") + "=" + _text(value))
    return words


def _text(value, between=","):
    if isinstance(value, list):
        # One number with a separator is a list.
        return between.join(map(repr, value)) + (between if len(value) == 1 else "")
    return value if isinstance(value, str) else repr(value)
