# SPDX-License-Identifier: GPL-3.0-or-later
"""What can go wrong: bad input, a computation that fails, a file that cannot be used."""

from __future__ import annotations

from typing import NamedTuple


class Fault(NamedTuple):
    """One fault of a scene or of an argument."""

    path: str
    """Key path such as ``"flexspline.profile.addendum"``, an argument, or a file name."""
    line: int
    """Line in the scene, from 1; 0 where there is none."""
    value: str
    """The value as it was written; empty when absent."""
    reason: str
    """Why this cannot be computed."""
    remedy: str
    """What to write instead."""
    origin: str = ""
    """``"--set"`` for a fault of :meth:`Scene.with_`; empty: the scene."""
    set: tuple[str, ...] = ()
    """The remedy as ``key=value``; empty where no number is known."""
    kind: str = "other"
    """``"unknown"``: no scene has this key or table here; ``"value"``: the key takes no such value in any scene;
    ``"other"``: it depends on other keys, on files or on the geometry."""


def fault_text(faults: tuple[Fault, ...]) -> str:
    """All faults in words, one a line."""
    lines = []
    for fault in faults:
        value = f" = {fault.value}" if fault.value else ""
        line = f"line {fault.line}: " if fault.line else ""
        remedy = f" ({fault.remedy})" if fault.remedy else ""
        lines.append(f"{line}{fault.path}{value}: {fault.reason}{remedy}")
    return "\n".join(lines)


class InputError(ValueError):
    """Bad input, with every fault that was found.

    Parameters
    ----------
    faults : tuple of Fault
        At least one, in order of place.
    text : str
        All of them in words, as the program prints them.
    """

    def __init__(self, faults: tuple[Fault, ...], text: str) -> None:
        super().__init__(faults, text)
        self.faults = tuple(Fault(*fault) for fault in faults)
        self.text = text

    def __str__(self) -> str:
        return self.text


class NumericalError(ArithmeticError):
    """A computation could not be finished to its tolerance.

    Parameters
    ----------
    code : str
        Kind of failure, such as ``"no-land"``; docs/reference/json.md lists them.
    stage, place, cause : str
        Part of the computation, where in the drive, what happened.
    remedy : str
        What can be done; empty where nothing is known to help.
    set : tuple of str
        The remedy as ``key=value``; empty where no number is known.
    """

    def __init__(
        self, code: str, stage: str, place: str, cause: str, remedy: str = "", set: tuple[str, ...] = ()
    ) -> None:
        super().__init__(code, stage, place, cause, remedy, set)
        self.code = code
        self.stage = stage
        self.place = place
        self.cause = cause
        self.remedy = remedy
        self.set = set

    def __str__(self) -> str:
        return f"{self.stage}: {self.place}: {self.cause}" + (f"; {self.remedy}" if self.remedy else "")


class FileError(OSError):
    """A file could not be read or written."""


class StoppedError(RuntimeError):
    """A computation was asked to stop, and nothing says why."""
