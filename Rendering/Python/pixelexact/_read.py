"""Files of solvers and of VTK."""

from __future__ import annotations

import os
import re
from typing import Any, Union

from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline as _Pipeline

from ._work import Error, Progress, run
from .PixelExactDataModel import vtkHighOrderGrid
from .PixelExactFilters import (
    vtkGLVisReader,
    vtkGmshReader,
    vtkHighOrderSeriesReader,
    vtkMFEMReader,
    vtkNektarReader,
    vtkUnstructuredGridToHighOrderGrid,
)

Path = Union[str, "os.PathLike[str]"]

_FIELD_FILES = (".gf", ".fld", ".chk", ".rst")


def _suffix(file: str) -> str:
    """In small letters; of x.mesh.gz that of the mesh, of a piece of a parallel run .mesh."""
    root, suffix = os.path.splitext(file)
    if suffix.lower() == ".gz":
        suffix = os.path.splitext(root)[1]
    return ".mesh" if re.fullmatch(r"\.\d{6,}", suffix) else suffix.lower()


def _alone(mesh: str, fields: list[str]) -> None:
    if fields:
        raise ValueError(f"'{mesh}' holds mesh and fields; name it alone, without '{fields[0]}'")


def _legacy(mesh: str, fields: list[str]) -> Any:
    from vtkmodules.vtkIOLegacy import vtkUnstructuredGridReader

    _alone(mesh, fields)
    reader = vtkUnstructuredGridReader()
    reader.SetFileName(mesh)
    reader.ReadAllScalarsOn()
    reader.ReadAllVectorsOn()
    reader.ReadAllFieldsOn()
    return reader


def _series(mesh: str, fields: list[str]) -> Any:
    reader = vtkHighOrderSeriesReader()
    reader.SetFileName(mesh)
    for step in fields:
        reader.AddFileName(step)
    return reader


def _mfem(mesh: str, fields: list[str]) -> Any:
    reader = vtkMFEMReader()
    reader.SetFileName(mesh)
    for field in fields:
        if _suffix(mesh) == ".mfem_root":
            reader.AddStepFileName(field)
        else:
            reader.AddGridFunctionFileName(field)
    return reader


def _glvis(mesh: str, fields: list[str]) -> Any:
    _alone(mesh, fields)
    reader = vtkGLVisReader()
    reader.SetFileName(mesh)
    return reader


def _gmsh(mesh: str, fields: list[str]) -> Any:
    reader = vtkGmshReader()
    reader.SetFileName(mesh)
    for field in fields:
        reader.AddViewFileName(field)
    return reader


def _nektar(mesh: str, fields: list[str]) -> Any:
    reader = vtkNektarReader()
    reader.SetFileName(mesh)
    for field in fields:
        if _suffix(field) in (".xml", ".nekg"):
            reader.AddSessionFileName(field)
        else:
            reader.AddFieldFileName(field)
    return reader


_READERS = {
    ".vtu": _series,
    ".pvtu": _series,
    ".pvd": _series,
    ".vtk": _legacy,
    ".mesh": _mfem,
    ".mfem_root": _mfem,
    ".saved": _glvis,
    ".msh": _gmsh,
    ".xml": _nektar,
    ".nekg": _nektar,
}


def _reader_of(mesh: Path, fields: tuple[Path, ...]) -> Any:
    names = [os.fsdecode(file) for file in (mesh, *fields)]
    for name in names:
        if not os.path.exists(name):
            raise FileNotFoundError(f"cannot read '{name}': there is no such file")
    suffix = _suffix(names[0])
    if suffix in _FIELD_FILES:
        raise ValueError(
            f"'{names[0]}' holds a field without its mesh; name the mesh file before it "
            "(x.mesh, u.gf; x.xml, u.fld)"
        )
    if suffix not in _READERS:
        raise ValueError(f"cannot read '{names[0]}': suffixes are {', '.join(_READERS)}")
    return _READERS[suffix](names[0], names[1:])


def _times_of(reader: Any) -> list[float]:
    run(reader, information_only=True)
    information = reader.GetOutputInformation(0)
    key = _Pipeline.TIME_STEPS()
    return [key.Get(information, i) for i in range(key.Length(information))]


def times(mesh: Path, *fields: Path) -> list[float]:
    """The times of the steps that files hold, ascending; empty where they have none."""
    return _times_of(_reader_of(mesh, fields))


def _chosen(steps: list[float], time_step: int, mesh: Path) -> float:
    if not -len(steps) <= time_step < len(steps):
        raise IndexError(
            f"time_step {time_step}: '{os.fspath(mesh)}' has {len(steps)} time steps, counted from 0"
        )
    return steps[time_step]


def as_high_order(grid: Any, progress: Progress = None) -> vtkHighOrderGrid:
    """A vtkUnstructuredGrid as one with coefficients: those that it carries, else converted."""
    if not vtkHighOrderGrid.IsHighOrder(grid):
        converter = vtkUnstructuredGridToHighOrderGrid()
        converter.SetInputData(grid)
        run(converter, progress)
        grid = converter.GetOutput()
    if isinstance(grid, vtkHighOrderGrid):
        return grid
    typed = vtkHighOrderGrid()
    typed.ShallowCopy(grid)
    return typed


def read(
    mesh: Path, *fields: Path, time_step: int = 0, progress: Progress = None
) -> vtkHighOrderGrid:
    """Reads a mesh file and, where the format keeps them apart, its field files.

    .vtu, .pvtu, .pvd, .vtk; .mesh with .gf, pieces of parallel runs, .mfem_root (MFEM); .saved
    (GLVis); .xml with .fld, .chk, .rst (Nektar++); .msh (Gmsh). Several .vtu, .mfem_root or fields
    of Nektar++ are time steps.

    time_step: counted from 0, or from the end where it is negative; see times. progress: a function
    of the part that is done; what it raises ends the work, and so does KeyboardInterrupt.

    Raises FileNotFoundError, ValueError for files that do not go together, IndexError for a step
    that is not there, Error with the reader's own words for what it cannot read.
    """
    reader = _reader_of(mesh, fields)
    steps = _times_of(reader)
    if steps:
        reader.GetOutputInformation(0).Set(
            _Pipeline.UPDATE_TIME_STEP(), _chosen(steps, time_step, mesh)
        )
    elif time_step not in (0, -1):
        raise IndexError(f"time_step {time_step}: '{os.fspath(mesh)}' has no time steps")
    run(reader, progress)
    grid = reader.GetOutput()
    if grid is None or grid.GetNumberOfCells() == 0:
        raise Error(f"cannot read '{os.fspath(mesh)}': it holds no cells")
    return as_high_order(grid, progress)
