# SPDX-License-Identifier: GPL-3.0-or-later
# Section of the cup in the colours of the largest von Mises stress over all angles, and that stress around the axis at
# the corner of an element where it is largest.
#
# Columns:
#   $cells    radius, z [mm]: elements as closed polygons, which empty lines part; one index for each colour
#   $colours  colour of each index
#   $place    radius, z [mm] of the largest stress
#   $around   angle from the major axis [deg], stress there [MPa]
#   $bands, $band_ends, $band_words, and the variable quantity: the legend of colours, see common.gp
# Variables: x_low, x_high, y_low, y_high [mm]; largest [MPa]

subject = "von Mises stress in the cup: mean of each element's corners, and around the axis at the largest corner"
stats $around using 1 name "angle" nooutput
angle_low = angle_min
angle_high = angle_max > angle_min ? angle_max : angle_min + 1
height = 694
eval page
eval colour_legend(638)

colour(i) = word($colours[i], 1) + 0
set multiplot
step = max(tic_step(x_high - x_low), tic_step(y_high - y_low))
eval axes(left_edge, 500, 110, 540)
set xrange [x_low:x_high]
set yrange [y_low:y_high]
set xtics step
set ytics step
set xlabel 'radius [mm]' noenhanced
set ylabel 'z above the middle of the bearing [mm]' noenhanced
set label 1001 'largest over all angles' at graph 0,1.03 left noenhanced
plot for [i = 1:|$colours|] $cells index i-1 using 1:2 with filledcurves closed fillcolor rgb colour(i) \
        fillstyle solid 1 border linecolor rgb colour(i) notitle, \
    $place using 1:2 with points pointtype 6 pointsize 1.4 linewidth 1.5 linecolor rgb blue notitle

unset label
unset object
unset ylabel
eval axes(555, 960, 110, 540)
ceiling = largest > 0 ? 1.05 * largest : 1
set xrange [angle_low:angle_high]
set yrange [0:ceiling]
set xtics angle_high - angle_low > 300 ? 60 : tic_step(angle_high - angle_low)
set ytics tic_step(ceiling)
set xlabel 'degrees clockwise from the major axis' noenhanced
set label 1001 sprintf('stress [MPa] at r = %.2f mm, z = %.2f mm (the circle)', \
    word($place[1], 1) + 0, word($place[1], 2) + 0) at graph 0,1.03 left noenhanced
plot $around using 1:2 with lines linecolor rgb blue linewidth 2 notitle
unset multiplot
