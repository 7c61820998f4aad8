// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Lines and areas of a drawing, with a legend below its axes; private to src/io.
#pragma once

#include <string>
#include <vector>

#include "hdconj/geometry/vec2.hpp"
#include "picture_frame.hpp"

namespace hdconj::picture {

using Polylines = std::vector<std::vector<Vec2>>;

/// How a line looks, in gnuplot's words.
[[nodiscard]] std::string line(char const* colour, double thickness, char const* dash = "solid");

/// Collects data blocks, the plot command and the legend; leaves out what is empty.
class Plot
{
  public:
    explicit Plot(Window const& window) : window_(window) {}

    /// @param legend  left out where empty; lines only
    void add(Polylines const& lines, std::string const& with, std::string const& look, std::string const& legend);
    void add(Polylines const& lines, std::string const& look, std::string const& legend) { add(lines, "lines", look, legend); }
    [[nodiscard]] std::string text() const { return data_ + legend_ + command_ + '\n'; }

  private:
    void add_legend(std::string const& look, std::string const& text);

    Window window_;
    std::string data_, legend_, command_;
    int count_ = 0, entries_ = 0;
};

}  // namespace hdconj::picture
