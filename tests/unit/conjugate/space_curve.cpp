// SPDX-License-Identifier: GPL-3.0-or-later
#include "conjugate/space_curve.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "conjugate/plane/conjugate_solver.hpp"
#include "hdconj/conjugate/crossing.hpp"
#include "hdconj/error.hpp"
#include "hdconj/solve.hpp"
#include "support/catch.hpp"
#include "support/coned_drive.hpp"
#include "support/polyline.hpp"

namespace hdconj::test::space_curve_cases {

namespace {

/// The boundary of a drive's tooth space, with what it is made of.
struct Boundary
{
    explicit Boundary(std::vector<std::string> const& keys = {}) : Boundary(builtin_scene(keys)) {}
    explicit Boundary(Scene const& scene) : drive(scene, 1), clock(out.plan, observer)
    {
        out.scene = drive.scene;
        out.plan = make_plan(out.scene);
        out.geometry = drive.middle.geometry;
        out.threads = 1;
        auto const& slice = drive.maker->motion(0);
        job.emplace(out, *slice.tooth, slice.motion, clock);
        job->find_branches_of_tooth();
        job->find_boundary();
        curve.emplace(job->curve(slice.tooth));
    }
    ConedDrive drive;
    Solution out;
    StageObserver observer;
    drive::StageClock clock;
    std::optional<conjugate::ConjugateSolver> job;
    std::optional<conjugate::ToothSpaceBoundary> curve;
};

std::vector<Vec2> points_of(conjugate::ToothSpaceBoundary const& curve, double chord)
{
    std::vector<Vec2> points;
    for (conjugate::BoundaryPiece const& piece : curve.pieces()) {
        envelope::SampledArc const sampled = curve.sampled(piece, chord);
        for (std::size_t i = points.empty() ? 0 : 1; i < sampled.points.size(); ++i)
            points.push_back(sampled.points[i].p);
    }
    return points;
}

/// Checks that @p points run to the right and lie @p distance from @p base, no nearer, and no further but for mitres.
/// @return the furthest
double check_parallel(std::vector<Vec2> const& base, std::vector<Vec2> const& points, double distance, double chord)
{
    double nearest = std::numeric_limits<double>::infinity(), furthest = 0;
    std::size_t off = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (i > 0)
            CHECK(points[i].x() > points[i - 1].x() - 1e-12);
        // over the land the middle one lies on the tip circle's end, half a pitch away
        double const d = distance_to_polyline(base, points[i]);
        nearest = std::min(nearest, d);
        furthest = std::max(furthest, d);
        off += d > distance + 1.1 * chord;
    }
    CHECK(nearest > distance - 1.1 * chord);
    CHECK(off < points.size() / 5);
    return furthest;
}

}  // namespace

namespace {

/// Checks the boundary @p b moved by @p distance: parallel to where it was, without a gap.
void check_moved(Boundary const& b, std::vector<Vec2> const& base, double distance, double chord)
{
    INFO("distance " << distance);
    conjugate::ToothSpaceBoundary const moved = b.curve->moved_along_normal(distance, b.drive.context->tolerance);
    CHECK(moved.tip_radius() == b.curve->tip_radius() + distance);
    CHECK(moved.offset() == Approx(distance).epsilon(1e-14));
    auto const& pieces = moved.pieces();
    for (std::size_t i = 0; i + 1 < pieces.size(); ++i) {
        // corners are where both pieces end
        CHECK((moved.at(pieces[i], pieces[i].end).p - moved.at(pieces[i + 1], pieces[i + 1].begin).p).norm() < 1e-10);
    }
    double const furthest = check_parallel(base, points_of(moved, chord), std::abs(distance), chord);
    // a mitre of two stretches that turn by less than 90 degrees
    CHECK(furthest < 1.42 * std::abs(distance) + 1.1 * chord);
    for (conjugate::BoundaryPiece const& piece : pieces)
        CHECK(moved.made_by(piece).segment >= -1);
}

}  // namespace

TEST_CASE("boundary moved along its normal is everywhere that far from where it was", "[space_curve]")
{
    Boundary const b;
    constexpr double chord = 1e-8;
    std::vector<Vec2> const base = points_of(*b.curve, chord);
    // into the material, and out of it by less and by more than the sharpest turn of the tip corner's path, which is
    // then swallowed
    for (double const distance : {1e-6, 1e-3, 0.01, 0.03, -1e-6, -1e-4, -5e-4, -1e-3, -1.3e-3, -1.5e-3, -1.7e-3,
                                  -1.8e-3, -1.9e-3, -2e-3, -3e-3, -0.0122, -0.03})
        check_moved(b, base, distance, chord);
}

