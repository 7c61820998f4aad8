# SPDX-License-Identifier: GPL-3.0-or-later
"""One drive of a study: from the values of its keys to a row. This is what workers run."""

from __future__ import annotations

import inspect
import math
import pickle
import subprocess
import sys
from collections.abc import Collection, Iterator, Mapping, Sequence
from functools import lru_cache
from typing import Any

import numpy as np

import hdconj

from .. import _core
from .._errors import FileError, InputError, NumericalError
from ._expression import NO_VALUE, Expression
from ._keys import Value
from ._recipe import Recipe

Row = dict[str, Any]
Sample = tuple[int, Mapping[str, Value]]
KILLED = "killed-worker"
MADE = {"code": "", "stage": "", "place": "", "cause": ""}
_KEPT = 6  # responses of cups and bearings that a worker keeps for the next drives; a drive has four
_TRIES = 3  # of a drive that kills its process: another process might have been the reason
# What the figures with one value stand over: a drive has one case, of several torques the largest is the last, and
# beside a measured value stands its error.
_SINGLE = ((), ("case",), ("state",), ("estimate",))


def _columns_of(group: tuple[Any, ...], path: str) -> Iterator[str]:
    """Figures in a group, as the extension gives it, that have a value for each slice, each member, each optimum."""
    _, datasets, links, groups, figures = group
    for name, place, _, _, _, is_attribute in figures:
        if not is_attribute and datasets[links.get(place, place)][3] not in _SINGLE:
            yield f"{path}.{name}"
    for name, inner in groups.items():
        yield from _columns_of(inner, f"{path}.{name}")


def figures_of(
    verb: str, result: Any, errors: bool, wanted: Collection[str] | None = None
) -> tuple[dict[str, float], dict[str, float], dict[str, str]]:
    """Values, errors and units of all single figures of a result, under names that begin with the verb.

    It reads what the extension gives: the arrays of a result, which nobody asks for here, take as long as a solve.
    ``wanted`` names figures; what needs arrays is left out where none such is there: the length of the conjugate zones,
    and figures of inner groups, which may have several values.
    """
    values, estimates, units = {}, {}, {}
    rows = result._made.figures()
    zones = f"{verb}.conjugate_zone_length"
    wants_zones = wanted is None or zones in wanted
    wants_inner = wanted is None or any(name.startswith(f"{verb}.") and name.count(".") > 1 for name in wanted)
    groups = result._made.layout()[3] if wants_zones or wants_inner else {}
    columns = set(_columns_of(groups[result._main], verb)) if wants_inner and result._main else set()
    for part in ("", "summary", result._main):
        for group, name, value, error, unit in rows:
            head, _, inner = group.partition("/")
            path = ".".join([verb, *inner.split("/"), name] if inner else [verb, name])
            if head != part or (inner and not (wants_inner and head == result._main)) or path in columns:
                continue
            values[path], units[path] = value, unit
            if not errors:
                estimates[path] = float("nan")
            elif error is not None:
                estimates[path] = error
    if wants_zones and "conjugate_zones" in groups:
        datasets = groups["conjugate_zones"][1]
        phi, on_boundary = (np.asarray(datasets[name][0]) for name in ("phi", "on_boundary"))
        values[zones] = float(np.abs(np.diff(phi, axis=1))[:, 0][on_boundary != 0].sum())
        estimates[zones], units[zones] = float("nan"), "rad"
    return values, estimates, units


@lru_cache
def lean_options(verb: str, errors: bool) -> dict[str, bool]:
    """Options with which a verb computes nothing but figures, and ``errors`` where it can leave them out."""
    lean = {"errors": errors, "advice": False}
    return {key: lean[key] for key in inspect.signature(getattr(hdconj, verb)).parameters if key in lean}


