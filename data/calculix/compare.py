#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Compares what CalculiX printed with what hdconj expects.

    ccx linear && python3 compare.py linear
    ccx contact && python3 compare.py contact

linear: the displacements of the nodes NWATCH, within 1 % of the largest.
contact: the same within 2 %, since the grids of contact points differ, and the force between bearing and cup within
3 %. Exit status 0: they agree; 1: they do not; 2: a file is missing.
"""
import csv
import math
import sys
from pathlib import Path


def block(lines, title):
    """Rows of numbers below the last line of a .dat file that contains @p title."""
    begin = max((i for i, line in enumerate(lines) if title in line), default=None)
    if begin is None:
        sys.exit(f"no {title} in the .dat file: CalculiX has not ended")
    rows = []
    for line in lines[begin + 1:]:
        if line.strip():
            try:
                rows.append([float(word) for word in line.split() if word != "L"])  # L: axes of the node's own
            except ValueError:
                break
    return rows


def main(name):
    """Prints each comparison; the exit status."""
    lines = Path(name + ".dat").read_text().splitlines()
    with open("expected.csv", newline="") as file:
        rows = list(csv.DictReader(file))
    expected = {int(row["node"]): [float(row[key]) for key in ("u_r", "u_t", "u_z")] for row in rows}
    found = {int(row[0]): row[1:4] for row in block(lines, "displacements")}
    largest = max(math.hypot(*u) for u in expected.values())
    apart = max(math.dist(u, found[node]) for node, u in expected.items())
    results = [("displacements", apart / largest, 0.01 if name == "linear" else 0.02)]
    if name == "contact":
        with open("expected_contact.csv", newline="") as file:
            force = {row["quantity"]: float(row["value"]) for row in csv.DictReader(file)}
        sums = block(lines, "total surface force")[0]
        off = math.hypot(force["force_x_N"] + sums[0], force["force_y_N"] + sums[1])
        results.append(("force", off / math.hypot(force["force_x_N"], force["force_y_N"]), 0.03))
    for what, share, limit in results:
        verdict = "good" if share <= limit else "WRONG"
        print(f"{what}: {100 * share:.2g} % apart; {verdict}, the limit is {100 * limit:g} %")
    if all(share <= limit for _, share, limit in results):
        return 0
    why = "CalculiX may have ended in a wrong state of contact, or t" if name == "contact" else "T"
    print(f"{why}he elements are too coarse for this cup: write the deck with more --steps, such as 24 or 48, "
          "into a new folder")
    return 1


if __name__ == "__main__":
    if len(sys.argv) != 2 or sys.argv[1] not in ("linear", "contact"):
        sys.exit(__doc__)
    try:
        sys.exit(main(sys.argv[1]))
    except OSError as error:
        print(error, file=sys.stderr)
        sys.exit(2)
