# SPDX-License-Identifier: BSD-3-Clause
"""Files of Bezier patches: what is no such file is refused, by file, line and remedy."""

import unittest

from tool import ToolTest, case

# The control points of the plane z = 0.1 over [-1, 1]^2, rows of u.
FLAT = [f"{2 * i / 3 - 1} {2 * j / 3 - 1} 0.1" for i in range(4) for j in range(4)]


class PatchFiles(ToolTest):
    def fails_with(self, lines, *names):
        file = self.folder / "patches.txt"
        file.write_text("\n".join(lines) + "\n", encoding="utf-8")
        image = self.folder / "i.png"
        base = ["render", case("toroid_hex_g3_p6"), "--output", image, "--size", "30x30"]
        self.fails(1, *base, "--patch", file, names=["patches.txt", *names])
        self.assertFalse(image.exists())

    def test_lines_that_are_no_points(self):
        self.fails_with([*FLAT[:3], "0 0", *FLAT[3:]], "line 4", "three finite numbers", "'0 0'")
        self.fails_with(["# made", "", *FLAT, "1 2 3 4"], "line 19", "'1 2 3 4'")
        self.fails_with(["patch of a ship", *FLAT], "line 1", "three finite numbers")
        self.fails_with([*FLAT[:15], "0 nan 0"], "line 16", "'0 nan 0'")
        self.fails_with([*FLAT[:15], "0 1e999 0"], "line 16")
        self.fails_with(["0,0,0", *FLAT[1:]], "line 1")

    def test_a_binary_file(self):
        file = self.folder / "ship.png"
        file.write_bytes(b"\x89PNG\r" + bytes(range(1, 10)) * 1000)
        self.fails(
            1, "render", case("toroid_hex_g3_p6"), "--output", self.folder / "i.png",
            "--patch", file, names=["line 1", "'?PNG ????????"])

    def test_patches_that_lack_points(self):
        self.fails_with(FLAT[:15], "line 15", "15 points of patch 1", "16 lines")
        self.fails_with([*FLAT, FLAT[0]], "line 17", "1 point of patch 2")
        self.fails_with(["# nothing", ""], "no points", "16 lines")

    def test_files_that_are_none(self):
        base = ["render", case("toroid_hex_g3_p6"), "--output", self.folder / "i.png"]
        self.fails(1, *base, "--patch", self.folder / "none.txt", names=["none.txt", "no such file"])
        self.fails(1, *base, "--patch", self.folder, names=[self.folder.name, "name a file"])

    def test_sound_files_are_read(self):
        sound = [f"{point.replace(' ', chr(9))}  # {k}\r" for k, point in enumerate(FLAT)]
        file = self.folder / "patches.txt"
        file.write_text("\n".join(["", "# flat", *sound, "", *FLAT]) + "\n", encoding="utf-8")
        base = ["render", case("toroid_hex_g3_p6"), "--output", self.folder / "i.png"]
        seen = self.summary(*base, "--size", "30x30", "--patch", file)
        # Two patches, one on the other.
        self.assertGreater(seen["pixels"]["exact"], 50)
        self.assertEqual(seen["pixels"]["unknown"], 0)


if __name__ == "__main__":
    unittest.main()
