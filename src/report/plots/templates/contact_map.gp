# SPDX-License-Identifier: GPL-3.0-or-later
# Smallest gap along each flank over tooth space and slice, both flanks.
#
# Columns:
#   $right, $left  rectangles: left, right [deg], low, high [mm], colour
#   $bands, $band_ends, $band_words, and the variable quantity: the legend of colours, see common.gp
# Variables: z_low, z_high [mm]; right_flank: 1 or 0, angle [deg], in_contact: 1 or 0: the flank that another picture
# draws larger; wave_generator: its angle [deg], where it is known

subject = "smallest gap along each flank, circular spline turned to first contact" \
    . (exists("wave_generator") ? sprintf(", wave generator at %g°", wave_generator) : "")
height = 742
eval page
eval colour_legend(682)

set multiplot
set xrange [-180:180]
set yrange [z_low:z_high]
set xtics 45
set ytics tic_step(2 * (z_high - z_low))
set ylabel 'z [mm]' noenhanced
on_left = angle < -20  # where the name of the flanks stands
mark_label = "set label 1002 in_contact ? 'most contact' : 'smallest gap' at first angle, graph 1.09 " \
    . (angle > 150 ? "right" : angle < -150 ? "left" : "center") . " noenhanced"
mark = mark_label . "; set arrow 1001 from first angle, graph 1.055 to first angle, graph 1.0 head filled " \
    . "size screen 0.006,25 linewidth 1.2 linecolor rgb ink"

eval axes(left_edge, right_edge, 104, 304)
set_name(words, marked) = sprintf("set label 1001 '%s' at graph %d,1.09 %s noenhanced", words, marked && on_left, \
    marked && on_left ? "right" : "left")
eval set_name("right flanks, driving side", right_flank)
if (right_flank) { eval mark }
# A border closes the seam that the smoothed edges of two neighbours leave.
plot $right using (($1 + $2) / 2):(($3 + $4) / 2):1:2:3:4:5 with boxxyerror linecolor rgb variable linewidth 0.6 \
    fillstyle solid 1 border notitle

unset label
unset object
unset arrow
eval axes(left_edge, right_edge, 392, 592)
eval set_name("left flanks", !right_flank)
if (!right_flank) { eval mark }
set xlabel 'tooth space, degrees clockwise from the major axis' noenhanced offset 0,0.4
plot $left using (($1 + $2) / 2):(($3 + $4) / 2):1:2:3:4:5 with boxxyerror linecolor rgb variable linewidth 0.6 \
    fillstyle solid 1 border notitle
unset multiplot
