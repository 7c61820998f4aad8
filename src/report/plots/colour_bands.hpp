// SPDX-License-Identifier: GPL-3.0-or-later
// Quantities as colours, in bands whose lightness changes evenly, so that colour-blind eyes and grey print keep the
// order. Colours are 0xrrggbb.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "plot.hpp"

namespace hdconj::report {

/// Gaps: interference, contact, and bands that end at 2, 5 ... 100 times the contact gap.
class GapBands
{
  public:
    /// @param contact_gap  [mm]
    /// @param rounding     [mm] gaps down to this far below 0 are still contact
    GapBands(double contact_gap, double rounding);

    /// Upper ends of all bands but the last, rising [mm].
    [[nodiscard]] std::vector<double> const& ends() const { return ends_; }
    /// Number of the band that holds @p gap: 0 interference, 1 contact, 2 ... apart.
    [[nodiscard]] std::size_t band_of(double gap) const;
    [[nodiscard]] static int colour(std::size_t band);
    [[nodiscard]] static std::size_t count();
    /// Gives the legend to a template.
    void set_in(PlotData& data) const;

  private:
    double contact_gap_;
    std::vector<double> ends_;
};

/// Bands of one width from 0 to beyond the largest value, from light to dark; 0 itself is a grey of its own.
class ColourScale
{
  public:
    /// @param largest  value that is drawn; 0 or less: one band
    explicit ColourScale(double largest);

    [[nodiscard]] std::size_t count() const { return count_; }
    /// 0 ... count(): 0 for nothing.
    [[nodiscard]] std::size_t band_of(double value) const;
    [[nodiscard]] int colour(std::size_t band) const;
    /// Gives the legend to a template. @param nothing  words for 0; empty: its colour is left out
    void set_in(PlotData& data, std::string const& quantity, std::string const& nothing) const;

  private:
    double step_ = 1;
    std::size_t count_ = 1;
};

}  // namespace hdconj::report
