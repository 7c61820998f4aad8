# SPDX-License-Identifier: GPL-3.0-or-later
"""Files that appear whole or not at all."""

from __future__ import annotations

import os
import shutil
import tempfile
from collections.abc import Callable
from pathlib import Path

from . import _core
from ._errors import FileError


def write_whole(target: str | os.PathLike[str], write: Callable[[str], object]) -> None:
    """Write a file as the program does, with a FileError that names the target.

    Parameters
    ----------
    target : path
        A file is replaced whole, or stays as it is. A device or a pipe is written into.
    write : callable
        Writes a file under the name that it is given.
    """

    def fill(place: Path) -> None:
        try:
            if place.is_file():
                write(str(place))
                return
            with tempfile.TemporaryDirectory() as folder:  # a device takes bytes one after the other
                made = os.path.join(folder, "made")
                write(made)
                with open(made, "rb") as source, open(place, "wb") as sink:
                    shutil.copyfileobj(source, sink)
        except FileError:
            raise
        except OSError as error:
            raise FileError(f"{os.fspath(target)}: cannot write: {error.strerror or error}") from error

    _core.write_atomically(target, fill)
