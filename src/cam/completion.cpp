// SPDX-License-Identifier: GPL-3.0-or-later
#include "completion.hpp"

#include <Eigen/LU>
#include <boost/math/quadrature/gauss.hpp>

#include "hdconj/base/tolerance.hpp"
#include "hdconj/error.hpp"

namespace hdconj::cam {
namespace {

constexpr int rest_powers = 7;  ///< of the even polynomial: up to s^12
constexpr int rest_conditions = 4;

using Coefficients = Eigen::Matrix<double, rest_powers, 1>;

/// Tangential state gained over the completed stretch, and its slope with respect to the coefficients.
struct Gain
{
    double value = 0;
    Coefficients slope = Coefficients::Zero();
};

Gain gain_of(CurveRule const& rule, EvenPolynomial const& curve)
{
    Gain gain;
    auto const integral = [&](auto const& f) {
        return boost::math::quadrature::gauss<double, 30>::integrate(f, 0.0, curve.scale);
    };
    gain.value = integral([&](double x) {
        EvenPolynomial::Value const at = curve(x);
        return rule.tangential_rate(at.value, at.slope);
    });
    for (int j = 0; j < rest_powers; ++j)
        gain.slope[j] = integral([&](double x) {
            EvenPolynomial::Value const at = curve(x);
            double const s = x / curve.scale, power = std::pow(s, 2 * j);
            double const rate = j == 0 ? 0 : 2 * j * std::pow(s, 2 * j - 1) / curve.scale;
            double const rho = rule.r_m + at.value;
            return rule.exact ? (rho * power + at.slope * rate) / std::hypot(rho, at.slope) : -power;
        });
    return gain;
}

}  // namespace

EvenPolynomial completion(CurveRule const& rule, MeshPoint const& end, double bend, double half_wave)
{
    double const span = half_wave - end.x;
    EvenPolynomial curve{span, std::vector<double>(rest_powers, 0.0)};
    curve.coefficients[0] = end.state[0];
    Eigen::Matrix<double, rest_powers + rest_conditions, rest_powers + rest_conditions> system;
    Eigen::Matrix<double, rest_powers + rest_conditions, 1> right;
    constexpr int budget = 30;
    double last = span * rule.r_m;
    for (int round = 0; round < budget; ++round) {
        system.setZero();
        right.setZero();
        for (int j = 0; j < rest_powers; ++j) {
            auto const third = [](int k) { return 2.0 * k * (2 * k - 1) * (2 * k - 2); };
            for (int k = 0; k < rest_powers; ++k)
                if (j > 1 && k > 1)
                    system(j, k) = third(j) * third(k) / (2 * (j + k) - 5);
            double const each[] = {1.0, 2.0 * j, 2.0 * j * (2 * j - 1)};
            for (int c = 0; c < rest_conditions - 1; ++c)
                system(rest_powers + c, j) = system(j, rest_powers + c) = each[c];
        }
        Gain const gain = gain_of(rule, curve);
        double const miss = end.state[1] + gain.value;
        Eigen::Map<Coefficients const> const now(curve.coefficients.data());
        system.block<1, rest_powers>(rest_powers + 3, 0) = gain.slope.transpose() / span;
        system.block<rest_powers, 1>(0, rest_powers + 3) = gain.slope / span;
        right.tail<rest_conditions>() << end.state[0], -span * end.slope, span * span * bend,
            (gain.slope.dot(now) - miss) / span;
        // the angle here runs from the minor axis: the slope changes its sign
        Eigen::Matrix<double, rest_powers + rest_conditions, 1> const solved = system.fullPivLu().solve(right);
        if (!solved.allFinite())
            break;
        Eigen::Map<Coefficients>(curve.coefficients.data()) = solved.head<rest_powers>();
        if (std::abs(miss) <= 64 * unit_roundoff * rule.r_m || (round > 2 && std::abs(miss) >= last))
            return curve;
        last = std::abs(miss);
    }
    throw NumericalError(ErrorCode::not_converged, "neutral curve", "from the end of the mesh to the minor axis",
                         "no smooth curve there gives it the length of the ring");
}

}  // namespace hdconj::cam
