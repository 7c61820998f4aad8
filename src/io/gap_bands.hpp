// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Gaps as colours: interference, contact, and bands at multiples of the contact gap; private to src/io.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace hdconj {

/// Bands at 0, 1, 2, 5 ... 100 times the contact gap.
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
    /// 0xrrggbb.
    [[nodiscard]] static int colour(std::size_t band);
    [[nodiscard]] static std::size_t count();

    /// Legend in gnuplot's words, @p top [px] below the upper edge of a picture of that height.
    [[nodiscard]] std::string legend(double top, double height) const;

  private:
    double contact_gap_;
    std::vector<double> ends_;
};

/// Rectangles of one colour, as a data block and its plot command.
class ColouredCells
{
  public:
    void add(double left, double right, double low, double high, std::size_t band);
    /// "$name << END ..."
    [[nodiscard]] std::string block(std::string const& name) const;
    /// What stands after "plot".
    [[nodiscard]] static std::string command(std::string const& name);

  private:
    std::string rows_;
};

}  // namespace hdconj
