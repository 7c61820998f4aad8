// SPDX-License-Identifier: GPL-3.0-or-later
// The mean flank of the measured teeth, as points of a tooth.

#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "hdconj/base/rigid_motion.hpp"
#include "hdconj/numeric/bracketed_root.hpp"
#include "numeric/least_squares.hpp"
#include "ring_figures.hpp"

namespace hdconj::inspect {
namespace {

constexpr int most_terms = 6;    // of the polynomial
constexpr int least_terms = 3;   // slope and crowning are figures of the teeth, and stay
constexpr int even_steps = 160;  // along the flank: a spline through them keeps within nanometres

/// Powers of xi, columns of a matrix.
Eigen::MatrixXd powers_of(Eigen::VectorXd const& xi, int terms)
{
    Eigen::MatrixXd powers(xi.size(), terms);
    powers.col(0).setOnes();
    for (Eigen::Index k = 1; k < terms; ++k)
        powers.col(k) = powers.col(k - 1).cwiseProduct(xi);
    return powers;
}

/// Coefficients of the powers of @p xi that fit @p deviation best: of the highest degree whose term noise does not
/// explain.
Eigen::VectorXd smoothed(Eigen::VectorXd const& xi, Eigen::VectorXd const& deviation)
{
    constexpr double by_chance = 1e-3;  // of two sides: so rarely does noise alone make a term
    auto const n = static_cast<int>(xi.size());
    int terms = std::min(most_terms, n - 1);
    Eigen::MatrixXd const basis = powers_of(xi, terms);
    Eigen::VectorXd coefficient = numeric::LeastSquares(basis).solve(deviation);
    int const freedom = n - terms;
    double const noise = (deviation - basis * coefficient).norm() / std::sqrt(freedom);
    double const limit = noise * gsl_cdf_tdist_Qinv(by_chance / 2, freedom);
    while (terms > least_terms) {
        Eigen::MatrixXd const shorter = basis.leftCols(terms);
        // with the lower terms free, the highest is that of the orthogonal polynomials: independent of the others
        double const variance = numeric::covariance(shorter)(terms - 1, terms - 1);
        if (std::abs(coefficient[terms - 1]) > limit * std::sqrt(variance))
            break;
        --terms;
        coefficient = numeric::LeastSquares(basis.leftCols(terms)).solve(deviation);
    }
    return coefficient;
}

/// What the flanks of the first plane have in common.
struct MeanDeviation
{
    Eigen::VectorXd coefficient;  ///< of the powers of xi
    double first = 0, last = 0;   ///< xi of the points nearest to the ends
    double half_excess = 0;       ///< turn of the right flank that gives the mean thickness [rad]
    bool both_sides = false;

    /// At @p xi; beyond the points the parabola that continues it, because higher terms soon run away there.
    [[nodiscard]] double at(double xi) const
    {
        double const inside = std::clamp(xi, first, last), beyond = xi - inside;
        double value = 0, slope = 0, bend = 0;
        for (Eigen::Index k = coefficient.size(); k-- > 0;) {
            bend = bend * inside + slope;
            slope = slope * inside + value;
            value = value * inside + coefficient[k];
        }
        return value + beyond * (slope + beyond * bend);
    }
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
    auto const [first, last] = std::ranges::minmax(xi);
    mean.first = first;
    mean.last = last;
    mean.coefficient = smoothed(Eigen::VectorXd::Map(xi.data(), n), Eigen::VectorXd::Map(deviation.data(), n));
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
        double const deviation = mean_.at(2 * s / flank_.length() - 1);
        return frame_.inverse(turned_clockwise(point + deviation * normal + seat_, mean_.half_excess));
    }
    /// Where the curve ends: at the nominal height of the end @p s. A flank that is cut or continued by more than a
    /// step for that is almost level there, and keeps its own end.
    struct End
    {
        double s = 0;  ///< arc length up to which the curve is followed
        Vec2 point = Vec2::Zero();
    };
    [[nodiscard]] End end(double s) const
    {
        double const y = frame_.inverse(flank_.at(s).point + seat_).y(), inside = s > 0 ? s - step() : step();
        auto const found = numeric::bracketed_root([&](double at) { return (*this)(at).y() - y; }, std::min(s, inside),
                                                   std::max(s, inside));
        if (found.found)
            return {found.x, (*this)(found.x)};
        Vec2 const last = (*this)(s), beyond = last - (*this)(inside);
        Vec2 along = frame_.rotate_back(right_of(flank_.at(s).normal));
        if (along.dot(beyond) < 0)
            along = -along;
        double const by = (y - last.y()) / along.y();
        return {s, 0 <= by && by <= step() ? Vec2(last + by * along) : last};
    }
    [[nodiscard]] double step() const { return flank_.length() / even_steps; }
    [[nodiscard]] NominalFlank const& flank() const { return flank_; }

  private:
    NominalFlank const& flank_;
    Vec2 seat_;
    MeanDeviation mean_;
    Pose frame_;
};

/// Leaves out what is beyond the highest and the lowest point: an end that is almost level may bend back by its
/// deviations.
void cut_at_summits(std::vector<Vec2>& points)
{
    auto const [lowest, highest] = std::ranges::minmax_element(points, {}, [](Vec2 const& p) { return p.y(); });
    if (highest < lowest)
        points = std::vector<Vec2>(highest, lowest + 1);
}

}  // namespace

std::vector<Vec2> mean_flank(RingData const& data)
{
    MeanDeviation mean = mean_deviation(data);
    if (!mean.both_sides)
        return {};
    MeanCurve const curve(data, std::move(mean));
    double const length = curve.flank().length(), apart = curve.step() / 4;
    auto const root = curve.end(0), tip = curve.end(length);
    std::vector<double> places = curve.flank().joints();
    for (int i = 1; i < even_steps; ++i)
        places.push_back(length * i / even_steps);
    std::sort(places.begin(), places.end());
    std::vector<Vec2> points{root.point};
    double before = root.s;
    for (double const s : places) {
        if (s - before < apart || tip.s - s < apart)
            continue;
        points.push_back(curve(s));
        before = s;
    }
    points.push_back(tip.point);
    std::reverse(points.begin(), points.end());
    cut_at_summits(points);
    return points;  // from tip to root, as the family "points" has them
}

}  // namespace hdconj::inspect
