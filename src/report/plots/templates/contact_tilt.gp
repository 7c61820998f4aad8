# SPDX-License-Identifier: GPL-3.0-or-later
# Contact area (left axis) and least side clearance (right axis) against the tilt of the circular spline, a pair of curves
# for each surface and kind of tilt, the best tilts marked.
#
# Columns:
#   $curves  tilt [deg], contact area [%], least side clearance [um]; one index for each curve, two rows where it has no tilt
#   $names   of each curve: 1 where it has no tilt, else 0, "name"
#   $best    curve (0: none), tilt [deg], value on its axis, 1 for the area or 0 for the offset, 1 on the bound
# Variables: contact_gap [um]; tilt_low, tilt_high [deg]

subject = sprintf("contact area (gap up to %g µm), and the side clearance that clears the flanks, against tilt", \
    contact_gap)
stats $curves using 2:3 name "all" nooutput
largest_area = all_max_x
largest_offset = all_max_y
name(i) = word($names[i], 2)
is_level(i) = word($names[i], 1) + 0
best(i, k) = word($best[i], k) + 0
do for [i = 1:|$best|] {
  if (best(i, 4)) { largest_area = max(largest_area, best(i, 3)) }
  if (!best(i, 4)) { largest_offset = max(largest_offset, best(i, 3)) }
}
panel_bottom = 522
legend_y(i) = panel_bottom + 66 + 26 * i
middle = (112 + width - 95) / 2
area_end = axis_end(largest_area)
offset_end = axis_end(largest_offset)
height = legend_y(|$names| + 1)
eval page
# Numbers of small shares are long, and the name of the axis stands beside them.
eval axes(area_end < 0.01 ? 147 : 112, width - 95, 82, panel_bottom)

# Widths differ as well: in SVG, gnuplot joins lines of one colour and width and forgets the dashes of the second one.
area_look(i) = line(curve_colour(i), 2.2)
offset_look(i) = dashed(curve_colour(i), 2.0, "(8,5)")
do for [i = 1:|$names|] {
  eval sample(112, legend_y(i), area_look(i))
  eval sample(middle, legend_y(i), offset_look(i))
  set label "contact area: " . name(i) at screen px(112 + sample_text),py(legend_y(i)) noenhanced
  set label "least side clearance: " . name(i) at screen px(middle + sample_text),py(legend_y(i)) noenhanced
}

set style textbox opaque noborder fillcolor rgb white margins 0.2,0.2
do for [i = 1:|$best|] {
  tilt = best(i, 2)
  is_area = best(i, 4)
  level = best(i, 3) / (is_area ? area_end : offset_end)
  colour = best(i, 1) > 0 ? curve_colour(best(i, 1)) : ink
  words = sprintf("%.3g°", tilt) . (is_area ? "" : sprintf(", %.3g µm", best(i, 3))) \
      . (best(i, 5) ? " (on the bound)" : "")
  set arrow from first tilt, graph 0 to first tilt, graph level nohead back linecolor rgb colour linewidth 0.9 \
      dashtype (2,3)
  if (tilt > tilt_low + 0.8 * (tilt_high - tilt_low)) {
    set label words at first tilt, graph level right offset -0.9,0.7 front boxed noenhanced textcolor rgb colour
  } else {
    set label words at first tilt, graph level left offset 0.9,0.7 front boxed noenhanced textcolor rgb colour
  }
  set label '' at first tilt, graph level point pointtype (is_area ? 7 : 6) pointsize 1.1 linecolor rgb colour front
}

set border 11
set xrange [tilt_low:tilt_high]
set yrange [0:area_end]
set y2range [0:offset_end]
set xtics tic_step(tilt_high - tilt_low)
set ytics tic_step(area_end)
set y2tics tic_step(offset_end)
set xlabel 'tilt of the circular spline [deg]' noenhanced
set ylabel 'contact area [% of the driving flanks]' noenhanced
set y2label 'least side clearance [µm]' noenhanced
plot for [i = 1:|$names|] $curves index i-1 using 1:3 axes x1y2 with linespoints linecolor rgb curve_colour(i) \
        linewidth (is_level(i) ? 1.1 : 2.0) dashtype (8,5) pointtype (is_level(i) ? -2 : 6) pointsize 0.6 notitle, \
    for [i = 1:|$names|] $curves index i-1 using 1:2 axes x1y1 with linespoints linecolor rgb curve_colour(i) \
        linewidth (is_level(i) ? 1.2 : 2.2) pointtype (is_level(i) ? -2 : 7) pointsize 0.6 notitle
