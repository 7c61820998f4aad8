# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs a study: the drive in the middle, sample, survivors."""

from __future__ import annotations

import os
import time
import warnings
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import suppress
from itertools import islice
from pathlib import Path
from random import Random
from typing import Any, NamedTuple

from .._arguments import checked
from .._errors import Fault, NumericalError
from ._drive import Row, Sample, careful_rows, figures_of, lean_options
from ._engine import SHARD_SECONDS, compute_rows, engine, is_address
from ._faults import UncheckedNames, fault_at, lines_of, near, refuse
from ._keys import Value
from ._options import known_options
from ._probe import absent_key
from ._progress import Told
from ._read import load_recipe, unread_files
from ._recipe import Recipe
from ._shards import schema_of, write_shard
from ._store import Folder

_LOOKED_AT = 200  # drives of the sample, where the one in the middle cannot be made
_TRIES = 8  # of these, which are computed until one can be made
_TRY_SECONDS = 30.0  # after these no other one is tried


class First(NamedTuple):
    """What the drive in the middle of all that varies says."""

    row: Row
    units: dict[str, str]
    seconds: float
    unchecked: str
    """Why the names of figures are not checked; empty where they are."""


def first_drive(recipe: Recipe) -> First:
    """Computes the drive in the middle; where it cannot be made, a few others of the sample, for the names of figures.

    Raises
    ------
    InputError
        A name under [figures] is no figure of the result, or a verb refuses its options.
    """
    refuse(unread_files(recipe))
    begin = time.perf_counter()
    rows, units = careful_rows(recipe, [(0, recipe.first)], recipe.errors)
    seconds, row = time.perf_counter() - begin, rows[0]
    options = {option for verb, _ in recipe.verbs for option in known_options(verb)}
    if row["code"] == "scene" and (row["place"] in options or row["place"].startswith("read_measured(")):
        refuse([Fault("compute", 0, "", f"{row['place']}: {row['cause']}", "mend the options of the verb")])
    is_checked, tried = shows_names(recipe, rows), 0
    for other in islice(_others(recipe), 0 if is_checked else _TRIES):
        if is_checked or time.perf_counter() > begin + _TRY_SECONDS:
            break
        is_checked, tried = shows_names(recipe, careful_rows(recipe, [other], False)[0]), tried + 1
    what = "the drive in the middle" + f" and {tried} more" * bool(tried)
    why = f"{what} cannot be made, so the names of figures are unchecked: {fault_of(row)}"
    return First(row, units, seconds, "" if is_checked else why)


def _others(recipe: Recipe) -> Iterator[Sample]:
    """Some drives of the sample, but the one in the middle, whose scenes have no fault."""
    for number in Random(0).sample(range(recipe.drives), min(_LOOKED_AT, recipe.drives)):
        values = recipe.values(number)
        with suppress(NumericalError):  # of a link
            if values != recipe.first and not recipe.scene_of(recipe.linked(values)).check():
                yield number, values


def shows_names(recipe: Recipe, rows: Sequence[Row]) -> bool:
    """Whether one of some drives can be made; it shows which names figures have, and others are refused."""
    codes = [row["code"] for row in rows]
    if "figure" in codes and "" not in codes:
        _refuse_figures(recipe, recipe.restored(rows[codes.index("figure")]))
    return "" in codes or "figure" in codes


def _refuse_figures(recipe: Recipe, values: Mapping[str, Value]) -> None:
    """Names every figure that a drive does not have, and those that have the name of a key of the scene.

    One that has no value for that drive is no fault.
    """
    linked = recipe.linked(values)
    figures, lines = _figures_of(recipe, linked), lines_of(recipe.text)
    keys = _known_keys(recipe, linked)
    known, both, scene = keys | figures, keys & figures, recipe.scene_of(linked)
    refuse([
        fault_at(lines, f"figures.{name}", f"{used} is a key of the scene and a figure",
                 f'write a name for the key under [vary], such as x = "{used}", and x here', expression.text)
        if used in both else
        fault_at(lines, f"figures.{name}", f"unknown figure {used}",
                 absent_key(scene, used) or near(used, sorted(known)), expression.text)
        for name, expression in recipe.figures for used in expression.names if used in both or used not in known
    ])  # fmt: skip


def _known_keys(recipe: Recipe, linked: Mapping[str, Value]) -> set[str]:
    """Keys and names that the expressions under [figures] may use."""
    words = {key.path for key in recipe.keys if key.law == "list" and set(map(type, key.values)) == {str}}
    return {*recipe.constants, *linked} - words


def _figures_of(recipe: Recipe, linked: Mapping[str, Value]) -> set[str]:
    import hdconj

    scene = recipe.scene_of(linked)
    names: set[str] = set()
    for verb, options in recipe.verbs:
        result = getattr(hdconj, verb)(scene, **options, **lean_options(verb, False))
        names |= set(figures_of(verb, result, False)[0])
    return names


def check(study: str | os.PathLike[str] | Recipe) -> Recipe:
    """Read a study and compute the drive in the middle of all that varies; InputError names every fault.

    A warning says where neither this drive nor a few others can be made, so that the names of figures are unchecked.
    """
    recipe = study if isinstance(study, Recipe) else load_recipe(study)
    _warn(first_drive(recipe).unchecked)
    return recipe


def _warn(unchecked: str) -> None:
    if unchecked:
        warnings.warn(unchecked, UncheckedNames, stacklevel=3)


