#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The built-in drive's flank as a notebook would compute it, beside hdconj: time at equal error, error at equal time.

  notebook.py build/release/bin/hdconj [LARGEST]

Versions of notebook_jobs.py, written for this comparison: NumPy (f(t, u) on a grid of positions and profile points,
sign changes, linear interpolation), SciPy
(quad for the arc length, brentq for each contact) and shapely (union of tooth positions). Two jobs:
- points: the stretch of the right convex arc only, of which notebooks are told where it begins and ends; beside the
  points of the whole boundary alone in the
  library, branches given (study sampling of `hdconj accuracy`);
- tooth space: all segments over the whole lobe, the outermost points, a file; beside the whole process `hdconj solve`,
  which certifies its branches and checks
  what it made over a full turn besides; and beside the same in a program that is running, as a notebook is (study
  tolerance), without the file.
Imports and reference are not timed. Error: Hausdorff distance from hdconj's own outline at 1e-10 mm (which 50 digits
confirm: `hdconj accuracy`).
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
from shapely.geometry import LineString, Point

from notebook_jobs import whole_numpy, whole_scipy, with_numpy, with_scipy, with_shapely

program = os.path.abspath(sys.argv[1])
largest = float(sys.argv[2]) if len(sys.argv) > 2 else 20.0
folder = tempfile.TemporaryDirectory()


def hdconj(tolerance, threads):
    name = os.path.join(folder.name, "result.h5")
    start = time.perf_counter()
    subprocess.run(
        [program, "solve", "--quiet", "--threads", str(threads), "--set", f"solver.tolerance={tolerance}", "-o", name],
        check=True,
    )
    return time.perf_counter() - start, name


def outlines_of(name):
    """Points of the outline that the right convex arc made; those from land to land; the flexspline's tooth."""
    with h5py.File(name) as result:
        outline = result["circular_spline/outline"][0]
        pieces = result["circular_spline/pieces"]
        made = [
            (k, s, int(a), int(b))
            for k, s, a, b in zip(
                pieces["kind"].asstr()[:], pieces["segment_name"].asstr()[:], pieces["first"][:], pieces["last"][:]
            )
        ]
        first, last = max(
            ((a, b) for k, s, a, b in made if k == "flank" and s == "right convex arc"), key=lambda run: run[1] - run[0]
        )
        space = [(a, b) for k, _, a, b in made if k != "land"]
        return outline[first : last + 1], outline[space[0][0] : space[-1][1] + 1], result["flexspline/outline"][:]


