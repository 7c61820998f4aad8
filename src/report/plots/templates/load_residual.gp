# SPDX-License-Identifier: GPL-3.0-or-later
# What a rig has measured, less two curves: its own two straight lines, and the simulation.
#
# Columns: torque on the circular spline [N m], angle measured less angle of the curve [arcmin]; may have no rows.
#   $lines  against the straight lines of the measurement
#   $curve  against the simulation
# Variables: bent: 1 for two lines, 0 for one; step: of the angle, 0 where it has none [arcmin]

subject = "angle of the rig less that of " . (bent ? "two straight lines" : "one straight line") \
    . " (above) and of the simulation (below)"
height = 700
eval page
lines_min_y = lines_max_y = curve_min_y = curve_max_y = 0.0
lines_min_x = lines_max_x = 0.0
if (|$lines| > 1) { stats $lines using 1:2 name "lines" nooutput }
if (|$curve| > 1) { stats $curve using 1:2 name "curve" nooutput }
least = step > 0 ? step : 0.01
low(a) = 1.08 * min(a, -least)
high(a) = 1.08 * max(a, least)
span = 1.04 * max(max(-lines_min_x, lines_max_x), 1e-9)

set multiplot
set xrange [-span:span]
set xtics tic_step(2 * span)
set zeroaxis linecolor rgb light_grey
eval axes(left_edge, right_edge, 82, 320)
set yrange [low(lines_min_y):high(lines_max_y)]
set ytics tic_step(2 * (high(lines_max_y) - low(lines_min_y)))
set ylabel "from its lines [arcmin]" noenhanced
if (step > 0) {
    set object rectangle from graph 0,first -step to graph 1,first step fillcolor rgb paper fillstyle solid noborder \
        behind
    set label "band: one step of the encoder" at graph 0.99,1.05 right noenhanced textcolor rgb dark_grey
}
plot $lines using 1:2 with points pointtype 7 pointsize 0.35 linecolor rgb dark_grey notitle

unset label
eval axes(left_edge, right_edge, 380, 620)
set yrange [low(curve_min_y):high(curve_max_y)]
set ytics tic_step(2 * (high(curve_max_y) - low(curve_min_y)))
set xlabel "torque on the circular spline [N m]" noenhanced
set ylabel "from the simulation [arcmin]" noenhanced
plot $curve using 1:2 with points pointtype 7 pointsize 0.35 linecolor rgb blue notitle
unset multiplot
