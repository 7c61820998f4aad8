# SPDX-License-Identifier: GPL-3.0-or-later
# Draws docs/figures/load/members.svg from data/reference/load-members.csv; run in the project's folder by
# docs/pictures.sh.
set terminal svg size 900,420 font "DejaVu Sans,13" enhanced background "white"
set output "docs/figures/load/members.svg"
set datafile separator ","
set title "stiffness of type-50, one outline, with one member after the other, 1000 N m/rad"
set style fill solid
set boxwidth 0.26
set yrange [0:42]
set xrange [-0.6:8.9]
set ytics 10 nomirror
set grid ytics lc rgb "#dddddd"
set border 3 lc rgb "#666666"
set key top right horizontal
set samples 2
set bmargin 4
set xtics nomirror scale 0 ("teeth\nand cup" 0, "22 rigid\nballs" 1, "balls by\nHertz" 2, "bearing\nclearance" 3, \
  "circular\nspline" 4, "flange" 5, "hub" 6, "shaft" 7)
set label 1 "catalogue K3" at 7.6,30.2 tc rgb "#666666"
set label 2 "catalogue K1" at 7.6,17.2 tc rgb "#666666"
set label 3 "thesis, second line" at 7.6,11.7 tc rgb "#b03030"
set label 4 "thesis, first line" at 7.6,4.4 tc rgb "#b03030"
table = "data/reference/load-members.csv"
row(n, x) = n < 8 ? x / 1000 : NaN
plot table using ($0 - 0.28):(row($0, $6)) every ::1 with boxes lc rgb "#90b8e0" title "K1", \
  "" using ($0):(row($0, $8)) every ::1 with boxes lc rgb "#5088c8" title "K2", \
  "" using ($0 + 0.28):(row($0, $10)) every ::1 with boxes lc rgb "#2060b0" title "K3", \
  29 lc rgb "#666666" dt 2 notitle, 16 lc rgb "#666666" dt 2 notitle, \
  10.474 lc rgb "#b03030" dt 2 notitle, 7.534 lc rgb "#b03030" dt 3 notitle, \
  5.655 lc rgb "#b03030" dt 2 notitle, 3.186 lc rgb "#b03030" dt 3 notitle
