// SPDX-License-Identifier: GPL-3.0-or-later
// The table of poses against the neutral curve's own equations, integrated here.
#include "hdconj/turning_teeth.hpp"

#include <cmath>
#include <numbers>

#include "hdconj/contact.hpp"
#include "hdconj/read_scene.hpp"
#include "support/catch.hpp"

namespace hdconj::test::turning_teeth_cases {

namespace {

/// rho(u) = r_0 + w0 cos 2u of type-50 (design 3.1), r_0 from docs/explanation/thesis.md by the length of the curve.
struct Curve
{
    double w0 = 0.25, r_m = 24.347, r_0 = r_0_of(w0, r_m);

    [[nodiscard]] double rho(double u) const { return r_0 + w0 * std::cos(2 * u); }
    [[nodiscard]] double slope(double u) const { return -2 * w0 * std::sin(2 * u); }
    /// Arc from the major axis to @p u over r_m, by Simpson's rule.
    [[nodiscard]] double phi(double u) const { return arc(r_0, w0, u) / r_m; }

  private:
    static double arc(double r_0, double w0, double u)
    {
        constexpr int n = 2000;
        double sum = 0;
        for (int i = 0; i <= n; ++i) {
            double const v = u * i / n;
            int const weight = i == 0 || i == n ? 1 : i % 2 == 1 ? 4 : 2;
            sum += weight * std::hypot(r_0 + w0 * std::cos(2 * v), 2 * w0 * std::sin(2 * v));
        }
        return sum * u / (3 * n);
    }
    static double r_0_of(double w0, double r_m)
    {
        double r = r_m;
        for (int i = 0; i < 50; ++i)
            r += r_m - arc(r, w0, std::numbers::pi / 2) / (std::numbers::pi / 2);
        return r;
    }
};

/// As the page interpolates.
double between(std::vector<double> const& table, double place)
{
    auto const n = static_cast<long>(table.size());
    double const low = std::floor(place), t = place - low;
    auto const at = [&](long ahead) {
        return table[static_cast<std::size_t>((static_cast<long>(low) + ahead + n) % n)];
    };
    return -at(-1) * t * (t - 1) * (t - 2) / 6 + at(0) * (t + 1) * (t - 1) * (t - 2) / 2 -
           at(1) * (t + 1) * t * (t - 2) / 2 + at(2) * (t + 1) * t * (t - 1) / 6;
}

}  // namespace

TEST_CASE("turning teeth: the interpolated poses are those of the neutral curve", "[turning_teeth]")
{
    TurningTeeth const teeth = turning_teeth(builtin_scene(), {0});
    Curve const curve;
    CHECK(teeth.period == std::numbers::pi);
    CHECK(teeth.interpolation_error < 1e-6);
    CHECK(std::abs(teeth.tooth.front().x() + teeth.tooth.back().x()) < teeth.chord);
    for (double u = 0.013; u < std::numbers::pi / 2; u += 0.11) {
        INFO("u = " << u);
        double const phi = curve.phi(u), place = phi / teeth.period * teeth.steps;
        double const tolerance = teeth.interpolation_error + 1e-9;
        CHECK(std::abs(between(teeth.radius, place) - curve.rho(u)) < tolerance);
        CHECK(std::abs(between(teeth.advance, place) - (u - phi)) < tolerance / curve.r_m);
        CHECK(std::abs(between(teeth.lean, place) - (u - phi - std::atan(curve.slope(u) / curve.rho(u)))) < tolerance);
    }
}

TEST_CASE("turning teeth: a jump of the curvature costs accuracy, and the table says so", "[turning_teeth]")
{
    TurningTeeth const smooth = turning_teeth(builtin_scene(), {0});
    TurningTeeth const jumps = turning_teeth(read_scene(HDCONJ_SOURCE_DIR "/data/scenes/two-disc.toml"), {0});
    CHECK(jumps.interpolation_error > 10 * smooth.interpolation_error);
    CHECK(jumps.interpolation_error < 1e-6);
}

TEST_CASE("turning teeth: the reverse problem turns the tooth that it solves for", "[turning_teeth]")
{
    TurningTeeth const teeth =
        turning_teeth(read_scene(HDCONJ_SOURCE_DIR "/data/scenes/circular-spline-given.toml"), {0});
    REQUIRE(teeth.tooth.size() > 100);
    CHECK(teeth.chord > 0);
    CHECK(teeth.tooth.front().x() < 0);
}

TEST_CASE("teeth are placed in one plane at least", "[turning_teeth]")
{
    CHECK_THROWS_AS(turning_teeth(builtin_scene(), {}), InputError);
    CHECK_THROWS_AS(flexspline_poses(builtin_scene(), {}, 0), InputError);
}

}  // namespace hdconj::test::turning_teeth_cases
