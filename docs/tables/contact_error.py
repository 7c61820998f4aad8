#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Whether the stated error of a contact share bounds its true one: docs/tables/contact_error.py build/release/bin/hdconj [DESIGNS]

Every share of the ladder is held against a run that is many times finer, in flank points, in slices, and of random coned designs in both. Prints, per ladder, the
largest and the median ratio of stated to true error, and ends with status 1 where a true error is larger than what both runs state.
"""
import json
import os
import random
import statistics
import subprocess
import sys
import tempfile

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")
SURFACES = ("tilted", "ruled", "per-slice")
PLAIN, CONED = "type-50", "type-50-coned"


def state(program, scene, surface, slices, points, keys=()):
    with tempfile.TemporaryDirectory() as folder:
        command = [program, "contact", os.path.join(ROOT, "data/scenes", scene + ".toml"), "--json", "--quiet", "--surface", surface,
                   "-o", os.path.join(folder, "result.h5"), "--set", f"slices.count={slices}", "--set", "slices.surface=" + surface, "--set", f"contact.flank_points={points}"]
        for key in keys:
            command += ["--set", key]
        done = subprocess.run(command, capture_output=True, text=True)
        if done.returncode != 0:
            return done.stderr.strip().splitlines()[-1]
        case = json.loads(done.stdout)["contact"]["cases"][0]
        return case["state"]["share"], case["state"]["share_error"], case["backlash_offset_um"]


class Ladder:
    bad = 0

    def __init__(self, name):
        self.name, self.ratios, self.true, self.runs, self.refused = name, [], [], 0, 0

    def add(self, what, coarse, fine):
        if isinstance(coarse, str) or isinstance(fine, str):
            self.refused += 1
            print(f"<!-- {self.name}, {what}: {coarse if isinstance(coarse, str) else fine} -->")
            return
        self.runs += 1
        true, stated = abs(coarse[0] - fine[0]), coarse[1]
        if true > stated + fine[1]:
            Ladder.bad += 1
            print(f"<!-- NOT BOUNDED {self.name}, {what}: {coarse} {fine} -->")
        if true > 0:
            self.ratios.append(stated / true)
        if fine[0] > 0:
            self.true.append(true / fine[0])

    def row(self):
        within = sum(ratio >= 1 for ratio in self.ratios)
        print(f"| {self.name} | {self.runs} | {100 * statistics.median(self.true):.2g} ... {100 * max(self.true):.2g} | "
              f"{within} of {len(self.ratios)} | {min(self.ratios):.2g} | {statistics.median(self.ratios):.2g} |")
        sys.stdout.flush()


def design(seed):
    """A cone, a clearance, a gap and an angle of the wave generator."""
    draw = random.Random(seed)
    keys = [f"wave_generator.radial_deformation={draw.uniform(0.242, 0.258):.6f}", f"coning.bottom_to_middle={draw.uniform(8, 30):.4f}",
            f"contact.contact_gap={draw.choice((0.0005, 0.001, 0.003)):g}", f"contact.wave_generator_angle_deg={draw.uniform(-1.5, 1.5):.4f}",
            f"coning.axial_shift={draw.choice(('none', 'mapped'))}", f"flexspline.profile.convex_radius={draw.uniform(0.266, 0.274):.5f}"]
    surface = draw.choice(SURFACES)
    if draw.random() < 0.4:
        keys += [f"tilt.angle_deg={draw.uniform(-0.3, 0.3):.4f}", "tilt.kind=" + (draw.choice(("radial", "draft")) if surface == "tilted" else "radial")]
    if draw.random() < 0.3:
        keys.append(f"circular_spline.backlash_offset={draw.uniform(0.002, 0.02):.5f}")
    return surface, keys


def main():
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    program, designs = sys.argv[1], int(sys.argv[2]) if len(sys.argv) == 3 else 30
    print("| ladder | runs | true error [% of the share], median ... largest | stated >= true | least ratio | median ratio |\n|---|---|---|---|---|---|")
    points = (50, 100, 200, 400)
    ladder = Ladder("flank points 50 ... 400 against 1600, one plane")
    for angle in (0, 0.7):
        keys = ["circular_spline.backlash_offset=0.005", f"contact.wave_generator_angle_deg={angle}"]
        fine = state(program, PLAIN, "tilted", 1, 1600, keys)
        for each in points:
            ladder.add(each, state(program, PLAIN, "tilted", 1, each, keys), fine)
    ladder.row()
    for surface in SURFACES:
        ladder = Ladder(f"flank points 50 ... 400 against 1600, coned, \"{surface}\"")
        for shift in ("none", "mapped"):
            keys = ["coning.axial_shift=" + shift]
            fine = state(program, CONED, surface, 3, 1600, keys)
            for each in points:
                # the error across the slices is the same in both
                coarse = state(program, CONED, surface, 3, each, keys)
                ladder.add(f"{shift}, {each}", coarse, fine)
        ladder.row()
    for surface in SURFACES:
        ladder = Ladder(f"2 ... 9 slices against 65, coned, \"{surface}\"")
        for shift in ("none", "mapped"):
            keys = ["coning.axial_shift=" + shift]
            fine = state(program, CONED, surface, 65, 100, keys)
            for each in (2, 3, 4, 5, 6, 7, 9):
                ladder.add(f"{shift}, {each}", state(program, CONED, surface, each, 100, keys), fine)
        ladder.row()
    ladder = Ladder("3 and 5 slices, 50 points against 33 and 500, random coned designs")
    for seed in range(designs):
        surface, keys = design(seed)
        fine = state(program, CONED, surface, 33, 500, keys)
        for slices in (3, 5):
            ladder.add(f"{seed}, {surface}, {keys}, {slices}", state(program, CONED, surface, slices, 50, keys), fine)
    ladder.row()
    sys.exit(1 if Ladder.bad else 0)


main()
