# SPDX-License-Identifier: GPL-3.0-or-later
"""Indices of Sobol: which key matters for which figure."""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

from ._recipe import Recipe

Floats = npt.NDArray[np.float64]


def indices_of(recipe: Recipe, frame: Any) -> Any:
    """The table that :meth:`hdconj.study.Study.indices` describes, of the rows of a "saltelli" sample."""
    import pandas
    from SALib.analyze import sobol

    keys = [key.path for key in recipe.keys]
    problem = {"num_vars": len(keys), "names": keys, "bounds": [[0, 1]] * len(keys)}
    found: list[tuple[Any, ...]] = []
    used: dict[str, int] = {}
    equal: list[str] = []
    for name, _ in recipe.figures:
        blocks = _blocks(frame, name, len(keys) + 2)
        whole = np.isfinite(blocks).all(axis=1)
        values = blocks[whole]
        used[name] = len(values)
        if len(values) < 2:
            continue
        if not _differ(values, _blocks(frame, f"{name}_error", len(keys) + 2)[whole]):
            equal.append(name)
        if np.ptp(values) == 0:
            continue
        made = sobol.analyze(problem, values.reshape(-1), calc_second_order=False, seed=recipe.seed)
        for i, key in enumerate(keys):
            found.append((name, key, made["S1"][i], made["S1_conf"][i], made["ST"][i], made["ST_conf"][i]))
    table = pandas.DataFrame(found, columns=["figure", "key", "first", "first_error", "total", "total_error"])
    table.attrs |= {"blocks": used, "equal": equal}
    return table


def _blocks(frame: Any, column: str, width: int) -> Floats:
    """A column with one row for each block of a sample; rows that are missing are not a number."""
    sample = np.asarray(frame["sample"], dtype=int)
    blocks = np.full((sample.max(initial=-1) // width + 1, width), np.nan)
    blocks[sample // width, sample % width] = np.asarray(frame[column], dtype=float)
    return blocks


def _differ(values: Floats, errors: Floats) -> bool:
    """Whether the largest and the smallest of some values differ by more than the errors of both."""
    of_both = np.nan_to_num(errors.flat[[values.argmin(), values.argmax()]]).sum()
    return bool(np.ptp(values) > of_both)
