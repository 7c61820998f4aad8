// SPDX-License-Identifier: GPL-3.0-or-later
// The registration of least largest deviation.
//
// Near a placement the deviations are linear in the step x of the unknowns, and the least largest deviation t is the
// solution of a linear program: minimise t where s (d + J x) <= t for every row, s = 1 and -1. The dual simplex method
// solves it. Its basis is one constraint more than there are unknowns, the references, on which the deviations are
// equal in size. The constraint that is violated most replaces the reference whose multiplier falls to 0 first, so that
// t grows with each exchange. Placement by placement the program is solved again until its steps are roundings.
#include <algorithm>
#include <boost/random/mersenne_twister.hpp>
#include <boost/random/normal_distribution.hpp>
#include <cmath>
#include <limits>
#include <map>
#include <utility>
#include <vector>

#include "hdconj/base/parallel.hpp"
#include "hdconj/error.hpp"
#include "numeric/dense.hpp"
#include "numeric/least_squares.hpp"
#include "numeric/quantile.hpp"
#include "registration.hpp"

namespace hdconj::inspect {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// One constraint s (d + J x) <= t.
struct Reference
{
    Index row;
    double sign;
};

[[noreturn]] void refuse_endless(char const* what)
{
    throw NumericalError(ErrorCode::not_converged, "registration", "minimum zone", what,
                         "write --register least-squares");
}

/// As a row (s J, -1) of the matrix of constraints.
VectorXd constraint_of(MatrixXd const& rows, Reference const& at)
{
    VectorXd constraint(rows.cols() + 1);
    constraint << at.sign * rows.row(at.row).transpose(), -1;
    return constraint;
}

/// References with multipliers that are not negative: rows of full rank and one more, with the signs of the weights
/// that sum them to 0.
std::vector<Reference> first_references(MatrixXd const& rows)
{
    Index const n = rows.cols();
    numeric::LeastSquares const independent(rows.transpose());
    MatrixXd chosen(n, n);
    for (Index i = 0; i < n; ++i)
        chosen.col(i) = rows.row(independent.chosen(i)).transpose();
    VectorXd weight(n + 1);
    weight << numeric::LU(chosen).solve(-rows.row(independent.chosen(n)).transpose()), 1;
    std::vector<Reference> first;
    for (Index i = 0; i <= n; ++i)
        first.push_back({independent.chosen(i), weight[i] < 0 ? -1.0 : 1.0});
    return first;
}

/// The reference that leaves when @p entering becomes one.
std::size_t leaving(numeric::LU const& transposed, VectorXd const& entering)
{
    Index const size = entering.size();
    VectorXd const multiplier = transposed.solve(-VectorXd::Unit(size, size - 1));
    VectorXd const rate = transposed.solve(entering);
    std::size_t leaves = 0;
    double least = std::numeric_limits<double>::infinity();
    for (Index i = 0; i < size; ++i) {
        double const ratio = std::max(0.0, multiplier[i]) / rate[i];
        if (rate[i] > 64 * unit_roundoff && ratio < least) {
            least = ratio;
            leaves = static_cast<std::size_t>(i);
        }
    }
    return leaves;
}

double largest_size(std::vector<PointView> const& views)
{
    double largest = 0;
    for (PointView const& view : views)
        largest = std::max(largest, std::abs(view.deviation));
    return largest;
}

VectorXd deviations_of(std::vector<PointView> const& views)
{
    VectorXd deviations(static_cast<Index>(views.size()));
    for (std::size_t i = 0; i < views.size(); ++i)
        deviations[static_cast<Index>(i)] = views[i].deviation;
    return deviations;
}

}  // namespace

