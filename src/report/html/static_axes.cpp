// SPDX-License-Identifier: GPL-3.0-or-later
#include "static_axes.hpp"

#include <fmt/format.h>

#include <cmath>
#include <iterator>

namespace hdconj::report {
namespace static_frame {  // many sources are one translation unit
namespace {

constexpr double width = 520, height = 300, left = 64, right = 12, top = 12, bottom = 44;

}  // namespace
}  // namespace static_frame

std::vector<double> Axis::ticks() const
{
    constexpr int about = 6;
    double const raw = (high - low) / about, power = std::pow(10, std::floor(std::log10(raw)));
    double step = 10 * power;
    for (double const digit : {5.0, 2.0, 1.0})
        if (digit * power >= raw)
            step = digit * power;
    std::vector<double> all;
    for (double i = std::ceil(low / step - 1e-9); i * step <= high + 1e-9 * step; ++i)
        all.push_back(i * step + 0.0);  // no -0
    return all;
}

Axis horizontal_axis(double low, double high)
{
    return {low, high > low ? high : low + 1, static_frame::left, static_frame::width - static_frame::right};
}

Axis vertical_axis(double low, double high)
{
    return {low, high > low ? high : low + 1, static_frame::height - static_frame::bottom, static_frame::top};
}

std::string axes_svg(Axis const& x, Axis const& y, std::string_view x_label, std::string_view y_label)
{
    using namespace static_frame;
    std::string svg = "<g class=\"axes\">";
    auto out = std::back_inserter(svg);
    for (double const value : x.ticks())
        fmt::format_to(out,
                       "<line x1=\"{0:.1f}\" x2=\"{0:.1f}\" y1=\"{1}\" y2=\"{2}\"/><text x=\"{0:.1f}\" y=\"{3}\" "
                       "text-anchor=\"middle\">{4:.6g}</text>",
                       x(value), top, height - bottom, height - bottom + 16, value);
    for (double const value : y.ticks())
        fmt::format_to(out,
                       "<line x1=\"{1}\" x2=\"{2}\" y1=\"{0:.1f}\" y2=\"{0:.1f}\"/><text x=\"{3}\" y=\"{4:.1f}\" "
                       "text-anchor=\"end\">{5:.6g}</text>",
                       y(value), left, width - right, left - 6, y(value) + 4, value);
    double const middle_x = (left + width - right) / 2, middle_y = (top + height - bottom) / 2;
    fmt::format_to(out,
                   "<text x=\"{}\" y=\"{}\" text-anchor=\"middle\">{}</text><text x=\"14\" y=\"{}\" "
                   "text-anchor=\"middle\" transform=\"rotate(-90 14 {})\">{}</text></g>",
                   middle_x, height - 6, x_label, middle_y, middle_y, y_label);
    return svg;
}

std::string static_figure(std::string_view title, std::string_view drawing, std::string_view key)
{
    return fmt::format(
        "<figure><figcaption>{0}</figcaption><svg class=\"chart\" xmlns=\"http://www.w3.org/2000/svg\" role=\"img\" "
        "viewBox=\"0 0 {1} {2}\"><title>{0}</title>{3}</svg><div class=\"names\">{4}</div></figure>",
        title, static_frame::width, static_frame::height, drawing, key);
}

}  // namespace hdconj::report
