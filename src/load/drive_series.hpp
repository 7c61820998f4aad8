// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Displacements of the stations of an elastic drive as series around the ring.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "elastic_drive.hpp"

namespace hdconj::load {

/// Displacement series of all stations under these forces, as PointResponse::series gives it.
[[nodiscard]] std::vector<std::vector<double>> displacements(ElasticDrive const& drive, Eigen::MatrixXd const& forces,
                                                             int threads = 1);

/// Value and derivative of a series of an elastic drive at an angle.
struct SeriesValue
{
    double value = 0, slope = 0;
};
[[nodiscard]] SeriesValue series_at(ElasticDrive const& drive, std::vector<double> const& series, double phi);

/// Cosine and sine of all harmonics of an elastic drive at an angle, to evaluate several series there.
struct SeriesPlace
{
    SeriesPlace(ElasticDrive const& drive, double phi);

    [[nodiscard]] SeriesValue operator()(std::vector<double> const& series) const;

  private:
    struct Wave
    {
        double n, cosine, sine;
    };
    std::vector<Wave> waves_;
};

}  // namespace hdconj::load
