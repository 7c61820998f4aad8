// SPDX-License-Identifier: GPL-3.0-or-later
#include "extrapolation.hpp"

#include <algorithm>
#include <cmath>

namespace hdconj::rig {
namespace {

/// Least squares of one curve through readings beside the crossing.
struct Curve
{
    std::vector<BesideCrossing> const& readings;
    AtCrossing value;
    double far;

    [[nodiscard]] Eigen::Index count() const { return std::ssize(readings); }

    /// Angles at the crossing.
    [[nodiscard]] Eigen::Index sides() const { return value == AtCrossing::jump ? 2 : 1; }

    /// Readings of the first side.
    [[nodiscard]] Eigen::Index first() const
    {
        return value == AtCrossing::jump ? std::ranges::count_if(readings, [](auto const& p) { return p.distance < 0; })
                                         : count();
    }

    /// Readings of the side that has least.
    [[nodiscard]] Eigen::Index fewest() const
    {
        return value == AtCrossing::jump ? std::min(first(), count() - first()) : count();
    }

    /// A power of the distances, the same of both sides but for its sign.
    [[nodiscard]] Eigen::VectorXd power(int degree) const
    {
        Eigen::VectorXd column(count());
        for (Eigen::Index i = 0; i < count(); ++i) {
            double const share = readings[static_cast<std::size_t>(i)].distance / far;
            column[i] = std::copysign(std::pow(std::abs(share), degree), share);
        }
        return column;
    }

    [[nodiscard]] Eigen::MatrixXd columns(int degree) const
    {
        Eigen::MatrixXd result = Eigen::MatrixXd::Zero(count(), sides() + degree);
        result.col(0).head(first()).setOnes();
        result.col(sides() - 1).tail(count() - first()).setOnes();
        for (int each = 1; each <= degree; ++each)
            result.col(sides() + each - 1) = power(each);
        return result;
    }

    [[nodiscard]] Eigen::VectorXd angles() const
    {
        Eigen::VectorXd column(count());
        for (Eigen::Index i = 0; i < count(); ++i)
            column[i] = readings[static_cast<std::size_t>(i)].angle;
        return column;
    }

    /// The value as a sum of the coefficients.
    [[nodiscard]] Eigen::VectorXd wanted(int degree) const
    {
        Eigen::VectorXd result = Eigen::VectorXd::Zero(sides() + degree);
        result[0] = -1;
        result[sides() - 1] = 1;
        return result;
    }
};

/// The part of @p value that is beyond @p deviations of its standard error.
double beyond(double value, double error, double deviations)
{
    return std::sqrt(std::max(0.0, value * value - deviations * deviations * error * error));
}

}  // namespace

ByCurve extrapolations(CrossingReadings const& readings, AtCrossing wanted, double far, Noise const& noise)
{
    // A parabola through three readings has no residuals, so that its angle at the crossing wants one more.
    Eigen::Index const of_line = 2, of_bend = wanted == AtCrossing::jump ? 2 : 3,
                       of_parabola = wanted == AtCrossing::jump ? 2 : 4;
    Curve const near{readings.near, wanted, far}, farther{readings.farther, wanted, far};
    ByCurve values;
    if (near.fewest() < of_line)
        return values;
    values.push_back(fitted(near.columns(1), near.angles(), near.wanted(1), noise));
    if (farther.fewest() < of_bend)
        return values;
    double const off = fitted(near.columns(1), near.power(2), near.wanted(1), {}).value;
    Eigen::VectorXd curvature = Eigen::VectorXd::Zero(farther.sides() + 2);
    curvature[farther.sides() + 1] = -off;
    values.push_back(fitted(farther.columns(2), farther.angles(), curvature, noise));
    if (near.fewest() >= of_parabola)
        values.push_back(fitted(near.columns(2), near.angles(), near.wanted(2), noise));
    return values;
}

std::vector<Estimate> means_of(std::vector<ByCurve> const& branches)
{
    std::vector<Estimate> means;
    std::size_t const ways = branches.empty() ? 0 : std::ranges::min(branches, {}, &ByCurve::size).size();
    for (std::size_t i = 0; i < ways; ++i) {
        std::vector<Found> values;
        for (ByCurve const& branch : branches)
            values.push_back(branch[i]);
        means.push_back(mean_of(values));
    }
    return means;
}

Estimate extrapolated(std::vector<Estimate> const& by_curve)
{
    constexpr double growth = 3;       // of the curvature towards zero torque, at most
    constexpr double least_ratio = 2;  // of the errors of parabola and line, over distances from 1 to 6 and less
    constexpr double left = 2;         // of the growth of the curvature, by a parabola
    constexpr double by_chance = 1.5;  // standard errors
    Estimate result = by_curve[line];
    if (by_curve.size() <= bend)
        return result;
    double const expected = beyond(by_curve[bend].value, by_curve[bend].error, 1);
    if (by_curve.size() <= parabola) {
        result.error = std::hypot(result.error, left * expected);
        return result;
    }
    double const difference = by_curve[parabola].value - result.value, size = std::abs(difference);
    double const of_parabola = std::max(by_curve[parabola].error, least_ratio * result.error);
    double const variance = of_parabola * of_parabola - result.error * result.error;
    double const prior = growth * growth * expected * expected;
    double const share = prior > 0 ? prior / (prior + variance) : 0;
    result.value += share * difference;
    result.error = std::sqrt(result.error * result.error + share * variance);
    if (size > 0) {
        double const farther = std::copysign(by_curve[bend].value, difference * by_curve[bend].value);
        double const remains = std::max(size, left * (size - std::max(0.0, farther)));
        result.error = std::hypot(result.error, remains * beyond(size, std::sqrt(variance), by_chance) / size);
    }
    return result;
}

}  // namespace hdconj::rig
