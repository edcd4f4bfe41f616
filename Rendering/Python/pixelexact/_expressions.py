"""Expressions of fields that are written as functions in Python."""

from __future__ import annotations

import inspect
import math
import operator
import re
from numbers import Real
from typing import Any, Callable, Optional, Union

FieldName = Union[str, Callable[..., Any]]
# The number of indices of what a name stands for; None: it is not known.
RankOf = Callable[[str], Optional[int]]

# As many as the parser of expressions takes.
_MAX_CHARACTERS = 4096
# The precedence of a text's outermost operator: a part of lower precedence gets brackets.
_ATOM, _POWER, _PRODUCT, _SUM = 4, 3, 2, 1
_SUMS = {"add": "+", "subtract": "-"}
_PRODUCTS = {"multiply": "*", "divide": "/", "true_divide": "/"}
_POWERS = {"power": "^", "float_power": "^"}
_COMPARISONS = {
    "less": "<",
    "less_equal": "<=",
    "greater": ">",
    "greater_equal": ">=",
    "equal": "==",
    "not_equal": "!=",
}
_LOGIC = {
    "logical_and": "&&",
    "bitwise_and": "&&",
    "logical_or": "||",
    "bitwise_or": "||",
    "logical_not": "!",
    "invert": "!",
}
# NumPy's and SciPy's functions of one argument or several, by their names, and the language's.
_SAME = "sqrt exp log log10 sin cos tan sinh cosh tanh sign floor ceil erf cross outer where dot det"
_FUNCTIONS = {
    **{name: name for name in [*_SAME.split(), "transpose"]},
    "arcsin": "asin",
    "arccos": "acos",
    "arctan": "atan",
    "arctan2": "atan2",
    "absolute": "abs",
    "fabs": "abs",
    "minimum": "min",
    "maximum": "max",
    "inner": "dot",
    "vdot": "dot",
    "norm": "mag",
    "trace": "tr",
}
_ARGUMENTS = {"arctan2": 2, "minimum": 2, "maximum": 2, "dot": 2, "inner": 2, "vdot": 2, "cross": 2}
_ARGUMENTS |= {"outer": 2, "where": 3}
# Ranks of what functions of the language give, by that of their first argument.
_RANKS: dict[str, Callable[[int], int]] = {
    **dict.fromkeys("dot mag tr det Q lambda2 vonMises".split(), lambda _: 0),
    **dict.fromkeys("cross curl vorticity eig".split(), lambda _: 1),
    **dict.fromkeys("outer hessian strain sym tensor".split(), lambda _: 2),
    "grad": lambda rank: rank + 1,
    "div": lambda rank: max(rank - 1, 0),
}
_CALLABLE = "grad div curl laplacian hessian sym eig tensor vorticity strain Q lambda2 vonMises jump".split()
_NAMED_RANKS = {
    **dict.fromkeys("x y z t time pi element order detJ scaledJacobian".split(), 0),
    **dict.fromkeys("attribute elementSize minDetJ minScaledJacobian".split(), 0),
    **dict.fromkeys("coords xi n normal".split(), 1),
}


def _number(value: Any) -> str:
    try:
        real = float(value)
    except OverflowError:
        real = math.inf
    if not math.isfinite(real):
        raise ValueError(f"a number of an expression is finite, not {value}")
    whole = isinstance(value, int) and abs(value) < 2**53
    text = repr(int(value) if whole else real)
    return f"({text})" if math.copysign(1.0, real) < 0 else text


def _symbol(value: Any) -> "_Symbol":
    if isinstance(value, _Symbol):
        return value
    if hasattr(value, "mask") and hasattr(value, "filled"):
        raise TypeError("arrays with masks are no part of an expression")
    if getattr(value, "shape", None) == ():
        value = value.item()
    if isinstance(value, Real):
        return _Symbol(_number(value), _ATOM, 0, isinstance(value, bool))
    if (isinstance(value, (list, tuple)) or hasattr(value, "__array__")) and len(value) > 0:
        parts = [_symbol(part) for part in value]
        if any(part.rank for part in parts):
            raise TypeError("a list is a vector of numbers; use numpy.outer for a matrix")
        return _Symbol(f"vec({', '.join(part.text for part in parts)})", _ATOM, 1)
    raise TypeError(f"{value!r} is neither a number nor made of fields")


def _highest(parts: list["_Symbol"]) -> Optional[int]:
    ranks = [part.rank for part in parts if part.rank is not None]
    return max(ranks) if len(ranks) == len(parts) else None


def _refuse(what: str) -> None:
    raise TypeError(f"{what}; write it as text, where m*v and m*m are products of matrices")


