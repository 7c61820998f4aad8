#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Whether the stated errors of `contact` bound the true ones.

    docs/tables/contact_error.py PROGRAM [--csv] [DESIGNS [random]]

Compares coarse runs with much finer ones: in flank points, in slices, and of random coned designs in both. Prints the
least and the median ratio of stated to true error. Ends with status 1 where a true error is larger than what both runs
state. With `random` only the random designs.
"""

import json
import os
import random
import statistics
import subprocess
import sys
import tempfile

from contact import CSV, ROOT, head, row

SURFACES = ("tilted", "ruled", "per-slice")
PLAIN, CONED = "type-50", "type-50-coned"


def state(program, scene, surface, slices, points, keys=()):
    with tempfile.TemporaryDirectory() as folder:
        command = [
            program,
            "contact",
            os.path.join(ROOT, "data/scenes", scene + ".toml"),
            "--json",
            "--quiet",
            "--surface",
            surface,
            "-o",
            os.path.join(folder, "result.h5"),
            "--set",
            f"slices.count={slices}",
            "--set",
            "slices.surface=" + surface,
            "--set",
            f"contact.flank_points={points}",
        ]
        for key in keys:
            command += ["--set", key]
        done = subprocess.run(command, capture_output=True, text=True)
        if done.returncode != 0:
            return done.stderr.strip().splitlines()[-1]
        return json.loads(done.stdout)["contact"]["cases"][0]


def share(case):
    return case["state"]["contact_fraction"], case["state"]["contact_fraction_error"]


FIGURES = {
    "least clearance of the flanks [um]": lambda case: (
        case["closest_flank"]["clearance_um"],
        case["clearance_error_um"],
    ),
    "least clearance of the root [um]": lambda case: (
        min(each["root"]["clearance_um"] for each in case["slices"]),
        case["root_clearance_error_um"],
    ),
    "least side clearance [um]": lambda case: (case["least_side_clearance_um"], case["least_side_clearance_error_um"]),
    "tip circle [mm]": lambda case: (case["least_tip_radius_mm"], case["least_tip_radius_error_mm"]),
    "more root clearance [um]": lambda case: (case["least_root_clearance_um"], case["least_root_clearance_error_um"]),
    "backlash with the least side clearance [arcmin]": lambda case: (
        case["backlash_of_least_side_clearance_arcmin"],
        case["backlash_of_least_side_clearance_error_arcmin"],
    ),
    "turn to first contact [arcmin]": lambda case: (
        case["state"]["turn_to_contact_arcmin"],
        case["state"]["turn_to_contact_error_arcmin"],
    ),
    "backlash [arcmin]": lambda case: (case["state"]["backlash_arcmin"], case["state"]["backlash_error_arcmin"]),
    "smallest gap [um]": lambda case: (case["state"]["smallest_gap_um"], case["state"]["smallest_gap_error_um"]),
    "deviation of a ruled surface [um]": lambda case: (case["ruled_deviation_um"], case["ruled_deviation_error_um"]),
}


class Comparison:
    bad = 0

    def __init__(self, name, figure=share):
        self.name, self.figure, self.ratios, self.true, self.stated, self.runs, self.refused = (
            name,
            figure,
            [],
            [],
            [],
            0,
            0,
        )

    def add(self, what, coarse, fine):
        if isinstance(coarse, str) or isinstance(fine, str):
            self.refused += 1
            print(f"<!-- {self.name}, {what}: {coarse if isinstance(coarse, str) else fine}", file=sys.stderr)
            return
        coarse, fine = self.figure(coarse), self.figure(fine)
        self.runs += 1
        self.stated.append(coarse[1])
        true, stated = abs(coarse[0] - fine[0]), coarse[1]
        if true > stated + fine[1]:
            Comparison.bad += 1
            print(f"<!-- NOT BOUNDED {self.name}, {what}: {coarse} {fine}", file=sys.stderr)
        if true > 0:
            self.ratios.append(stated / true)
        if fine[0] > 0:
            self.true.append(true / fine[0])

    def row(self):
        within = sum(ratio >= 1 for ratio in self.ratios) + self.runs - len(self.ratios)
        true = ["%.2g" % (100 * of(self.true)) if self.true else "" for of in (statistics.median, max)]
        row(
            self.name,
            self.runs,
            *true,
            within,
            *["%.2g" % of(self.ratios) if self.ratios else "" for of in (min, statistics.median)],
        )


def design(seed):
    """A cone, a clearance, a gap and an angle of the wave generator."""
    draw = random.Random(seed)
    keys = [
        f"wave_generator.radial_deformation={draw.uniform(0.242, 0.258):.6f}",
        f"coning.bottom_to_middle={draw.uniform(8, 30):.4f}",
        f"contact.contact_gap={draw.choice((0.0005, 0.001, 0.003)):g}",
        f"contact.wave_generator_angle_deg={draw.uniform(-1.5, 1.5):.4f}",
        f"coning.axial_shift={draw.choice(('none', 'mapped'))}",
        f"flexspline.profile.convex_radius={draw.uniform(0.266, 0.274):.5f}",
    ]
    surface = draw.choice(SURFACES)
    if draw.random() < 0.4:
        keys += [
            f"tilt.angle_deg={draw.uniform(-0.3, 0.3):.4f}",
            "tilt.kind=" + (draw.choice(("radial", "draft")) if surface == "tilted" else "radial"),
        ]
    if draw.random() < 0.3:
        keys.append(f"circular_spline.backlash_offset={draw.uniform(0.002, 0.02):.5f}")
    return surface, keys


def random_designs(program, designs):
    comparison = Comparison("random designs: 3 and 5 slices and 50 points against 33 and 500")
    others = [Comparison(name, figure) for name, figure in FIGURES.items()]
    outside = runs = elsewhere = 0
    for seed in range(designs):
        surface, keys = design(seed)
        fine = state(program, CONED, surface, 33, 500, keys)
        for slices in (3, 5):
            coarse = state(program, CONED, surface, slices, 50, keys)
            what = f"{seed}, {surface}, {keys}, {slices}"
            comparison.add(what, coarse, fine)
            if isinstance(coarse, str) or isinstance(fine, str):
                continue
            for other in others:
                other.add(what, coarse, fine)
            runs += 1
            if not coarse["state"]["teeth_least"] <= fine["state"]["teeth"] <= coarse["state"]["teeth_most"]:
                outside += 1
                teeth = [
                    [case["state"][key] for key in ("teeth_least", "teeth", "teeth_most")] for case in (coarse, fine)
                ]
                print(f"<!-- OUTSIDE teeth, {what}: {teeth}", file=sys.stderr)
            for where, place, case in ((coarse["state"], "smallest_z", fine["state"]), (coarse, "closest_z", None)):
                z = (case if case else fine["closest_flank"])["smallest_z_mm" if case else "z_mm"]
                low, high = ((fine["state"] if case else fine)[place + end] for end in ("_from_mm", "_to_mm"))
                # both ranges share a plane, and the finer place is in the coarser range or its own reaches into it
                if max(low, where[place + "_from_mm"]) > min(high, where[place + "_to_mm"]):
                    elsewhere += 1
                    found = f"{where[place + '_from_mm']} ... {where[place + '_to_mm']}"
                    print(f"<!-- ELSEWHERE {place}, {what}: {found}, {z} in {low} ... {high}", file=sys.stderr)
    if runs == 0:
        return
    for each in (comparison, *others):
        each.row()
    row("teeth", runs, "", "", runs - outside, "", "")
    row("places along z", 2 * runs, "", "", 2 * runs - elsewhere, "", "")
    Comparison.bad += outside + elsewhere


def main():
    if len(sys.argv) not in (2, 3, 4) or sys.argv[3:] not in ([], ["random"]):
        sys.exit(__doc__)
    program, designs = sys.argv[1], int(sys.argv[2]) if len(sys.argv) > 2 else 30
    if CSV:
        print(f"# made by (long): docs/tables/contact_error.py PROGRAM --csv {designs}")
    head(
        "comparison",
        "runs",
        "true error, median [%]",
        "largest [%]",
        "runs within the estimate",
        "estimate over true error, least",
        "median",
    )
    if len(sys.argv) < 4:
        series(program)
    random_designs(program, designs)
    sys.exit(1 if Comparison.bad else 0)


def series(program):
    points = (50, 100, 200, 400)
    comparison = Comparison("flank points 50 ... 400 against 1600")
    for angle in (0, 0.7):
        keys = ["circular_spline.backlash_offset=0.005", f"contact.wave_generator_angle_deg={angle}"]
        fine = state(program, PLAIN, "tilted", 1, 1600, keys)
        for each in points:
            comparison.add(each, state(program, PLAIN, "tilted", 1, each, keys), fine)
    comparison.row()
    for surface in SURFACES:
        comparison = Comparison(f"the same on a cone: {surface}")
        for shift in ("none", "mapped"):
            keys = ["coning.axial_shift=" + shift]
            fine = state(program, CONED, surface, 3, 1600, keys)
            for each in points:
                # the error across the slices is the same in both
                coarse = state(program, CONED, surface, 3, each, keys)
                comparison.add(f"{shift}, {each}", coarse, fine)
        comparison.row()
    for surface in SURFACES:
        comparison = Comparison(f"2 ... 9 slices against 65 on a cone: {surface}")
        for shift in ("none", "mapped"):
            keys = ["coning.axial_shift=" + shift]
            fine = state(program, CONED, surface, 65, 100, keys)
            for each in (2, 3, 4, 5, 6, 7, 9):
                comparison.add(f"{shift}, {each}", state(program, CONED, surface, each, 100, keys), fine)
        comparison.row()


main()
