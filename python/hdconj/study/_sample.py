# SPDX-License-Identifier: GPL-3.0-or-later
"""Samples: numbers from 0 to 1 for each key. Sample i depends on seed and i, whatever else is asked for.

A Latin hypercube depends on the count too, as it must.
"""

from __future__ import annotations

import math
from functools import lru_cache
from typing import Any

import numpy as np
import numpy.typing as npt

from ._keys import Key, Value

METHODS = ("grid", "sobol", "lhs", "random", "saltelli")
Units = npt.NDArray[np.float64]


def grid_points(key: Key) -> tuple[Value, ...]:
    """The values of a key in a grid; empty where it has no finite number of them."""
    return key.values


def sample_count(method: str, count: int, keys: tuple[Key, ...]) -> int:
    """How many drives a study has; ``saltelli`` takes count (keys + 2) for its indices."""
    if method == "grid":
        return math.prod(len(grid_points(key)) for key in keys)
    return count * (len(keys) + 2) if method == "saltelli" else count


@lru_cache(maxsize=2)
def _whole(method: str, count: int, seed: int, dimensions: int) -> Units:
    """Samples of methods that make all of them at once."""
    from scipy.stats import qmc

    if method == "lhs":
        return np.asarray(qmc.LatinHypercube(dimensions, rng=np.random.default_rng(seed)).random(count))
    from SALib.sample import sobol

    problem = {"num_vars": dimensions, "names": [str(i) for i in range(dimensions)], "bounds": [[0, 1]] * dimensions}
    return np.asarray(sobol.sample(problem, count, calc_second_order=False, seed=seed))


@lru_cache(maxsize=1)
def _sobol(seed: int, dimensions: int, blocks: int) -> Units:
    from scipy.stats import qmc

    return np.asarray(qmc.Sobol(dimensions, scramble=True, rng=np.random.default_rng(seed)).random_base2(blocks))


def values_of(index: int, method: str, count: int, seed: int, keys: tuple[Key, ...]) -> list[Value]:
    """The values of all keys in sample ``index``."""
    if method == "grid":
        shape = [len(grid_points(key)) for key in keys]
        places = np.unravel_index(index, shape)
        return [grid_points(key)[int(place)] for key, place in zip(keys, places)]
    units: Any
    if method == "random":
        units = np.random.Generator(np.random.Philox(key=seed, counter=[0, 0, 0, index])).random(len(keys))
    elif method == "sobol":
        # A power of 2 at a time; the beginning of a Sobol sequence does not depend on its length.
        units = _sobol(seed, len(keys), max(int(count - 1).bit_length(), 1))[index]
    else:
        units = _whole(method, count, seed, len(keys))[index]
    return [key.value(float(unit)) for key, unit in zip(keys, units)]