def compute(recipe: Recipe, values: Mapping[str, Value], errors: bool) -> tuple[Row, dict[str, str]]:
    """The row of a drive, without its number, and units of its figures; raises what the verbs raise.

    Where a figure has no value the others stay, and the row has the code ``figure`` and the name of the first such one.
    """
    linked = recipe.linked(values)
    scene = recipe.scene_of({**linked, "solver.threads": 1})
    known: dict[str, Any] = {k: v for k, v in {**recipe.constants, **linked}.items() if not isinstance(v, str)}
    keys = frozenset(known)
    estimates: dict[str, float] = {}
    units: dict[str, str] = {}
    for verb, options in recipe.verbs:
        call = getattr(hdconj, verb)
        lean = lean_options(verb, errors)
        result = call(scene, **options, **lean)
        if result.missing:
            raise NumericalError("missing-case", verb, "the only case", "; ".join(result.missing))
        own, own_errors, own_units = figures_of(verb, result, lean.get("errors", True), recipe.figure_names)
        known |= own
        estimates |= own_errors
        units |= own_units
    row: Row = {**linked, **MADE}
    both = keys & units.keys()
    for name, expression in recipe.figures:
        try:
            if clash := both.intersection(expression.names):
                raise ValueError(f"{min(clash)} is a key of the scene and a figure")
            value, error = expression.with_error(known, estimates)
            if not math.isfinite(value):
                raise ValueError("is no finite number")
            row |= {name: value, f"{name}_error": error}
        except NO_VALUE as why:
            cause = f"{why.args[0]} has no number here" if isinstance(why, KeyError) else str(why)
            if not row["code"]:
                row |= failure(NumericalError("figure", "figures", name, f"{expression.text}: {cause}"))
    found = {name: units.get(expression.text.strip(), "") for name, expression in recipe.figures}
    return row, {**found, **recipe.units}


def failure(error: BaseException, links: Sequence[tuple[str, Expression]] = ()) -> dict[str, str]:
    """Code, stage, place and cause of what a drive raised; a value of a link that no scene takes is the link's."""
    if isinstance(error, NumericalError):
        return {"code": error.code, "stage": error.stage, "place": error.place, "cause": error.cause}
    if isinstance(error, InputError):
        for path, link in links:
            if fault := next((each for each in error.faults if each.path == path and each.kind == "value"), None):
                cause = f"{link.text} gives {fault.value}: {fault.reason}"
                return {"code": "link", "stage": "study", "place": path, "cause": cause}
        fault = error.faults[0]
        return {"code": "scene", "stage": "check", "place": fault.path, "cause": fault.reason}
    code = "memory" if isinstance(error, MemoryError) else "file" if isinstance(error, FileError) else "value"
    return {"code": code, "stage": "study", "place": type(error).__name__, "cause": str(error)}


def row_of(recipe: Recipe, sample: Sample, errors: bool) -> tuple[Row, dict[str, str]]:
    """The row of a drive, made or not."""
    number, values = sample
    try:
        row, units = compute(recipe, values, errors)
        return {"sample": number, **row}, units
    except (InputError, NumericalError, FileError, ArithmeticError, ValueError, MemoryError) as error:
        return {"sample": number, **_known(recipe, values), **failure(error, recipe.links)}, {}


def _known(recipe: Recipe, values: Mapping[str, Value]) -> Row:
    """Values of a drive that cannot be made, links where all have values."""
    try:
        return dict(recipe.linked(values))
    except NumericalError:
        return dict(values)


def rows_of(recipe: Recipe, samples: Sequence[Sample], errors: bool) -> tuple[list[Row], dict[str, str]]:
    """Rows of several drives, in order, and the units of their figures."""
    _core.keep_elastic_bodies(_KEPT)
    rows: list[Row] = []
    units: dict[str, str] = {}
    for sample in samples:
        row, own = row_of(recipe, sample, errors)
        rows.append(row)
        units |= own
    return rows, units


def careful_rows(recipe: Recipe, samples: Sequence[Sample], errors: bool) -> tuple[list[Row], dict[str, str]]:
    """As :func:`rows_of` in a process of its own. Where that is killed, each half is tried, down to the drive."""
    tries = _TRIES if len(samples) == 1 else 1
    for _ in range(tries):
        task = pickle.dumps((recipe, list(samples), errors))
        # In a group of its own: Ctrl-C is for the process that waits, which then ends it.
        words = [sys.executable, "-m", "hdconj.study._child"]
        done = subprocess.run(words, input=task, stdout=subprocess.PIPE, process_group=0)
        if done.returncode == 0:
            rows, units = pickle.loads(done.stdout)
            return rows, units
    if len(samples) == 1:
        number, values = samples[0]
        cause = f"signal {-done.returncode}" if done.returncode < 0 else f"exit status {done.returncode}"
        killed = {"code": KILLED, "stage": "study", "place": "process", "cause": cause}
        return [{"sample": number, **_known(recipe, values), **killed}], {}
    half = len(samples) // 2
    parts = [careful_rows(recipe, part, errors) for part in (samples[:half], samples[half:])]
    return parts[0][0] + parts[1][0], parts[0][1] | parts[1][1]
