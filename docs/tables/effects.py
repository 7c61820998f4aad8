#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""What each effect costs, next to the scene without effects: docs/tables/effects.py build/release/bin/hdconj [REPEATS]

Every effect is run in turn, the whole round again and again, so that a busy machine is busy for all of them alike. Times are user time of the whole
program on one thread, medians; only their ratios mean something.
"""
import os
import resource
import statistics
import subprocess
import sys
import tempfile

CONED = ["--set", "coning.model=linear", "--set", "coning.bottom_to_middle=9", "--set", "coning.apex_height=0.43"]
NINE = ["--set", "slices.count=9"]


def surface(name):
    return [*NINE, "--set", "slices.surface=" + name]


def tilted(angle, kind):
    return ["--set", f"tilt.angle_deg={angle}", "--set", "tilt.kind=" + kind]


SHORT_RUNS = 10  # a clock that ticks in milliseconds says little about one of them

ROUNDS = {
    "solve": [
        ("base", []),
        ("kinematics first-order", ["--set", "solver.kinematics=first-order"]),
        ("kinematics material", ["--set", "solver.kinematics=material"]),
        ("backlash_offset 0.01", ["--set", "circular_spline.backlash_offset=0.01"]),
        ("root_clearance 0.05", ["--set", "circular_spline.root_clearance=0.05"]),
        ("9 slices, tilted", surface("tilted")),
        ("9 slices, tilt 0.2 radial", [*surface("tilted"), *tilted(0.2, "radial")]),
        ("9 slices, tilt 0.2 draft", [*surface("tilted"), *tilted(0.2, "draft")]),
        ("coning alone", CONED),
        ("coning, 9 slices, tilted", [*CONED, *surface("tilted")]),
        ("coning, 9 slices, ruled", [*CONED, *surface("ruled")]),
        ("coning, 9 slices, per-slice", [*CONED, *surface("per-slice")]),
        ('coning, 9 slices, tilted, "auto"', [*CONED, *surface("tilted"), "--set", "circular_spline.backlash_offset=auto"]),
    ],
    "contact": [
        ("one slice", []),
        ("9 slices", surface("tilted")),
        ("9 slices, tilt 0.2 radial", [*surface("tilted"), *tilted(0.2, "radial")]),
        ("9 slices, tilt 0.2 draft", [*surface("tilted"), *tilted(0.2, "draft")]),
        ("coning, no axial shift, tilted", [*CONED, *surface("tilted"), "--set", "coning.axial_shift=none"]),
        ("coning, axial shift, tilted", [*CONED, *surface("tilted")]),
        ("coning, axial shift, ruled", [*CONED, *surface("ruled")]),
        ("coning, axial shift, per-slice", [*CONED, *surface("per-slice")]),
        ("the same with 17 slices", [*CONED, "--set", "slices.count=17", "--set", "slices.surface=per-slice"]),
        ("the same with 33 slices", [*CONED, "--set", "slices.count=33", "--set", "slices.surface=per-slice"]),
    ],
}


def user_time(command):
    before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(" ".join(command) + "\n" + done.stderr)
    return resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before


def main():
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    program, repeats = sys.argv[1], int(sys.argv[2]) if len(sys.argv) == 3 else 7
    with tempfile.TemporaryDirectory() as folder:
        names = [(verb, name) for verb, effects in ROUNDS.items() for name, _ in effects]
        times = {each: [] for each in names}
        for _ in range(repeats):
            for verb, effects in ROUNDS.items():
                for name, arguments in effects:
                    command = [program, verb, "--quiet", "--threads", "1", "-o", os.path.join(folder, "result.h5"), *arguments]
                    runs = SHORT_RUNS if verb == "solve" else 1
                    times[verb, name].append(sum(user_time(command) for _ in range(runs)) / runs)
    base = statistics.median(times["solve", "base"])
    print("| verb | effect | time, ratio to base | least ... largest |")
    print("|---|---|---|---|")
    for verb, name in names:
        taken = times[verb, name]
        print(f"| `{verb}` | {name} | {statistics.median(taken) / base:.1f} | {min(taken) / base:.1f} ... {max(taken) / base:.1f} |")


main()
