# SPDX-License-Identifier: GPL-3.0-or-later
"""The command ``hdconj study``."""

from __future__ import annotations

import argparse
import os
import signal
import sys
import warnings
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Any

# Of arguments of the functions.
OPTIONS = {"jobs": "--jobs", "scheduler": "--scheduler", "shard_seconds": "--shard-seconds", "count": "-n"}
_LARGEST = 2**31 - 1
PACKAGES = "pip install 'hdconj[study]'"


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog="hdconj study", description="Computes many drives: sweeps, tolerances, optima.",
        epilog="Exit status: 0 done, 1 failed or stopped (run again to resume), 2 bad study or bad command line.",
    )  # fmt: skip
    verbs = parser.add_subparsers(dest="verb", required=True, metavar="VERB")

    def add(name: str, about: str, what: str) -> argparse.ArgumentParser:
        verb = verbs.add_parser(name, help=about, description=about)
        verb.add_argument("what", metavar=what)
        return verb

    add("check", "checks a study and computes the drive in the middle of all that varies", "STUDY.toml")
    for name, about in (("run", "computes the drives of a study"), ("optimise", "searches for the best drives")):
        verb = add(name, about, "STUDY.toml")
        verb.add_argument(
            "-o", dest="folder", metavar="DIR", required=True, help="folder of the results; resumes there"
        )
        verb.add_argument("--jobs", type=_whole, default=0, metavar="N", help="processes of this machine; 0: all cores")
        verb.add_argument("--scheduler", metavar="ADDRESS", help="of a Dask scheduler, such as tcp://host:8786")
        verb.add_argument(
            "--shard-seconds", type=float, default=10.0, metavar="S", help="time of one shard, 2 to 60; default 10"
        )
        verb.add_argument("--quiet", action="store_true", help="no progress bar, no summary")
    add("status", "says how far a study is", "DIR")
    best = add("best", "prints the best drives", "DIR")
    best.add_argument("-n", type=_whole, default=10, metavar="N", help="how many; default 10")
    best.add_argument("--csv", metavar="FILE", help="all rows of the study as text")
    best.add_argument("--scene", metavar="FILE", help="the scene of the first of them")
    picture = add("picture", "draws a study", "DIR")
    picture.add_argument("-o", dest="folder", metavar="FOLDER", help="of the pictures; default DIR/pictures")
    return parser


def _whole(text: str) -> int:
    """A whole number of an option."""
    if abs(value := int(text)) > _LARGEST:
        raise argparse.ArgumentTypeError(f"{text} is more than {_LARGEST}")
    return value


def _counted(count: int, word: str) -> str:
    return f"{count} {word}{'s' * (count != 1)}"


def _number(value: Any) -> str:
    return f"{value:.6g}" if isinstance(value, float) else str(value)


def print_status(study: Any) -> None:
    """Prints how far a study is, and its yield where it has constraints."""
    state = study.status()
    total = f" of {state['total']}" if state["total"] is not None else ""
    lacking = state["failed"].pop("figure", 0)
    print(f"{state['done']}{total} drives, {sum(state['failed'].values())} that cannot be made", end="")
    print(f", {lacking} that lack a figure" * bool(lacking) + "; running" * bool(state["running"]))
    for code, count in sorted(state["failed"].items()):
        print(f"  {count} {code}")
    if state["lacking"]:
        print("  {} figure {} = {}".format(*state["lacking"]))
    if study.about.get("unchecked"):
        print(study.about["unchecked"])
    if state["seconds_left"]:
        print(f"{state['seconds_left']:.0f} s of one worker left")
    if "ended" in study.about:
        print(study.about["ended"])
    if study.recipe.constraints and state["done"]:
        share, low, high = study.yield_of()
        # drives that are chosen are no sample
        is_drawn = study.about["kind"] == "run" and study.recipe.method != "grid"
        sure = f" ({100 * low:.1f} to {100 * high:.1f} % at 95 % confidence)" if is_drawn else ""
        print(f"{100 * share:.1f} % keep all constraints{sure}")
    if study.recipe.method == "saltelli" and state["done"] == state["total"]:
        print_indices(study)


