# SPDX-License-Identifier: GPL-3.0-or-later
# Gap over one flank, along the flank and over the face width.
#
# Columns:
#   $cells    rectangles: left, right, low, high, colour; along the flank in mm or shares of its length, z in mm
#   $contour  along, z: pieces of the line where the gap is the contact gap
#   $slices   z [mm] of the slices that were computed; between them gaps are interpolated
#   $bands, $band_ends, $band_words, and the variable quantity: the legend of colours, see common.gp
# Variables: longest: largest distance along the flank; in_mm: 1 where these distances are in mm, 0 for shares; z_low,
# z_high [mm]; right_flank: 1 or 0, angle [deg], in_contact: 1 or 0: the flank

subject = sprintf("%s flank of the tooth space at %.2f°, the one with %s; circular spline turned to first contact", \
    right_flank ? "right" : "left", angle, in_contact ? "most contact" : "the smallest gap")
height = 666
eval page
eval colour_legend(606)

eval axes(left_edge, width - 62, 82, 502)
set border 11
set xrange [0:longest]
set yrange [z_low:z_high]
set y2range [z_low:z_high]
set xtics tic_step(longest)
set ytics tic_step(z_high - z_low)
set y2tics ('' z_low)
do for [i = 1:|$slices|] { set y2tics add ('' $slices[i] + 0) }
set xlabel sprintf('along the flank, from the land corner to the flank end [%s]', \
    in_mm ? 'mm' : 'fraction of its length') noenhanced
set ylabel 'z [mm]' noenhanced
set y2label 'slices computed' noenhanced offset -1,0
# A border closes the seam that the smoothed edges of two neighbours leave.
plot $cells using (($1 + $2) / 2):(($3 + $4) / 2):1:2:3:4:5 with boxxyerror linecolor rgb variable linewidth 0.6 \
        fillstyle solid 1 border notitle, \
    $contour using 1:2 with lines linecolor rgb white linewidth 1.8 notitle
