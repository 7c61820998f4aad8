# SPDX-License-Identifier: GPL-3.0-or-later
# One page of an inspection: deviations along the left and the right flanks, positions of the flanks and radial shifts
# of the teeth round the ring.
#
# Columns:
#   $left_traces, $right_traces  arc length from the root [mm], deviation [um]; an empty row after each flank
#   $left_band, $right_band  arc length, least and largest deviation of all flanks
#   $left_strays, $right_strays  the same of points that are left out; first a row of NaN
#   $ring  number of the tooth, position of its left flank, of its right flank, radial shift [um]; an empty row where
#          teeth are missing
# Variables: left_words, right_words, ring_words: figures; left_drawn, right_drawn: how many flanks are
# drawn, empty: all; registration; flank_length [mm]; first_tooth, last_tooth: numbers

subject = "deviation along the nominal normal, positive: too much material; registration: " . registration
height = 790
eval page
middle = (left_edge + right_edge) / 2
set label 'left: ' . left_words at screen px(left_edge),py(84) noenhanced textcolor rgb blue
set label 'right: ' . right_words at screen px(middle + 50),py(84) noenhanced textcolor rgb vermilion
set label left_drawn at screen px(left_edge),py(434) noenhanced
set label right_drawn at screen px(middle + 50),py(434) noenhanced
set label ring_words at screen px(left_edge),py(468) noenhanced
eval sample(left_edge, 494, line(blue, 1.6))
eval sample(left_edge + 215, 494, line(vermilion, 1.6))
eval sample(left_edge + 440, 494, dashed(dark_grey, 1.4, "(4,4)"))
set label 'left flanks, position' at screen px(left_edge + sample_text),py(494) noenhanced
set label 'right flanks, position' at screen px(left_edge + 215 + sample_text),py(494) noenhanced
set label 'radial shift' at screen px(left_edge + 440 + sample_text),py(494) noenhanced

stats $left_band using 2:3 name "l" nooutput
stats $right_band using 2:3 name "r" nooutput
low = min(exists("l_min_x") ? l_min_x : 0, exists("r_min_x") ? r_min_x : 0)
high = max(exists("l_max_y") ? l_max_y : 0, exists("r_max_y") ? r_max_y : 0)
margin = high > low ? 0.08 * (high - low) : 1
set multiplot
set xrange [0:flank_length]
set yrange [low - margin:high + margin]
set xtics tic_step(2 * flank_length)
set ytics tic_step(high - low + 2 * margin)
set xlabel 'arc length from the root [mm]' noenhanced
set ylabel 'deviation [µm]' noenhanced
set xzeroaxis linecolor rgb grey linewidth 0.8
eval axes(left_edge, middle - 20, 100, 360)
plot $left_band using 1:(strlen(left_drawn) ? $2 : NaN):3 \
        with filledcurves fillcolor rgb 0xdcdcdc fillstyle solid 1 noborder notitle, \
    $left_traces using 1:2 with linespoints pointtype 7 pointsize 0.15 linecolor rgb blue linewidth 0.6 notitle, \
    $left_strays using 1:2 with points pointtype 2 pointsize 0.7 linecolor rgb ink notitle
unset label
unset arrow
eval axes(middle + 50, right_edge, 100, 360)
unset ylabel
plot $right_band using 1:(strlen(right_drawn) ? $2 : NaN):3 \
        with filledcurves fillcolor rgb 0xdcdcdc fillstyle solid 1 noborder notitle, \
    $right_traces using 1:2 with linespoints pointtype 7 pointsize 0.15 linecolor rgb vermilion linewidth 0.6 notitle, \
    $right_strays using 1:2 with points pointtype 2 pointsize 0.7 linecolor rgb ink notitle
eval axes(left_edge, right_edge, 516, 720)
set xrange [first_tooth - 1:last_tooth + 1]
set autoscale y
set offsets 0, 0, graph 0.08, graph 0.08
set xtics autofreq
set ytics autofreq
set xlabel 'number of the tooth' noenhanced
set ylabel 'shift [µm]' noenhanced
plot $ring using 1:4 with linespoints pointtype 6 pointsize 0.3 linecolor rgb dark_grey dashtype (4,4) \
        linewidth 1.2 notitle, \
    $ring using 1:2 with linespoints pointtype 7 pointsize 0.3 linecolor rgb blue linewidth 1.4 notitle, \
    $ring using 1:3 with linespoints pointtype 7 pointsize 0.3 linecolor rgb vermilion linewidth 1.4 notitle
unset multiplot
