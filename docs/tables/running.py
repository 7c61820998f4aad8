#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Tables of running.md, from the program's own JSON: docs/tables/running.py PROGRAM [--csv] [TABLE ...]

TABLE is any of: sequences, efficiency, rest; all of them without one. With --csv a table is comma-separated, as
data/reference/running-TABLE.csv has it, in place of Markdown.
"""

import json
import os
import subprocess
import sys
import tempfile

from contact import head, make, row

FRICTION = {
    "friction__flanks": 0.08,
    "friction__bearing_load": 0.0005,
    "friction__bearing_speed": 2,
    "friction__viscosity_40": 100,
    "friction__viscosity_100": 11,
    "friction__seal": 0.01,
}
PER_SLICE = {"slices__surface": "per-slice", "slices__count": 9, "circular_spline__backlash_offset": 0.04}


def run(program, *arguments, **keys):
    """The object of a running drive, on the built-in scene; keys are --set, with __ for the dot."""
    with tempfile.TemporaryDirectory() as folder:
        command = [program, "run", "--json", "--quiet", "-o", os.path.join(folder, "result.h5"), *arguments]
        for key, value in keys.items():
            command += ["--set", key.replace("__", ".") + "=" + str(value)]
        done = subprocess.run(command, capture_output=True, text=True)
        if done.returncode != 0:
            sys.exit(done.stderr)
        return json.loads(done.stdout)["running"]


def of(sequence, key, digits):
    """A figure with its error."""
    unit = "arcsec" if key in ("peak_to_peak", "rms") else "Nm"
    error = sequence[f"{key}_error_{unit}"]
    return ["%.*g" % (digits, sequence[f"{key}_{unit}"]), "-" if error is None else "%.2g" % error]


def sequences(program):
    """Transmission error and torque on the wave generator: drives, spans and torques."""
    head("drive", "span", "torque [N m]", "positions", "peak to peak [arcsec]", "+-", "rms [arcsec]", "+-",
         "largest order", "its amplitude [arcsec]", "mean torque [N m]", "+-", "ripple [N m]", "+-")
    for name, arguments, keys in (
        ("plane", ["--torque", "0"], {}),
        ("plane pitch", ["--torque", "0"], {"errors__circular_spline__pitch_deviation": 0.002}),
        ("plane eccentric", ["--torque", "0"], {"errors__circular_spline__eccentricity": 0.005}),
        ("tilted", [], {}),
        ("per-slice", [], PER_SLICE),
        ("per-slice pitch", [], {**PER_SLICE, "errors__circular_spline__pitch_deviation": 0.002}),
    ):
        for each in run(program, *arguments, **keys)["sequences"]:
            order = max(each["spectrum"], key=lambda of: of["amplitude_arcsec"])
            torque = each["torque_Nm"]
            row(name, each["span"], "%.4g" % torque, len(each["positions"]), *of(each, "peak_to_peak", 3),
                *of(each, "rms", 3), "%.4g" % order["per_input"], "%.3g" % order["amplitude_arcsec"],
                *(of(each, "mean_torque", 4) + of(each, "torque_ripple", 3) if torque else ["-"] * 4))


def efficiency(program):
    """Efficiency over torque, speed and temperature."""
    head("temperature [deg C]", "speed [rpm]", "torque [N m]", "efficiency [%]", "+-", "input [N m]", "flanks [N m]",
         "M1 [N m]", "M0 [N m]", "seals [N m]")
    keys = {**PER_SLICE, **FRICTION, "running__temperatures": "[0, 40]", "running__speeds": "[500, 2000]"}
    for each in run(program, **keys)["losses"]["efficiency"]:
        row("%g" % each["temperature_degC"], "%g" % each["speed_rpm"], "%.4g" % each["torque_Nm"],
            "%.1f" % (100 * each["efficiency"]), "%.2g" % (100 * each["efficiency_error"]),
            *("%.3g" % each[key + "_Nm"] for key in ("input_torque", "flank_loss", "bearing_load_loss",
                                                     "bearing_speed_loss", "seal_loss")))


def rest(program):
    """What it takes to start, and what drives the wave generator back."""
    head("surface", "starting torque [N m]", "+-", "back-driving torque [N m]", "+-", "ball forces [N]", "+-",
         "largest sliding [mm/rad]", "+-")
    for name, keys in (("tilted", {}), ("per-slice", PER_SLICE)):
        losses = run(program, **keys, **FRICTION)["losses"]
        def of(figure, unit, digits):
            return "%.*g" % (digits, losses[figure + unit]), "%.2g" % losses[figure + "_error" + unit]
        row(name, *of("starting_torque", "_Nm", 3), *of("back_driving_torque", "_Nm", 3),
            *of("ball_load", "_N", 4), *of("largest_sliding", "_mm_per_rad", 3))


TABLES = {"sequences": sequences, "efficiency": efficiency, "rest": rest}

if __name__ == "__main__":
    make(TABLES, set(TABLES), __doc__)