def _operate(name: str, parts: list["_Symbol"]) -> "_Symbol":
    """An operation on two; brackets keep the order of operations that Python has."""
    a, b = parts
    rank = _highest(parts)
    if name in _SUMS:
        return _Symbol(f"{a.within(_SUM)} {_SUMS[name]} {b.within(_PRODUCT)}", _SUM, rank)
    if name in _PRODUCTS:
        if (a.rank or 0) + (b.rank or 0) > 2:
            _refuse("expressions of fields have no products of matrices entry by entry")
        return _Symbol(f"{a.within(_PRODUCT)}{_PRODUCTS[name]}{b.within(_POWER)}", _PRODUCT, rank)
    if name in _POWERS:
        return _Symbol(f"{a.within(_ATOM)}^{b.within(_ATOM)}", _POWER, rank)
    if name == "matmul" and a.rank == 2 and b.rank in (1, 2):
        return _Symbol(f"{a.within(_PRODUCT)}*{b.within(_POWER)}", _PRODUCT, b.rank)
    if name in _COMPARISONS:
        return _Symbol(f"({a.within(_SUM)} {_COMPARISONS[name]} {b.within(_SUM)})", _ATOM, 0, True)
    return _Symbol(f"({a.within(_ATOM)} {_LOGIC[name]} {b.within(_ATOM)})", _ATOM, 0, True)


def _called(function: str, parts: list["_Symbol"]) -> "_Symbol":
    rank = _highest(parts[-2:] if function == "where" else parts[:1])
    if function in _RANKS and rank is not None:
        rank = _RANKS[function](rank)
    elif function in _RANKS:
        rank = _RANKS[function](0) if function not in ("grad", "div") else None
    return _Symbol(f"{function}({', '.join(part.text for part in parts)})", _ATOM, rank)


def _call(name: str, arguments: Any) -> "_Symbol":
    """What a function of NumPy's makes of its arguments."""
    parts = [_symbol(argument) for argument in arguments]
    if name in _LOGIC and not all(part.is_truth for part in parts):
        raise TypeError(f"{name}: of comparisons alone, such as (u > 0) & (x < 1)")
    if name == "matmul" and all(part.rank == 1 for part in parts):
        name = "dot"
    if name in ("dot", "inner", "vdot") and any((part.rank or 0) > 1 for part in parts):
        _refuse(f"expressions of fields have no {name} of matrices")
    two = name in {**_SUMS, **_PRODUCTS, **_POWERS, **_COMPARISONS, **_LOGIC}
    two = two or (name == "matmul" and parts[0].rank == 2 and parts[1].rank in (1, 2))
    if two and len(parts) == 2:
        return _operate(name, parts)
    if len(parts) == 1 and name in ("negative", "logical_not", "invert"):
        sign = "-" if name == "negative" else "!"
        return _Symbol(f"({sign}{parts[0].within(_ATOM)})", _ATOM, parts[0].rank, sign == "!")
    if len(parts) == 1 and name == "positive":
        return parts[0]
    if len(parts) == 1 and name == "square":
        return _Symbol(f"{parts[0].within(_ATOM)}^2", _POWER, parts[0].rank)
    if len(parts) == 1 and name == "reciprocal":
        return _Symbol(f"1/{parts[0].within(_POWER)}", _PRODUCT, parts[0].rank)
    if len(parts) == 2 and name == "hypot":
        return _called("mag", [_symbol([*parts, 0])])
    if name in _FUNCTIONS and len(parts) == _ARGUMENTS.get(name, 1):
        return _called(_FUNCTIONS[name], parts)
    known = [*_FUNCTIONS, "clip", "hypot", "reciprocal", "square"]
    raise TypeError(
        f"expressions of fields have no {name} of {len(parts)} arguments of these kinds; there are "
        f"{', '.join(sorted(known))} and the usual operators"
    )


