# SPDX-License-Identifier: BSD-3-Clause
"""Options of a file and of the environment, and what is made of the options that there are."""

import json
import os
import shutil
import subprocess
import unittest
from unittest import mock

from tool import CUBE, ToolTest, read_image, run, unit_cube_grid

from TestFigure import texts_of


class DefaultsTest(ToolTest):
    def setUp(self):
        super().setUp()
        self.cube = self.folder / "cube.vtu"
        self.cube.write_text(unit_cube_grid([("u", [p[0] for p in CUBE])]), encoding="utf-8")
        self.image = self.folder / "a.png"
        self.base = ["render", self.cube, "--field", "u", "--plane", "z", "-o", self.image]
        patch = mock.patch.dict(os.environ, {"XDG_CONFIG_HOME": str(self.folder / "home")})
        patch.start()
        self.addCleanup(patch.stop)
        os.environ.pop("PIXELEXACT_OPTIONS", None)

    def config(self, content, path="home/pixelexact/config.json"):
        file = self.folder / path
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(content if isinstance(content, str) else json.dumps(content), encoding="utf-8")
        return file

    def size(self, *arguments):
        self.succeeds(*self.base, *arguments)
        return read_image(self.image).shape[1::-1]


class Files(DefaultsTest):
    def test_order_of_precedence(self):
        self.assertEqual(self.size(), (1000, 1000))
        self.config({"*": {"size": "10x11"}})
        self.assertEqual(self.size(), (10, 11))
        self.config({"*": {"size": "10x11"}, "render": {"size": "12x13"}, "bench": {"size": "1x1"}})
        self.assertEqual(self.size(), (12, 13))
        with mock.patch.dict(os.environ, {"PIXELEXACT_OPTIONS": "--size 14x15"}):
            self.assertEqual(self.size(), (14, 15))
            self.assertEqual(self.size("--size", "16x17"), (16, 17))
            self.assertEqual(self.size("--no-config"), (1000, 1000))
        other = self.config({"render": {"size": "18x19"}}, "other.json")
        self.assertEqual(self.size("--config", other), (18, 19))

    def test_kinds_of_values(self):
        self.config({"render": {"figure": True, "title": "of a file", "samples": 2, "contours": [0.5],
            "outlines": False, "size": "300x200"}})
        self.succeeds(*self.base)
        command = texts_of(self.image)["Command"]
        for word in ["--figure", "'--title=of a file'", "--samples=2", "--contours=0.5", "--no-config"]:
            self.assertIn(word, command)
        self.assertNotIn("--outlines", command)
        # What it says does the same without the file.
        first = self.image.read_bytes()
        shutil.rmtree(self.folder / "home")
        done = subprocess.run(command.replace("pixelexact", os.environ["PIXELEXACT_TOOL"], 1), shell=True,
            stdout=subprocess.PIPE, stderr=subprocess.PIPE, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(self.image.read_bytes()[-500:], first[-500:])

    def test_repeated_options(self):
        self.config({"render": {"plane": ["x", "y=25%"]}})
        found = self.summary("render", self.cube, "--field", "u", "-o", self.image, "--size", "9x9")
        self.assertEqual(len(found["layers"]), 2)
        found = self.summary("render", self.cube, "--field", "u", "--plane", "z", "-o", self.image,
            "--size", "9x9")
        self.assertNotIn("layers", found)

    def test_excluded_ones_stay_out(self):
        self.config({"render": {"colormap": "plasma", "range": "0,1", "size": "9x9"}})
        self.succeeds(*self.base, "--color", "1,0,0")
        self.assertEqual(self.size("--color", "1,0,0"), (9, 9))

    def test_other_commands(self):
        self.config({"*": {"colormap": "plasma", "quiet": True}})
        self.assertEqual(self.succeeds("info", self.cube).stdout, "")

    def test_mistakes(self):
        for content, says in [
            ("{", "JSON"), ("[]", "object"), ({"render": 3}, "object"),
            ({"rendr": {}}, "'rendr'"), ({"render": {"sise": "9x9"}}, "'sise'"),
            ({"*": {"sise": "9x9"}}, "'sise'"), ({"render": {"size": None}}, "size"),
            ({"render": {"size": {"a": 1}}}, "size"),
        ]:
            self.config(content)
            self.fails(2, *self.base, names=["config.json", says])
            self.succeeds(*self.base, "--no-config", "--size", "9x9")
        shutil.rmtree(self.folder / "home")
        self.fails(2, *self.base, "--config", self.folder / "absent.json", names=["--config", "absent.json"])


class Environment(DefaultsTest):
    def test_words(self):
        words = "--size=9x8 --title 'two  words' --figure --font-size 8 --threads 1"
        with mock.patch.dict(os.environ, {"PIXELEXACT_OPTIONS": words}):
            self.succeeds(*self.base, "--size", "300x200")
            self.assertIn("'--title=two  words'", texts_of(self.image)["Command"])
            # Of other commands' options there is no word.
            self.succeeds("info", self.cube)

    def test_mistakes(self):
        for words in ["--sise 9x9", "--size", "cube.vtu", "--size 9x9 more", "--title 'two words"]:
            with mock.patch.dict(os.environ, {"PIXELEXACT_OPTIONS": words}):
                self.fails(2, *self.base, names=["PIXELEXACT_OPTIONS"])


class Completion(DefaultsTest):
    def complete(self, *words):
        """What bash offers for the last word."""
        script = self.folder / "completion"
        script.write_text(self.succeeds("--completion", "bash").stdout, encoding="utf-8")
        quoted = " ".join(f"'{word}'" for word in words)
        code = (f"source {script}; COMP_WORDS=({quoted}); COMP_CWORD={len(words) - 1}; _pixelexact; "
            'printf "%s\\n" "${COMPREPLY[@]}"')
        return subprocess.run(["bash", "-c", code], stdout=subprocess.PIPE, text=True, check=True,
            cwd=self.folder).stdout.split()

    def test_bash(self):
        self.assertEqual(self.complete("pixelexact", "ren"), ["render"])
        self.assertIn("--mesh-outline", self.complete("pixelexact", "render", "--mesh"))
        self.assertEqual(self.complete("pixelexact", "render", "--plan"), ["--plane"])
        self.assertEqual(sorted(self.complete("pixelexact", "render", "--lights", "o")), ["off", "on"])
        self.assertEqual(self.complete("pixelexact", "info", "cub"), ["cube.vtu"])
        # Names and files.
        self.assertEqual(self.complete("pixelexact", "render", "--colormap", "gr"), ["grayscale"])
        self.assertLess({"coolwarm", "cube.vtu"}, {*self.complete("pixelexact", "render", "--colormap", "c")})
        self.assertEqual(self.complete("pixelexact", "render", "--transfer", "ro"), ["romaO"])
        self.assertEqual(self.complete("pixelexact", "render", "--font", "s"), ["sans", "serif"])
        self.assertEqual(self.complete("pixelexact", "render", "--font", "cu"), ["cube.vtu"])
        self.assertEqual(self.complete("pixelexact", "info", "--sweep"), [])

    def test_every_option_of_the_help_is_there(self):
        bash, zsh, manual = [self.succeeds("--completion", what).stdout for what in ("bash", "zsh", "man")]
        for command in ["info", "probe", "render", "bench", "view"]:
            for line in self.succeeds(command, "--help-all").stdout.splitlines():
                name = line.strip().split(" ")[0].split("[")[0].split(",")[-1]
                if line.startswith("  -") and name.startswith("--"):
                    self.assertIn(name, bash)
                    self.assertIn(name, zsh)
                    self.assertIn(name.replace("-", "\\-"), manual)

    @unittest.skipUnless(shutil.which("zsh"), "zsh is not installed")
    def test_zsh_reads_it(self):
        script = self.folder / "_pixelexact"
        script.write_text(self.succeeds("--completion", "zsh").stdout, encoding="utf-8")
        subprocess.run(["zsh", "-n", script], check=True)

    @unittest.skipUnless(shutil.which("man"), "man is not installed")
    def test_man_reads_it(self):
        page = self.folder / "pixelexact.1"
        page.write_text(self.succeeds("--completion", "man").stdout, encoding="utf-8")
        done = subprocess.run(["man", "--warnings", "-l", "-E", "UTF-8", page], stdout=subprocess.PIPE,
            stderr=subprocess.PIPE, text=True, check=True, env={**os.environ, "MANPAGER": "cat", "MANWIDTH": "100"})
        self.assertEqual(done.stderr, "")
        self.assertIn("PIXELEXACT_OPTIONS", done.stdout)
        self.assertIn("--mesh-outline", done.stdout)

    def test_unknown(self):
        self.fails(2, "--completion", "fish", names=["fish", "bash"])


if __name__ == "__main__":
    unittest.main()
