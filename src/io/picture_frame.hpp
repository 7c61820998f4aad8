// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// What is around the drawing: size, scale, axes, title; private to src/io.
#pragma once

#include <cmath>
#include <string>

#include "hdconj/scene/scene.hpp"
#include "picture_script.hpp"

namespace hdconj::picture {

// Layout [px]. Margins are fixed, so that the scale is known and the same in x and y.
inline constexpr double width = 1000;
inline constexpr double left_margin = 95;
inline constexpr double right_margin = 30;
inline constexpr double top_margin = 66;
inline constexpr double bottom_margin = 184;
inline constexpr double font_size = 15;

/// What is seen, in the circular-spline frame [mm].
struct Window
{
    double left = 0, right = 0, low = 0, high = 0;

    /// [px/mm]
    [[nodiscard]] double scale() const { return (width - left_margin - right_margin) / (right - left); }
    /// Height of the whole picture [px].
    [[nodiscard]] double height() const { return std::round((high - low) * scale() + top_margin + bottom_margin); }
    /// Place on the picture, [px] from its left and upper edges, in gnuplot's words.
    [[nodiscard]] std::string screen(double x, double y) const;
};

[[nodiscard]] std::string terminal(PictureFormat format, Window const& window);

/// Axes of equal scale and the title.
/// @param w0  largest radial deformation [mm], for the title
[[nodiscard]] std::string frame(Window const& window, Drive const& drive, double w0);

/// Distance of the tics [mm]: 1, 2 or 5 times a power of ten, about eight across @p range.
[[nodiscard]] double tic_step(double range);

}  // namespace hdconj::picture
