"""Files of solvers and of VTK."""

from __future__ import annotations

import os
import sys
import warnings
from typing import Any, Optional, Sequence, Union

from . import _run
from ._docstrings import with_texts
from ._format_rows import FORMATS
from ._work import Error, Progress, run
from .PixelExactDataModel import vtkHighOrderGrid
from .PixelExactFilters import vtkUnstructuredGridToHighOrderGrid

Path = Union[str, "os.PathLike[str]"]
Warp = Union[str, tuple[str, float], None]


def _names(mesh: Path, fields: tuple[Path, ...]) -> list[str]:
    names = [os.fsdecode(file) for file in (mesh, *fields)]
    for name in names:
        if not os.path.exists(name):
            raise FileNotFoundError(f"cannot read '{name}': there is no such file")
    return names


def _times_of(names: list[str]) -> list[float]:
    try:
        return _run.times(names)
    except _run.CannotRead as error:
        raise Error(str(error)) from None


def times(mesh: Path, *fields: Path) -> list[float]:
    """The times of the steps that files hold, ascending; empty where they have none."""
    return _times_of(_names(mesh, fields))


def _chosen(steps: list[float], time_step: int, mesh: Path) -> int:
    """Counted from 0."""
    if not steps and time_step in (0, -1):
        return 0
    if not -len(steps) <= time_step < len(steps):
        count = f"{len(steps)} time steps, counted from 0" if steps else "no time steps"
        raise IndexError(f"time_step {time_step}: '{os.fspath(mesh)}' has {count}")
    return time_step % len(steps)


def as_high_order(grid: Any, progress: Progress = None, surface_elements: bool = False) -> vtkHighOrderGrid:
    """A vtkUnstructuredGrid as one with coefficients that fit: those that it carries, else converted."""
    if not vtkUnstructuredGridToHighOrderGrid.IsConverted(grid):
        converter = vtkUnstructuredGridToHighOrderGrid()
        converter.SetSurfaceElements(surface_elements)
        converter.SetInputData(grid)
        run(converter, progress)
        grid = converter.GetOutput()
    if isinstance(grid, vtkHighOrderGrid):
        return grid
    typed = vtkHighOrderGrid()
    typed.ShallowCopy(grid)
    return typed


@with_texts("{formats}", FORMATS)
def read(
    mesh: Path,
    *fields: Path,
    time_step: int = 0,
    cells: str = "lagrange",
    surface_elements: bool = False,
    warp: Warp = None,
    warp_direction: Optional[Sequence[float]] = None,
    progress: Progress = None,
) -> vtkHighOrderGrid:
    """Reads a mesh file and, where the format keeps them apart, its field files.

    All that the program reads, by the same function; suffixes of meshes, and of their field files:

    {formats}

    What looks wrong in a file is a RuntimeWarning.

    time_step: counted from 0, or from the end where it is negative; see times. cells: which of VTK's
    cells the grid of a solver's own file has beside its coefficients, "lagrange" or "corners"
    (vtkHighOrderFileReader.SetCells); "corners" takes the least memory. surface_elements: of a file
    that mixes solids with triangles and quadrilaterals, read these in place of the solids. warp, warp_direction: as of
    cut; the grid is deformed. progress: a function of the part that is done; what it raises ends the
    work, and so does KeyboardInterrupt.

    Raises FileNotFoundError, ValueError for files that do not go together and for other cells,
    IndexError for a step that is not there, Error with the reader's own words for what it cannot
    read.
    """
    if cells not in ("lagrange", "corners"):
        raise ValueError(f"cells {cells!r}: must be 'lagrange' or 'corners'")
    names = _names(mesh, fields)
    steps = _times_of(names)
    step = _chosen(steps, time_step, mesh)
    try:
        grid, notes = _run.read(names, step, cells == "corners", surface_elements, progress)
    except _run.CannotRead as error:
        raise Error(str(error)) from None
    for note in notes:
        warnings.warn(note, RuntimeWarning, stacklevel=2)
    if grid.GetNumberOfCells() == 0:
        raise Error(f"cannot read '{os.fspath(mesh)}': it holds no cells")
    typed = as_high_order(grid, progress, surface_elements)
    if steps:
        typed.GetInformation().Set(typed.DATA_TIME_STEP(), steps[step])
    from ._warp import warped  # which imports this module

    return warped(typed, warp, warp_direction, progress)


def show_in_notebooks() -> None:
    """Makes IPython and Jupyter display a grid as print does: its own text is an address, and types
    of VTK 9.1 accept no other."""
    shell = getattr(sys.modules.get("IPython"), "get_ipython", lambda: None)()
    if shell is not None:
        shell.display_formatter.formatters["text/plain"].for_type(
            vtkHighOrderGrid, lambda grid, printer, _cycle: printer.text(str(grid).strip())
        )
