#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Ends every verb at random moments by INT, TERM, HUP and KILL.

  interrupt_verbs.py PROGRAM [--times N] [--verbs VERB...]   each of the verbs N times [8; 100 is the long test]

Half of the moments are drawn from the whole run, half from the time at which a temporary is there. An old result is
there each time. Afterwards every file and folder is the old one or the new one, whole; no temporary stays of a run that
could end by itself, and none at all after the next run. Prints one line a verb; exit status 1 where something is wrong,
77 without gnuplot, which draws some of the files.
"""

import argparse
import hashlib
import os
import random
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import h5py

SIGNALS = [signal.SIGINT, signal.SIGTERM, signal.SIGHUP, signal.SIGKILL]
# What makes a run quick, and every kind of file that it can write.
VERBS = {
    "check": "",
    "init": "--force a.toml",
    "solve": "-o a.h5 --dxf a.dxf --picture a.svg",
    "contact": "--set contact.flank_points=40 -o a.h5 --stl a.stl --vtk a.vtk --xdmf a.xdmf --picture a.svg",
    "load": "--set slices.count=3 --no-curve -o a.h5 --vtu a.vtu --picture a.svg",
    "wedm": "--tilt 0.2 -o wires --picture a.svg",
    "export": "--calculix deck --vtu a.vtu --steps 8",
    "accuracy": "--study polynomial-fit --quick --sample 0 -o study --page a.md",
}
CHANGED = ["--set", "wave_generator.radial_deformation=0.249"]
LONGEST_WRITE = 0.03  # s
TIMED = {"accuracy"}  # measures times: only the scene of its records is the same in two runs


def content_of(file, timed):
    """What a file holds, but for date and times of the run."""
    if file.suffix != ".h5":
        return file.stat().st_size > 0 if timed else file.read_bytes()
    with h5py.File(file, "r") as stored:
        found = hashlib.sha256(str(stored.attrs["scene"]).encode())

        def add(name, item):
            if isinstance(item, h5py.Dataset) and not name.endswith("seconds") and not timed:
                found.update(repr((name, item[()].tolist())).encode())

        stored.visititems(add)
    return found.digest()


def contents(folder, timed):
    """Of each target in a folder; of a folder in it as a whole."""
    found = {}
    for item in folder.iterdir():
        files = sorted(item.rglob("*")) if item.is_dir() else [item]
        found[item.name] = [(file.name, content_of(file, timed)) for file in files if file.is_file()]
    return found


def hidden(folder):
    return sorted(name for name in os.listdir(folder) if name.startswith("."))


class Trial:
    """One verb: its old and its new result, and what is wrong."""

    def __init__(self, program, verb, place):
        self.program, self.verb, self.place = program, verb, place
        self.timed = verb in TIMED
        self.command = [program, verb, *VERBS[verb].split(), "--quiet"]
        self.old, self.new = place / "old", place / "new"
        self.faults = []
        for folder, changed in ((self.old, []), (self.new, CHANGED)):
            folder.mkdir()
            begin = time.monotonic()
            subprocess.run(self.changed(changed), cwd=folder, check=True, stdout=subprocess.DEVNULL)
            self.seconds = time.monotonic() - begin
        if verb == "init":  # writes the same file always
            (self.old / "a.toml").write_text("old\n")
        self.whole = [contents(folder, self.timed) for folder in (self.old, self.new)]
        self.struck = 0

    def changed(self, options):
        return self.command + (options if self.verb != "init" else [])

    def want(self, condition, text):
        if not condition:
            self.faults.append(f"{self.verb}: {text}")

    def end_once(self, number, wait, at_write):
        folder = self.place / "now"
        shutil.rmtree(folder, ignore_errors=True)
        shutil.copytree(self.old, folder)
        run = subprocess.Popen(self.changed(CHANGED), cwd=folder, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        begin = time.monotonic()
        moment = begin + wait * self.seconds
        while run.poll() is None and (not hidden(folder) if at_write else time.monotonic() < moment):
            time.sleep(0.0005)
        if at_write:
            time.sleep(wait * LONGEST_WRITE)
        if run.poll() is not None:
            self.seconds = (self.seconds + time.monotonic() - begin) / 2
            return
        run.send_signal(number)
        status = run.wait(60)
        self.struck += status != 0
        what = f"after {signal.Signals(number).name} at {wait:.3f} of the {'write' if at_write else 'run'}"
        self.want(status in (0, -number), f"status {status} {what}")
        self.want(number == signal.SIGKILL or not hidden(folder), f"{hidden(folder)} left {what}")
        subprocess.run([self.program, "init", "next.toml", "--quiet"], cwd=folder, check=True)
        (folder / "next.toml").unlink()
        self.want(not hidden(folder), f"{hidden(folder)} left by the next run {what}")
        found = contents(folder, self.timed)
        self.want(found.keys() == self.whole[0].keys(), f"{sorted(found)} are there {what}")
        for name, content in found.items():
            self.want(content in [whole.get(name) for whole in self.whole], f"{name} is neither old nor new {what}")


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("program")
    parser.add_argument("--times", type=int, default=8)
    parser.add_argument("--verbs", nargs="+", default=list(VERBS))
    given = parser.parse_args()
    if shutil.which("gnuplot") is None:
        print("NOT TRIED: gnuplot")
        return 77
    os.environ["SOURCE_DATE_EPOCH"] = "1000000000"
    draw = random.Random(1)
    faults = []
    for verb in given.verbs:
        with tempfile.TemporaryDirectory() as place:
            trial = Trial(str(Path(given.program).resolve()), verb, Path(place))
            for i in range(given.times):
                trial.end_once(SIGNALS[i % len(SIGNALS)], draw.random(), i // len(SIGNALS) % 2 == 1)
            print(f"{verb}: ended {trial.struck} times of {given.times}, {len(trial.faults)} faults", flush=True)
            faults += trial.faults
    print(*faults, sep="\n", end="")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
