"""A page with the exact picture, for a notebook or a browser."""

from __future__ import annotations

import atexit
import base64
import html
import os
import shutil
import subprocess
import tempfile
from pathlib import Path as FilePath
from typing import Any, Optional, Sequence

from ._tool import Input, files_of, find_tool, text_of_error, words_of
from ._work import Error

# The picture stays where scripts do not run or the browser does not reach the server.
_PAGE = """<div id="{id}"><img src="data:image/png;base64,{picture}" width="{width}" height="{height}"
style="max-width:100%;object-fit:contain" alt="picture of the field"></div>
<script>
(() => {{
  const place = document.getElementById("{id}"), address = "{address}";
  fetch(address, {{ mode: "no-cors" }}).then(() => {{
    const frame = document.createElement("iframe");
    Object.assign(frame, {{ src: address, width: "100%", height: "{height}" }});
    frame.style.border = "1px solid #ccc";
    place.replaceChildren(frame);
  }}, () => {{}});
}})();
</script>"""


class Shown:
    """A page that `pixelexact serve` shows. In a notebook it is the page, and a picture of it where
    the browser does not reach the server.

    address: of the page, with its token. picture: the bytes of a PNG. close() ends the server, as the
    end of Python does.
    """

    def __init__(self, address: str, picture: bytes, size: Sequence[int], process: Any, folder: str) -> None:
        self.address = address
        self.picture = picture
        self._size = tuple(size)
        self._process = process
        self._folder = folder
        atexit.register(self.close)

    def close(self) -> None:
        """Ends the server. The picture stays."""
        atexit.unregister(self.close)
        if self._process is not None:
            self._process.terminate()
            self._process.wait()
            self._process.stdout.close()
            self._process.stdin.close()
            self._process = None
        shutil.rmtree(self._folder, ignore_errors=True)

    def __enter__(self) -> Shown:
        return self

    def __exit__(self, *_: Any) -> None:
        self.close()

    def __repr__(self) -> str:
        return f"<Shown at {self.address}>" if self._process is not None else "<Shown, closed>"

    def _repr_png_(self) -> bytes:
        return self.picture

    def _repr_html_(self) -> str:
        width, height = self._size
        return _PAGE.format(
            id="pixelexact-" + os.urandom(8).hex(),
            picture=base64.b64encode(self.picture).decode(),
            address=html.escape(self.address),
            width=width,
            height=height,
        )


def show(
    grid: Input,
    field: Optional[str] = None,
    *,
    size: Sequence[int] = (900, 600),
    **options: Any,
) -> Shown:
    """A page with the exact picture of a cut, which turns, moves and zooms, with values under the
    pointer and controls: the program's `serve`, at an address of this machine.

    grid: a vtkUnstructuredGrid, the name of a file, or a list of names (a mesh and its fields, or time
    steps). A grid is written to a temporary file. field: a field's name or an expression.
    size: width and height of the page in a notebook, and of its picture, in pixels. options: those of
    the program's render, with underscores: plane="z=40%", contours=9, edges=True.

    Raises Error, with the program's words, for what it refuses, and where there is no program.
    """
    tool = find_tool("show")
    width, height = (int(side) for side in size)
    folder = tempfile.mkdtemp(prefix="pixelexact-")
    process = None
    try:
        files = files_of("show", grid, folder)
        words = words_of({"field": field, **options})
        picture = os.path.join(folder, "picture.png")
        words_of_picture = [*words, f"--size={width}x{height}", f"--output={picture}", "--quiet"]
        done = subprocess.run(
            [tool, "render", *files, *words_of_picture], capture_output=True, text=True, check=False
        )
        if done.returncode != 0:
            raise Error(text_of_error(done.stderr))
        messages = os.path.join(folder, "messages.txt")
        with open(messages, "wb") as stream:
            process = subprocess.Popen(
                [tool, "serve", *files, *words, "--port=0", "--quiet", "--until-input-ends"],
                # It ends with this process, also where that is killed.
                stdin=subprocess.PIPE,
                stdout=subprocess.PIPE,
                stderr=stream,
                text=True,
            )
        assert process.stdout is not None
        address = process.stdout.readline().strip()
        if not address:
            process.stdout.close()
            process.stdin.close()
            said = FilePath(messages).read_text(encoding="utf-8", errors="replace")
            raise Error(text_of_error(said))
        return Shown(address, FilePath(picture).read_bytes(), (width, height), process, folder)
    except BaseException:
        if process is not None:
            process.kill()
            process.wait()
        shutil.rmtree(folder, ignore_errors=True)
        raise
