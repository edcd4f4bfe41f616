# SPDX-License-Identifier: BSD-3-Clause
"""A client of `pixelexact serve` by the standard library: HTTP, and a small part of WebSockets (RFC 6455)."""

import base64
import hashlib
import json
import os
import socket
import struct
import subprocess
import urllib.parse

from tool import TOOL

GUID = "258EAFA5-E914-47DA-95CA-C5AB0DC85B11"


class Refused(Exception):
    """The server answered an upgrade with another status, which is the first argument; 0: none."""


def request(port, target, method="GET", headers=(), host="127.0.0.1"):
    """Status and content of an HTTP request; (0, b"") where the server closes without an answer."""
    lines = [f"{method} {target} HTTP/1.1", f"Host: {host}:{port}", "Connection: close", *headers, "", ""]
    with socket.create_connection(("127.0.0.1", port), timeout=30) as link:
        try:
            link.sendall("\r\n".join(lines).encode())
            answer = b""
            while part := link.recv(65536):
                answer += part
        except ConnectionError:
            return 0, b""
    head, _, body = answer.partition(b"\r\n\r\n")
    return (int(head.split()[1]), body) if head.startswith(b"HTTP/") else (0, b"")


class WebSocket:
    """A connection to a server's address, as `serve` prints it."""

    def __init__(self, address, origin=None, host=None, timeout=120):
        parts = urllib.parse.urlsplit(address)
        self.link = socket.create_connection((parts.hostname, parts.port), timeout=timeout)
        key = base64.b64encode(os.urandom(16)).decode()
        target = parts.path + ("?" + parts.query if parts.query else "")
        lines = [f"GET {target} HTTP/1.1", f"Host: {host or parts.netloc}", "Upgrade: websocket",
                 "Connection: Upgrade", f"Sec-WebSocket-Key: {key}", "Sec-WebSocket-Version: 13"]
        lines += [f"Origin: {origin}"] if origin else []
        self.link.sendall("\r\n".join(lines + ["", ""]).encode())
        head = b""
        while b"\r\n\r\n" not in head:
            part = self.link.recv(1)
            if not part:
                break
            head += part
        status = int(head.split()[1]) if head.startswith(b"HTTP/") else 0
        if status != 101:
            self.link.close()
            raise Refused(status)
        expected = base64.b64encode(hashlib.sha1((key + GUID).encode()).digest())
        if expected not in head:
            raise ValueError("the server's answer to the upgrade is wrong")

    def close(self):
        self.link.close()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()

    def send_bytes(self, payload, opcode=1, final=True, masked=True):
        """One frame of RFC 6455, section 5.2."""
        size = len(payload)
        head = bytes([(0x80 if final else 0) | opcode])
        bit = 0x80 if masked else 0
        if size < 126:
            head += bytes([bit | size])
        elif size < 65536:
            head += bytes([bit | 126]) + struct.pack(">H", size)
        else:
            head += bytes([bit | 127]) + struct.pack(">Q", size)
        if masked:
            mask = os.urandom(4)
            head += mask
            payload = bytes(byte ^ mask[k % 4] for k, byte in enumerate(payload))
        self.link.sendall(head + payload)

    def send(self, **message):
        self.send_bytes(json.dumps(message).encode())

    def _exactly(self, count):
        data = bytearray()
        while len(data) < count:
            part = self.link.recv(min(65536, count - len(data)))
            if not part:
                raise ConnectionError("the server closed the connection")
            data += part
        return bytes(data)

    def _frame(self):
        first, second = self._exactly(2)
        size = second & 0x7F
        if size == 126:
            size = struct.unpack(">H", self._exactly(2))[0]
        elif size == 127:
            size = struct.unpack(">Q", self._exactly(8))[0]
        return first & 0x0F, bool(first & 0x80), self._exactly(size)

    def receive(self):
        """The next message, as (header, content). A text is a header alone; a binary message has a
        header's length in 4 bytes, the header in JSON and its content. Throws ConnectionError where
        the server has closed."""
        kind, data = 0, b""
        while True:
            opcode, final, payload = self._frame()
            if opcode == 8:
                raise ConnectionError(f"closed with {struct.unpack('>H', payload[:2])[0] if payload else 0}")
            if opcode == 9:
                self.send_bytes(payload, opcode=10)
            if opcode in (1, 2):
                kind = opcode
            if opcode < 8:
                data += payload
                if final:
                    break
        if kind == 1:
            return json.loads(data), b""
        size = struct.unpack(">I", data[:4])[0]
        return json.loads(data[4 : 4 + size]), data[4 + size :]

    def wait(self, wanted):
        """The first message for whose header `wanted(header)` is true. A failure that is not wanted
        is an AssertionError."""
        while True:
            header, content = self.receive()
            if wanted(header):
                return header, content
            if header.get("kind") == "failure":
                raise AssertionError(header["text"])


class Server:
    """A running `pixelexact serve` with a token of its own. `address` is the page's."""

    def __init__(self, *arguments, folder=None):
        environment = {name: value for name, value in os.environ.items() if name != "DISPLAY"}
        self.process = subprocess.Popen(
            [TOOL, "serve", *map(str, arguments), "--port", "0"], env=environment, cwd=folder,
            stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        self.address = self.process.stdout.readline().strip()
        if not self.address.startswith("http://"):
            raise ValueError(self.stop())
        self.parts = urllib.parse.urlsplit(self.address)
        self.port = self.parts.port

    def connect(self, **options):
        return WebSocket(self.address, **options)

    def memory(self):
        """Resident memory in bytes."""
        with open(f"/proc/{self.process.pid}/statm", encoding="utf-8") as stream:
            return int(stream.read().split()[1]) * os.sysconf("SC_PAGE_SIZE")

    def is_running(self):
        return self.process.poll() is None

    def stop(self):
        """Ends it; returns its messages."""
        if self.is_running():
            self.process.terminate()
        try:
            _, messages = self.process.communicate(timeout=60)
        except subprocess.TimeoutExpired:
            self.process.kill()
            _, messages = self.process.communicate()
        return messages

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.stop()
