# SPDX-License-Identifier: BSD-3-Clause
"""Surfaces that are made of the mesh: what is no boundary and no iso-surface is refused."""

import unittest

from tool import CUBE, DATA, ToolTest, run, unit_cube_grid

class MeshSurfaces(ToolTest):
    def setUp(self):
        super().setUp()
        self.cube = self.folder / "cube.vtu"
        fields = [
            ("u", [x for x, _, _ in CUBE]),
            ("p=q.1", [3.0 + z for _, _, z in CUBE]),
            ("v", [[x, 2.0, z] for x, _, z in CUBE]),
        ]
        self.cube.write_text(unit_cube_grid(fields), encoding="utf-8")
        self.image = self.folder / "i.png"
        self.base = ["render", self.cube, "--field", "u", "--output", self.image]

    def test_iso_surfaces_that_are_none(self):
        for text in ["u", "=0.5", "u=", "u=half", "u=nan", "u=inf", "u=1e999", "u=1,2"]:
            done = self.fails(2, *self.base, "--isosurface", text, names=["FIELD=VALUE", text])
            self.assertIn("--isosurface", done.stderr)
        for text, names in {
            "w=0.5": ["no field 'w'", "'u'", "'v'"],
            "v.3=0.5": ["component 3", "'v' has 3 components"],
            "u.1=0.5": ["component 1", "'u' has 1 component"],
        }.items():
            self.fails(1, *self.base, "--isosurface", text, names=["--isosurface", *names])
        done = run(*self.base, "--isosurface", "v.w=0.5")
        self.assertEqual(done.returncode, 1)
        self.assertIn("--isosurface: 'w' is not expected here\n  v.w\n    ^", done.stderr)
        self.assertFalse(self.image.exists())

    def test_values_beyond_the_range_name_it(self):
        # u = x, from 0 to 1; |v| from 2 to sqrt(6).
        for text, names in {
            "u=1.5": ["field 'u'", "values from ", "1.5 is none of them", "choose a value between"],
            "u=-1e-9": ["-1e-09"],
            "v=1.9": ["the magnitude of field 'v'"],
            "v.magnitude=2.5": ["the magnitude of field 'v'", "2.449489742783"],
            "v.1=0": ["component 1 of field 'v'", "0 is none of them"],
            "p=q.1=2.9": ["field 'p=q.1'"],
        }.items():
            self.fails(1, *self.base, "--isosurface", text, names=["--isosurface", *names])

    def test_values_within_it_are_accepted(self):
        for text in ["u=0.5", "u.0=1", "v=2.2", "v.magnitude=2", "v.2=0", "p=q.1=3.5", "p=q.1.0=4"]:
            self.succeeds(*self.base, "--isosurface", text, "--size", "9x9")
        # Without --field, and of another one than is shown.
        render = ["render", self.cube, "--output", self.image]
        for field in [[], ["--field", "v"]]:
            self.succeeds(*render, *field, "--isosurface", "p=q.1=3.5", "--size", "9x9")

    def test_values_that_need_a_jacobian(self):
        flux = DATA / "mfem_escher_tet_darcy_p3"
        render = ["render", flux / f"{flux.name}.mesh", flux / "flux.gf", "--output", self.image]
        for text in ["flux=0.5", "flux.1=0"]:
            names = ["--isosurface", "field 'flux'", "H(div)", "choose another field"]
            self.fails(1, *render, "--isosurface", text, names=names)

    def test_no_magnitude_is_negative(self):
        names = ["--isosurface", "'v'", "magnitude", "0 is none of them", "choose a value between"]
        self.fails(1, *self.base, "--isosurface", "v=0", names=names)
        zero = self.folder / "zero.vtu"
        zero.write_text(unit_cube_grid([("v", CUBE)]), encoding="utf-8")
        render = ["render", zero, "--output", self.image]
        names = ["--isosurface", "'v'", "magnitude", "positive"]
        self.fails(1, *render, "--isosurface", "v=0", names=names)
        self.fails(1, *render, "--isosurface", "v=-1", names=names[:3])

    def test_boundaries_that_are_none(self):
        for text in ["some", "1;2", "-1", "1,", "element:", "element:x", "element:1.5", "1,element:2"]:
            self.fails(2, *self.base, f"--boundary={text}", names=["--boundary", "element:NUMBER"])
        self.fails(1, *self.base, "--boundary=element:0,7", names=["no element 7", "from 0 to 0"])
        for text in ["all", "element:0"]:
            self.succeeds(*self.base, f"--boundary={text}", "--size", "9x9")

    def test_boundaries_by_attributes(self):
        for text in ["3", "0,3"]:
            names = ["--boundary", "there is no boundary attribute", "whole boundary"]
            self.fails(1, *self.base, f"--boundary={text}", names=names)
        folder = DATA / "mfem_escher_tet_darcy_p3"
        mesh, field = folder / f"{folder.name}.mesh", folder / "pressure.gf"
        there = self.summary("info", mesh, field)["boundary_attributes"]
        listed = ", ".join(there)
        render = ["render", mesh, field, "--output", self.image, "--size", "60x60"]
        names = ["--boundary", "attribute 77", listed]
        self.fails(1, *render, "--boundary=77", names=names)
        self.fails(1, *render, f"--boundary={next(iter(there))},77", names=names)
        whole = self.summary(*render, "--boundary")["pixels"]
        self.assertGreater(whole["exact"], 300)
        self.assertEqual(whole["unknown"], 0)
        every = "--boundary=" + ",".join(there)
        self.assertEqual(self.summary(*render, every)["pixels"], whole)

    def test_layers_count_them(self):
        several = ["--boundary", "--isosurface", "u=0.5", "--boundary=element:0"]
        several += ["--isosurface", "v=2.2", "--size", "9x9"]
        self.fails(2, *self.base, *several, "--layer", "5:opacity=0.5", names=["4 surfaces"])
        self.succeeds(*self.base, *several, "--layer", "4:opacity=0.5")

    def test_without_a_field(self):
        bare = self.folder / "bare.vtu"
        bare.write_text(unit_cube_grid([]), encoding="utf-8")
        render = ["render", bare, "--output", self.image]
        self.fails(1, *render, "--isosurface", "u=0.5", names=["--isosurface", "no field"])

    def test_files_are_read_before_the_mesh(self):
        surface = ["--surface", self.folder / "none.stl", "--boundary"]
        render = ["render", self.folder / "none.vtu", "--output", self.image]
        self.fails(1, *render, *surface, names=["none.stl", "no such file"])


if __name__ == "__main__":
    unittest.main()
