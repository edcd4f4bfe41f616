"""Expressions of fields that are written as functions in Python."""

from __future__ import annotations

import inspect
import math
from numbers import Real
from typing import Any, Callable, Optional, Union

FieldName = Union[str, Callable[..., Any]]

_OPERATORS = {
    "add": "+",
    "subtract": "-",
    "multiply": "*",
    "divide": "/",
    "true_divide": "/",
    "power": "^",
    "float_power": "^",
    "less": "<",
    "less_equal": "<=",
    "greater": ">",
    "greater_equal": ">=",
    "equal": "==",
    "not_equal": "!=",
    "logical_and": "&&",
    "bitwise_and": "&&",
    "logical_or": "||",
    "bitwise_or": "||",
}
# NumPy's and SciPy's functions, by their names, as patterns of their arguments.
_FUNCTIONS = {
    **{
        name: f"{name}({{}})"
        for name in "sqrt exp log log10 sin cos tan sinh cosh tanh sign floor ceil erf".split()
    },
    "arcsin": "asin({})",
    "arccos": "acos({})",
    "arctan": "atan({})",
    "arctan2": "atan2({}, {})",
    "absolute": "abs({})",
    "fabs": "abs({})",
    "minimum": "min({}, {})",
    "maximum": "max({}, {})",
    "negative": "(-{})",
    "positive": "{}",
    "logical_not": "(!{})",
    "invert": "(!{})",
    "square": "({}^2)",
    "reciprocal": "(1/{})",
    "hypot": "mag(vec({}, {}, 0))",
    "where": "where({}, {}, {})",
    "dot": "dot({}, {})",
    "inner": "dot({}, {})",
    "vdot": "dot({}, {})",
    "cross": "cross({}, {})",
    "outer": "outer({}, {})",
    "norm": "mag({})",
    "trace": "tr({})",
    "det": "det({})",
    "transpose": "transpose({})",
}


def _text_of(value: Any) -> str:
    if isinstance(value, _Symbol):
        return value.text
    if getattr(value, "shape", None) == ():
        value = value.item()
    if isinstance(value, Real):
        if not math.isfinite(value):
            raise ValueError(f"{value} is no number of an expression")
        whole = isinstance(value, int) and abs(value) < 2**53
        text = repr(int(value) if whole else float(value))
        return text if value >= 0 else f"({text})"
    if hasattr(value, "__len__") and not isinstance(value, (str, bytes)) and len(value) > 0:
        return f"vec({', '.join(map(_text_of, value))})"
    raise TypeError(f"{value!r} is neither a number nor made of fields")


def _call(name: str, arguments: Any) -> Any:
    texts = [_text_of(argument) for argument in arguments]
    if name in _OPERATORS and len(texts) == 2:
        return _Symbol(f"({texts[0]} {_OPERATORS[name]} {texts[1]})")
    pattern = _FUNCTIONS.get(name, "")
    if len(texts) > 0 and pattern.count("{}") == len(texts):
        return _Symbol(pattern.format(*texts))
    raise TypeError(
        f"expressions of fields have no {name} of {len(texts)} arguments; there are "
        f"{', '.join(sorted(_FUNCTIONS))} and the usual operators"
    )


class _Symbol:
    """What a function is called with: what is done to it becomes text."""

    def __init__(self, text: str) -> None:
        self.text = text

    def __array_ufunc__(self, ufunc: Any, method: str, *inputs: Any, **options: Any) -> Any:
        if method != "__call__" or options:
            raise TypeError(f"expressions of fields have no {ufunc.__name__} with these options")
        return _call(ufunc.__name__, inputs)

    def __array_function__(self, function: Any, _types: Any, inputs: Any, options: Any) -> Any:
        if options:
            raise TypeError(f"expressions of fields have no {function.__name__} with {options}")
        if function.__name__ == "clip":
            low = _call("maximum", inputs[:2])
            return _call("minimum", (low, *inputs[2:]))
        return _call(function.__name__, inputs)

    def __getitem__(self, index: Any) -> "_Symbol":
        # x is a coordinate, and the point where it is indexed.
        of = "coords" if self.text == "x" else self.text
        number = ", ".join(map(str, index if isinstance(index, tuple) else (index,)))
        return _Symbol(f"{of}[{number}]")

    def __iter__(self) -> Any:
        raise TypeError(f"take components of {self.text} one by one: {self.text}[0]")

    def __bool__(self) -> bool:
        raise TypeError(
            "it branches on a field's value, which differs from pixel to pixel: use numpy.where, "
            "numpy.minimum or numpy.maximum in place of if, min or max"
        )

    def __float__(self) -> float:
        raise TypeError("use NumPy's functions in place of math's: numpy.sin(u)")

    def __hash__(self) -> int:
        return hash(self.text)


def _add_operators() -> None:
    pairs = [
        ("add", "add"),
        ("sub", "subtract"),
        ("mul", "multiply"),
        ("truediv", "divide"),
        ("pow", "power"),
        ("and", "logical_and"),
        ("or", "logical_or"),
    ]
    for short, name in pairs:
        setattr(_Symbol, f"__{short}__", lambda a, b, name=name: _call(name, (a, b)))
        setattr(_Symbol, f"__r{short}__", lambda a, b, name=name: _call(name, (b, a)))
    comparisons = [
        ("lt", "less"),
        ("le", "less_equal"),
        ("gt", "greater"),
        ("ge", "greater_equal"),
        ("eq", "equal"),
        ("ne", "not_equal"),
    ]
    for short, name in comparisons:
        setattr(_Symbol, f"__{short}__", lambda a, b, name=name: _call(name, (a, b)))
    for short, name in [("neg", "negative"), ("pos", "positive"), ("abs", "absolute"), ("invert", "logical_not")]:
        setattr(_Symbol, f"__{short}__", lambda a, name=name: _call(name, (a,)))


_add_operators()


def expression_of(field: Optional[FieldName]) -> Optional[str]:
    """A field's name or expression as text; that of a function is what it does to its arguments.

    The function is called once, with symbols for the fields, coordinates and parameters that its
    arguments are named after; those with a default value keep that. Raises TypeError for what is
    no expression: branches, loops until a value is reached, functions of other libraries.
    """
    if field is None or isinstance(field, str):
        return field
    if not callable(field):
        raise TypeError(f"field: a name, an expression as text or a function, not {field!r}")
    names = []
    for parameter in inspect.signature(field).parameters.values():
        if parameter.kind in (parameter.VAR_POSITIONAL, parameter.VAR_KEYWORD):
            raise TypeError("name each argument of the function after a field: lambda u, x: u - x")
        if parameter.default is parameter.empty:
            names.append((parameter.name, parameter.kind == parameter.KEYWORD_ONLY))
    positional = [_Symbol(name) for name, by_name in names if not by_name]
    named = {name: _Symbol(name) for name, by_name in names if by_name}
    return _text_of(field(*positional, **named))
