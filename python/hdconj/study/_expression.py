# SPDX-License-Identifier: GPL-3.0-or-later
"""Expressions of a study: arithmetic over names, read through ``ast`` and never run as Python."""

from __future__ import annotations

import ast
import keyword
import math
import operator
import re
import sys
import unicodedata
from collections.abc import Callable, Iterator, Mapping
from itertools import product
from typing import Any

LONGEST = 1000  # characters
DEEPEST = 100  # operations in each other's operands
MOST_CORNERS = 6  # names with errors that change together
_BINARY: dict[type, Callable[[Any, Any], Any]] = {
    ast.Add: operator.add,
    ast.Sub: operator.sub,
    ast.Mult: operator.mul,
    ast.Div: operator.truediv,
    ast.FloorDiv: operator.floordiv,
    ast.Mod: operator.mod,
    ast.Pow: lambda base, power: math.pow(base, power),
}
_UNARY: dict[type, Callable[[Any], Any]] = {ast.UAdd: operator.pos, ast.USub: operator.neg}
_FUNCTIONS: dict[str, Callable[..., Any]] = {
    **{name: getattr(math, name) for name in ("sqrt", "exp", "log", "sin", "cos", "tan", "asin", "acos", "atan")},
    **{"degrees": math.degrees, "radians": math.radians, "hypot": math.hypot},
    **{"abs": abs, "min": min, "max": max, "round": round, "floor": math.floor, "ceil": math.ceil},
}
# How many arguments a function takes at least and at most, where that is not one.
_ARGUMENTS = {
    **dict.fromkeys(("log", "round"), (1, 2, "one argument or two")),
    **dict.fromkeys(("min", "max"), (2, LONGEST, "two arguments or more")),
    "hypot": (1, LONGEST, "one argument or more"),
}
_CONSTANTS = {"pi": math.pi}
# What an expression raises that has no value: outside a function's domain, over a word, over a name without a value.
NO_VALUE = (ArithmeticError, ValueError, TypeError, KeyError)


class Expression:
    """Numbers, names with dots, ``+ - * / // % **``, parentheses and a few functions.

    Parameters
    ----------
    text : str
        Such as ``"25 + 0.5 * flexspline.wall"``.

    Raises
    ------
    ValueError
        The text is something else; the message says what, and a second argument what to write where that is known.
    """

    __slots__ = ("text", "names", "_tree", "_divisors")

    def __init__(self, text: str) -> None:
        if len(text) > LONGEST:
            raise ValueError(f"longer than {LONGEST} characters")
        if "^" in text:
            raise ValueError("^ is no operation", "write " + re.sub(r" *\^ *", " ** ", text))
        try:
            tree = ast.parse(text.strip(), mode="eval").body
        except (SyntaxError, ValueError, RecursionError, MemoryError) as error:
            raise ValueError(f"no expression: {getattr(error, 'msg', error)}") from None
        if _is_deep(tree):
            raise ValueError(f"more than {DEEPEST} operations in each other")
        names: dict[str, None] = {}
        _check(tree, names)
        self.text, self.names, self._tree = text, tuple(names), tree
        self._divisors = tuple(factor for node in ast.walk(tree) for factor in _divisors(node))

    def __call__(self, values: Mapping[str, Any]) -> Any:
        """The value; raises one of :data:`NO_VALUE` where there is none."""
        return _value(self._tree, values)

    def with_error(self, values: Mapping[str, Any], errors: Mapping[str, float]) -> tuple[float, float]:
        """The value and what the errors of all names may change; not a number where that is not determined.

        Up to :data:`MOST_CORNERS` names change together, each to both of its ends; of more names each changes alone,
        and what they change is added. The error is not determined where that of a name is unknown, where an end has
        no value, and where a divisor changes its sign between the ends.
        """
        value = float(self(values))
        if self.text.strip() in errors:  # the figure itself, to the last bit
            return value, errors[self.text.strip()]
        ends = {n: (values[n] - errors[n], values[n] + errors[n]) for n in self.names if errors.get(n, 0.0) != 0}
        if any(math.isnan(errors[name]) for name in ends):
            return value, math.nan
        if len(ends) <= MOST_CORNERS:
            return value, self._change(value, values, [dict(zip(ends, corner)) for corner in product(*ends.values())])
        alone = ([{name: end} for end in pair] for name, pair in ends.items())
        return value, sum((self._change(value, values, changes) for changes in alone), 0.0)

    def _change(self, value: float, values: Mapping[str, Any], changes: list[dict[str, float]]) -> float:
        """The largest of some changes; not a number where one has no value or a divisor changes its sign."""
        largest = 0.0
        signs = [_sign(node, values) for node in self._divisors]
        try:
            for change in changes:
                changed = {**values, **change}
                if [_sign(node, changed) for node in self._divisors] != signs:
                    return math.nan
                difference = abs(float(self(changed)) - value)
                if not math.isfinite(difference):
                    return math.nan
                largest = max(largest, difference)
        except NO_VALUE:
            return math.nan
        return largest

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Expression) and other.text == self.text

    def __hash__(self) -> int:
        return hash(self.text)

    def __reduce__(self) -> tuple[Any, ...]:
        return Expression, (self.text,)