TEST_CASE("boundary of a cam with knots is moved as far", "[space_curve]")
{
    // A knot cuts the path of the tip's corner, whose two parts are swallowed one after the other. Others lie beside
    // the place where land and flank meet, which a smaller tip circle and the move shift over them.
    for (int i = 0; i < 9; ++i) {
        double const tip = 25.021 + 0.0023 * i;
        INFO("tip circle " << tip);
        Boundary const b(read_scene(file_of("cam-table"), {"circular_spline.inner_radius=" + std::to_string(tip)}));
        constexpr double chord = 1e-6;
        std::vector<Vec2> const base = points_of(*b.curve, chord);
        for (double const distance : {0.0122, 4e-3, 1e-3, -1e-4, -1e-3, -1.06e-3, -1.2e-3, -1.527e-3, -1.8e-3, -2.4e-3,
                                      -3.2e-3, -0.0122, -0.02})
            check_moved(b, base, distance, chord);
    }
}

TEST_CASE("a flank goes on over a joint of its profile where the tip circle moves beyond it", "[space_curve]")
{
    for (char const* const tip : {"30.048", "30.049", "30.0505"}) {
        INFO("tip circle " << tip);
        Boundary const b(
            read_scene(file_of("cycloid"),
                       {"drive.flexspline_teeth=240", "drive.circular_spline_teeth=242", "flexspline.wall=0.84",
                        "wave_generator.family=ellipse", "wave_generator.radial_deformation=0.215",
                        std::string("circular_spline.inner_radius=") + tip}));
        constexpr double chord = 1e-6;
        std::vector<Vec2> const base = points_of(*b.curve, chord);
        for (double const distance : {-0.009163, -0.004581, -1e-3, 1e-3, 0.0046})
            check_moved(b, base, distance, chord);
    }
}

TEST_CASE("a draft is made whatever the tip circle, and its land follows the circle", "[space_curve][draft]")
{
    // At the first drive's tip circles the outline gains a corner beyond the flank, which the draft moves out of the
    // land. At the second's the draft moves the flank by more than the arc that it lies on is long.
    std::vector<std::string> const drafted{"slices.surface=tilted", "slices.count=3", "tilt.kind=draft"};
    auto const first = [](std::vector<std::string> const& keys) { return builtin_scene(keys); };
    auto const second = [](std::vector<std::string> const& keys) {
        return parse_scene(R"([drive]
module = 0.1
flexspline_teeth = 400
circular_spline_teeth = 402
[flexspline]
wall = 0.35
[flexspline.profile]
family = "double-circular-arc"
addendum = 0.085
dedendum = 0.115
convex_radius = 0.11
convex_offset = 0.04
convex_rise = 0.0
concave_radius = 0.2
concave_offset = "tangent"
concave_rise = 0.025
[wave_generator]
family = "ellipse"
radial_deformation = 0.1
[circular_spline]
width = 8.0
)",
                           "a fine drive", {}, keys);
    };
    struct Row
    {
        std::function<Scene(std::vector<std::string> const&)> scene;
        std::string tilt;
        double from, step;
    };
    for (Row const& row :
         {Row{first, "tilt.angle_deg=0.9", 25.047, 5e-4}, Row{first, "tilt.angle_deg=1.9", 25.045, 1e-3},
          Row{second, "tilt.angle_deg=0.6", 20.011, 5e-4}}) {
        std::vector<std::vector<Vec2>> before;
        for (int i = 0; i < 10; ++i) {
            double const tip = row.from + row.step * i;
            INFO(row.tilt << ", tip circle " << tip);
            Solution const made =
                solve(row.scene(with(drafted, {row.tilt, "circular_spline.inner_radius=" + std::to_string(tip)})));
            CircularSplineOutline const& spline = made.circular_spline;
            std::vector<std::vector<Vec2>> corners;
            for (auto const& slice : spline.outline)
                corners.push_back({slice[static_cast<std::size_t>(spline.landmarks.front())],
                                   slice[static_cast<std::size_t>(spline.landmarks.back())]});
            for (std::size_t k = 0; k < before.size(); ++k)
                for (std::size_t side = 0; side < 2; ++side)
                    CHECK((corners[k][side] - before[k][side]).norm() < 4 * row.step);
            before = corners;
        }
    }
}

