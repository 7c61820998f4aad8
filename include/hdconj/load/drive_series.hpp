// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Displacements of an elastic drive's stations, as series around the ring.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "hdconj/load/elastic_drive.hpp"

namespace hdconj {

/// Displacement series of all stations under these forces, as PointResponse::series gives it.
[[nodiscard]] std::vector<std::vector<double>> displacements(ElasticDrive const& drive, Eigen::MatrixXd const& forces, int threads = 1);

/// Value of a series of `drive` at an angle, and its derivative.
struct SeriesValue
{
    double value = 0, slope = 0;
};
[[nodiscard]] SeriesValue series_at(ElasticDrive const& drive, std::vector<double> const& series, double phi);

/// cos and sin of all harmonics of `drive` at an angle, for several series there.
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

}  // namespace hdconj
