// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// What a round wire leaves, made with Clipper from the moves alone, against the solved outline: a way that knows no
/// offset of the outline.
#include <algorithm>
#include <cmath>
#include <iostream>
#include <numbers>
#include <polyclipping/clipper.hpp>

#include "hdconj/read_scene.hpp"
#include "hdconj/solve.hpp"
#include "hdconj/wedm.hpp"
#include "support/catch.hpp"
#include "wedm/faces.hpp"

namespace hdconj::test::wire_sweep_cases {

using ClipperLib::cInt;

namespace {

constexpr double per_mm = 1e8;  // Clipper counts in whole numbers

ClipperLib::IntPoint integer_point(Vec2 const& p)
{
    return {static_cast<cInt>(std::llround(p.x() * per_mm)), static_cast<cInt>(std::llround(p.y() * per_mm))};
}

Vec2 in_mm(ClipperLib::IntPoint const& q)
{
    return {static_cast<double>(q.X) / per_mm, static_cast<double>(q.Y) / per_mm};
}

/// The region within @p reach of the path of a pass in one face; of an open one with the straight ways in and out.
ClipperLib::Paths swept(WirePass const& pass, bool upper, double reach, bool closed)
{
    ClipperLib::Path path;
    for (WireMove const& move : pass.moves)
        if (!closed || move.tag == WireTag::contour || move.tag == WireTag::stop)
            path.push_back(integer_point(upper ? move.upper : move.lower));
    ClipperLib::ClipperOffset offset(2.0, 1e-5 * per_mm);
    offset.AddPath(path, ClipperLib::jtRound, closed ? ClipperLib::etClosedLine : ClipperLib::etOpenRound);
    ClipperLib::Paths region;
    offset.Execute(region, reach * per_mm);
    return region;
}

double distance(Vec2 const& p, std::vector<Vec2> const& line)
{
    double best = 1e300;
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        Vec2 const& a = line[i];
        Vec2 const along = line[i + 1] - a;
        if ((a - p).norm() - along.norm() > best)
            continue;
        double const share = std::clamp((p - a).dot(along) / along.squaredNorm(), 0.0, 1.0);
        best = std::min(best, (p - a - share * along).norm());
    }
    return best;
}

/// Points of @p part in the pitch of space @p space and halves of its neighbours, in one run.
std::vector<Vec2> wall_near(ClipperLib::Path const& part, int space, int teeth)
{
    std::vector<Vec2> wall;
    double const pitch = 2 * std::numbers::pi / teeth;
    auto const is_near = [&](ClipperLib::IntPoint const& q) {
        Vec2 const p = in_mm(q);
        return std::abs(std::remainder(std::atan2(p.x(), p.y()) - space * pitch, 2 * std::numbers::pi)) < pitch;
    };
    // a list that began in the middle of the run would join its ends by a chord past the root
    auto const far = static_cast<std::size_t>(std::find_if_not(part.begin(), part.end(), is_near) - part.begin());
    for (std::size_t i = 0; i < part.size(); ++i)
        if (auto const& q = part[(far + i) % part.size()]; is_near(q))
            wall.push_back(in_mm(q));
    return wall;
}

/// What a cut is off the face of one tooth space.
struct Off
{
    double too_deep = 0;
    double left = 0;          ///< where no residual was told
    double in_residuals = 0;  ///< left where one was
};

/// @param void_inside  whether @p part is the boundary of a hole
Off off(ClipperLib::Path const& part, std::vector<Vec2> const& face, std::vector<Residual> const& residuals,
        double near, bool upper, int space, int teeth, bool void_inside)
{
    Off worst;
    std::vector<Vec2> const wall = wall_near(part, space, teeth);
    for (Vec2 const& p : face) {
        bool const inside = ClipperLib::PointInPolygon(integer_point(p), part) != 0;
        bool const solid = inside != void_inside;
        double const away = distance(p, wall);
        bool const told = std::any_of(residuals.begin(), residuals.end(), [&](Residual const& r) {
            return r.tooth == space && r.upper == upper && (r.where - p).norm() < near;
        });
        double& worst_here = !solid ? worst.too_deep : told ? worst.in_residuals : worst.left;
        worst_here = std::max(worst_here, away);
    }
    return worst;
}

void say_and_check(std::string const& what, Off const& worst, WireProgram const& program)
{
    INFO(what);
    std::cout << what << ": " << worst.too_deep << " mm too deep, " << worst.left << " mm left, in residuals "
              << worst.in_residuals << " mm of " << program.figures.residual << " told\n";
    CHECK(worst.too_deep <= program.tolerance);
    CHECK(worst.left <= program.tolerance);
    CHECK(worst.in_residuals == Approx(program.figures.residual).margin(program.tolerance));
}

}  // namespace

