// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <numbers>

#include "support/catch.hpp"
#include "support/type50.hpp"

namespace hdconj::test::motion_cases {

namespace {

/// Rates against central differences of the pose: the two share only the definition of the motion.
template <class Motion>
void rates_are_derivatives(Motion const& motion)
{
    constexpr double h = 1e-5;
    for (double u : {-1.4, -0.6, -0.05, 0.0, 0.3, 0.9, 1.5}) {
        motion::MotionRates const r = motion.rates(u);
        Pose const here = motion.pose(u);
        Pose const after = motion.pose(u + h);
        Pose const before = motion.pose(u - h);
        for (Vec2 const& x : {Vec2(0, 0), Vec2(0.1, 0.8), Vec2(-0.3, 0.4)}) {
            Vec2 const v = (after(x) - before(x)) / (2 * h);
            CHECK((v - here.rotate(r.twist(x))).norm() < 2e-9);
        }
        motion::MotionRates const ra = motion.rates(u + h);
        motion::MotionRates const rb = motion.rates(u - h);
        CHECK((ra.twist.omega - rb.twist.omega) / (2 * h) == Approx(r.change.omega).margin(1e-9));
        CHECK(((ra.twist.q - rb.twist.q) / (2 * h) - r.change.q).norm() < 1e-8);
        CHECK(std::abs(r.twist.omega) <= r.omega_size);
        CHECK(r.twist.q.norm() <= r.q_size);
        CHECK(r.change.q.norm() <= r.q_change_size);
    }
}

}  // namespace

TEST_CASE("exact and first-order rates are the derivatives of their poses, n = 1, 2, 3", "[motion]")
{
    for (int waves : {1, 2, 3}) {
        rates_are_derivatives(type50_motion(waves));
        rates_are_derivatives(type50_first_order(waves));
    }
}

TEST_CASE("the closed neutral curve of type-50 has r_0 - r_m = -2.567 um", "[motion]")
{
    wavegen::NeutralCurve<wavegen::CosineCam> const curve(wavegen::CosineCam{type50_w0, 2}, type50_r_m);
    CHECK((curve.r_0() - curve.r_m()) * 1e3 == Approx(-2.567).margin(5e-4));
    CHECK(curve.phi(2 * std::numbers::pi) == Approx(2 * std::numbers::pi).epsilon(1e-15));
    // second path: composite Gauss-Legendre is not needed for a periodic integrand, the trapezoid rule converges
    // geometrically
    double length = 0;
    constexpr int points = 400;
    for (int i = 0; i < points; ++i) {
        double const u = 2 * std::numbers::pi * i / points;
        double const rho = curve.r_0() + type50_w0 * std::cos(2 * u);
        length += std::hypot(rho, 2 * type50_w0 * std::sin(2 * u));
    }
    CHECK(length / points == Approx(type50_r_m).epsilon(1e-15));
}

TEST_CASE("no radial deformation, no relative motion but the slow turn", "[motion]")
{
    // w0 -> 0: the ring stays a circle, the tooth turns with gamma = (1 - z_f/z_c) u about the centre
    Exact const motion = type50_motion(2, 1e-12);
    for (double u : {-1.0, 0.4, 1.2}) {
        double const gamma = (1 - type50_ratio) * u;
        Pose const pose = motion.pose(u);
        CHECK(pose.origin.x() == Approx(type50_r_m * std::sin(gamma)).epsilon(1e-11));
        CHECK(pose.sine == Approx(std::sin(gamma)).epsilon(1e-9));
        CHECK(motion.rates(u).twist.omega == Approx(1 - type50_ratio).epsilon(1e-9));
    }
}

TEST_CASE("the motion is mirror symmetric and one lobe moves the tooth by a whole number of pitches", "[motion]")
{
    Exact const motion = type50_motion();
    for (double u : {0.1, 0.7, 1.4}) {
        Pose const right = motion.pose(u);
        Pose const left = motion.pose(-u);
        CHECK(left.origin.x() == -right.origin.x());
        CHECK(left.origin.y() == right.origin.y());
        CHECK(left.sine == -right.sine);
    }
    double const half = motion.half_lobe();
    Vec2 const a = motion.pose(-half).origin;
    Vec2 const b = motion.pose(half).origin;
    double const moved = std::atan2(b.x(), b.y()) - std::atan2(a.x(), a.y());
    CHECK(moved == Approx(2 * std::numbers::pi / type50_z_c).epsilon(1e-12));
}

TEST_CASE("first-order motion is the thesis' (2-16), (2-17), (2-19)", "[motion]")
{
    FirstOrder const motion = type50_first_order();
    for (double phi : {-1.1, 0.2, 0.8}) {
        double const v = -0.5 * type50_w0 * std::sin(2 * phi);
        double const mu = 1.5 * type50_w0 * std::sin(2 * phi) / type50_r_m;
        double const phi_2 = type50_ratio * phi;
        double const gamma = phi + v / type50_r_m - phi_2;
        double const theta = phi + mu - phi_2;
        double const rho = type50_r_m + type50_w0 * std::cos(2 * phi);
        Pose const pose = motion.pose(phi);
        CHECK(pose.origin.x() == Approx(rho * std::sin(gamma)).margin(1e-14));
        CHECK(pose.origin.y() == Approx(rho * std::cos(gamma)).epsilon(1e-14));
        CHECK(pose.sine == Approx(std::sin(theta)).margin(1e-15));
    }
}

TEST_CASE("a deformation as large as the ring is refused", "[motion]")
{
    CHECK_THROWS_AS(wavegen::NeutralCurve<wavegen::CosineCam>(wavegen::CosineCam{25, 2}, type50_r_m), NumericalError);
}

}  // namespace hdconj::test::motion_cases
