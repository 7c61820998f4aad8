// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// What a round wire leaves, made with Clipper from the moves alone, against the solved outline: a way that knows no offset of the outline.
#include <algorithm>
#include <cmath>
#include <iostream>
#include <numbers>
#include <polyclipping/clipper.hpp>

#include "hdconj/io/scene_toml.hpp"
#include "hdconj/pipeline/wedm.hpp"
#include "support/catch.hpp"

using namespace hdconj;
using ClipperLib::cInt;

namespace {

constexpr double per_mm = 1e8;  // Clipper counts in whole numbers

ClipperLib::IntPoint counted(Vec2 const& p)
{
    return {static_cast<cInt>(std::llround(p.x() * per_mm)), static_cast<cInt>(std::llround(p.y() * per_mm))};
}

/// The region within @p reach of the closed path of a pass in one face.
ClipperLib::Paths swept(WirePass const& pass, bool upper, double reach)
{
    ClipperLib::Path path;
    for (WireMove const& move : pass.moves)
        if (move.tag == WireTag::contour || move.tag == WireTag::stop)
            path.push_back(counted(upper ? move.upper : move.lower));
    ClipperLib::ClipperOffset offset(2.0, 1e-5 * per_mm);
    offset.AddPath(path, ClipperLib::jtRound, ClipperLib::etClosedLine);
    ClipperLib::Paths region;
    offset.Execute(region, reach * per_mm);
    return region;
}

double distance(Vec2 const& p, std::vector<Vec2> const& closed)
{
    double best = 1e300;
    for (std::size_t i = 0; i < closed.size(); ++i)
    {
        Vec2 const& a = closed[i];
        Vec2 const along = closed[i + 1 == closed.size() ? 0 : i + 1] - a;
        if ((a - p).norm() - along.norm() > best)
            continue;
        double const share = std::clamp((p - a).dot(along) / along.squaredNorm(), 0.0, 1.0);
        best = std::min(best, (p - a - share * along).norm());
    }
    return best;
}

}  // namespace

TEST_CASE("wire sweep: a round wire on the path leaves the outline in both faces but for the residuals", "[wedm]")
{
    for (auto const& sets : {std::vector<std::string>{"tilt.angle_deg=0.2"}, {"tilt.angle_deg=0.2", "wedm.wire_diameter=0.2"}})
    {
        Scene const scene = builtin_scene(sets);
        CircularSplineOutline const outline = solve(wire_scene(scene)).circular_spline;
        WireProgram const program = wire_program(scene, outline);
        WirePass const& pass = program.passes.back();
        for (bool const upper : {false, true})
        {
            ClipperLib::Paths const region = swept(pass, upper, pass.offset);
            // the outer side of the cut ring is the part
            auto const part = std::max_element(region.begin(), region.end(), [](auto const& a, auto const& b) { return std::abs(Area(a)) < std::abs(Area(b)); });
            REQUIRE(part != region.end());
            std::vector<Vec2> wall;
            double const pitch = 2 * std::numbers::pi / program.teeth;
            std::vector<Vec2> const& face = upper ? outline.outline.back() : outline.outline.front();
            for (auto const& q : *part)
            {
                Vec2 const p(static_cast<double>(q.X) / per_mm, static_cast<double>(q.Y) / per_mm);
                if (std::abs(std::atan2(p.x(), p.y())) < pitch)
                    wall.push_back(p);
            }
            // every point of the cut lies on the outline, or stands off it no more than the residual told
            double too_deep = 0;
            double left = 0;
            double in_root = 0;
            for (Vec2 const& p : face)
            {
                bool const cut = ClipperLib::PointInPolygon(counted(p), *part) != 0;
                double const away = distance(p, wall);
                double& worst = cut ? too_deep : left;
                bool const residual = std::any_of(program.residuals.begin(), program.residuals.end(), [&](Residual const& r) {
                    return r.tooth == 0 && r.upper == upper && (r.where - p).norm() < pass.offset;
                });
                (!cut && residual ? in_root : worst) = std::max(!cut && residual ? in_root : worst, away);
            }
            std::cout << "wire " << program.wire_diameter << (upper ? " upper" : " lower") << " face: " << too_deep << " mm too deep, " << left << " mm left, in residuals "
                      << in_root << " mm of " << program.figures.residual << " told\n";
            CHECK(too_deep <= program.tolerance);
            CHECK(left <= program.tolerance);
            CHECK(in_root > program.tolerance);
            CHECK(in_root <= program.figures.residual);  // the shortest way is no longer than that along the normal
        }
    }
}
