#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Work of whole runs on one thread, and the errors that they state: docs/tables/cost.py PROGRAM [--csv] [TABLE ...]

TABLE is any of: tolerance, errors, verbs; all of them without one. Counts of points and contacts are the same on every
machine. Instructions are counted by callgrind (valgrind). Memory is the largest resident set.
"""

import json
import os
import re
import subprocess
import sys
import tempfile

from contact import ROOT, head, make, row

RUNS = {
    "--version": ["--version"],
    "check": ["check", "--quiet"],
    "solve": ["solve"],
    "solve a cycloid tooth": ["solve", "cycloid"],
    "contact": ["contact"],
    "contact of a cycloid tooth": ["contact", "cycloid", "--set", "circular_spline.width=7"],
    "export": ["export", "type-50-elastic", "--calculix", "deck"],
    "wedm": ["wedm", "--tilt", "0.2"],
    "contact on a cone: tilted": ["contact", "type-50-coned", "--surface", "tilted"],
    "contact on a cone: ruled": ["contact", "type-50-coned", "--surface", "ruled"],
    "contact on a cone: per-slice": ["contact", "type-50-coned", "--surface", "per-slice"],
    "load": ["load", "type-50-elastic", "--surface", "per-slice", "--torque", "28", "--no-curve"],
}


def command(program, words):
    """The command line of a run; a scene is named without folder and ending."""
    given = [
        (
            os.path.join(ROOT, "data/scenes", word + ".toml")
            if os.path.exists(os.path.join(ROOT, "data/scenes", word + ".toml"))
            else word
        )
        for word in words
    ]
    threads = ["--quiet", "--threads", "1"] if words[0] not in ("--version", "check") else []
    target = ["-o", "out"] if words[0] in ("solve", "contact", "load", "wedm") else []
    return [program, *given, *threads, *target]


def million_instructions(program, words):
    """Instructions of a run, by callgrind."""
    with tempfile.TemporaryDirectory() as folder:
        done = subprocess.run(
            ["valgrind", "--tool=callgrind", "--callgrind-out-file=counts", *command(os.path.abspath(program), words)],
            cwd=folder,
            capture_output=True,
            text=True,
        )
    found = re.search(r"Collected : (\d+)", done.stderr)
    if done.returncode or not found:
        sys.exit(f"{words}: {done.stderr}")
    return int(found[1]) / 1e6


def memory_MB(program, words):
    """Largest resident set of a run."""
    with tempfile.TemporaryDirectory() as folder:
        child = subprocess.Popen(command(os.path.abspath(program), words), cwd=folder, stdout=subprocess.DEVNULL)
        _, status, usage = os.wait4(child.pid, 0)
    if status:
        sys.exit(f"{words}: status {status}")
    return usage.ru_maxrss / 1024


def verbs(program):
    head("run", "million instructions", "+-", "memory [MB]", "+-")
    for name, words in RUNS.items():
        count, memory = million_instructions(program, words), memory_MB(program, words)
        row(name, "%.4g" % count, "%.2g" % (0.02 * count), "%.0f" % memory, "%.0f" % (0.2 * memory))


def tolerance(program):
    head("tolerance [mm]", "outline points", "contacts evaluated", "result file [MB]")
    for power in range(3, 12):
        words = ["solve", "--set", f"solver.tolerance=1e-{power}"]
        with tempfile.TemporaryDirectory() as folder:
            done = subprocess.run(
                [*command(os.path.abspath(program), words), "--json"],
                cwd=folder,
                capture_output=True,
                text=True,
                check=True,
            )
            size = os.path.getsize(os.path.join(folder, "out"))
        found = json.loads(done.stdout)
        row(f"1e-{power}", found["circular_spline"]["points"], found["work"]["envelope_points"], "%.2g" % (size / 1e6))


def errors(program):
    """What `solve` states of the errors of the built-in drive. Those that are rounding differ among processors."""
    with tempfile.TemporaryDirectory() as folder:
        done = subprocess.run(
            [*command(os.path.abspath(program), ["solve"]), "--json"],
            cwd=folder,
            capture_output=True,
            text=True,
            check=True,
        )
    head("figure", "value", "+-")
    for key, value in json.loads(done.stdout)["error"].items():
        if value > 0:
            row(key, "%.3g" % value, "%.1g" % (0.2 * value))


TABLES = {"tolerance": tolerance, "errors": errors, "verbs": verbs}

if __name__ == "__main__":
    make(TABLES, ("verbs",), __doc__)
