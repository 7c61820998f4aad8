# SPDX-License-Identifier: GPL-3.0-or-later
"""Arguments of functions, checked against their annotations before anything is computed."""

from __future__ import annotations

import functools
import inspect
import re
from collections.abc import Callable, Iterable, Sequence
from itertools import chain, repeat
from numbers import Integral, Real
from operator import index
from typing import Any, NoReturn, TypeVar, cast, get_args, get_type_hints

from ._errors import InputError

_LARGEST = 2**31 - 1  # of the program's whole numbers

Function = TypeVar("Function", bound=Callable[..., Any])


def _plain(given: Any) -> Any:
    """Python's own for what NumPy has; of an array without dimensions its one value."""
    return given.tolist() if hasattr(given, "tolist") else given


def number(name: str, given: Any) -> float:
    given = _plain(given)
    if isinstance(given, bool) or not isinstance(given, Real):
        _refuse(name, "a number", given)
    return float(given)


def whole(name: str, given: Any) -> int:
    given = _plain(given)
    if isinstance(given, bool) or not isinstance(given, Integral) or abs(index(given)) > _LARGEST:
        _refuse(name, f"a whole number up to {_LARGEST}", given)
    return index(given)


def truth(name: str, given: Any) -> bool:
    given = _plain(given)
    if not isinstance(given, bool):
        _refuse(name, "True or False", given)
    return given


def word(name: str, given: Any) -> str:
    if not isinstance(given, str):
        _refuse(name, "text", given)
    return given


def _refuse(name: str, wanted: str, given: Any) -> NoReturn:
    raise TypeError(f"{name} takes {wanted}, not {given!r}")


# Options of the program whose arguments have other names, and those that are keys of the scene here.
_ARGUMENTS = {
    "best": "best_deg", "dialect": "dialects", "kind": "kinds", "no-curve": "curve", "study": "studies",
    "surface": "surfaces", "tilt": "tilts_deg", "with": "parts",
}  # fmt: skip
_KEYS = {"part": "wedm.part", "tilt": "tilt.angle_deg"}
_RIG = ("torque_constant", "counts_per_turn", "ratio", "efficiency")
_VALUE = r"-?\d+(?:\.\d+)?(?:e[+-]?\d+)?|FROM,TO|b-spline|circular-spline|contact|flexspline|load|radial|tilted"
# An option, and the value that follows it; commands in quotes stay as they are.
_OPTION = re.compile(rf"`[^`]*`|(?m:^POINTS\b)|(?<![\w-])--([a-z]+(?:-[a-z]+)*)(?: ({_VALUE})(?![\w-]))?")
# The heading of faults of changes, and a change or a removal that a remedy names.
_SET = re.compile(r"(?m:^--set:)|--set (?:'!([\w.]+)'|([\w.]+)=([\w.-]+))")


def as_changes(text: str) -> str:
    """What the program says of ``--set``, with :meth:`Scene.with_` in its place."""

    def change(match: re.Match[str]) -> str:
        removed, path, value = match.groups()
        if removed:
            return f'with_({{"{removed}": None}})'
        if not path:
            return "with_():"
        shown = value if value[0].isdigit() or value == "value" else f'"{value}"'
        return f'with_({{"{path}": {shown}}})'

    return _SET.sub(change, text)


def _in_arguments(text: str, names: Sequence[str], takes_any: bool) -> str:
    """What the program says, with a function's arguments in place of options."""

    def argument(match: re.Match[str]) -> str:
        option, value = match[1] or "points", match[2]
        name = _ARGUMENTS.get(option, option.replace("-", "_"))
        if value == "FROM,TO":
            name, value = "best_deg", "[FROM, TO]"
        elif value and value[-1].isalpha():
            value = f'"{value}"'
        if name == "measured" and name not in names:
            name = "file"
        if match[0].startswith("`"):
            return match[0]
        if name in names or takes_any:
            return f"{name}={value}" if value else name
        if name in _RIG:
            return f"read_measured(FILE, {name}={value or '...'})"
        return " = ".join(filter(None, (_KEYS[option], value))) if option in _KEYS else match[0]

    return _OPTION.sub(argument, as_changes(text))


def _by_arguments(error: InputError, names: Sequence[str], takes_any: bool) -> InputError:
    def told(text: str) -> str:
        return _in_arguments(text, names, takes_any)

    faults = (
        fault._replace(path=told(fault.path), reason=told(fault.reason), remedy=told(fault.remedy))
        for fault in error.faults
    )
    return InputError(tuple(faults), told(error.text))


_CHECKS: dict[Any, Callable[[str, Any], Any]] = {float: number, int: whole, bool: truth, str: word}


def checked(function: Function) -> Function:
    """The function, which refuses arguments that are annotated as one of these kinds and are none.

    The faults that it raises name its arguments, not the options of the program.
    """
    checks, may_be_none = {}, set()
    for name, hint in get_type_hints(function).items():
        kinds = get_args(hint) or (hint,)
        simple = [kind for kind in kinds if kind in _CHECKS]
        if simple and len(kinds) == 1 + (type(None) in kinds):
            checks[name] = _CHECKS[simple[0]]
        if type(None) in kinds:
            may_be_none.add(name)
    parameters = inspect.signature(function).parameters
    names, takes_any = list(parameters), any(each.kind is each.VAR_KEYWORD for each in parameters.values())

    def value_of(name: str, given: Any) -> Any:
        return given if name not in checks or (given is None and name in may_be_none) else checks[name](name, given)

    @functools.wraps(function)
    def call(*positional: Any, **named: Any) -> Any:
        values = [value_of(name, given) for name, given in zip(chain(names, repeat("")), positional)]
        others = {name: value_of(name, given) for name, given in named.items()}
        try:
            return function(*values, **others)
        except InputError as error:
            raise _by_arguments(error, names, takes_any).with_traceback(error.__traceback__) from None

    return cast(Function, call)


def numbers(name: str, given: float | Sequence[float]) -> list[float]:
    """Of one number, or of several."""
    given = _plain(given)
    if isinstance(given, Real):
        return [number(name, given)]
    if isinstance(given, str) or not isinstance(given, Iterable):
        _refuse(name, "a number or several, such as [0, 0.1]", given)
    return [number(name, each) for each in given]


def words(name: str, given: str | Sequence[str]) -> list[str]:
    """Of one word, or of several."""
    if isinstance(given, str):
        return [given]
    if not isinstance(given, Iterable):
        _refuse(name, "a word or several", given)
    return [word(name, each) for each in given]


def interval(name: str, given: Sequence[float]) -> tuple[float, float]:
    """Of two numbers in either order."""
    ends = numbers(name, given)
    if len(ends) != 2:
        _refuse(name, "two numbers, such as (0, 0.3)", given)
    return min(ends), max(ends)
