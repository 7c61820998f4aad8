# SPDX-License-Identifier: GPL-3.0-or-later
"""Search for the best drives by pymoo; every generation is computed as the samples of a study are."""

from __future__ import annotations

import io
import os
from importlib import import_module
from pathlib import Path
from typing import Any

import numpy as np

from .._arguments import checked
from .._errors import Fault
from ._drive import Sample
from ._engine import SHARD_SECONDS, compute_rows, engine
from ._faults import refuse
from ._progress import Told
from ._read import NO_OBJECTIVES, load_recipe
from ._recipe import Recipe
from ._run import compute_survivors, look_for_names, prepare, refuse_machine
from ._shards import write_whole
from ._store import Folder
from ._study import Study

WORST = 1e30  # objective and violation of a drive that cannot be made
# Why an algorithm of pymoo ends before it has made all its generations.
ENDS = {
    "nsga2": "NSGA-II makes no drive any more that it has not made before",
    "cmaes": "the drives of CMA-ES differ too little to go on",
}


def _module(name: str) -> Any:
    """A module of pymoo, whose functions have no types."""
    return import_module(f"pymoo.{name}")


class Search:
    """An algorithm of pymoo over numbers from 0 to 1: asked for a generation, told what it is worth.

    What it asks depends on the seed and on what it was told, so that it goes on where it was when it is told all of
    that again.
    """

    def __init__(self, recipe: Recipe) -> None:
        options = recipe.optimise
        population = int(options["population"])
        self.takes_constraints, self.worst = options["method"] != "cmaes", -np.inf
        self.problem = _module("core.problem").Problem(
            n_var=len(recipe.keys), n_obj=len(recipe.objectives), n_ieq_constr=int(self.takes_constraints), xl=0.0,
            xu=1.0,
        )  # fmt: skip
        if options["method"] == "nsga2":
            self.algorithm = _module("algorithms.moo.nsga2").NSGA2(pop_size=population)
        elif options["method"] == "cmaes":
            kind = _module("algorithms.soo.nonconvex.cmaes").CMAES
            # A generation of equal drives, such as of none that can be made, widens the search and does not end it.
            endless = {"tolfun": 0, "tolx": 0, "tolfunhist": 0, "tolflatfitness": np.inf}
            self.algorithm = kind(pop_size=population, sigma=0.25, **endless)
            self.algorithm.n_sample_points = population  # of its first generation
        else:
            self.algorithm = _module("algorithms.soo.nonconvex.random_search").RandomSearch(
                n_points_per_iteration=population
            )
        never = _module("core.termination").NoTermination()
        self.algorithm.setup(self.problem, termination=never, seed=int(options["seed"]), verbose=False)
        self.asked: Any = None

    def ask(self) -> Any:
        """Numbers from 0 to 1, one row for each drive of the next generation; None where the search has ended."""
        self.asked = self.algorithm.ask() if self.algorithm.has_next() else None
        return None if self.asked is None else np.clip(np.asarray(self.asked.get("X"), dtype=float), 0, 1)

    def tell(self, values: Any, violation: Any) -> None:
        """Takes objectives, all to be as small as possible, and by how much each drive breaks the constraints."""
        known = {"F": np.where(np.isfinite(values), values, WORST)}
        if self.takes_constraints:
            known["G"] = violation[:, None]
        else:
            known["F"] = self._penalised(known["F"], violation[:, None])
        problem = _module("problems.static").StaticProblem(self.problem, **known)
        _module("core.evaluator").Evaluator().eval(problem, self.asked)
        self.algorithm.tell(infills=self.asked)

    def _penalised(self, values: Any, violation: Any) -> Any:
        """Objectives in which a drive that breaks a constraint is worse than all so far that keep them.

        pymoo gives CMA-ES the same infinite objective for all drives that break a constraint, which leads nowhere.
        """
        keeps = violation == 0
        self.worst = max(self.worst, float(values[keeps].max(initial=-np.inf)))
        worst = self.worst if np.isfinite(self.worst) else 0.0
        return np.where(keeps, values, worst + (abs(worst) or 1.0) * (1 + violation))


def violation(study: Study, rows: Any) -> Any:
    """By how much rows break the constraints in all, as shares of the limits; 0 where they keep them."""
    found = np.zeros(len(rows))
    for name, (low, high) in study.recipe.constraints.items():
        value = np.asarray(rows[name], dtype=float)
        for limit, over in ((low, low - value), (high, value - high)):
            if np.isfinite(limit):
                found += np.maximum(over, 0) / (abs(limit) or 1.0)
    return np.where(study.made(rows) & np.isfinite(found), found, WORST)


