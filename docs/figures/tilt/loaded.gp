# SPDX-License-Identifier: GPL-3.0-or-later
# Draws docs/figures/tilt-loaded.svg from data/reference/load-thesis.csv and load-surfaces.csv; run in the project's
# folder by docs/pictures.sh.
set terminal svg size 900,400 font "DejaVu Sans,13" enhanced background "white"
set output "docs/figures/tilt-loaded.svg"
set datafile separator ","
set title "flank under pressure at 28 N m, % of all flanks of the loaded side; lines: stated error"
set style fill solid
set boxwidth 0.62
set yrange [0:1]
set xrange [-0.7:10.7]
set ytics 0.2 nomirror
set grid ytics lc rgb "#dddddd"
set border 3 lc rgb "#666666"
unset key
set bmargin 4
set xtics nomirror scale 0 ("0°" 0, "0.1°\nradial" 1, "0.2°\nradial" 2, "0.3°\nradial" 3, "0.1°\ndraft" 4, \
  "0.2°\ndraft" 5, "0.3°\ndraft" 6, "ruled\n40 µm" 7, "ruled\n0 µm" 8, "per slice\n40 µm" 9, "per slice\n0 µm" 10)
set label 1 "one outline, least side clearance" at 3,0.42 center tc rgb "#2060b0"
set label 2 "surface that follows the cone,\nside clearance below" at 7.6,0.6 center tc rgb "#b03030"
tilts = "data/reference/load-thesis.csv"
surfaces = "data/reference/load-surfaces.csv"
place(row) = row < 4 ? row : row - 1
# rows of load-surfaces.csv: none, 40 and 65 um, each tilted, ruled, per-slice
bar(row) = row == 1 ? 8 : row == 2 ? 10 : row == 4 ? 7 : row == 5 ? 9 : NaN
plot tilts using ($0 == 4 ? NaN : place($0)):10 every ::1 with boxes lc rgb "#2060b0", \
  "" using ($0 == 4 ? NaN : place($0)):($10 - $11):(0):(2*$11) every ::1 with vectors heads size 0.08,90 lc rgb "#222222", \
  "" using ($0 == 4 ? NaN : place($0)):($10 + $11 + 0.03):(sprintf("%.2f", $10)) every ::1 with labels, \
  surfaces using (bar($0)):10 every ::1 with boxes lc rgb "#b03030", \
  "" using (bar($0)):($10 - $11):(0):(2*$11) every ::1 with vectors heads size 0.08,90 lc rgb "#222222", \
  "" using (bar($0)):($10 + $11 + 0.03):(sprintf("%.2f", $10)) every ::1 with labels
