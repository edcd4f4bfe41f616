# SPDX-License-Identifier: BSD-3-Clause
"""Options that would change nothing are refused by their name."""

import unittest

from tool import ToolTest, unit_cube_grid

HALF = ("--plane", "0,0,0.5,0,0,1")


class Effects(ToolTest):
    def setUp(self):
        super().setUp()
        cube = self.folder / "cube.vtu"
        cube.write_text(unit_cube_grid(), encoding="utf-8")
        self.base = ["render", cube, "--field", "u", *HALF, "--size", "9x9",
                     "--output", self.folder / "i.png"]
        self.maps = [["--range", "0,1"], ["--colormap", "jet"], ["--log"],
                     ["--nan-color", "1,0,0"]]

    def test_colours_by_value_where_all_is_of_one_colour(self):
        for option in self.maps:
            for solid in [["--color", "1,0,0"], ["--layer", "1:color=1:0:0"]]:
                self.fails(2, *self.base, *solid, *option, names=[option[0]])
        for solid in [["--color", "1,0,0"], ["--layer", "1:color=1:0:0"]]:
            self.fails(2, *self.base, *solid, "--show-undecided", names=["--show-undecided"])
        # One surface of two is coloured by value.
        self.succeeds(*self.base, "--sphere", "0,0,0,0.5", "--layer", "1:color=1:0:0",
                      "--range", "0,1")

    def test_what_every_layer_says_itself(self):
        for option, key in [
            (["--lights", "on"], "lights=off"),
            (["--precision", "float"], "precision=double"),
            (["--component", "0"], "component=0"),
            (["--range", "0,1"], "range=cut"),
            (["--colormap", "jet"], "colormap=plasma"),
            (["--color", "1,1,1"], "color=0:0:0"),
        ]:
            layer = ["--layer", f"1:{key}"]
            self.fails(2, *self.base, *option, *layer, names=[option[0], "no effect"])
            self.succeeds(*self.base, *option, *layer, "--plane", "0,0,0.3,0,0,1")

    def test_beside_a_legend(self):
        for picture in [["--owners"], ["--show", "validity"]]:
            for option in [*self.maps, ["--color", "1,0,0"], ["--lights", "on"]]:
                self.fails(2, *self.base, *picture, *option, names=["no effect", picture[0]])
            for key in ["opacity=0.5", "color=1:0:0", "range=cut", "lights=on", "colormap=jet"]:
                self.fails(2, *self.base, *picture, "--layer", f"1:{key}", names=["--layer"])
            summary = self.summary(*self.base, *picture, "--outlines")
            self.assertIsNone(summary["color_range"])

    def test_colours_of_what_is_not_painted(self):
        self.fails(2, *self.base, "--undecided-color", "1,0,0", names=["--show-undecided"])
        self.fails(2, *self.base, "--outline-color", "1,0,0", names=["--outlines"])

    def test_a_key_twice(self):
        for layers in [["1:opacity=1,opacity=0.5"], ["1:lights=on", "1:lights=off"]]:
            words = [word for layer in layers for word in ("--layer", layer)]
            self.fails(2, *self.base, *words, names=["--layer", "already"])
        self.fails(2, *self.base, "--layer", "1:color=1:0:0,range=0:1", names=["color", "range"])


if __name__ == "__main__":
    unittest.main()
