# SPDX-License-Identifier: GPL-3.0-or-later
# Orders of the transmission error, one row of bars for each sequence of positions.
#
# Columns:
#   $orders  one index for each sequence: periods in a turn of the wave generator, amplitude [arcsec]
#   $names   of each sequence: its highest order, its largest amplitude [arcsec], "name"

subject = "orders of the transmission error: amplitude over periods in a turn of the wave generator"
sequences = |$names|
highest(i) = word($names[i], 1) + 0
largest(i) = word($names[i], 2) + 0
panel = 190
panel_top(i) = 96 + (panel + 78) * (i - 1)
height = panel_top(sequences) + panel + 84
eval page
set multiplot
do for [i = 1:sequences] {
  if (i == 2) { unset label 1; unset label 2 }  # of the page, which the first row of bars has drawn
  eval axes(left_edge, right_edge, panel_top(i), panel_top(i) + panel)
  set xrange [0:1.03 * highest(i)]
  set yrange [0:axis_end(largest(i))]
  set xtics tic_step(highest(i))
  set ytics tic_step(2 * axis_end(largest(i)))
  set ylabel '[arcsec]' noenhanced
  set xlabel (i == sequences ? 'order' : '') noenhanced
  set label 10 word($names[i], 3) at screen px(left_edge + 8),py(panel_top(i) - 12) noenhanced
  plot $orders index i-1 using 1:2 with impulses linecolor rgb curve_colour(i) linewidth 2.5 notitle
}
unset multiplot
