# SPDX-License-Identifier: GPL-3.0-or-later
# A neutral curve that was looked for between two given teeth, over half a wave: its displacement, its curvature, and
# its error where flanks touch.
#
# Columns:
#   $curve  angle [deg], displacement [um], curvature [1/m], error of the displacement [um] or NaN
#   $mesh   the same, NaN where no flanks touch
# Variables: words: figures; half_wave, touch_begin, touch_end [deg]; ring: curvature of the undeformed ring [1/m]

subject = words
height = 805
left = left_edge + 22
eval page
eval sample(left, 84, line(blue, 2.4))
set label 'flanks touch' at screen px(left + sample_text),py(84) noenhanced
eval sample(left + 160, 84, dashed(dark_grey, 1.4, "(4,4)"))
set label 'completed' at screen px(left + 160 + sample_text),py(84) noenhanced
set multiplot
set xrange [0:half_wave]
set xtics tic_step(half_wave)
set xzeroaxis linecolor rgb grey linewidth 0.8
unset xlabel
set format x ''
set autoscale y
set offsets 0, 0, graph 0.06, graph 0.06
set ylabel 'displacement [µm]' noenhanced
eval axes(left, right_edge, 100, 310)
plot $curve using 1:2 with lines linecolor rgb dark_grey dashtype (4,4) linewidth 1.4 notitle, \
    $mesh using 1:2 with lines linecolor rgb blue linewidth 2.4 notitle
unset label
unset arrow
set ylabel 'curvature [1/m]' noenhanced
eval axes(left, right_edge, 330, 520)
plot ring with lines linecolor rgb grey linewidth 0.8 notitle, \
    $curve using 1:3 with lines linecolor rgb dark_grey dashtype (4,4) linewidth 1.4 notitle, \
    $mesh using 1:3 with lines linecolor rgb blue linewidth 2.4 notitle
set xlabel 'angle from the major axis [deg]' noenhanced
set format x '%g'
set ylabel 'error [µm]' noenhanced
set logscale y
set format y '%.0e'
eval axes(left, right_edge, 540, 720)
plot $mesh using 1:4 with lines linecolor rgb vermilion linewidth 1.8 notitle
unset multiplot
