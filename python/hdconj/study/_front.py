# SPDX-License-Identifier: GPL-3.0-or-later
"""Designs that no other one beats, of many designs and several objectives."""

from __future__ import annotations

from bisect import bisect_right

import numpy as np
import numpy.typing as npt

Bools = npt.NDArray[np.bool_]
Floats = npt.NDArray[np.float64]
_AT_ONCE = 10**6  # comparisons


def dominated(values: Floats, errors: Floats) -> Bools:
    """Which designs another one beats: as good in every objective, better in one by more than the errors of both.

    Parameters
    ----------
    values : (n, m) array
        Objectives, all to be as small as possible.
    errors : (n, m) array
        Their errors. One that is not known counts as the largest of its objective, and as 0 where none is known.
    """
    largest = np.where(np.isnan(errors), 0.0, errors).max(axis=0, initial=0.0)
    errors = np.where(np.isnan(errors), largest, errors)
    worst, best = values + errors, values - errors
    if values.shape[1] == 2:
        return np.asarray((_least_of_as_good(values, worst) < best).any(axis=1), dtype=bool)
    rivals = _rivals(np.hstack([values, worst]))
    as_good, ends = values[rivals], worst[rivals]
    found = np.zeros(len(values), dtype=bool)
    for part in _parts(len(values), rivals.size):
        found[part] = _any_beats(as_good, ends, values[part], best[part])
    return found


def _any_beats(as_good: Floats, ends: Floats, values: Floats, best: Floats) -> Bools:
    beats = np.ones((len(values), len(as_good)), dtype=bool)
    better = np.zeros_like(beats)
    for i in range(values.shape[1]):
        beats &= as_good[:, i] <= values[:, i, None]
        better |= ends[:, i] < best[:, i, None]
    return np.asarray((beats & better).any(axis=1), dtype=bool)


def _least_of_as_good(values: Floats, worst: Floats) -> Floats:
    """For each design, the least value of both objectives with its error among all that are as good in both.

    Designs are taken in order of the first objective. Those so far whose value with error counts are kept as steps: in
    order of the second objective, the values with errors fall.
    """
    least = np.empty_like(worst)
    order = np.lexsort((values[:, 1], values[:, 0])).tolist()
    along = values[:, 1].tolist()
    for column in range(2):
        ends = worst[:, column].tolist()
        places: list[float] = []
        steps: list[float] = []
        for i in order:
            at = bisect_right(places, along[i])
            if at == 0 or ends[i] < steps[at - 1]:
                over = at
                while over < len(steps) and steps[over] >= ends[i]:
                    over += 1
                places[at:over], steps[at:over] = [along[i]], [ends[i]]
                at += 1
            least[i, column] = steps[at - 1]
    return least


def _rivals(corners: Floats) -> npt.NDArray[np.intp]:
    """Numbers of the rows that are enough to beat all which any row beats: no other row is as small in all columns."""
    order = np.argsort(corners.sum(axis=1), kind="stable")  # a smaller row stands before
    kept = np.empty(0, dtype=np.intp)
    for part in _parts(len(order), 10**5):
        fresh = order[part]
        for given in _parts(len(kept), fresh.size):
            fresh = fresh[~_covered(corners[kept[given]], corners[fresh]).any(axis=1)]
        inner = np.tril(_covered(corners[fresh], corners[fresh]), -1)
        kept = np.concatenate([kept, fresh[~inner.any(axis=1)]])
    return kept


def _covered(others: Floats, rows: Floats) -> Bools:
    """Which of the others are as small as each row in all columns."""
    found = np.ones((len(rows), len(others)), dtype=bool)
    for i in range(rows.shape[1]):
        found &= others[:, i] <= rows[:, i, None]
    return found


def _parts(count: int, others: int) -> list[slice]:
    """Slices of a number of rows, each to be compared with the others at once."""
    size = max(_AT_ONCE // max(others, 1), 1)
    return [slice(first, first + size) for first in range(0, count, size)]
