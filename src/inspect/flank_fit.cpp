// SPDX-License-Identifier: GPL-3.0-or-later
#include "flank_fit.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "hdconj/base/rigid_motion.hpp"
#include "hdconj/error.hpp"
#include "numeric/least_squares.hpp"

namespace hdconj::inspect {
namespace {

/// Residuals beyond so many standard deviations, taken from their median size, are no noise: once in 5e8 points.
constexpr double stray_deviations = 6;
constexpr double median_of_normal = 0.6745;  // of the size of a normal variable, in standard deviations
/// Below this no point is called a stray [mm]: finer than any probe repeats.
constexpr double least_stray = 2e-3;
constexpr double least_weight = 1e-6;  // of a size among the weights: rounds then end at the points that are met
constexpr int most_turns = 60;

struct SortedViews
{
    std::vector<std::size_t> points;
    std::vector<PointView> views;
    std::vector<double> arc_length;
};

/// The points whose feet are on the flank, by rising arc length.
SortedViews sorted_views(PointReader const& read, std::vector<PlanePoint> const& points, FlankGroup const& group,
                         Placement const& placement)
{
    NominalFlank const& flank = read.part().planes[group.plane].flank(group.right);
    SortedViews all;
    for (std::size_t const i : group.points) {
        PointView const view = read.on_flank(points[i], placement, group.tooth, group.right);
        if (!view.on)
            continue;
        all.points.push_back(i);
        all.views.push_back(view);
        all.arc_length.push_back(flank.arc_length(view.foot));
    }
    std::vector<std::size_t> order(all.points.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return all.arc_length[a] < all.arc_length[b]; });
    SortedViews sorted;
    for (std::size_t const i : order) {
        sorted.points.push_back(all.points[i]);
        sorted.views.push_back(all.views[i]);
        sorted.arc_length.push_back(all.arc_length[i]);
    }
    return sorted;
}

/// What the parabola of least sum of sizes leaves of the deviations: strays do not draw it to themselves. By weights
/// that are the reciprocal sizes of the remainders.
std::vector<double> robust_remainders(FlankParabola const& parabola, double length)
{
    constexpr int rounds = 30;
    auto const n = static_cast<Eigen::Index>(parabola.points.size());
    Eigen::MatrixXd basis(n, 3);
    Eigen::VectorXd const deviation = Eigen::VectorXd::Map(parabola.deviation.data(), n);
    Eigen::VectorXd remainder = Eigen::VectorXd::Map(parabola.remainder.data(), n);
    for (Eigen::Index i = 0; i < n; ++i) {
        double const xi = 2 * parabola.arc_length[static_cast<std::size_t>(i)] / length - 1;
        basis.row(i) << 1, xi, xi * xi;
    }
    for (int round = 0; round < rounds; ++round) {
        double const least = std::max(remainder.cwiseAbs().maxCoeff() * least_weight, unit_roundoff * length);
        Eigen::VectorXd const root = remainder.cwiseAbs().cwiseMax(least).cwiseInverse().cwiseSqrt();
        Eigen::VectorXd const fitted =
            numeric::LeastSquares(root.asDiagonal() * basis).solve(Eigen::VectorXd(root.cwiseProduct(deviation)));
        remainder = deviation - basis * fitted;
    }
    return {remainder.data(), remainder.data() + n};
}

/// Index of the stray that is furthest off, if there is any.
std::optional<std::size_t> stray_of(FlankParabola const& parabola, double length)
{
    double largest = 0;
    for (double const each : parabola.remainder)
        largest = std::max(largest, std::abs(each));
    if (parabola.points.size() <= fewest_points || largest <= least_stray)
        return std::nullopt;
    std::vector<double> size = robust_remainders(parabola, length);
    std::transform(size.begin(), size.end(), size.begin(), [](double r) { return std::abs(r); });
    auto const worst = static_cast<std::size_t>(std::max_element(size.begin(), size.end()) - size.begin());
    double const furthest = size[worst];
    // it meets three points: those say nothing of the others. Few points scatter more (Rousseeuw and Leroy 1987, 5.3)
    constexpr std::size_t met = 3;
    double const few = 1 + 5 / static_cast<double>(size.size() - met);
    auto const middle = size.begin() + static_cast<std::ptrdiff_t>(met + (size.size() - met) / 2);
    std::nth_element(size.begin(), middle, size.end());
    double const limit = std::max(least_stray, stray_deviations * few * *middle / median_of_normal);
    return furthest > limit ? std::optional(worst) : std::nullopt;
}

}  // namespace