def print_indices(study: Any) -> None:
    """Prints which key matters most for each figure, and from how many blocks where some lack a drive."""
    table = study.indices()
    for name, blocks in table.attrs["blocks"].items():
        part, of = table[table["figure"] == name], study.recipe.count
        if name in table.attrs["equal"]:
            found = "no key matters, its values differ by no more than their errors"
        elif part.empty:
            found = "too few drives for indices"
        else:
            most = part.loc[part["total"].idxmax()]
            found = f"{most['key']} matters most, total index {most['total']:.3f} +- {most['total_error']:.3f}"
        print(f"{name}: {found}" + f", from {blocks} of {of} blocks" * (blocks < of))


def print_best(study: Any, options: argparse.Namespace) -> bool:
    """Prints the best drives and writes what was asked for; whether there is any."""
    wants_rows_only = options.csv and not options.scene and not study.recipe.objectives
    table = None if wants_rows_only else study.best(options.n)
    if options.csv:
        study.to_csv(options.csv)
    if table is None:
        return True
    if table.empty:
        return _say_none(study)
    print_table(table)
    if options.scene:
        study.folder.write_scene(Path(options.scene), study.recipe, study.values(table.iloc[0]))
    return True


def print_table(table: Any) -> None:
    """Prints the best drives, without ranks and errors where none is known, and says the units."""
    unsure = [name for name in table.columns if name == "rank" or name.endswith("_error")]
    empty = [name for name in unsure if table[name].isna().all()]
    ranks = {"rank": table["rank"].astype(float)} if "rank" in table else {}
    shown = table.assign(**ranks).drop(columns=[*empty, "code", "stage", "place", "cause"])
    print(shown.to_string(index=False, float_format=_number, na_rep="-"))
    units = [f"{name} [{unit}]" for name, unit in table.attrs["units"].items() if unit and name in shown]
    if units:
        print(f"hdconj study: units: {', '.join(units)}", file=sys.stderr)
    if "rank" in table and table["rank"].isna().any():
        said = "a drive whose error is not known has no rank (errors = true or survivors under [compute] estimate it)"
        print(f"hdconj study: {said}", file=sys.stderr)


def _say_none(study: Any) -> bool:
    """Says why a study has no best drive."""
    rows = study.frame
    lacks_figures = rows["code"].isin(("", "figure")).any()
    unmade = "has a value of each objective" if lacks_figures else "can be made"
    why = "keeps all constraints" if study.made(rows).any() else unmade
    print(f"hdconj study: {study.folder.place}: none of its drives {why}", file=sys.stderr)
    return False


def _stop_at_once_at_the_second_interrupt() -> None:
    """The first Ctrl-C stops the study and closes its workers; one more does not wait for that."""
    if signal.getsignal(signal.SIGINT) is not signal.default_int_handler:
        return  # such as that of a run in the background

    # What multiprocessing's helper, which cleans up then, would say of a run that ended at once.
    os.environ.setdefault("PYTHONWARNINGS", "ignore:resource_tracker")

    def stop(*_: object) -> None:
        signal.signal(signal.SIGINT, lambda *_: os._exit(1))
        raise KeyboardInterrupt

    signal.signal(signal.SIGINT, stop)


@contextmanager
def _told_warnings() -> Iterator[None]:
    """Says warnings of the study as a command says them; others stay as they are."""
    from ._faults import UncheckedNames

    with warnings.catch_warnings():
        whole = warnings.showwarning

        def show(message: Any, category: type[Warning], *rest: Any) -> None:
            if issubclass(category, UncheckedNames):
                print(f"hdconj study: {message}", file=sys.stderr)
            else:
                whole(message, category, *rest)

        warnings.showwarning = show  # type: ignore[assignment]
        yield


