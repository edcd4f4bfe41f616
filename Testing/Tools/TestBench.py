# SPDX-License-Identifier: BSD-3-Clause
"""pixelexact bench: times that are times, of the work that render does."""

import unittest

from tool import MIDDLE, ToolTest, case


class Bench(ToolTest):
    def test_summary(self):
        shot = [case("escher_tet_g3_p3"), "--field", "u", *MIDDLE, "--size", "60x60"]
        summary = self.summary("bench", *shot, "--repeat", "3", "--threads", "1")
        render = self.summary("render", *shot, "--output", self.folder / "image.png")
        self.assertEqual(summary["points"], render["pixels"]["exact"])
        self.assertEqual(summary["threads"], 1)
        self.assertEqual(len(summary["frame_seconds"]), 3)
        self.assertEqual(len(summary["frame_processor_seconds"]), 3)
        median = sorted(summary["frame_seconds"])[1]
        self.assertEqual(summary["median_frame_seconds"], median)
        self.assertGreater(median, 0)
        self.assertAlmostEqual(summary["points_per_second"] * median / summary["points"], 1)
        self.assertGreater(summary["kernel_seconds"], 0)
        self.assertGreater(summary["ratio_to_kernel"], 0)
        # One thread: its stages are within the frame that they were timed in.
        stages = summary["stages"].values()
        self.assertGreater(min(stages), -1e-9)
        self.assertGreater(summary["stages"]["inversion"], 0)
        self.assertLessEqual(sum(stages), summary["staged_frame_seconds"])

    def test_contours(self):
        shot = [case("escher_tet_g3_p3"), "--field", "u", *MIDDLE, "--size", "60x60"]
        shot += ["--contours", "-0.2,0,0.1"]
        found = self.summary("bench", *shot, "--repeat", "3")["contours"]
        render = self.summary("render", *shot, "--output", self.folder / "image.png")
        for key in ["in", "out", "undecided"]:
            self.assertEqual(found[key], render["contours"]["pixels"][key])
        self.assertEqual(len(found["frame_seconds"]), 3)
        self.assertGreater(found["ratio_to_frame"], 1)
        self.fails(2, "bench", *shot, "--contour-labels", "12", names=["--contour-labels"])
        self.fails(2, "bench", "--contours", "3", names=["--contours", "without an INPUT"])

    def test_nothing_to_measure(self):
        base = ["bench", case("escher_tet_g3_p3"), "--field", "u", "--size", "9x9"]
        summary = self.summary(*base, "--plane", "0,0,9,0,0,1")
        self.assertEqual(summary["points"], 0)

    def test_figures(self):
        """Every made mesh fills the image, with no pixel that is not exact."""
        made = ["bench", "--elements", "60", "--size", "24x16", "--repeat", "1"]
        frames = self.summary(*made)["frames"]
        self.assertEqual({frame["shape"] for frame in frames},
            {"hexahedron", "prism", "tetrahedron", "pyramid", "mixed"})
        self.assertEqual({frame["order"] for frame in frames}, {3, 6, 8, 14})
        for frame in frames:
            self.assertEqual(frame["points"], frame["width"] * frame["height"])
            self.assertGreater(frame["one_thread_ratio"], 0)
            self.assertLessEqual(frame["elements_bounded"], frame["elements"])
            # Values are sums of some units; a float's roundoff is 6e-8.
            self.assertGreater(frame["floats_error"], 0)
            self.assertLess(frame["floats_error"], 1e-5)

    def test_the_papers_figures(self):
        folder = self.folder / "paper"
        found = self.summary(
            *("bench", case("toroid_hex_g3_p6"), "--field", "u", "--plane", "z=0.1"),
            *("--size", "200x200", "--paper", "quick", "--output", folder),
        )
        figures = {row["figure"] for row in found["rows"]}
        self.assertEqual(figures, {"8a", "8b", "10a", "10b", "10c", "10d", "10e", "10f"})
        for row in found["rows"]:
            self.assertGreater(row.get("seconds", row.get("bytes")), 0.0, row)
        # More triangles, smaller errors.
        coarse, fine = found["linear"]
        self.assertLess(2 * coarse["triangles"], fine["triangles"])
        self.assertLess(fine["mean_error"], 0.5 * coarse["mean_error"])
        names = {path.name for path in folder.iterdir()}
        self.assertLessEqual({"paper.csv", "errors.csv", "figure-8a.png", "figure-10f.png"}, names)

    def test_what_the_papers_figures_have_no_use_for(self):
        self.fails(2, "bench", "--paper", "quick", "--repeat", "3", names=["--repeat"])
        self.fails(2, "bench", "--paper", "quick", "--field", "u", names=["--field", "INPUT"])
        self.fails(2, "bench", "--output", "x", names=["--output", "--paper"])
        source = case("toroid_hex_g3_p6")
        sphere = ["--paper", "quick", "--sphere", "0,0,0,1"]
        self.fails(2, "bench", source, *sphere, names=["--sphere"])

    def test_errors(self):
        source = case("escher_tet_g3_p3")
        self.fails(2, "bench", source, *MIDDLE, "--elements", 5, names=["--elements", "no effect"])
        for words in [MIDDLE, ["--field", "u"], ["--colormap", "jet"], ["--outlines"]]:
            self.fails(2, "bench", *words, names=[words[0], "without an INPUT"])
        base = ["bench", case("escher_tet_g3_p3"), "--field", "u"]
        self.fails(2, *base, *MIDDLE, "--repeat", "0", names=["--repeat"])


if __name__ == "__main__":
    unittest.main()
