# SPDX-License-Identifier: GPL-3.0-or-later
"""What varies: ranges, lists, distributions and classes of tolerance, each a function of a number from 0 to 1."""

from __future__ import annotations

import json
import math
import re
import sys
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from fractions import Fraction
from typing import Any, NamedTuple, Union

import numpy as np

from .._core import describe_key
from ._faults import written

Value = Union[bool, int, float, str]
LAWS = ("from", "list", "normal", "uniform", "nominal")
MOST = 10**7  # drives of a study, and values of a law: their numbers fit into the memory of one machine
_ALLOWED = {
    "from": {"from", "to", "count", "step"},
    "list": {"list"},
    "normal": {"normal", "limits"},
    "uniform": {"uniform"},
    "nominal": {"nominal", "tolerance"},
}
# Standard tolerances of ISO 286-1 in um: for sizes up to that in mm, grades IT5 to IT11.
_SIZES = (3, 6, 10, 18, 30, 50, 80, 120, 180, 250, 315, 400, 500)
_GRADES = {
    5: (4, 5, 6, 8, 9, 11, 13, 15, 18, 20, 23, 25, 27),
    6: (6, 8, 9, 11, 13, 16, 19, 22, 25, 29, 32, 36, 40),
    7: (10, 12, 15, 18, 21, 25, 30, 35, 40, 46, 52, 57, 63),
    8: (14, 18, 22, 27, 33, 39, 46, 54, 63, 72, 81, 89, 97),
    9: (25, 30, 36, 43, 52, 62, 74, 87, 100, 115, 130, 140, 155),
    10: (40, 48, 58, 70, 84, 100, 120, 140, 160, 185, 210, 230, 250),
    11: (60, 75, 90, 110, 130, 160, 190, 220, 250, 290, 320, 360, 400),
}
_BETWEEN = 0.6180339887  # a part of a range that makes a whole number of few ranges
_TINY = 2.0**-53  # a number from 0 to 1 keeps this far from both


class Takes(NamedTuple):
    """What a key of scenes takes."""

    number: str  # "length", "angle", "number" or "whole number"; empty where it takes none
    unit: str  # "mm", "deg", or another such as "N m"; empty for none
    words: str  # what may be written, such as "a length in mm above 0"


def takes(path: str) -> Takes:
    """What the scene's schema says of a key; all empty where no table has it."""
    return Takes(*(describe_key(path) or ("", "", "")))


def is_number(value: object) -> bool:
    """Whether a value of TOML is a finite number."""
    return isinstance(value, (int, float)) and not isinstance(value, bool) and abs(value) <= sys.float_info.max


def as_text(value: Value) -> str:
    """A value in a column of text: words as they are, others as TOML writes them."""
    return value if isinstance(value, str) else json.dumps(value)


@dataclass(frozen=True)
class Key:
    """A key of the scene, or a name of the study, and how it varies.

    ``law`` is one of :data:`LAWS`; ``numbers`` holds the ends of the range, or mean and deviation and limits;
    ``values`` the values of a list, or the points of a grid.
    """

    path: str
    law: str
    numbers: tuple[float, ...] = ()
    values: tuple[Value, ...] = ()

    @property
    def is_random(self) -> bool:
        """Whether it is a distribution."""
        return self.law in ("normal", "uniform", "nominal")

    def value(self, unit: float) -> Value:
        """The value that belongs to a number from 0 to 1; it does not fall where that rises."""
        if self.law == "list" or (self.law == "from" and self.numbers[2:]):
            return self.values[min(int(unit * len(self.values)), len(self.values) - 1)]
        unit = min(max(float(unit), _TINY), 1 - _TINY)
        if self.law in ("from", "uniform"):
            return self.numbers[0] + unit * (self.numbers[1] - self.numbers[0])
        from scipy.stats import norm, truncnorm

        mean, deviation, *limits = self.numbers
        if not limits:
            return float(norm.ppf(unit, mean, deviation))
        low, high = ((limit - mean) / deviation for limit in limits)
        return float(truncnorm.ppf(unit, low, high, mean, deviation))

    @property
    def middle(self) -> Value:
        """The value in the drive in the middle: the middle, the mean, or the first of a list."""
        return self.values[0] if self.law == "list" else self.value(0.5)

    @property
    def is_text(self) -> bool:
        """Whether its column holds text: its list has words, if only among numbers."""
        if self.law != "list":
            return False
        kinds = {float if type(value) is int else type(value) for value in self.values}
        return str in kinds or len(kinds) > 1

    def restored(self, cell: Any) -> Value:
        """The value that a cell of its column stands for."""
        if self.is_text:
            return next((value for value in self.values if as_text(value) == cell), str(cell))
        plain: Value = np.asarray(cell).item()
        return next((value for value in self.values if value == plain), plain)

    @property
    def probes(self) -> tuple[Value, ...]:
        """Values that the scene's schema must take."""
        if self.law == "list":
            return self.values
        ends = () if self.law == "normal" else (self.value(0.0), self.value(1.0))
        return (self.middle, *ends, *self.values[1:2])

    @property
    def between(self) -> tuple[Value, ...]:
        """A value that is whole only where all are, but for lists."""
        return () if self.values else (self.value(_BETWEEN),)


def _pair(spec: Mapping[str, Any], name: str, told: Callable[[str, str], None]) -> tuple[float, float] | None:
    pair = spec[name]
    if not isinstance(pair, list) or len(pair) != 2 or not all(map(is_number, pair)):
        told(f"{name} = {written(pair)} is not two numbers", f"write {name} = [A, B]")
        return None
    return float(pair[0]), float(pair[1])


