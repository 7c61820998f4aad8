# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws docs/figures/tilt-sketch.svg: what coning is, and what the two kinds of tilt do to an outline.

usage: sketch.py HDCONJ OUTPUT.svg     (needs h5py and gnuplot; run from the project's folder)
"""

import pathlib
import subprocess
import sys
import tempfile

import h5py

ENLARGED = 6  # lean of the wall and tilt, left
TILT = 0.5  # degrees, right


def outlines(program, folder, kind):
    """The tilted outline at the rear end, in the middle and at the front end."""
    result = folder / f"{kind}.h5"
    keys = (f"tilt.angle_deg={TILT}", "tilt.kind=" + kind, "slices.count=3", "slices.surface=tilted")
    subprocess.run(
        [
            program,
            "solve",
            "data/scenes/type-50.toml",
            "-o",
            result,
            "--quiet",
            *(part for key in keys for part in ("--set", key)),
        ],
        check=True,
    )
    with h5py.File(result) as file:
        return file["/circular_spline/outline"][:]


def section():
    """Blocks of z and radius: wall of the cup, untilted and tilted edge of the circular spline, bearing."""

    def moved(z):
        return ENLARGED * 0.25 * (z + 8.57) / 8.57

    wall = [(z, 24.35 + moved(z)) for z in (-8.5, -3.9, 3.9, 6)]
    teeth = [(z, 24.7 + moved(z)) for z in (-3.9, 3.9)] + [(z, 25.3 + moved(z)) for z in (3.9, -3.9)]
    ring = [(-3, 23.6 + moved(-3)), (3, 23.6 + moved(3)), (3, 24.05 + moved(3)), (-3, 24.05 + moved(-3))]
    inner, slope = 28.2, ENLARGED * 0.2 * 3.14159265 / 180
    return [
        wall,
        teeth + teeth[:1],
        ring + ring[:1],
        [(-3.5, inner), (3.5, inner), (3.5, 29.7), (-3.5, 29.7), (-3.5, inner)],
        [(-3.5, inner - 3.5 * slope), (3.5, inner + 3.5 * slope)],
        [(-8.5, 21.5), (-8.5, 24.35)],
    ]


def main(program, output):
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        data = ["\n".join(f"{z} {r}" for z, r in block) for block in section()]
        for kind in ("radial", "draft"):
            for outline in outlines(program, folder, kind):
                data.append("\n".join(f"{x:.5f} {y:.5f}" for x, y in outline[::4]))
        (folder / "data").write_text("\n\n\n".join(data) + "\n")
        plot = f"""
set terminal svg size 1140,380 font "DejaVu Sans,13" enhanced background "white"
set output "{output}"
set multiplot
file = "{folder}/data"
unset border; unset tics; unset key
set size 0.42,0.98; set origin 0.0,0.0
set xrange [-10.5:8.5]; set yrange [20.6:30.9]
set label 1 "axial section, lean and tilt {ENLARGED} times enlarged" at -9.5,30.6
set label 2 "bottom" at -8.1,22.2
set label 3 "flexspline" at 4.4,25.0 tc rgb "#b03030"
set label 4 "bearing" at 0.4,23.2 tc rgb "#777777"
set label 5 "circular spline" at -2.2,29.0
set label 6 "edge tilted by 0.2°" at 4.0,28.3 tc rgb "#2060b0"
set label 7 "rear, z = -3.5 mm" at -3.5,21.0 center
set label 8 "front, z = +3.5 mm" at 3.5,21.0 center
set arrow 1 from -3.5,21.3 to -3.5,27.2 nohead dt 3 lc rgb "#aaaaaa"
set arrow 2 from 3.5,21.3 to 3.5,28.1 nohead dt 3 lc rgb "#aaaaaa"
plot file index 3 with filledcurves closed fc rgb "#e4e4e4", "" index 3 with lines lc rgb "#777777", \\
  "" index 1 with filledcurves closed fc rgb "#f0c8c8", "" index 0 with lines lw 5 lc rgb "#b03030", \\
  "" index 2 with filledcurves closed fc rgb "#dddddd", "" index 5 with lines lw 5 lc rgb "#b03030", \\
  "" index 4 with lines lw 2.5 lc rgb "#2060b0"
unset label; unset arrow
set size ratio -1
set xrange [-0.45:0.45]; set yrange [24.88:25.74]
do for [k = 0:1] {{
  set size 0.285,0.98; set origin 0.425 + 0.285*k,0.0
  set label 1 (k ? "draft: moved along its normal" : "radial: moved along its radii") at -0.42,25.70
  set label 2 "rear" at 0.0,25.07 center tc rgb "#2060b0"
  set label 3 "middle" at 0.0,25.00 center
  set label 4 "front" at 0.0,24.93 center tc rgb "#d06000"
  plot file index 6 + 3*k with lines lw 2 lc rgb "#2060b0", "" index 7 + 3*k with lines lw 2 lc rgb "#222222", \\
    "" index 8 + 3*k with lines lw 2 lc rgb "#d06000"
}}
unset multiplot
"""
        subprocess.run(["gnuplot"], input=plot, text=True, check=True)


main(*sys.argv[1:])
