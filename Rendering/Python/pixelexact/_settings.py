"""Keywords that are rows of the table of settings: their checks and their texts."""

from __future__ import annotations

import inspect
import operator
from typing import Any, Callable, TypeVar

from ._docstrings import with_texts
from ._scene import numbers_of
from ._setting_rows import ROWS

_Function = TypeVar("_Function", bound=Callable[..., Any])


def _is_flag(value: Any) -> bool:
    return not hasattr(value, "__len__") and value in (True, False)


def _number_of(keyword: str, kind: str, value: Any) -> float:
    if kind == "integer":
        return operator.index(value)
    return numbers_of(value, keyword)[0]


def _refuse(error: type[Exception], keyword: str, value: Any) -> Exception:
    expected = ROWS[keyword]["expected"]
    return error(f"{keyword}: expected {expected}, got {value!r}")


def check(**settings: Any) -> None:
    """Raises TypeError or ValueError for flags, choices and numbers that the table does not allow,
    in the words of the command-line tool."""
    for keyword, value in settings.items():
        row = ROWS[keyword]
        if row["type"] == "flag":
            if not _is_flag(value):
                raise _refuse(TypeError, keyword, value)
        elif row["type"] == "choice":
            if value not in row["choices"]:
                raise _refuse(ValueError, keyword, value)
        else:
            try:
                number = _number_of(keyword, row["type"], value)
            except TypeError:
                raise _refuse(TypeError, keyword, value) from None
            if not row["limits"][0] <= number <= row["limits"][1]:
                raise _refuse(ValueError, keyword, value)


def documented(function: _Function) -> _Function:
    """Puts the table's texts of the function's keywords in place of {settings} in its docstring."""
    texts = [
        f"{keyword}: {ROWS[keyword]['help']}"
        for keyword in inspect.signature(function).parameters
        if keyword in ROWS
    ]
    return with_texts("{settings}", texts)(function)
