# SPDX-License-Identifier: GPL-3.0-or-later
"""How a computation proceeds: counts, and a bar on a terminal."""

from __future__ import annotations

import sys
from collections.abc import Sequence
from dataclasses import dataclass
from importlib.util import find_spec

from ._drive import Row


@dataclass
class Told:
    """How a computation proceeds."""

    done: int = 0
    failed: int = 0


class Progress:
    """A bar of tqdm on a terminal; nothing elsewhere, or where tqdm is not installed."""

    def __init__(self, total: int, what: str, shown: bool) -> None:
        self.told, self.bar = Told(), None
        if shown and sys.stderr.isatty() and find_spec("tqdm"):
            from tqdm import tqdm  # type: ignore[import-untyped]

            self.bar = tqdm(total=total, desc=what, unit="drive", smoothing=0.1, file=sys.stderr)

    def add(self, rows: Sequence[Row]) -> None:
        """Counts the rows of a shard."""
        self.told.done += len(rows)
        self.told.failed += sum(bool(row["code"]) for row in rows)
        if self.bar is not None:
            self.bar.set_postfix(failed=self.told.failed, refresh=False)
            self.bar.update(len(rows))

    def close(self) -> None:
        """Leaves the bar as it is."""
        if self.bar is not None:
            self.bar.close()