def _run(options: argparse.Namespace) -> bool:
    """Computes a study; False where a search has found no drive."""
    from . import _optimise, _run
    from ._study import open as open_study

    _stop_at_once_at_the_second_interrupt()
    call = _run.run if options.verb == "run" else _optimise.optimise
    with _told_warnings():
        call(
            options.what, options.folder, jobs=options.jobs, scheduler=options.scheduler,
            shard_seconds=options.shard_seconds, progress=not options.quiet,
        )  # fmt: skip
    study = open_study(options.folder)
    if not options.quiet:
        print_status(study)
    return options.verb == "run" or bool(study.feasible().any()) or _say_none(study)


def _act(options: argparse.Namespace) -> bool:
    """Does what a command asks for; whether it found what it looks for."""
    from ._study import open as open_study

    if options.verb in ("run", "optimise"):
        return _run(options)
    if options.verb == "check":
        from ._read import load_recipe
        from ._run import fault_of, first_drive

        recipe = load_recipe(options.what)
        first = first_drive(recipe)
        if fault := fault_of(first.row):
            lacks = "lacks a figure" if first.row["code"] == "figure" else "cannot be made"
            said = first.unchecked or f"the drive in the middle {lacks}: {fault}"
            print(f"hdconj study: {said}", file=sys.stderr)
        keys, figures = len(recipe.keys), len(recipe.figures)
        vary = f"{_counted(keys, 'key')} {'varies' if keys == 1 else 'vary'}"
        print(f"{_counted(recipe.drives, 'drive')}, {vary}, {_counted(figures, 'figure')}")
    elif options.verb == "status":
        print_status(open_study(options.what))
    elif options.verb == "best":
        return print_best(open_study(options.what), options)
    else:
        from ._pictures import draw_all

        for file in draw_all(open_study(options.what), options.folder):
            print(f"wrote {file}")
    return True


def _failed(error: Exception, options: argparse.Namespace) -> str:
    """What went wrong and where, and what to do."""
    from ._shards import is_lasting, told

    said = str(error)
    if isinstance(error, OSError) and error.errno:  # one of the system, whose own text names an errno
        place = error.filename or getattr(options, "folder", None) or options.what
        said = told(place, "cannot be used", error)
    helps = options.verb in ("run", "optimise") and not is_lasting(error)
    return said + "; run again to resume" * helps


def main(words: Sequence[str] | None = None) -> int:
    """Runs the command and returns its exit status."""
    options = _parser().parse_args(words)
    try:
        status = _status(options)
        sys.stdout.flush()
        return status
    except BrokenPipeError:  # what reads the output has enough; Python itself flushes once more
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return 1
    except KeyboardInterrupt:
        print("hdconj study: stopped; run again to resume", file=sys.stderr)
        return 1


def _status(options: argparse.Namespace) -> int:
    """The exit status of a command, which says on stderr what went wrong."""
    try:
        from .._errors import FileError, InputError, fault_text
        from ._engine import EngineLost
    except ImportError as error:
        print(f"hdconj study: the package {error.name} is missing; {PACKAGES}", file=sys.stderr)
        return 1
    try:
        return 0 if _act(options) else 1
    except ImportError as error:
        print(f"hdconj study: the package {error.name} is missing; {PACKAGES}", file=sys.stderr)
        return 1
    except InputError as error:
        count = len(error.faults)
        told = tuple(
            fault if fault.line else fault._replace(path=OPTIONS.get(fault.path, fault.path)) for fault in error.faults
        )
        said = str(error) if told == error.faults else fault_text(told)
        print(f"hdconj study: {count} fault{'s' if count > 1 else ''} in {options.what}\n{said}", file=sys.stderr)
        return 2
    except BrokenPipeError:
        raise
    except (EngineLost, FileError, OSError) as error:
        print(f"hdconj study: {_failed(error, options)}", file=sys.stderr)
        return 1


if __name__ == "__main__":
    sys.exit(main())
