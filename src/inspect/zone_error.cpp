// SPDX-License-Identifier: GPL-3.0-or-later
#include "zone_error.hpp"

#include <algorithm>
#include <boost/random/mersenne_twister.hpp>
#include <boost/random/normal_distribution.hpp>
#include <map>
#include <vector>

#include "hdconj/base/parallel.hpp"
#include "registration.hpp"

namespace hdconj::inspect {

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
    constexpr std::ptrdiff_t percentile = 380;  // of the sizes in growing order, 0.95 (400 + 1)
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
        std::nth_element(sizes.begin(), sizes.begin() + percentile, sizes.end());
        found.half_width[k] = sizes[percentile];
    }
    return found;
}

}  // namespace hdconj::inspect
