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
    FlankFit fit;
    int turns = 0;
    for (;;) {
        auto const parabola = flank_parabola(read, points, group, {placement.turn + fit.turn, placement.shift});
        if (!parabola || parabola->by_turn[0] == 0)
            return std::nullopt;
        double const step = -parabola->coefficient[0] / parabola->by_turn[0];
        bool const at_rest = std::abs(step) * plane.reference_radius <= read.part().tolerance().roundoff();
        if (!at_rest && turns++ < most_turns) {
            fit.turn += step;
            continue;
        }
        fit.parabola = *parabola;
        break;
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
