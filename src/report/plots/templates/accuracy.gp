# SPDX-License-Identifier: GPL-3.0-or-later
# Error against time of a study's methods, both logarithmic: a line for each method, its floor dashed, least and most
# time as whiskers; beside the drive the worst of the sample, where there is one.
#
# Columns:
#   $panels  left, right, top, bottom [px], first and last curve from 1, "title": one or two pairs of axes
#   $curves  time [s], error, least time, most time [s]; one index for each curve
#   $series  colour number, floor (0: none) of each curve
#   $labels  panel, place on the picture x, y [px], colour number, "setting": at the ends of the curves
#   $legend  colour number (0: goes on with the line above), number of points, "words"
#   $tics    time [s], "number": tics in place of whole decades; no rows: these
# Variables: question; time_low, time_high [s]; error_low, error_high; unit

subject = question . (|$labels| > 0 ? "; at the ends of a line its first and last setting" : "")
bottom = word($panels[1], 4) + 0
legend_y(i) = bottom + 66 + 26 * i
height = legend_y(|$legend| + 1)
eval page
do for [i = 1:|$legend|] {
  colour = word($legend[i], 1) + 0
  set label word($legend[i], 3) at screen px(112 + sample_text + (colour ? 0 : 24)),py(legend_y(i)) noenhanced
  if (colour) {
    set label '' at screen px(112 + 22),py(legend_y(i)) point pointtype 7 pointsize 0.7 \
        linecolor rgb curve_colour(colour)
    if (word($legend[i], 2) > 1) { eval sample(112, legend_y(i), line(curve_colour(colour), 2.2)) }
  }
}

set multiplot
set style textbox opaque noborder fillcolor rgb white margins 0.2,0.2
set logscale xy
set grid linecolor rgb faint linewidth 0.6
set xrange [time_low:time_high]
set yrange [error_low:error_high]
set format y '10^{%L}'
set format x '10^{%L}'
if (|$tics| > 0) { set xtics (word($tics[1], 2) word($tics[1], 1) + 0) }
do for [i = 2:|$tics|] { set xtics add (word($tics[i], 2) word($tics[i], 1) + 0) }
set xlabel 'time [s], median; whiskers: least and most' noenhanced
set ylabel sprintf('error against the reference [%s]', unit) noenhanced
do for [p = 1:|$panels|] {
  panel(k) = word($panels[p], k)
  eval axes(panel(1) + 0, panel(2) + 0, panel(3) + 0, panel(4) + 0)
  first_curve = panel(5) + 0
  last_curve = panel(6) + 0
  set label panel(7) at screen px(panel(1) + 0),py(panel(3) - 16) left noenhanced
  do for [i = 1:|$labels|] {
    if (word($labels[i], 1) == p) {
      set label word($labels[i], 5) at screen px(word($labels[i], 2) + 0),py(word($labels[i], 3) + 0) center \
          noenhanced textcolor rgb curve_colour(word($labels[i], 4) + 0) front boxed
    }
  }
  do for [i = first_curve:last_curve] {
    floor_error = word($series[i], 2) + 0
    if (floor_error > 0) {
      set arrow from graph 0, first floor_error to graph 1, first floor_error nohead back \
          linecolor rgb curve_colour(word($series[i], 1) + 0) linewidth 0.9 dashtype (2,3)
    }
  }
  plot for [i = first_curve:last_curve] $curves index i-1 using 1:2:3:4 with xerrorbars pointtype -1 linewidth 0.7 \
          linecolor rgb curve_colour(word($series[i], 1) + 0) notitle, \
      for [i = first_curve:last_curve] $curves index i-1 using 1:2 with linespoints pointtype 7 pointsize 0.7 \
          linewidth 2.2 linecolor rgb curve_colour(word($series[i], 1) + 0) notitle
  # What stands about the first axes is not drawn again, nor are the numbers of an axis that is the same.
  unset label
  unset arrow
  unset ylabel
  set format y ''
}
unset multiplot
