# SPDX-License-Identifier: GPL-3.0-or-later
"""Indices of Sobol: which key matters for which figure."""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

from ._recipe import Recipe

Floats = npt.NDArray[np.float64]
FEWEST = 8  # blocks


def indices_of(recipe: Recipe, frame: Any) -> Any:
    """The table that :meth:`hdconj.study.Study.indices` describes, of the rows of a "saltelli" sample."""
    import pandas

    keys = [key.path for key in recipe.keys]
    found: list[tuple[Any, ...]] = []
    used: dict[str, int] = {}
    equal: list[str] = []
    for name, _ in recipe.figures:
        blocks = _blocks(frame, name, len(keys) + 2)
        whole = np.isfinite(blocks).all(axis=1)
        values = blocks[whole]
        used[name] = len(values)
        if len(values) < FEWEST:
            continue
        if not _differ(values, _blocks(frame, f"{name}_error", len(keys) + 2)[whole]):
            equal.append(name)
        if (values[:, 0] == values[:, -1]).all():
            continue
        for key, numbers in zip(keys, with_half_widths(values)):
            found.append((name, key, *numbers))
    table = pandas.DataFrame(found, columns=["figure", "key", "first", "first_error", "total", "total_error"])
    table.attrs |= {"blocks": used, "equal": equal}
    return table


def with_half_widths(blocks: Floats) -> Floats:
    """First index, its half width, total index and its half width of each key.

    The half widths of 95 % are those of the jackknife that leaves out a block at a time, of the logarithms of the
    shares. An index lies between 0 and 1, and so no half width exceeds 1.
    """
    from scipy.stats import t

    count = len(blocks)
    shares = _shares(blocks)
    with np.errstate(all="ignore"):  # one block alone may have all that differs: nothing is known then
        logs = np.log([np.maximum(_shares(np.delete(blocks, i, axis=0)), np.finfo(float).tiny) for i in range(count)])
        half = shares * np.expm1(t.ppf(0.975, count - 1) * np.sqrt(count - 1) * logs.std(axis=0))
    first, total = np.clip([1 - shares[0], shares[1]], 0, 1)
    of_first, of_total = np.fmin(half, 1)
    return np.stack([first, of_first, total, of_total], axis=1)


def _shares(blocks: Floats) -> Floats:
    """Shares of the variance without each key, and with it: what the other keys change, and what this one changes.

    They are Jansen's (1999), but of the variance by which the first and the last drive of a block differ. What these
    have in common by chance, which few blocks do not average out, then falls out of shares near 1.
    """
    first, changed, last = blocks[:, :1], blocks[:, 1:-1], blocks[:, -1:]
    shares: Floats = np.mean([(last - changed) ** 2, (changed - first) ** 2], axis=1) / ((last - first) ** 2).mean()
    return shares


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
