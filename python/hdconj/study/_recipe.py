# SPDX-License-Identifier: GPL-3.0-or-later
"""A study as it was read: what varies, what is computed, what is wanted."""

from __future__ import annotations

import hashlib
import json
import math
import os
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path
from typing import Any

from .._errors import InputError, NumericalError
from .._scene import Scene
from ._data_files import checksum, contents, renamed
from ._expression import NO_VALUE, Expression
from ._keys import Key, Value, is_number
from ._sample import sample_count, values_of

VERBS = ("solve", "contact", "load")
_LATER = ("constraints", "objectives")  # may change between two runs into one folder


@dataclass(frozen=True)
class Recipe:
    """A study that has no fault."""

    text: str
    tables: Mapping[str, Any]
    scene: Scene
    keys: tuple[Key, ...]
    links: tuple[tuple[str, Expression], ...]
    method: str
    count: int
    seed: int
    verbs: tuple[tuple[str, Mapping[str, Any]], ...]
    errors: bool
    survivors: int
    figures: tuple[tuple[str, Expression], ...]
    constraints: Mapping[str, tuple[float, float]] = field(default_factory=dict)
    objectives: Mapping[str, int] = field(default_factory=dict)
    """1: as small as possible, -1: as large as possible."""
    optimise: Mapping[str, Any] = field(default_factory=dict)
    places: Mapping[str, str] = field(default_factory=dict)
    """Where the files are that the study names otherwise: its table [files]."""

    @property
    def drives(self) -> int:
        """How many drives the sample has."""
        return sample_count(self.method, self.count, self.keys)

    def values(self, index: int) -> dict[str, Value]:
        """Values of the keys of drive ``index``, without links."""
        chosen = values_of(index, self.method, self.count, self.seed, self.keys)
        return {key.path: value for key, value in zip(self.keys, chosen)}

    def values_at(self, units: Any) -> dict[str, Value]:
        """Values of the keys at numbers from 0 to 1."""
        return {key.path: key.value(float(unit)) for key, unit in zip(self.keys, units)}

    def restored(self, row: Mapping[str, Any]) -> dict[str, Value]:
        """Values of the keys of a row of a table, as they were computed with."""
        return {key.path: key.restored(row[key.path]) for key in self.keys}

    @property
    def first(self) -> dict[str, Value]:
        """The drive in the middle of everything that varies."""
        return {key.path: key.middle for key in self.keys}

    @cached_property
    def base(self) -> dict[str, Any]:
        """Keys of the scene that all drives share; none where its text is no TOML, of which its check tells."""
        try:
            return flat(self.scene.to_dict())
        except InputError:
            return {}

    @cached_property
    def constants(self) -> dict[str, float]:
        """Keys of the scene that all drives share and that are numbers."""
        return {path: value for path, value in self.base.items() if is_number(value)}

    def linked(self, values: Mapping[str, Value]) -> dict[str, Value]:
        """All values, links included; raises NumericalError where a link has none."""
        if not self.links:
            return dict(values)
        known = {**self.base, **values}
        for path, expression in self.links:
            known[path] = _number_of(path, expression, known)
        return {**values, **{path: known[path] for path, _ in self.links}}

    def scene_of(self, linked: Mapping[str, Value]) -> Scene:
        """The scene of a drive; names without a dot are the study's own, and whole values may be counts."""
        changes = {path: _whole(value) for path, value in linked.items() if "." in path}
        for path in self.file_paths & changes.keys():
            changes[path] = self.places.get(str(changes[path]), changes[path])
        return self.scene.with_(changes)

    @cached_property
    def file_paths(self) -> frozenset[str]:
        """Keys under [vary] whose words name files, where the study has a table [files] for these."""
        words = [(key.path, value) for key in self.keys for value in key.values if value in self.places]
        first = {path: _whole(value) for path, value in self.first.items() if "." in path}
        return frozenset(path for path, word in words
                         if "." in path and path in self.scene.with_({**first, path: word})._core.files)  # fmt: skip

    @cached_property
    def varied(self) -> frozenset[str]:
        """Keys and names that vary, links included."""
        return frozenset((*(key.path for key in self.keys), *(path for path, _ in self.links)))

    def varied_of(self, link: str) -> list[str]:
        """Keys that vary from which a link is computed, by way of other links too."""
        links, found, left = dict(self.links), set[str](), [link]
        while left:
            names = links[left.pop()].names
            left += [name for name in names if name in links and name not in found]
            found.update(names)
        return [key.path for key in self.keys if key.path in found]

    @cached_property
    def figure_names(self) -> frozenset[str]:
        """What the expressions under [figures] read."""
        return frozenset(name for _, expression in self.figures for name in expression.names)

    @property
    def units(self) -> dict[str, str]:
        """Units that the study gives to its figures."""
        figures = self.tables["figures"].items()
        return {name: item["unit"] for name, item in figures if isinstance(item, dict) and "unit" in item}

    @cached_property
    def files(self) -> dict[str, bytes]:
        """What the files hold that drives and options name, under these names and those that the study has for them."""
        there = {**self.data, **self.measured}
        return there | {name: there[place] for name, place in self.places.items() if place in there}

    @property
    def data(self) -> dict[str, bytes]:
        """What the files hold that scene and lists of [vary] name; a study that names others is refused."""
        return contents([self.scene, *(scene for _, _, scene in self.worded())])

    def worded(self) -> Iterator[tuple[Key, str, Scene]]:
        """Words in lists of [vary], which may name files, and the drive in the middle with each."""
        first = self.first
        for key in self.keys:
            for word in (value for value in key.values if isinstance(value, str)):
                yield key, word, self.scene_of({**first, key.path: word})

    @cached_property
    def measured(self) -> dict[str, bytes]:
        """What the measured curves hold, under the names that the study gives them; without those that are not there.

        Their options have the names of the files where they are.
        """
        found = {}
        for verb, options in self.verbs:
            if "measured" in options and (file := Path(options["measured"])).is_file() and os.access(file, os.R_OK):
                found[str(self.tables["compute"][verb]["measured"])] = file.read_bytes()
        return found

    def identity(self) -> str:
        """A hash of what decides the rows; of a file its content counts, and not its name."""
        kept = {name: table for name, table in self.tables.items() if name not in (*_LATER, "scene", "files")}
        kept["sample"] = {k: v for k, v in kept.get("sample", {}).items() if k != "count" or self.method == "lhs"}
        kept["compute"] = {k: v for k, v in kept.get("compute", {}).items() if k != "survivors"}
        kept["optimise"] = {k: v for k, v in kept.get("optimise", {}).items() if k != "generations"}
        kept["scene"] = self.scene.to_dict()
        # a sample gives its numbers to the keys in their order, and rows have their columns in it
        kept["order"] = [*(key.path for key in self.keys), *(name for name, _ in (*self.links, *self.figures))]
        words = json.dumps(kept, sort_keys=True, default=str)
        words = renamed(words, {name: checksum(content) for name, content in self.files.items()})
        return hashlib.sha256(words.encode()).hexdigest()


def _number_of(path: str, link: Expression, known: Mapping[str, Any]) -> Value:
    try:
        value: Value = link(known)
        if isinstance(value, (int, float)) and math.isfinite(value):
            return value
        cause = "is no finite number"
    except NO_VALUE as error:
        cause = str(error)
    raise NumericalError("link", "study", path, f"{link.text}: {cause}")


def _whole(value: Value) -> Value:
    """A number of floating point that is whole as such a number, which keys of counts take."""
    is_whole = isinstance(value, float) and value.is_integer() and abs(value) <= 2**53
    return int(value) if is_whole else value


def flat(tables: Mapping[str, Any], before: str = "") -> dict[str, Any]:
    """Nested tables as paths with dots."""
    found: dict[str, Any] = {}
    for name, item in tables.items():
        path = f"{before}{name}"
        found.update(flat(item, f"{path}.") if isinstance(item, Mapping) else {path: item})
    return found
