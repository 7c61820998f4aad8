# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads the tables of STUDY.toml one after the other, and collects their faults (docs/reference/study.md)."""

from __future__ import annotations

import json
import re
from collections.abc import Iterable, Iterator, Mapping
from difflib import get_close_matches
from graphlib import CycleError, TopologicalSorter
from pathlib import Path
from typing import Any

from .._errors import Fault
from .._scene import Scene, toml_text
from ._data_files import TABLE, placed
from ._expression import NO_VALUE, Expression, as_name
from ._faults import fault_at, lines_of, near, written
from ._keys import LAWS, MOST, Key, is_number, read_key
from ._options import fits, in_words, known_options
from ._recipe import VERBS, flat

_TAKEN = ("sample", "code", "stage", "place", "cause", "rank")
_PATH = re.compile(r"[\w-]+(\.[\w-]+)*")


def _specs(tables: Mapping[str, Any], before: str = "") -> Iterator[tuple[str, Any]]:
    """Path and law of each key of [vary], whose paths may be quoted or nested."""
    for name, item in tables.items():
        if (
            isinstance(item, Mapping)
            and not set(item) & set(LAWS)
            and any(isinstance(inner, (Mapping, str)) for inner in item.values())
        ):
            yield from _specs(item, f"{before}{name}.")
        else:
            yield f"{before}{name}", item


