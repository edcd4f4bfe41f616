"""Pictures without a window, and what is known of their pixels."""

from __future__ import annotations

import copy
import errno
import operator
import os
from typing import TYPE_CHECKING, Any, Iterator, Optional, Sequence, Union

from vtkmodules.vtkCommonDataModel import vtkPlane
from vtkmodules.vtkRenderingCore import vtkCamera

from ._pickling import camera_of_state, image_of_state, state_of_camera, state_of_image
from ._read import Path
from ._scene import Vector, asks_python, normal_of
from ._settings import check
from ._work import Error, Progress, run
from .PixelExactRendering import vtkHighOrderPicture

if TYPE_CHECKING:
    import numpy

    Array = numpy.ndarray[Any, Any]

_MOST_PIXELS = 2**30
_COLORS = {"white": (1.0, 1.0, 1.0), "black": (0.0, 0.0, 0.0)}


class Cut:
    """A cut through a field, to be added to a vtkRenderer or a pyvista.Plotter.

    actor, scalar_bar, mapper (a vtkHighOrderMapper: all else is set there), surface. It may be
    unpacked: actor, scalar_bar = pixelexact.cut(...). In notebooks it shows as a picture. It is not
    pickled, nor copied with what it holds: pickle the Picture that render gives.
    """

    def __init__(self, actor: Any, scalar_bar: Any, mapper: Any, surface: Any) -> None:
        self.actor = actor
        self.scalar_bar = scalar_bar
        self.mapper = mapper
        self.surface = surface

    def __repr__(self) -> str:
        return f"<Cut of {self.scalar_bar.GetTitle()!r} by {self.surface.GetClassName()}>"

    def __iter__(self) -> Iterator[Any]:
        return iter((self.actor, self.scalar_bar))

    def __copy__(self) -> Cut:
        return Cut(self.actor, self.scalar_bar, self.mapper, self.surface)

    def __deepcopy__(self, _memo: Any) -> Cut:
        raise TypeError(
            "a Cut cannot be copied with what it holds, VTK's actor and mapper: call pixelexact.cut "
            "again, or copy the picture that its render gives"
        )

    def __reduce__(self) -> Any:
        raise TypeError(
            "a Cut cannot be pickled, for it holds VTK's actor and mapper: pickle the arguments of "
            "pixelexact.cut, or the picture that its render gives"
        )

    def render(self, **view: Any) -> Picture:
        """A Picture of it; see render for size, camera and the rest of a view."""
        return picture_of(self, **view)

    def _repr_png_(self) -> bytes:
        return self.render(size=(600, 600))._repr_png_()


