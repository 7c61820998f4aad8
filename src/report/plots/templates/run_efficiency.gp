# SPDX-License-Identifier: GPL-3.0-or-later
# Efficiency over the torque on the output, one curve for each speed and temperature.
#
# Columns:
#   $curves  one index for each: torque [N m], efficiency [%], its error [%]
#   $names   of each: 0, "speed, temperature"
# Variables: starting: torque on the wave generator that starts it without load [N m]

subject = sprintf("efficiency over the torque on the output; starting torque of the wave generator %.3g N m", starting)
curves = |$names|
panel_bottom = 480
legend_y(i) = panel_bottom + 70 + 25 * i
height = legend_y(curves + 1)
eval page
eval axes(left_edge, right_edge, 82, panel_bottom)
do for [i = 1:curves] {
  eval sample(left_edge, legend_y(i), line(curve_colour(i), 1.8))
  set label word($names[i], 2) at screen px(left_edge + sample_text),py(legend_y(i)) noenhanced
}
stats $curves using 1 name "torque" nooutput
set xrange [0:1.03 * torque_max]
set yrange [0:100]
set xtics tic_step(torque_max)
set ytics 10
set grid ytics linecolor rgb faint linewidth 0.8
set xlabel 'torque on the output [N m]' noenhanced
set ylabel 'efficiency [%]' noenhanced
# gnuplot's own error bars have a white spot in their middle
plot for [i = 1:curves] $curves index i-1 using 1:($2-$3):(0):(2*$3) with vectors heads size graph 0.006,90 \
        linecolor rgb curve_colour(i) linewidth 1 notitle, \
    for [i = 1:curves] $curves index i-1 using 1:2 with linespoints linecolor rgb curve_colour(i) \
        linewidth 1.8 pointtype 7 pointsize 0.4 notitle
