# SPDX-License-Identifier: GPL-3.0-or-later
# Shared by all pictures: the program runs it between the data and the template. Lengths on the picture are in pixels
# from its left and upper edges.
#
# Variables:
#   png      1: PNG for screens with many pixels, 0: SVG
#   heading  first line above the drawing
# A template sets `subject`, the second line, and `height`, and evaluates `page`; before each plot it evaluates
# axes(left, right, top, bottom).

set encoding utf8
set border 3 linecolor rgb 0x808080 linewidth 0.8
set tics nomirror out scale 0.6 textcolor rgb 0x303030
unset key

width = 1000.0
left_edge = 95.0
right_edge = width - 30

# Colours that stay apart for colour-blind eyes and in grey print.
black = 0x000000
ink = 0x303030
dark_grey = 0x5f5f5f
grey = 0x9a9a9a
light_grey = 0xc4c4c4
faint = 0xe0e0e0
paper = 0xf1efe9
white = 0xffffff
blue = 0x0072b2
light_blue = 0x9ccbe6
pale_blue = 0xdbe9f3
green = 0x009e73
orange = 0xe69f00
vermilion = 0xd55e00
light_vermilion = 0xefb790
purple = 0xcc79a7
# Colour of curve number i, counted from 1.
curve_colour(i) = word("0x0072b2 0xd55e00 0x009e73 0xcc79a7 0x000000 0xe69f00 0x56b4e9 0x8c6d46", (i - 1) % 8 + 1) + 0

# Places on the picture in gnuplot's screen coordinates.
px(x) = x / width
py(y) = 1 - y / (1.0 * height)

svg_terminal = "set terminal svg size width,height fixed font 'DejaVu Sans,15' background rgb 'white'"
png_terminal = "set terminal pngcairo size 2*width,2*height font 'DejaVu Sans,22.5' " \
    . "linewidth 2 dashlength 2 pointscale 2"
page = (png ? png_terminal : svg_terminal) \
    . "; set label heading at screen px(left_edge),py(26) noenhanced" \
    . "; set label subject at screen px(left_edge),py(50) noenhanced textcolor rgb 0x404040"
axes(left, right, top, bottom) = sprintf("set lmargin at screen %f; set rmargin at screen %f; " \
    . "set tmargin at screen %f; set bmargin at screen %f", px(left), px(right), py(top), py(bottom))

# Distance of tics, about eight across a range: 1, 2 or 5 times a power of ten.
round_up(part) = part < 1.5 ? 1 : part < 3.5 ? 2 : part < 7.5 ? 5 : 10
decade(step) = 10.0 ** floor(log10(step))
tic_step(range) = decade(range / 8.0) * round_up(range / 8.0 / decade(range / 8.0))
# The first tic above the largest value; an axis without values ends at 1.
axis_end(largest) = largest > 0 ? tic_step(largest) * ceil(1.04 * largest / tic_step(largest)) : 1

max(a, b) = a > b ? a : b
min(a, b) = a < b ? a : b

# How lines look, and a sample of one in a legend. gnuplot's own legend depends on guesses of text widths, which differ
# between SVG and PNG.
line(colour, thickness) = sprintf("linecolor rgb %d linewidth %g", colour, thickness)
dashed(colour, thickness, dash) = line(colour, thickness) . " dashtype " . dash
sample(x, y, look) = sprintf("set arrow from screen %f,%f to screen %f,%f nohead %s", \
    px(x), py(y), px(x + 44), py(y), look)
sample_text = 58

# A drawing in millimetres with the same scale in x and y: `eval window` sets the height and the axes from x_low,
# x_high, y_low and y_high, named `across` and `upwards`; entry(...) adds a line to the legend in two columns below
# them, unless nothing of it is shown.
decimals(step) = max(0, -int(floor(log10(step) + 1e-9)))
window = "step = tic_step(x_high - x_low)" \
    . "; height = floor(250.5 + (y_high - y_low) * (right_edge - left_edge) / (x_high - x_low))" \
    . "; eval page; eval axes(left_edge, right_edge, 66, height - 184)" \
    . "; set xrange [x_low:x_high]; set yrange [y_low:y_high]; set xtics step; set ytics step" \
    . "; set format sprintf('%%.%df', decimals(step))" \
    . "; set xlabel across noenhanced; set ylabel upwards noenhanced"
entries = 0
entry_x(i) = left_edge + (i - 1) % 2 * 437
entry_y(i) = height - 92 + (i - 1) / 2 * 25
entry(shown, look, text) = !shown ? "" : (entries = entries + 1, sample(entry_x(entries), entry_y(entries), look) \
    . sprintf("; set label '%s' at screen %f,%f noenhanced", \
        text, px(entry_x(entries) + sample_text), py(entry_y(entries))))

# Legend of colour bands: `eval colour_legend(top)` draws it from the variable `quantity` and the rows of
#   $bands       colour of each band
#   $band_ends   place counted in bands, "number below it"
#   $band_words  place counted in bands, "words that end there, above"
if (exists("$bands")) {
  band_x(i) = 250 + i * (right_edge - 250) / |$bands|
  band_place(row) = px(band_x(word(row, 1) + 0))
  bands(i, top) = i > |$bands| ? "" : sprintf("; set object rectangle from screen %f,%f to screen %f,%f " \
      . "fillcolor rgb %d fillstyle solid noborder front", \
      px(band_x(i - 1)), py(top + 18), px(band_x(i)), py(top), $bands[i] + 0) . bands(i + 1, top)
  band_ends(i, top) = i > |$band_ends| ? "" : sprintf( \
      "; set label word($band_ends[%d], 2) at screen %f,%f center noenhanced", \
      i, band_place($band_ends[i]), py(top + 34)) . band_ends(i + 1, top)
  band_words(i, top) = i > |$band_words| ? "" : sprintf( \
      "; set label word($band_words[%d], 2) at screen %f,%f right noenhanced", \
      i, band_place($band_words[i]), py(top - 12)) . band_words(i + 1, top)
  colour_legend(top) = sprintf("set label quantity at screen %f,%f noenhanced", px(left_edge), py(top + 9)) \
      . bands(1, top) . band_ends(1, top) . band_words(1, top)
}
