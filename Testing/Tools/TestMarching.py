# SPDX-License-Identifier: BSD-3-Clause
"""Boundaries and iso-surfaces of solvers' meshes, against marching along the pixels' rays with probe,
which locates points and knows neither faces nor surfaces. PIXELEXACT_MARCHING names folders of the
shared data (comma-separated, or `all`) in the place of the few that are taken otherwise."""

import os
import unittest
from pathlib import Path

import numpy as np

from rendering import EXACT, SurfaceTest, numbers
from tool import View, columns, read_buffers, read_csv

SHARED = Path(__file__).resolve().parents[3] / "shared" / "data"
FEW = ["mfem_toroid_hex_g3_p6", "mfem_escher_tet_p3", "nek_pyramid_curved_p6", "nek_prism_curved_p7"]
SIZE = (20, 16)
STEPS = 400  # along the mesh's diagonal
ROUNDS = 5
PARTS = 32  # of an interval, in each round


def cases():
    wanted = os.environ.get("PIXELEXACT_MARCHING", "")
    if wanted == "all":
        return sorted(path.name for path in SHARED.iterdir() if path.is_dir())
    return wanted.split(",") if wanted else FEW


def inputs(folder):
    """A solver's own files where there are some."""
    for mesh, fields in [("*.xml", "*.fld"), ("*.mesh", "*.gf"), ("*.vtu", None)]:
        meshes = sorted(folder.glob(mesh))
        if meshes:
            found = sorted(folder.glob(fields))[:1] if fields else []
            return [str(meshes[0]), *map(str, found)]
    return []


@unittest.skipUnless(SHARED.is_dir(), "there is no ../shared/data")
class Marching(SurfaceTest):
    def look(self, files, field, *options):
        image, buffers = self.folder / "image.png", self.folder / "buffers.vti"
        if "--size" not in options:
            options = [*options, "--size", "x".join(map(str, SIZE))]
        outputs = ["--output", image, "--buffers", buffers]
        told = self.summary("render", *files, *field, *options, *outputs)
        return View.of_summary(told["camera"], *SIZE), read_buffers(buffers)

    def ask(self, files, field, positions):
        points, out = self.folder / "points.csv", self.folder / "out.csv"
        flat = positions.reshape(-1, 3)
        lines = "".join(numbers(position) + "\n" for position in flat)
        points.write_text("x,y,z\n" + lines, encoding="utf-8")
        self.succeeds("probe", *files, *field, "--points", points, "--output", out)
        found = columns(read_csv(out))
        shape = positions.shape[:-1]
        value = found.get("value", found.get("value_0"))
        return (
            (found["verdict"] == "inside").reshape(shape),
            value.reshape(shape),
            found["element"].reshape(shape),
        )

    def prepare(self, name):
        files = inputs(SHARED / name)
        facts = self.summary("info", *files)
        lower, upper = np.array(facts["node_bounds"]).reshape(3, 2).T
        fields = [one["name"] for one in facts["fields"] if one["components"] == 1]
        return files, ["--field", fields[0]], 0.5 * (lower + upper), np.linalg.norm(upper - lower)

    def test_boundaries(self):
        for name in cases():
            with self.subTest(name):
                files, field, middle, size = self.prepare(name)
                view, buffers = self.look(files, field, "--boundary")
                self.march_boundary(name, files, field, view, buffers, middle, size)

    def march_boundary(self, name, files, field, view, buffers, middle, size):
        origin, direction = view.rays()
        centre = ((middle - origin) * direction).sum(axis=-1)
        t = centre[..., None] + np.linspace(-0.6, 0.6, STEPS) * size
        at = origin[..., None, :] + t[..., None] * direction[..., None, :]
        inside = self.ask(files, field, at)[0]
        seen = inside.any(axis=-1)
        shown = buffers["Verdict"] == EXACT
        self.assertEqual((buffers["Verdict"] > EXACT).sum(), 0)
        # What is inside of the mesh lies behind a boundary.
        self.assertEqual((seen & ~shown).sum(), 0)
        end = np.maximum(inside.argmax(axis=-1), 1)[..., None]
        for _ in range(ROUNDS):
            lower = np.take_along_axis(t, end - 1, axis=-1)
            upper = np.take_along_axis(t, end, axis=-1)
            t = lower + (upper - lower) * np.linspace(0, 1, PARTS + 1)
            at = origin[..., None, :] + t[..., None] * direction[..., None, :]
            inside = self.ask(files, field, at)[0]
            end = np.maximum(inside.argmax(axis=-1), 1)[..., None]
        entered = np.take_along_axis(t, end, axis=-1)[..., 0]
        late = buffers["Depth"] - entered
        off = np.abs(late)[seen & shown] / size
        early = seen & shown & (late < -1e-8 * size)
        print(
            f"{name}: {seen.sum()} rays enter the mesh, {(shown & ~seen).sum()} more between steps; "
            f"{early.sum()} hits before the first step inside, the others within "
            f"{off[off < 1e-8].max(initial=0):.2g} of the size"
        )
        self.assertEqual((seen & shown & (late > 1e-8 * size)).sum(), 0)
        # Hits that steps passed over are in the mesh, too.
        rest = shown & (early | ~seen)
        if rest.any():
            self.assertTrue(self.ask(files, field, buffers["Position"][rest])[0].mean() > 0.9)

    def test_isosurfaces(self):
        for name in cases():
            with self.subTest(name):
                files, field, middle, size = self.prepare(name)
                view, buffers = self.look(files, field, "--boundary")
                origin, direction = view.rays()
                centre = ((middle - origin) * direction).sum(axis=-1)
                t = centre[..., None] + np.linspace(-0.6, 0.6, STEPS) * size
                at = origin[..., None, :] + t[..., None] * direction[..., None, :]
                inside, value, element = self.ask(files, field, at)
                level = float(np.quantile(value[inside], 0.6))
                spread = np.ptp(value[inside])
                options = ["--isosurface", f"{field[1]}={level!r}"]
                _, buffers = self.look(files, field, *options, *view.options())
                shown = buffers["Verdict"] == EXACT
                above = value > level
                crosses = inside[..., 1:] & inside[..., :-1] & (above[..., 1:] != above[..., :-1])
                crosses &= element[..., 1:] == element[..., :-1]
                seen = crosses.any(axis=-1)
                unknown = buffers["Verdict"] > EXACT
                self.assertEqual((seen & ~shown & ~unknown).sum(), 0)
                upper = np.take_along_axis(t, crosses.argmax(axis=-1)[..., None] + 1, axis=-1)[..., 0]
                self.assertEqual((seen & shown & (buffers["Depth"] > upper + 1e-9 * size)).sum(), 0)
                off = np.abs(buffers["Value"][shown] - level).max(initial=0) / spread
                print(
                    f"{name}: {seen.sum()} rays cross {field[1]} = {level:.4g}, {shown.sum()} hits, "
                    f"{unknown.sum()} unknown; values off by {off:.2g} of the range"
                )
                self.assertLess(off, 1e-12)


if __name__ == "__main__":
    unittest.main()
