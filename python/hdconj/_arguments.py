# SPDX-License-Identifier: GPL-3.0-or-later
"""Arguments of functions, checked against their annotations before anything is computed."""

from __future__ import annotations

import functools
import inspect
from collections.abc import Callable, Iterable, Sequence
from itertools import chain, repeat
from numbers import Integral, Real
from operator import index
from typing import Any, NoReturn, TypeVar, cast, get_args, get_type_hints

_LARGEST = 2**31 - 1  # of the program's whole numbers

Function = TypeVar("Function", bound=Callable[..., Any])


def number(name: str, given: Any) -> float:
    if isinstance(given, bool) or not isinstance(given, Real):
        _refuse(name, "a number", given)
    return float(given)


def whole(name: str, given: Any) -> int:
    if isinstance(given, bool) or not isinstance(given, Integral) or abs(index(given)) > _LARGEST:
        _refuse(name, f"a whole number up to {_LARGEST}", given)
    return index(given)


def truth(name: str, given: Any) -> bool:
    if type(given).__name__ not in ("bool", "bool_"):  # Python's, and both names of NumPy's
        _refuse(name, "True or False", given)
    return bool(given)


def word(name: str, given: Any) -> str:
    if not isinstance(given, str):
        _refuse(name, "text", given)
    return given


def _refuse(name: str, wanted: str, given: Any) -> NoReturn:
    raise TypeError(f"{name} takes {wanted}, not {given!r}")


_CHECKS: dict[Any, Callable[[str, Any], Any]] = {float: number, int: whole, bool: truth, str: word}


def checked(function: Function) -> Function:
    """The function, which refuses arguments that are annotated as one of these kinds and are none."""
    checks, may_be_none = {}, set()
    for name, hint in get_type_hints(function).items():
        kinds = get_args(hint) or (hint,)
        simple = [kind for kind in kinds if kind in _CHECKS]
        if simple and len(kinds) == 1 + (type(None) in kinds):
            checks[name] = _CHECKS[simple[0]]
        if type(None) in kinds:
            may_be_none.add(name)
    names = list(inspect.signature(function).parameters)

    def value_of(name: str, given: Any) -> Any:
        return given if name not in checks or (given is None and name in may_be_none) else checks[name](name, given)

    @functools.wraps(function)
    def call(*positional: Any, **named: Any) -> Any:
        return function(
            *(value_of(name, given) for name, given in zip(chain(names, repeat("")), positional)),
            **{name: value_of(name, given) for name, given in named.items()},
        )

    return cast(Function, call)


def numbers(name: str, given: float | Sequence[float]) -> list[float]:
    """Of one number, or of several."""
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
