# SPDX-License-Identifier: GPL-3.0-or-later
"""Many drives: sweeps, tolerances and optima, from one machine to a cluster.

``hdconj study`` is the same as ``python -m hdconj.study``. It needs the packages of ``pip install 'hdconj[study]'``,
which are loaded with the first name that is used.
"""

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from ._engine import EngineLost
    from ._progress import Told
    from ._optimise import optimise
    from ._read import load_recipe, read_recipe
    from ._recipe import Recipe
    from ._run import check, run
    from ._study import Study, open

__all__ = ["EngineLost", "Recipe", "Study", "Told", "check", "load_recipe", "open", "optimise", "read_recipe", "run"]
_HOMES = {
    **{"EngineLost": "_engine", "Told": "_progress", "Recipe": "_recipe", "Study": "_study", "open": "_study"},
    **{"optimise": "_optimise", "load_recipe": "_read", "read_recipe": "_read", "check": "_run", "run": "_run"},
}


def __getattr__(name: str) -> Any:
    if name not in _HOMES:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return getattr(import_module(f".{_HOMES[name]}", __name__), name)