def _range(path: str, spec: Mapping[str, Any], told: Callable[[str, str], None]) -> Key | None:
    low, high = spec.get("from"), spec.get("to")
    if not (is_number(low) and is_number(high)):
        told("from and to are not two numbers", "write { from = A, to = B }")
        return None
    assert isinstance(low, (int, float)) and isinstance(high, (int, float))
    if low >= high:
        told(f"from = {low} is not below to = {high}", "exchange them, or write one value under [set]")
        return None
    if not is_number(float(high) - float(low)):
        told(f"from {low} to {high} is too wide", "write numbers up to 1e300")
        return None
    step, count = spec.get("step"), spec.get("count")
    if step is not None:
        if not is_number(step) or step <= 0:
            told(f"step = {written(step)} divides no range", "write a number above 0")
            return None
        if not float(high) / step - float(low) / step < MOST:
            least = f"{1.1 * (float(high) / MOST - float(low) / MOST):.2g}"
            told(f"step = {written(step)} makes more than {MOST} points", f"write a number from {least}")
            return None
        if count is not None:
            told("both step and count", "remove one of them")
        count = int((high - low) / step * (1 + 1e-12)) + 1
        return Key(path, "from", (float(low), float(high), float(step)), _points(low, high, step, count))
    if count is None:
        return Key(path, "from", (float(low), float(high)))
    if not isinstance(count, int) or isinstance(count, bool) or not 2 <= count <= MOST:
        told(f"count = {written(count)} makes no grid", f"write a whole number from 2 to {MOST}")
        return None
    return Key(path, "from", (float(low), float(high)), _points(float(low), float(high), None, count))


def _points(low: float, high: float, step: float | None, count: int) -> tuple[float, ...]:
    """Points from low on by steps, or even ones up to high. As decimal numbers, rounded once: 0.3 + 6 x 0.2 is 1.5.

    They are whole numbers where low and step are, and the last one is not above high.
    """
    if isinstance(low, int) and isinstance(step, int):
        return tuple(range(low, low + count * step, step))
    begin, end, width = (Fraction(repr(number)) for number in (low, high, 0 if step is None else step))
    parts = count - 1 if step is None else 1
    scale = math.lcm(begin.denominator, end.denominator, width.denominator)
    first, over = int(begin * scale), int((width or end - begin) * scale)
    return tuple(min((first * parts + i * over) / (scale * parts), float(high)) for i in range(count))


def _tolerance(path: str, spec: Mapping[str, Any], told: Callable[[str, str], None]) -> Key | None:
    nominal, tolerance = spec["nominal"], spec.get("tolerance")
    if not is_number(nominal) or not 0 < nominal <= _SIZES[-1]:
        told(f"nominal = {written(nominal)} is no size", f"write a length in mm above 0 and at most {_SIZES[-1]}")
        return None
    match = re.fullmatch(r"(h|H|js|JS)(\d+)", tolerance) if isinstance(tolerance, str) else None
    if match is None or int(match[2]) not in _GRADES:
        told(
            "no tolerance" if tolerance is None else f"tolerance = {written(tolerance)} is no class that is known here",
            f'write h, H or js and a grade from {min(_GRADES)} to {max(_GRADES)}, such as tolerance = "js7"',
        )
        return None
    width = _GRADES[int(match[2])][next(i for i, size in enumerate(_SIZES) if nominal <= size)] / 1000
    low = (
        float(nominal)
        + {"h": -width, "H": 0.0, "js": -width / 2}[match[1].lower() if "s" in match[1].lower() else match[1]]
    )
    return Key(path, "nominal", (low + width / 2, width / 6, low, low + width))


def read_key(path: str, spec: Mapping[str, Any], told: Callable[[str, str], None]) -> Key | None:
    """The key that a table of ``[vary]`` describes; faults go to ``told(reason, remedy)``, and then None comes back."""
    laws = [law for law in LAWS if law in spec]
    if len(laws) != 1:
        told("several laws at once" if laws else "no law", "write one of from and to, list, normal, uniform, nominal")
        return None
    law = laws[0]
    for name in sorted(set(spec) - _ALLOWED[law]):
        told(f"unknown word {name}", f"with {law} go: {', '.join(sorted(_ALLOWED[law] - {law})) or 'none'}")
    if law == "from":
        return _range(path, spec, told)
    if law == "nominal":
        return _tolerance(path, spec, told)
    if law == "list":
        values = spec["list"]
        if (
            not isinstance(values, list)
            or not values
            or not all(isinstance(v, (bool, str)) or is_number(v) for v in values)
        ):
            told("no list of values", "write list = [A, B, C] of numbers or words")
            return None
        return Key(path, "list", (), tuple(values))
    pair = _pair(spec, law, told)
    if pair is None:
        return None
    if law == "uniform":
        if pair[0] >= pair[1]:
            told(f"the interval {list(pair)} is empty", "write the smaller end first")
            return None
        return Key(path, "uniform", pair)
    if pair[1] <= 0:
        told(f"the standard deviation {pair[1]} is not above 0", "write normal = [MEAN, DEVIATION]")
        return None
    limits = _pair(spec, "limits", told) if "limits" in spec else ()
    if limits is None:
        return None
    if limits and not limits[0] < limits[1]:
        told(f"the limits {list(limits)} are empty", "write the smaller limit first")
        return None
    return Key(path, "normal", (*pair, *limits))
