# SPDX-License-Identifier: GPL-3.0-or-later
# Line load over tooth space and slice on the flanks that carry more, and the force on each tooth.
#
# Columns:
#   $cells   rectangles: left, right [deg], low, high [mm], colour
#   $forces  angle of the tooth space [deg], force on these flanks, on the others (not positive) [N], width [deg]
#   $peak    angle [deg], z [mm], line load [N/mm]: the largest; no rows where there is none
#   $bands, $band_ends, $band_words, and the variable quantity: the legend of colours, see common.gp
# Variables: angle_low, angle_high [deg]; z_low, z_high [mm]; most, least [N]: largest force up and down;
# right_flank: 1 where the right flanks carry more, else 0; sectors: how often the pattern repeats around the ring

subject = sprintf("line load on the %s flanks, and the force on each tooth", right_flank ? "right" : "left") \
    . (sectors > 1 ? sprintf("; it repeats %d times around the ring", sectors) : "")
height = 714
eval page
eval colour_legend(396)

set multiplot
set xrange [angle_low:angle_high]
set xtics tic_step(angle_high - angle_low)
eval axes(left_edge, right_edge, 100, 330)
set yrange [z_low:z_high]
set ytics tic_step(2 * (z_high - z_low))
set ylabel 'z [mm]' noenhanced
if (|$peak| > 0) {
  at = word($peak[1], 1) + 0
  set arrow from first at, graph 1.06 to first at, graph 1.0 head filled size screen 0.006,25 linewidth 1.2 \
      linecolor rgb ink front
  words = sprintf("%.3g N/mm", word($peak[1], 3) + 0)
  if (2 * at > angle_low + angle_high) {
    set label words at first at, graph 1.10 right noenhanced
  } else {
    set label words at first at, graph 1.10 left noenhanced
  }
}
plot $cells using (($1 + $2) / 2):(($3 + $4) / 2):1:2:3:4:5 with boxxyerror linecolor rgb variable linewidth 0.4 \
        fillstyle solid 1 border notitle, \
    $peak using 1:2 with points pointtype 6 pointsize 0.9 linewidth 1.5 linecolor rgb white notitle

unset label
unset object
unset arrow
eval axes(left_edge, right_edge, 460, 630)
range = most > least ? most - least : 1
set yrange [1.08 * least:(most > 0 ? 1.08 * most : range)]
set ytics tic_step(2 * range)
set xlabel 'tooth space, degrees clockwise from the major axis' noenhanced
set ylabel 'force [N]' noenhanced
set boxwidth 0.85 relative
if (least < 0) {
  set label 'downwards: on the other flanks' at graph 0,1.07 left noenhanced textcolor rgb vermilion
}
plot $forces using 1:2 with boxes linecolor rgb blue fillstyle solid 1 noborder notitle, \
    $forces using 1:(least < 0 ? $3 : NaN) with boxes linecolor rgb vermilion fillstyle solid 1 noborder notitle
unset multiplot
