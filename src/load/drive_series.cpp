// SPDX-License-Identifier: GPL-3.0-or-later
#include "drive_series.hpp"

#include <cmath>

namespace hdconj::load {

std::vector<std::vector<double>> displacements(ElasticDrive const& drive, Eigen::MatrixXd const& forces, int threads)
{
    std::vector<std::size_t> all;
    for (std::size_t i = 0; i < drive.stations.count(); ++i)
        all.push_back(i);
    return drive.response.series(forces, drive.phase, all, threads);
}

SeriesPlace::SeriesPlace(ElasticDrive const& drive, double phi)
{
    waves_.reserve(drive.response.harmonics().size());
    for (HarmonicResponse const& h : drive.response.harmonics())
        waves_.push_back({static_cast<double>(h.n), std::cos(h.n * phi), std::sin(h.n * phi)});
}

SeriesValue SeriesPlace::operator()(std::vector<double> const& series) const
{
    SeriesValue at;
    for (std::size_t k = 0; k < waves_.size(); ++k) {
        Wave const& w = waves_[k];
        at.value += series[2 * k] * w.cosine + series[2 * k + 1] * w.sine;
        at.slope += w.n * (series[2 * k + 1] * w.cosine - series[2 * k] * w.sine);
    }
    return at;
}

SeriesValue series_at(ElasticDrive const& drive, std::vector<double> const& series, double phi)
{
    return SeriesPlace(drive, phi)(series);
}

}  // namespace hdconj::load
