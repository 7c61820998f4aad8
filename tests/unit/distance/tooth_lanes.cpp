// SPDX-License-Identifier: GPL-3.0-or-later
#include "hdconj/distance/tooth_lanes.hpp"

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "hdconj/distance/full_turn.hpp"
#include "hdconj/distance/lowest_point.hpp"
#include "profile/measured_points.hpp"
#include "support/catch.hpp"
#include "support/type50.hpp"

namespace hdconj::test::tooth_lanes_cases {

TEST_CASE("tooth lanes: distance and slope of eight points at once are those of one at a time", "[contact]")
{
    profile::Profile const tooth = type50_tooth();
    distance::ToothDistance const distance(tooth);
    auto const eight = distance::tooth_lanes(tooth);
    REQUIRE(eight.has_value());
    Exact const motion = type50_motion();
    std::mt19937 random(11);
    std::uniform_real_distribution<double> x(-0.5, 0.5), y(0.3, 1.4), u(-1.5, 1.5);
    double off = 0, steep = 0;
    int within = 0;
    for (int i = 0; i < 500; ++i) {
        double const at = u(random);
        Pose const pose = motion.pose(at);
        PlanarVelocity const twist = motion.rates(at).twist;
        distance::Lanes px, py, d, slope;
        for (std::size_t l = 0; l < distance::lanes; ++l) {
            Vec2 const p = pose(Vec2(x(random), y(random)));
            px[l] = p.x();
            py[l] = p.y();
        }
        (*eight)(pose, twist, px, py, d, slope);
        for (std::size_t l = 0; l < distance::lanes; ++l) {
            Vec2 const local = pose.inverse(Vec2(px[l], py[l]));
            distance::NearestPoint const foot = distance(local);
            off = std::max(off, std::abs(d[l] - foot.distance));
            if (std::abs(foot.distance) > 1e-3)
                steep = std::max(steep, std::abs(slope[l] + foot.normal.dot(twist(local))));
            within += foot.distance < 0;
        }
    }
    CHECK(within > 300);
    CHECK(off < 1e-12);
    CHECK(steep < 1e-9);
}

TEST_CASE("tooth lanes: none for a tooth with curves", "[contact]")
{
    std::vector<Vec2> points;
    for (int i = 0; i <= 12; ++i)
        points.emplace_back(0.06 + 0.02 * i, 0.2 - 0.04 * i);
    profile::FlankSegment flank{"flank", {}};
    for (profile::CurvePiece& piece : profile::spline_through(points))
        flank.pieces.emplace_back(std::move(piece));
    CHECK_FALSE(
        distance::tooth_lanes(profile::symmetric_tooth({flank}, {0.25, 200, 0.7, 0, ""}, 0.2, 0.28)).has_value());
}

TEST_CASE("full turns of neighbouring points together are those one by one, however they are grouped", "[contact]")
{
    profile::Profile const tooth = type50_tooth();
    Exact const motion = type50_motion();
    double const pitch = 2 * std::numbers::pi / type50_z_c;
    distance::FullTurnClearance<Exact> const clearance(tooth, motion, pitch, 1);
    // close together and far apart
    for (double const step : {1e-5, 1e-3, 2e-2}) {
        std::vector<Vec2> points;
        for (int i = 0; i < 45; ++i) {
            double const angle = pitch * 0.2 + step * i / 100;
            double const radius = 25.1 + step * i;
            points.emplace_back(radius * std::sin(angle), radius * std::cos(angle));
        }
        std::vector<distance::TurnMinimum> together(points.size()), shifted(points.size());
        clearance(points, nullptr, together);
        std::span<Vec2 const> const all(points);
        clearance(all.first(5), nullptr, std::span(shifted).first(5));
        clearance(all.subspan(5), &shifted[4], std::span(shifted).subspan(5));
        for (std::size_t i = 0; i < points.size(); ++i) {
            INFO("step " << step << " point " << i);
            double const alone = clearance(points[i]).distance;
            CHECK(std::abs(together[i].distance - alone) < 3e-14);
            CHECK(std::abs(shifted[i].distance - alone) < 3e-14);
            distance::ToothDistance const distance(tooth);
            Vec2 const at = turned_clockwise(points[i], -together[i].copy * pitch);
            CHECK(std::abs(distance(motion.pose(together[i].u).inverse(at)).distance - together[i].distance) < 3e-14);
        }
    }
}

TEST_CASE("the lowest point of smooth and of pointed dips, in few looks", "[contact]")
{
    constexpr double rounding = 1e-15;
    struct Case
    {
        char const* what;
        double (*value)(double);
        double (*slope)(double);
        double lowest;
        int looks;
    };
    // all about x = 0.3 in steps of 0.01
    std::vector<Case> const cases{
        {"parabola", [](double x) { return (x - 0.3) * (x - 0.3); }, [](double x) { return 2 * (x - 0.3); }, 0, 3},
        {"cosine", [](double x) { return 1 - std::cos(x - 0.3); }, [](double x) { return std::sin(x - 0.3); }, 0, 5},
        {"quartic beside", [](double x) { return std::pow(x - 0.29, 4) - 4e-6 * x; },
         [](double x) { return 4 * std::pow(x - 0.29, 3) - 4e-6; }, -1.19e-6, 12},
        {"straight sides", [](double x) { return x < 0.3 ? 0.07 * (0.3 - x) : 0.3 * (x - 0.3); },
         [](double x) { return x < 0.3 ? -0.07 : 0.3; }, 0, 6},
        {"bent up", [](double x) { return std::abs(x - 0.3) + (x - 0.3) * (x - 0.3); },
         [](double x) { return (x < 0.3 ? -1 : 1) + 2 * (x - 0.3); }, 0, 30},
        {"bent down", [](double x) { return std::abs(x - 0.3) - 9 * (x - 0.3) * (x - 0.3); },
         [](double x) { return (x < 0.3 ? -1 : 1) - 18 * (x - 0.3); }, 0, 40},
        {"one side bent down",
         [](double x) { return x < 0.3 ? 0.02 * (0.3 - x) : (x - 0.3) - 20 * (x - 0.3) * (x - 0.3); },
         [](double x) { return x < 0.3 ? -0.02 : 1 - 40 * (x - 0.3); }, 0, 40},
        {"straight and a parabola", [](double x) { return x < 0.3 ? 0.02 * (0.3 - x) : (x - 0.3) * (x - 0.3); },
         [](double x) { return x < 0.3 ? -0.02 : 2 * (x - 0.3); }, 0, 60},
    };
    for (Case const& dip : cases)
        for (double const before : {0.0031, 0.005, 0.0097}) {
            INFO(dip.what << " " << before);
            int looks = 0;
            double best = 1;
            auto const look = [&](double x) {
                ++looks;
                best = std::min(best, dip.value(x));
                return distance::BracketEnd{x, dip.value(x), dip.slope(x)};
            };
            distance::minimise_bracketed(look, {0.3 - before, dip.value(0.3 - before), dip.slope(0.3 - before)},
                                         {0.31 - before, dip.value(0.31 - before), dip.slope(0.31 - before)}, rounding);
            CHECK(best <= dip.lowest + 4 * rounding);
            CHECK(best >= dip.lowest - 4 * rounding);
            CHECK(looks <= dip.looks);
        }
}

}  // namespace hdconj::test::tooth_lanes_cases
