#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Tables about the elastic cup, from what the program prints: docs/tables/elastic.py PROGRAM [--csv] [TABLE ...]

TABLE is any of: cup, teeth, play, held, fillets; all of them without one. With --csv a table is comma-separated, as
data/reference/elastic-TABLE.csv has it, in place of Markdown.
"""

import json
import os
import re
import subprocess
import sys
import tempfile

from contact import head, make, row

SCENE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "data", "scenes", "type-50-elastic.toml")


def cup(program, *settings):
    """Coning [deg], force [N] and gap at the balls [um] of one cup; settings are those of --set."""
    with tempfile.TemporaryDirectory() as folder:
        command = [program, "export", SCENE, "--vtu", os.path.join(folder, "cup.vtu"), "--steps", "4"]
        for setting in settings:
            command += ["--set", setting]
        done = subprocess.run(command, capture_output=True, text=True)
        if done.returncode != 0:
            sys.exit(done.stderr.strip())
    coning, force = re.search(
        r"con(?:es by|ing)(?: of the whole toothed ring)? (\S+)(?: \+- \S+)? degrees.*(?:with|cup) (\S+)(?: \+- \S+)? N", done.stdout
    ).groups()
    gap = re.search(r"balls .*?(\S+) um", done.stdout)
    return {
        "coning": "%.3f" % float(coning),
        "force": "%.0f" % float(force),
        "gap": "%.1f" % float(gap.group(1)) if gap else "0",
    }


def assembled(program, *settings):
    """The cup on its wave generator, without torque, and the stated error of each figure."""
    with tempfile.TemporaryDirectory() as folder:
        command = [
            program,
            "load",
            SCENE,
            "--surface",
            "per-slice",
            "--no-curve",
            "--json",
            "--quiet",
            "-o",
            os.path.join(folder, "l.h5"),
            *[word for setting in settings for word in ("--set", setting)],
        ]
        return json.loads(subprocess.run(command, capture_output=True, text=True, check=True).stdout)["load"]["cup"]


def cup_state(program):
    state = assembled(program, "circular_spline.backlash_offset=0.04")
    head("figure", "value", "+-")
    for key, digits in (
        ("coning_major_deg", 3),
        ("coning_minor_deg", 3),
        ("wave_generator_force_N", 0),
        ("largest_stress_MPa", 0),
    ):
        row(key, "%.*f" % (digits, state[key]), "%.2g" % state["error"][key])


def teeth(program):
    head("steel in the layer of teeth", "coning [deg]", "force [N]")
    for share in (None, 0.01, 0.1, 0.3, 0.5, 1.0):
        found = (
            cup(program)
            if share is None
            else cup(program, "flexspline.cup.tooth_layer=0.53", "flexspline.cup.tooth_share=%g" % share)
        )
        row("none" if share is None else "%g" % share, found["coning"], found["force"])


def play(program):
    head("cam_oversize [um]", "coning [deg]", "force [N]", "ring off its balls by up to [um]")
    for oversize in (10, 5, 0, -5, -10, -20, -50):
        found = cup(program, "bearing.cam_oversize=%g" % (oversize / 1000))
        row(oversize, found["coning"], found["force"], found["gap"])


def held(program):
    """Balls held along the axis or free to move along it."""
    head("axially", "coning [deg]", "force [N]")
    for axially in ("held", "free"):
        found = cup(program, "bearing.axially=" + axially)
        row(axially, found["coning"], found["force"])


def fillets(program):
    head("beside the teeth", "circles", "coning [deg]", "force [N]", "largest stress [MPa]", "+-")
    for radius in (None, 0.3, 0.5, 1.0):
        for circles in (13, 49):
            settings = ["bearing.circles=%d" % circles, "bearing.angles=48"]
            if radius is not None:
                settings += [
                    "!flexspline.cup.rear_ramp",
                    "!flexspline.cup.front_ramp",
                    "flexspline.cup.rear_fillet=%g" % radius,
                    "flexspline.cup.front_fillet=%g" % radius,
                ]
            found, state = cup(program, *settings), assembled(program, *settings)
            row(
                "ramp of 0.4" if radius is None else "arc of %g" % radius,
                circles,
                found["coning"],
                found["force"],
                "%.0f" % state["largest_stress_MPa"],
                "%.0f" % state["error"]["largest_stress_MPa"],
            )


TABLES = {"cup": cup_state, "teeth": teeth, "play": play, "held": held, "fillets": fillets}

if __name__ == "__main__":
    make(TABLES, (), __doc__)
