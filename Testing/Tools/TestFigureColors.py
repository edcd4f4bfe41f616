# SPDX-License-Identifier: BSD-3-Clause
"""Bands, ranges and colour maps of files."""

import json
import unittest

import numpy as np

from tool import CUBE, ToolTest, case, read_buffers, read_image, unit_cube_grid

SIZE = "80x60"


class Colors(ToolTest):
    def setUp(self):
        super().setUp()
        self.cube = self.folder / "cube.vtu"
        fields = [("u", [p[0] for p in CUBE]), ("w", [3.0 * p[0] - 1.0 for p in CUBE])]
        self.cube.write_text(unit_cube_grid(fields), encoding="utf-8")

    def draw(self, source, *arguments, field="u"):
        """The summary, exact pixels' values, and their colours."""
        image, buffers = self.folder / "a.png", self.folder / "a.vti"
        found = self.summary("render", source, "--field", field, "--plane", "z", "--size", SIZE,
            "-o", image, "--buffers", buffers, *arguments)
        read = read_buffers(buffers)
        exact = read["Verdict"] == 1
        return found, read["Value"][exact], read_image(image)[exact].astype(int)


class Bands(Colors):
    def test_each_band_has_one_colour(self):
        for bands in [2, 5, 16]:
            _, values, colors = self.draw(self.cube, "--bands", bands, "--range", "0,1",
                "--colormap", "grayscale")
            band = np.minimum(np.floor(values * bands), bands - 1)
            np.testing.assert_allclose(colors[:, 0], 255 * (band + 0.5) / bands, atol=1.01)
            self.assertEqual(len(np.unique(colors[:, 0])), bands)

    def test_values_beyond_have_the_last_bands(self):
        _, values, colors = self.draw(self.cube, "--bands", 4, "--range", "0.4,0.6",
            "--colormap", "grayscale")
        self.assertEqual(set(colors[values < 0.4][:, 0]), set(colors[(values > 0.4) & (values < 0.44)][:, 0]))

    def test_logarithms(self):
        _, values, colors = self.draw(self.cube, "--bands", 3, "--range", "0.001,1", "--log",
            "--colormap", "grayscale")
        band = np.clip(np.floor(np.log10(values) + 3.0), 0, 2)
        np.testing.assert_allclose(colors[:, 0], 255 * (band + 0.5) / 3, atol=1.01)

    def test_refused(self):
        base = ["render", self.cube, "-o", self.folder / "a.png"]
        for text in ["1", "0", "x", "257", "2.5"]:
            self.fails(2, *base, "--bands", text, names=["--bands"])
        self.fails(2, *base, "--bands", 3, "--color", "1,0,0", names=["--bands", "--color"])
        self.fails(2, *base, "--bands", 3, "--show", "validity", names=["--bands"])


class Ranges(Colors):
    def test_symmetric(self):
        found, values, _ = self.draw(self.cube, "--range", "symmetric", field="w")
        low, high = found["color_range"]
        self.assertEqual(low, -high)
        self.assertAlmostEqual(high, np.abs(values).max(), delta=1e-12)
        field = self.draw(self.cube, "--range", "symmetric-field", field="w")[0]["color_range"]
        self.assertEqual(field[0], -field[1])
        self.assertAlmostEqual(field[1], 2.0, delta=1e-3)
        self.assertGreaterEqual(field[1], 2.0)

    def test_percentiles_are_numpys(self):
        source = case("toroid_hex_g3_p6")
        for low, high in [(1, 99), (0, 100), (12.5, 50), (25, 75)]:
            found, values, _ = self.draw(source, "--range", f"{low}%,{high}%")
            expected = np.percentile(values, [low, high])
            np.testing.assert_allclose(found["color_range"], expected, rtol=1e-12)
            self.assertAlmostEqual(found["beyond_range"]["below"], low / 100 * values.size, delta=2)

    def test_of_a_layer(self):
        found, values, _ = self.draw(self.cube, "--layer", "1:range=10%:90%")
        np.testing.assert_allclose(found["color_range"], np.percentile(values, [10, 90]), rtol=1e-12)

    def test_refused(self):
        base = ["render", self.cube, "-o", self.folder / "a.png"]
        for text in ["1%,99", "-1%,50%", "50%,101%", "60%,40%", "5%", "symmetric-x", "50%,50%"]:
            self.fails(2, *base, "--range", text, names=["--range"])
        for text in ["symmetric", "symmetric-field"]:
            self.fails(2, *base, "--range", text, "--log", names=["--range", "--log", "symmetric"])
        self.fails(2, *base, "--range", "all", names=["--range", "all"])


POINTS = [-1.0, 0.0, 0.0, 0.2, 0.5, 1.0, 0.5, 0.4, 2.0, 1.0, 1.0, 0.0]