class Picture:
    """Pixels of a cut, and what is known of each. Rows are from the top, as in other images.

    image: RGBA, uint8, (height, width, 4). values: of the component that is shown, NaN where there
    is none. verdicts: 0 nothing, 1 exact, 2 unknown. elements: cells of the source, -1 none.
    positions, normals, xi: (height, width, 3). contours: 0 none, 1 a contour goes through the pixel,
    2 undecided; None where there are none. contour_values: of these, ascending. range: of the
    colours. cut: what it is of.

    Arrays are views of VTK's and not copies. It may be copied; and pickled, without its cut.
    """

    def __init__(self, image: Array, data: Any, of: Cut, camera: Any) -> None:
        self.image = image
        self.camera = camera
        self.range = tuple(of.mapper.GetScalarRange())
        self.contour_values = sorted(of.mapper.GetContourValues() or ())
        self._cut: Optional[Cut] = of
        self._of = repr(of)
        self._data = data

    @property
    def cut(self) -> Cut:
        """What it is of. Error: the picture was unpickled, and cuts are not pickled."""
        if self._cut is None:
            raise Error(
                f"this picture was pickled, and {self._of} was not: call pixelexact.cut again"
            )
        return self._cut

    def __getstate__(self) -> dict[str, Any]:
        state = {name: value for name, value in self.__dict__.items() if name != "_cut"}
        state["camera"] = state_of_camera(self.camera)
        state["_data"] = state_of_image(self._data)
        return state

    def __setstate__(self, state: dict[str, Any]) -> None:
        self.__dict__.update(state)
        self.camera = camera_of_state(state["camera"])
        self._data = image_of_state(state["_data"])
        self._cut = None

    def __copy__(self) -> Picture:
        other = Picture.__new__(Picture)
        other.__dict__.update(self.__dict__)
        return other

    def __deepcopy__(self, memo: Any) -> Picture:
        other = Picture.__new__(Picture)
        memo[id(self)] = other
        other.__setstate__(copy.deepcopy(self.__getstate__(), memo))
        other._cut = self._cut
        return other

    def __repr__(self) -> str:
        width, height, _ = self._data.GetDimensions()
        none, exact, unknown = (int((self.verdicts == verdict).sum()) for verdict in range(3))
        return (
            f"<Picture of {self._of}, {width} x {height}: {exact} pixels exact, {none} nothing, "
            f"{unknown} unknown>"
        )

    def array(self, name: str) -> Array:
        """One of the arrays of vtkHighOrderMapper.GetBuffers; KeyError, which lists them."""
        from vtkmodules.util.numpy_support import vtk_to_numpy

        points = self._data.GetPointData()
        found = points.GetArray(name)
        if found is None:
            names = [points.GetArrayName(i) for i in range(points.GetNumberOfArrays())]
            raise KeyError(f"no array '{name}'; there are: {', '.join(names)}")
        width, height, _ = self._data.GetDimensions()
        numbers = vtk_to_numpy(found)
        rows: Array = numbers.reshape((height, width) + numbers.shape[1:])[::-1]
        return rows

    @property
    def values(self) -> Array:
        return self.array("Value")

    @property
    def verdicts(self) -> Array:
        return self.array("Verdict")

    @property
    def elements(self) -> Array:
        return self.array("Element")

    @property
    def positions(self) -> Array:
        return self.array("Position")

    @property
    def normals(self) -> Array:
        return self.array("Normal")

    @property
    def xi(self) -> Array:
        return self.array("Xi")

    @property
    def contours(self) -> Optional[Array]:
        return self.array("Contour") if self._data.GetPointData().HasArray("Contour") else None

    def __array__(self, dtype: Any = None, copy: Any = None) -> Array:
        return self.image if dtype is None else self.image.astype(dtype)

    def _png_writer(self) -> Any:
        from vtkmodules.vtkIOImage import vtkPNGWriter

        writer = vtkPNGWriter()
        writer.SetInputData(_to_vtk(self.image))
        return writer

    def save(self, file: Path) -> None:
        """Writes the picture (.png), or all that is known of its pixels (.vti); OSError: it could not."""
        name = os.fspath(file)
        suffix = os.path.splitext(name)[1].lower()
        if suffix == ".png":
            content = self._repr_png_()
        elif suffix == ".vti":
            from vtkmodules.vtkIOXML import vtkXMLImageDataWriter

            writer = vtkXMLImageDataWriter()
            writer.SetInputData(self._data)
            writer.WriteToOutputStringOn()
            writer.Write()
            content = writer.GetOutputString().encode()
        else:
            raise ValueError(f"save: .png or .vti, not '{name}'")
        # VTK's writers do not say why a file cannot be written.
        try:
            with open(name, "wb") as written:
                written.write(content)
        except OSError as error:
            if os.path.isfile(name) and not os.path.islink(name):
                os.remove(name)  # a part of a file would be taken for the whole
            full = error.errno in (errno.ENOSPC, errno.EDQUOT, errno.EFBIG)
            remedy = "; make room, or name another place" if full else ""
            raise OSError(error.errno, f"cannot write '{name}': {error.strerror}{remedy}") from error

    def _repr_png_(self) -> bytes:
        writer = self._png_writer()
        writer.WriteToMemoryOn()
        writer.Write()
        return bytes(writer.GetResult())


