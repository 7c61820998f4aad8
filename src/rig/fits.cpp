// SPDX-License-Identifier: GPL-3.0-or-later
#include "fits.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>

#include "cleaning.hpp"

namespace hdconj::rig {

double deviation_from_neighbours(Samples const& samples, std::vector<LoadBranch> const& branches)
{
    std::vector<double> differences;
    for (LoadBranch const& branch : branches) {
        std::vector<std::size_t> const at = by_torque(samples, branch);
        for (std::size_t k = 1; k + 1 < at.size(); ++k) {
            double const low = samples.torque[at[k - 1]], high = samples.torque[at[k + 1]];
            double const share = high > low ? (samples.torque[at[k]] - low) / (high - low) : 0.5;
            double const line = std::lerp(samples.twist[at[k - 1]], samples.twist[at[k + 1]], share);
            differences.push_back((samples.twist[at[k]] - line) /
                                  std::sqrt(1 + share * share + (1 - share) * (1 - share)));
        }
    }
    return differences.empty() ? 0 : deviation_of(std::move(differences));
}

namespace {

/// The part of an error that is not as that of independent readings, see fitted().
double by_rounding(Eigen::VectorXd const& angles, Eigen::VectorXd const& residuals, Eigen::VectorXd const& weights,
                   Noise const& noise, double error)
{
    double runs = 0;
    for (Eigen::Index i = 0; i < angles.size();) {
        double run = 0;
        double const first = angles[i];
        for (; i < angles.size() && std::abs(angles[i] - first) < noise.rounding; ++i)
            run += weights[i];
        runs += run * run;
    }
    constexpr double most = 0.9;
    double const after = residuals.head(residuals.size() - 1).dot(residuals.tail(residuals.size() - 1));
    double const alike = residuals.squaredNorm() > 0 ? std::clamp(after / residuals.squaredNorm(), 0.0, most) : 0;
    double const all_alike =
        noise.rounding * weights.lpNorm<1>();  // residuals are alike where the line does not fit too
    return std::hypot(noise.rounding * std::sqrt(runs),
                      std::min(all_alike, error * std::sqrt(2 * alike / (1 - alike))));
}

}  // namespace

Found fitted(Eigen::MatrixXd const& columns, Eigen::VectorXd const& angles, Eigen::VectorXd const& wanted,
             Noise const& noise)
{
    Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> const solver(columns);
    Eigen::VectorXd const weights = solver.pseudoInverse().transpose() * wanted;
    Eigen::VectorXd const residuals = angles - columns * solver.solve(angles);
    constexpr double like_residuals = 4;
    double const freedom = static_cast<double>(columns.rows() - solver.rank());
    double const variance =
        (residuals.squaredNorm() + like_residuals * noise.deviation * noise.deviation) / (freedom + like_residuals);
    double const error = std::sqrt(variance) * weights.norm();
    return {weights.dot(angles), error, noise.rounding > 0 ? by_rounding(angles, residuals, weights, noise, error) : 0};
}

}  // namespace hdconj::rig
