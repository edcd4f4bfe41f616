"""Docstrings that are completed from generated tables."""

from __future__ import annotations

import textwrap
from typing import Any, Callable, Iterable, TypeVar

_Function = TypeVar("_Function", bound=Callable[..., Any])


def with_texts(place: str, texts: Iterable[str]) -> Callable[[_Function], _Function]:
    """A decorator that puts texts, each from a line of its own, in place of the line `place` of the
    docstring."""
    lines = [
        textwrap.fill(text, 100, initial_indent=" " * 4, subsequent_indent=" " * 8)
        for text in texts
    ]

    def complete(function: _Function) -> _Function:
        if function.__doc__ is not None:  # python -OO drops docstrings
            function.__doc__ = function.__doc__.replace(f"    {place}\n", "\n".join(lines) + "\n")
        return function

    return complete
