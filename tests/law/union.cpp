// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The outline against the union of 8000 tooth positions, or 20 000 with HDCONJ_FULL, made with Clipper: a way to the
/// tooth space that knows no envelope.
#include <iostream>

#include "support/catch.hpp"
#include "support/oracle/chain.hpp"
#include "support/oracle/run.hpp"
#include "support/oracle/sweep.hpp"
#include "support/oracle/touch_law.hpp"
#include "support/run/full_run.hpp"

namespace hdconj::test::union_cases {

using namespace oracle;
using hdconj::Scene;
using hdconj::Solution;

namespace {

struct Apart
{
    double outline = 0;  ///< farthest flank or corner point of the outline from the union
    double swept = 0;    ///< farthest corner of the union from the outline
    std::size_t outline_points = 0, swept_points = 0;
};

Apart apart(Solution const& solution, SweptBoundary const& swept, double tip, double pitch)
{
    Apart result;
    std::vector<Point<double>> chain;
    for (auto const& p : solution.circular_spline.outline.at(0))
        chain.push_back(point_of(p));
    for (auto const& piece : solution.circular_spline.pieces) {
        if (!must_be_touched(piece.kind))
            continue;
        for (std::size_t i = piece.first; i <= piece.last; ++i) {
            double nearest = 1e300;
            for (auto const& loop : swept.loops)
                nearest = std::min(nearest, distance_to_chain(chain[i], loop, true));
            result.outline = std::max(result.outline, nearest);
            ++result.outline_points;
        }
    }
    for (auto const& loop : swept.loops)
        for (auto const& p : loop) {
            if (length(p) < tip || std::abs(std::atan2(p.x, p.y)) > pitch / 2)
                continue;
            result.swept = std::max(result.swept, distance_to_chain(p, chain, false));
            ++result.swept_points;
        }
    return result;
}

}  // namespace

TEST_CASE("union: the outline is the boundary of thousands of united tooth positions", "[union]")
{
    for (Scene const& scene : {type_50(), liu_2025()}) {
        Solution const solution = hdconj::solve(scene);
        double const tip = solution.geometry.circular_spline_inner_radius;
        auto const swept = swept_boundary(solution.scene, tip, full_run() ? 20000 : 8000, 1e-6);
        double const pitch = 2 * pi<double>() / scene.drive.circular_spline_teeth;
        auto const found = apart(solution, swept, tip, pitch);
        std::cout << scene.drive.name << ": outline to union " << found.outline << " mm (" << found.outline_points
                  << " points), union to outline " << found.swept << " mm (" << found.swept_points
                  << " points); stated error of the union " << swept.error << " mm, of the outline "
                  << solution.error.largest() << " mm\n";
        INFO(scene.drive.name);
        double const allowed = swept.error + solution.error.largest();
        CHECK(found.outline_points > 100);
        CHECK(found.swept_points > 1000);
        CHECK(found.outline <= allowed);
        CHECK(found.swept <= allowed);

        // Negative control: 3 um off in the motion is seen.
        Scene other = scene;
        other.solver.kinematics = hdconj::Kinematics::first_order;
        auto const wrong = apart(hdconj::solve(other), swept, tip, pitch);
        CHECK(wrong.outline > 1.2e-6 + allowed);
        CHECK(wrong.swept > 1.2e-6 + allowed);
    }
}

}  // namespace hdconj::test::union_cases
