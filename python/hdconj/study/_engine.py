# SPDX-License-Identifier: GPL-3.0-or-later
"""Shards through Dask: processes of this machine, or a scheduler that runs somewhere else."""

from __future__ import annotations

import asyncio
import concurrent.futures
import logging
import os
import signal
import sys
import threading
import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from importlib import import_module
from importlib.util import find_spec
from multiprocessing import spawn
from multiprocessing.resource_tracker import ensure_running
from pathlib import Path
from typing import Any

from .._errors import FileError, InputError
from ._drive import Row, Sample, careful_rows, rows_of
from ._progress import Progress, Told
from ._recipe import Recipe
from ._shards import IDENTITY, schema_of, write_shard

WINDOW = 4  # shards a worker has in hand
SHARD_SECONDS = 10.0  # of work in a shard; between 2 and 60
LONGEST_SHARD = 2000  # drives
WORKERS_SECONDS = 60.0  # without any worker
NEEDED = "scheduler and workers need a Python with the same hdconj[study]"
# Dask looks at itself a hundred times a second, for its dashboard: 6 % of a core.
WATCHED_RARELY = {
    "distributed.worker.profile.enabled": False,
    "distributed.admin.tick.interval": "1s",
    "distributed.admin.system-monitor.interval": "5s",
    "distributed.admin.system-monitor.gil.enabled": False,
}
# What Dask's calls raise when the scheduler dies.
LOST = (OSError, RuntimeError, asyncio.CancelledError, concurrent.futures.CancelledError)


class EngineLost(RuntimeError):
    """The scheduler or all workers went away; what is written stays."""


def _lost(error: BaseException) -> EngineLost:
    """What it means that Dask raises one of :data:`LOST`."""
    if "deserialization" in str(error):
        return EngineLost(f"the scheduler cannot read what is to be computed: {NEEDED}")
    return EngineLost(f"the scheduler is gone ({type(error).__name__})")


def work(recipe: Recipe, samples: Sequence[Sample], errors: bool, careful: bool) -> tuple[list[Row], Any, float]:
    """A shard on a worker: rows, units, seconds."""
    begin = time.perf_counter()
    rows, units = (careful_rows if careful else rows_of)(recipe, samples, errors)
    return rows, units, time.perf_counter() - begin


def _module(name: str) -> Any:
    """A module whose functions have no types; loaded when it is needed, which takes half a second."""
    return import_module(name)


def is_address(text: str) -> bool:
    """Whether a text is an address of a scheduler, whether one answers there or not."""
    try:
        _module("distributed.comm").get_address_host_port(text)
    except (TypeError, ValueError):
        return False
    return True


@contextmanager
def engine(jobs: int = 0, scheduler: str | None = None) -> Iterator[Any]:
    """A client of Dask distributed.

    Parameters
    ----------
    jobs : int
        Processes on this machine; 0: as many as it has cores.
    scheduler : str, optional
        Address of a scheduler, such as ``"tcp://host:8786"``, instead of processes of this machine.
    """
    dask, distributed = _module("dask"), _module("distributed")
    quiet: dict[str, Any] = {"distributed.admin.low-level-log-length": 0}
    logging.getLogger("distributed").setLevel(logging.CRITICAL)
    logging.getLogger("distributed.client").setLevel(logging.CRITICAL + 1)  # it tells a lost scheduler by a traceback
    if scheduler:
        with dask.config.set(quiet):
            try:
                client = distributed.Client(scheduler, timeout=20)
            except (OSError, TimeoutError, ValueError) as error:
                raise EngineLost(f"no scheduler answers at {scheduler}: {error}") from None
            try:
                yield client
            finally:
                _quietly(client.close)
        return
    # A worker that dies takes the blame at once: its shards are tried with care, in processes of their own.
    settings = {
        **quiet, **WATCHED_RARELY, "distributed.scheduler.allowed-failures": 0,
        "distributed.worker.memory.terminate": False,
    }  # fmt: skip
    spaces = {"OMP_NUM_THREADS": "1", **({} if "GOMP_SPINCOUNT" in os.environ else {"GOMP_SPINCOUNT": "3000"})}
    settings["distributed.nanny.pre-spawn-environ"] = {
        **dask.config.get("distributed.nanny.pre-spawn-environ"),
        **spaces,
    }
    with dask.config.set(settings), _without_the_script():
        with _deaf_to_interrupts():
            try:
                cluster = distributed.LocalCluster(
                    n_workers=jobs or os.cpu_count() or 1, threads_per_worker=1, processes=True, memory_limit=0,
                    dashboard_address=":0", local_directory=_scratch(), silence_logs=60,
                )  # fmt: skip
            except LOST as error:
                raise EngineLost(f"the processes of this machine did not start ({error})") from None
        client = distributed.Client(cluster)
        try:
            if find_spec("bokeh") and sys.stderr.isatty():
                print(f"dashboard: {client.dashboard_link}", file=sys.stderr)
            yield client
        finally:
            _quietly(client.close)
            _quietly(cluster.close)


@contextmanager
def _deaf_to_interrupts() -> Iterator[None]:
    """Threads that begin in here, and their processes, never see the Ctrl-C of a terminal: it is for this one alone.

    One that comes meanwhile arrives afterwards.
    """
    ensure_running()  # multiprocessing lets interrupts through again where it starts this process of its own
    before = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)


