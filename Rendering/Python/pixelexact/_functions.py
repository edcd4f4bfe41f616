"""Implicit functions that are written in Python."""

from __future__ import annotations

import _thread
import threading
from typing import Any, Callable, Optional

from .PixelExactDataModel import vtkImplicitCallback

# Until the picture that is being made has failed and the interpreter is back in the program.
_SECONDS_UNTIL_INTERRUPT = 0.05


def _interrupt_soon() -> None:
    timer = threading.Timer(_SECONDS_UNTIL_INTERRUPT, _thread.interrupt_main)
    timer.daemon = True
    timer.start()


def _observer(function: Callable[[Any], Any], answers: str) -> Callable[[Any, str], None]:
    """An observer that hands points to a function and takes its answers to an array."""
    import numpy
    from vtkmodules.util.numpy_support import vtk_to_numpy

    def observe(caller: Any, _event: str) -> None:
        try:
            points = numpy.array(vtk_to_numpy(caller.GetPoints()))
            room = vtk_to_numpy(getattr(caller, answers)())
            given = numpy.asarray(function(points))
            if given.shape != room.shape:
                raise ValueError(f"shape {given.shape} was returned, not {room.shape}")
            if given.dtype.kind not in "fiub":
                raise TypeError(f"{given.dtype} was returned, not real numbers")
            room[...] = given
        except BaseException as error:  # VTK would end the program, or go on.
            caller.SetFailure(f"{type(error).__name__}: {error}".rstrip(": "))
            if isinstance(error, KeyboardInterrupt):
                _interrupt_soon()

    return observe


def implicit_function(
    function: Callable[[Any], Any], gradient: Optional[Callable[[Any], Any]] = None
) -> vtkImplicitCallback:
    """A vtkImplicitFunction of a Python function: the surface is where it is 0.

    function: takes points, an array of shape (n, 3), and returns n finite real numbers.
    gradient: takes the same and returns their gradients, of shape (n, 3); without it central
        differences are taken over 6e-6 of the size of the mesh (vtkHighOrderMapper) or over
        SetDifferenceStep (others).

    The points are a copy of the caller's; there are up to some 16,000 of them. As with any function
    without a closed form, thin sheets may be overlooked: vtkHighOrderMapper.SetSearchSamples. The
    interpreter runs one thread at a time, so frames are traced on one core. What the function closes
    over may change: call Modified() of what is returned.

    If the function raises an exception, returns another shape or a number that is not finite, the
    picture lacks the cut, and the mapper's error states the reason. KeyboardInterrupt is raised
    again soon after the picture was aborted. Only the caller's thread can call the function.
    """
    callback = vtkImplicitCallback()
    callback.AddObserver(vtkImplicitCallback.EvaluateEvent, _observer(function, "GetValues"))
    if gradient is not None:
        callback.AddObserver(vtkImplicitCallback.GradientEvent, _observer(gradient, "GetGradients"))
    return callback
