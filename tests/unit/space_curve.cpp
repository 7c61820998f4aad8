// SPDX-License-Identifier: GPL-3.0-or-later
#include "hdconj/conjugate/space_curve.hpp"

#include <algorithm>
#include <cmath>

#include "hdconj/numeric/error.hpp"
#include "pipeline/job.hpp"
#include "support/catch.hpp"
#include "support/coned_drive.hpp"
#include "support/polyline.hpp"

using namespace hdconj;
using namespace hdconj::test;

namespace {

/// The boundary of the built-in drive's tooth space, with what it is made of.
struct Boundary
{
    Boundary() : drive(builtin_scene(), 1), clock(out.plan, observer)
    {
        out.scene = drive.scene;
        out.plan = make_plan(out.scene);
        out.geometry = drive.middle.geometry;
        out.threads = 1;
        auto const& slice = drive.maker->motion(0);
        job.emplace(out, *slice.tooth, slice.motion, clock);
        job->find_branches_of_tooth();
        job->find_boundary();
        curve.emplace(job->curve(slice.owner));
    }
    ConedDrive drive;
    Solution out;
    StageObserver observer;
    detail::StageClock clock;
    std::optional<detail::SolveJob<ErasedMotion>> job;
    std::optional<SpaceCurve> curve;
};

std::vector<Vec2> points_of(SpaceCurve const& curve, double chord)
{
    std::vector<Vec2> points;
    for (BoundaryPiece const& piece : curve.pieces())
    {
        SampledArc const sampled = curve.sampled(piece, chord);
        for (std::size_t i = points.empty() ? 0 : 1; i < sampled.points.size(); ++i)
            points.push_back(sampled.points[i].p);
    }
    return points;
}

}  // namespace

TEST_CASE("boundary moved along its normal is everywhere that far from where it was", "[space_curve]")
{
    Boundary const b;
    constexpr double chord = 1e-8;
    std::vector<Vec2> const base = points_of(*b.curve, chord);
    // into the material, and out of it by less and by more than the sharpest turn of the tip corner's path, which is then swallowed
    for (double const distance : {1e-6, 1e-3, 0.01, 0.03, -1e-6, -1e-4, -5e-4, -1e-3, -1.3e-3, -1.5e-3, -1.7e-3, -1.8e-3, -1.9e-3, -2e-3, -3e-3, -0.0122, -0.03})
    {
        INFO("distance " << distance);
        SpaceCurve const moved = b.curve->moved_along_normal(distance, b.drive.bench->tolerance);
        CHECK(moved.tip_radius() == b.curve->tip_radius() + distance);
        CHECK(moved.offset() == Approx(distance).epsilon(1e-14));
        auto const& pieces = moved.pieces();
        for (std::size_t i = 0; i + 1 < pieces.size(); ++i)
        {
            // corners are where both pieces end
            CHECK((moved.at(pieces[i], pieces[i].end).p - moved.at(pieces[i + 1], pieces[i + 1].begin).p).norm() < 1e-10);
        }
        std::vector<Vec2> const points = points_of(moved, chord);
        double nearest = 1, furthest = 0;
        std::size_t off = 0;
        for (std::size_t i = 0; i < points.size(); ++i)
        {
            if (i > 0)
                CHECK(points[i].x() > points[i - 1].x() - 1e-12);
            // over the land the middle one lies on the tip circle's end, half a pitch away
            double const d = distance_to_polyline(base, points[i]);
            nearest = std::min(nearest, d);
            furthest = std::max(furthest, d);
            off += d > std::abs(distance) + 1.1 * chord;
        }
        CHECK(nearest > std::abs(distance) - 1.1 * chord);
        // a mitre of two stretches that turn by less than 90 degrees
        CHECK(furthest < 1.42 * std::abs(distance) + 1.1 * chord);
        CHECK(off < points.size() / 5);
        for (BoundaryPiece const& piece : pieces)
            CHECK(moved.made_by(piece).segment >= -1);
    }
}

TEST_CASE("boundary moved by nothing has the same bits", "[space_curve]")
{
    Boundary const b;
    Tolerance const& tolerance = b.drive.bench->tolerance;
    CHECK(points_of(b.curve->moved_along_normal(0, tolerance), 1e-6) == points_of(*b.curve, 1e-6));
}

TEST_CASE("boundary moved so far that a stretch is gone says so", "[space_curve]")
{
    Boundary const b;
    for (double const distance : {0.15, 0.5, -0.4})
    {
        INFO("distance " << distance);
        CHECK_THROWS_AS(b.curve->moved_along_normal(distance, b.drive.bench->tolerance), NumericalError);
        CHECK_THROWS_WITH(b.curve->moved_along_normal(distance, b.drive.bench->tolerance), ContainsSubstring("draft: near (") && ContainsSubstring("tilt.angle_deg"));
    }
}