TEST_CASE("a draft that is too large names the joint that fails and both keys that decide", "[space_curve][draft]")
{
    Boundary const b;
    auto const& pieces = b.curve->pieces();
    Tolerance const& tolerance = b.drive.context->tolerance;
    std::vector<Vec2> joints;
    for (conjugate::BoundaryPiece const& piece : pieces)
        joints.push_back(b.curve->at(piece, piece.end).p);
    try {
        (void)b.curve->moved_along_normal(-0.134, tolerance);
        FAIL("is made");
    } catch (NumericalError const& error) {
        std::string const text = error.what();
        CHECK(std::ranges::any_of(
            joints, [&](Vec2 const& p) { return text.find(conjugate::near_text(p)) != std::string::npos; }));
        CHECK_THAT(text, ContainsSubstring("circular_spline.inner_radius") && ContainsSubstring("tilt.angle_deg"));
    }
}

TEST_CASE("a boundary cut at a wider tip circle is that of the circle", "[space_curve]")
{
    constexpr double chord = 1e-7;
    Boundary const deep(std::vector<std::string>{"circular_spline.inner_radius=25.01"});
    for (char const* const tip : {"25.012", "25.03", "25.0497", "25.06", "25.1"}) {
        INFO("tip circle " << tip);
        Boundary const made(std::vector<std::string>{std::string("circular_spline.inner_radius=") + tip});
        conjugate::ToothSpaceBoundary const cut = deep.curve->cut_at(made.curve->tip_radius());
        REQUIRE(cut.pieces().size() == made.curve->pieces().size());
        CHECK(cut.tip_radius() == made.curve->tip_radius());
        std::vector<Vec2> const expected = points_of(*made.curve, chord);
        for (Vec2 const& p : points_of(cut, chord))
            CHECK(distance_to_polyline(expected, p) < 1.1 * chord);
    }
    CHECK(deep.curve->cut_at(25.005).tip_radius() == 25.01);
}

TEST_CASE("boundary moved by nothing has the same bits", "[space_curve]")
{
    Boundary const b;
    Tolerance const& tolerance = b.drive.context->tolerance;
    CHECK(points_of(b.curve->moved_along_normal(0, tolerance), 1e-6) == points_of(*b.curve, 1e-6));
}

TEST_CASE("a stretch beside the tip circle that vanishes is left out and nothing else changes", "[space_curve]")
{
    constexpr double chord = 1e-7;
    for (std::vector<std::string> const& keys : {std::vector<std::string>{},
                                                 {"circular_spline.inner_radius=25.0215"},
                                                 {"circular_spline.inner_radius=25.03"}}) {
        Boundary const b(keys);
        std::vector<Vec2> const base = points_of(*b.curve, chord);
        auto const moved = [&](double distance) {
            return b.curve->moved_along_normal(distance, b.drive.context->tolerance);
        };
        std::size_t const pieces = b.curve->pieces().size();
        double here = 0.01, gone = 0.1;  // with all pieces, and with fewer
        INFO("tip circle " << b.curve->tip_radius());
        REQUIRE(moved(here).pieces().size() == pieces);
        REQUIRE(moved(gone).pieces().size() < pieces);
        for (int i = 0; i < 40; ++i) {
            double const middle = 0.5 * (here + gone);
            (moved(middle).pieces().size() == pieces ? here : gone) = middle;
        }
        // it has become a point, and the outline goes on without a jump
        std::vector<Vec2> const before = points_of(moved(here), chord), after = points_of(moved(gone), chord);
        for (Vec2 const& p : after)
            CHECK(distance_to_polyline(before, p) < 1.1 * chord);
        for (Vec2 const& p : before)
            CHECK(distance_to_polyline(after, p) < 1.1 * chord);
        // beyond, no point is nearer to where the boundary was, the new corner included, and all but the mitres are as
        // near
        for (double distance = gone; distance < 0.16; distance += 0.004) {
            INFO("distance " << distance);
            conjugate::ToothSpaceBoundary const curve = moved(distance);
            CHECK(curve.pieces().size() < pieces);
            check_parallel(base, points_of(curve, chord), distance, chord);
        }
    }
}

TEST_CASE("boundary moved so far that a stretch is gone says so", "[space_curve]")
{
    Boundary const b;
    for (double const distance : {0.5, -0.4}) {
        INFO("distance " << distance);
        CHECK_THROWS_AS(b.curve->moved_along_normal(distance, b.drive.context->tolerance), NumericalError);
        CHECK_THROWS_WITH(b.curve->moved_along_normal(distance, b.drive.context->tolerance),
                          ContainsSubstring("draft: near (") && ContainsSubstring("tilt.angle_deg"));
    }
}

}  // namespace hdconj::test::space_curve_cases
