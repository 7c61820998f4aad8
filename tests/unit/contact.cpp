// SPDX-License-Identifier: GPL-3.0-or-later
#include "hdconj/contact/full_turn.hpp"

#include <cmath>
#include <random>

#include "hdconj/profile/measured_points.hpp"
#include "support/catch.hpp"
#include "support/type50.hpp"

using namespace hdconj;
using namespace hdconj::test;

namespace {

/// Signed distance to a fine polygon of the tooth: another path, right to the chord error.
double polygon_distance(std::vector<Vec2> const& polygon, Vec2 const& p)
{
    double nearest = 1e9;
    double side = 1;
    for (std::size_t i = 0; i + 1 < polygon.size(); ++i)
    {
        Vec2 const d = polygon[i + 1] - polygon[i];
        double const t = std::clamp((p - polygon[i]).dot(d) / d.squaredNorm(), 0.0, 1.0);
        double const distance = (p - polygon[i] - t * d).norm();
        if (distance < nearest)
        {
            nearest = distance;
            side = cross(d, p - polygon[i]) >= 0 ? 1 : -1;
        }
    }
    return side * nearest;
}

}  // namespace

TEST_CASE("distance to the exact tooth agrees with a fine polygon, inside and outside", "[contact]")
{
    Profile const tooth = type50_tooth();
    ToothDistance const distance(tooth);
    std::vector<Vec2> const polygon = polygon_of(tooth, 1e-8);
    std::mt19937 random(42);
    std::uniform_real_distribution<double> x(-0.5, 0.5), y(0.45, 1.2);
    int inside = 0;
    for (int i = 0; i < 300; ++i)
    {
        Vec2 const p{x(random), y(random)};
        NearestPoint const near = distance(p);
        double const reference = polygon_distance(polygon, p);
        CHECK(std::abs(near.distance) == Approx(std::abs(reference)).margin(2e-8));
        if (std::abs(reference) > 1e-6)
            CHECK((near.distance > 0) == (reference > 0));
        CHECK(distance.lower_bound(p) <= near.distance + 1e-12);
        // the normal is the gradient
        constexpr double h = 1e-7;
        double const slope = (distance(p + h * near.normal).distance - distance(p - h * near.normal).distance) / (2 * h);
        if (std::abs(near.distance) > 1e-3)
            CHECK(slope == Approx(1).margin(1e-3));
        inside += near.distance < 0;
    }
    CHECK(inside > 30);
}

TEST_CASE("distance to a spline tooth", "[contact]")
{
    std::vector<Vec2> points;
    for (int i = 0; i <= 12; ++i)
        points.emplace_back(0.06 + 0.02 * i + 0.003 * std::sin(i), 0.2 - 0.04 * i);
    FlankSegment flank{"flank", {}};
    for (CurvePiece& piece : spline_through(points))
        flank.pieces.emplace_back(std::move(piece));
    Profile const tooth = symmetric_tooth({flank}, {0.25, 200, 0.7, 0, ""}, 0.2, 0.28);
    ToothDistance const distance(tooth);
    std::vector<Vec2> const polygon = polygon_of(tooth, 1e-8);
    for (int i = 0; i < 60; ++i)
    {
        Vec2 const p{-0.4 + 0.0137 * i, 0.5 + 0.006 * i};
        CHECK(std::abs(distance(p).distance) == Approx(std::abs(polygon_distance(polygon, p))).margin(3e-8));
    }
}

TEST_CASE("the smallest distance over a full turn: marching finds what a dense scan finds", "[contact]")
{
    Profile const tooth = type50_tooth();
    Exact const motion = type50_motion();
    double const pitch = 2 * std::numbers::pi / type50_z_c;
    FullTurnClearance<Exact> const clearance(tooth, motion, pitch, 1);
    ToothDistance const distance(tooth);
    TurnMinimum last;
    for (int i = 0; i < 25; ++i)
    {
        double const angle = pitch * (-0.5 + i / 24.0);
        double const radius = 25.03 + 0.02 * (i % 20);
        Vec2 const p{radius * std::sin(angle), radius * std::cos(angle)};
        double scanned = 1e9;
        for (int copy = -3; copy <= 3; ++copy)
            for (int k = 0; k <= 20000; ++k)
            {
                double const u = motion.half_lobe() * (k / 10000.0 - 1);
                Vec2 const x = motion.pose(u).inverse(turned_clockwise(p, -copy * pitch));
                if (distance.lower_bound(x) < scanned)
                    scanned = std::min(scanned, distance(x).distance);
            }
        TurnMinimum const found = clearance(p);
        CHECK(found.distance <= scanned + 1e-13);
        // the scan may stop half a step (80 urad) short of the minimum; the tooth moves by 0.5 mm per radian
        CHECK(found.distance >= scanned - 8e-5);
        TurnMinimum const hinted = clearance(p, i > 0 ? &last : nullptr);
        CHECK(hinted.distance == Approx(found.distance).margin(1e-14));
        last = found;
    }
}

TEST_CASE("the distance to a tooth of a thousand pieces is that to its polygon", "[contact]")
{
    // more pieces than one run holds; a full tooth with a flat tip and wavy flanks
    std::vector<Vec2> points;
    constexpr int count = 1001;
    for (int i = 0; i < count; ++i)
    {
        double const s = 2.0 * i / (count - 1) - 1;
        points.emplace_back(0.3 * s + 0.01 * std::sin(9 * s), 0.25 - 0.5 * s * s * s * s);
    }
    Profile tooth;
    tooth.segment_names = {"tooth"};
    for (CurvePiece& piece : spline_through(points))
        tooth.pieces.push_back({std::move(piece)});
    tooth.addendum = tooth.dedendum = 0.25;
    ToothDistance const distance(tooth);
    constexpr double chord = 1e-8;
    std::vector<Vec2> const polygon = polygon_of(tooth, chord);
    for (int i = 0; i < 200; ++i)
    {
        Vec2 const p(0.7 * std::sin(1.7 * i), 0.5 * std::cos(2.3 * i));
        NearestPoint const foot = distance(p);
        INFO("p " << p.transpose());
        // beyond the root ends the sign is the rim's
        CHECK(std::abs(foot.distance) == Approx(std::abs(polygon_distance(polygon, p))).margin(2 * chord));
        CHECK((p - foot.point).norm() == Approx(std::abs(foot.distance)).margin(1e-12));
    }
}