VectorXd chebyshev_step(MatrixXd const& rows, VectorXd const& deviations)
{
    constexpr int most_exchanges = 1000;
    Index const n = rows.cols();
    if (rows.rows() <= n)
        return numeric::LeastSquares(rows).solve(VectorXd(-deviations));
    std::vector<Reference> at = first_references(rows);
    for (int exchange = 0; exchange < most_exchanges; ++exchange) {
        MatrixXd transposed(n + 1, n + 1);
        VectorXd right(n + 1);
        for (Index i = 0; i <= n; ++i) {
            Reference const& each = at[static_cast<std::size_t>(i)];
            transposed.col(i) = constraint_of(rows, each);
            right[i] = -each.sign * deviations[each.row];
        }
        VectorXd const solution = numeric::LU(transposed.transpose()).solve(right);
        VectorXd const left_over = deviations + rows * solution.head(n);
        // steps of a part that hardly fixes them are far larger than what they leave
        double const rounding =
            64 * unit_roundoff * (deviations.cwiseAbs() + rows.cwiseAbs() * solution.head(n).cwiseAbs()).maxCoeff();
        Index worst = 0;
        double const largest = left_over.cwiseAbs().maxCoeff(&worst);
        if (largest <= solution[n] + rounding)
            return solution.head(n);
        Reference const entering{worst, left_over[worst] < 0 ? -1.0 : 1.0};
        at[leaving(numeric::LU(transposed), constraint_of(rows, entering))] = entering;
    }
    refuse_endless("the exchange of references does not end");
}

Placement minimum_zone(Registered const& what, Placement near)
{
    constexpr int most_programs = 100, most_halvings = 40;
    NominalPart const& part = what.read.part();
    std::vector<PointView> views = views_of(what.read, what.points, near, what.threads);
    double largest = largest_size(views);
    for (int program = 0; program < most_programs; ++program) {
        VectorXd step = chebyshev_step(jacobian(views, near, part, most_unknowns), deviations_of(views));
        bool lower = false;
        for (int halving = 0; halving < most_halvings && !lower; ++halving) {
            if (step.norm() <= part.tolerance().roundoff())
                return near;
            Placement const next = moved(near, step, part);
            auto next_views = views_of(what.read, what.points, next, what.threads);
            lower = largest_size(next_views) < largest;
            if (lower) {
                near = next;
                views = std::move(next_views);
                largest = largest_size(views);
            }
            step /= 2;
        }
        if (!lower)
            return near;
    }
    refuse_endless("the steps do not come to an end");
}

Eigen::VectorXd without_noise(std::vector<std::size_t> const& points, std::vector<PointView> const& views,
                              std::vector<FlankFit> const& fits, double noise)
{
    constexpr double coefficients = 3;
    std::map<std::size_t, double> remainder;
    double squares = 0, freedom = 0;
    for (FlankFit const& fit : fits) {
        freedom += static_cast<double>(fit.parabola.points.size()) - coefficients;
        for (std::size_t i = 0; i < fit.parabola.points.size(); ++i) {
            remainder[fit.parabola.points[i]] = fit.parabola.remainder[i];
            squares += fit.parabola.remainder[i] * fit.parabola.remainder[i];
        }
    }
    double const share = squares > 0 ? std::min(1.0, freedom * noise * noise / squares) : 0;
    Eigen::VectorXd smooth(static_cast<Eigen::Index>(points.size()));
    for (std::size_t i = 0; i < points.size(); ++i) {
        auto const found = remainder.find(points[i]);
        smooth[static_cast<Eigen::Index>(i)] =
            views[i].deviation - (found == remainder.end() ? 0 : share * found->second);
    }
    return smooth;
}

ZoneError zone_error(Eigen::MatrixXd const& rows, Eigen::VectorXd const& smooth, double noise, int threads)
{
    constexpr std::size_t repeats = 400;
    constexpr double covered = 0.95;
    Eigen::Vector3d const centre = chebyshev_step(rows, smooth);
    std::vector<Eigen::Vector3d> errors(repeats);
    parallel_for(repeats, threads, 1, [&](std::size_t i) {
        boost::random::mt19937_64 engine(i);
        boost::random::normal_distribution<double> normal(0, noise);
        Eigen::VectorXd noisy = smooth;
        for (double& each : noisy)
            each += normal(engine);
        errors[i] = chebyshev_step(rows, noisy) - centre;
    });
    ZoneError found;
    for (Eigen::Vector3d const& error : errors)
        found.covariance += error * error.transpose() / static_cast<double>(repeats);
    for (Eigen::Index k = 0; k < most_unknowns; ++k) {
        std::vector<double> sizes;
        for (Eigen::Vector3d const& error : errors)
            sizes.push_back(std::abs(error[k]));
        found.half_width[k] = numeric::quantile(std::move(sizes), covered);
    }
    return found;
}

}  // namespace hdconj::inspect
