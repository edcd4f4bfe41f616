# SPDX-License-Identifier: BSD-3-Clause
"""The colour maps: their differences to the published tables, reversed maps, and where they are listed."""

import json
import os
import sys
import unittest
from pathlib import Path

import numpy as np
import pixelexact
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy

DATA = Path(os.environ["PIXELEXACT_DATA_DIR"])
sys.path.insert(0, str(DATA.parent / "Rendering" / "Settings"))
import colormaps  # noqa: E402

# The largest difference to the published table, in levels of 255.
DIFFERENCES = {"viridis": 1, "inferno": 1, "plasma": 2, "magma": 1, "cividis": 2, "turbo": 2, "vik": 1, "romaO": 1}


def published(name):
    """256 colours, as integers from 0 to 255."""
    tables = json.loads((Path(__file__).parent / "color_tables.json").read_text(encoding="utf-8"))
    return np.frombuffer(bytes.fromhex("".join(tables[name])), np.uint8).reshape(256, 3).astype(int)


def table_of(name):
    mapper = pixelexact.vtkHighOrderMapper()
    mapper.SetColorMap(name)
    return mapper.GetLookupTable()


def colors(table, values):
    mapped = table.MapScalars(numpy_to_vtk(np.asarray(values, dtype=float)), 0, -1)
    return vtk_to_numpy(mapped)[:, :3].astype(int)


class ColorMaps(unittest.TestCase):
    def test_differences_to_published_tables(self):
        for name, largest in DIFFERENCES.items():
            with self.subTest(name):
                made = colors(table_of(name), np.arange(256) / 255)
                self.assertEqual(np.abs(made - published(name)).max(), largest)

    def test_colours_of_the_table_are_published_ones(self):
        """And each map with a published table is compared."""
        stepped = {row["name"]: row for row in colormaps.load() if row["step"]}
        self.assertEqual(set(stepped), set(DIFFERENCES))
        for name, row in stepped.items():
            exact = ["{:02x}{:02x}{:02x}".format(*color) for color in published(name)[:: row["step"]]]
            self.assertEqual(row["colors"], exact)

    def test_reversed_maps(self):
        for name in colormaps.names():
            with self.subTest(name):
                table, other = table_of(name), table_of(f"{name}_r")
                entries = [[each.GetTableValue(i) for i in range(1024)] for each in (table, other)]
                np.testing.assert_allclose(entries[0], entries[1][::-1], atol=1e-9)
                self.assertEqual(table.GetNanColor(), other.GetNanColor())

    def test_ends_of_cyclic_maps_meet(self):
        for row in colormaps.load():
            low, high = colors(table_of(row["name"]), (0, 1))
            if row["kind"] == "cyclic":
                self.assertLessEqual(np.abs(low - high).max(), 2)
            else:
                self.assertGreater(np.abs(low - high).max(), 50)

    def test_middle_of_diverging_maps(self):
        """It is the lightest colour, nearly without hue."""
        for row in colormaps.load():
            if row["kind"] == "diverging":
                every = colors(table_of(row["name"]), np.arange(256) / 255)
                middle = every[127:129].mean(axis=0)
                self.assertLess(np.ptp(middle), 16)
                self.assertGreaterEqual(middle.sum(), every.sum(axis=1).max() - 16)

    def test_nan_is_not_in_the_map(self):
        for name in colormaps.names():
            table = table_of(name)
            every = np.array([table.GetTableValue(i)[:3] for i in range(1024)])
            distance = np.linalg.norm(every - np.array(table.GetNanColor()[:3]), axis=1).min()
            self.assertGreater(255 * distance, 35, name)

    def test_default_of_all_interfaces_is_viridis(self):
        grid = pixelexact.read(DATA / "escher_tet_g3_p3.vtu")
        values, expected = np.linspace(0, 1, 101), colors(table_of("viridis"), np.linspace(0, 1, 101))
        mapper = pixelexact.vtkHighOrderMapper()
        mapper.SetInputData(grid)
        np.testing.assert_array_equal(colors(mapper.GetLookupTable(), values), expected)
        default, named = (
            pixelexact.render(grid, "u", size=(60, 40), **cmap) for cmap in ({}, {"cmap": "viridis"})
        )
        np.testing.assert_array_equal(default.image, named.image)
        self.assertGreater(np.count_nonzero(default.verdicts == 1), 200)

    def test_other_names_are_refused(self):
        for name in ("virids", "_r", "viridis_r_r", "viridis_", "Viridis", ""):
            with self.subTest(name), self.assertRaises(ValueError) as raised:
                pixelexact.cut(DATA / "escher_tet_g3_p3.vtu", "u", cmap=name)
            self.assertIn(", ".join(colormaps.names()), str(raised.exception))
            self.assertIn("viridis_r", str(raised.exception))

    def test_picture_of_a_reversed_map(self):
        grid = pixelexact.read(DATA / "toroid_hex_g3_p6.vtu")
        one, other = (
            pixelexact.render(grid, "u", cmap=cmap, clim=(-1, 1), size=(60, 40)) for cmap in ("vik_r", "vik")
        )
        seen = one.verdicts == 1
        self.assertGreater(np.count_nonzero(seen), 500)
        made = colors(table_of("vik"), 0.5 * (1 - one.values[seen]))
        self.assertLessEqual(np.abs(one.image[seen][:, :3] - made).max(), 3)
        self.assertGreater(np.abs(one.image.astype(int) - other.image).max(), 100)


if __name__ == "__main__":
    unittest.main()
