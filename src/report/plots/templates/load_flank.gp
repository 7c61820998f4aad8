# SPDX-License-Identifier: GPL-3.0-or-later
# Where the tooth that carries most is pressed, over its flank, and how much, over the face width.
#
# Columns:
#   $strips  Hertz strips: from and to height [mm], low and high z [mm], colour of the largest pressure
#   $sure    z [mm], largest pressure of a strip that is determined [MPa]; may have no rows
#   $unsure  the same of strips on the rounded edge of the land or near the ends of the width; may have no rows
#   $load    z [mm], line load [N/mm], width of the slice [mm]
#   $bands, $band_ends, $band_words, and the variable quantity: the legend of colours, see common.gp
# Variables: angle [deg] of the tooth space, right_flank: 1 or 0, force [N] on the flank, most [MPa] and most_load
# [N/mm]: largest pressure and line load; height_low, height_high [mm]: end and tip of the flank, from the pitch circle
# towards the axis; z_low, z_high [mm]

subject = sprintf("%s flank of the tooth space at %.2f°, which carries most: %.3g N", right_flank ? "right" : "left", \
    angle, force)
height = 806
eval page
eval colour_legend(376)

set multiplot
eval axes(left_edge, right_edge, 82, 282)
set xrange [height_low:height_high]
set yrange [z_low:z_high]
set xtics tic_step(height_high - height_low)
set ytics tic_step(2 * (z_high - z_low))
set xlabel 'height on the flank of the circular spline, from its pitch circle towards the tip [mm]' noenhanced
set ylabel 'z [mm]' noenhanced
set object rectangle from graph 0,0 to graph 1,1 fillcolor rgb paper fillstyle solid noborder behind
set label 'end of the flank' at graph 0.005,0.06 left noenhanced textcolor rgb dark_grey
set label 'tip' at graph 0.995,0.06 right noenhanced textcolor rgb dark_grey
plot $strips using (($1 + $2) / 2):(($3 + $4) / 2):1:2:3:4:5 with boxxyerror linecolor rgb variable linewidth 2.2 \
    fillstyle solid 1 border notitle

unset label
unset object
eval axes(left_edge, right_edge - 65, 452, 668)
set border 11
set xrange [z_low:z_high]
set yrange [0:axis_end(most)]
set xtics tic_step(z_high - z_low)
set ytics tic_step(2 * axis_end(most))
set y2range [0:axis_end(most_load)]
set y2tics tic_step(2 * axis_end(most_load))
set xlabel 'z [mm]' noenhanced
set ylabel 'pressure [MPa]' noenhanced offset 1,0
set y2label 'line load [N/mm]' noenhanced
legend_y = 772
eval sample(left_edge, legend_y, line(pale_blue, 9))
set label 'line load' at screen px(left_edge + sample_text),py(legend_y) noenhanced
set label '' at screen px(260),py(legend_y) point pointtype 7 pointsize 0.9 linecolor rgb vermilion
set label 'largest pressure' at screen px(275),py(legend_y) noenhanced
set label '' at screen px(445),py(legend_y) point pointtype 6 pointsize 0.9 linewidth 1.5 linecolor rgb vermilion
set label 'not determined: on an edge, or within 0.5 mm of an end' at screen px(460),py(legend_y) noenhanced
plot $load using 1:2:($3 * 0.96) axes x1y2 with boxes linecolor rgb pale_blue fillstyle solid 1 noborder notitle, \
    $unsure using 1:2 with points pointtype 6 pointsize 0.9 linewidth 1.5 linecolor rgb vermilion notitle, \
    $sure using 1:2 with points pointtype 7 pointsize 0.9 linecolor rgb vermilion notitle
unset multiplot
