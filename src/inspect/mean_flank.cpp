// SPDX-License-Identifier: GPL-3.0-or-later
#include "mean_flank.hpp"

#include <algorithm>
#include <utility>

#include "hdconj/base/rigid_motion.hpp"
#include "hdconj/numeric/bracketed_root.hpp"
#include "numeric/least_squares.hpp"

namespace hdconj::inspect {
namespace {

constexpr int terms = 6;         // of the polynomial
constexpr int even_steps = 160;  // along the flank: a spline through them keeps within nanometres

Eigen::RowVectorXd powers_of(double xi)
{
    Eigen::RowVectorXd powers(terms);
    double power = 1;
    for (double& each : powers) {
        each = power;
        power *= xi;
    }
    return powers;
}

/// What the flanks of the first plane have in common.
struct MeanDeviation
{
    Eigen::VectorXd coefficient;  ///< of the powers of xi
    double half_excess = 0;       ///< turn of the right flank that gives the mean thickness [rad]
    bool both_sides = false;
};

MeanDeviation mean_deviation(RingData const& data)
{
    std::vector<double> xi, deviation;
    double turn[2] = {0, 0};
    int count[2] = {0, 0};
    for (FlankFit const& fit : data.fits) {
        if (fit.group.plane != 0)
            continue;
        double const length = data.part().planes[0].flank(fit.group.right).length();
        for (double const s : fit.parabola.arc_length)
            xi.push_back(2 * s / length - 1);
        deviation.insert(deviation.end(), fit.parabola.deviation.begin(), fit.parabola.deviation.end());
        turn[fit.group.right ? 1 : 0] += fit.turn;
        ++count[fit.group.right ? 1 : 0];
    }
    MeanDeviation mean;
    mean.both_sides = count[0] > 0 && count[1] > 0;
    if (!mean.both_sides)
        return mean;
    mean.half_excess = (turn[1] / count[1] - turn[0] / count[0]) / 2;
    auto const n = static_cast<Eigen::Index>(xi.size());
    Eigen::MatrixXd basis(n, terms);
    for (Eigen::Index i = 0; i < n; ++i)
        basis.row(i) = powers_of(xi[static_cast<std::size_t>(i)]);
    mean.coefficient = numeric::LeastSquares(basis).solve(Eigen::VectorXd(Eigen::VectorXd::Map(deviation.data(), n)));
    return mean;
}

/// The mean flank as a curve of the arc length of the nominal one.
class MeanCurve
{
  public:
    MeanCurve(RingData const& data, MeanDeviation mean)
        : flank_(data.part().planes[0].right),
          seat_(0, data.part().seat),
          mean_(std::move(mean)),
          frame_(data.part().frame)
    {
    }

    [[nodiscard]] Vec2 operator()(double s) const
    {
        auto const [point, normal] = flank_.at(s);
        double const deviation = powers_of(2 * s / flank_.length() - 1) * mean_.coefficient;
        return frame_.inverse(turned_clockwise(point + deviation * normal + seat_, mean_.half_excess));
    }
    /// The nominal height of an end.
    [[nodiscard]] double height(double s) const { return frame_.inverse(flank_.at(s).point + seat_).y(); }

    /// The arc length at which the curve is at the nominal height of the end @p s: that of the end where it does not
    /// reach it.
    [[nodiscard]] double reached(double s) const
    {
        double const inside = s > 0 ? s - step() : step(), y = height(s);
        auto const found = numeric::bracketed_root([&](double at) { return (*this)(at).y() - y; }, std::min(s, inside),
                                                   std::max(s, inside));
        return found.found ? found.x : s;
    }
    /// The point at the height @p y of the straight continuation from @p s.
    [[nodiscard]] Vec2 continued(double s, double y) const
    {
        Vec2 const end = (*this)(s), along = frame_.rotate_back(right_of(flank_.at(s).normal));
        return end + (y - end.y()) / along.y() * along;
    }
    [[nodiscard]] double step() const { return flank_.length() / even_steps; }
    [[nodiscard]] NominalFlank const& flank() const { return flank_; }

  private:
    NominalFlank const& flank_;
    Vec2 seat_;
    MeanDeviation mean_;
    Pose frame_;
};

}  // namespace

std::vector<Vec2> mean_flank(RingData const& data)
{
    MeanDeviation mean = mean_deviation(data);
    if (!mean.both_sides)
        return {};
    MeanCurve const curve(data, std::move(mean));
    double const length = curve.flank().length(), root = curve.reached(0), tip = curve.reached(length);
    std::vector<double> places = curve.flank().joints();
    for (int i = 1; i < even_steps; ++i)
        places.push_back(length * i / even_steps);
    std::sort(places.begin(), places.end());
    std::vector<Vec2> points{curve.continued(root, curve.height(0))};
    double const apart = curve.step() / 4;
    double before = root;
    for (double const s : places) {
        if (s - before < apart || tip - s < apart)
            continue;
        points.push_back(curve(s));
        before = s;
    }
    points.push_back(curve.continued(tip, curve.height(length)));
    std::reverse(points.begin(), points.end());
    return points;  // from tip to root, as the family "points" has them
}

}  // namespace hdconj::inspect
