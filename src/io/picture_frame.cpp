// SPDX-License-Identifier: GPL-3.0-or-later
#include "picture_frame.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "picture_lines.hpp"

namespace hdconj::picture {
namespace {

constexpr double heading_y = 26, subject_y = 50;  // [px] from above

/// Decimals that numbers in steps of @p step need.
int decimals_of(double step)
{
    constexpr double rounding = 1e-9;  // log10(0.001) may be a little below -3
    return std::max(0, -static_cast<int>(std::floor(std::log10(step) + rounding)));
}

}  // namespace

std::string screen(double x, double y, double height)
{
    return fmt::format("screen {:.6f},{:.6f}", x / width, 1 - y / height);
}

std::string Window::screen(double x, double y) const
{
    return picture::screen(x, y, height());
}

std::string title(double height, Words const& words)
{
    return fmt::format(
        "set label {} at {} noenhanced\n"
        "set label {} at {} noenhanced textcolor rgb '#404040'\n",
        gnuplot_quoted(words.heading), screen(left_margin, heading_y, height), gnuplot_quoted(words.subject),
        screen(left_margin, subject_y, height));
}

std::string axes(Panel const& panel, double height)
{
    return fmt::format(
        "set encoding utf8\n"
        "set lmargin at screen {:.6f}\nset rmargin at screen {:.6f}\n"
        "set bmargin at screen {:.6f}\nset tmargin at screen {:.6f}\n"
        "set border 3 linecolor rgb '#808080' linewidth 0.8\n"
        "set tics nomirror out scale 0.6 textcolor rgb '#303030'\n"
        "unset key\n",
        panel.left / width, panel.right / width, 1 - panel.bottom / height, 1 - panel.top / height);
}

double tic_step(double range)
{
    constexpr double wanted = 8;
    double const power = std::pow(10.0, std::floor(std::log10(range / wanted)));
    double const rest = range / wanted / power;
    return power * (rest < 1.5 ? 1 : rest < 3.5 ? 2 : rest < 7.5 ? 5 : 10);
}

std::string terminal(PictureFormat format, double height)
{
    if (format == PictureFormat::svg) {
        return fmt::format("set terminal svg size {},{} fixed font 'DejaVu Sans,{}' background rgb 'white'\n", width,
                           height, font_size);
    }
    constexpr int finer = 2;               // for screens with many pixels
    constexpr double point_per_px = 0.75;  // cairo takes sizes in points
    return fmt::format("set terminal pngcairo size {},{} font 'DejaVu Sans,{}' linewidth {} dashlength {} "
                       "pointscale {}\n",
                       finer * width, finer * height, point_per_px * finer * font_size, finer, finer, finer);
}

std::string frame(Window const& window, Words const& words)
{
    double const step = tic_step(window.right - window.left);
    Panel const panel{.bottom = window.height() - bottom_margin};
    return axes(panel, window.height()) +
           fmt::format(
               "set xrange [{:.6f}:{:.6f}]\nset yrange [{:.6f}:{:.6f}]\n"
               "set format '%.{}f'\nset xtics {:g}\nset ytics {:g}\n"
               "set xlabel {} noenhanced\n"
               "set ylabel {} noenhanced\n",
               window.left, window.right, window.low, window.high, decimals_of(step),
               step, step, gnuplot_quoted(words.across), gnuplot_quoted(words.up)) +
           title(window.height(), words);
}

}  // namespace hdconj::picture
