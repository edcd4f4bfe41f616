# SPDX-License-Identifier: BSD-3-Clause
"""What is written, and where: buffers by name, compressed; standard streams; disks that are full."""

import os
import unittest
from pathlib import Path

import numpy as np

from tool import MIDDLE, ToolTest, case, read_buffers, read_image, run, unit_cube_grid

USUAL = ["Value", "Position", "Normal", "Xi", "Element", "Depth", "Verdict", "Layer", "Color"]


class OutputTest(ToolTest):
    def setUp(self):
        super().setUp()
        self.image, self.buffers = self.folder / "i.png", self.folder / "b.vti"
        self.shot = [case("escher_tet_g3_p3"), "--field", "u", *MIDDLE, "--size", "60x50"]
        self.both = ["--output", self.image, "--buffers", self.buffers]
        self.points = self.folder / "p.csv"
        self.points.write_text("x,y,z\n0,0,0\n0.1,0.2,0.3\n", encoding="utf-8")


class Buffers(OutputTest):
    def test_all_are_there_unasked(self):
        self.succeeds("render", *self.shot, *self.both)
        self.assertEqual(list(read_buffers(self.buffers)), USUAL)

    def test_those_of_empty_pictures_are_read_without_complaint(self):
        self.succeeds(
            "render", case("escher_tet_g3_p3"), "--plane", "0,0,9,0,0,1", "--size", "6x5", *self.both
        )
        self.assertNotRegex(self.buffers.read_bytes(), rb"(?m)^\s*-?nan\s*$")
        self.assertTrue(np.isnan(read_buffers(self.buffers)["Position"]).all())

    def test_those_asked_for_alone(self):
        self.succeeds("render", *self.shot, *self.both)
        every, size = read_buffers(self.buffers), self.buffers.stat().st_size
        for names in ["Value", "Verdict,Value", "Color", "Normal,Layer,Element"]:
            self.succeeds("render", *self.shot, *self.both, "--arrays", names)
            some = read_buffers(self.buffers)
            self.assertEqual(set(some), set(names.split(",")))
            for name, array in some.items():
                np.testing.assert_array_equal(array, every[name])
            self.assertLess(self.buffers.stat().st_size, size)
        names = "Owners,Coverage,Value_lower"
        more = ["--owners", "--enclosures", "--arrays", names]
        self.succeeds("render", *self.shot, *self.both, *more)
        self.assertEqual(set(read_buffers(self.buffers)), set(names.split(",")))

    def test_pieces_of_a_surface(self):
        """Of a box the face; of a plane nothing."""
        names = "Piece,Piece_u,Piece_v"
        self.succeeds("render", *self.shot, *self.both, "--arrays", names)
        self.assertEqual(set(read_buffers(self.buffers)["Piece"].ravel()), {-1})
        shot = [case("escher_tet_g3_p3"), "--field", "u", "--size", "60x50"]
        box = ["--box", "-0.4,-0.4,-0.4,0.4,0.4,0.4"]
        view = ["--camera-position", "3,2,4", "--focal-point", "0,0,0"]
        self.succeeds("render", *shot, *box, *view, *self.both, "--arrays", names)
        some = read_buffers(self.buffers)
        self.assertEqual(list(some), names.split(","))
        faces = set(some["Piece"].ravel()) - {-1}
        self.assertTrue(faces and faces <= set(range(6)), faces)

    def test_names_of_none(self):
        base = ["render", *self.shot, *self.both]
        for names in ["value", "Value,", "Values", "Value Verdict"]:
            self.fails(2, *base, "--arrays", names, names=["--arrays", "Verdict"])
        self.fails(2, *base, "--arrays", "Owners", names=["'Owners'", "--owners"])
        self.fails(2, *base, "--arrays", "Value_upper", names=["'Value_upper'", "--enclosures"])
        self.fails(2, *base[:-2], "--arrays", "Value", names=["--arrays", "--buffers"])

    def test_are_compressed_and_inline(self):
        """Inline, because ParaView 5.11 of Debian 12 cannot read appended data with the newest
        expat."""
        self.succeeds("render", *self.shot, *self.both)
        raw = sum(array.nbytes for array in read_buffers(self.buffers).values())
        self.assertLess(self.buffers.stat().st_size, 0.6 * raw)
        text = self.buffers.read_bytes()
        self.assertIn(b"vtkZLibDataCompressor", text)
        self.assertNotIn(b"AppendedData", text)


