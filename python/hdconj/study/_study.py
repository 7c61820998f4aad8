# SPDX-License-Identifier: GPL-3.0-or-later
"""What a study has found: tables, best drives, yield, the keys that matter."""

from __future__ import annotations

import os
from bisect import bisect_left
from collections import Counter
from collections.abc import Iterator, Mapping
from functools import cached_property
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt

from .._arguments import checked
from .._files import write_whole
from .._scene import Scene
from ._front import dominated
from ._keys import Value, takes
from ._read import load_recipe
from ._recipe import Recipe
from ._shards import read_shards, schema_of
from ._store import Folder, refuse

Bools = npt.NDArray[np.bool_]
Floats = npt.NDArray[np.float64]


class Study:
    """The folder of a study; see :func:`hdconj.study.open`."""

    def __init__(self, place: str | os.PathLike[str], recipe: Recipe | None = None) -> None:
        self.folder = Folder(place)
        self.about: dict[str, Any] = self.folder.about()
        """Versions, machine, hash of the scene, units of the drive in the middle: what study.json says."""
        self.recipe: Recipe = recipe or load_recipe(Path(place) / "study.toml", computed=True)

    def _shards(self, part: str) -> Iterator[tuple[Any, dict[str, Any]]]:
        """Shards of the drives that the study has now: its count may be less than when they were computed."""
        columns = schema_of(self.recipe).names
        for table, about in read_shards(self.folder.place / part, self.about, columns):
            if self.about["kind"] == "run":
                count = bisect_left(table.column("sample").to_pylist(), self.recipe.drives)
                about = {**about, "seconds": about["seconds"] * count / len(table)}
                table = table.slice(0, count)
            if len(table):
                yield table, about

    def _read(self, part: str) -> Any:
        import pandas
        import pyarrow as pa

        tables = [table.replace_schema_metadata(None) for table, _ in self._shards(part)]
        return pa.concat_tables(tables).to_pandas() if tables else pandas.DataFrame()

    @cached_property
    def frame(self) -> Any:
        """All rows in order of samples, failed drives too, as a ``pandas.DataFrame``.

        Its ``attrs["units"]`` has the units of keys and figures.
        """
        frame = self._read("rows")
        if frame.empty:
            frame = schema_of(self.recipe).empty_table().to_pandas()
        frame.attrs["units"] = self.key_units | self.units
        return frame

    @cached_property
    def units(self) -> dict[str, str]:
        """Units of the figures; where the drive in the middle could not be made, those of the rows."""
        units: dict[str, str] = self.recipe.units | self.about.get("units", {})
        shards = () if all(name in units for name, _ in self.recipe.figures) else self._shards("rows")
        return {name: unit for _, about in shards for name, unit in about["units"].items()} | units

    @cached_property
    def key_units(self) -> dict[str, str]:
        """Units of the keys that vary or follow from a link, as far as the scene's schema knows one."""
        paths = (*(key.path for key in self.recipe.keys), *(path for path, _ in self.recipe.links))
        return {path: unit for path in paths if (unit := takes(path).unit)}

    def to_pandas(self) -> Any:
        """The same as :attr:`frame`."""
        return self.frame

    def to_xarray(self) -> Any:
        """Rows as an ``xarray.Dataset``: over the keys where the sample is a grid, else over the samples.

        Keys, figures and their errors have the attribute ``units``.
        """
        found = self._labelled()
        for name, unit in (self.key_units | self.units).items():
            for variable in (name, f"{name}_error"):
                if variable in found.variables:
                    found[variable].attrs["units"] = unit
        return found

    def _labelled(self) -> Any:
        rows = self.frame
        if self.recipe.method == "grid" and self.about["kind"] == "run":
            keys = [key.path for key in self.recipe.keys]
            rows = rows.drop_duplicates(keys)  # a list may have a value twice
            return rows.set_index(keys).drop(columns=[path for path, _ in self.recipe.links]).to_xarray()
        return rows.set_index("sample").to_xarray()

    def to_csv(self, file: str | os.PathLike[str]) -> None:
        """Write all rows as text; numbers keep all their digits."""
        write_whole(file, lambda place: self.frame.to_csv(place, index=False))

    def made(self, rows: Any) -> Bools:
        """Which rows are drives that could be made and have all objectives; other figures may have no value."""
        has_objectives = rows[list(self.recipe.objectives)].notna().all(axis=1)
        return np.asarray(rows["code"].isin(("", "figure")) & has_objectives, dtype=bool)

    def feasible(self, frame: Any = None) -> Bools:
        """Which rows are drives that could be made, have all objectives and keep all constraints."""
        rows = self.frame if frame is None else frame
        good = self.made(rows).copy()
        for name, (low, high) in self.recipe.constraints.items():
            good &= np.asarray((rows[name] >= low) & (rows[name] <= high), dtype=bool)
        return good

    def objectives(self, frame: Any) -> tuple[Floats, Floats]:
        """Objectives of rows, all to be as small as possible, and their errors."""
        aims = self.recipe.objectives
        values = np.column_stack([aim * np.asarray(frame[name], dtype=float) for name, aim in aims.items()])
        errors = np.column_stack([np.asarray(frame[f"{name}_error"], dtype=float) for name in aims])
        return values, errors

    @checked
    def best(self, count: int = 10) -> Any:
        """The best drives as a ``pandas.DataFrame``, best first; each once, however often it was computed.

        With one objective the column ``rank`` is the same for drives whose difference to the first of them does not
        exceed the errors of both; it is empty where the error of a drive is not known. With several the drives are
        those that no other one beats by more than the errors of both. An error that is not known counts there as the
        largest known one of its objective, and as 0 where none is known. Its ``attrs["units"]`` has the units.

        Parameters
        ----------
        count : int
            How many at most. Survivors have the figures of their second computation, with errors; others have none.
        """
        import pandas

        if count < 1:
            raise refuse("count", f"{count} is less than one", "write a whole number from 1")
        if not self.recipe.objectives:
            raise refuse(self.folder.place, "nothing says what is better", "write [objectives] into its study.toml")
        rows = self._rivals(self._with_survivors() if self.recipe.survivors else self.frame)
        values, errors = self.objectives(rows)
        order = _leading(values, errors, count)
        chosen = rows.iloc[order].reset_index(drop=True)
        if len(self.recipe.objectives) == 1:
            chosen.insert(0, "rank", pandas.array(_ranks(values[order, 0], errors[order, 0]), dtype="Int64"))
        chosen.attrs["units"] = self.frame.attrs["units"]
        return chosen

    def candidates(self, count: int) -> Any:
        """The drives that are computed again with errors: the best.

        With several objectives the front without errors, and as many further fronts behind it as it takes.
        """
        rows = self._rivals(self.frame)
        values, errors = self.objectives(rows)
        chosen, left = np.empty(0, dtype=int), np.arange(len(rows))
        while len(left) and len(chosen) < count:
            front = left[_leading(values[left], errors[left], count - len(chosen))]
            chosen, left = np.concatenate([chosen, front]), np.setdiff1d(left, front)
        return rows.iloc[chosen]

    def _rivals(self, rows: Any) -> Any:
        """Those that keep all constraints, each drive once: lists and steps may make the same drive twice."""
        return rows[self.feasible(rows)].drop_duplicates([key.path for key in self.recipe.keys])

    def _with_survivors(self) -> Any:
        """All rows; those of the drives that survive as the study is now as they were computed last, with errors."""
        import pandas

        first = self.candidates(self.recipe.survivors)["sample"]
        second = self._read("survivors")
        if second.empty:  # none yet, or nothing to compute again
            return self.frame
        second = second[second["sample"].isin(first)]
        return pandas.concat([second, self.frame[~self.frame["sample"].isin(second["sample"])]]).sort_values("sample")

    def values(self, row: Mapping[str, Any]) -> dict[str, Value]:
        """Values of all keys of a row, links included."""
        return self.recipe.linked(self.recipe.restored(row))

    def scene(self, sample: int) -> Scene:
        """The scene of a sample, to be computed by itself."""
        rows = self.frame[self.frame["sample"] == sample]
        if rows.empty:
            raise refuse(self.folder.place, f"has no sample {sample}", "take a number of the column sample")
        return self.recipe.scene_of(self.values(rows.iloc[0]))

    def independent(self) -> Bools:
        """Which rows share no key with another one: in a sample for indices the first and the last of each block."""
        if self.recipe.method != "saltelli" or self.about["kind"] != "run":
            return np.ones(len(self.frame), dtype=bool)
        place = np.asarray(self.frame["sample"]) % (len(self.recipe.keys) + 2)
        return np.asarray((place == 0) | (place == len(self.recipe.keys) + 1))

    def yield_of(self) -> tuple[float, float, float]:
        """The share of drives that keep all constraints, and the ends of its interval of 95 %."""
        from scipy.stats import binomtest

        good = self.feasible()
        good = good[self.independent()]
        if not len(good):
            return float("nan"), 0.0, 1.0
        interval = binomtest(int(good.sum()), len(good)).proportion_ci(method="wilson")
        return float(good.mean()), float(interval.low), float(interval.high)

    def indices(self) -> Any:
        """First and total indices of Sobol of every figure, with half widths of their 95 % interval, from 8 blocks on.

        A ``pandas.DataFrame`` with the columns figure, key, first, first_error, total, total_error; the key with the
        largest total index of a figure matters most. Blocks in which a drive is missing or could not be made are left
        out; ``attrs["blocks"]`` of the table says how many blocks each figure has. ``attrs["equal"]`` names the
        figures whose largest and smallest value differ by no more than their errors, so that no key matters.
        """
        from ._indices import indices_of

        if self.recipe.method != "saltelli":
            raise refuse(self.folder.place, "has no sample for indices", 'write method = "saltelli" under [sample]')
        return indices_of(self.recipe, self.frame)

    def status(self) -> dict[str, Any]:
        """How far the study is; ``lacking`` is the commonest figure without a value: how many drives, name, cause."""
        shards = list(self._shards("rows"))
        seconds = sum(about["seconds"] for _, about in shards)
        done = sum(len(table) for table, _ in shards)
        failures: Counter[tuple[str, str, str]] = Counter()
        for table, _ in shards:
            failures.update(zip(*(table.column(name).to_pylist() for name in ("code", "place", "cause"))))
        codes: Counter[str] = Counter()
        for (code, _, _), count in failures.items():
            codes[code] += count * bool(code)
        lacking = [(count, *why) for (code, *why), count in failures.most_common() if code == "figure"]
        total = self.recipe.drives if self.about["kind"] == "run" else None
        return {
            "verb": self.about["kind"],
            "running": self.folder.is_running(),
            "done": done,
            "total": total,
            "failed": {code: count for code, count in codes.items() if count},
            "lacking": lacking[0] if lacking else None,
            "shards": len(shards),
            "worker_seconds": seconds,
            "seconds_left": (total - done) * seconds / done if total and done else None,
        }


