# SPDX-License-Identifier: BSD-3-Clause
"""serve: what a page gets is what render and probe give, and only who has the token gets it."""

import csv
import io
import json
import math
import os
import random
import re
import shlex
import signal
import socket
import subprocess
import tempfile
import time
import unittest
from pathlib import Path

import numpy as np
from browser import Refused, Server, WebSocket, request
from tool import CUBE, DATA, TOOL, case, plain_grid, read_image, run, unit_cube_grid

TORUS = case("toroid_hex_g3_p6")
SIZE = [120, 90]


def is_exact(header):
    return header.get("kind") == "frame" and header["exact"]


def is_failure(header):
    return header.get("kind") == "failure"


def is_file(header):
    return header.get("kind") == "file"


def is_hover(header):
    return header.get("kind") == "hover"


class ServeTest(unittest.TestCase):
    """Tests with one server of the toroid, which has a scalar and a vector."""

    options = ["--plane", "z=40%", "--field", "u"]

    @classmethod
    def setUpClass(cls):
        cls.server = Server(TORUS, *cls.options)

    @classmethod
    def tearDownClass(cls):
        messages = cls.server.stop()
        if cls.server.process.returncode != 0 or "internal error" in messages:
            raise AssertionError(f"{cls.server.process.returncode}: {messages}")

    def open(self, size=SIZE, **options):
        page = self.server.connect(**options)
        self.addCleanup(page.close)
        page.send(size=size)
        return page, page.wait(is_exact)[0]

    def folder(self):
        folder = tempfile.TemporaryDirectory(prefix="pixelexact-")
        self.addCleanup(folder.cleanup)
        return Path(folder.name)

    def pixels(self, content):
        path = self.folder() / "picture.png"
        path.write_bytes(content)
        return read_image(path)

    def rendered(self, command, folder):
        """What the printed command line writes."""
        words = shlex.split(command)
        self.assertEqual(words[:2], ["pixelexact", "render"])
        done = run(*words[1:], folder=folder)
        self.assertEqual(done.returncode, 0, done.stderr)


class Access(ServeTest):
    def test_page_needs_the_token(self):
        port, token = self.server.port, self.server.parts.query
        status, page = request(port, "/?" + token)
        self.assertEqual(status, 200)
        self.assertIn(b"<title>PixelExact</title>", page)
        self.assertNotRegex(page.decode(), r"(src|href)=.https?:")
        for target in ("/", "/?token=", "/?token=" + "0" * 32, "/?" + token + "0", "/?" + token[:-1], "/x?" + token,
                       "/../../etc/passwd?" + token, "/?x=1", f"/{TORUS}?{token}"):
            self.assertEqual(request(port, target), (403, b""), target)
        self.assertRegex(token, r"^token=[0-9a-f]{32}$")

    def test_other_methods_and_hosts_are_refused(self):
        port, token = self.server.port, self.server.parts.query
        for method in ("POST", "PUT", "DELETE", "OPTIONS"):
            status, content = request(port, "/?" + token, method, ["Content-Length: 0"])
            self.assertNotEqual(status, 200, method)
            self.assertNotIn(b"PixelExact", content)
        for host in ("example.com", "127.0.0.1.example.com", "localhost.example.com"):
            self.assertEqual(request(port, "/?" + token, host=host), (403, b""), host)
        self.assertEqual(request(port, "/?" + token, host="localhost")[0], 200)

    def test_sockets_need_token_origin_and_host(self):
        address = self.server.address
        bare = address.split("?")[0]
        for other in (bare, bare + "?token=" + "f" * 32):
            with self.assertRaises(Refused) as caught:
                WebSocket(other)
            self.assertEqual(caught.exception.args[0], 403)
        for origin in ("http://example.com", "null", f"http://127.0.0.1:{self.server.port + 1}", "http://" + "a" * 3000):
            with self.assertRaises(Refused):
                self.server.connect(origin=origin)
        with self.assertRaises(Refused):
            self.server.connect(host="example.com")
        self.server.connect(origin=f"http://127.0.0.1:{self.server.port}").close()
        # As behind ssh -L 9000:localhost:PORT.
        self.server.connect(host="localhost:9000", origin="http://localhost:9000").close()

    def test_tokens_differ(self):
        with Server(TORUS, *self.options) as other:
            self.assertNotEqual(other.parts.query, self.server.parts.query)


