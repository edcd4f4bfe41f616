"""A picture of a cut in one call."""

from __future__ import annotations

from typing import Any, Optional, Sequence, Union

from ._cut import cut
from ._expressions import FieldName
from ._picture import Picture, picture_of
from ._read import Path
from ._scene import Vector
from ._settings import documented
from ._work import Progress


@documented
def render(
    grid: Any,
    field: Optional[FieldName] = None,
    *,
    output: Optional[Path] = None,
    size: Sequence[int] = (1000, 1000),
    view: Union[str, Vector, None] = None,
    camera: Any = None,
    background: Union[str, Vector, None] = "white",
    buffers: bool = True,
    progress: Progress = None,
    stride: int = 1,
    **options: Any,
) -> Picture:
    """A picture of a cut, traced without a window, a display or OpenGL, and what is known of it.

    grid, field, options: as of cut.
    camera: a vtkCamera, instead of view.
    {settings}

    progress: a function of the part that is done; what it raises, and KeyboardInterrupt, end the
    work. Other threads of Python run meanwhile, unless the surface is a function of Python.
    """
    of = cut(grid, field, **options)
    picture = picture_of(of, size, view, camera, background, buffers, progress, stride)
    if output is not None:
        picture.save(output)
    return picture
