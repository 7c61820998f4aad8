# SPDX-License-Identifier: GPL-3.0-or-later
# The whole contour that one set-up cuts by wire, with start hole, leads, stops and the direction of travel.
#
# Columns: x, y [mm] of polylines, which empty lines part.
#   $contour  of the part, lower face
#   $path     centre of the wire, lower face, first pass
#   $leads    straight in and out
#   $marks    x, y [mm], 1 for a stop or 0 for an end of the path, "words"
#   $arrow    two points beside the beginning of the path; none where the path has no such place
# Variables: x_low, x_high, y_low, y_high [mm]; passes, blocks: their numbers; lower_inner, lower_outer, upper_inner,
# upper_outer: radii of both faces [mm].

subject = sprintf("%d pass%s, %d blocks;  lower face %.4f to %.4f mm, upper face %.4f to %.4f mm from the axis", \
    passes, passes == 1 ? "" : "es", blocks, lower_inner, lower_outer, upper_inner, upper_outer)
across = "x [mm]"
upwards = "y [mm]"
eval window

contour = line(black, 1.6)
path = line(blue, 0.9)
leads = line(vermilion, 1.5)

eval entry(|$contour|, contour, "contour of the part, lower face")
eval entry(|$path|, path, "centre of the wire, lower face, first pass")
eval entry(|$leads|, leads, "straight in and out")
if (|$arrow| > 1) {
    set arrow from word($arrow[1], 1) + 0,word($arrow[1], 2) + 0 to word($arrow[2], 1) + 0,word($arrow[2], 2) + 0 \
        head filled size screen 0.014,18 linecolor rgb blue linewidth 1.6 front
}

# Without any stop there is nothing to label: gnuplot does not survive labels that are all undefined.
stats $marks using 3 name "mark" nooutput
stops = mark_max > 0 ? "$marks using 1:($3 == 1 ? $2 : NaN):4 with labels left offset 0.9,-0.9 point" \
    . " pointtype 7 pointsize 0.8 linecolor rgb purple textcolor rgb purple noenhanced notitle" : "NaN notitle"

plot $contour using 1:2 with lines @contour notitle, \
    $path using 1:2 with lines @path notitle, \
    $leads using 1:2 with lines @leads notitle, \
    $marks using 1:($3 == 0 ? $2 : NaN):4 with labels left offset 0.9,0.5 point pointtype 7 pointsize 0.8 \
        linecolor rgb vermilion textcolor rgb vermilion noenhanced notitle, \
    @stops
