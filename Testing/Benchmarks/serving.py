#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Measures `pixelexact serve`: latency, several pages at once, malformed requests.

Usage: PIXELEXACT_TOOL=... PIXELEXACT_DATA_DIR=... serving.py latency|clients|malformed [--file FILE]
       [--size WxH] [--seconds S] [--clients N] [--requests N]

latency prints medians of the time from a message to the picture's last byte, by a client on the same machine. clients turns
the views of N pages at once and prints the waits for pictures and memory. malformed sends seeded garbage and prints memory.
"""

import argparse
import random
import socket
import statistics
import sys
import threading
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "Tools"))

from browser import Refused, Server  # noqa: E402
from tool import case  # noqa: E402


def exact(header):
    return header.get("kind") == "frame" and header["exact"]


def frame(header):
    return header.get("kind") == "frame"


def timed(page, wanted, **message):
    begin = time.perf_counter()
    page.send(**message)
    header, content = page.wait(wanted)
    return time.perf_counter() - begin, header, len(content)


def latency(server, size):
    with server.connect() as page:
        first, header, size_of = timed(page, exact, size=size)
        print(f"first exact picture     {1000 * first:7.0f} ms  {size_of} bytes, tracing and colours {1000 * header['seconds']:.0f} ms")
        turns, stops, sizes, traced = [], [], [], []
        for _ in range(20):
            took, header, content = timed(page, frame, turn=[0.05, 0.02])
            if header["exact"]:
                continue  # a newer picture replaced the coarse one
            turns.append(took)
            took, header, content = timed(page, exact, still=True)
            stops.append(took)
            sizes.append(content)
            traced.append(header["seconds"])
        print(f"turn to coarse picture  {1000 * statistics.median(turns):7.0f} ms")
        print(f"stop to exact picture   {1000 * statistics.median(stops):7.0f} ms  longest {1000 * max(stops):.0f} ms, "
              f"{statistics.median(sizes):.0f} bytes, tracing and colours {1000 * statistics.median(traced):.0f} ms")
        hovers = [timed(page, lambda h: h.get("kind") == "hover", hover=[size[0] // 2 + k, size[1] // 2])[0] for k in range(20)]
        print(f"value under the pointer {1000 * statistics.median(hovers):7.1f} ms")


def spread(name, waits):
    """Prints the median, the 95th percentile and the longest of times in seconds."""
    ordered = sorted(waits)
    part = ordered[min(len(ordered) - 1, int(0.95 * len(ordered)))]
    print(f"{name:24}{1000 * statistics.median(ordered):7.0f} ms  95 % {1000 * part:.0f} ms  longest {1000 * ordered[-1]:.0f} ms  "
          f"of {len(ordered)}")


def clients(server, size, seconds, count):
    end = time.monotonic() + seconds
    firsts, coarse_waits, exact_waits = [], [], []
    before = server.memory() / 2**20

    def turn():
        with server.connect() as page:
            firsts.append(timed(page, exact, size=size)[0])
            while time.monotonic() < end:
                for _ in range(5):
                    took, header, _ = timed(page, frame, turn=[0.05, 0.0])
                    if not header["exact"]:  # else a newer picture replaced the coarse one
                        coarse_waits.append(took)
                begin = time.perf_counter()
                if not header["exact"]:
                    page.wait(exact)
                    exact_waits.append(time.perf_counter() - begin)

    threads = [threading.Thread(target=turn) for _ in range(count)]
    for thread in threads:
        thread.start()
    memory = []
    while any(thread.is_alive() for thread in threads):
        memory.append(server.memory() / 2**20)
        time.sleep(1)
    print(f"{count} pages of {size[0]} x {size[1]} pixels, {seconds:.0f} s")
    spread("first exact picture", firsts)
    spread("turn to coarse picture", coarse_waits)
    spread("stop to exact picture", exact_waits)
    print(f"memory without pages: {before:.0f} MiB")
    for part in (0.1, 0.25, 0.5, 0.75, 1.0):
        print(f"memory after {100 * part:.0f} %: {memory[min(len(memory) - 1, int(part * len(memory)))]:.0f} MiB")
    time.sleep(3)
    print(f"memory when all have left: {server.memory() / 2**20:.0f} MiB")


def malformed(server, count):
    dice = random.Random(57)
    token = server.parts.query
    lines = ["GET / HTTP/1.1", f"GET /?{token} HTTP/1.1", "Host: 127.0.0.1", "Upgrade: websocket", "Connection: Upgrade",
             "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==", "Sec-WebSocket-Version: 13", "Content-Length: -1",
             "Content-Length: 99999999999", "Transfer-Encoding: chunked", "\0" * 9, "A" * 9000, "GET", "HTTP/9.9 x", ": x",
             "Upgrade: h2c", "HTTP2-Settings: AAAA", "PRI * HTTP/2.0"]
    texts = ['{"set":{"--field":"%s"}}', '{"turn":[%s,0]}', '{"size":[%s,9]}', '{"hover":%s}', '{"save":"%s"}', '[%s]', '{"zoom":%s}']
    values = ["u", "1e999", "-1", "null", "((((", "u/0", "\\u0000", "nan(", "9" * 50, "[[[[", "u;--output=x", "x" * 300]
    for k in range(count):
        try:
            if k % 4 == 0:
                with server.connect(timeout=5) as page:
                    for _ in range(dice.randint(1, 4)):
                        text = bytearray((dice.choice(texts) % dice.choice(values)).encode())
                        for _ in range(dice.randint(0, 3)):
                            text[dice.randrange(len(text))] = dice.randrange(256)
                        page.send_bytes(bytes(text), opcode=dice.choice([0, 1, 1, 1, 2, 3, 8, 9, 10, 15]),
                                        final=dice.random() < 0.8, masked=dice.random() < 0.9)
            else:
                data = bytearray("\r\n".join(dice.choices(lines, k=dice.randint(1, 8))).encode() + dice.choice([b"", b"\r\n\r\n"]))
                for _ in range(dice.randint(0, 6)):
                    data[dice.randrange(len(data))] = dice.randrange(256)
                with socket.create_connection(("127.0.0.1", server.port), timeout=5) as link:
                    link.sendall(bytes(data))
        except (Refused, OSError, ValueError):
            pass
        if not server.is_running():
            sys.exit(f"the server ended after {k + 1} requests: {server.stop()}")
        if (k + 1) % max(1, count // 10) == 0:
            print(f"{k + 1} requests, memory {server.memory() / 2**20:.0f} MiB")
    time.sleep(12)
    with server.connect() as page:
        print(f"afterwards an exact picture in {1000 * timed(page, exact, size=[300, 200])[0]:.0f} ms")


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("what", choices=["latency", "clients", "malformed"])
    parser.add_argument("--file", default=str(case("toroid_hex_g3_p6")))
    parser.add_argument("--size", default="1000x1000")
    parser.add_argument("--seconds", type=float, default=60)
    parser.add_argument("--clients", type=int, default=10)
    parser.add_argument("--requests", type=int, default=10000)
    given = parser.parse_args()
    size = [int(side) for side in given.size.split("x")]
    with Server(given.file, "--plane", "z=40%", "--view", "iso") as server:
        if given.what == "latency":
            latency(server, size)
        elif given.what == "clients":
            clients(server, size, given.seconds, given.clients)
        else:
            malformed(server, given.requests)


if __name__ == "__main__":
    main()
