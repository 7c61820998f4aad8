#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The built-in drive's flank as a notebook would compute it, beside hdconj: time at equal error, error at equal time.

  notebook.py build/release/bin/hdconj [LARGEST]

Three versions, written for this comparison: NumPy (f(t, u) on a grid of positions and profile points, sign changes, linear interpolation), SciPy (quad for
the arc length, brentq for each contact) and shapely (union of tooth positions). They compute the stretch of the right convex arc only, and are given
where it begins and ends; imports and reference are not timed. hdconj computes the whole tooth space, all branches certified, checked over a full turn, and is timed
as a process with its file; beside that stand the points of the whole boundary alone, in the library, branches given (study sampling of `hdconj accuracy`). Error: Hausdorff distance from hdconj's own outline at 1e-10 mm (which 50 digits confirm: `hdconj accuracy`).
LARGEST: seconds after which a version is made no finer [20].
"""
import json
import math
import os
import subprocess
import sys
import tempfile
import time

import h5py
import numpy as np
import shapely
import shapely.affinity
from scipy.integrate import quad
from scipy.optimize import brentq
from shapely.geometry import LineString, Point, Polygon
from shapely.ops import unary_union

program = os.path.abspath(sys.argv[1])
largest = float(sys.argv[2]) if len(sys.argv) > 2 else 20.0
folder = tempfile.TemporaryDirectory()


def hdconj(tolerance, threads):
    name = os.path.join(folder.name, "result.h5")
    start = time.perf_counter()
    subprocess.run([program, "solve", "--quiet", "--threads", str(threads), "--set", f"solver.tolerance={tolerance}", "-o", name], check=True)
    return time.perf_counter() - start, name


def flank_of(name):
    """Points of the outline that the right convex arc made, and the flexspline's tooth."""
    with h5py.File(name) as result:
        outline = result["circular_spline/outline"][0]
        pieces = result["circular_spline/pieces"]
        made = [(int(a), int(b)) for k, s, a, b in zip(pieces["kind"].asstr()[:], pieces["segment_name"].asstr()[:], pieces["first"][:], pieces["last"][:])
                if k == "flank" and s == "right convex arc"]
        first, last = max(made, key=lambda run: run[1] - run[0])
        tooth = result["flexspline/outline"][:]
        return outline[first:last + 1], tooth


# --- the drive, as its scene gives it -------------------------------------------------------------------------------
m, z_f, z_c, h_a, h_f, wall, w0, n = 0.25, 200, 202, 0.2250, 0.3030, 0.7, 0.25, 2
rho_a, l_a = 0.2701, 0.0982
r_m = m * z_f / 2 - h_f - wall + wall / 2
pitch_line = wall / 2 + h_f
ratio = z_f / z_c
centre = np.array([-l_a, pitch_line])


def w(u):
    return w0 * np.cos(n * u), -n * w0 * np.sin(n * u), -n * n * w0 * np.cos(n * u)


def mean_radius():
    def excess(r_0):
        return quad(lambda u: math.hypot(r_0 + w0 * math.cos(n * u), n * w0 * math.sin(n * u)), 0, math.pi / n, epsabs=1e-13, epsrel=1e-13)[0] - r_m * math.pi / n
    return brentq(excess, r_m - w0, r_m, xtol=1e-14)


def poses(u, phi, r_0):
    """Angles and origins of the tooth frame in the circular spline's."""
    d, d1, _ = w(u)
    rho = r_0 + d
    gamma = u - ratio * phi
    theta = gamma - np.arctan(d1 / rho)
    return theta, rho * np.sin(gamma), rho * np.cos(gamma)


def velocity(u, r_0):
    """theta' and q of f = n.(theta' (y, -x) + q)."""
    d, d1, d2 = w(u)
    rho = r_0 + d
    s = np.sqrt(rho ** 2 + d1 ** 2)
    return 1 - ratio * s / r_m - (rho * d2 - d1 ** 2) / s ** 2, s - ratio * rho ** 2 / r_m, ratio * rho * d1 / r_m


