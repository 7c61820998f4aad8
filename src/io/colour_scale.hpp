// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// A quantity from 0 up as colours; private to src/io.
#pragma once

#include <cstddef>
#include <string>

namespace hdconj {

/// Bands of one width from 0 to beyond the largest value, from light to dark; 0 itself is a grey of its own.
class ColourScale
{
  public:
    /// @param largest  value that is drawn; 0 or less: one band
    explicit ColourScale(double largest);

    [[nodiscard]] std::size_t count() const { return count_; }
    /// 0 ... count(): 0 for nothing.
    [[nodiscard]] std::size_t band_of(double value) const;
    /// 0xrrggbb.
    [[nodiscard]] int colour(std::size_t band) const;

    /// Legend in gnuplot's words, @p top [px] below the upper edge of a picture of that height. @param what  "pressure [MPa]"
    [[nodiscard]] std::string legend(std::string const& what, std::string const& nothing, double top, double height) const;

  private:
    double step_ = 1;
    std::size_t count_ = 1;
};

}  // namespace hdconj
