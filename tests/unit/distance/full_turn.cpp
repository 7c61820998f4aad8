// SPDX-License-Identifier: GPL-3.0-or-later
#include "hdconj/distance/full_turn.hpp"

#include <cmath>
#include <random>

#include "hdconj/numeric/bernstein_roots.hpp"
#include "profile/measured_points.hpp"
#include "support/catch.hpp"
#include "support/type50.hpp"

namespace hdconj::test::full_turn_cases {

namespace {

/// Signed distance to a fine polygon of the tooth: another path, right to the chord error.
double polygon_distance(std::vector<Vec2> const& polygon, Vec2 const& p)
{
    double nearest = 1e9;
    double side = 1;
    for (std::size_t i = 0; i + 1 < polygon.size(); ++i) {
        Vec2 const d = polygon[i + 1] - polygon[i];
        double const t = std::clamp((p - polygon[i]).dot(d) / d.squaredNorm(), 0.0, 1.0);
        double const distance = (p - polygon[i] - t * d).norm();
        if (distance < nearest) {
            nearest = distance;
            side = cross(d, p - polygon[i]) >= 0 ? 1 : -1;
        }
    }
    return side * nearest;
}

}  // namespace

TEST_CASE("distance to the exact tooth agrees with a fine polygon, inside and outside", "[contact]")
{
    profile::Profile const tooth = type50_tooth();
    distance::ToothDistance const distance(tooth);
    std::vector<Vec2> const polygon = profile::polygon_of(tooth, 1e-8);
    std::mt19937 random(42);
    std::uniform_real_distribution<double> x(-0.5, 0.5), y(0.45, 1.2);
    int inside = 0;
    for (int i = 0; i < 300; ++i) {
        Vec2 const p{x(random), y(random)};
        distance::NearestPoint const near = distance(p);
        double const reference = polygon_distance(polygon, p);
        CHECK(std::abs(near.distance) == Approx(std::abs(reference)).margin(2e-8));
        if (std::abs(reference) > 1e-6)
            CHECK((near.distance > 0) == (reference > 0));
        CHECK(distance.lower_bound(p) <= near.distance + 1e-12);
        // the normal is the gradient
        constexpr double h = 1e-7;
        double const slope =
            (distance(p + h * near.normal).distance - distance(p - h * near.normal).distance) / (2 * h);
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
    profile::FlankSegment flank{"flank", {}};
    for (profile::CurvePiece& piece : profile::spline_through(points))
        flank.pieces.emplace_back(std::move(piece));
    profile::Profile const tooth = profile::symmetric_tooth({flank}, {0.25, 200, 0.7, 0, ""}, 0.2, 0.28);
    distance::ToothDistance const distance(tooth);
    std::vector<Vec2> const polygon = profile::polygon_of(tooth, 1e-8);
    for (int i = 0; i < 60; ++i) {
        Vec2 const p{-0.4 + 0.0137 * i, 0.5 + 0.006 * i};
        CHECK(std::abs(distance(p).distance) == Approx(std::abs(polygon_distance(polygon, p))).margin(3e-8));
    }
}

TEST_CASE(
    "distance to teeth of curves is that to the nearest of all certified feet, near the curve and beyond its centres "
    "of curvature",
    "[contact]")
{
    std::vector<std::string> const plain{"!flexspline.profile.convex_radius",  "!flexspline.profile.convex_offset",
                                         "!flexspline.profile.concave_radius", "!flexspline.profile.concave_offset",
                                         "!flexspline.profile.concave_rise",   "!flexspline.profile.tip_line_from"};
    std::vector<std::vector<std::string>> const families{
        {"flexspline.profile.family=cycloid", "flexspline.profile.addendum=0.19", "flexspline.profile.dedendum=0.26",
         "flexspline.profile.addendum_rolling_radius=0.14", "flexspline.profile.dedendum_rolling_radius=0.2",
         "flexspline.profile.thickness=0.39"},
        {"flexspline.profile.family=involute", "flexspline.profile.addendum=0.2", "flexspline.profile.dedendum=0.28",
         "flexspline.profile.thickness=0.38", "flexspline.profile.pressure_angle_deg=27"},
        {"flexspline.profile.family=s-tooth", "flexspline.profile.addendum=0.17", "flexspline.profile.dedendum=0.25",
         "flexspline.profile.deflection=0.95", "flexspline.profile.pressure_angle_deg=12",
         "flexspline.profile.thickness=0.385"},
        {"flexspline.profile.family=bezier", "!flexspline.profile.addendum", "!flexspline.profile.dedendum",
         "flexspline.profile.points=[[0.06,0.2],[0.15,0.12],[0.17,-0.04],[0.29,-0.28]]"}};
    for (std::vector<std::string> family : families) {
        family.insert(family.begin(), plain.begin(), plain.end());
        INFO(family[plain.size()]);
        profile::Profile const tooth = type50_tooth(family);
        distance::ToothDistance const distance(tooth);
        std::mt19937 random(7);
        std::uniform_real_distribution<double> along(0, 1), off(-9, 0), wide(-1, 1);
        double worst = 0, turned = 0;
        std::size_t curves = 0;
        for (profile::ProfilePiece const& piece : tooth.pieces) {
            auto const* const given = std::get_if<profile::CurvePiece>(&piece.shape);
            curves += given != nullptr;
            for (int i = 0; given != nullptr && i < 400; ++i) {
                double const t = along(random);
                Vec2 const n = left_of(given->first(t)).normalized();
                Vec2 const p = i % 4 == 3
                                   ? Vec2(wide(random), 0.6 + wide(random))
                                   : Vec2(given->point(t) + (i % 2 == 0 ? 1 : -1) * std::pow(10, off(random)) * n);
                double nearest = 1e9;
                auto const offer = [&](Vec2 const& foot) { nearest = std::min(nearest, (p - foot).norm()); };
                for (profile::ProfilePiece const& other : tooth.pieces) {
                    if (other.corner)
                        continue;
                    offer(profile::start_of(other.shape).point);
                    offer(profile::end_of(other.shape).point);
                    if (auto const* line = std::get_if<profile::LinePiece>(&other.shape))
                        offer(line->a +
                              std::clamp((p - line->a).dot(line->tangent()), 0.0, line->length()) * line->tangent());
                    if (auto const* arc = std::get_if<profile::ArcPiece>(&other.shape))
                        for (int k = 0; k <= 4000; ++k)
                            offer(profile::point_at(*arc, k / 4000.0));
                    if (auto const* curve = std::get_if<profile::CurvePiece>(&other.shape)) {
                        std::vector<double> f;
                        double size = 0;
                        for (std::size_t k = 0; k < curve->a().size(); ++k) {
                            f.push_back(curve->a()[k] - p.y() * curve->b()[k] + p.x() * curve->c()[k]);
                            size = std::max(size, std::abs(curve->a()[k]) + std::abs(p.y() * curve->b()[k]) +
                                                      std::abs(p.x() * curve->c()[k]));
                        }
                        numeric::BernsteinRoots const feet = numeric::bernstein_roots(f, 8 * unit_roundoff * size);
                        for (int k = 0; k < feet.count; ++k)
                            offer(curve->point(feet.t[static_cast<std::size_t>(k)]));
                    }
                }
                distance::NearestPoint const found = distance(p);
                worst = std::max(worst, std::abs(std::abs(found.distance) - nearest));
                CHECK((p - found.point).norm() == Approx(nearest).margin(1e-14));
                // beside the curve the normal is the curve's own to some roundings of a coordinate over the speed,
                // however near the point
                double const speed = given->first(t).norm(),
                             curvature = std::abs(cross(given->first(t), given->second(t))) / std::pow(speed, 3);
                double const moved = (found.point - given->point(t)).norm();
                if (i % 4 != 3 && nearest < 1e-3 && moved < 1e-12)
                    turned = std::max(turned, speed * (std::abs(cross(found.normal, n)) - 2 * curvature * moved));
            }
        }
        CHECK(curves > 0);
        CHECK(worst < 1e-14);
        CHECK(turned > 0);
        CHECK(turned < 4e-15);
    }
}

TEST_CASE("the smallest distance over a full turn: marching finds what a dense scan finds", "[contact]")
{
    profile::Profile const tooth = type50_tooth();
    Exact const motion = type50_motion();
    double const pitch = 2 * std::numbers::pi / type50_z_c;
    distance::FullTurnClearance<Exact> const clearance(tooth, motion, pitch, 1);
    distance::ToothDistance const distance(tooth);
    distance::TurnMinimum last;
    for (int i = 0; i < 25; ++i) {
        double const angle = pitch * (-0.5 + i / 24.0);
        double const radius = 25.03 + 0.02 * (i % 20);
        Vec2 const p{radius * std::sin(angle), radius * std::cos(angle)};
        double scanned = 1e9;
        for (int copy = -3; copy <= 3; ++copy)
            for (int k = 0; k <= 20000; ++k) {
                double const u = motion.half_lobe() * (k / 10000.0 - 1);
                Vec2 const x = motion.pose(u).inverse(turned_clockwise(p, -copy * pitch));
                if (distance.lower_bound(x) < scanned)
                    scanned = std::min(scanned, distance(x).distance);
            }
        distance::TurnMinimum const found = clearance(p);
        CHECK(found.distance <= scanned + 1e-13);
        // the scan may stop half a step (80 urad) short of the minimum; the tooth moves by 0.5 mm per radian
        CHECK(found.distance >= scanned - 8e-5);
        distance::TurnMinimum const hinted = clearance(p, i > 0 ? &last : nullptr);
        CHECK(hinted.distance == Approx(found.distance).margin(1e-14));
        last = found;
    }
}

TEST_CASE("the distance to a tooth of a thousand pieces is that to its polygon", "[contact]")
{
    // more pieces than one run holds; a full tooth with a flat tip and wavy flanks
    std::vector<Vec2> points;
    constexpr int count = 1001;
    for (int i = 0; i < count; ++i) {
        double const s = 2.0 * i / (count - 1) - 1;
        points.emplace_back(0.3 * s + 0.01 * std::sin(9 * s), 0.25 - 0.5 * s * s * s * s);
    }
    profile::Profile tooth;
    tooth.segment_names = {"tooth"};
    for (profile::CurvePiece& piece : profile::spline_through(points))
        tooth.pieces.push_back({std::move(piece)});
    tooth.addendum = tooth.dedendum = 0.25;
    distance::ToothDistance const distance(tooth);
    constexpr double chord = 1e-8;
    std::vector<Vec2> const polygon = profile::polygon_of(tooth, chord);
    for (int i = 0; i < 200; ++i) {
        Vec2 const p(0.7 * std::sin(1.7 * i), 0.5 * std::cos(2.3 * i));
        distance::NearestPoint const foot = distance(p);
        INFO("p " << p.transpose());
        // beyond the root ends the sign is the rim's
        CHECK(std::abs(foot.distance) == Approx(std::abs(polygon_distance(polygon, p))).margin(2 * chord));
        CHECK((p - foot.point).norm() == Approx(std::abs(foot.distance)).margin(1e-12));
    }
}

}  // namespace hdconj::test::full_turn_cases