class Pictures(ServeTest):
    def test_exact_picture_is_that_of_its_command(self):
        page, _ = self.open()
        page.send(turn=[0.4, 0.2], zoom=1.3, move=[0.1, -0.05])
        page.send(set={"--contours": "5", "--edges": True, "--colormap": "plasma", "--plane": "x=37.5%"})
        header, content = page.wait(is_exact)
        folder = self.folder()
        self.rendered(header["command"], folder)
        (written,) = folder.iterdir()
        np.testing.assert_array_equal(self.pixels(content), read_image(written))
        self.assertEqual(header["mime"], "image/png")
        self.assertEqual(sum(header["pixels"].values()), SIZE[0] * SIZE[1])

    def test_coarse_pictures_come_first(self):
        page, _ = self.open([900, 700])
        coarse = 0
        for _ in range(10):
            page.send(turn=[0.3, 0.0])
            header, content = page.receive()
            self.assertTrue(content)
            if not header["exact"]:  # on a busy machine the exact one may have replaced it
                coarse += 1
                page.wait(is_exact)
        self.assertGreater(coarse, 0)

    # Certified contours of this on the curved boundary take many seconds.
    SLOW = {"--boundary": "all", "--field": "mag(grad(u))", "--contours": "25"}

    def test_a_change_interrupts_contours(self):
        page, _ = self.open([900, 700])
        page.send(view="iso")
        page.wait(is_exact)
        page.send(set=self.SLOW)
        page.receive()
        time.sleep(1.0)  # its tracing has ended
        page.send(set={"--contours": None})
        header, _ = page.wait(is_exact)
        self.assertNotIn("--contours", header["options"])

    def test_contours_give_way_to_other_pages(self):
        slow, _ = self.open([900, 700])
        quick, _ = self.open()
        slow.send(view="iso")
        slow.wait(is_exact)
        slow.send(set=self.SLOW)
        slow.receive()
        time.sleep(1.0)
        quick.send(turn=[0.1, 0.0])
        quick.wait(is_exact)
        slow.send(set={"--contours": None})
        self.assertNotIn("--contours", slow.wait(is_exact)[0]["options"])

    def test_exact_pictures_follow_each_change(self):
        """Also where other messages come while the picture is traced."""
        page, _ = self.open([900, 700])
        for round_ in range(12):
            page.send(turn=[0.1, 0.0])
            time.sleep(0.05 + 0.01 * round_)
            page.send(still=True)
            page.send(hover=[1, 1])
            time.sleep(0.01)
            self.assertTrue(page.wait(is_exact))

    def test_saved_files_are_those_of_render(self):
        page, _ = self.open([600, 450])
        page.send(set={"--figure": True, "--title": "a figure"}, turn=[0.2, 0.1])
        for suffix in ("png", "svg", "vti"):
            page.send(save=suffix)
            header, content = page.wait(is_file)
            folder = self.folder()
            self.rendered(header["command"], folder)
            written = (folder / header["name"]).read_bytes()
            self.assertTrue(header["name"].endswith("." + suffix))
            self.assertEqual(content == written, True, suffix)

    def test_files_give_way_to_pictures(self):
        """A page gets its pictures while a large file of another page is drawn."""
        slow, _ = self.open()
        quick, _ = self.open()
        slow.send(size=[1600, 1200], set={"--contours": "25", "--samples": "8"})
        slow.send(save="vti")
        slow.link.setblocking(False)
        for _ in range(3):
            quick.send(turn=[0.1, 0.0])
            quick.wait(is_exact)
        # What has come until now is no file.
        early = b""
        try:
            while part := slow.link.recv(1 << 20):
                early += part
        except BlockingIOError:
            pass
        self.assertNotIn(b'{"kind":"file"', early)
        self.assertIn(b'"exact":false', early)
        slow.link.settimeout(300)
        slow.close()

    def test_waiting_files(self):
        """A few files may wait for a page, and come one after the other."""
        page, _ = self.open([600, 450])
        for _ in range(12):
            page.send(save="png")
        seen = []
        while seen.count("file") + seen.count("failure") < 12:
            header, _ = page.receive()
            seen.append(header["kind"])
            if header["kind"] == "failure":
                self.assertIn("files wait", header["text"])
        self.assertGreaterEqual(seen.count("file"), 4)
        page.send(save="png")
        self.assertTrue(page.wait(is_file)[1])

    def test_a_file_that_fails_leaves_the_picture(self):
        page, before = self.open()
        page.send(turn=[0.2, 0.0], save="exe")
        page.wait(is_failure)
        self.assertNotEqual(page.wait(is_exact)[0]["command"], before["command"])

    def test_expressions(self):
        page, _ = self.open()
        page.send(set={"--field": "mag(grad(u))"})
        header, content = page.wait(is_exact)
        self.assertEqual(header["field"], "mag(grad(u))")
        folder = self.folder()
        self.rendered(header["command"], folder)
        (written,) = folder.iterdir()
        np.testing.assert_array_equal(self.pixels(content), read_image(written))

    def test_values_are_those_of_probe(self):
        page, _ = self.open()
        found = []
        for x in range(5, SIZE[0], 10):
            page.send(hover=[x, SIZE[1] // 2])
            header, _ = page.wait(is_hover)
            if header["verdict"] == "exact":
                found.append(header)
        self.assertGreater(len(found), 3)
        points = "\n".join(",".join(map(repr, one["position"])) for one in found)
        path = self.folder() / "points.csv"
        path.write_text("x,y,z\n" + points + "\n", encoding="utf-8")
        done = run("probe", TORUS, "--field", "u", "--points", path, "--output", "-")
        self.assertEqual(done.returncode, 0, done.stderr)
        rows = list(csv.DictReader(io.StringIO(done.stdout)))
        for one, row in zip(found, rows):
            self.assertEqual(one["value"], float(row["value"]))
            self.assertEqual(one["element"], int(row["element"]))

    def test_hover_beside_the_mesh(self):
        page, _ = self.open()
        page.send(hover=[0, 0])
        header, _ = page.wait(is_hover)
        self.assertEqual((header["verdict"], header["pixel"]), ("nothing", [0, 0]))
        self.assertNotIn("value", header)

    def test_marks_after_a_range(self):
        """The range that was shown does not stay where pixels have the colours of a legend."""
        page, before = self.open()
        page.send(set={"--show": "validity"})
        self.assertNotIn("--range", page.wait(is_exact)[0]["command"])
        page.send(turn=[0.1, 0.0])
        self.assertNotIn("--range", page.wait(is_exact)[0]["command"])
        page.send(set={"--show": None}, view="fit")
        self.assertEqual(page.wait(is_exact)[0]["bar"], before["bar"])

    def test_iso_surface_and_boundary(self):
        page, before = self.open()
        low, high = before["values"]
        page.send(view="iso")
        page.wait(is_exact)
        for change in ({"--isosurface": f"u={(low + high) / 2}"}, {"--boundary": "all"}, {"--plane": "y"}):
            page.send(set=change)
            header, _ = page.wait(is_exact)
            self.assertEqual(list(change), [name for name in ("--plane", "--isosurface", "--boundary")
                                            if name in header["options"]])
            self.assertGreater(header["pixels"]["exact"], 0)

    def test_warp(self):
        page, before = self.open()
        page.send(set={"--warp": "vec(u,u,u)=0.01"})
        header, _ = page.wait(is_exact)
        self.assertNotEqual(header["box"], before["box"])
        folder = self.folder()
        self.rendered(header["command"], folder)
        page.send(set={"--warp": None})
        self.assertEqual(page.wait(is_exact)[0]["box"], before["box"])

    def test_views_of_pages_are_their_own(self):
        one, first = self.open()
        other, _ = self.open()
        one.send(view="+x")
        self.assertNotEqual(one.wait(is_exact)[0]["command"], first["command"])
        other.send(hover=[0, 0])
        other.send(size=[100, 80])
        header, _ = other.wait(is_exact)
        self.assertEqual(header["options"], {**first["options"]})


class Figures(ServeTest):
    options = [*ServeTest.options, "--figure", "--title", "a title", "--mark-extremes", "--font-size", "14"]

    def test_are_saved_and_not_shown(self):
        page, header = self.open([600, 450])
        self.assertIn("--mark-extremes", header["command"])
        page.send(save="png")
        header, content = page.wait(is_file)
        folder = self.folder()
        self.rendered(header["command"], folder)
        self.assertEqual(content == (folder / header["name"]).read_bytes(), True)


class Steps(ServeTest):
    def setUp(self):
        self.steps = self.folder()
        for step in range(3):
            (self.steps / f"torus_{step}.vtu").symlink_to(TORUS)

    def test_time_steps(self):
        files = sorted(self.steps.iterdir())
        with Server(*files, *self.options) as server, server.connect() as page:
            page.send(size=SIZE)
            header, _ = page.wait(is_exact)
            self.assertEqual((len(header["times"]), header["step"]), (3, 0))
            page.send(set={"--time-step": "2"})
            header, content = page.wait(is_exact)
            self.assertEqual(header["step"], 2)
            folder = self.folder()
            self.rendered(header["command"], folder)
            (written,) = folder.iterdir()
            np.testing.assert_array_equal(self.pixels(content), read_image(written))
            page.send(set={"--time-step": "7"})
            self.assertIn("3 time steps", page.wait(is_failure)[0]["text"])
            self.assertEqual(page.wait(is_exact)[0]["step"], 2)

    def test_a_file_without_steps(self):
        """It has the step 0 alone, as for render."""
        done = run("render", TORUS, "--time-step", "1", "--output", self.folder() / "x.png")
        self.assertEqual(done.returncode, 1)
        page, before = self.open()
        page.send(set={"--time-step": "1"})
        text = page.wait(is_failure)[0]["text"]
        self.assertIn("no time steps", text)
        self.assertIn(text.split("';")[-1], done.stderr)
        page.send(set={"--time-step": "0"})
        self.assertEqual(page.wait(is_exact)[0]["pixels"], before["pixels"])


class Cameras(ServeTest):
    options = [*ServeTest.options, "--view", "+x"]

    def test_first_picture_that_fails_keeps_the_view(self):
        _, right = self.open()
        page = self.server.connect()
        self.addCleanup(page.close)
        page.send(size=SIZE, set={"--field": "nothing"})
        page.wait(is_failure)
        self.assertEqual(page.wait(is_exact)[0]["command"], right["command"])


class Phases(ServeTest):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory(prefix="pixelexact-")
        cls.addClassCleanup(folder.cleanup)
        cls.cube = Path(folder.name) / "cube.vtu"
        fields = [("p_real", [p[0] for p in CUBE]), ("p_imag", [p[1] for p in CUBE])]
        cls.cube.write_text(unit_cube_grid(fields), encoding="utf-8")
        cls.server = Server(cls.cube, "--plane", "z", "--field", "p_real")

    def test_fields_at_a_phase(self):
        page, first = self.open()
        self.assertTrue(first["complex"])
        self.assertEqual([one["name"] for one in first["fields"]], ["p_real", "p_imag"])
        for degrees in ("90", "30", "-225"):
            page.send(set={"--phase": degrees, "--field": "p"})
            header, _ = page.wait(is_exact)
            self.assertIn({"name": "p", "components": 1}, header["fields"])
            page.send(hover=[SIZE[0] // 2 + 7, SIZE[1] // 2 - 5])
            value, _ = page.wait(is_hover)
            x, y, _ = value["position"]
            angle = math.radians(float(degrees))
            self.assertAlmostEqual(value["value"], x * math.cos(angle) - y * math.sin(angle), places=14)
        page.send(set={"--phase": None, "--field": "p_imag"})
        self.assertNotIn("--phase", page.wait(is_exact)[0]["options"])

    def test_wrong_phases(self):
        page, before = self.open()
        for value in ("x", "nan", "1,2", "1e999"):
            page.send(set={"--phase": value})
            self.assertEqual(page.wait(is_failure)[0]["options"], before["options"])


class Ends(unittest.TestCase):
    def folder(self):
        folder = tempfile.TemporaryDirectory(prefix="pixelexact-")
        self.addCleanup(folder.cleanup)
        return Path(folder.name)

    def test_signals_while_a_file_is_read(self):
        n = 40
        corners = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)]
        at = np.stack(np.meshgrid(*[np.arange(n)] * 3, indexing="ij"), axis=-1).reshape(-1, 1, 3) + np.array(corners)
        cells = (at[..., 0] * (n + 1) + at[..., 1]) * (n + 1) + at[..., 2]
        points = np.stack(np.meshgrid(*[np.arange(n + 1) / n] * 3, indexing="ij"), axis=-1).reshape(-1, 3)
        large = self.folder() / "large.vtu"
        large.write_text(plain_grid(points, [(12, ids) for ids in cells], [("u", points[:, 0])]), encoding="utf-8")
        for number in (signal.SIGTERM, signal.SIGINT):
            process = subprocess.Popen([TOOL, "serve", large, "--plane", "z"], stdout=subprocess.PIPE,
                                       stderr=subprocess.PIPE, text=True)
            while not self.blocks(process, number):  # which the program does before it reads
                time.sleep(0.001)
            process.send_signal(number)
            output, messages = process.communicate(timeout=60)
            self.assertEqual((process.returncode, output), (-number, ""), messages)
            self.assertIn(f"ended by {number.name}", messages)

    @staticmethod
    def blocks(process, number):
        status = Path(f"/proc/{process.pid}/status").read_text(encoding="utf-8")
        return bool(int(re.search(r"SigBlk:\s*([0-9a-f]+)", status)[1], 16) & 1 << (number - 1))

    def test_signals_while_a_picture_is_drawn(self):
        with Server(TORUS, "--plane", "z", "--samples", "8", "--contours", "25") as server, server.connect() as page:
            page.send(size=[2000, 2000])
            page.send(save="vti")
            page.receive()
            server.process.terminate()
            server.process.communicate(timeout=60)
            self.assertEqual(server.process.returncode, 0)


class Refusals(ServeTest):
    def test_files_cannot_be_named(self):
        page, before = self.open()
        for name, value in (("--output", "/tmp/x.png"), ("--buffers", "/tmp/x.vti"), ("--surface", "/etc/passwd"),
                            ("--patch", "/etc/passwd"), ("--font", "/etc/passwd"), ("--config", "/etc/passwd"),
                            ("--contours-output", "/tmp/x.vtp"), ("INPUT", "/etc/passwd"), ("--layer", "1:colormap=/x"),
                            ("--colormap", "/etc/passwd"), ("--colormap", "a.json"), ("--colormap", "../a.xml:b"),
                            ("--sweep", "z=0:1:9"), ("--threads", "1"), ("--size", "9999x9999"), ("-o", "x.png"),
                            ("--time-step", "all"), ("--samples", "16"), ("--field", "u\n--output=x")):
            page.send(set={name: value})
            header, _ = page.wait(is_failure)
            self.assertEqual(header["options"], before["options"], name)
        page.send(hover=[1, 1])
        self.assertEqual(page.wait(is_hover)[0]["verdict"], "nothing")

    def test_every_option_of_a_file_is_unreachable(self):
        """No row of the table whose form is a file can be set."""
        table = json.loads((Path(__file__).parents[2] / "Rendering/Settings/settings.json").read_text(encoding="utf-8"))
        rows = [row for group in table["groups"] for row in group["settings"]]
        files = {row["option"].split(",")[-1] for row in rows
                 if row.get("option", "").startswith("-") and re.search(r"FILE|FOLDER|\.vt|IMAGE", row.get("form", ""))}
        self.assertIn("--surface", files)
        page, _ = self.open()
        for name in files:
            page.send(set={name: "a.json"})
            self.assertIn(name, page.wait(is_failure)[0]["text"])

    def test_failures_leave_the_picture(self):
        page, before = self.open()
        for change in ({"--field": "nothing"}, {"--field": "u+"}, {"--range": "3,1"}, {"--log": True, "--range": "-1,1"},
                       {"--contours": "x"}, {"--plane": "0,0,0,0,0,0"}, {"--edges": "-3"}, {"--isosurface": "u=x"}):
            page.send(set=change)
            self.assertTrue(page.wait(is_failure)[0]["text"], change)
        page.send(size=[110, 80])
        self.assertEqual(page.wait(is_exact)[0]["options"], before["options"])

    def test_a_refusal_does_not_end_what_is_drawn(self):
        page, _ = self.open()
        page.send(turn=[0.1, 0.0])
        page.send(set={"--colormap": "/etc/passwd"})
        page.wait(is_failure)
        page.wait(is_exact)

    def test_wrong_members_are_named(self):
        page, _ = self.open()
        for message in ({"turn": [1]}, {"turn": ["a", 0]}, {"turn": [1e9, 0]}, {"zoom": 0}, {"zoom": -1}, {"zoom": "x"},
                        {"move": {}}, {"size": [0, 0]}, {"size": [4096, 4096]}, {"size": [1e30, 2]}, {"hover": [1]},
                        {"view": 3}, {"view": "sideways"}, {"save": "exe"}, {"save": "../x"}, {"set": 3}, {"set": {"--edges": 3}}):
            page.send(**message)
            self.assertTrue(page.wait(is_failure)[0]["text"], message)
        page.send(turn=[0.1, 0.1])
        self.assertTrue(page.wait(is_exact))

    def assert_closed(self, page):
        with self.assertRaises((ConnectionError, socket.timeout)):
            while True:
                page.receive()

    def test_garbage_closes(self):
        for payload in (b"", b"\xff\xfe", b"[]", b"{", b"3", b"[" * 9000, b"x" * 20000):
            page, _ = self.open()
            page.send_bytes(payload)
            self.assert_closed(page)
        page, _ = self.open()
        page.send_bytes(b"{}", opcode=2)
        self.assert_closed(page)
        page, _ = self.open()
        with self.assertRaises((ConnectionError, socket.timeout)):
            for _ in range(40):
                page.send_bytes(b"y" * 1000, final=False)
            while True:
                page.receive()

    def test_floods_close(self):
        page, _ = self.open()
        with self.assertRaises(ConnectionError):
            for _ in range(3000):
                page.send(hover=[1, 1])
            while True:
                page.receive()

    def test_malformed_requests(self):
        """The server survives seeded garbage of HTTP and WebSocket."""
        dice = random.Random(57)
        token = self.server.parts.query
        lines = ["GET / HTTP/1.1", "GET /?" + token + " HTTP/1.1", "Host: 127.0.0.1", "Upgrade: websocket", "Connection: Upgrade",
                 "Sec-WebSocket-Key: x", "Sec-WebSocket-Version: 99", "Content-Length: -1", "Content-Length: 99999999999",
                 "Transfer-Encoding: chunked", "\x00" * 9, "A" * 9000, "GET", "HTTP/9.9 x", "Range: bytes=-1", ": x"]
        for _ in range(300):
            text = "\r\n".join(dice.choices(lines, k=dice.randint(1, 7))).encode() + dice.choice([b"", b"\r\n\r\n", b"\n\n"])
            data = bytearray(text)
            for _ in range(dice.randint(0, 5)):
                data[dice.randrange(len(data))] = dice.randrange(256)
            with socket.create_connection(("127.0.0.1", self.server.port), timeout=10) as link:
                link.sendall(bytes(data))
                if dice.random() < 0.3:
                    link.settimeout(0.05)
                    try:
                        self.assertNotIn(b"<title>", link.recv(4096) if token.encode() not in data else b"")
                    except (socket.timeout, ConnectionError):
                        pass
        self.assertTrue(self.server.is_running())
        page, _ = self.open()
        for _ in range(50):
            page.send_bytes(bytes(dice.randrange(256) for _ in range(dice.randint(1, 125))), opcode=9)
        self.assertEqual(request(self.server.port, "/?" + token)[0], 200)


class Limits(unittest.TestCase):
    def test_number_of_pages(self):
        with Server(TORUS, "--plane", "z", "--views", "2") as server:
            first, second = server.connect(), server.connect()
            with self.assertRaises(Refused) as caught:
                server.connect()
            self.assertEqual(caught.exception.args[0], 503)
            first.close()
            for _ in range(100):
                try:
                    server.connect().close()
                    break
                except Refused:
                    time.sleep(0.1)
            else:
                self.fail("a closed page still counts")
            second.close()

    def test_slow_page_hinders_no_other(self):
        with Server(TORUS, "--plane", "z") as server, server.connect() as slow, server.connect() as other:
            for _ in range(20):
                slow.send(size=[1200, 1000])  # and reads nothing
                slow.send(size=[1000, 1200])
            other.send(size=SIZE)
            self.assertTrue(other.wait(is_exact))

    def test_usage(self):
        for words, expected in ((["--sweep", "z=0:1:9"], "serve"), (["--stride", "4"], "--stride"), (["--buffers", "x.vti"], "serve"),
                                (["--port", "70000"], "--port"), (["--views", "0"], "--views"), (["--field", "nothing"], "nothing")):
            done = run("serve", TORUS, *words)
            self.assertIn(done.returncode, (1, 2), words)
            self.assertIn(expected, done.stderr)
        done = run("serve", TORUS, "--address", "192.0.2.1")
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertIn("--address", done.stderr)
        self.assertEqual(run("serve", DATA / "nowhere.vtu").returncode, 1)


if __name__ == "__main__":
    unittest.main()