@contextmanager
def _without_the_script() -> Iterator[None]:
    """Workers do not run the script that has called, which need not stand below ``if __name__ == "__main__":``.

    Processes that the script itself spawns meanwhile have it, as ever.
    """
    whole = spawn.get_preparation_data

    def bare(name: str) -> dict[str, Any]:
        is_of_dask = threading.current_thread().name.startswith("AsyncProcess")
        return {word: item for word, item in whole(name).items() if not (is_of_dask and word.startswith("init_main"))}

    spawn.get_preparation_data = bare
    try:
        yield
    finally:
        spawn.get_preparation_data = whole


def _scratch() -> str:
    import tempfile

    return tempfile.gettempdir()


def _quietly(close: Callable[[], object]) -> None:
    """Closes what is not needed any more; that it may be gone already, or half of it, does not matter."""
    try:
        close()
    except (Exception, asyncio.CancelledError):  # noqa: BLE001
        logging.getLogger(__name__).debug("closing failed", exc_info=True)


class _Shards:
    """Cuts what is left into shards of a few seconds each."""

    def __init__(self, samples: Sequence[Sample], seconds: float, target: float) -> None:
        self.samples, self.at = samples, 0
        self.seconds, self.target, self.is_guess = max(seconds, 1e-4), target, True

    def __bool__(self) -> bool:
        return self.at < len(self.samples)

    def learn(self, seconds: float, count: int) -> None:
        """Takes the time of a shard for that of the next ones."""
        fresh = max(seconds / count, 1e-4)
        self.seconds = fresh if self.is_guess else 0.7 * self.seconds + 0.3 * fresh
        self.is_guess = False

    def take(self, workers: int) -> list[Sample]:
        """The next shard: consecutive samples, and short enough that the workers end together."""
        left = len(self.samples) - self.at
        fair = max(left // (2 * workers), min(left, int(2 / self.seconds)), 1)
        size = min(max(int(self.target / self.seconds), 1), fair, LONGEST_SHARD)
        part = [self.samples[self.at]]
        while len(part) < size and self.at + len(part) < len(self.samples):
            following = self.samples[self.at + len(part)]
            if following[0] != part[-1][0] + 1:
                break
            part.append(following)
        self.at += len(part)
        return part


def _workers(client: Any) -> int:
    """Threads of all workers; waits a minute for the first."""
    until = time.monotonic() + WORKERS_SECONDS
    while True:
        try:
            threads = sum(client.nthreads().values())
        except LOST as error:
            raise _lost(error) from None
        if threads:
            return int(threads)
        if time.monotonic() > until:
            raise EngineLost(f"no worker for {WORKERS_SECONDS:.0f} s: {NEEDED}")
        time.sleep(0.2)


def _finished(client: Any, running: dict[Any, Any]) -> list[Any]:
    """Futures that have ended, at least one; EngineLost where the scheduler is gone."""
    wait, looked = _module("distributed").wait, time.monotonic()
    while True:
        if client.status not in ("running", "connecting"):
            raise EngineLost("the scheduler is gone")
        try:
            done = wait(list(running), timeout=1.0, return_when="FIRST_COMPLETED").done
            return list(done)
        except (TimeoutError, asyncio.TimeoutError):
            if time.monotonic() > looked + 5:
                _workers(client)
                looked = time.monotonic()
        except LOST as error:
            raise _lost(error) from None


def compute_rows(
    client: Any, recipe: Recipe, samples: Sequence[Sample], folder: Path, own: Mapping[str, Any], *, errors: bool,
    seconds: float = 1.0, shard_seconds: float = SHARD_SECONDS, what: str = "drives", shown: bool = True,
    look: Callable[[Sequence[Row]], None] = lambda rows: None,
) -> Told:  # fmt: skip
    """Computes samples and writes their shards, one after the other as they come.

    Parameters
    ----------
    client : distributed.Client
        Of :func:`engine`.
    recipe, samples
        What is computed; samples in order of their numbers.
    folder : Path
        Where the shards go.
    own
        What study.json says: shards say whose they are.
    errors : bool
        Whether the verbs estimate errors.
    seconds : float
        A guess of the time of one drive; measured times replace it.
    shard_seconds : float
        Time of one shard.
    what : str
        Name of the progress bar.
    shown : bool
        Whether there is one.
    look
        Sees the rows of a shard before they are written, and may refuse the study.
    """
    from distributed import KilledWorker

    schema, progress = schema_of(recipe), Progress(len(samples), what, shown)
    shards = _Shards(samples, seconds, shard_seconds)
    running: dict[Any, list[Sample]] = {}

    def send(part: list[Sample], careful: bool) -> None:
        running[client.submit(work, recipe, part, errors, careful, pure=False, priority=10 if careful else 0)] = part

    try:
        while shards or running:
            workers = _workers(client)
            # One shard each until the time of a drive is known.
            while shards and len(running) < (workers if shards.is_guess else WINDOW * workers):
                send(shards.take(workers), False)
            for future in _finished(client, running):
                part = running.pop(future)
                try:
                    rows, units, taken = future.result()
                except KilledWorker:
                    send(part, True)
                    continue
                except LOST as error:
                    raise _lost(error) from None
                look(rows)
                shards.learn(taken, len(part))
                about = {"units": units, "seconds": taken, "errors": errors}
                write_shard(folder, rows, schema, about | {word: own[word] for word in IDENTITY})
                progress.add(rows)
    except (EngineLost, FileError, InputError, KeyboardInterrupt):
        _quietly(lambda: client.cancel(list(running), force=True))
        raise
    finally:
        progress.close()
    return progress.told
