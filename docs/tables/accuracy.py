#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Errors of every setting on the built-in drive, without times: docs/tables/accuracy.py PROGRAM --csv [RECORDS.csv]

Runs `hdconj accuracy --sample 0`, which takes a minute, or reads the records of a run. Prints what data/reference/
accuracy.csv holds: the error of each study, method and setting, and the estimate over the error.
"""

import csv
import os
import subprocess
import sys
import tempfile

from contact import row

COUNTS = ("missed", "evaluations", "points")


def number(text):
    return float(text) if text else None


def error_of(record):
    """Distance of outline and reference where it is known, else the error of the points or of the figure."""
    return number(record["hausdorff"] or record["error"])


def measured(program):
    """Records of a fresh run."""
    with tempfile.TemporaryDirectory() as folder:
        study = os.path.join(folder, "study")
        subprocess.run(
            [program, "accuracy", "-o", study, "--sample", "0", "--repeats", "1", "--quiet"],
            check=True,
            stdout=subprocess.DEVNULL,
        )
        with open(os.path.join(study, "records.csv")) as file:
            return list(csv.DictReader(file))


def main():
    arguments = [each for each in sys.argv[1:] if each != "--csv"]
    if len(arguments) not in (1, 2):
        sys.exit(__doc__)
    if len(arguments) == 2:
        with open(arguments[1]) as file:
            records = list(csv.DictReader(file))
    else:
        records = measured(arguments[0])
    print("# made by (long): docs/tables/accuracy.py PROGRAM --csv")
    row("study", "method", "setting", "error", "unit", "error [um]", "estimate over error", *COUNTS)
    for record in records:
        if record["method"].startswith("reference: harmonics"):
            continue
        error, estimate, unit = error_of(record), number(record["estimate"]), record["unit"]
        row(
            record["study"],
            record["method"].replace(",", ""),
            "%g" % float(record["value"]),
            "" if error is None else "%.3g" % error,
            unit,
            "%.3g" % (1000 * error) if error is not None and unit == "mm" else "",
            "%.3g" % (estimate / error) if estimate and error and unit != "1" else "",
            *[record[key] for key in COUNTS]
        )


main()
