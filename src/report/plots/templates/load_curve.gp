# SPDX-License-Identifier: GPL-3.0-or-later
# Torque on the circular spline against its twist: every case with its play and its two straight lines, and what a rig
# has measured.
#
# Columns: twist [arcmin], torque [N m].
#   $measured  points of the rig; no rows where nothing was measured
#   $curves    one index for each case, NaN where it has no curve
#   $stages    the same: two lines of two rows, an empty row between them
#   $cases     of each case: backlash [arcmin], stiffness of both stages [N m/deg], torque of the knee [N m],
#              1 where there are two stages, "name"
#   $rig       what the rig gave: 1 where it is of the cup, cycles, backlash and its error [arcmin], number of stages
#              found, stiffness of both with their errors [N m/deg], torque of the knee [N m], 1 where the
#              backlash is determined
# Variables: shown: number of the case that the other pictures show, from 1; play: its backlash if that is drawn
# [arcmin], else 0

subject = "torque on the circular spline against its twist, wave generator and cup held; " \
    . "dashed: two straight lines"
measured = |$rig| > 0
case(i, k) = word($cases[i], k) + 0
case_words(i) = sprintf("%s:  backlash %.3g′", word($cases[i], 6), case(i, 1)) . (case(i, 5) \
    ? sprintf(",  %.4g and %.4g N m/°,  knee at %.3g N m", case(i, 2), case(i, 3), case(i, 4)) \
    : case(i, 2) != 0 ? sprintf(",  %.4g N m/°,  no knee", case(i, 2)) : "")
rig(k) = word($rig[1], k) + 0
rig_words(i) = sprintf("measured%s, %d cycle%s:  backlash ", rig(1) ? " at the cup" : "", rig(2), \
    rig(2) == 1 ? "" : "s") . (rig(11) ? sprintf("%.2f ± %.2f′", rig(3), rig(4)) : "not determined") . (rig(5) == 0 ? "" \
    : sprintf(",  %.1f ± %.1f and %.1f ± %.1f N m/°,  knee at %.3g N m", rig(6), rig(7), rig(8), rig(9), rig(10)))

panel_bottom = 552
legend_y(i) = panel_bottom + 70 + 25 * i
cases = |$cases|
height = legend_y(cases + measured + 1)
eval page
eval axes(left_edge, right_edge, 82, panel_bottom)
if (measured) {
  set label rig_words(1) at screen px(left_edge + sample_text),py(legend_y(1)) noenhanced
  set label '' at screen px(left_edge + 22),py(legend_y(1)) point pointtype 7 pointsize 0.5 linecolor rgb dark_grey
}
do for [i = 1:cases] {
  eval sample(left_edge, legend_y(i + measured), line(curve_colour(i), i == shown ? 2.4 : 1.6))
  set label case_words(i) at screen px(left_edge + sample_text),py(legend_y(i + measured)) noenhanced
}

# Both axes show 0 and all points with some air.
rig_min_x = rig_max_x = rig_min_y = rig_max_y = 0.0
all_min_x = all_max_x = all_min_y = all_max_y = 0.0
if (measured) { stats $measured using 1:2 name "rig" nooutput }
if (cases > 0) { stats $curves using 1:2 name "all" nooutput }
air(low, high) = high > low ? 0.06 * (high - low) : 1
lower(low, high) = low < 0 || high == low ? low - air(low, high) : low
twist_least = min(0, min(rig_min_x, all_min_x))
twist_most = max(0, max(rig_max_x, all_max_x))
torque_least = min(0, min(rig_min_y, all_min_y))
torque_most = max(0, max(rig_max_y, all_max_y))
twist_low = lower(twist_least, twist_most)
twist_high = twist_most + air(twist_least, twist_most)
torque_low = lower(torque_least, torque_most)
torque_high = torque_most + air(torque_least, torque_most)
set xrange [twist_low:twist_high]
set yrange [torque_low:torque_high]
set xtics tic_step(twist_high - twist_low)
set ytics tic_step(torque_high - torque_low)
set xlabel 'twist [arcmin]' noenhanced
set ylabel 'torque [N m]' noenhanced
set xzeroaxis linecolor rgb light_grey linewidth 0.8
set yzeroaxis linecolor rgb light_grey linewidth 0.8
if (play > 0) {
  below = -0.05 * (torque_high - torque_low)
  set arrow from first -play/2.0,below to first play/2.0,below heads filled size screen 0.008,20 \
      linewidth 1 linecolor rgb ink front
  set label sprintf("backlash %.3g′", play) at first 0,2*below center noenhanced front
}
plot $measured using 1:2 with points pointtype 7 pointsize 0.2 linecolor rgb dark_grey notitle, \
    for [i = 1:cases] $curves index i-1 using 1:2 with linespoints linecolor rgb curve_colour(i) \
        linewidth (i == shown ? 2.4 : 1.6) pointtype 7 pointsize 0.35 notitle, \
    for [i = 1:cases] $stages index i-1 using 1:2 with lines linecolor rgb curve_colour(i) linewidth 1.1 \
        dashtype (7,5) notitle
