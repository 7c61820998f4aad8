# SPDX-License-Identifier: GPL-3.0-or-later
# Forces of the balls around the whole ring.
#
# Columns:
#   $carrying, $idle  angle from the major axis, -180 to 180 [deg], force [N]: balls that carry, and those that do not
# Variables: largest [N]; waves: lobes of the cam

subject = sprintf("forces of the %d balls on the outer ring%s; bands: lobes of the cam", |$carrying| + |$idle|, \
    |$idle| > 0 ? sprintf("; %d carry nothing (grey)", |$idle|) : "")
height = 504
eval page
eval axes(left_edge, right_edge, 100, 420)
ceiling = largest > 0 ? 1.12 * largest : 1
set xrange [-186:186]
set yrange [0:ceiling]
set xtics -180,30,180
set ytics tic_step(ceiling)
set xlabel 'angle from the major axis [°]' noenhanced
set ylabel 'force of a ball [N]' noenhanced
# A lobe lifts the ring at each end of the major axis.
do for [i = -int(waves):int(waves)] {
  lobe = 360.0 * i / waves
  if (abs(lobe) <= 180) {
    set arrow from first lobe,0 to first lobe,ceiling nohead back linecolor rgb 0xd8d8d8 linewidth 6
  }
}
plot $idle using 1:2 with points pointtype 7 pointsize 0.7 linecolor rgb grey notitle, \
    $carrying using 1:2 with impulses linecolor rgb blue linewidth 2 notitle, \
    $carrying using 1:2 with points pointtype 7 pointsize 0.7 linecolor rgb blue notitle
