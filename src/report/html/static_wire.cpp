// SPDX-License-Identifier: GPL-3.0-or-later
#include "static_wire.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <vector>

#include "hdconj/base/vec2.hpp"
#include "static_axes.hpp"

namespace hdconj::report {
namespace static_path {  // many sources are one translation unit
namespace {

constexpr double half_width = 520.0 / 2, half_height = 300.0 / 2;  // of the picture

/// What the picture shows: a place in its middle and the size of half its height [mm].
struct Window
{
    Vec2 middle;
    double half;

    [[nodiscard]] Vec2 on_page(Vec2 const& point) const
    {
        double const scale = half_height / half;
        return {half_width + scale * (point.x() - middle.x()), half_height - scale * (point.y() - middle.y())};
    }
    /// With a margin, so that lines go on to the border.
    [[nodiscard]] bool shows(Vec2 const& point) const
    {
        Vec2 const at = on_page(point);
        return std::abs(at.x() - half_width) < 1.5 * half_width && std::abs(at.y() - half_height) < 1.5 * half_height;
    }
};

std::vector<Vec2> points_of(Json const& group, char const* name)
{
    std::vector<double> const flat = column_of(group, name);
    std::vector<Vec2> points;
    for (std::size_t i = 0; i + 1 < flat.size(); i += 2)
        points.emplace_back(flat[i], flat[i + 1]);
    return points;
}

std::string path_of(std::vector<Vec2> const& points, Window const& window)
{
    std::string path;
    bool drawn = false;
    for (Vec2 const& point : points) {
        bool const seen = window.shows(point);
        Vec2 const at = window.on_page(point);
        if (seen)
            fmt::format_to(std::back_inserter(path), "{}{:.1f} {:.1f}", drawn ? 'L' : 'M', at.x(), at.y());
        drawn = seen;
    }
    return path;
}

}  // namespace
}  // namespace static_path

std::string static_wire_path(Json const& wedm)
{
    using namespace static_path;
    std::vector<Json> const set_ups = groups_of(wedm, "set_up_");
    if (set_ups.empty())
        return "";
    std::vector<Vec2> contour = points_of(set_ups.front(), "lower");
    if (contour.empty())
        return "";
    contour.push_back(contour.front());
    auto const by_radius = [](Vec2 const& a, Vec2 const& b) { return a.norm() < b.norm(); };
    auto const [inner, outer] = std::minmax_element(contour.begin(), contour.end(), by_radius);
    double const depth = outer->norm() - inner->norm();
    // one tooth space: about the point of the root that lies highest
    auto const root =
        std::max_element(contour.begin(), contour.end(), [](Vec2 const& a, Vec2 const& b) { return a.y() < b.y(); });
    Window const window{*root * (1 - depth / 2 / root->norm()), 1.2 * depth};
    std::string drawing = fmt::format("<path class=\"line\" d=\"{}\"/>", path_of(contour, window));
    std::string key = "<span class=\"key\">contour of the part</span>";
    std::vector<Json> const passes = groups_of(set_ups.front(), "pass_");
    for (std::size_t i = 0; i < passes.size(); ++i) {
        constexpr std::size_t styles = 4;
        drawing += fmt::format("<path class=\"line s{}\" d=\"{}\"/>", i % styles,
                               path_of(points_of(passes[i], "lower"), window));
        key += fmt::format("<span class=\"key s{}\">pass {}</span>", i % styles, i + 1);
    }
    return static_figure("Wire path at one tooth space, lower face", drawing, key);
}

}  // namespace hdconj::report
