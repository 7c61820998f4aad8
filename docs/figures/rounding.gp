# SPDX-License-Identifier: GPL-3.0-or-later
# Pictures of docs/explanation/stability.md from data/reference/rounding-*.csv; run by docs/pictures.sh in the project's folder.
set datafile separator ","
set datafile missing ""
set terminal pngcairo size 1140,630 font "DejaVu Sans,13" fontscale 1.3 pointscale 1.5 linewidth 1.5
set logscale y
set format y "10^{%T}"
set yrange [1e-20:10]
set ytics 1e-20, 1e4
set grid back lc rgb "#dddddd"
set key outside right center samplen 0.5 spacing 1.2
set border lc rgb "#666666"
red = 0xb03030; blue = 0x2060b0; green = 0x308040

set logscale x
set format x "10^{%T}"
set output "docs/figures/rounding-fold.png"
set title "Beside a fold (type-50): the position of a given profile point"
set xlabel "position after the fold [rad]"
set ylabel "error of the position [rad], of the envelope"
set yrange [1e-36:10]
set ytics 1e-36, 1e4
set xrange [1e-10:0.5]
set arrow 1 from 1e-10,1e-10 to 0.5,0.5 nohead lc rgb "#aaaaaa" dt 2
set label 1 "lost altogether" at 3e-4,5e-2 right tc rgb "#888888"
file = "data/reference/rounding-fold.csv"
plot file using 1:2 with points pt 7 ps 0.4 lc rgb red title "float: position", \
     file using 1:3 with points pt 6 ps 0.4 lc rgb red title "envelope", \
     file using 1:4 with points pt 7 ps 0.4 lc rgb blue title "double: position", \
     file using 1:5 with points pt 6 ps 0.4 lc rgb blue title "envelope", \
     file using 1:6 with points pt 7 ps 0.4 lc rgb green title "long double: position", \
     file using 1:7 with points pt 6 ps 0.4 lc rgb green title "envelope"
unset arrow 1
unset label 1

set output "docs/figures/rounding-cusp.png"
set title "Beside a cusp (swallowtail design): the speed of the envelope"
set xlabel "position after the cusp [rad]"
set ylabel "relative error"
set yrange [1e-20:1e3]
set ytics 1e-20, 1e4
set xrange [1e-13:0.2]
set xtics 1e-12, 100
set label 1 "above: the sign is lost" at 0.1,20 right tc rgb "#888888"
set arrow 1 from 1e-13,1 to 0.2,1 nohead lc rgb "#aaaaaa" dt 2
file = "data/reference/rounding-cusp.csv"
plot file using 1:2 with points pt 7 ps 0.4 lc rgb red title "float: speed", \
     file using 1:3 with points pt 6 ps 0.4 lc rgb red title "envelope", \
     file using 1:4 with points pt 7 ps 0.4 lc rgb blue title "double: speed", \
     file using 1:5 with points pt 6 ps 0.4 lc rgb blue title "envelope", \
     file using 1:6 with points pt 7 ps 0.4 lc rgb green title "long double: speed", \
     file using 1:7 with points pt 6 ps 0.4 lc rgb green title "envelope"
unset arrow 1
unset label 1

unset logscale x
set format x "%g"
set xtics auto
set output "docs/figures/rounding-fast.png"
set yrange [1e-20:10]
set title "Fast contact: one degree takes it over the whole straight flank"
set xlabel "position u [deg]"
set ylabel "error [tooth heights]"
set xrange [*:*]
file = "data/reference/rounding-fast.csv"
plot file using 1:3 with points pt 7 ps 0.4 lc rgb red title "float: along", \
     file using 1:4 with points pt 6 ps 0.4 lc rgb red title "across", \
     file using 1:5 with points pt 7 ps 0.4 lc rgb blue title "double: along", \
     file using 1:6 with points pt 6 ps 0.4 lc rgb blue title "across", \
     file using 1:7 with points pt 7 ps 0.4 lc rgb green title "long double: along", \
     file using 1:8 with points pt 6 ps 0.4 lc rgb green title "across"
