#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Tables of docs/explanation/elastic-cup.md, from what the program prints: docs/tables/elastic.py build/release/bin/hdconj [TABLE ...]

TABLE is any of: teeth, play, fillets, cost; all of them without one.
"""
import os
import re
import subprocess
import sys
import tempfile
import time

from contact import head, row

SCENE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "data", "scenes", "type-50-elastic.toml")


def cup(program, *settings):
    """Coning [deg], force [N], gap at the balls [um] and seconds of one cup; settings are those of --set."""
    with tempfile.TemporaryDirectory() as folder:
        command = [program, "export", SCENE, "--vtu", os.path.join(folder, "cup.vtu"), "--steps", "4"]
        for setting in settings:
            command += ["--set", setting]
        start = time.perf_counter()
        done = subprocess.run(command, capture_output=True, text=True)
        took = time.perf_counter() - start
        if done.returncode != 0:
            sys.exit(done.stderr.strip())
        with open(os.path.join(folder, "cup.vtu")) as file:
            stress = re.search(r'Name="von_mises"[^>]*>\s*([^<]*)<', file.read()).group(1)
    coning, force = re.search(r"cones by (\S+)(?: \+- \S+)? degrees.* with (\S+)(?: \+- \S+)? N", done.stdout).groups()
    gap = re.search(r"off the balls by up to (\S+) um", done.stdout)
    return {"coning": "%.3f" % float(coning), "force": "%.0f" % float(force), "gap": "%.1f" % float(gap.group(1)) if gap else "0", "took": took,
            "stress": "%.0f" % max(map(float, stress.split()))}


def teeth(program):
    head("layer of teeth, 0.53 mm high", "coning [deg]", "force [N]")
    for share in (None, 0.01, 0.1, 0.3, 0.5, 1.0):
        found = cup(program) if share is None else cup(program, "flexspline.cup.tooth_layer=0.53", "flexspline.cup.tooth_share=%g" % share)
        row("none" if share is None else "%g of it steel" % share, found["coning"], found["force"])


def play(program):
    head("cam_oversize [um]", "coning [deg]", "force [N]", "ring off its balls by up to [um]")
    for oversize in (10, 5, 0, -5, -10, -20, -50):
        found = cup(program, "bearing.cam_oversize=%g" % (oversize / 1000))
        row(oversize, found["coning"], found["force"], found["gap"])


def fillets(program):
    head("beside the teeth", "circles", "coning [deg]", "force [N]", "largest stress at nodes [MPa]")
    for radius in (None, 0.3, 0.5, 1.0):
        for circles in (13, 49):
            settings = ["bearing.circles=%d" % circles, "bearing.angles=48"]
            if radius is not None:
                settings += ["!flexspline.cup.rear_ramp", "!flexspline.cup.front_ramp", "flexspline.cup.rear_fillet=%g" % radius, "flexspline.cup.front_fillet=%g" % radius]
            found = cup(program, *settings)
            row("ramp of 0.4" if radius is None else "arc of %g" % radius, circles, found["coning"], found["force"], found["stress"])


def cost(program):
    head("angles", "circles", "coning [deg]", "force [N]", "time [s]")
    for angles, circles in ((24, 7), (48, 7), (48, 13), (96, 13), (96, 17), (96, 33)):
        runs = [cup(program, "bearing.angles=%d" % angles, "bearing.circles=%d" % circles) for _ in range(3)]
        row(angles, circles, runs[0]["coning"], runs[0]["force"], "%.2f" % min(r["took"] for r in runs))


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    tables = {"teeth": teeth, "play": play, "fillets": fillets, "cost": cost}
    for name in sys.argv[2:] or tables:
        print("\n## " + name + "\n")
        tables[name](sys.argv[1])


if __name__ == "__main__":
    main()
