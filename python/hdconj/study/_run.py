# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs a study: the drive in the middle, sample, survivors."""

from __future__ import annotations

import os
import time
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from .._arguments import checked
from .._errors import Fault
from ._drive import Row, Sample, careful_rows, figures_of, lean_options
from ._engine import SHARD_SECONDS, compute_rows, engine, is_address
from ._faults import fault_at, lines_of, near, refuse
from ._options import known_options
from ._progress import Told
from ._read import load_recipe, unread_files
from ._recipe import Recipe
from ._shards import schema_of, write_shard
from ._store import Folder


def first_drive(recipe: Recipe) -> tuple[Row, dict[str, str], float]:
    """The row of the drive in the middle of all that varies, its units, and seconds.

    Raises
    ------
    InputError
        A name under [figures] is no figure of the result, or a verb refuses its options.
    """
    refuse(unread_files(recipe))
    begin = time.perf_counter()
    rows, units = careful_rows(recipe, [(0, recipe.first)], recipe.errors)
    row = rows[0]
    if row["code"] == "figure":
        _refuse_figures(recipe)
    options = {option for verb, _ in recipe.verbs for option in known_options(verb)}
    if row["code"] == "scene" and (row["place"] in options or row["place"].startswith("read_measured(")):
        refuse([Fault("compute", 0, "", f"{row['place']}: {row['cause']}", "mend the options of the verb")])
    return row, units, time.perf_counter() - begin


def _refuse_figures(recipe: Recipe) -> None:
    """Names every figure that the first drive does not have, and those that have the name of a key of the scene.

    One that has no value for that drive is no fault.
    """
    figures, lines = _figures_of_first(recipe), lines_of(recipe.text)
    keys = _known_keys(recipe)
    known, both = keys | figures, keys & figures
    refuse([
        fault_at(lines, f"figures.{name}", f"{used} is a key of the scene and a figure",
                 f'write a name for the key under [vary], such as x = "{used}", and x here', expression.text)
        if used in both else
        fault_at(lines, f"figures.{name}", f"unknown figure {used}", near(used, sorted(known)), expression.text)
        for name, expression in recipe.figures for used in expression.names if used in both or used not in known
    ])  # fmt: skip


def _known_keys(recipe: Recipe) -> set[str]:
    """Keys and names that the expressions under [figures] may use."""
    words = {key.path for key in recipe.keys if key.law == "list" and set(map(type, key.values)) == {str}}
    return {*recipe.constants, *recipe.linked(recipe.first)} - words


def _figures_of_first(recipe: Recipe) -> set[str]:
    import hdconj

    scene = recipe.scene_of(recipe.linked(recipe.first))
    names: set[str] = set()
    for verb, options in recipe.verbs:
        result = getattr(hdconj, verb)(scene, **options, **lean_options(verb, False))
        names |= set(figures_of(verb, result, False)[0])
    return names


def check(study: str | os.PathLike[str] | Recipe) -> Recipe:
    """Read a study and compute the drive in the middle of all that varies; InputError names every fault."""
    recipe = study if isinstance(study, Recipe) else load_recipe(study)
    first_drive(recipe)
    return recipe


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
    recipe = study if isinstance(study, Recipe) else load_recipe(study)
    place = Folder(folder)
    with place.locked():
        recipe, about = prepare(place, recipe, "run")
        samples = _Samples(recipe, place.missing(recipe, range(recipe.drives)))
        with lazily(samples or recipe.survivors, jobs, scheduler) as client:
            told = compute_rows(
                client, recipe, samples, place.rows, about, errors=recipe.errors,
                seconds=about["seconds_of_first"], shard_seconds=shard_seconds, shown=progress,
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
        write_shard(place.part("first"), [first[0]], schema_of(recipe), {"units": first[1]})
        about |= {"seconds_of_first": first[2], "units": first[1], "first": fault_of(first[0])}
        place.note(about)
    about.setdefault("seconds_of_first", 1.0)
    return load_recipe(place.place.resolve() / "study.toml") if recipe.files else recipe, about


def fault_of(row: Row) -> str:
    """Why a drive could not be made; empty where it was."""
    return ": ".join(str(row[word]) for word in ("code", "place", "cause")) if row["code"] else ""


def compute_survivors(client: Any, place: Folder, recipe: Recipe, shard_seconds: float, progress: bool) -> Told:
    """Computes the best drives once more, with errors."""
    from ._study import open as open_study

    best = open_study(place.place).best(recipe.survivors, again=False)
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
