# SPDX-License-Identifier: BSD-3-Clause
"""Sweeps, turns and time steps: their pictures are those of single calls; restart; videos."""

import shutil
import subprocess
import unittest

import numpy as np

from tool import CUBE, DATA, ToolTest, case, plain_grid, read_buffers, read_image, run, unit_cube_grid

from TestFigure import texts_of

SIZE = ["--size", "64x48"]


class AnimationTest(ToolTest):
    def setUp(self):
        super().setUp()
        self.cube = self.folder / "cube.vtu"
        fields = [("u", [p[0] + 10.0 * p[2] for p in CUBE])]
        self.cube.write_text(unit_cube_grid(fields), encoding="utf-8")

    def animate(self, *arguments, source=None, output="f_%03d.png"):
        return self.summary("render", source or self.cube, "--field", "u", *SIZE, *arguments, "-o",
            self.folder / output)

    def camera(self):
        """That all pictures here have."""
        return ["--camera-position", "0.5,0.5,5", "--focal-point", "0.5,0.5,0.5"]

    def single(self, *arguments, source=None):
        image = self.folder / "single.png"
        self.succeeds("render", source or self.cube, "--field", "u", *SIZE, *arguments, "-o", image)
        return read_image(image)


class Sweeps(AnimationTest):
    def test_pictures_are_those_of_planes(self):
        fixed = [*self.camera(), "--range", "0,11"]
        for sweep, places in [("z=0.1:0.9:5", [0.1, 0.3, 0.5, 0.7, 0.9]),
                              ("z=25%:75%:3", [0.25, 0.5, 0.75]), ("z=0.4:0.4:1", [0.4])]:
            found = self.animate("--sweep", sweep, *fixed)
            self.assertEqual((found["frames"], found["written"]), (len(places),) * 2)
            # Nothing is read or located again.
            self.assertEqual((found["read"], found["locators"]), (1, 1))
            for k, place in enumerate(places):
                expected = self.single("--plane", f"z={place}", *fixed)
                np.testing.assert_array_equal(read_image(found["files"][k]), expected)

    def test_one_range_for_all(self):
        found = self.animate("--sweep", "z=0.1:0.9:5", "--range", "all", *self.camera())
        low, high = found["color_range"]
        # u = x + 10 z, at pixels' centres.
        self.assertAlmostEqual(low, 1.0, delta=0.05)
        self.assertAlmostEqual(high, 10.0, delta=0.05)
        for k, place in enumerate([0.1, 0.3, 0.5, 0.7, 0.9]):
            expected = self.single("--plane", f"z={place}", *self.camera(), "--range", f"{low},{high}")
            np.testing.assert_array_equal(read_image(found["files"][k]), expected)
        found = self.animate("--sweep", "z=0.1:0.9:3", "--range", "symmetric-all", *self.camera())
        self.assertEqual(found["color_range"][0], -found["color_range"][1])

    def test_range_of_all_of_a_layer(self):
        found = self.animate("--sweep", "z=0.1:0.9:3", "--layer", "1:range=all", *self.camera())
        self.assertAlmostEqual(found["color_range"][0], 1.0, delta=0.05)
        low, high = found["color_range"]
        expected = self.single("--plane", "z=0.5", *self.camera(), "--range", f"{low},{high}")
        np.testing.assert_array_equal(read_image(found["files"][1]), expected)

    def test_camera_sees_all(self):
        # A wedge of planes across x: none leaves the picture.
        found = self.animate("--sweep", "x=0:1:4", "--view", "iso", "--background", "none")
        seen = [read_image(file)[..., 3] > 0 for file in found["files"]]
        self.assertFalse(np.array_equal(seen[0], seen[-1]))
        for mask in seen:
            self.assertGreater(mask.sum(), 50)
            self.assertFalse(mask[[0, -1]].any() or mask[:, [0, -1]].any())

    def test_other_surfaces_stay(self):
        found = self.animate("--sweep", "z=0.2:0.8:2", "--sphere", "0.5,0.5,0.5,0.3",
            "--layer", "1:color=1:0:0", "--layer", "2:color=0:0:1", "--lights", "off", "--view", "iso")
        for file in found["files"]:
            colors = np.unique(read_image(file).reshape(-1, 3), axis=0).tolist()
            self.assertEqual(sorted(colors), [[0, 0, 255], [255, 0, 0], [255, 255, 255]])

    def test_contours_and_figures(self):
        found = self.summary("render", self.cube, "--field", "u", "--sweep", "z=0.2:0.8:3", "--figure",
            "--size", "300x240", "--contours", "4", "--title", "t", *self.camera(), "-o",
            self.folder / "f_%03d.png")
        texts = texts_of(self.folder / "f_001.png")
        self.assertEqual(texts["Frame"], "1 of 3")
        self.assertIn("cube.vtu", texts["Source"])
        self.assertIn("--sweep", texts["Command"])
        self.assertEqual(len(found["files"]), 3)


