// SPDX-License-Identifier: GPL-3.0-or-later
#include "hdconj/motion/rates_model.hpp"

#include <cmath>
#include <complex>
#include <numbers>
#include <span>

#include "hdconj/motion/material_motion.hpp"
#include "hdconj/numeric/bernstein.hpp"
#include "hdconj/wavegen/displacement_of.hpp"
#include "hdconj/wavegen/inextensional_mode.hpp"
#include "support/catch.hpp"
#include "support/type50.hpp"

namespace hdconj::test::rates_model_cases {

namespace {

using Complex = std::complex<double>;

double value(motion::RatesVector const& c, double s)
{
    return numeric::bernstein_value({c.data(), motion::rates_coefficients}, s);
}

double slope(motion::RatesVector const& c, double s)
{
    return numeric::bernstein_value(numeric::bernstein_derivative({c.data(), motion::rates_coefficients}), s);
}

/// Largest error of the model against the motion as a share of the stated one, at points that the fit has not seen.
template <class Motion>
double used(Motion const& motion, motion::RatesModel const& model)
{
    double worst = 0;
    for (motion::RatesPanel const& p : model.panels) {
        for (int i = 0; i <= 57; ++i) {
            double const s = i / 57.0;
            motion::MotionRates const r = motion.rates(p.u0 + s * (p.u1 - p.u0));
            double const h = p.u1 - p.u0;
            worst = std::max({worst, std::abs(value(p.omega, s) - r.twist.omega) / p.omega_error,
                              std::abs(value(p.q_x, s) - r.twist.q.x()) / p.q_error,
                              std::abs(value(p.q_y, s) - r.twist.q.y()) / p.q_error,
                              std::abs(slope(p.omega, s) - h * r.change.omega) / p.omega_slope,
                              std::abs(slope(p.q_x, s) - h * r.change.q.x()) / p.q_slope,
                              std::abs(slope(p.q_y, s) - h * r.change.q.y()) / p.q_slope});
        }
    }
    return worst;
}

/// A motion whose velocity has a kink that it does not declare.
struct Kinked
{
    Pose pose(double) const { return {}; }
    motion::MotionRates rates(double u) const
    {
        return {{0.1 * std::abs(u - 0.3), {std::cos(u), 0}}, {u < 0.3 ? -0.1 : 0.1, {-std::sin(u), 0}}, 1, 1, 1, 1};
    }
    motion::ToothAngles angles(double u) const { return {u, u}; }
    double half_lobe() const { return 1; }
    std::span<double const> breaks() const { return {}; }
    bool symmetric() const { return false; }
};

}  // namespace

TEST_CASE("the model of the rates keeps its stated errors, values and slopes", "[motion]")
{
    for (int waves : {1, 2, 3}) {
        for (double w0 : {1e-9, 0.25, 3.0}) {
            Exact const exact = type50_motion(waves, w0);
            motion::RatesModel const model = motion::rates_model(exact, -exact.half_lobe(), exact.half_lobe());
            REQUIRE(model.resolved);
            CHECK(used(exact, model) < 0.5);
            FirstOrder const first = type50_first_order(waves, w0);
            motion::RatesModel const other = motion::rates_model(first, -first.half_lobe(), first.half_lobe());
            REQUIRE(other.resolved);
            CHECK(used(first, other) < 0.5);
            motion::MaterialMotion const material(wavegen::inextensional_mode(wavegen::CosineCam{w0, waves}),
                                                  type50_r_m, type50_ratio);
            motion::RatesModel const third = motion::rates_model(material, -material.half_lobe(), material.half_lobe());
            REQUIRE(third.resolved);
            CHECK(used(material, third) < 0.5);
            motion::MaterialMotion const same(wavegen::displacement_of(exact.curve()), type50_r_m, type50_ratio);
            motion::RatesModel const fourth = motion::rates_model(same, -same.half_lobe(), same.half_lobe());
            REQUIRE(fourth.resolved);
            CHECK(used(same, fourth) < 0.5);
        }
    }
    CHECK(motion::rates_model(type50_motion(), -std::numbers::pi / 2, std::numbers::pi / 2).panels.size() <= 16);
}

TEST_CASE("what the model neglects is below its stated error by Cauchy's bound", "[motion]")
{
    // the interpolant at N + 1 Chebyshev points of a function that is analytic, and in modulus below M, in the ellipse
    // with foci at the ends of the panel and half axes summing to R (times half the panel) is off by at most 4 M R^-N /
    // (R - 1)
    for (int waves : {1, 2, 3}) {
        Exact const motion = type50_motion(waves);
        double const r_0 = motion.curve().r_0();
        double const per = type50_ratio / type50_r_m;
        motion::RatesModel const model = motion::rates_model(motion, -motion.half_lobe(), motion.half_lobe());
        for (motion::RatesPanel const& panel : model.panels) {
            double const middle = 0.5 * (panel.u0 + panel.u1);
            double const half = 0.5 * (panel.u1 - panel.u0);
            PlanarVelocity const at_middle = motion.rates(middle).twist;
            double omega_bound = 1, q_bound = 1;
            for (double r = 4; r < 24; r *= 1.2) {
                double omega = 0, q = 0;
                bool analytic = true;
                constexpr int samples = 720;
                for (int i = 0; i < samples; ++i) {
                    Complex const e = std::polar(r, 2 * std::numbers::pi * i / samples);
                    Complex const u = middle + half * 0.5 * (e + 1.0 / e);
                    double const n = waves;
                    Complex const rho = r_0 + type50_w0 * std::cos(n * u), rho1 = -n * type50_w0 * std::sin(n * u),
                                  rho2 = -n * n * type50_w0 * std::cos(n * u);
                    Complex const square = rho * rho + rho1 * rho1;
                    // the root has no branch point inside while the values on the ellipse stay in the right half plane
                    analytic = analytic && square.real() > 0;
                    Complex const length = std::sqrt(square);
                    omega = std::max(
                        omega, std::abs(1.0 - per * length - (rho * rho2 - rho1 * rho1) / square - at_middle.omega));
                    q = std::max({q, std::abs(length - per * rho * rho - at_middle.q.x()),
                                  std::abs(per * rho * rho1 - at_middle.q.y())});
                }
                constexpr double between_samples = 1.05;
                double const share = between_samples * 4 * std::pow(r, -motion::rates_degree) / (r - 1);
                if (analytic) {
                    omega_bound = std::min(omega_bound, share * omega);
                    q_bound = std::min(q_bound, share * q);
                }
            }
            CHECK(omega_bound < panel.omega_error);
            CHECK(q_bound < panel.q_error);
        }
    }
}

TEST_CASE("a kink that a motion does not declare is seen", "[motion]")
{
    CHECK_FALSE(motion::rates_model(Kinked{}, -1, 1).resolved);
    CHECK(motion::rates_model(Kinked{}, 0.3, 1).resolved);
    CHECK(motion::rates_model(Kinked{}, 0, 0).panels.empty());
}

}  // namespace hdconj::test::rates_model_cases
