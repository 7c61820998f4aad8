// SPDX-License-Identifier: GPL-3.0-or-later
// What a ring that was solved before has in place of the one that is cut.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "base/text.hpp"
#include "hdconj/units.hpp"
#include "hdconj/wedm.hpp"
#include "wedm/seen_distance.hpp"

namespace hdconj {
namespace {

/// The largest distance of the ends of @p ring from the contour that @p cut cuts, at their heights [mm].
double off_the_cut(CircularSplineOutline const& ring, WireProgram const& cut)
{
    double most = 0;
    auto const measure = [&](std::vector<Vec2> const& points, double z) {
        double const share = 0.5 + z / cut.machine.thickness;
        std::vector<Vec2> line = cut.nominal.lower;
        for (std::size_t i = 0; i < line.size(); ++i)
            line[i] += share * (cut.nominal.upper[i] - line[i]);
        region::SegmentTree const contour(std::move(line), true);
        for (Vec2 const& p : points)
            most = std::max(most, wedm::seen_distance(contour, p));
    };
    measure(ring.outline.front(), ring.z.front());
    measure(ring.outline.back(), ring.z.back());
    return most;
}

}  // namespace

std::string other_ring(CircularSplineOutline const& ring, std::optional<double> side_clearance,
                       std::optional<Coning> const& cone, Scene const& scene, WireProgram const& cut)
{
    double const lower = ring.outline.front().front().norm();  // the tip circle, in the middle of a land
    double const upper = ring.outline.back().front().norm();
    double const own_lower = cut.figures.lower.inner, own_upper = cut.figures.upper.inner;
    double const lean = ring.z.size() > 1 ? std::atan((upper - lower) / (ring.z.back() - ring.z.front())) : 0;
    double const own_lean = std::atan((own_upper - own_lower) / cut.machine.thickness);
    std::vector<std::string> found, keys;
    auto const compare = [&](std::string const& what, double value, double own, std::string const& key) {
        if (std::abs(value - own) <= cut.contour_error)
            return;
        found.push_back(
            fmt::format("{} of {:.6f} in place of {:.6f} mm ({:+.4g} um)", what, value, own, (value - own) * per_um));
        keys.push_back(fmt::format("{} = {:.6f}", key, value));
    };
    if (side_clearance && !scene.circular_spline.automatic_backlash)
        compare("a side clearance", *side_clearance, scene.circular_spline.backlash_offset,
                "circular_spline.backlash_offset");
    compare("a tip circle at z = 0", (lower + upper) / 2, (own_lower + own_upper) / 2, "circular_spline.inner_radius");
    if (std::abs(lean - own_lean) * cut.machine.thickness > cut.contour_error) {
        found.push_back(fmt::format("a tilt of {:.4f} in place of {:.4f} degrees", to_deg(lean), to_deg(own_lean)));
        keys.push_back(fmt::format("tilt.angle_deg = {:.6g}", to_deg(lean)));
    }
    double const off = off_the_cut(ring, cut);
    bool const is_off = off > cut.tolerance;
    if (is_off && cone && !scene.coning) {
        found.emplace_back("the outline of the bent cup");
        keys.push_back(fmt::format("coning.model = \"{}\", coning.bottom_to_middle = {}", to_string(cone->model),
                                   short_number(*cone->bottom_to_middle)));
    }
    if (found.empty() && !is_off)
        return {};
    found.push_back(fmt::format("an outline up to {:.3g} um off the one that is cut", off * per_um));
    return fmt::format("{}{}", fmt::join(found, ", "),
                       keys.empty() || !side_clearance
                           ? ""
                           : fmt::format("; for a ring with these write {} into the scene", fmt::join(keys, ", ")));
}

}  // namespace hdconj
