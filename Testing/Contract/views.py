# SPDX-License-Identifier: BSD-3-Clause
"""Views: what is drawn and how, as JSON. The same view by every face of PixelExact is the same picture.

A view is a dictionary. Its names are those of the command-line tool's options, with an underscore for
each minus sign; what it does not name has the default. `layers` is a list, in the order in which the tool
numbers surfaces; a layer has a `surface`, [kind, *numbers], and what `--layer` takes. `camera` has either
`view`, or `camera_position`, `focal_point`, `view_up` and `view_angle` or `parallel_scale`.
"""

import json
import random
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "Rendering" / "Settings"))
import colormaps  # noqa: E402

# As the tool orders them.
KINDS = ("plane", "sphere", "cylinder", "quadric", "torus", "box", "isosurface", "boundary")
MAPS = (*colormaps.names(), "viridis_r", "vik_r")
SIZES = ((64, 48), (50, 60), (71, 41))
COUNT = 50
SEED = 20261128

# Of a mesh: a range about the values of its field u, and half its extent about 0.
CASES = {
    "toroid_hex_g3_p6": ((-0.8, 0.8), (1.4, 1.4, 0.4)),
    "escher_tet_g3_p3": ((-2.0, 2.5), (1.7, 1.7, 1.2)),
    "fichera_hex_g3_p4": ((-2.5, 3.0), (1.0, 1.0, 1.0)),
    "periodic_hex_dg_g3_p4": ((0.0, 1.2), (1.0, 1.0, 1.0)),
}


def _rounded(numbers):
    return [round(number, 3) for number in numbers]


def _normal(dice):
    while True:
        normal = _rounded([dice.uniform(-1, 1) for _ in range(3)])
        if sum(abs(part) for part in normal) > 0.5:
            return normal


def _surface(dice, kind, case):
    values, half = case
    about = _rounded([0.2 * h * dice.uniform(-1, 1) for h in half])
    size = round(0.7 * min(half[0], half[1]) * dice.uniform(0.7, 1.2), 3)
    if kind == "plane":
        return [kind, *about, *_normal(dice)]
    if kind == "sphere":
        return [kind, *about, size]
    if kind == "cylinder":
        return [kind, *about, *_normal(dice), size]
    if kind == "quadric":
        return [kind, *_rounded([1, 1.5, dice.uniform(-1, 2), 0.1, 0, 0, *about]), -round(size**2, 3)]
    if kind == "torus":
        return [kind, *about, *_normal(dice), size, round(0.3 * size, 3)]
    if kind == "box":
        return [kind, *_rounded([a - 0.5 * size for a in about]), *_rounded([a + 0.5 * size for a in about])]
    if kind == "isosurface":
        return [kind, "u", round(dice.uniform(0.1, 0.5) * values[1], 3)]
    return [kind]


def _contours(dice, values):
    if dice.random() < 0.5:
        return dice.randint(1, 12)
    return sorted({round(dice.uniform(*values), 2) for _ in range(dice.randint(1, 5))})


def _range(dice, values):
    return dice.choice(["cut", "field", _rounded([0.5 * values[0], 0.5 * values[1]])])


def _camera(dice, case):
    _, half = case
    if dice.random() < 0.5:
        return {"view": dice.choice(["iso", "+x", "-x", "+y", "-y", "+z", "-z"])}
    away = _normal(dice)
    length = sum(part**2 for part in away) ** 0.5
    far = 4.0 * max(half)
    camera = {
        "camera_position": _rounded([far * part / length for part in away]),
        "focal_point": [0, 0, 0],
        "view_up": [0.1, 0.9, 0.4],
    }
    if dice.random() < 0.5:
        return camera | {"view_angle": round(dice.uniform(25, 40), 1)}
    return camera | {"parallel_scale": round(max(half) * dice.uniform(0.8, 1.3), 3)}


def _layer(dice, kind, case, alone):
    """What a layer says itself; where it is alone, the view says it."""
    values, _ = case
    layer = {"surface": _surface(dice, kind, case)}
    if alone:
        return layer
    if dice.random() < 0.4:
        layer["opacity"] = round(dice.uniform(0.3, 0.9), 2)
    how = dice.random()
    if how < 0.2:
        layer["color"] = _rounded([dice.random() for _ in range(3)])
    elif how < 0.4:
        layer["colormap"] = dice.choice(MAPS)
        layer["range"] = _rounded([0.5 * values[0], 0.5 * values[1]])
    if dice.random() < 0.3:
        layer["lights"] = dice.choice(["on", "off"])
    return layer


def _own_contours(dice, values, view):
    """Of layers that do not have the view's."""
    for layer in view["layers"] if len(view["layers"]) > 1 else []:
        if dice.random() < 0.3:
            layer["contours"] = _contours(dice, values)


