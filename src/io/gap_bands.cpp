// SPDX-License-Identifier: GPL-3.0-or-later
#include "gap_bands.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "picture_frame.hpp"
#include "summary_figures.hpp"

namespace hdconj {
namespace {

constexpr std::array multiples = {1, 2, 5, 10, 20, 50, 100};

// Interference and contact stand out of a scale whose lightness rises evenly, so that colour-blind eyes and grey print keep the order.
constexpr std::array colours = {0xd7191c, 0xffb000, 0x2e1e3b, 0x413d7b, 0x37659e, 0x348fa7, 0x40b7ad, 0x8bdab2, 0xdef5e5};
static_assert(colours.size() == multiples.size() + 2);

}  // namespace

GapBands::GapBands(double contact_gap, double rounding) : contact_gap_(contact_gap), ends_{-rounding}
{
    for (int const multiple : multiples) {
        ends_.push_back(multiple * contact_gap);
    }
}

std::size_t GapBands::band_of(double gap) const
{
    return static_cast<std::size_t>(std::lower_bound(ends_.begin(), ends_.end(), gap) - ends_.begin());
}

int GapBands::colour(std::size_t band)
{
    return colours.at(band);
}

std::size_t GapBands::count()
{
    return colours.size();
}

std::string GapBands::legend(double top, double height) const
{
    constexpr double block_height = 18, words_above = 12, number_below = 16;  // [px]
    constexpr double from = 250;
    double const block = (picture::width - picture::right_margin - from) / static_cast<double>(count());
    auto const at = [&](double x, double y) { return picture::screen(x, y, height); };
    std::string text =
        fmt::format("set label 'gap [µm]' at {} noenhanced\n", at(picture::left_margin, top + block_height / 2));
    for (std::size_t i = 0; i < count(); ++i) {
        double const left = from + block * static_cast<double>(i);
        text += fmt::format("set object rectangle from {} to {} fillcolor rgb '#{:06x}' fillstyle solid noborder front\n",
                            at(left, top + block_height), at(left + block, top), colour(i));
        if (i > 0) {
            double const end = i == 1 ? 0 : multiples[i - 2] * contact_gap_ * um_per_mm;
            text += fmt::format("set label '{:g}' at {} center noenhanced\n", end,
                                at(left, top + block_height + number_below));
        }
    }
    text += fmt::format("set label 'interference' at {} right noenhanced\nset label 'contact' at {} center noenhanced\n",
                        at(from + 0.95 * block, top - words_above), at(from + 1.5 * block, top - words_above));
    return text;
}

void ColouredCells::add(double left, double right, double low, double high, std::size_t band)
{
    fmt::format_to(std::back_inserter(rows_), "{:.6g} {:.6g} {:.6g} {:.6g} {:.6g} {:.6g} {}\n", (left + right) / 2,
                   (low + high) / 2, left, right, low, high, GapBands::colour(band));
}

std::string ColouredCells::block(std::string const& name) const
{
    return fmt::format("${} << END\n{}END\n", name, rows_);
}

std::string ColouredCells::command(std::string const& name)
{
    // The border closes the seam that two neighbours' smoothed edges leave.
    return fmt::format("${} using 1:2:3:4:5:6:7 with boxxyerror linecolor rgb variable linewidth 0.6 fillstyle solid 1 "
                       "border notitle",
                       name);
}

}  // namespace hdconj