def hausdorff(points, truth):
    """Of a curve that may go on inside the tip circle, where the tooth space ends."""
    line, true_line = LineString(points), LineString(truth)
    points = points[np.hypot(*points.T) >= min(np.hypot(*truth[0]), np.hypot(*truth[-1]))]
    step = max(1, len(truth) // 1500), max(1, len(points) // 1500)
    return max(
        max(line.distance(Point(p)) for p in truth[:: step[0]]),
        max(true_line.distance(Point(p)) for p in points[:: step[1]]),
    )


def gap(boundary, truth):
    return max(boundary.distance(Point(p)) for p in truth[:: max(1, len(truth) // 400)])


def timed(work, repeats=3):
    """Result and median: memory that is touched for the first time takes as long as the work in it."""
    seconds = []
    for _ in range(repeats):
        start = time.perf_counter()
        result = work()
        seconds.append(time.perf_counter() - start)
    return result, sorted(seconds)[repeats // 2]


# --- measurement ----------------------------------------------------------------------------------------------------
_, reference = hdconj(1e-10, 0)
truth, space, _ = outlines_of(reference)
with h5py.File(reference) as result:
    # where the stretch begins and ends, which the notebooks are told: nearest samples of the branch
    ends = []
    for branch in result["envelope"].values():
        if branch.attrs["segment_name"] == "right convex arc" and branch.attrs["kind"] == "regular":
            u, point = branch["u"][:], branch["point"][:]
            ends.append(
                [u[np.argmin(np.hypot(*(point - truth[k]).T))] for k in (0, -1)]
                + [min(np.hypot(*(point - truth[0]).T))]
            )
ends = sorted(min(ends, key=lambda e: e[2])[:2])
coarse_tooth = hdconj(1e-5, 1)[1]
tooth = outlines_of(coarse_tooth)[2]

series = {
    "hdconj, tooth space": [],
    "hdconj, running": [],
    "hdconj, points": [],
    "NumPy, points": [],
    "SciPy, points": [],
    "NumPy, tooth space": [],
    "SciPy, tooth space": [],
    "union": [],
}
for digits in range(3, 11):
    seconds = sorted(hdconj(10.0**-digits, 0)[0] for _ in range(5))[2]
    series["hdconj, tooth space"].append((10.0**-digits, 10.0**-digits, seconds))
for study, method, name in (("sampling", "adaptive", "hdconj, points"), ("tolerance", "solve", "hdconj, running")):
    measured = subprocess.run(
        [
            program,
            "accuracy",
            "--quiet",
            "--json",
            "--sample",
            "0",
            "--study",
            study,
            "-o",
            os.path.join(folder.name, study),
        ],
        capture_output=True,
        check=True,
    ).stdout
    series[name] = [
        (level["value"], level["error"], level["median_s"])
        for each in json.loads(measured)["convergence_series"]
        if each["method"] == method
        for level in each["levels"]
    ]
made = os.path.join(folder.name, "notebook.h5")
for name, make, true_points in (
    ("NumPy, points", lambda count: with_numpy(count, ends), truth),
    ("SciPy, points", lambda count: with_scipy(count, ends), truth),
    ("NumPy, tooth space", lambda count: whole_numpy(count, made), space),
    ("SciPy, tooth space", lambda count: whole_scipy(count, made), space),
):
    for count in [2**k for k in range(6, 17)]:
        points, seconds = timed(lambda: make(count))
        series[name].append((count, hausdorff(points, true_points), seconds))
        if seconds > largest / 3:
            break
for count in [2**k for k in range(5, 13)]:
    boundary, seconds = timed(lambda: with_shapely(count, ends, tooth))
    series["union"].append((count, gap(boundary, truth), seconds))
    if seconds > largest / 3:
        break


def interpolated(found, at, wanted, given):
    """Column `wanted` where column `given` is `at`, on log-log lines; None outside."""
    for a, b in zip(found, found[1:]):
        lo, hi = sorted((a[given], b[given]))
        if lo <= at <= hi and lo < hi:
            share = math.log(at / a[given]) / math.log(b[given] / a[given])
            return a[wanted] * (b[wanted] / a[wanted]) ** share
    return None


for name, found in series.items():
    print(f"{name}:")
    for knob, error, seconds in found:
        print(f"  {knob:10g}   error {error:9.2e} mm   {seconds * 1e3:10.2f} ms")
print("\nratio of time at equal error (the notebook's over hdconj's), and of error at equal time:")
summary = {}
for name, own in (
    ("NumPy, points", "hdconj, points"),
    ("SciPy, points", "hdconj, points"),
    ("NumPy, tooth space", "hdconj, tooth space"),
    ("SciPy, tooth space", "hdconj, tooth space"),
    ("NumPy, tooth space", "hdconj, running"),
    ("SciPy, tooth space", "hdconj, running"),
    ("NumPy, points", "hdconj, tooth space"),
    ("SciPy, points", "hdconj, tooth space"),
    ("union", "hdconj, tooth space"),
):
    mine = series[own]
    ratios = [
        (error, seconds / interpolated(mine, error, 2, 1))
        for _, error, seconds in series[name]
        if interpolated(mine, error, 2, 1)
    ]
    errors = [
        (seconds, error / interpolated(mine, seconds, 1, 2))
        for _, error, seconds in series[name]
        if interpolated(mine, seconds, 1, 2)
    ]
    print(
        f"  {name} / {own}: time "
        + ", ".join(f"{r:.3g} at {e:.1e} mm" for e, r in ratios)
        + "; error "
        + ", ".join(f"{r:.3g} at {s * 1e3:.3g} ms" for s, r in errors)
    )
    summary[f"{name} / {own}"] = {"time_ratio": ratios, "error_ratio": errors}
print(json.dumps({"series": series, "ratios": summary}), file=open(os.environ.get("NOTEBOOK_JSON", os.devnull), "w"))
