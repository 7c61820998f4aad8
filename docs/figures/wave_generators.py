# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws docs/figures/wave-generators.svg: neutral curves of the wave generators, displacement 20 times enlarged.

usage: wave_generators.py HDCONJ OUTPUT.svg     (needs h5py and gnuplot; run from the project's folder)
"""

import math
import pathlib
import subprocess
import sys
import tempfile

import h5py

FAMILIES = [
    ("type-50", "cosine", ""),
    ("ellipse", "ellipse", ""),
    ("four-roller", "four-roller, β = 30°", "rollers"),
    ("two-disc", "two-disc, β = 30°", "discs"),
    ("ring-on-cosine-cam", "ring-on-cosine-cam, t = 4.5 mm", "cam"),
    ("cam-table", "table, every 5°", "rows"),
]
ENLARGED = 20
R_M = 24.347  # mm; all these scenes share the ring of type-50


def enlarged(radius):
    """The radius whose displacement is enlarged."""
    return R_M + ENLARGED * (radius - R_M)


def blocks(folder, name, extra, program):
    result = folder / f"{name}.h5"
    subprocess.run([program, "solve", f"data/scenes/{name}.toml", "-o", result, "--quiet"], check=True)
    with h5py.File(result) as f:
        points = f["neutral_curve"][:]
    curve = []
    for x, y in list(points[::4]) + [points[0]]:
        u, rho = math.atan2(x, y), math.hypot(x, y)
        r = enlarged(rho)
        curve.append(f"{r * math.sin(u):.3f} {r * math.cos(u):.3f}")
    ring = [f"{R_M * math.sin(a)} {R_M * math.cos(a)}" for a in (math.pi * k / 60 for k in range(121))]
    marks = []
    at = {"rollers": [30, 150, 210, 330], "discs": [30, 150, 210, 330], "rows": range(0, 360, 5)}.get(extra, [])
    for degrees in at:
        u = math.radians(degrees)
        x, y = min(points, key=lambda p: abs(math.remainder(math.atan2(p[0], p[1]) - u, 2 * math.pi)))
        r = enlarged(math.hypot(x, y))
        marks.append(f"{r * math.sin(u):.3f} {r * math.cos(u):.3f}")
    if extra == "cam":
        for k in range(121):
            a = math.pi * k / 60
            r = R_M - 4.5 + ENLARGED * 0.25 * math.cos(2 * a)
            marks.append(f"{r * math.sin(a):.3f} {r * math.cos(a):.3f}")
    return ["\n".join(block) for block in (ring, curve, marks or ["NaN NaN"])]


def main(program, output):
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        lines = [
            "set terminal svg size 900,620 font 'sans,13' background rgb 'white'",
            f"set output '{output}'",
            "set multiplot layout 2,3",
            "unset border; unset tics; set size ratio -1; set key off",
            "set xrange [-33:33]; set yrange [-33:33]",
        ]
        for file, title, extra in FAMILIES:
            data = folder / f"{file}.dat"
            data.write_text("\n\n\n".join(blocks(folder, file, extra, program)))
            marks = (
                "with lines lw 1.5 lc rgb '#2060c0'"
                if extra == "cam"
                else f"with points pt 7 ps {0.35 if extra == 'rows' else 1.0} lc rgb '#2060c0'"
            )
            lines.append(f'set title "{title}" offset 0,-1')
            lines.append(
                f"plot '{data}' index 0 title 'undeformed ring' with lines lw 1 dt 2 lc rgb '#909090', "
                f"'' index 1 title 'neutral curve' with lines lw 2 lc rgb '#c03020', '' index 2 title 'marks' {marks}"
            )
        lines.append("unset multiplot")
        subprocess.run(["gnuplot"], input="\n".join(["set encoding utf8"] + lines).encode(), check=True)


if __name__ == "__main__":
    main(*sys.argv[1:])