def _to_vtk(image: Array) -> Any:
    import numpy
    from vtkmodules.util.numpy_support import numpy_to_vtk
    from vtkmodules.vtkCommonDataModel import vtkImageData

    height, width, channels = image.shape
    data = vtkImageData()
    data.SetDimensions(width, height, 1)
    pixels = numpy.ascontiguousarray(image[::-1]).reshape(-1, channels)
    data.GetPointData().SetScalars(numpy_to_vtk(pixels, deep=True))
    return data


def _over(image: Array, background: Union[str, Vector, None]) -> Array:
    """Straight alpha over a colour."""
    import numpy

    if background is None:
        return image
    if isinstance(background, str):
        if background not in _COLORS:
            raise ValueError(
                f"background: 'white', 'black', (r, g, b) from 0 to 1, or None, not {background!r}"
            )
        background = _COLORS[background]
    color = numpy.asarray(background, dtype=float)
    if color.shape != (3,) or not ((color >= 0) & (color <= 1)).all():
        raise ValueError(f"background: three numbers from 0 to 1, not {background!r}")
    whole = image.copy()
    clear = whole[..., 3] != 255
    alpha = whole[clear][:, 3:] / 255.0
    mixed = alpha * whole[clear][:, :3] + (1.0 - alpha) * 255.0 * color
    whole[clear] = numpy.concatenate(
        [numpy.rint(mixed), numpy.full((len(mixed), 1), 255.0)], axis=1
    ).astype(numpy.uint8)
    return whole


def _place(picture: Any, of: Cut, view: Union[str, Vector, None]) -> None:
    if view is None and not isinstance(of.surface, vtkPlane):
        view = "iso"
    if view is None:
        normal = of.surface.GetNormal()
        # A plane across y is seen from below y, so that x points to the right.
        is_along_y = normal[0] == 0.0 and normal[1] > 0.0 and normal[2] == 0.0
        picture.ViewAlong([-part for part in normal] if is_along_y else normal)
    elif isinstance(view, str) and view == "iso":
        picture.ViewAlong((1.0, 1.0, 1.0))
    else:
        picture.ViewAlong(normal_of(view, "view: 'iso', or"))


def _pixels_of(size: Sequence[int]) -> list[int]:
    try:
        pixels = [operator.index(part) for part in size]
    except TypeError:
        raise TypeError(f"size: two whole numbers, pixels across and up, not {size!r}") from None
    if len(pixels) != 2 or min(pixels) < 1 or pixels[0] * pixels[1] > _MOST_PIXELS:
        raise ValueError(f"size: pixels across and up, at most 2^30 of them, not {size!r}")
    return pixels


def _trace(
    of: Cut,
    size: Sequence[int],
    view: Union[str, Vector, None],
    camera: Any,
    buffers: bool,
    progress: Progress,
    stride: int = 1,
) -> Any:
    check(stride=stride)
    width, height = _pixels_of(size)
    if camera is not None and view is not None:
        raise ValueError("view and camera are two ways to say the same: leave one out")
    if camera is not None and not isinstance(camera, vtkCamera):
        raise TypeError(f"camera: a vtkCamera, not {type(camera).__name__}")
    picture = vtkHighOrderPicture()
    picture.SetActor(of.actor)
    picture.SetSize(width, height)
    picture.SetAllBuffers(buffers)
    picture.SetStride(stride)
    picture.SetCamera(camera)
    if camera is None:
        _place(picture, of, view)
    run(picture, progress, may_release=not asks_python(of.surface))
    return picture


def picture_of(
    of: Cut,
    size: Sequence[int] = (1000, 1000),
    view: Union[str, Vector, None] = None,
    camera: Any = None,
    background: Union[str, Vector, None] = "white",
    buffers: bool = True,
    progress: Progress = None,
    stride: int = 1,
) -> Picture:
    """See render."""
    from vtkmodules.util.numpy_support import vtk_to_numpy

    picture = _trace(of, size, view, camera, buffers, progress, stride)
    data = picture.GetOutput()
    colors = data.GetPointData().GetArray("Color")
    if colors is None:
        raise Error("the picture was given up")
    width, height, _ = data.GetDimensions()
    image = vtk_to_numpy(colors).reshape(height, width, 4)[::-1]
    return Picture(_over(image, background), data, of, picture.GetCamera())
