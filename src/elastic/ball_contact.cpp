// SPDX-License-Identifier: GPL-3.0-or-later
#include "ball_contact.hpp"

#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/ellint_2.hpp>
#include <cmath>
#include <numbers>

#include "hdconj/numeric/bracketed_root.hpp"

namespace hdconj::elastic {
namespace {

/// Complete elliptic integrals of an ellipse of contact whose axes are as exp(x) to 1.
struct Ellipse
{
    double ratio2, modulus2, first, second;

    explicit Ellipse(double x)
        : ratio2(std::exp(2 * x)),
          modulus2(1 - 1 / ratio2),
          first(boost::math::ellint_1(std::sqrt(modulus2))),
          second(boost::math::ellint_2(std::sqrt(modulus2)))
    {
    }
};

/// Approach over that of a sphere with the same sum of curvatures. @param difference  of the curvatures over their sum
double relative_approach(double difference)
{
    constexpr double round = 1e-6;  // the circle's approach differs to second order: below the last digits
    constexpr double longest = 15;  // logarithm of the ratio of axes, for differences up to 1 - 1e-11
    if (difference < round)
        return 1;
    auto const off = [&](double x) {
        Ellipse const e(x);
        return ((e.ratio2 + 1) * e.second - 2 * e.first) / ((e.ratio2 - 1) * e.second) - difference;
    };
    double const x = numeric::bracketed_root(off, round, longest, off(round), off(longest)).x;
    Ellipse const e(x);
    return 2 * e.first / std::numbers::pi * std::cbrt(std::numbers::pi / (2 * e.ratio2 * e.second));
}

/// E/(1 - nu^2) of both bodies in series [MPa].
double contact_modulus(PointContact const& contact)
{
    auto const compliance = [](Elasticity const& body) {
        return (1 - body.poissons_ratio * body.poissons_ratio) / body.youngs_modulus;
    };
    return 1 / (compliance(contact.first) + compliance(contact.second));
}

}  // namespace

double point_constant(PointContact const& contact)
{
    double const sum = contact.along + contact.across;
    double const approach = relative_approach((contact.along - contact.across) / sum);
    // of a sphere on a plane, sum = 2/R: F = 4/3 E* sqrt(R) d^1.5
    return 4.0 / 3 * contact_modulus(contact) * std::sqrt(2 / sum) / (approach * std::sqrt(approach));
}

double ball_constant(GroovedBall const& ball)
{
    double const curvature = 2 / ball.diameter;
    auto const of = [&](double raceway, double conformity) {
        return point_constant(
            {ball.ball, ball.rings, curvature + raceway, curvature - 1 / (conformity * ball.diameter)});
    };
    double const inner = of(1 / (ball.outer_raceway - ball.diameter), ball.inner_conformity);
    double const outer = of(-1 / ball.outer_raceway, ball.outer_conformity);
    return std::pow(std::pow(inner, -2.0 / 3) + std::pow(outer, -2.0 / 3), -1.5);
}

}  // namespace hdconj::elastic