class Maps(Colors):
    def file(self, name, text):
        path = self.folder / name
        path.write_text(text, encoding="utf-8")
        return path

    def json(self, *maps, name="map.json"):
        return self.file(name, json.dumps(list(maps)))

    def check(self, path):
        """Against linear interpolation of the points, spread over 0 to 1."""
        _, values, colors = self.draw(self.cube, "--colormap", path, "--range", "0,1")
        rows = np.reshape(POINTS, (-1, 4))
        at = (rows[:, 0] + 1.0) / 3.0
        for channel in range(3):
            expected = 255 * np.interp(values, at, rows[:, channel + 1])
            self.assertLess(np.abs(colors[:, channel] - expected).max(), 1.6)

    def test_json(self):
        one = {"ColorSpace": "RGB", "Name": "mine", "RGBPoints": POINTS, "NanColor": [1, 0, 0]}
        self.check(self.json(one))
        two = self.json(one, {**one, "Name": "other", "RGBPoints": POINTS[:8]}, name="two.json")
        self.check(f"{two}:mine")
        self.fails(1, "render", self.cube, "--colormap", two, "-o", self.folder / "a.png",
            names=["two.json", "'mine'", "'other'", "FILE:NAME"])
        self.fails(1, "render", self.cube, "--colormap", f"{two}:third", "-o", self.folder / "a.png",
            names=["two.json", "'third'"])

    def test_xml(self):
        points = "".join(
            f'<Point x="{x}" o="1" r="{r}" g="{g}" b="{b}"/>' for x, r, g, b in np.reshape(POINTS, (-1, 4))
        )
        self.check(self.file("map.xml",
            f'<ColorMaps><ColorMap name="m" space="RGB">{points}</ColorMap></ColorMaps>'))

    def test_spaces_are_vtks(self):
        from vtkmodules.vtkRenderingCore import vtkColorTransferFunction

        for space, choose in [("Lab", "SetColorSpaceToLab"), ("Diverging", "SetColorSpaceToDiverging"),
                              ("HSV", "SetColorSpaceToHSV"), ("Step", "SetColorSpaceToStep"),
                              ("Lab/CIEDE2000", "SetColorSpaceToLabCIEDE2000")]:
            path = self.json({"ColorSpace": space, "Name": "m", "RGBPoints": POINTS})
            _, values, colors = self.draw(self.cube, "--colormap", path, "--range", "-1,2")
            function = vtkColorTransferFunction()
            getattr(function, choose)()
            function.HSVWrapOff()
            for x, r, g, b in np.reshape(POINTS, (-1, 4)):
                function.AddRGBPoint(x, r, g, b)
            values, first = np.unique(values, return_index=True)
            colors = colors[first]
            expected = np.array([function.GetColor(v) for v in values]) * 255
            # A table of 1024 steps has a jump a little beside.
            worst = np.sort(np.abs(colors - expected).max(axis=1))
            self.assertLess(worst[int(0.97 * worst.size)], 3.0, space)

    def test_not_a_number(self):
        self.cube.write_text(unit_cube_grid([("u", [float("nan")] * 8)]), encoding="utf-8")
        path = self.json({"Name": "m", "RGBPoints": POINTS, "NanColor": [0.2, 0.4, 0.6]})
        _, _, colors = self.draw(self.cube, "--colormap", path)
        np.testing.assert_array_equal(np.unique(colors, axis=0), [[51, 102, 153]])

    def test_of_a_layer(self):
        path = self.json({"Name": "m", "RGBPoints": [0, 0, 0, 1, 1, 0, 1, 0]})
        _, _, colors = self.draw(self.cube, "--layer", f"1:colormap={path}")
        self.assertEqual(set(colors[:, 0]), {0})

    def test_refused(self):
        for name, text, says in [
            ("no.json", "{", "JSON"),
            ("no.xml", "<a", "XML"),
            ("empty.json", "[]", "no colour map"),
            ("empty.xml", "<ColorMaps/>", "no colour map"),
            ("one.json", '[{"Name":"m","RGBPoints":[0,0,0,0]}]', "two points"),
            ("short.json", '[{"Name":"m","RGBPoints":[0,0,0,0,1]}]', "four numbers"),
            ("down.json", '[{"Name":"m","RGBPoints":[1,0,0,0,0,1,1,1]}]', "ascending"),
            ("bright.json", '[{"Name":"m","RGBPoints":[0,0,0,0,1,255,1,1]}]', "between 0 and 1"),
            ("space.json", '[{"ColorSpace":"X","Name":"m","RGBPoints":[0,0,0,0,1,1,1,1]}]', "'X'"),
            ("text.json", '[{"Name":3,"RGBPoints":"a"}]', "JSON"),
            ("classes.json", '[{"Name":"m","IndexedColors":[0,0,0,1,1,1]}]', "categories"),
        ]:
            path = self.file(name, text)
            self.fails(1, "render", self.cube, "--colormap", path, "-o", self.folder / "a.png",
                names=["--colormap", name, says])
        self.fails(1, "render", self.cube, "--colormap", "absent.json", "-o", self.folder / "a.png",
            names=["--colormap", "absent.json"])
        self.fails(2, "render", self.cube, "--colormap", "virdis", "-o", self.folder / "a.png",
            names=["--colormap", "virdis", "viridis", ".json"])


if __name__ == "__main__":
    unittest.main()
