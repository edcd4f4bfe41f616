"""The program pixelexact, run with the keywords of Python functions as its options."""

from __future__ import annotations

import json
import math
import operator
import os
import shutil
import subprocess
import tempfile
from pathlib import Path as FilePath
from typing import Any, Sequence, Union

from vtkmodules.vtkCommonCore import vtkDataArray
from vtkmodules.vtkCommonDataModel import vtkUnstructuredGrid

from . import _run
from ._read import Path, as_high_order
from ._setting_rows import ROWS
from ._work import Error

Input = Union[vtkUnstructuredGrid, Path, Sequence[Path]]

_ALL_THREADS = _run.get_threads()


def find_tool(function: str) -> str:
    """The program: of this package's installation or build, else on the PATH. `function`: the name
    that the error begins with."""
    beside = FilePath(__file__).resolve().parents[4] / "bin" / "pixelexact"
    found = str(beside) if beside.is_file() else shutil.which("pixelexact")
    if found is None:
        raise Error(
            f"{function}: the program pixelexact is neither installed with this package nor on the "
            "PATH; install it or add its folder to PATH, or use pixelexact.render for a picture"
        )
    return found


def _option_of(keyword: str) -> str:
    """The option of a keyword: its own name, or that of the Python keyword (cmap: --colormap)."""
    row = ROWS.get(keyword)
    # A keyword that Python reserves has an underscore after it.
    return (row and row["option"]) or "--" + keyword.rstrip("_").replace("_", "-")


def _text(keyword: str, value: Any) -> str:
    if isinstance(value, (str, os.PathLike)):
        return os.fspath(value)
    if hasattr(value, "__index__"):
        return str(operator.index(value))
    if hasattr(value, "__float__"):
        return repr(float(value))
    raise TypeError(f"{keyword}: a text, a number or a list of these, not {type(value).__name__}")


def _is_list(value: Any) -> bool:
    return isinstance(value, (list, tuple)) or getattr(value, "shape", ()) != ()


def _is_text(value: Any) -> bool:
    return isinstance(value, (str, os.PathLike))


def _joined(keyword: str, numbers: Sequence[Any]) -> str:
    text = ("x" if keyword == "size" else ",").join(_text(keyword, number) for number in numbers)
    # The comma after a single contour makes it a value instead of a count.
    return text + "," if keyword == "contours" and len(numbers) == 1 else text


def _words_of(keyword: str, value: Any) -> list[str]:
    option = _option_of(keyword)
    if value is None or value is False:
        return []
    if value is True:
        return [option]
    if not _is_list(value):
        return [f"{option}={_text(keyword, value)}"]
    if not any(_is_list(each) or _is_text(each) for each in value):
        return [f"{option}={_joined(keyword, value)}"]
    words = []
    for each in value:
        if _is_list(each) and any(map(_is_text, each)):
            words += [option, *(_text(keyword, part) for part in each)]
        else:
            words += _words_of(keyword, each)
    return words


def words_of(options: dict[str, Any]) -> list[str]:
    """Keywords as options of the program. True: the option alone; None and False: nothing; numbers:
    with commas between them; a list of texts or of lists: the option once for each; a list in it of
    several files: one group of files, as --with takes."""
    words = [word for keyword, value in options.items() for word in _words_of(keyword, value)]
    if "threads" not in options and _run.get_threads() != _ALL_THREADS:
        words.append(f"--threads={_run.get_threads()}")
    return words


def _forget_ranges(grid: Any) -> None:
    """VTK writes the range of vectors' lengths that arrays keep, and cannot read infinity in it."""
    for data in (grid.GetPointData(), grid.GetCellData(), grid.GetFieldData()):
        for k in range(data.GetNumberOfArrays()):
            array = data.GetArray(k)
            if array is not None and not all(map(math.isfinite, array.GetRange(-1))):
                # The writer keeps a range that is there.
                array.GetInformation().Set(vtkDataArray.L2_NORM_RANGE(), (0.0, 1.0), 2)


def _write(grid: Any, file: str) -> None:
    from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridWriter

    writer = vtkXMLUnstructuredGridWriter()
    writer.SetFileName(file)
    data = as_high_order(grid)
    _forget_ranges(data)
    writer.SetInputData(data)
    writer.SetDataModeToBinary()
    writer.SetHeaderTypeToUInt64()
    writer.SetCompressorTypeToNone()
    if writer.Write() != 1:
        raise Error(f"cannot write '{file}'; make room in the folder of temporary files")


def files_of(function: str, grid: Input, folder: str) -> list[str]:
    """The names of the files of an input. A grid is written into the folder."""
    if isinstance(grid, (str, os.PathLike)):
        return [os.fspath(grid)]
    if isinstance(grid, vtkUnstructuredGrid):
        file = os.path.join(folder, "grid.vtu")
        _write(grid, file)
        return [file]
    if isinstance(grid, (list, tuple)):
        return [os.fspath(file) for file in grid]
    raise TypeError(
        f"{function}: a grid is a vtkUnstructuredGrid or names of files, not {type(grid).__name__}"
    )


def text_of_error(stderr: str) -> str:
    return stderr.strip().removeprefix("pixelexact: ")


def run_tool(
    function: str, command: str, grid: Input, words: Sequence[str]
) -> tuple[dict[str, Any], list[str]]:
    """The report of a command (--json), and its notes: what it chose and what it warns of. Raises
    Error with the program's words for what it refuses."""
    tool = find_tool(function)
    with tempfile.TemporaryDirectory(prefix="pixelexact-") as folder:
        files = files_of(function, grid, folder)
        done = subprocess.run(
            [tool, command, *files, *words, "--json"], capture_output=True, text=True, check=False,
            errors="surrogateescape",
        )
    try:
        report: dict[str, Any] = json.loads(done.stdout or "{}")
    except ValueError:
        raise Error(f"{function}: '{tool}' printed no report, but: {done.stdout[:200]}") from None
    if done.returncode != 0:
        said = report.get("error") or text_of_error(done.stderr)
        raise Error(said or f"{function}: the program ended with status {done.returncode}")
    return report, [text_of_error(line) for line in done.stderr.splitlines()]