@checked
def optimise(
    study: str | os.PathLike[str] | Recipe, folder: str | os.PathLike[str], *, jobs: int = 0,
    scheduler: str | None = None, shard_seconds: float = SHARD_SECONDS, progress: bool = True,
) -> Told:  # fmt: skip
    """Search for the best drives of a study; where generations are there already, go on.

    Parameters
    ----------
    study : path
        STUDY.toml with [objectives] and perhaps [optimise].
    folder, jobs, scheduler, shard_seconds, progress
        As for :func:`hdconj.study.run`.

    Returns
    -------
    Told
        Counts of the drives that were computed now. The folder holds ``best.toml`` and the scenes of the best
        drives in ``pareto``.
    """
    refuse_machine(jobs, shard_seconds, scheduler)
    given = study if isinstance(study, Recipe) else load_recipe(study)
    if not given.objectives:
        refuse([Fault("objectives", 0, "", *NO_OBJECTIVES)])
    place, told = Folder(folder), Told()
    with place.locked():
        if place.same(given, "optimise"):
            _refuse_other_search(place, given)
        recipe, about = prepare(place, given, "optimise")
        place.part("asked")
        with engine(jobs, scheduler) as client:
            search, first = Search(recipe), 0
            about.pop("ended", None)
            for generation in range(int(recipe.optimise["generations"])):
                units = _asked(place, generation, search.ask())
                if units is None:
                    about["ended"] = _end_of(recipe, generation)
                    break
                numbers = range(first, first + len(units))
                first += len(units)
                samples: list[Sample] = [
                    (number, recipe.values_at(units[number - numbers[0]])) for number in place.missing(recipe, numbers)
                ]
                if samples:
                    now = compute_rows(
                        client, recipe, samples, place.rows, about, errors=recipe.errors,
                        seconds=about["seconds_of_first"], shard_seconds=shard_seconds,
                        what=f"generation {generation + 1}", shown=progress, look=look_for_names(place, given, about),
                    )  # fmt: skip
                    told.done += now.done
                    told.failed += now.failed
                _tell(search, Study(place.place, recipe), numbers)
            if recipe.survivors and not recipe.errors:
                compute_survivors(client, place, recipe, shard_seconds, progress)
        place.note(about)
        write_best(Study(place.place))
    return told


def _end_of(recipe: Recipe, generation: int) -> str:
    """What is said of a search that has ended before its last generation."""
    options = recipe.optimise
    return f"the search ended after {generation} of {options['generations']} generations: {ENDS[options['method']]}"


def _refuse_other_search(place: Folder, recipe: Recipe) -> None:
    """Refuses a study whose search does not ask for the drives that the folder holds; nothing is written."""
    study, search, first = Study(place.place, recipe), Search(recipe), 0
    for generation in range(int(recipe.optimise["generations"])):
        units = search.ask()
        if units is None or not _is_stored(place, generation, units):
            return
        numbers = range(first, first + len(units))
        first += len(units)
        if place.missing(recipe, numbers):
            return
        _tell(search, study, numbers)


def _file_of(place: Folder, generation: int) -> Path:
    return place.place / "asked" / f"{generation:06d}.npy"


def _is_stored(place: Folder, generation: int, units: Any) -> bool:
    """Whether a generation was asked for before; then it must be the same. A damaged file counts as none."""
    try:
        with open(_file_of(place, generation), "rb") as file:
            before = np.lib.format.read_array(file)
    except (FileNotFoundError, ValueError):
        return False
    if not np.array_equal(before, units):
        refuse([Fault(str(place.place), 0, "", "the search asks for other drives than before", "name another folder")])
    return True


def _asked(place: Folder, generation: int, units: Any) -> Any:
    """What the search asks, stored."""
    file = _file_of(place, generation)
    if units is not None and not _is_stored(place, generation, units):
        made = io.BytesIO()
        np.save(made, units)
        write_whole(file, made.getvalue())
    return units


def _tell(search: Search, study: Study, numbers: range) -> None:
    rows = study.frame[study.frame["sample"].isin(numbers)]
    search.tell(study.objectives(rows)[0], violation(study, rows))


def write_best(study: Study) -> list[Path]:
    """Writes the scenes of the best drives: best.toml, and of several objectives all that no other one beats.

    Those of a search before are removed. Nothing is written where no drive keeps all constraints.
    """
    best = study.best(max(len(study.frame), 1))
    folder = study.folder.place
    files = [folder / "best.toml"]
    for old in (folder / "pareto").glob("*.toml"):
        old.unlink()
    if best.empty:
        files[0].unlink(missing_ok=True)
        return []
    values = study.objectives(best)[0]
    spread = np.ptp(values, axis=0)
    distance = ((values - values.min(axis=0)) / np.where(spread > 0, spread, 1)) ** 2
    nearest = best.iloc[int(distance.sum(axis=1).argmin())]
    study.folder.write_scene(files[0], study.recipe, study.values(nearest))
    if len(study.recipe.objectives) > 1:
        pareto = study.folder.part("pareto")
        for row in best.to_dict("records"):
            files.append(pareto / f"sample-{int(row['sample']):06d}.toml")
            study.folder.write_scene(files[-1], study.recipe, study.values(row))
    return files