def _looks(dice, values, view):
    # What all layers say themselves is not said of the view.
    mapped = not all("color" in layer or "colormap" in layer for layer in view["layers"])
    if mapped and dice.random() < 0.6:
        view["colormap"] = dice.choice(MAPS)
    if mapped and dice.random() < 0.7:
        view["range"] = _range(dice, values)
    if dice.random() < 0.6:
        view["contours"] = _contours(dice, values)
        _own_contours(dice, values, view)
        if dice.random() < 0.4:
            view["contour_width"] = round(dice.uniform(0.5, 4), 2)
        if dice.random() < 0.4:
            view["contour_color"] = dice.choice(["map", _rounded([dice.random() for _ in range(3)])])
        if dice.random() < 0.3:
            view["contour_labels"] = dice.randint(8, 14)
    if dice.random() < 0.3:
        view["edges"] = round(dice.uniform(0.8, 3), 1)
        if dice.random() < 0.5:
            view["edge_color"] = _rounded([dice.random() for _ in range(3)])
    if dice.random() < 0.3:
        view["lights"] = dice.choice(["on", "off"])


def _view(dice):
    name = dice.choice(list(CASES))
    case = CASES[name]
    number = dice.choice([1, 1, 1, 2, 3])
    kinds = sorted(dice.sample(KINDS, number), key=KINDS.index)
    view = {"case": name, "field": "u", "size": list(dice.choice(SIZES))}
    view["layers"] = [_layer(dice, kind, case, number == 1) for kind in kinds]
    _looks(dice, case[0], view)
    if number == 1 and dice.random() < 0.25:
        view["layers"][0]["opacity"] = 0.5
    view["camera"] = _camera(dice, case)
    return view


def _known():
    """Settings of one face alone, and pairs that have differed."""
    plane = {"case": "toroid_hex_g3_p6", "field": "u", "size": [64, 48],
             "layers": [{"surface": ["plane", 0, 0, 0.1, 0, 0, 1]}], "camera": {"view": "+z"}}
    two = [{"surface": ["plane", 0, 0, 0.1, 0.2, 0, 1], "opacity": 0.6},
           {"surface": ["sphere", 1, 0, 0, 0.4], "opacity": 0.5}]
    iso = {**plane, "camera": {"view": "iso"}}
    ball = [{"surface": ["sphere", 1, 0, 0, 0.3]}]
    return [
        {**iso, "layers": two, "contours": 5, "contour_labels": 10, "size": [320, 240]},
        {**iso, "layers": two, "contours": 5, "edges": 1.5},
        {**iso, "layers": two, "samples": 3, "contours": [0.1, 0.2]},
        {**iso, "layers": ball, "samples": 4},
        {**plane, "edges": 1.5, "edges_by_kind": True},
        {**plane, "outlines": True, "outline_color": [1, 0, 0]},
        {**plane, "range": [0.01, 0.5], "log": True, "contours": 6},
        {**plane, "contours": [0.1], "certifier": "interval"},
        {**plane, "range": "symmetric", "contours": 4},
        {**plane, "range": "2%,98%"},
        {**plane, "range": "symmetric-field", "colormap": "coolwarm"},
        {**plane, "contours": 4, "contours_only": True, "background": "none"},
        {**plane, "clip": [[0, 0, 0, 1, 0.3, 0]]},
        {**plane, "bands": 5, "contours": 4, "contour_color": "map"},
        {**plane, "bands": 6, "range": [0.01, 0.5], "log": True},
        {**iso, "layers": two, "bands": 3, "range": "field"},
        {**plane, "show_undecided": True},
        # Values of an iso-surface are equal up to rounding, so that nothing decides their colours.
        {**iso, "layers": [{"surface": ["isosurface", "u", 0.3]}], "show_undecided": True,
         "range": [0.2999999999999, 0.3000000000001]},
        {**plane, "show_undecided": True, "bands": 4, "undecided_color": [0, 1, 0]},
        {**iso, "layers": ball, "show_undecided": True, "contours": 12, "contour_width": 3},
        {**iso, "layers": two, "show_undecided": True, "contours": 5},
        {**iso, "layers": ball, "contours": 12, "show_undecided_contours": True,
         "undecided_contour_color": [1, 0.5, 0]},
        {**iso, "layers": ball, "clip": [[1, 0, 0, 0, 0, 1], [1, 0, 0, 1, 0, 0]]},
    ]


def views():
    """The same each time."""
    dice = random.Random(SEED)
    return [json.loads(json.dumps(view)) for view in [_view(dice) for _ in range(COUNT)] + _known()]
