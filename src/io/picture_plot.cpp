// SPDX-License-Identifier: GPL-3.0-or-later
#include "picture_plot.hpp"

#include <fmt/format.h>

#include <iterator>

#include "picture_lines.hpp"

namespace hdconj::picture {

std::string line(char const* colour, double thickness, char const* dash)
{
    return fmt::format("linecolor rgb '{}' linewidth {} dashtype {}", colour, thickness, dash);
}

void Plot::add(Polylines const& lines, std::string const& with, std::string const& look, std::string const& legend)
{
    std::string block;
    for (auto const& each : lines) {
        for (auto const& point : each) {
            fmt::format_to(std::back_inserter(block), "{:.6f} {:.6f}\n", point.x(), point.y());
        }
        block += each.empty() ? "" : "\n";
    }
    if (block.empty()) {
        return;
    }
    ++count_;
    data_ += fmt::format("$data{} << END\n{}END\n", count_, block);
    command_ += fmt::format("{} $data{} using 1:2 with {} {}", command_.empty() ? "plot" : ", \\\n    ", count_,
                            with, look);
    if (!legend.empty()) {
        add_legend(look, legend);
    }
}

/// Drawn here: gnuplot's own legend depends on guesses of text widths, which differ between SVG and PNG.
void Plot::add_legend(std::string const& look, std::string const& text)
{
    constexpr int columns = 2;
    constexpr double below_axis = 92, row_height = 25, sample = 42, gap = 12;  // [px]
    double const column_width = (picture::width - picture::left_margin - picture::right_margin) / columns;
    double const x = picture::left_margin + entries_ % columns * column_width;
    double const y = window_.height() - picture::bottom_margin + below_axis + entries_ / columns * row_height;
    legend_ +=
        fmt::format("set arrow from {} to {} nohead {}\nset label {} at {} noenhanced\n", window_.screen(x, y),
                    window_.screen(x + sample, y), look, gnuplot_quoted(text), window_.screen(x + sample + gap, y));
    ++entries_;
}

}  // namespace hdconj::picture
