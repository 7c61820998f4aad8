# SPDX-License-Identifier: GPL-3.0-or-later
# Stiffness against torque: the slope of the torque-twist curve of every case with its error, and K1, K2, K3.
#
#   $slopes     one index for each case: torque [N m], stiffness less its error, stiffness, stiffness with its error
#               [N m/deg]; NaN where it has no curve
#   $catalogue  the same: torque [N m] and K [N m/deg] at both ends of each line, an empty row after each; NaN where
#               it has none
#   $cases      of each case: K1, K2, K3 [N m/rad], 1 where it has them, "name"

subject = "stiffness of the teeth on the elastic cup against torque; band: estimated error; " \
    . "thick: K1, K2 and K3 of a catalogue"
case(i, k) = word($cases[i], k) + 0
case_words(i) = word($cases[i], 5) . (case(i, 4) \
    ? (case(i, 1) < 1e3 ? sprintf(":  K1 %.3g,  K2 %.3g,  K3 %.3g N m/rad", case(i, 1), case(i, 2), case(i, 3)) \
        : sprintf(":  K1 %.1f,  K2 %.1f,  K3 %.1f ·10³ N m/rad", case(i, 1) / 1e3, case(i, 2) / 1e3, case(i, 3) / 1e3)) \
    : "")
panel_bottom = 552
legend_y(i) = panel_bottom + 70 + 25 * i
cases = |$cases|
height = legend_y(cases + 1)
eval page
wide_tics = 20  # of four digits, beside which the label needs room
eval axes(left_edge + wide_tics, right_edge, 82, panel_bottom)
do for [i = 1:cases] {
  eval sample(left_edge, legend_y(i), line(curve_colour(i), 1.8))
  set label case_words(i) at screen px(left_edge + sample_text),py(legend_y(i)) noenhanced
}
stats $slopes using 1:3 name "all" nooutput
set xrange [min(0, all_min_x):max(0, all_max_x)]
set yrange [0:axis_end(1.25 * all_max_y)]
set xtics tic_step(abs(all_max_x) + abs(all_min_x))
set ytics tic_step(1.25 * all_max_y)
set xlabel 'torque [N m]' noenhanced
set ylabel 'stiffness [N m/°]' noenhanced
plot for [i = 1:cases] $slopes index i-1 using 1:2:4 with filledcurves fillcolor rgb curve_colour(i) \
        fillstyle transparent solid 0.15 noborder notitle, \
    for [i = 1:cases] $slopes index i-1 using 1:3 with linespoints linecolor rgb curve_colour(i) linewidth 1.8 \
        pointtype 7 pointsize 0.35 notitle, \
    for [i = 1:cases] $catalogue index i-1 using 1:2 with lines linecolor rgb curve_colour(i) linewidth 4 notitle
