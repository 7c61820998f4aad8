#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Contact of type-50 against tilt if the flanks were soft: docs/tables/soft_contact.py PROGRAM [--csv] [CLEARANCE]

An estimate for docs/explanation/contact.md, not part of the program. The gap map of `hdconj contact` is moved back to a
side clearance that the thesis' prototypes may have had (0.0225 mm by the backlash of 6.2 arcmin), so that the teeth
overlap. The circular spline is turned until the overlap, taken as the pressure of a bed of springs, makes a given
moment. What overlaps on the driving side is in contact.

Simplifications: gaps change by the clearance itself and by lever times turn; normals are those of the slice in the
middle; the tip circle is the least one. Tilts at which no surface can be made have no area. Needs h5py and numpy.
"""

import json
import os
import subprocess
import sys
import tempfile

import h5py
import numpy as np

from contact import CSV, head, row

SCENE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "data/scenes/type-50-coned.toml")
PLANE = os.path.join(os.path.dirname(SCENE), "type-50.toml")
TILTS = (-0.4, -0.2, 0, 0.1, 0.2, 0.3, 0.4, 0.6, 0.8, 1, 1.5)
MOMENTS = (5, 10, 20, 40, 80)  # mm^4: times the bed's stiffness in N/mm^3 a torque


class Bed:
    """Gaps of one tilt at the prototypes' clearance, and what a turn does to them."""

    def __init__(self, program, clearance, tilt, kind, shift):
        with tempfile.TemporaryDirectory() as folder:
            result = os.path.join(folder, "result.h5")
            command = [
                program,
                "contact",
                SCENE,
                "--surface",
                "tilted",
                "--kind",
                kind,
                f"--tilt={tilt}",
                "--json",
                "--quiet",
                "-o",
                result,
            ]
            for key in (
                f"circular_spline.backlash_offset={clearance}",
                "coning.axial_shift=" + shift,
                "contact.flank_points=120",
            ):
                command += ["--set", key]
            done = subprocess.run(command, capture_output=True, text=True)
            self.made = done.returncode == 0
            if not self.made:
                return
            case = json.loads(done.stdout)["contact"]["cases"][0]
            with h5py.File(result) as file:
                gap, station, z = (file["/contact/map/" + name][...] for name in ("gap", "flank_position", "z"))
            # points of a flank that an offset has cut away share a place, or have no gap: they touch nothing
            kept = np.diff(station, prepend=-1) > 0
            gap, station = np.nan_to_num(gap[..., kept], nan=1), station[kept]
            # the map's stations count along the flank without side clearance, at z = 0 the same for all tilts
            subprocess.run(
                [
                    program,
                    "solve",
                    PLANE,
                    "--quiet",
                    "-o",
                    result,
                    "--set",
                    f"circular_spline.inner_radius={case['least_tip_radius_mm']}",
                ],
                check=True,
            )
            with h5py.File(result) as file:
                outline = file["/circular_spline/outline"][0]
                first, last = file["/circular_spline/landmarks"][3:5]
        flank = outline[first : last + 1][::-1]
        length = np.concatenate([[0], np.cumsum(np.hypot(*np.diff(flank, axis=0).T))])
        x, y = (np.interp(station * length[-1], length, flank[:, axis]) for axis in (0, 1))
        along = np.hypot(np.gradient(x), np.gradient(y))
        n_x, n_y = -np.gradient(y) / along, np.gradient(x) / along
        n_x, n_y = np.sign(n_x.mean()) * n_x, np.sign(n_x.mean()) * n_y
        self.lever = y * n_x - x * n_y
        self.area = np.gradient(z)[:, None] * (np.gradient(station) * length[-1])[None, :]
        turned = np.radians(case["state"]["turn_to_contact_arcmin"] / 60)
        entered = case["backlash_offset_um"] / 1000 - clearance
        self.driving = gap[:, 1] - entered + turned * self.lever
        self.other = gap[:, 0] - entered - turned * self.lever

    def at(self, turn):
        """Moment and share of the driving flanks."""
        driving, other = self.driving - turn * self.lever, self.other + turn * self.lever
        pressed = np.maximum(-driving, 0) - np.maximum(-other, 0)
        return (pressed * self.lever * self.area).sum(), ((driving <= 0) * self.area).sum() / (
            self.area.sum() * len(driving)
        )

    def share(self, moment):
        low, high = -0.01, 0.01
        for _ in range(60):
            middle = (low + high) / 2
            low, high = (middle, high) if self.at(middle)[0] < moment else (low, middle)
        return self.at(low)[1]


def main():
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    clearance = float(sys.argv[2]) if len(sys.argv) == 3 else 0.0225
    if CSV:
        print(f"# made by (long): docs/tables/soft_contact.py PROGRAM --csv {clearance:g}")
        print("# flank that overlaps [%] at each tilt [deg]; the moment times the stiffness of the bed is a torque")
    head("kind", "axial shift", "moment [mm^4]", *TILTS, "best [deg]")
    for kind in ("radial", "draft"):
        for shift in ("none", "mapped"):
            beds = [Bed(sys.argv[1], clearance, tilt, kind, shift) for tilt in TILTS]
            for moment in MOMENTS:
                shares = [bed.share(moment) if bed.made else -1 for bed in beds]
                row(
                    kind,
                    shift,
                    moment,
                    *["%.2f" % (100 * s) if s >= 0 else "-" for s in shares],
                    TILTS[int(np.argmax(shares))],
                )


main()
