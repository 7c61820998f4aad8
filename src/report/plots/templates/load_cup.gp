# SPDX-License-Identifier: GPL-3.0-or-later
# Section of the cup at the major and the minor axis, as made and displaced by a multiple of its displacement.
#
# Columns: radius, z above the middle of the bearing [mm]; closed polygons, which empty lines part.
#   $made            as made
#   $major, $minor   displaced
# Variables: x_low, x_high, y_low, y_high [mm]; major_angle, minor_angle [deg]; multiple: of the displacement; largest:
# displacement [um]

subject = sprintf("section of the cup, grey as made, blue displaced by %g times its radial and axial displacement " \
    . "(largest %.3g µm)", multiple, largest)
height = 624
eval page
step = max(tic_step(x_high - x_low), tic_step(y_high - y_low))
set xrange [x_low:x_high]
set yrange [y_low:y_high]
set xtics step
set ytics step
set xlabel 'radius [mm]' noenhanced
set ylabel 'z above the middle of the bearing [mm]' noenhanced

set multiplot
eval axes(left_edge, 500, 110, 540)
set label 1001 sprintf('major axis, %g°', major_angle) at graph 0,1.03 left noenhanced
plot $made using 1:2 with filledcurves closed fillcolor rgb 0xdcdcdc fillstyle solid 1 noborder notitle, \
    $major using 1:2 with filledcurves closed fillcolor rgb 0xa6cde6 fillstyle solid 1 noborder notitle, \
    $major using 1:2 with lines linecolor rgb blue linewidth 0.7 notitle
unset label
eval axes(555, 960, 110, 540)
set label 1001 sprintf('minor axis, %g°', minor_angle) at graph 0,1.03 left noenhanced
plot $made using 1:2 with filledcurves closed fillcolor rgb 0xdcdcdc fillstyle solid 1 noborder notitle, \
    $minor using 1:2 with filledcurves closed fillcolor rgb 0xa6cde6 fillstyle solid 1 noborder notitle, \
    $minor using 1:2 with lines linecolor rgb blue linewidth 0.7 notitle
unset multiplot
