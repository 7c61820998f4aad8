# SPDX-License-Identifier: GPL-3.0-or-later
# One tooth space of the circular spline with the flexspline teeth that sweep it, or, of the reverse problem, one tooth
# of the flexspline with the circular-spline teeth.
#
# Columns: x, y [mm] of polylines, which empty lines part.
#   $material         what is left of the blank, closed beyond the frame
#   $family           positions of the given tooth
#   $branch           envelope that is not on the boundary
#   $tip_circle       of the circular spline
#   $tooth            the given tooth at the major axis
#   $outline          the tooth solved for
#   $boundary         envelope on the boundary
#   $boundary_corner  path of a tooth corner on the boundary
#   $corner           path of a tooth corner that is not
# Variables: reverse: 1 for the reverse problem, else 0; module, w0 [mm]; z_f, z_c: teeth; positions: number of teeth in
# $family; x_low, x_high, y_low, y_high [mm].

subject = (reverse ? "flexspline tooth, left free by the circular spline's" \
    : "tooth space of the circular spline, swept by the flexspline") \
    . sprintf(":  module %g mm,  teeth %d/%d,  w0 %g mm", module, z_f, z_c, w0)
across = reverse ? "x [mm], across the tooth" : "x [mm], across the tooth space"
upwards = reverse ? "y [mm], from the pitch line" : "y [mm], from the axis of the drive"
eval window

family = line(light_grey, 0.7)
branch = line(light_blue, 1.6)
tip_circle = dashed(dark_grey, 0.9, "(12,4,2,4)")
tooth = line(dark_grey, 1.4)
outline = line(black, 4.2)
boundary = line(blue, 1.9)
boundary_corner = dashed(vermilion, 1.9, "(6,4)")
corner = dashed(light_vermilion, 1.4, "(6,4)")

eval entry(|$family|, family, sprintf("%s, %d positions", \
    reverse ? "circular-spline teeth" : "flexspline tooth", positions))
eval entry(|$branch|, branch, "envelope, not on the boundary")
eval entry(|$tip_circle|, tip_circle, "tip circle of the circular spline")
eval entry(|$tooth|, tooth, reverse ? "circular spline at the major axis, given" : "flexspline tooth at the major axis")
eval entry(|$outline|, outline, reverse ? "flexspline tooth, solved for" : "circular spline")
eval entry(|$boundary|, boundary, "envelope on the boundary")
eval entry(|$boundary_corner|, boundary_corner, "path of a tooth corner, on the boundary")
eval entry(|$corner|, corner, "path of a tooth corner, not on the boundary")

plot $material using 1:2 with filledcurves closed linecolor rgb paper fillstyle solid noborder notitle, \
    $family using 1:2 with lines @family notitle, \
    $branch using 1:2 with lines @branch notitle, \
    $tip_circle using 1:2 with lines @tip_circle notitle, \
    $tooth using 1:2 with lines @tooth notitle, \
    $outline using 1:2 with lines @outline notitle, \
    $boundary using 1:2 with lines @boundary notitle, \
    $boundary_corner using 1:2 with lines @boundary_corner notitle, \
    $corner using 1:2 with lines @corner notitle
