// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The touch law of the reverse problem as a check, and the scene of data/scenes that most of its laws are tried on.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "check_touch.hpp"
#include "random_reverse_designs.hpp"
#include "support/oracle/reverse_touch.hpp"
#include "support/oracle/run.hpp"

namespace oracle {

inline constexpr std::size_t all_points = static_cast<std::size_t>(-1);

inline hdconj::Scene given_scene(std::vector<std::string> const& overrides = {})
{
    return hdconj::read_scene(std::string(HDCONJ_SOURCE_DIR) + "/data/scenes/circular-spline-given.toml", overrides);
}

/// Both laws on the flexspline tooth, at most @p most points; the straight walls are looked at in between as well.
inline TouchReport reverse_touch_law(hdconj::Solution const& solution, ReverseTouchScan& scan, std::size_t most)
{
    double const clearance = solution.scene.circular_spline.backlash_offset;
    auto const& outline = solution.flexspline_outline;
    TouchReport report;
    auto const look = [&](Point<double> const& p, std::string const& kind, std::size_t index) {
        double const distance = scan.nearest(p).distance - clearance;
        bool const cut = kind == "flank" || kind == "corner";
        if (cut)
            report.touched.take(std::abs(distance), distance, p, kind, index);
        report.entered.take(distance < 0 ? -distance : 0, distance, p, kind, index);
    };
    for (auto const& piece : solution.flexspline_pieces) {
        std::size_t const count = piece.last - piece.first;
        std::size_t const stride = std::max<std::size_t>(1, count * solution.flexspline_pieces.size() / most);
        for (std::size_t i = piece.first; i <= piece.last;
             i = i < piece.last ? std::min(i + stride, piece.last) : i + 1)
            look(point_of(outline[i]), piece.kind, i);
        if (piece.kind == "root wall" || piece.kind == "land")
            for (double share : {0.01, 0.25, 0.5, 0.75, 0.99})
                look(point_of(outline[piece.first] + share * (outline[piece.last] - outline[piece.first])), "straight",
                     piece.first);
    }
    return report;
}

inline void check_every_point(hdconj::Solution const& solution)
{
    ReverseTouchScan scan(solution.scene);
    auto const report = reverse_touch_law(solution, scan, all_points);
    CHECK(report.touched.points > 100);
    check_touched(report);
    CHECK(solution.check->smallest_clearance == Approx(solution.scene.circular_spline.backlash_offset).margin(1e-11));
}

inline hdconj::Solution reversed(hdconj::Scene const& scene)
{
    return hdconj::solve(hdconj::parse_scene(designs::reverse_toml_of(scene), "generated scene"));
}

}  // namespace oracle
