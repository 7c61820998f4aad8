# SPDX-License-Identifier: GPL-3.0-or-later
# One tooth space of a part that is cut by wire: its contour in both faces, the wire of every pass, and the wire itself
# at some places of the last pass.
#
# Columns: x, y [mm] of polylines, which empty lines part; of faces that are equal, the upper one has no rows.
#   $lower, $upper            contour of the part
#   $earlier                  centre of the wire in the lower face, earlier passes
#   $path_lower, $path_upper  centre of the wire, last pass
#   $wires_lower, $wires_upper  places where the wire is drawn
# Variables: x_low, x_high, y_low, y_high [mm]; space: number of the tooth space, -1: the whole part; level: 1 where
# both faces are equal, else 0; face_shift, guide_shift [um]; upper_face: words about it; wire_diameter, spark_gap [mm].

whole = space < 0
subject = (whole ? "the whole part" : sprintf("tooth space %d", space)) \
    . sprintf(";  face shift %.4g µm,  guide offset %.4g µm,  upper face %s", face_shift, guide_shift, upper_face)
across = whole ? "x [mm]" : "x [mm], across the tooth space"
upwards = whole ? "y [mm]" : "y [mm], from the axis of the part"
face = level ? "both faces" : "lower face"
eval window

radius = wire_diameter / 2.0
earlier = line(grey, 0.8)
lower = line(black, 2.6)
upper = line(vermilion, 2.2)
path_lower = line(blue, 1.7)
path_upper = line(orange, 1.6)
wire_lower = line(blue, 0.9)
wire_upper = line(orange, 0.8)
cut = dashed(blue, 0.65, "(3,3)")

eval entry(|$earlier|, earlier, "centre of the wire, lower face, earlier passes")
eval entry(|$lower|, lower, "contour of the part, " . face)
eval entry(|$upper|, upper, "contour of the part, upper face")
eval entry(|$path_lower|, path_lower, "centre of the wire, " . face . ", last pass")
eval entry(|$path_upper|, path_upper, "centre of the wire, upper face, last pass")
eval entry(|$wires_lower|, wire_lower, sprintf("wire, %g mm, %s", wire_diameter, face))
eval entry(|$wires_lower|, cut, sprintf("what it cuts there, gap %g mm", spark_gap))
eval entry(|$wires_upper|, wire_upper, "wire, upper face, the same moves")

plot $wires_lower using 1:2:(radius) with circles linecolor rgb pale_blue fillstyle solid noborder notitle, \
    $earlier using 1:2 with lines @earlier notitle, \
    $lower using 1:2 with lines @lower notitle, \
    $upper using 1:2 with lines @upper notitle, \
    $path_lower using 1:2 with lines @path_lower notitle, \
    $path_upper using 1:2 with lines @path_upper notitle, \
    $wires_lower using 1:2:(radius) with circles @wire_lower fillstyle empty notitle, \
    $wires_lower using 1:2:(radius + spark_gap) with circles @cut fillstyle empty notitle, \
    $wires_upper using 1:2:(radius) with circles @wire_upper fillstyle empty notitle