class Turns(AnimationTest):
    def test_pictures_are_those_of_cameras(self):
        start = ["--camera-position", "3,-2,0.5", "--focal-point", "0.5,0.5,0.5", "--view-up", "0,0,1"]
        found = self.animate("--turn", "180:3", "--plane", "z", "--range", "0,11", *start)
        self.assertEqual((found["read"], found["locators"]), (1, 1))
        pivot, from_pivot = np.array([0.5, 0.5]), np.array([2.5, -2.5])
        for k, file in enumerate(found["files"]):
            c, s = np.cos(k * np.pi / 3), np.sin(k * np.pi / 3)
            x, y = pivot + np.array([[c, -s], [s, c]]) @ from_pivot
            expected = self.single("--plane", "z", "--range", "0,11", "--camera-position",
                f"{float(x)!r},{float(y)!r},0.5", *start[2:])
            different = (read_image(file) != expected).any(axis=2).mean()
            self.assertLess(different, 0.01)

    def test_camera_sees_all(self):
        found = self.animate("--turn", "360:5", "--plane", "z", "--view", "iso", "--background", "none")
        masks = [read_image(file)[..., 3] > 0 for file in found["files"]]
        for mask in masks:
            self.assertGreater(mask.sum(), 100)
            self.assertFalse(mask[[0, -1]].any() or mask[:, [0, -1]].any())


class Steps(AnimationTest):
    def series(self, moved=0.0):
        sets = ""
        for step in range(3):
            points = [[p[0] + moved * step, p[1], p[2]] for p in CUBE]
            text = plain_grid(points, [(12, list(range(8)))], [("u", [(step + 1.0) * p[0] for p in CUBE])])
            (self.folder / f"s_{step}.vtu").write_text(text, encoding="utf-8")
            sets += f'<DataSet timestep="{0.5 * step}" part="0" file="s_{step}.vtu"/>'
        path = self.folder / "series.pvd"
        path.write_text(f'<VTKFile type="Collection"><Collection>{sets}</Collection></VTKFile>',
            encoding="utf-8")
        return path

    def test_all_steps(self):
        fixed = ["--plane", "z", *self.camera(), "--range", "0,3"]
        for moved, locators in [(0.0, 1), (0.25, 3)]:
            series = self.series(moved)
            found = self.animate("--time-step", "all", *fixed, source=series, output="t_{step}.png")
            # Each file once; a mesh that stays the same is located once.
            self.assertEqual((found["frames"], found["read"], found["locators"]), (3, 3, locators))
            for step in range(3):
                expected = self.single("--time-step", step, *fixed, source=series)
                np.testing.assert_array_equal(read_image(self.folder / f"t_{step}.png"), expected)

    def test_range_of_all(self):
        found = self.animate("--time-step", "all", "--plane", "z", "--range", "all", source=self.series())
        self.assertAlmostEqual(found["color_range"][0], 0.0, delta=0.1)
        self.assertAlmostEqual(found["color_range"][1], 3.0, delta=0.1)

    def test_with_a_turn(self):
        series = self.series()
        found = self.animate("--time-step", "all", "--turn", "30:3", "--plane", "z", source=series)
        self.assertEqual(found["frames"], 3)
        self.fails(1, "render", series, "--field", "u", "--plane", "z", "--time-step", "all", "--turn", "30:4", "-o",
            self.folder / "a_%d.png", names=["--time-step all", "3", "4"])

    def test_solver_files(self):
        source = DATA / "nek_tet_varp"
        files = [next(source.glob("*.xml")), next(source.glob("*.fld"))]
        done = run("render", *files, "--time-step", "all", *SIZE, "-o", self.folder / "n_%d.png")
        self.assertIn(done.returncode, (0, 1), done.stderr)
        if done.returncode == 1:
            self.assertIn("no time steps", done.stderr)

    def test_other_commands_take_one(self):
        self.fails(2, "info", self.series(), "--time-step", "all", names=["--time-step"])
        self.fails(1, "render", self.cube, "--field", "u", "--plane", "z", "--time-step", "all", "-o", self.folder / "a_%d.png",
            names=["--time-step all", "no time steps"])


