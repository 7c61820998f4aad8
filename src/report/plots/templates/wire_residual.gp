# SPDX-License-Identifier: GPL-3.0-or-later
# Height of the material that the last pass cannot reach, around the part.
#
# Columns: number of the tooth space, height above the contour [um].
#   $lower_idle, $upper_idle        places of either face that do not mesh
#   $lower_meshing, $upper_meshing  places that mesh
# Variables: pass: number of the last pass; wire_diameter [mm]; first_space, last_space; highest [um]

subject = sprintf("material that pass %d cannot reach with a wire of %g mm, above the contour", pass, wire_diameter)
height = 630
eval page
eval axes(left_edge, right_edge, 82, 482)
set xrange [first_space - 1:last_space + 1]
range = 1.1 * (highest > 0 ? highest : 1)
set yrange [0:range]
set ytics tic_step(range)
set xlabel 'tooth space' noenhanced
set ylabel 'residual material [µm]' noenhanced

marker(type, size, colour) = sprintf("pointtype %d pointsize %g linecolor rgb %d", type, size, colour)
lower_idle = marker(6, 0.7, blue)
upper_idle = marker(4, 1.1, green)
lower_meshing = marker(7, 0.7, vermilion)
upper_meshing = marker(12, 1.2, purple)
point_entry(shown, look, text) = !shown ? "" : (entries = entries + 1, \
    sprintf("set label '' at screen %f,%f point %s; set label '%s' at screen %f,%f noenhanced", px(entry_x(entries)), \
        py(entry_y(entries) + 37), look, text, px(entry_x(entries) + 18), py(entry_y(entries) + 37)))
eval point_entry(|$lower_idle|, lower_idle, "lower face, does not mesh")
eval point_entry(|$upper_idle|, upper_idle, "upper face, does not mesh")
eval point_entry(|$lower_meshing|, lower_meshing, "lower face, meshes")
eval point_entry(|$upper_meshing|, upper_meshing, "upper face, meshes")

plot $lower_idle using 1:2 with points @lower_idle notitle, \
    $upper_idle using 1:2 with points @upper_idle notitle, \
    $lower_meshing using 1:2 with points @lower_meshing notitle, \
    $upper_meshing using 1:2 with points @upper_meshing notitle
