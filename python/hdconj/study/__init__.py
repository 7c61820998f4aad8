# SPDX-License-Identifier: GPL-3.0-or-later
"""Many drives: sweeps, tolerances and optima, from one machine to a cluster.

``hdconj study`` is the same as ``python -m hdconj.study``. It needs the packages of ``pip install 'hdconj[study]'``.
"""

from ._engine import EngineLost, Told
from ._optimise import optimise
from ._read import load_recipe, read_recipe
from ._recipe import Recipe
from ._run import check, run
from ._study import Study, open

__all__ = ["EngineLost", "Recipe", "Study", "Told", "check", "load_recipe", "open", "optimise", "read_recipe", "run"]