class Resumed(AnimationTest):
    def test_what_is_there_stays(self):
        words = ["--sweep", "z=0.2:0.8:4", *self.camera(), "--resume"]
        found = self.animate(*words)
        self.assertEqual((found["written"], found["kept"]), (4, 0))
        files = [self.folder / f"f_{k:03}.png" for k in range(4)]
        before = [file.read_bytes() for file in files]
        times = [file.stat().st_mtime_ns for file in files]
        files[2].unlink()
        files[1].write_bytes(before[1][: len(before[1]) // 2][:60])  # cut off before it says what it is
        found = self.animate(*words)
        self.assertEqual((found["written"], found["kept"]), (2, 2))
        self.assertEqual([file.read_bytes() for file in files], before)
        self.assertEqual([file.stat().st_mtime_ns == time for file, time in zip(files, times)],
            [True, False, False, True])
        # Other words, another input: all are made again.
        found = self.animate(*words, "--colormap", "plasma")
        self.assertEqual(found["kept"], 0)
        self.cube.write_text(unit_cube_grid([("u", [p[1] for p in CUBE])]), encoding="utf-8")
        found = self.animate(*words, "--colormap", "plasma")
        self.assertEqual(found["kept"], 0)
        found = self.animate(*words, "--colormap", "plasma", "--threads", 1)
        self.assertEqual(found["kept"], 4)
        self.assertFalse(list(self.folder.glob("*.part")))

    def test_files_of_options(self):
        colors = self.folder / "map.json"
        words = ["--sweep", "z=0.2:0.8:2", "--colormap", f"{colors}:m", "--resume"]
        for blue, kept in [(0, 0), (0, 2), (1, 0)]:
            colors.write_text(f'[{{"Name":"m","RGBPoints":[0,0,0,{blue},1,1,1,1]}}]', encoding="utf-8")
            self.assertEqual(self.animate(*words)["kept"], kept)

    def test_files_behind_a_collection(self):
        text = unit_cube_grid([("u", [p[0] for p in CUBE])])
        for step in range(2):
            (self.folder / f"s_{step}.vtu").write_text(text, encoding="utf-8")
        sets = "".join(f'<DataSet timestep="{k}" part="0" file="s_{k}.vtu"/>' for k in range(2))
        series = self.folder / "series.pvd"
        series.write_text(f'<VTKFile type="Collection"><Collection>{sets}</Collection></VTKFile>',
            encoding="utf-8")
        words = ["--time-step", "all", "--plane", "z", "--resume"]
        self.assertEqual(self.animate(*words, source=series)["written"], 2)
        self.assertEqual(self.animate(*words, source=series)["kept"], 2)
        text = unit_cube_grid([("u", [p[1] for p in CUBE])])
        (self.folder / "s_1.vtu").write_text(text, encoding="utf-8")
        self.assertEqual(self.animate(*words, source=series)["kept"], 0)

    def test_other_formats(self):
        for output in ["r_%d.tif", "r_%d.jpg"]:
            words = ["--sweep", "z=0.2:0.8:2", "--resume"]
            self.assertEqual(self.animate(*words, output=output)["written"], 2)
            self.assertEqual(self.animate(*words, output=output)["kept"], 2)


@unittest.skipUnless(shutil.which("ffmpeg"), "ffmpeg is not installed")
class Videos(AnimationTest):
    def frames(self, path, width, height):
        """Its pictures, decoded."""
        data = subprocess.run(["ffmpeg", "-loglevel", "error", "-i", path, "-f", "rawvideo", "-pix_fmt",
            "rgb24", "-"], stdout=subprocess.PIPE, check=True).stdout
        return np.frombuffer(data, np.uint8).reshape(-1, height, width, 3)[:, ::-1]

    def test_pictures_come_back(self):
        fixed = [*self.camera(), "--range", "0,11"]
        for name in ["v.mp4", "v.webm"]:
            found = self.animate("--sweep", "z=0.1:0.9:5", *fixed, output=name)
            self.assertEqual((found["frames"], found["files"]), (5, [str(self.folder / name)]))
            decoded = self.frames(self.folder / name, 64, 48)
            self.assertEqual(len(decoded), 5)
            for k, picture in enumerate(decoded):
                expected = self.single("--plane", f"z={0.1 + 0.2 * k}", *fixed)
                self.assertLess(np.abs(picture.astype(int) - expected).mean(), 6.0)

    def test_odd_sizes_are_padded(self):
        self.succeeds("render", self.cube, "--sweep", "z=0.1:0.9:2", "--size", "33x27", "-o",
            self.folder / "v.mp4")
        self.assertEqual(len(self.frames(self.folder / "v.mp4", 34, 28)), 2)


class Refused(AnimationTest):
    def test_wrong_usage(self):
        base = ["render", self.cube, "--field", "u", *SIZE]
        sweep = ["--sweep", "z=0:1:3"]
        out = ["-o", self.folder / "a_%d.png"]
        for text in ["z=0:1", "z=0:1:0", "w=0:1:3", "z", "z=0:x:3", "z=0%:1:3", "z=-5%:50%:3", "", "z=0:1:2.5"]:
            self.fails(2, *base, f"--sweep={text}", *out, names=["--sweep"])
        for text in ["360", "x:3", "360:0", "1:2:3"]:
            self.fails(2, *base, "--turn", text, *out, names=["--turn"])
        self.fails(2, *base, *sweep, "--turn", "90:4", *out, names=["--sweep", "--turn"])
        self.fails(2, *base, *sweep, names=["--output", "%04d"])
        self.fails(2, *base, *sweep, "-o", "-", names=["--output"])
        for name in ["a.png", "a_%x.png", "a_%d_%d.png", "a_%4d.png"]:
            self.fails(2, *base, *sweep, "-o", self.folder / name, names=["--output", "{frame}"])
        self.fails(2, *base, *sweep, "-o", self.folder / "a_{step}.png", names=["one name"])
        self.fails(2, *base, *sweep, *out, "--buffers", self.folder / "a.vti", names=["--buffers", "%04d"])
        self.fails(2, *base, "--resume", "-o", self.folder / "a.png", names=["--resume"])
        self.fails(2, *base, *sweep, "--resume", "-o", self.folder / "a.mp4", names=["--resume"])
        self.fails(2, *base, *sweep, "--background", "none", "-o", self.folder / "a.mp4",
            names=["--background"])
        self.fails(1, *base, *sweep, "-o", self.folder / "absent" / "a_%d.png", names=["absent"])

    def test_buffers(self):
        """Those of single calls; where one is missing its picture is made again."""
        sweep = ["--sweep", "z=0.1:0.9:3", *self.camera(), "--buffers", self.folder / "b_%d.vti"]
        self.animate(*sweep, "--arrays", "Value,Position")
        for k, place in enumerate([0.1, 0.5, 0.9]):
            one = self.folder / "one.vti"
            self.single("--plane", f"z={place}", *self.camera(), "--buffers", one, "--arrays", "Value,Position")
            expected, found = read_buffers(one), read_buffers(self.folder / f"b_{k}.vti")
            self.assertEqual(set(found), {"Value", "Position"})
            for name, array in expected.items():
                np.testing.assert_array_equal(found[name], array)
        again = [*sweep, "--arrays", "Value,Position", "--resume"]
        self.assertEqual(self.animate(*again)["kept"], 3)
        (self.folder / "b_1.vti").unlink()
        found = self.animate(*again)
        self.assertEqual((found["kept"], found["written"]), (2, 1))
        self.assertTrue((self.folder / "b_1.vti").exists())

    @unittest.skipUnless(shutil.which("ffprobe"), "ffmpeg is not installed")
    def test_pictures_in_a_second(self):
        for asked, rate in [([], "25/1"), (["--fps", "10"], "10/1")]:
            video = self.folder / "a.mp4"
            self.animate("--sweep", "z=0.1:0.9:3", *asked, "--buffers", self.folder / "v_{frame}.vti", output="a.mp4")
            told = subprocess.run(["ffprobe", "-v", "error", "-count_frames", "-show_entries",
                "stream=r_frame_rate,nb_read_frames", "-of", "csv=p=0", str(video)], stdout=subprocess.PIPE, text=True,
                check=True).stdout.strip()
            self.assertEqual(told.split(",")[:2], [rate, "3"])
            self.assertEqual(read_buffers(self.folder / "v_2.vti")["Value"].shape, (48, 64))

    def test_without_ffmpeg(self):
        import os
        from unittest import mock

        with mock.patch.dict(os.environ, {"PATH": str(self.folder)}):
            self.fails(1, "render", self.cube, "--sweep", "z=0:1:3", "-o", self.folder / "a.mp4",
                names=["ffmpeg", "cut_%04d.png"])


if __name__ == "__main__":
    unittest.main()
