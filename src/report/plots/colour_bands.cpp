// SPDX-License-Identifier: GPL-3.0-or-later
#include "colour_bands.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "hdconj/units.hpp"

namespace hdconj::report {
namespace {

constexpr std::array gap_multiples = {1, 2, 5, 10, 20, 50, 100};

// Interference and contact stand out of the others.
constexpr std::array gap_colours = {0xd7191c, 0xffb000, 0x2e1e3b, 0x413d7b, 0x37659e,
                                    0x348fa7, 0x40b7ad, 0x8bdab2, 0xdef5e5};
static_assert(gap_colours.size() == gap_multiples.size() + 2);

constexpr std::array scale_colours = {0xfff0b3, 0xfdcb6e, 0xf99b4f, 0xe8643f, 0xc0364f, 0x861f5c, 0x4a1152, 0x1d0a33};
constexpr int nothing_colour = 0xe4e4e4;

// Words end a little before their band does.
constexpr double words_end = 0.95;

int mixed_colour(int a, int b, double share)
{
    constexpr int channel = 0xff;
    int colour = 0;
    for (int const shift : {16, 8, 0}) {
        double const value = (1 - share) * (a >> shift & channel) + share * (b >> shift & channel);
        colour |= static_cast<int>(std::lround(value)) << shift;
    }
    return colour;
}

void set_legend(PlotData& data, std::string const& quantity, PlotColumns const& bands, PlotColumns const& ends,
                PlotColumns const& words)
{
    data.set("quantity", quantity);
    data.set("bands", bands);
    data.set("band_ends", ends);
    data.set("band_words", words);
}

/// 1, 2 or 5 times a power of ten, about an eighth of @p range.
double tic_step(double range)
{
    constexpr double wanted = 8;
    double const power = std::pow(10.0, std::floor(std::log10(range / wanted)));
    double const rest = range / wanted / power;
    return power * (rest < 1.5 ? 1 : rest < 3.5 ? 2 : rest < 7.5 ? 5 : 10);
}

}  // namespace

GapBands::GapBands(double contact_gap, double rounding) : contact_gap_(contact_gap), ends_{-rounding}
{
    for (int const multiple : gap_multiples)
        ends_.push_back(multiple * contact_gap);
}

std::size_t GapBands::band_of(double gap) const
{
    return static_cast<std::size_t>(std::lower_bound(ends_.begin(), ends_.end(), gap) - ends_.begin());
}

int GapBands::colour(std::size_t band)
{
    return gap_colours.at(band);
}

std::size_t GapBands::count()
{
    return gap_colours.size();
}

void GapBands::set_in(PlotData& data) const
{
    PlotColumns bands, ends, words;
    for (std::size_t i = 0; i < count(); ++i) {
        bands.row(colour(i));
        if (i > 0)
            ends.named_row(fmt::format("{:g}", i == 1 ? 0 : gap_multiples.at(i - 2) * contact_gap_ * per_um), i);
    }
    words.named_row("interference", words_end);
    words.named_row("contact", 1 + words_end);
    set_legend(data, "gap [µm]", bands, ends, words);
}

ColourScale::ColourScale(double largest)
{
    if (largest > 0) {
        step_ = tic_step(largest);
        count_ = std::max<std::size_t>(1, static_cast<std::size_t>(std::ceil(largest / step_)));
    }
}

std::size_t ColourScale::band_of(double value) const
{
    return value > 0 ? std::min(count_, static_cast<std::size_t>(value / step_) + 1) : 0;
}

int ColourScale::colour(std::size_t band) const
{
    if (band == 0)
        return nothing_colour;
    double const at =
        count_ > 1 ? static_cast<double>(band - 1) / static_cast<double>(count_ - 1) * (scale_colours.size() - 1) : 0;
    auto const lower = std::min(static_cast<std::size_t>(at), scale_colours.size() - 2);
    return mixed_colour(scale_colours[lower], scale_colours[lower + 1], at - static_cast<double>(lower));
}

void ColourScale::set_in(PlotData& data, std::string const& quantity, std::string const& nothing) const
{
    std::size_t const before = nothing.empty() ? 0 : 1;
    PlotColumns bands, ends, words;
    for (std::size_t band = 1 - before; band <= count_; ++band)
        bands.row(colour(band));
    for (std::size_t end = 0; end <= count_; ++end)
        ends.named_row(fmt::format("{:g}", step_ * static_cast<double>(end)), end + before);
    if (!nothing.empty())
        words.named_row(nothing, words_end);
    set_legend(data, quantity, bands, ends, words);
}

}  // namespace hdconj::report