class Reader:
    """Reads the tables of a study one after the other, and collects faults."""

    def __init__(self, text: str, name: str, folder: Path) -> None:
        self.text, self.name, self.folder = text, name, folder
        self.lines = lines_of(text)
        self.faults: list[Fault] = []
        self.tables: dict[str, Any] = {}
        self.places: dict[str, str] = {}

    def told(self, path: str, reason: str, remedy: str, value: object = "") -> None:
        """Notes a fault of a key or of a table."""
        self.faults.append(fault_at(self.lines, path, reason, remedy, value))

    def table(self, name: str, known: tuple[str, ...] | None = None) -> dict[str, Any]:
        """A table of the file; unknown words in it are faults where `known` lists them."""
        table = self.tables.get(name, {})
        if not isinstance(table, dict):
            self.told(name, "is no table", f"write [{name}] on a line of its own", table)
            return {}
        for word in table if known is not None else ():
            if known is not None and word not in known:
                self.told(f"{name}.{word}", "unknown key", near(word, known))
        return table

    def paths(self, table: str, given: Iterable[tuple[str, Any]]) -> Iterator[tuple[str, Any]]:
        """Those of the keys under [set] or [vary] whose paths can be such of a scene."""
        for path, item in given:
            if _PATH.fullmatch(path):
                yield path, item
            else:
                remedy = 'write words with dots between them, such as "flexspline.wall"'
                fault = fault_at(self.lines, f"{table}.{path}", "is no path of a key", remedy)
                self.faults.append(fault._replace(path=f"{table}.{json.dumps(path)}"))

    def count(self, table: Mapping[str, Any], path: str, standard: int, least: int = 0, most: int = MOST) -> int:
        """A whole number of a table."""
        value = table.get(path.split(".")[-1], standard)
        if isinstance(value, bool) or not isinstance(value, int) or not least <= value <= most:
            is_more = isinstance(value, int) and value > most
            reason = f"is more than {most}" if is_more else "must be a whole number"
            self.told(path, reason, f"write a whole number from {least} to {most}", value)
            return max(standard, least)
        return value

    def word(self, table: Mapping[str, Any], path: str, standard: str, known: tuple[str, ...]) -> str:
        """A word of a table."""
        value = table.get(path.split(".")[-1], standard)
        if value not in known:
            self.told(path, "unknown word", f"write one of {', '.join(known)}", value)
            return standard
        return str(value)

    def expression(self, path: str, text: object) -> Expression | None:
        """An expression of the study."""
        try:
            if not isinstance(text, str):
                raise ValueError("no expression in quotes")
            expression = Expression(text)
        except ValueError as error:
            reason, *remedy = error.args
            usual = 'write arithmetic over names in quotes, such as "2 * flexspline.wall"'
            self.told(path, reason, remedy[0] if remedy else usual, text)
            return None
        try:
            if not expression.names:
                float(expression({}))
        except NO_VALUE as error:
            self.told(path, f"has no value: {error}", "write an expression that has one", text)
        return expression

    def base(self) -> Scene:
        """The scene that all drives share."""
        given = self.tables.get("scene")
        if given is None:
            scene = Scene()
        elif isinstance(given, dict):
            scene = Scene.from_toml(toml_text(given), "[scene]", self.folder)
        elif isinstance(given, str):
            scene = Scene.load(self.folder / given)
        else:
            self.told("scene", "is no file name", 'write scene = "FILE.toml" before the first table', given)
            return Scene()
        changes = dict(self.paths("set", flat(self.table("set")).items()))
        # of other keys the scene's own file says where files are
        own = {*changes, *(flat(given) if isinstance(given, dict) else ())}
        return placed(scene.with_(changes) if changes else scene, self.places, own)

    def files(self) -> dict[str, str]:
        """Where the files are that the study names: of its folder, the copies there."""
        table = self.table("files")
        if "files" in self.tables and not TABLE.search(self.text):
            self.told("files", "is no table of its own", "write [files] on a line of its own")
        for name, place in table.items():
            if not isinstance(place, str):
                self.told(f"files.{name}", "is no file name", 'write NAME = "FILE.csv"', place)
        self.places = {name: place for name, place in table.items() if isinstance(place, str)}
        return self.places

    def vary(self) -> tuple[list[Key], dict[str, Expression]]:
        """Keys and links of [vary]."""
        keys, links = [], {}
        if not self.table("vary"):
            self.told(
                "vary", "nothing varies", 'write [vary] and a key, such as "tilt.angle_deg" = { from = 0, to = 1 }'
            )
        fixed, met = flat(self.table("set")), set()
        for path, spec in self.paths("vary", _specs(self.table("vary"))):
            if path in met:
                self._twice(f"vary.{path}")
                continue
            met.add(path)
            if "." not in path and (name := as_name(path)) != path:
                self.told(f"vary.{path}", "is no name that an expression can use", f"write another one, such as {name}")
            if path in fixed:
                self.told(f"vary.{path}", "the key stands under [set] too", "remove one of them")
            if isinstance(spec, str):
                expression = self.expression(f"vary.{path}", spec)
                if expression is not None:
                    links[path] = expression
            elif isinstance(spec, dict):
                key = read_key(path, spec, lambda reason, remedy: self.told(f"vary.{path}", reason, remedy))
                if key is not None:
                    keys.append(key)
            elif isinstance(spec, list):
                self.told(f"vary.{path}", "is a list without its law", f"write {{ list = {written(spec)} }}", spec)
            else:
                link = f'write {path} = "{written(spec)}"' if is_number(spec) else "remove it"
                remedy = "write it under [set]" if "." in path else link
                self.told(f"vary.{path}", "a single value does not vary", remedy, spec)
        return keys, links

    def _twice(self, path: str) -> None:
        """A key that stands in the file twice: quoted, and in a table of its own."""
        lines = self.text.split("\n")
        lines[fault_at(self.lines, path, "", "").line - 1] = ""
        second = fault_at(lines_of("\n".join(lines)), path, "", "").line
        self.told(path, f"the key stands in line {second} too" if second else "the key is given twice", "remove one")

    def ordered(self, links: dict[str, Expression]) -> tuple[tuple[str, Expression], ...]:
        """Links in an order in which each finds its names."""
        try:
            order = list(TopologicalSorter({path: link.names for path, link in links.items()}).static_order())
        except CycleError as error:
            ring = " -> ".join(map(str, error.args[1]))
            self.told(f"vary.{error.args[1][0]}", f"the links go in a circle: {ring}", "give one of them a law")
            return ()
        return tuple((path, links[path]) for path in order if path in links)

    def compute(self) -> tuple[list[tuple[str, Mapping[str, Any]]], bool, int]:
        """Verbs and their options."""
        table = self.table("compute", ("verb", "errors", "survivors", *VERBS))
        words = table.get("verb", "solve")
        words = [words] if isinstance(words, str) else words
        if not isinstance(words, list) or not words or any(word not in VERBS for word in words):
            remedy = f"write one of {', '.join(VERBS)}, or a list of them"
            self.told("compute.verb", "unknown verb", remedy, table["verb"])
            close = [get_close_matches(str(word), VERBS, 1) for word in words] if isinstance(words, list) else []
            words = list(dict.fromkeys(word for each in close for word in each)) if all(close) else []  # what is meant
        errors = table.get("errors", False)
        if not isinstance(errors, bool):
            self.told("compute.errors", "must be true or false", "write errors = true", errors)
        options = {word: self.options(word, table.get(word, {})) for word in VERBS if word in table or word in words}
        for word in VERBS:
            if words and word in table and word not in words:
                remedy = f"write verb = {written([*words, word])}, or remove it"
                self.told(f"compute.{word}", "options of a verb that is not computed", remedy)
        verbs: list[tuple[str, Mapping[str, Any]]] = [(word, options[word]) for word in words]
        return verbs, bool(errors), self.count(table, "compute.survivors", 0)

    def options(self, verb: str, options: object) -> dict[str, Any]:
        """Options of a verb."""
        if not isinstance(options, dict):
            self.told(f"compute.{verb}", "is no table", f"write {verb} = {{ OPTION = VALUE }}", options)
            return {}
        known = known_options(verb)
        for option, value in options.items():
            path = f"compute.{verb}.{option}"
            if option not in known:
                remedy = near(option, known) if known else f"remove it: {verb} has no options"
                self.told(path, "unknown option", remedy, value)
            elif not fits(value, known[option]):
                self.told(path, "is of another type", f"write {in_words(known[option])}", value)
            elif isinstance(value, list) and len(value) > 1 and option != "best_deg":
                self.told(path, "a drive has one case", "write one value, vary the key", value)
        kept = dict(options)
        if (measured := kept.pop("measured", None)) and isinstance(measured, str):
            kept["measured"] = str(self.folder / self.places.get(measured, measured))
        return kept

    def figures(self, verbs: list[str]) -> list[tuple[str, Expression]]:
        """Names of the study for figures of the results."""
        found = []
        table = self.table("figures")
        wanted = list(verbs)
        if not table:
            self.told("figures", "no figure is wanted", 'write [figures] and a name, such as land = "solve.land_width"')
        for name, text in table.items():
            if isinstance(text, dict):
                text = self._value_with_unit(f"figures.{name}", text)
            expression = self.expression(f"figures.{name}", text)
            if name in _TAKEN:
                self.told(f"figures.{name}", "the rows have a column of this name already", "write another name")
            if not re.fullmatch(r"[A-Za-z]\w*", name) or name.endswith("_error"):
                self.told(
                    f"figures.{name}", "is no name of a figure", "write letters, digits and _; not _error at its end"
                )
            for used in expression.names if expression else ():
                verb = used.split(".")[0]
                if verbs and verb in VERBS and verb not in verbs:
                    wanted += [verb] * (verb not in wanted)
                    remedy = f"write verb = {written(wanted)} under [compute]"
                    self.told(f"figures.{name}", f"{verb} is not computed", remedy, text)
            if expression:
                found.append((name, expression))
        return found

    def _value_with_unit(self, path: str, item: Mapping[str, Any]) -> object:
        """The expression of a figure that has a unit."""
        for word in set(item) - {"value", "unit"}:
            self.told(path, f"unknown word {word}", near(word, ("value", "unit")), item)
        if not isinstance(item.get("unit", ""), str):
            self.told(path, "the unit is no text in quotes", 'write unit = "um"', item)
        return item.get("value", item)

    def columns(self, paths: Iterable[str], figures: list[str]) -> None:
        """Rows have one column for each key and link, two for each figure, and some of their own."""
        taken = {*_TAKEN, *figures, *(f"{name}_error" for name in figures)}
        for path in paths:
            if path in taken:
                self.told(f"vary.{path}", "the rows have a column of this name already", "write another name")

    def constraints(self, figures: Any) -> dict[str, tuple[float, float]]:
        """Limits of figures."""
        found = {}
        for name, limits in self.table("constraints").items():
            place = f"constraints.{name}"
            if name not in figures:
                self.told(place, "no figure of the study", near(name, figures))
            if not isinstance(limits, dict) or not limits or set(limits) - {"min", "max"}:
                self.told(place, "no limits", "write { min = A }, { max = B } or both", limits)
            elif not all(map(is_number, limits.values())):
                self.told(place, "a limit is no number", "write { min = A, max = B }", limits)
            elif limits.get("min", -float("inf")) >= limits.get("max", float("inf")):
                self.told(place, "min is not below max", "write a min below the max", limits)
            else:
                found[name] = float(limits.get("min", "-inf")), float(limits.get("max", "inf"))
        return found

    def objectives(self, figures: Any) -> dict[str, int]:
        """What is better: 1 for the smaller figure, -1 for the larger one."""
        found = {}
        for name, aim in self.table("objectives").items():
            if name not in figures:
                self.told(f"objectives.{name}", "no figure of the study", near(name, figures))
            if aim not in ("min", "max"):
                self.told(f"objectives.{name}", "no aim", 'write "min" or "max"', aim)
            else:
                found[name] = 1 if aim == "min" else -1
        return found
