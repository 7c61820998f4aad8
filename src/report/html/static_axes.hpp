// SPDX-License-Identifier: GPL-3.0-or-later
// Axes of a picture that needs no script, as web/src/chart.js draws them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace hdconj::report {

/// An axis: values from low to high, on the page from one place to another.
struct Axis
{
    double low, high, from, to;
    [[nodiscard]] double operator()(double value) const { return from + (value - low) / (high - low) * (to - from); }
    /// About six round values.
    [[nodiscard]] std::vector<double> ticks() const;
};

/// Axes of the usual picture; where both values are the same, the axis goes on for 1.
[[nodiscard]] Axis horizontal_axis(double low, double high);
[[nodiscard]] Axis vertical_axis(double low, double high);

/// Their lines, numbers and labels.
[[nodiscard]] std::string axes_svg(Axis const& x, Axis const& y, std::string_view x_label, std::string_view y_label);

/// A figure of the usual size. @param drawing  SVG  @param key  HTML below the picture
[[nodiscard]] std::string static_figure(std::string_view title, std::string_view drawing, std::string_view key);

}  // namespace hdconj::report
