"""Fields that are expressions of others."""

from __future__ import annotations

import math
from typing import Any

from ._cut import rank_in
from ._expressions import FieldName, expression_of
from ._read import as_high_order
from ._scene import source_of
from ._work import Progress, run
from .PixelExactDataModel import vtkHighOrderGrid
from .PixelExactFilters import vtkHighOrderCalculator


def calculate(
    grid: Any, *, progress: Progress = None, point_values: bool = True, **fields: FieldName
) -> vtkHighOrderGrid:
    """A grid with new fields that are expressions of its own: Q="Q(velocity)", e="u - sin(pi*x)".

    Expressions are evaluated exactly wherever a value is asked for; they go with the grid as text.
    One may name those before it. Wherever a field's name is taken, an expression itself is, too.

    A function in place of text is called once, with symbols for what its arguments are named after:
    error=lambda u, x, y: u - numpy.sin(x) * numpy.cos(y). What it does to them, with operators and
    NumPy's functions, is the expression; branches and other libraries' functions are refused.

    grid: as of cut; it stays as it is. point_values: whether the new fields are also arrays at the
    points, for filters of VTK. Raises Error for what is no expression, with its place in the text.
    """
    if not fields:
        raise TypeError('calculate: name a field, such as speed="mag(velocity)"')
    source = source_of(grid, progress)
    for name, expression in fields.items():
        text = expression_of(expression, lambda of, grid=source: rank_in(grid, of))
        if text is None:
            raise TypeError(f"{name}: an expression as text, or a function, not None")
        calculator = vtkHighOrderCalculator()
        calculator.SetInputData(source)
        calculator.SetResultArrayName(name)
        calculator.SetFunction(text)
        calculator.SetPointValues(point_values)
        run(calculator, progress)
        result = calculator.GetOutputDataObject(0)
        source = result if result.IsA("vtkCompositeDataSet") else as_high_order(result)
    return source


def at_phase(grid: Any, degrees: float) -> vtkHighOrderGrid:
    """A grid whose complex fields have a real part NAME at a phase, as fields that are expressions.

    A complex field is a pair NAME_real and NAME_imag, as MFEM's complex grid functions are read. NAME
    is NAME_real cos(degrees) - NAME_imag sin(degrees); one of an earlier call is replaced. grid: as
    of cut; it stays as it is. Raises ValueError where it has no complex field.
    """
    if not math.isfinite(degrees):
        raise ValueError(f"degrees: a finite number, not {degrees!r}")
    source = source_of(grid)
    turned = vtkHighOrderGrid()
    turned.ShallowCopy(source)
    if vtkHighOrderCalculator.DefinePhase(turned, degrees) == 0:
        raise ValueError("the grid has no complex field, which is a pair NAME_real and NAME_imag")
    return turned