TEST_CASE("wire sweep: a round wire on the path leaves the outline in both faces but for the residuals", "[wedm]")
{
    for (auto const& sets : {std::vector<std::string>{"tilt.angle_deg=0.2"},
                             {"tilt.angle_deg=0.2", "wedm.wire_diameter=0.2"},
                             {"tilt.angle_deg=0.2", "circular_spline.root_clearance=0.02", "wedm.residual_limit=1"},
                             {"tilt.angle_deg=0.2", "circular_spline.root_clearance=0.1", "wedm.residual_limit=1"},
                             {"wedm.wire_diameter=0.33", "wedm.residual_limit=1"}}) {
        Scene const scene = builtin_scene(sets);
        Solution const solution = solve(wire_scene(scene));
        CircularSplineOutline const& outline = solution.circular_spline;
        WireProgram const program = wire_program(scene, solution);
        WirePass const& pass = program.passes.back();
        for (bool const upper : {false, true}) {
            ClipperLib::Paths const region = swept(pass, upper, pass.offset, true);
            // the outer side of the cut ring is the part; it is the larger one
            auto const part = std::max_element(region.begin(), region.end(), [](auto const& a, auto const& b) {
                return std::abs(Area(a)) < std::abs(Area(b));
            });
            REQUIRE(part != region.end());
            std::vector<Vec2> const& face = upper ? outline.outline.back() : outline.outline.front();
            Off const worst = off(*part, face, program.residuals, pass.offset, upper, 0, program.teeth, true);
            say_and_check("wire " + std::to_string(program.wire_diameter) + (upper ? " upper face" : " lower face"),
                          worst, program);
            CHECK(worst.in_residuals > program.tolerance);
        }
    }
}

TEST_CASE("wire sweep: where the teeth are said to stay clear of a residual, all that they reach is cut", "[wedm]")
{
    // contour without root clearance: where the flexspline's teeth come
    for (auto const& [clearance, clear] : {std::pair("0.002", false), {"0.02", true}, {"0.1", true}}) {
        std::vector<std::string> sets = {"tilt.angle_deg=0.2"};
        CircularSplineOutline const reached = solve(wire_scene(builtin_scene(sets))).circular_spline;
        sets.push_back(std::string("circular_spline.root_clearance=") + clearance);
        sets.emplace_back("wedm.residual_limit=1");
        WireProgram const program = wire_program(builtin_scene(sets));
        WirePass const& pass = program.passes.back();
        double left = 0;
        for (bool const upper : {false, true}) {
            ClipperLib::Paths const region = swept(pass, upper, pass.offset, true);
            auto const part = std::max_element(region.begin(), region.end(), [](auto const& a, auto const& b) {
                return std::abs(Area(a)) < std::abs(Area(b));
            });
            REQUIRE(part != region.end());
            left = std::max(left, off(*part, upper ? reached.outline.back() : reached.outline.front(), {}, pass.offset,
                                      upper, 0, program.teeth, true)
                                      .left);
        }
        sets.back() = "wedm.residual_limit=0.003";
        CHECK_THROWS_WITH(wire_program(builtin_scene(sets)),
                          ContainsSubstring("residual_limit = ") &&
                              (clear ? ContainsSubstring("from what is left") : ContainsSubstring("")));
        INFO("root clearance " << clearance << ": " << left << " mm left");
        CHECK((left <= program.tolerance) == clear);
    }
}

