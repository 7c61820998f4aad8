#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The registrations of `hdconj inspect` against SciPy.

  inspect_with_scipy.py PROGRAM

Makes rings of the built-in drive's flexspline from the formulas of its double circular arc, with errors of shape and
noise, lets the program lay them on the nominal part, and does the same with scipy.optimize and a distance of its own.
"""
import json
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np
from scipy.optimize import least_squares, linprog, root

TEETH, SEAT = 200, 25.0  # number of teeth, radius of the pitch line
AGREEMENT = 1e-10  # mm
OF_LEAST_SQUARES = 1e-8  # mm; places along the flank enter, which the program knows to some millionth of its length
H_A, H_F, R_A, L_A, R_F, B_F, H_T = 0.2250, 0.3030, 0.2701, 0.0982, 0.5145, 0.0671, 0.1900
CONVEX = np.array([-L_A, 0.0])
CONCAVE = np.array([np.sqrt((R_A + R_F) ** 2 - B_F ** 2) - L_A, B_F])
JOINT = np.arctan2(B_F, CONCAVE[0] + L_A)
TIP, ROOT = np.arcsin(H_T / R_A), np.arcsin((B_F + H_F) / R_F)
N_TIP = np.array([np.cos(TIP), np.sin(TIP)])
LINE_FROM = CONVEX + R_A * N_TIP
LINE_LENGTH = (H_A - H_T) / N_TIP[0]
LENGTHS = (R_F * (ROOT - JOINT), R_A * (TIP - JOINT), LINE_LENGTH)


def right_flank(s):
    """Point and outward normal at an arc length from the root; y from the pitch line."""
    if s < LENGTHS[0]:
        angle = ROOT - s / R_F
        n = np.array([np.cos(angle), np.sin(angle)])
        return CONCAVE - R_F * n, n
    s -= LENGTHS[0]
    if s < LENGTHS[1]:
        angle = JOINT + s / R_A
        n = np.array([np.cos(angle), np.sin(angle)])
        return CONVEX + R_A * n, n
    return LINE_FROM + (s - LENGTHS[1]) * np.array([-N_TIP[1], N_TIP[0]]), N_TIP


def turned(p, angle):
    """Clockwise about the axis; p (n, 2)."""
    c, s = np.cos(angle), np.sin(angle)
    return np.stack([c * p[..., 0] + s * p[..., 1], -s * p[..., 0] + c * p[..., 1]], -1)


def distance_of(p):
    """Signed distance of points (n, 2) on right flanks, frame of the pitch line, from the nominal flank."""
    to_concave, to_convex = p - CONCAVE, p - CONVEX
    concave = R_F - np.hypot(*to_concave.T)
    convex = np.hypot(*to_convex.T) - R_A
    line = (p - LINE_FROM) @ N_TIP
    below = np.arctan2(-to_concave[:, 1], -to_concave[:, 0]) > JOINT
    above = np.arctan2(to_convex[:, 1], to_convex[:, 0]) > TIP
    return np.where(below, concave, np.where(above, line, convex))


def arc_fraction_of(p):
    """Place of the foot of points (n, 2) on right flanks: -1 at the root, 1 at the tip."""
    to_concave, to_convex = p - CONCAVE, p - CONVEX
    below = np.arctan2(-to_concave[:, 1], -to_concave[:, 0])
    above = np.arctan2(to_convex[:, 1], to_convex[:, 0])
    line = sum(LENGTHS[:2]) + (p - LINE_FROM) @ np.array([-N_TIP[1], N_TIP[0]])
    s = np.where(below > JOINT, R_F * (ROOT - below), np.where(above > TIP, line, LENGTHS[0] + R_A * (above - JOINT)))
    return 2 * s / sum(LENGTHS) - 1


def on_right_flank(unknowns, points, tooth, right):
    """Points in the frame of a right flank. The last unknown turns right flanks further and left ones less."""
    turn, x, y, excess = unknowns
    place = turned(points - np.array([x, y]), -(turn + np.where(right, excess, -excess)))
    place = turned(place, -tooth * 2 * np.pi / TEETH) - np.array([0, SEAT])
    place[:, 0] *= np.where(right, 1, -1)
    return place


def deviations(unknowns, points, tooth, right, probe):
    return distance_of(on_right_flank((*unknowns, 0)[:4], points, tooth, right)) - probe


def ring(seed, teeth, per_flank, probe):
    """Points of some teeth, with the numbers of their teeth and flanks, of a part that is turned and shifted."""
    rng = np.random.default_rng(seed)
    points, numbers, sides = [], [], []
    for tooth in teeth:
        for right in (False, True):
            off = rng.normal(0, 1e-3, 3)
            for s in np.linspace(0.08, 0.92, per_flank) * sum(LENGTHS):
                p, n = right_flank(s)
                xi = 2 * s / sum(LENGTHS) - 1
                p = p + n * (probe + off @ (1, xi, xi * xi) + rng.normal(0, 3e-4))
                points.append(turned(p * ((1 if right else -1), 1) + (0, SEAT), tooth * 2 * np.pi / TEETH))
                numbers.append(tooth)
                sides.append(right)
    moved = turned(np.array(points), rng.normal(0, 2e-4)) + rng.normal(0, 4e-3, 2)
    return moved, np.array(numbers), np.array(sides)


def slopes(residuals, at):
    """Central differences, in columns."""
    step = 1e-6
    return np.stack([(residuals(at + step * e) - residuals(at - step * e)) / (2 * step) for e in np.eye(len(at))], -1)


def minimum_zone(residuals, at):
    """Linear programs of SciPy until the references stay, then the equations of the references to the last digits."""
    for _ in range(12):
        d, rows = residuals(at), slopes(residuals, at)
        both = np.vstack([np.c_[rows, -np.ones(len(d))], np.c_[-rows, -np.ones(len(d))]])
        found = linprog([0, 0, 0, 1], both, np.r_[-d, d], bounds=[(None, None)] * 3 + [(0, None)], method="highs")
        at = at + found.x[:3]
    d = residuals(at)
    most = np.argsort(-np.abs(d))[:4]
    signs = np.sign(d[most])
    exact = root(lambda v: residuals(at + v[:3])[most] - signs * v[3], np.r_[0, 0, 0, np.abs(d).max()],
                 tol=1e-15)
    return at + exact.x[:3]


def with_common_errors(near, points, tooth, right, probe):
    """Least squares with a thickness, and a slope and a crowning of either side, as unknowns beside turn and shift.

    Slope and crowning are taken without what a turn of their side explains, so that they leave the turn to the rest.
    """
    def off(v):
        return deviations((v[0] / SEAT, v[1], v[2], v[3] / SEAT), points, tooth, right, probe)

    def equations(v):
        rows = slopes(off, v[:4])
        xi = arc_fraction_of(on_right_flank((v[0] / SEAT, v[1], v[2], v[3] / SEAT), points, tooth, right))
        patterns = []
        for side in (right, ~right):
            turn = np.where(side, rows[:, 0], 0)
            for power in (1, 2):
                bend = np.where(side, xi ** power, 0)
                patterns.append(bend - turn * (turn @ bend) / (turn @ turn))
        bends = np.stack(patterns, -1)
        return np.hstack([rows, bends]).T @ (off(v[:4]) + bends @ v[4:])

    return root(equations, np.r_[near, np.zeros(5)], tol=1e-15).x[:3]


def by_scipy(registration, points, tooth, right, probe):
    """Turn times radius and shift in mm."""
    if registration == "datum":
        return np.zeros(3)
    free = 1 if registration == "turn" else 3

    def residuals(v):
        return deviations((v[0] / SEAT, *np.r_[v[1:], np.zeros(3 - free)]), points, tooth, right, probe)

    near = least_squares(residuals, np.zeros(free), method="lm").x
    # the minimiser ends where the sum no longer changes; the roots of its gradient are sharper
    at = root(lambda v: slopes(residuals, v).T @ residuals(v), near, tol=1e-15).x
    if registration == "least-squares":
        return with_common_errors(at, points, tooth, right, probe)
    return minimum_zone(residuals, at) if registration == "minimum-zone" else np.r_[at, np.zeros(3 - free)]


def main(program):
    worst = 0
    cases = ((range(0, 200, 20), 0.0), (range(0, 200, 25), 0.05), ((0, 1, 62, 130), -0.02), (range(0, 200, 8), 0.0))
    for seed, (teeth, probe) in enumerate(cases, 1):
        points, tooth, right = ring(seed, teeth, 25, probe)
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "points.csv"
            file.write_text("x,y\n" + "".join(f"{x!r},{y!r}\n" for x, y in points.tolist()))
            for registration in ("datum", "turn", "least-squares", "minimum-zone"):
                out = subprocess.run([program, "inspect", str(file), "--register", registration, "--probe", str(probe),
                                      "--json"], capture_output=True, text=True, check=True).stdout
                found = json.loads(out)["placement"]
                ours = np.array([np.radians(found["turn_deg"]) * SEAT, found["shift_x_um"] / 1e3,
                                 found["shift_y_um"] / 1e3])
                away = np.abs(ours - by_scipy(registration, points, tooth, right, probe)).max()
                worst = max(worst, away / (OF_LEAST_SQUARES if registration == "least-squares" else AGREEMENT))
                print(f"seed {seed} {registration}: {away:.2e} mm")
    print(f"largest difference {worst:.2g} of what is allowed")
    return 0 if worst <= 1 else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