@checked
def run(
    study: str | os.PathLike[str] | Recipe, folder: str | os.PathLike[str], *, jobs: int = 0,
    scheduler: str | None = None, shard_seconds: float = SHARD_SECONDS, progress: bool = True,
) -> Told:  # fmt: skip
    """Compute a study into a folder; where rows are there already, the others.

    Parameters
    ----------
    study : path
        STUDY.toml (docs/reference/study.md).
    folder : path
        Made where it is not there.
    jobs : int
        Processes of this machine; 0: as many as it has cores.
    scheduler : str, optional
        Address of a Dask scheduler instead.
    shard_seconds : float
        Time of one shard, 2 to 60 s. No row depends on it.
    progress : bool
        A bar on a terminal.

    Returns
    -------
    Told
        Counts of the drives that were computed now.

    Raises
    ------
    InputError
        The study has faults, or the folder is another study's or in use.
    EngineLost, FileError
        The scheduler went away, or the disk is full: run again to resume.
    """
    refuse_machine(jobs, shard_seconds, scheduler)
    given = study if isinstance(study, Recipe) else load_recipe(study)
    place = Folder(folder)
    with place.locked():
        recipe, about = prepare(place, given, "run")
        samples = _Samples(recipe, place.missing(recipe, range(recipe.drives)))
        with lazily(samples or recipe.survivors, jobs, scheduler) as client:
            told = compute_rows(
                client, recipe, samples, place.rows, about, errors=recipe.errors,
                seconds=about["seconds_of_first"], shard_seconds=shard_seconds, shown=progress,
                look=look_for_names(place, given, about),
            ) if samples else Told()  # fmt: skip
            if recipe.survivors and not recipe.errors:
                compute_survivors(client, place, recipe, shard_seconds, progress)
    return told


class _Samples(Sequence[Sample]):
    """Drives of a recipe, each made where it is asked for: all of them would take much memory."""

    def __init__(self, recipe: Recipe, numbers: Sequence[int]) -> None:
        self.recipe, self.numbers = recipe, numbers

    def __len__(self) -> int:
        return len(self.numbers)

    def __getitem__(self, place: Any) -> Any:
        return self.numbers[place], self.recipe.values(self.numbers[place])


def refuse_machine(jobs: int, shard_seconds: float, scheduler: str | None) -> None:
    """Refuses numbers of processes and seconds that cannot be, and what is no address."""
    faults = []
    if scheduler is not None and not is_address(scheduler):
        reason = "is no address of a scheduler"
        faults.append(Fault("scheduler", 0, scheduler, reason, "write tcp://HOST:PORT, such as tcp://host:8786"))
    if jobs < 0:
        remedy = "write 0 for all cores, or a number from 1"
        faults.append(Fault("jobs", 0, str(jobs), "is no number of processes", remedy))
    if not 2 <= shard_seconds <= 60:
        reason = "is no time of a shard"
        faults.append(Fault("shard_seconds", 0, str(shard_seconds), reason, "write a number from 2 to 60"))
    refuse(faults)


def lazily(needed: Any, jobs: int, scheduler: str | None) -> Any:
    """The engine where it is needed, else nothing."""
    from contextlib import nullcontext

    return engine(jobs, scheduler) if needed else nullcontext()


def prepare(place: Folder, recipe: Recipe, kind: str) -> tuple[Recipe, dict[str, Any]]:
    """Makes the folder the study's and computes the first drive, once.

    The recipe that comes back is what workers take: it reads files of numbers from the folder.
    """
    is_new = not (place.place / "study.json").exists() or "first" not in place.about()
    first = first_drive(recipe) if is_new else None
    about = place.begin(recipe, kind)
    if first is not None:
        write_shard(place.part("first"), [first.row], schema_of(recipe), {"units": first.units})
        about |= {"seconds_of_first": first.seconds, "units": first.units, "first": fault_of(first.row)}
        about["unchecked"] = first.unchecked
        place.note(about)
    _warn(about.get("unchecked", ""))
    about.setdefault("seconds_of_first", 1.0)
    return load_recipe(place.place.resolve() / "study.toml") if recipe.files else recipe, about


def look_for_names(place: Folder, recipe: Recipe, about: dict[str, Any]) -> Callable[[Sequence[Row]], None]:
    """What looks at rows while names of figures are unchecked: the first drive that can be made shows them."""

    def look(rows: Sequence[Row]) -> None:
        if about.get("unchecked") and shows_names(recipe, rows):
            about["unchecked"] = ""
            place.note(about)

    return look


def fault_of(row: Row) -> str:
    """Why a drive could not be made, or which figure it lacks; empty where it was made."""
    said = ("place", "cause") if row["code"] in ("figure", "link") else ("code", "place", "cause")
    return ": ".join(str(row[word]) for word in said) if row["code"] else ""


def compute_survivors(client: Any, place: Folder, recipe: Recipe, shard_seconds: float, progress: bool) -> Told:
    """Computes the best drives once more, with errors."""
    from ._study import open as open_study

    best = open_study(place.place).candidates(recipe.survivors)
    folder = place.part("survivors")
    chosen: Sequence[int] = sorted(int(number) for number in best["sample"])
    values = {int(row["sample"]): recipe.restored(row) for row in best.to_dict("records")}
    samples = [(number, values[number]) for number in place.missing(recipe, chosen, folder)]
    if not samples:
        return Told()
    return compute_rows(
        client, recipe, samples, folder, place.about(), errors=True, seconds=5, shard_seconds=shard_seconds,
        what="survivors", shown=progress,
    )  # fmt: skip