def _leading(values: Floats, errors: Floats, count: int) -> npt.NDArray[np.intp]:
    """Numbers of the best rows, at most so many: of one objective the first, of several some all over the front."""
    order: npt.NDArray[np.intp] = np.argsort(values[:, 0], kind="stable")
    if values.shape[1] == 1:
        return order[:count]
    order = order[~dominated(values, errors)[order]]
    spread = np.unique(np.linspace(0, len(order) - 1, min(count, len(order))).round().astype(int))
    order = order[spread]
    return order


def _ranks(values: Floats, errors: Floats) -> list[int | None]:
    """Ranks from 1 of sorted values; a new one begins where the difference to the first of the last exceeds errors.

    None where the error is not known; such a value takes its place in the count.
    """
    ranks: list[int | None] = []
    leader: int | None = None
    for i in range(len(values)):
        if np.isnan(errors[i]):
            ranks.append(None)
            continue
        if leader is None or values[i] - errors[i] > values[leader] + errors[leader]:
            leader = i
        ranks.append(leader + 1)
    return ranks


def open(folder: str | os.PathLike[str]) -> Study:
    """Open the folder of a study, while it runs or afterwards.

    Parameters
    ----------
    folder : path
        What ``-o`` of ``hdconj study run`` named.

    Returns
    -------
    Study
        ``study.frame``, ``study.best()``, ``study.to_xarray()``, ``study.to_csv(FILE)``.

    Raises
    ------
    InputError
        The folder holds no study.
    """
    return Study(folder)
