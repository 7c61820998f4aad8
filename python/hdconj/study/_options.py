# SPDX-License-Identifier: GPL-3.0-or-later
"""Options of a verb under [compute]: their types are those of the Python function, which judges their values."""

from __future__ import annotations

import types
from collections.abc import Iterator, Mapping, Sequence
from typing import Any, Union, get_args, get_origin, get_type_hints

import hdconj

from .._errors import Fault, InputError, NumericalError
from .._scene import Scene
from ._keys import is_number

_NOT_HERE = ("scene", "progress", "errors", "advice", "return")
# Options that stand in place of a key of the scene, and that key.
KEYS = {
    **{"torque": "load.torque", "points": "load.points"},
    **{"tilts_deg": "tilt.angle_deg", "kinds": "tilt.kind", "surfaces": "slices.surface"},
}
_LEAVES = {bool: "true or false", int: "a whole number", float: "a number", str: "a text in quotes"}


class _Asked(Exception):
    """A verb begins to compute: it has taken its options."""


def _begins(what: str, share: float | None) -> None:
    raise _Asked


def known_options(verb: str) -> dict[str, Any]:
    """Options that a study may give to a verb, and their types."""
    return {name: kind for name, kind in get_type_hints(getattr(hdconj, verb)).items() if name not in _NOT_HERE}


def single(value: Any) -> Any:
    """The one value of an option that may be a list; None where it has none."""
    return next(iter(value), None) if isinstance(value, list) else value


def fits(value: object, kind: Any) -> bool:
    """Whether a value of TOML is one of a type."""
    origin, inner = get_origin(kind), get_args(kind)
    if origin in (Union, types.UnionType):
        return any(fits(value, each) for each in inner)
    if origin is tuple:
        return isinstance(value, list) and len(value) == len(inner) and all(map(fits, value, inner))
    if origin is Sequence:
        return isinstance(value, list) and all(fits(each, inner[0]) for each in value)
    if kind is float:
        return is_number(value)
    if kind is int:
        return isinstance(value, int) and not isinstance(value, bool) and abs(value) < 2**31
    return kind in (bool, str) and isinstance(value, kind)


def in_words(kind: Any) -> str:
    """A type as one writes it in TOML."""
    origin, inner = get_origin(kind), get_args(kind)
    if origin in (Union, types.UnionType):
        return " or ".join(filter(None, map(in_words, inner)))
    if origin is tuple:
        return f"[{', '.join(map(in_words, inner))}]"
    return f"[{in_words(inner[0])}]" if origin is Sequence else _LEAVES.get(kind, "")


def judged(verb: str, options: Mapping[str, Any], scene: Scene) -> Iterator[Fault]:
    """What the verb itself finds wrong with its options, before it computes anything.

    Options that it refuses are left out then, as their faults may hide others. A measured curve is left to the first
    drive: a study is read also where that file is not.
    """
    known = known_options(verb)
    asked = {name: value for name, value in options.items() if name != "measured" and fits(value, known.get(name))}
    while True:
        try:
            getattr(hdconj, verb)(scene, **asked, progress=_begins)
        except (_Asked, NumericalError):
            return
        except InputError as error:
            faults = [fault for fault in error.faults if fault.path in known]
            yield from faults
            kept = {name: value for name, value in asked.items() if name not in {fault.path for fault in faults}}
            if kept == asked:
                return
            asked = kept
