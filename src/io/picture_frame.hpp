// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// What is around the drawing: size, scale, axes, title; private to src/io.
#pragma once

#include <cmath>
#include <string>

#include "picture_script.hpp"

namespace hdconj::picture {

// Layout [px]. Margins are fixed, so that the scale is known and the same in x and y.
inline constexpr double width = 1000;
inline constexpr double left_margin = 95;
inline constexpr double right_margin = 30;
inline constexpr double top_margin = 66;
inline constexpr double bottom_margin = 184;
inline constexpr double font_size = 15;

/// What is seen, in the frame of the outline that is solved for [mm].
struct Window
{
    double left = 0, right = 0, low = 0, high = 0;

    /// [px/mm]
    [[nodiscard]] double scale() const { return (width - left_margin - right_margin) / (right - left); }
    /// Height of the whole picture [px].
    [[nodiscard]] double height() const { return std::round((high - low) * scale() + top_margin + bottom_margin); }
    /// See @ref picture::screen.
    [[nodiscard]] std::string screen(double x, double y) const;
};

/// Place on a picture of that height, [px] from its left and upper edges, in gnuplot's words.
[[nodiscard]] std::string screen(double x, double y, double height);

/// @param height  of the whole picture [px]
[[nodiscard]] std::string terminal(PictureFormat format, double height);

/// Words around the drawing.
struct Words
{
    std::string heading;
    std::string subject;
    std::string across;  ///< of the x axis
    std::string up;      ///< of the y axis
};

/// Heading and subject at the top of a picture of that height [px].
[[nodiscard]] std::string title(double height, Words const& words);

/// Axes of equal scale and the title.
[[nodiscard]] std::string frame(Window const& window, Words const& words);

/// Edges of a set of axes [px], from the left and upper edges of the picture.
struct Panel
{
    double left = left_margin, right = width - right_margin, top = top_margin, bottom = 0;
};

/// Places the next plot of a picture of that height [px], with the look that all have.
[[nodiscard]] std::string axes(Panel const& panel, double height);

/// Distance of the tics: 1, 2 or 5 times a power of ten, about eight across @p range.
[[nodiscard]] double tic_step(double range);

}  // namespace hdconj::picture
