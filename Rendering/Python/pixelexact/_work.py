"""Long work: progress, interruption, errors as exceptions."""

from __future__ import annotations

import re
import warnings
from contextlib import contextmanager
from typing import Any, Callable, Iterable, Iterator, Optional

from . import _run

Progress = Optional[Callable[[float], object]]

# "ERROR: In FILE, line N\nvtkClass (0x...): text\n\n"
_PREFIX = re.compile(r"\A(?:\w+: In .*, line \d+\n)?(?:\w+ \((?:0x)?[0-9a-fA-F]+\): )?")


class Error(RuntimeError):
    """The work could not be done; the text names what is wrong and the remedy."""


def _plain(text: str) -> str:
    return _PREFIX.sub("", text.strip()).strip()


@contextmanager
def errors_of(speakers: Iterable[Any], before: str) -> Iterator[list[str]]:
    """What objects of VTK's complain of meanwhile, which is not printed; less `before`."""
    errors: list[str] = []

    def listen(_caller: Any, _event: str, text: str) -> None:
        errors.append(_plain(text).removeprefix(before))

    listen.CallDataType = "string0"  # type: ignore[attr-defined]
    heard = [(speaker, speaker.AddObserver("ErrorEvent", listen)) for speaker in speakers]
    try:
        yield errors
    finally:
        for speaker, tag in heard:
            speaker.RemoveObserver(tag)


def run(algorithm: Any, progress: Progress = None, *, may_release: bool = True) -> None:
    """Updates a VTK algorithm. Raises Error with its first error; its warnings are Python's.

    Other threads of the interpreter run meanwhile, unless may_release is false or somebody observes
    the algorithm or vtkOutputWindow. What progress raises, and KeyboardInterrupt, end the work.
    """
    errors, notes = _run.update(algorithm, progress, may_release)
    for note in notes:
        warnings.warn(_plain(note), RuntimeWarning, stacklevel=3)
    if errors:
        raise Error(_plain(errors[0]))


def set_threads(count: Optional[int] = None) -> None:
    """How many threads work at once, from 1, in all that is computed from now on; None: all.

    Results do not depend on it.
    """
    if count is None:
        _run.set_threads(0)
        return
    if not hasattr(count, "__index__"):
        raise TypeError(f"set_threads: a whole number or None, not {count!r}")
    if count < 1:
        raise ValueError(f"set_threads: there must be at least one thread, not {count}")
    _run.set_threads(count)
