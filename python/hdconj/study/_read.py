# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads STUDY.toml, and names every fault at once (docs/reference/study.md)."""

from __future__ import annotations

import os
import tomllib
from pathlib import Path
from typing import Any

from .._errors import Fault, InputError, fault_text
from ._faults import fault_at, lines_of, near, refuse
from ._keys import MOST, Key
from ._probe import ask_names, ask_verbs, probe, refuse_overridden, refuse_unused, settled
from ._recipe import Recipe
from ._sample import METHODS, sample_count
from ._tables import Reader

TABLES = ("scene", "set", "vary", "sample", "compute", "figures", "constraints", "objectives", "optimise", "files")
OPTIMISERS = ("nsga2", "cmaes", "random")
LARGEST_SEED = 10**9
NO_OBJECTIVES = ("nothing says what is better", 'write [objectives], NAME = "min" or "max"')


def _optimise(reader: Reader) -> dict[str, Any]:
    table = reader.table("optimise", ("method", "population", "generations", "seed"))
    population = reader.count(table, "optimise.population", 40, 2, MOST // 2)
    return {
        "method": reader.word(table, "optimise.method", "nsga2", OPTIMISERS),
        "population": population,
        "generations": reader.count(table, "optimise.generations", 25, 1, MOST // population),
        "seed": reader.count(table, "optimise.seed", 1, most=LARGEST_SEED),
    }


def _refuse_unfit_search(reader: Reader, recipe: Recipe) -> None:
    """A table [optimise] that no search can follow, whatever the study is read for."""
    if "optimise" not in reader.tables:
        return
    if not recipe.objectives and not reader.table("objectives"):
        reader.told("optimise", *NO_OBJECTIVES)
    if recipe.optimise["method"] == "cmaes" and len(recipe.objectives) > 1:
        reason = f"takes one objective, not {', '.join(recipe.objectives)}"
        reader.told("optimise.method", reason, "write nsga2, or one figure for both", "cmaes")


def _refuse_too_many(reader: Reader, method: str, count: int, keys: tuple[Key, ...]) -> None:
    """A study has at most MOST drives."""
    drives = sample_count(method, count, keys)
    if drives > MOST and method == "grid":
        reader.told("sample.method", f"the grid has {drives} drives, more than {MOST}", "write fewer points")
    elif drives > MOST:
        most = 2 ** ((MOST // (len(keys) + 2)).bit_length() - 1)
        reason = f"makes {drives} drives, more than {MOST}"
        reader.told("sample.count", reason, f"write at most {most}", count)


def unread_files(recipe: Recipe) -> list[Fault]:
    """Faults of measured curves and of files in lists that cannot be read: a study is read also where they are not."""
    lines = lines_of(recipe.text)
    found = [
        fault_at(lines, f"compute.{verb}.measured", "cannot be read",
                 "name a CSV file, relative to the study's folder", options["measured"])
        for verb, options in recipe.verbs
        if "measured" in options and recipe.tables["compute"][verb]["measured"] not in recipe.measured
    ]  # fmt: skip
    remedy = "name a CSV file, relative to the scene's file"
    for key, name, scene in recipe.worded():
        if scene._core.files.get(key.path, (name, b""))[1] is None:
            found.append(fault_at(lines, f"vary.{key.path}", "cannot be read", remedy, name))
    return found


def _read_tables(reader: Reader, computed: bool) -> Recipe:
    """The recipe, sound as long as the reader has no fault. One that is computed is not asked what its rows tell."""
    for name, value in reader.tables.items():
        if name not in TABLES:
            kind = "table" if isinstance(value, dict) else "key"
            reader.told(name, f"unknown {kind}", near(name, TABLES))
    places = reader.files()
    scene = reader.base()
    keys, links = reader.vary()
    if not keys and links:
        reader.told("vary", "links alone do not vary", "give one key a law")
    sample = reader.table("sample", ("method", "count", "seed"))
    method = reader.word(sample, "sample.method", "sobol", METHODS)
    count = reader.count(sample, "sample.count", 64, 1)
    if method == "grid" and "count" in sample:
        reader.told("sample.count", "a grid counts itself", "remove it, or write count in the keys of [vary]")
    _refuse_too_many(reader, method, count, tuple(keys))
    for key in keys if method == "grid" else ():
        if not key.values:
            reader.told(f"vary.{key.path}", "has no points of a grid", "add count = N, or write a list")
    if method == "saltelli" and count & (count - 1):
        reader.told("sample.count", "must be a power of 2 for the indices of Sobol", "write 64, 128, 256 ...", count)
    verbs, errors, survivors = reader.compute()
    figures = reader.figures([verb for verb, _ in verbs])
    names = [name for name, _ in figures]
    reader.columns([*(key.path for key in keys), *links], names)
    seed = reader.count(sample, "sample.seed", 1, most=LARGEST_SEED)
    recipe = Recipe(
        reader.text, reader.tables, scene, tuple(keys), reader.ordered(links), method, count, seed,
        tuple(verbs), errors, survivors, tuple(figures), reader.constraints(names), reader.objectives(names),
        _optimise(reader), places,
    )  # fmt: skip
    if survivors and not recipe.objectives:
        reader.told("compute.survivors", "nothing says which drives survive", "write [objectives]", survivors)
    there = recipe.data
    for name, content in recipe.measured.items():
        if there.get(name, content) != content:
            reason = "has the name of another file of the scene"
            reader.told("compute.load.measured", reason, "write another name", name)
    probe(reader, scene, recipe)
    if not computed:
        refuse_overridden(reader, recipe)
        _refuse_unfit_search(reader, recipe)
    if recipe.base:
        ask_names(reader, recipe, links)
        if not computed:
            refuse_unused(reader, recipe)
    ask_verbs(reader, recipe)
    return recipe


def read_recipe(
    text: str, name: str = "text", folder: str | os.PathLike[str] = "", computed: bool = False
) -> Recipe:
    """Read a study.

    Parameters
    ----------
    text : str
        TOML (docs/reference/study.md).
    name : str
        How messages call it.
    folder : path
        Where the name of the scene's file starts.
    computed : bool
        Whether its rows are there: names that nothing uses, and options in place of keys that vary, are no fault then.

    Raises
    ------
    InputError
        With every fault; nothing has been computed.
    """
    text = text.removeprefix("\ufeff")  # a byte order mark, which scenes may begin with too
    reader = Reader(text, name, Path(folder))
    try:
        reader.tables = tomllib.loads(text)
    except tomllib.TOMLDecodeError as error:
        refuse([Fault(name, 0, "", f"no TOML: {error}", "mend the line")])
    recipe = _read_tables(reader, computed)
    if reader.faults:
        told = {(fault.path, fault.value) for fault in reader.faults}
        refuse([*reader.faults, *(each for each in unread_files(recipe) if (each.path, each.value) not in told)])
    return settled(recipe)


def load_recipe(file: str | os.PathLike[str], computed: bool = False) -> Recipe:
    """Read a study from a file; see :func:`read_recipe`."""
    try:
        text = Path(file).read_text(encoding="utf-8")
    except (OSError, UnicodeDecodeError) as error:
        reason = error.strerror if isinstance(error, OSError) else "not UTF-8"
        raise InputError(*_single(os.fspath(file), f"cannot be read: {reason}", "name a file of TOML")) from None
    return read_recipe(text, os.fspath(file), Path(file).parent, computed)


def _single(path: str, reason: str, remedy: str) -> tuple[tuple[Fault, ...], str]:
    faults = (Fault(path, 0, "", reason, remedy),)
    return faults, fault_text(faults)
