# SPDX-License-Identifier: BSD-3-Clause
"""One view is one picture: by the tool, by Python, by a mapper without a window and by one in a window."""

import sys
import unittest
from pathlib import Path

import numpy as np
from vtkmodules.vtkCommonCore import vtkOutputWindow, vtkStringOutputWindow

sys.path.insert(0, str(Path(__file__).parents[1] / "Tools"))

import faces  # noqa: E402
import views  # noqa: E402
import options  # noqa: E402
from tool import ToolTest, case, read_buffers  # noqa: E402

NO_LAYER = 255
BUFFERS = ("Value", "Position", "Verdict", "Contour", "Layer", "Color")


class Views(ToolTest):
    def by_tool(self, view):
        buffers = self.folder / "b.vti"
        self.succeeds("render", case(view["case"]), *options.options_of(view), "--buffers", buffers,
                      "--output", self.folder / "i.png")
        return {name: array.reshape(-1, *array.shape[2:]) for name, array in read_buffers(buffers).items()}

    def same(self, wanted, found, names=BUFFERS):
        for name in names:
            # Mappers have the number of the layer where there are several.
            if name == "Layer" and name not in found:
                self.assertFalse(wanted[name][wanted[name] != NO_LAYER].any())
                continue
            if name in wanted or (name in found and name == "Contour"):
                self.assertEqual(wanted[name].tobytes(), found[name].tobytes(),
                                 f"{name}: {_differences(wanted[name], found[name])}")

    def check(self, view):
        wanted = self.by_tool(view)
        actor = faces.actor_of(view)
        found, camera = faces.without_a_window(view, actor)
        self.same(wanted, found)
        found, seen = faces.in_a_window(view, actor, camera)
        self.same(wanted, found, [name for name in BUFFERS if name != "Color"])
        if all(layer.get("opacity", 1) == 1 for layer in view["layers"]):
            self.window_shows(wanted, seen)
        found = faces.by_render(view)
        if found is not None:
            self.same(wanted, found)

    def window_shows(self, wanted, seen):
        """OpenGL rounds colours by itself. Pixels whose centre hits nothing have no depth, so that the parts
        of contours in them are not drawn."""
        color = wanted["Color"]
        opaque = (color[:, 3] == 255) & (wanted["Verdict"] != 0)
        off = np.abs(color[opaque, :3].astype(int) - seen[opaque, :3].astype(int))
        self.assertLessEqual(off.max(initial=0), 1)

    def test_views(self):
        all_views = views.views()
        self.assertGreater(len(all_views), 50)
        for number, view in enumerate(all_views):
            with self.subTest(number=number, view=view):
                self.check(view)


class LinesAlone(unittest.TestCase):
    def test_they_hide_nothing(self):
        """In a window, what lies behind the surface shows between its contours."""
        from vtkmodules.vtkFiltersSources import vtkSphereSource
        from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper

        view = {"case": "toroid_hex_g3_p6", "field": "u", "size": [64, 48], "contours": 5,
                "layers": [{"surface": ["plane", 0, 0, 0.1, 0, 0, 1]}], "camera": {"view": "+z"}}
        ball = vtkSphereSource()
        ball.SetCenter(1.4, 0, -2)
        ball.SetRadius(0.2)
        mapper = vtkPolyDataMapper()
        mapper.SetInputConnection(ball.GetOutputPort())
        behind = vtkActor()
        behind.SetMapper(mapper)
        behind.GetProperty().SetColor(1, 0, 0)
        behind.GetProperty().LightingOff()
        red = {}
        for alone in (False, True, False):
            actor = faces.actor_of(view | {"contours_only": alone})
            _, camera = faces.without_a_window(view, actor)
            _, seen = faces.in_a_window(view, actor, camera, behind)
            red[alone] = int((seen[:, :3] == (255, 0, 0)).all(axis=1).sum())
        self.assertEqual(red[False], 0)
        self.assertGreater(red[True], 5)


def _differences(wanted, found):
    if wanted.shape != found.shape:
        return f"{wanted.shape} and {found.shape}"
    same = (wanted == found) | ((wanted != wanted) & (found != found))
    return f"{(~same).sum()} of {same.size}, the first at {np.argwhere(~same)[:3].tolist()}"


if __name__ == "__main__":
    # Warnings of what windows leave out are many.
    vtkOutputWindow.SetInstance(vtkStringOutputWindow())
    unittest.main()