std::optional<FlankParabola> flank_parabola(PointReader const& read, std::vector<PlanePoint> const& points,
                                            FlankGroup const& group, Placement const& placement)
{
    double const length = read.part().planes[group.plane].flank(group.right).length();
    SortedViews sorted = sorted_views(read, points, group, placement);
    auto const n = static_cast<Eigen::Index>(sorted.points.size());
    if (sorted.points.size() < fewest_points ||
        sorted.arc_length.back() - sorted.arc_length.front() < least_cover * length)
        return std::nullopt;
    Eigen::MatrixXd basis(n, 3), right(n, 4);
    for (Eigen::Index i = 0; i < n; ++i) {
        auto const k = static_cast<std::size_t>(i);
        PointView const& view = sorted.views[k];
        double const xi = 2 * sorted.arc_length[k] / length - 1;
        basis.row(i) << 1, xi, xi * xi;
        Vec2 const by_shift = -read.to_tooth(view.normal, group.tooth);
        right.row(i) << view.deviation, view.by_turn(), by_shift.x(), by_shift.y();
    }
    numeric::LeastSquares const fit(basis);
    if (fit.rank() < 3)
        return std::nullopt;
    Eigen::Matrix<double, 3, 4> const fitted = fit.solve(right);
    FlankParabola parabola;
    parabola.coefficient = fitted.col(0);
    parabola.by_turn = fitted.col(1);
    parabola.by_shift = fitted.rightCols<2>();
    parabola.covariance = numeric::covariance(basis);
    Eigen::VectorXd const remainder = right.col(0) - basis * parabola.coefficient;
    for (Eigen::Index i = 0; i < n; ++i) {
        parabola.deviation.push_back(right(i, 0));
        parabola.remainder.push_back(remainder[i]);
    }
    parabola.points = std::move(sorted.points);
    parabola.arc_length = std::move(sorted.arc_length);
    return parabola;
}

std::optional<FlankFit> flank_fit(PointReader const& read, std::vector<PlanePoint> const& points, FlankGroup group,
                                  Placement const& placement)
{
    NominalPlane const& plane = read.part().planes[group.plane];
    double const radius = plane.reference_radius, length = plane.flank(group.right).length();
    FlankFit fit;
    int turns = 0;
    for (;;) {
        auto const parabola = flank_parabola(read, points, group, {placement.turn + fit.turn, placement.shift});
        if (!parabola || parabola->by_turn[0] == 0)
            return std::nullopt;
        double const step = -parabola->coefficient[0] / parabola->by_turn[0];
        bool const at_rest = std::abs(step) * radius <= read.part().tolerance().roundoff();
        if (!at_rest && turns++ < most_turns) {
            fit.turn += step;
            continue;
        }
        auto const stray = stray_of(*parabola, length);
        if (!stray) {
            fit.parabola = *parabola;
            break;
        }
        std::size_t const gone = parabola->points[*stray];
        fit.strays.push_back(gone);
        group.points.erase(std::find(group.points.begin(), group.points.end(), gone));
        turns = 0;
    }
    group.points = fit.parabola.points;
    fit.group = std::move(group);
    // a = 0 ties the turn to a: b and c follow it
    Eigen::Matrix3d to_turn = Eigen::Matrix3d::Identity();
    Eigen::Vector3d const by_turn = fit.parabola.by_turn;
    to_turn.col(0) << -1 / by_turn[0], -by_turn[1] / by_turn[0], -by_turn[2] / by_turn[0];
    fit.by_coefficients = to_turn;
    fit.covariance = to_turn * fit.parabola.covariance * to_turn.transpose();
    return fit;
}

NoiseSum noise_of(FlankParabola const& parabola)
{
    constexpr double variance_of_second_difference = 6;
    auto const& r = parabola.remainder;
    auto const n = static_cast<Eigen::Index>(r.size());
    double const begin = parabola.arc_length.front(), length = parabola.arc_length.back() - begin;
    Eigen::MatrixX3d basis(n, 3);
    for (Eigen::Index i = 0; i < n; ++i) {
        double const xi = (parabola.arc_length[static_cast<std::size_t>(i)] - begin) / length;
        basis.row(i) << 1, xi, xi * xi;
    }
    Eigen::Matrix3d const covariance = numeric::covariance(basis);
    NoiseSum sum;
    double variance = 0;  // of all differences, for noise of variance 1: the parabola has taken its part of them
    for (Eigen::Index i = 1; i + 1 < n; ++i) {
        auto const k = static_cast<std::size_t>(i);
        double const difference = r[k - 1] - 2 * r[k] + r[k + 1];
        Eigen::RowVector3d const of_basis = basis.row(i - 1) - 2 * basis.row(i) + basis.row(i + 1);
        sum.squares += difference * difference;
        variance += variance_of_second_difference - of_basis * covariance * of_basis.transpose();
        ++sum.differences;
    }
    sum.squares *= static_cast<double>(sum.differences) / variance;
    return sum;
}

}  // namespace hdconj::inspect
