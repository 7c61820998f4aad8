# SPDX-License-Identifier: GPL-3.0-or-later
"""Conjugate tooth profiles of harmonic drives.

The functions are the verbs of the program ``hdconj``, and their results hold the arrays of its result files.
Lengths are in mm, angles in rad, forces in N, torques in N mm and stresses in MPa, unless a name says otherwise.
"""

import os as _os

# GNU's OpenMP reads once, when it is loaded, how long its threads spin between two loops; by its own choice so long
# that they disturb each other on a busy machine (apps/hdconj/threads.cpp). What the user says holds.
_spins = not {"OMP_WAIT_POLICY", "GOMP_SPINCOUNT"} & set(_os.environ)
if _spins:
    _os.environ["GOMP_SPINCOUNT"] = "3000"
from . import _core

if _spins:
    del _os.environ["GOMP_SPINCOUNT"]
from ._errors import Fault, FileError, InputError, NumericalError, StoppedError
from ._hdf5 import read
from ._results import (
    Accuracy,
    ContactStudy,
    Design,
    Inspection,
    LoadStudy,
    Measurement,
    NeutralCurve,
    Result,
    RunStudy,
    Solution,
    StepSolid,
    WireProgram,
)
from ._scene import Scene
from ._tree import Dataset, Figure, Group
from ._verbs import (
    accuracy,
    contact,
    design,
    find_neutral_curve,
    inspect,
    load,
    read_measured,
    report,
    run,
    solve,
    wedm,
)

__version__ = _core.version
__all__ = [
    "Accuracy",
    "ContactStudy",
    "Dataset",
    "Design",
    "Fault",
    "Figure",
    "FileError",
    "Group",
    "InputError",
    "Inspection",
    "LoadStudy",
    "Measurement",
    "NeutralCurve",
    "NumericalError",
    "Result",
    "RunStudy",
    "Scene",
    "Solution",
    "StepSolid",
    "StoppedError",
    "WireProgram",
    "accuracy",
    "contact",
    "design",
    "find_neutral_curve",
    "inspect",
    "load",
    "read",
    "read_measured",
    "report",
    "run",
    "solve",
    "wedm",
]
