# SPDX-License-Identifier: GPL-3.0-or-later
# Time against threads, both logarithmic: a line for each method, least and most time as whiskers, dotted what the time
# of one thread over the number of threads would be.
#
# Columns:
#   $panels  left, right, top, bottom [px], first and last curve from 1, "title": one or two pairs of axes
#   $curves  threads, time, least, most [ms]; one index for each curve
#   $series  colour number, time of one thread [ms] of each curve
#   $legend  colour number (0: goes on with the line above), number of points, "words"
# Variables: question; most_threads; time_low, time_high [ms]

subject = question . "; dotted: time of one thread over their number"
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
set logscale xy
set grid linecolor rgb faint linewidth 0.6
set xrange [1 / 1.15:most_threads * 1.15]
set yrange [time_low:time_high]
set xtics (1)
do for [k = 1:10] { if (2 ** k <= most_threads) { set xtics add (2 ** k) } }
set format y '%.3g'
set ytics (1, 2, 3, 4, 5, 6, 8, 10, 12, 15, 20, 30, 40, 50, 60, 80, 100, 150, 200, 300, 500, 1000)
set xlabel 'threads' noenhanced
set ylabel 'time [ms], median; whiskers: least and most' noenhanced
do for [p = 1:|$panels|] {
  panel(k) = word($panels[p], k)
  eval axes(panel(1) + 0, panel(2) + 0, panel(3) + 0, panel(4) + 0)
  first_curve = panel(5) + 0
  last_curve = panel(6) + 0
  set label panel(7) at screen px(panel(1) + 0),py(panel(3) - 16) left noenhanced
  # Whiskers before lines: gnuplot keeps the place of their point white.
  plot for [i = first_curve:last_curve] word($series[i], 2) / x with lines linewidth 0.9 dashtype (2,4) \
          linecolor rgb curve_colour(word($series[i], 1) + 0) notitle, \
      for [i = first_curve:last_curve] $curves index i-1 using 1:2:3:4 with yerrorbars pointtype -1 linewidth 0.7 \
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
