// SPDX-License-Identifier: GPL-3.0-or-later
// Gaps of a circular spline whose profile deviates.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "support/catch.hpp"
#include "support/coned_drive.hpp"

namespace hdconj::test::spline_profile_cases {

namespace {

/// Excess of material of the circular spline at a height above its pitch circle, towards the axis: a slope and a bump.
struct SplineProfile
{
    double pitch_radius, rise, bump;
    [[nodiscard]] double operator()(double radius) const
    {
        double const height = pitch_radius - radius;
        return -rise * height - bump * std::cos(9 * height);
    }
};

}  // namespace

TEST_CASE("gaps with a profile of the circular spline are distances to the flank that is made", "[gap_field]")
{
    ConedFlanks const flanks;
    double const pitch_radius = flanks.drive.scene.drive.module * flanks.drive.z_c() / 2;
    SplineProfile const profile{pitch_radius, 8e-3, 1e-3};
    contact::FlankDeviation deviation, nothing;
    deviation.radius = profile;
    nothing.radius = [](double) { return 0; };
    contact::GapField const plain = flanks.field(nullptr), made = flanks.field(&deviation);
    CHECK(flanks.field(&nothing).map(1e-4, 1).gap == plain.map(1e-4, 1).gap);

    constexpr int steps = 20;  // between two points
    constexpr double near = 0.03, slope = 0.02;
    int compared = 0;
    for (std::size_t space = 80; space < 122; ++space)
        for (int const flank : {0, 1}) {
            auto const place = [&](std::size_t j, int i) {
                return flanks.grid.between(
                    flank, 1,
                    flanks.grid.place(flank, j) +
                        (flanks.grid.place(flank, j + 1) - flanks.grid.place(flank, j)) * i / steps);
            };
            double least = 1, least_of_made = 1;
            Vec2 at = Vec2::Zero(), made_normal = Vec2::Zero(), across = Vec2::Zero();
            bool inside = false;
            for (std::size_t j = 0; j + 1 < flanks.grid.points(); ++j)
                for (int i = 0; i < steps; ++i) {
                    Vec2 const q = place(j, i), ahead = place(j, i + 1);
                    Vec2 normal = left_of(Vec2(ahead - q)).normalized();
                    auto const& into = flanks.grid.normal[static_cast<std::size_t>(flank)][1][j];
                    normal = normal.dot(into) > 0 ? normal : Vec2(-normal);
                    auto const moved = [&](Vec2 const& p) { return Vec2(p + profile(p.norm()) * normal); };
                    double const gap = made.touch(space, 1, q, 0).nearest.distance;
                    if (gap < least) {
                        least = gap;
                        at = q;
                        made_normal = moved(ahead) - moved(q);
                        across = ahead - q;
                        inside = j > 0 && j + 2 < flanks.grid.points();
                    }
                    least_of_made = std::min(least_of_made, plain.touch(space, 1, moved(q), 0).nearest.distance);
                }
            if (!inside || std::abs(least) > near)
                continue;
            ++compared;
            // half of the square of the slope, times the gap; and what the steps leave out
            CHECK(least == Approx(least_of_made).margin(slope * slope * near + 1e-6));
            auto const touch = made.touch(space, 1, at, 0);
            // across the made flank, and not across the nominal one
            CHECK(std::abs(touch.normal.dot(made_normal.normalized())) < 2e-3);
            CHECK(std::abs(touch.gradient().dot(across.normalized())) < 2e-3);
        }
    CHECK(compared > 20);
}

TEST_CASE("equal slopes on both flanks leave what the wave takes from the sum of both heights", "[gap_field]")
{
    // A point of contact stands at y above the flexspline's pitch line and at h = m z_c/2 - r towards the axis. With
    // r = m z_f/2 + w + y their sum is w0 - w, as long as w0 is the module; so slopes that are equal close all gaps by
    // as much wherever the flanks touch, and cancel at the major axis. The tooth leans by less than 1.5 w0/r.
    ConedFlanks const flanks;
    Scene const& scene = flanks.drive.scene;
    double const pitch_radius = scene.drive.module * flanks.drive.z_c() / 2, rise = 6e-3, w0 = 0.25;
    contact::FlankDeviation both, spline;
    both.height = [&](double y) { return -rise * (y - flanks.drive.tooth.pitch_line); };
    both.excess = 1e-2;
    spline.radius = both.radius = [=](double r) { return -rise * (pitch_radius - r); };
    contact::GapField const plain = flanks.field(nullptr), made = flanks.field(&both), one = flanks.field(&spline);
    double largest = 0, alone = 0;
    int compared = 0;
    for (std::size_t space = 70; space < 132; ++space)
        for (int const flank : {0, 1})
            for (std::size_t i = 0; i < flanks.grid.points(); ++i) {
                contact::GapField::Index const at{space, flank, 1, i};
                auto const touch = plain.touch(at, 0);
                if (std::abs(touch.nearest.distance) > 5e-3)
                    continue;
                ++compared;
                double const w = w0 * std::cos(4 * std::numbers::pi * touch.tooth / flanks.drive.z_f());
                double const change = made.gap(at, 0) - touch.nearest.distance;
                CHECK(change == Approx(-rise * (w0 - w)).margin(rise * (5e-3 + 1.5 * w0 / pitch_radius * 0.4)));
                largest = std::max(largest, std::abs(change));
                alone = std::max(alone, std::abs(one.gap(at, 0) - touch.nearest.distance));
            }
    CAPTURE(compared, largest, alone);
    CHECK(compared > 100);
    CHECK(largest > 1e-4);
    CHECK(alone > 5e-4);
}

}  // namespace hdconj::test::spline_profile_cases