TEST_CASE("wire sweep: two set-ups cut every tooth space of the flexspline once and leave its outline", "[wedm]")
{
    for (auto const& sets : {std::vector<std::string>{"wedm.part=flexspline", "wedm.overlap=0.1"},
                             {"wedm.part=flexspline", "drive.flexspline_teeth=201", "drive.circular_spline_teeth=203",
                              "!circular_spline.inner_radius", "wedm.start=50", "wedm.passes=[[0.02], [0]]"}}) {
        Scene const scene = builtin_scene(sets);
        WireSetUps set_ups = wire_set_ups(scene);
        REQUIRE(set_ups.size() == 2);
        REQUIRE(set_ups[1].set_up.turned);
        set_ups[1] = turned_half(set_ups[1]);  // back into the frame of the part
        int const teeth = scene.drive.flexspline_teeth;
        std::vector<int> times(static_cast<std::size_t>(teeth), 0);
        ClipperLib::Clipper cutter;
        for (WireProgram const& program : set_ups) {
            std::vector<char> seen(times.size(), 0);
            double overlap = 0;
            WirePass const& pass = program.passes.back();
            for (std::size_t i = 1; i < pass.moves.size(); ++i) {
                WireMove const& move = pass.moves[i];
                if (move.tag == WireTag::contour || move.tag == WireTag::stop)
                    seen.at(static_cast<std::size_t>(move.tooth)) = 1;
                overlap += move.tag == WireTag::overlap ? (move.lower - pass.moves[i - 1].lower).norm() : 0;
            }
            for (std::size_t k = 0; k < times.size(); ++k)
                times[k] += seen[k];
            CHECK(overlap == Approx(scene.wedm->overlap).margin(1e-12));
            cutter.AddPaths(swept(pass, false, pass.offset, false), ClipperLib::ptClip, true);
        }
        CHECK(std::all_of(times.begin(), times.end(), [](int n) { return n == 1; }));
        // a blank 1 mm larger all around, as the thesis has it
        wedm::WireFaces const faces = wedm::flexspline_faces(scene);
        double const blank = set_ups[0].figures.lower.outer + 1;
        ClipperLib::Path disc;
        for (int k = 0; k < 360; ++k)
            disc.push_back(integer_point(blank * direction(2 * std::numbers::pi * k / 360)));
        cutter.AddPath(disc, ClipperLib::ptSubject, true);
        ClipperLib::Paths left;
        cutter.Execute(ClipperLib::ctDifference, left, ClipperLib::pftNonZero, ClipperLib::pftNonZero);
        // the gear, and two strips that fall off
        CHECK(left.size() == 3);
        auto const part = std::find_if(left.begin(), left.end(), [](auto const& each) {
            return ClipperLib::PointInPolygon({0, 0}, each) != 0;
        });
        REQUIRE(part != left.end());
        WireProgram const& first = set_ups[0];
        for (int const from_start : {0, 1, teeth / 4, teeth / 2 - 1, teeth / 2, teeth / 2 + 1, teeth - 1}) {
            int const space = faces.space_in_order(first.set_up.first, from_start);
            std::vector<Residual> residuals = set_ups[0].residuals;
            residuals.insert(residuals.end(), set_ups[1].residuals.begin(), set_ups[1].residuals.end());
            Off const worst = off(*part, wedm::turned_to(faces.pitch.lower, space, teeth), residuals,
                                  first.passes.back().offset, false, space, teeth, false);
            say_and_check(std::to_string(teeth) + " teeth, space " + std::to_string(space), worst, first);
        }
    }
}

}  // namespace hdconj::test::wire_sweep_cases