class StandardStreams(OutputTest):
    def test_a_picture(self):
        self.succeeds("render", *self.shot, "--output", self.image)
        for option in ["-o", "--output"]:
            done = run("render", *self.shot, option, "-", text=False)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertEqual(done.stdout, self.image.read_bytes())
            self.assertIn(b"exact", done.stderr)

    def test_buffers(self):
        self.succeeds("render", *self.shot, *self.both)
        done = run("render", *self.shot, "-o", self.image, "--buffers", "-", text=False)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(done.stdout, self.buffers.read_bytes())

    def test_tables(self):
        probe = ["probe", case("escher_tet_g3_p3"), "--field", "u"]
        table = self.folder / "o.csv"
        self.succeeds(*probe, "--points", self.points, "--output", table)
        given = self.points.read_text(encoding="utf-8")
        done = run(*probe, "--points", "-", "--output", "-", given=given)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(done.stdout, table.read_text(encoding="utf-8"))
        self.assertIn("points", done.stderr)
        self.fails(1, *probe, "--points", "-", "--output", "-", names=["header"])

    def test_one_alone(self):
        base = ["render", *self.shot]
        self.fails(2, *base, "-o", "-", "--buffers", "-", names=["standard output"])
        self.fails(2, *base, "-o", "-", "--json", names=["--json"])
        self.fails(2, *base, "-o", self.image, "--buffers", "-", "--json", names=["--json"])
        probe = ["probe", self.shot[0], "--points", self.points, "--output", "-"]
        self.fails(2, *probe, "--json", names=["--json"])


class Places(OutputTest):
    def full(self, suffix):
        link = self.folder / f"full{suffix}"
        link.symlink_to("/dev/full")
        return link

    def test_full_disks(self):
        png, vti, table = self.full(".png"), self.full(".vti"), self.full(".csv")
        probe = ["probe", self.shot[0], "--field", "u", "--points", self.points]
        for words, full in [
            (["render", *self.shot, "--output", png], png),
            (["render", *self.shot, "--output", self.image, "--buffers", vti], vti),
            ([*probe, "--output", table], table),
        ]:
            self.fails(1, *words, names=[full, "No space left on device", "room"])
            self.assertEqual(os.readlink(full), "/dev/full")
        with open("/dev/full", "w", encoding="utf-8") as stream:
            large = ["render", *self.shot[:-1], "200x200", "-o", "-"]
            for words in [["render", *self.shot, "-o", "-"], large, [*probe, "--output", "-"],
                          ["render", *self.shot, "-o", self.image, "--buffers", "-"]]:
                done = run(*words, stdout=stream)
                self.assertEqual(done.returncode, 1, done.stderr)
                self.assertIn("standard output: No space left on device", done.stderr)

    def test_what_is_read_is_not_overwritten(self):
        mesh = self.folder / "cube.vtu"
        mesh.write_text(unit_cube_grid(), encoding="utf-8")
        before = mesh.read_bytes()
        alias = Path(f"{self.folder}/./cube.vtu")
        for file in [mesh, alias, self.points]:
            self.fails(2, "probe", mesh, "--points", self.points, "--output", file, names=[file])
        self.assertEqual(mesh.read_bytes(), before)

    def test_folders_that_are_not_there_are_told_before_the_work(self):
        absent = self.folder / "absent"
        self.fails(1, "render", absent / "mesh.vtu", *MIDDLE, "-o", absent / "i.png",
                   names=["i.png", "no folder"])
        folder = self.folder / "folder.png"
        folder.mkdir()
        self.fails(1, "render", absent / "mesh.vtu", *MIDDLE, "-o", folder,
                   names=[folder, "it is a folder"])


class Pictures(OutputTest):
    def test_read_back(self):
        self.succeeds("render", *self.shot, *self.both)
        color = read_buffers(self.buffers)["Color"]
        alpha = color[..., 3:] / 255.0
        expected = np.rint(alpha * color[..., :3] + (1 - alpha) * 255)
        np.testing.assert_array_equal(read_image(self.image), expected)


if __name__ == "__main__":
    unittest.main()
