# SPDX-License-Identifier: GPL-3.0-or-later
# Transmission error over the turn of the wave generator, one curve for each sequence of positions.
#
# Columns:
#   $curves  one index for each sequence: part of its period, transmission error less its mean [arcsec]
#   $names   of each sequence: its period [deg], "name with the peak to peak in arcsec"

subject = "transmission error over the wave generator, its mean left out; peak to peak in arcsec below"
sequences = |$names|
period(i) = word($names[i], 1) + 0
panel_bottom = 500
legend_y(i) = panel_bottom + 70 + 25 * i
height = legend_y(sequences + 1)
eval page
eval axes(left_edge, right_edge, 82, panel_bottom)
do for [i = 1:sequences] {
  eval sample(left_edge, legend_y(i), line(curve_colour(i), 1.8))
  set label sprintf("%s  (period %.4g°)", word($names[i], 2), period(i)) \
      at screen px(left_edge + sample_text),py(legend_y(i)) noenhanced
}
stats $curves using 2 name "all" nooutput
span = max(all_max - all_min, 1e-3)
set xrange [0:1]
set yrange [all_min - 0.06 * span:all_max + 0.06 * span]
set xtics 0.125
set ytics tic_step(1.12 * span)
set xlabel 'angle of the wave generator over the period of the sequence' noenhanced
set ylabel 'output ahead of the input [arcsec]' noenhanced
set xzeroaxis linecolor rgb light_grey linewidth 0.8
plot for [i = 1:sequences] $curves index i-1 using 1:2 with linespoints linecolor rgb curve_colour(i) \
    linewidth 1.8 pointtype 7 pointsize 0.3 notitle