def as_name(word: str) -> str:
    """A name like a word that an expression reads as itself: the word where it is one."""
    name = re.sub(r"\W", "_", unicodedata.normalize("NFKC", word))
    if name[:1].isdigit():
        name = f"n{name}"
    taken = keyword.iskeyword(name) or name in _CONSTANTS or name in _FUNCTIONS
    return f"{name}_1" if taken else name


def _name(node: ast.AST) -> str | None:
    """A name with dots, or None."""
    if isinstance(node, ast.Name):
        return node.id
    if isinstance(node, ast.Attribute):
        before = _name(node.value)
        return None if before is None else f"{before}.{node.attr}"
    return None


def _is_deep(tree: ast.AST) -> bool:
    """Whether a tree is too deep for functions that call themselves."""
    level = [tree]
    for _ in range(DEEPEST):
        level = [inner for node in level for inner in ast.iter_child_nodes(node) if isinstance(inner, ast.expr)]
    return bool(level)


def _check(node: ast.AST, names: dict[str, None]) -> None:
    """Refuses all but arithmetic, and collects the names."""
    name = _name(node)
    if name is not None:
        if name not in _CONSTANTS:
            names[name] = None
    elif isinstance(node, ast.Constant) and isinstance(node.value, (int, float)) and not isinstance(node.value, bool):
        if not abs(node.value) <= sys.float_info.max:
            raise ValueError("a number that is not finite")
    elif isinstance(node, ast.BinOp) and type(node.op) in _BINARY:
        _check(node.left, names)
        _check(node.right, names)
    elif isinstance(node, ast.UnaryOp) and type(node.op) in _UNARY:
        _check(node.operand, names)
    elif isinstance(node, ast.Call) and not node.keywords:
        if _name(node.func) not in _FUNCTIONS:
            raise ValueError(f"unknown function {ast.unparse(node.func)!r}; known: {', '.join(_FUNCTIONS)}")
        _check_count(str(_name(node.func)), len(node.args))
        for argument in node.args:
            _check(argument, names)
    else:
        raise ValueError(f"{ast.unparse(node)!r} is no arithmetic")


def _check_count(function: str, count: int) -> None:
    """Refuses a function with another number of arguments than it takes."""
    least, most, words = _ARGUMENTS.get(function, (1, 1, "one argument"))
    if not least <= count <= most:
        raise ValueError(f"{function} takes {words}, not {count}", f"write {function}({'x, y' if most > 1 else 'x'})")


def _divisors(node: ast.AST) -> Iterator[ast.expr]:
    """What must not be zero for an operation to be finite: divisors, bases of powers, cosines of tangents."""
    if isinstance(node, ast.BinOp) and isinstance(node.op, (ast.Div, ast.FloorDiv, ast.Mod)):
        yield from _factors(node.right)
    elif isinstance(node, ast.BinOp) and isinstance(node.op, ast.Pow) and _may_be_negative(node.right):
        yield from _factors(node.left)
    elif isinstance(node, ast.Call) and _name(node.func) == "tan":
        yield ast.Call(ast.Name("cos"), node.args, [])


def _may_be_negative(power: ast.expr) -> bool:
    return not (isinstance(power, ast.Constant) and power.value >= 0)  # type: ignore[operator]


def _factors(node: ast.expr) -> Iterator[ast.expr]:
    """Those parts of a divisor that change their sign where it has a zero, as a square itself does not."""
    if isinstance(node, ast.BinOp) and isinstance(node.op, ast.Mult):
        yield from _factors(node.left)
        yield from _factors(node.right)
    elif isinstance(node, ast.BinOp) and isinstance(node.op, (ast.Div, ast.Pow)):
        yield from _factors(node.left)
    elif isinstance(node, ast.UnaryOp):
        yield from _factors(node.operand)
    elif isinstance(node, ast.Call) and _name(node.func) in ("abs", "sqrt") and len(node.args) == 1:
        yield from _factors(node.args[0])
    else:
        yield node


def _sign(node: ast.expr, values: Mapping[str, Any]) -> int:
    value = _value(node, values)
    return int(value > 0) - int(value < 0)


def _value(node: ast.AST, values: Mapping[str, Any]) -> Any:
    name = _name(node)
    if name is not None:
        return _CONSTANTS[name] if name in _CONSTANTS else values[name]
    if isinstance(node, ast.Constant):
        return node.value
    if isinstance(node, ast.BinOp):
        return _BINARY[type(node.op)](_value(node.left, values), _value(node.right, values))
    if isinstance(node, ast.UnaryOp):
        return _UNARY[type(node.op)](_value(node.operand, values))
    assert isinstance(node, ast.Call)
    try:
        return _FUNCTIONS[str(_name(node.func))](*(_value(each, values) for each in node.args))
    except TypeError as error:
        raise ValueError(str(error)) from None
