# SPDX-License-Identifier: GPL-3.0-or-later
"""Faults of a study: where they stand in its file, and how they are told."""

from __future__ import annotations

import difflib
import re
import tomllib
from collections.abc import Iterable, Mapping
from typing import Any

from .._errors import Fault, InputError, fault_text
from .._scene import toml_value

_LONGEST = 100  # characters of a value
_WORD = r"""(?:[\w-]+|"[^"\n]*"|'[^'\n]*')"""
_KEY = re.compile(rf"[ \t]*({_WORD}(?:[ \t]*\.[ \t]*{_WORD})*)[ \t]*=")


class UncheckedNames(UserWarning):
    """No drive that was tried can be made, so that nothing says whether the names of figures are right."""


def _path_in(line: str) -> str:
    """The path of the one table or key in a line of TOML; empty where there is none."""
    try:
        item: Any = tomllib.loads(line)
    except tomllib.TOMLDecodeError:
        return ""
    words: list[str] = []
    while isinstance(item, dict) and item:
        word, item = next(iter(item.items()))
        words.append(word)
    return ".".join(words)


def lines_of(text: str) -> dict[str, int]:
    """The line of each table and each key of a text in TOML, from 1."""
    found: dict[str, int] = {}
    table = ""
    for number, line in enumerate(text.split("\n"), 1):
        if line.lstrip().startswith("["):
            table = _path_in(line) or table
            found.setdefault(table, number)
        elif key := _KEY.match(line):
            found.setdefault(f"{table}." * bool(table) + _path_in(f"{key[1]} = 0"), number)
    return found


def fault_at(lines: Mapping[str, int], path: str, reason: str, remedy: str, value: object = "") -> Fault:
    """A fault of a key, in the line of the key or of the table that it stands in."""
    place = path
    while place and place not in lines:
        place = place.rpartition(".")[0]
    return Fault(path, lines.get(place, 0), written(value), reason, remedy)


def written(value: object) -> str:
    """A value as the file has it, words without quotes; the beginning of a long one."""
    if isinstance(value, Mapping):
        text = f"{{ {', '.join(f'{key} = {toml_value(item)}' for key, item in value.items())} }}"
    else:
        text = value if isinstance(value, str) else toml_value(value)  # type: ignore[arg-type]
    return text if len(text) <= _LONGEST else text[:_LONGEST] + "..."


def short(value: object) -> str:
    """A value in a sentence: six digits of a number."""
    return f"{value:.6g}" if isinstance(value, (int, float)) and not isinstance(value, bool) else written(value)


def near(word: str, known: Iterable[object]) -> str:
    """What to write in place of a word that is not known."""
    words = list(map(str, known))
    close = difflib.get_close_matches(word, words, 1)
    return f"write {close[0]}" if close else f"known: {', '.join(words)}"


def refuse(faults: list[Fault]) -> None:
    """Raises InputError with all faults, in order of place."""
    if faults:
        ordered = tuple(sorted(dict.fromkeys(faults), key=lambda fault: (fault.line or 10**9, fault.path)))
        raise InputError(ordered, fault_text(ordered))