def f(angle, u, r_0):
    omega, q_x, q_y = velocity(u, r_0)
    x, y = centre[0] + rho_a * np.cos(angle), centre[1] + rho_a * np.sin(angle)
    return np.cos(angle) * (omega * y + q_x) + np.sin(angle) * (-omega * x + q_y)


def placed(angle, theta, x_0, y_0):
    x, y = centre[0] + rho_a * np.cos(angle), centre[1] + rho_a * np.sin(angle)
    return np.stack([x * np.cos(theta) + y * np.sin(theta) + x_0, -x * np.sin(theta) + y * np.cos(theta) + y_0], axis=-1)


# --- three notebooks ------------------------------------------------------------------------------------------------
def with_numpy(count, ends):
    r_0 = mean_radius()
    u = np.linspace(*ends, count)
    # arc length by the cumulative trapezoidal rule on a finer grid, from 0
    fine = np.linspace(0, ends[1], 8 * count)
    d, d1, _ = w(fine)
    speed = np.hypot(r_0 + d, d1)
    length = np.concatenate([[0], np.cumsum((speed[1:] + speed[:-1]) / 2 * np.diff(fine))])
    phi = np.interp(u, fine, length) / r_m
    angles = np.linspace(-0.6, 1.5, max(64, count // 8))
    values = f(angles[None, :], u[:, None], r_0)
    i, j = np.nonzero(np.signbit(values[:, 1:]) != np.signbit(values[:, :-1]))
    a, b = values[i, j], values[i, j + 1]
    angle = angles[j] + (angles[j + 1] - angles[j]) * a / (a - b)
    theta, x_0, y_0 = poses(u[i], phi[i], r_0)
    return placed(angle, theta, x_0, y_0)


def with_scipy(count, ends):
    r_0 = mean_radius()
    points = []
    for u in np.linspace(*ends, count):
        phi = quad(lambda v: math.hypot(r_0 + w0 * math.cos(n * v), n * w0 * math.sin(n * v)), 0, u, epsabs=1e-12, epsrel=1e-12)[0] / r_m
        angles = np.linspace(-0.6, 1.5, 21)
        values = f(angles, u, r_0)
        for k in np.nonzero(np.signbit(values[1:]) != np.signbit(values[:-1]))[0]:
            angle = brentq(f, angles[k], angles[k + 1], args=(u, r_0), xtol=1e-14)
            theta, x_0, y_0 = poses(u, phi, r_0)
            points.append(placed(angle, theta, x_0, y_0))
    return np.array(points)


def with_shapely(count, ends, tooth):
    """Union of positions over the whole lobe: the boundary, as points."""
    r_0 = mean_radius()
    shape = Polygon(tooth + [0, pitch_line])
    placed_teeth = []
    for u in np.linspace(-math.pi / n, math.pi / n, count):
        phi = quad(lambda v: math.hypot(r_0 + w0 * math.cos(n * v), n * w0 * math.sin(n * v)), 0, u)[0] / r_m
        theta, x_0, y_0 = poses(u, phi, r_0)
        c, s = math.cos(theta), math.sin(theta)
        placed_teeth.append(shapely.affinity.affine_transform(shape, [c, s, -s, c, x_0, y_0]))
    whole = unary_union(placed_teeth)
    return max(getattr(whole, "geoms", [whole]), key=lambda g: g.area).exterior


def hausdorff(points, truth):
    line, true_line = LineString(points), LineString(truth)
    step = max(1, len(truth) // 1500), max(1, len(points) // 1500)
    return max(max(line.distance(Point(p)) for p in truth[::step[0]]), max(true_line.distance(Point(p)) for p in points[::step[1]]))


def gap(boundary, truth):
    return max(boundary.distance(Point(p)) for p in truth[::max(1, len(truth) // 400)])


def timed(work):
    start = time.perf_counter()
    return work(), time.perf_counter() - start


# --- measurement ----------------------------------------------------------------------------------------------------
_, reference = hdconj(1e-10, 0)
truth, _ = flank_of(reference)
with h5py.File(reference) as result:
    # where the stretch begins and ends, which the notebooks are told: nearest samples of the branch
    ends = []
    for branch in result["envelope"].values():
        if branch.attrs["segment_name"] == "right convex arc" and branch.attrs["kind"] == "regular":
            u, point = branch["u"][:], branch["point"][:]
            ends.append([u[np.argmin(np.hypot(*(point - truth[k]).T))] for k in (0, -1)] + [min(np.hypot(*(point - truth[0]).T))])
ends = sorted(min(ends, key=lambda e: e[2])[:2])
coarse_tooth = hdconj(1e-5, 1)[1]
tooth = flank_of(coarse_tooth)[1]

ladders = {"hdconj": [], "hdconj, points alone": [], "NumPy": [], "SciPy": [], "union": []}
for digits in range(3, 11):
    seconds = sorted(hdconj(10.0 ** -digits, 0)[0] for _ in range(5))[2]
    ladders["hdconj"].append((10.0 ** -digits, 10.0 ** -digits, seconds))
measured = subprocess.run([program, "accuracy", "--quiet", "--json", "--sample", "0", "--study", "sampling", "-o", os.path.join(folder.name, "study")],
                          capture_output=True, check=True).stdout
for ladder in json.loads(measured)["ladders"]:
    if ladder["method"] == "adaptive":
        ladders["hdconj, points alone"] = [(rung["value"], rung["error"], rung["median_s"]) for rung in ladder["rungs"]]
for name, make, counts in (("NumPy", with_numpy, [2 ** k for k in range(6, 17)]), ("SciPy", with_scipy, [2 ** k for k in range(6, 17)])):
    for count in counts:
        points, seconds = timed(lambda: make(count, ends))
        ladders[name].append((count, hausdorff(points, truth), seconds))
        if seconds > largest / 3:
            break
for count in [2 ** k for k in range(5, 13)]:
    boundary, seconds = timed(lambda: with_shapely(count, ends, tooth))
    ladders["union"].append((count, gap(boundary, truth), seconds))
    if seconds > largest / 3:
        break


def interpolated(ladder, at, wanted, given):
    """Column `wanted` where column `given` is `at`, on log-log lines; None outside."""
    for a, b in zip(ladder, ladder[1:]):
        lo, hi = sorted((a[given], b[given]))
        if lo <= at <= hi and lo < hi:
            share = math.log(at / a[given]) / math.log(b[given] / a[given])
            return a[wanted] * (b[wanted] / a[wanted]) ** share
    return None


for name, ladder in ladders.items():
    print(f"{name}:")
    for knob, error, seconds in ladder:
        print(f"  {knob:10g}   error {error:9.2e} mm   {seconds * 1e3:10.2f} ms")
print("\nratio of time at equal error (the notebook's over hdconj's), and of error at equal time:")
summary = {}
for name in ("NumPy", "SciPy", "union"):
    for own in ("hdconj", "hdconj, points alone"):
        mine = ladders[own]
        ratios = [(error, seconds / interpolated(mine, error, 2, 1)) for _, error, seconds in ladders[name] if interpolated(mine, error, 2, 1)]
        errors = [(seconds, error / interpolated(mine, seconds, 1, 2)) for _, error, seconds in ladders[name] if interpolated(mine, seconds, 1, 2)]
        print(f"  {name} / {own}: time " + ", ".join(f"{r:.3g} at {e:.1e} mm" for e, r in ratios) + "; error " + ", ".join(f"{r:.3g} at {s * 1e3:.3g} ms" for s, r in errors))
        summary[f"{name} / {own}"] = {"time_ratio": ratios, "error_ratio": errors}
print(json.dumps({"ladders": ladders, "ratios": summary}), file=open(os.environ.get("NOTEBOOK_JSON", os.devnull), "w"))
