#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Instructions of whole runs, counted by callgrind: the measure that no other load on the machine changes.

  instructions.py PROGRAM            compare with instructions.csv: exit status 1 where a count has moved by more than 2
  %
  instructions.py PROGRAM --update   write that file anew

A table belongs to one compiler, its libraries and one kind of processor (by which the C library chooses its routines);
with others, or without valgrind, nothing is compared and the exit status is 77 (skipped).
"""

import csv
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

TABLE = pathlib.Path(__file__).with_name("instructions.csv")
ALLOWED = 0.02
CURVES = str(pathlib.Path(__file__).resolve().parents[2] / "data" / "scenes" / "cycloid.toml")
RUNS = {
    "check": ["check", "--quiet"],
    "solve 1e-3": ["solve", "--quiet", "--threads", "1", "--set", "solver.tolerance=1e-3", "-o", "a.h5"],
    "solve 1e-6": ["solve", "--quiet", "--threads", "1", "-o", "a.h5"],
    "solve 1e-8": ["solve", "--quiet", "--threads", "1", "--set", "solver.tolerance=1e-8", "-o", "a.h5"],
    "solve 1e-10": ["solve", "--quiet", "--threads", "1", "--set", "solver.tolerance=1e-10", "-o", "a.h5"],
    "solve a tooth of curves": ["solve", CURVES, "--quiet", "--threads", "1", "-o", "a.h5"],
    "contact": ["contact", "--quiet", "--threads", "1", "-o", "a.h5"],
    "contact of a tooth of curves": [
        "contact",
        CURVES,
        "--quiet",
        "--threads",
        "1",
        "--set",
        "circular_spline.width=7",
        "-o",
        "a.h5",
    ],
}


def build_of(program):
    said = subprocess.run([program, "--version"], capture_output=True, text=True, check=True).stdout.splitlines()
    with open("/proc/cpuinfo") as file:
        models = [line.split(":", 1)[1].strip() for line in file if line.startswith("model name")]
    return said[1].strip() + "; " + (models[0] if models else "unknown processor")


def count(program, arguments):
    with tempfile.TemporaryDirectory() as folder:
        done = subprocess.run(
            ["valgrind", "--tool=callgrind", "--callgrind-out-file=out", program, *arguments],
            cwd=folder,
            capture_output=True,
            text=True,
        )
        if done.returncode != 0:
            sys.exit(f"{' '.join(arguments)}: exit status {done.returncode}\n{done.stderr}")
        return int(re.search(r"Collected : (\d+)", done.stderr).group(1))


def main():
    program = str(pathlib.Path(sys.argv[1]).resolve())
    if shutil.which("valgrind") is None:
        print("skipped: no valgrind")
        return 77
    build = build_of(program)
    if "--update" in sys.argv:
        with TABLE.open("w", newline="") as file:
            table = csv.writer(file, lineterminator="\n")
            table.writerow(["run", "instructions", "build"])
            for name, arguments in RUNS.items():
                table.writerow([name, count(program, arguments), build])
        return 0
    with TABLE.open(newline="") as file:
        known = {row["run"]: (int(row["instructions"]), row["build"]) for row in csv.DictReader(file)}
    status = 0
    for name, arguments in RUNS.items():
        before, of = known[name]
        if of != build:
            print(f"skipped: the table is of '{of}', this program of '{build}'")
            return 77
        now = count(program, arguments)
        moved = now / before - 1
        print(f"{name}: {now / 1e6:.2f} million instructions, {100 * moved:+.2f} % against the table")
        if abs(moved) > ALLOWED:
            print(
                f"  more than {100 * ALLOWED:.0f} %: if it is meant, "
                f"run {pathlib.Path(__file__).name} PROGRAM --update and say why in the commit message"
            )
            status = 1
    return status


if __name__ == "__main__":
    sys.exit(main())