class _Symbol:
    """What a function is called with: what is done to it becomes text."""

    def __init__(
        self, text: str, level: int, rank: Optional[int] = None, is_truth: bool = False
    ) -> None:
        if len(text) > _MAX_CHARACTERS:
            raise TypeError(
                f"the expression is longer than {_MAX_CHARACTERS} characters: what a variable holds "
                "is written out each time; name parts with pixelexact.calculate and use these"
            )
        self.text = text
        self.level = level
        self.rank = rank
        self.is_truth = is_truth
        self.indexed = text

    def within(self, level: int) -> str:
        """The text as an operand that needs at least this precedence."""
        return self.text if self.level >= level else f"({self.text})"

    def __array_ufunc__(self, ufunc: Any, method: str, *inputs: Any, **options: Any) -> Any:
        if method != "__call__" or options:
            raise TypeError(f"expressions of fields have no {ufunc.__name__} with these options")
        return _call(ufunc.__name__, inputs)

    def __array_function__(self, function: Any, _types: Any, inputs: Any, options: Any) -> Any:
        if function.__name__ == "clip" and len(inputs) == 3 and not options:
            result = inputs[0]
            for bound, name in [(inputs[1], "maximum"), (inputs[2], "minimum")]:
                if not (bound is None or (isinstance(bound, Real) and math.isinf(bound))):
                    result = _call(name, (result, bound))
            return result
        if options:
            raise TypeError(f"expressions of fields have no {function.__name__} with {options}")
        return _call(function.__name__, inputs)

    def __call__(self, *arguments: Any) -> Any:
        if self.text not in _CALLABLE:
            raise TypeError(f"{self.text} is no function; there are {', '.join(_CALLABLE)}")
        return _called(self.text, [_symbol(argument) for argument in arguments])

    def __getitem__(self, index: Any) -> "_Symbol":
        try:
            numbers = [operator.index(i) for i in (index if isinstance(index, tuple) else [index])]
        except TypeError:
            numbers = []
        if not numbers or min(numbers) < 0 or len(numbers) > 2:
            raise TypeError(f"components have numbers from 0, {self.text}[0] or [0, 1], not {index!r}")
        of = self.indexed if self.level == _ATOM else f"({self.text})"
        rank = None if self.rank is None else max(self.rank - len(numbers), 0)
        return _Symbol(f"{of}[{', '.join(map(str, numbers))}]", _ATOM, rank)

    x = property(lambda self: self[0])
    y = property(lambda self: self[1])
    z = property(lambda self: self[2])
    T = property(lambda self: _call("transpose", (self,)))

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
    binary = {"add": "add", "sub": "subtract", "mul": "multiply", "truediv": "divide"}
    binary |= {"pow": "power", "matmul": "matmul", "mod": "mod", "floordiv": "floor_divide"}
    binary |= {"and": "bitwise_and", "or": "bitwise_or"}
    for short, name in binary.items():
        setattr(_Symbol, f"__{short}__", lambda a, b, name=name: _call(name, (a, b)))
        setattr(_Symbol, f"__r{short}__", lambda a, b, name=name: _call(name, (b, a)))
    comparisons = {"lt": "less", "le": "less_equal", "gt": "greater", "ge": "greater_equal"}
    comparisons |= {"eq": "equal", "ne": "not_equal"}
    for short, name in comparisons.items():
        setattr(_Symbol, f"__{short}__", lambda a, b, name=name: _call(name, (a, b)))
    unary = {"neg": "negative", "pos": "positive", "abs": "absolute", "invert": "invert"}
    for short, name in unary.items():
        setattr(_Symbol, f"__{short}__", lambda a, name=name: _call(name, (a,)))


_add_operators()


def _argument(name: str, rank_of: RankOf) -> _Symbol:
    """A field of the grid goes before what the language means by the name."""
    rank = rank_of(name)
    known = name in _NAMED_RANKS
    is_plain = re.fullmatch(r"[A-Za-z_][A-Za-z_0-9]*", name) is not None
    if rank is None and known:
        symbol = _Symbol(name, _ATOM, _NAMED_RANKS[name])
        symbol.indexed = "coords" if name == "x" else name  # x[0] is a component of the point
        return symbol
    return _Symbol(name if is_plain and not known else f'"{name}"', _ATOM, rank)


def expression_of(field: Optional[FieldName], rank_of: RankOf = lambda _: None) -> Optional[str]:
    """A field's name or expression as text; that of a function is what it does to its arguments.

    The function is called once, with symbols for the fields, coordinates, parameters and functions of
    the language (grad, curl, ...) that its arguments are named after; those with a default value keep
    that. rank_of: the number of indices (0: a scalar) of a field's values; None where there is none.
    Raises TypeError for what is no expression: branches, loops until a value is reached, functions of
    other libraries.
    """
    if field is None or isinstance(field, str):
        return field
    if not callable(field):
        raise TypeError(f"field: a name, an expression as text or a function, not {field!r}")
    try:
        parameters = inspect.signature(field).parameters.values()
    except ValueError:
        raise TypeError(f"the arguments of {field!r} have no names; use lambda u: ...") from None
    names = []
    for parameter in parameters:
        if parameter.kind in (parameter.VAR_POSITIONAL, parameter.VAR_KEYWORD):
            raise TypeError("name each argument of the function after a field: lambda u, x: u - x")
        if parameter.default is parameter.empty:
            names.append((parameter.name, parameter.kind == parameter.KEYWORD_ONLY))
    positional = [_argument(name, rank_of) for name, by_name in names if not by_name]
    named = {name: _argument(name, rank_of) for name, by_name in names if by_name}
    return _symbol(field(*positional, **named)).text
