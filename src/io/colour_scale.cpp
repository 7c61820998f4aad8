// SPDX-License-Identifier: GPL-3.0-or-later
#include "colour_scale.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "picture_frame.hpp"
#include "picture_lines.hpp"

namespace hdconj {
namespace {

// Lightness falls evenly, so that grey print keeps the order.
constexpr std::array anchors = {0xfff0b3, 0xfdcb6e, 0xf99b4f, 0xe8643f, 0xc0364f, 0x861f5c, 0x4a1152, 0x1d0a33};
constexpr int nothing_colour = 0xe4e4e4;

int mixed(int a, int b, double share)
{
    constexpr int channel = 0xff;
    int colour = 0;
    for (int const shift : {16, 8, 0}) {
        double const value = (1 - share) * (a >> shift & channel) + share * (b >> shift & channel);
        colour |= static_cast<int>(std::lround(value)) << shift;
    }
    return colour;
}

}  // namespace

ColourScale::ColourScale(double largest)
{
    if (largest > 0) {
        step_ = picture::tic_step(largest);
        count_ = std::max<std::size_t>(1, static_cast<std::size_t>(std::ceil(largest / step_)));
    }
}

std::size_t ColourScale::band_of(double value) const
{
    return value > 0 ? std::min(count_, static_cast<std::size_t>(value / step_) + 1) : 0;
}

int ColourScale::colour(std::size_t band) const
{
    if (band == 0) {
        return nothing_colour;
    }
    double const at = count_ > 1 ? static_cast<double>(band - 1) / static_cast<double>(count_ - 1) * (anchors.size() - 1) : 0;
    auto const lower = std::min(static_cast<std::size_t>(at), anchors.size() - 2);
    return mixed(anchors[lower], anchors[lower + 1], at - static_cast<double>(lower));
}

std::string ColourScale::legend(std::string const& what, std::string const& nothing, double top, double height) const
{
    constexpr double block_height = 18, number_below = 16, words_above = 12;  // [px]
    constexpr double from = 250;
    bool const has_nothing = !nothing.empty();
    double const block = (picture::width - picture::right_margin - from) / static_cast<double>(count_ + (has_nothing ? 1 : 0));
    auto const at = [&](double x, double y) { return picture::screen(x, y, height); };
    std::string text = fmt::format("set label {} at {} noenhanced\n", gnuplot_quoted(what), at(picture::left_margin, top + block_height / 2));
    double left = from;
    for (std::size_t band = has_nothing ? 0 : 1; band <= count_; ++band) {
        text += fmt::format("set object rectangle from {} to {} fillcolor rgb '#{:06x}' fillstyle solid noborder front\n", at(left, top + block_height), at(left + block, top),
                            colour(band));
        if (band == 0) {
            text += fmt::format("set label {} at {} center noenhanced\n", gnuplot_quoted(nothing), at(left + block / 2, top - words_above));
        } else {
            text += fmt::format("set label '{:g}' at {} center noenhanced\n", step_ * static_cast<double>(band - 1), at(left, top + block_height + number_below));
        }
        left += block;
    }
    return text + fmt::format("set label '{:g}' at {} center noenhanced\n", step_ * static_cast<double>(count_), at(left, top + block_height + number_below));
}

}  // namespace hdconj
