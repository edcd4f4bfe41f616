"""Messages name what ParaView's users see: filters, panels and properties."""

import re
import unittest

from paraview import simple

import scene


def torus():
    return simple.PixelExactGridReader(FileName=[scene.data("toroid_hex_g3_p6.vtu")])


class Messages(unittest.TestCase):
    def setUp(self):
        self.view = scene.view()

    def tearDown(self):
        simple.ResetSession()

    def check(self, text, *words):
        """What VTK adds before a message, the object's class and address, is left out."""
        for line in re.findall(r"\(0x[0-9a-f]+\): (.*)", text):
            if not line.startswith("Algorithm "):
                self.assertNotRegex(line, r"\bvtk[A-Z]|\b(Set|Add|Get)[A-Z][a-z]+|--[a-z]")
        for word in words:
            self.assertIn(word, text)

    def shown(self, source):
        representation = simple.Show(source, self.view)
        with scene.messages() as heard:
            representation.SetRepresentationType("PixelExact")
            scene.pixels(self.view)
        return heard[0]

    def test_cut_cells(self):
        name = "mfem_escher_tet_darcy_p3"
        reader = simple.PixelExactMFEMReader(FileName=scene.data(f"{name}/{name}.mesh"), Cells="Corners")
        said = self.shown(simple.Clip(Input=reader))
        self.check(said, "Extract Selection", "PixelExact Pack")
        self.assertNotIn("keeps its range", said)

    def test_plane_without_normal(self):
        shown = simple.Show(torus(), self.view)
        shown.SetRepresentationType("PixelExact")
        shown.CutFunction.Normal = [0, 0, 0]
        with scene.messages() as heard:
            scene.pixels(self.view)
        self.check(heard[0], "the normal of the plane is zero")

    def test_filters(self):
        grid = torus()
        for made, words in (
            (simple.PixelExactCalculator(Input=grid), ["type one under Function"]),
            (simple.PixelExactCalculator(Input=grid, Function="u", ResultArrayName="u"), ["Result Array Name"]),
            (simple.PixelExactIntegrate(Input=simple.Tetrahedralize(Input=grid)), ["Extract Selection"]),
        ):
            with scene.messages() as heard:
                made.UpdatePipeline()
            self.check(heard[0], *words)


if __name__ == "__main__":
    scene.main()
