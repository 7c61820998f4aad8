// SPDX-License-Identifier: GPL-3.0-or-later
#include "elastic_drive.hpp"

#include <cmath>
#include <numeric>
#include <utility>

#include "hdconj/base/parallel.hpp"
#include "numeric/compliance.hpp"

namespace hdconj::load {
Footing footing(ElasticDrive const& drive, FlankContact const& c)
{
    DriveStations const& s = drive.stations;
    int const grid = drive.response->grid(), at = c.tooth * drive.steps_per_tooth % grid;
    return {
        at < 0 ? at + grid : at, {s.radial(c.slice), s.tangential(c.slice), s.turn(c.slice)}, {c.c_r, c.c_t, c.c_turn}};
}

std::vector<BearingNode> bearing_nodes(ElasticDrive const& drive)
{
    std::vector<BearingNode> nodes;
    for (std::size_t w = 0; w < drive.bearing_steps.size(); ++w)
        for (std::size_t j = 0; j < drive.stations.bearing; ++j)
            nodes.push_back({j, w, drive.bearing_steps[w]});
    return nodes;
}

using Eigen::Index;

std::shared_ptr<Eigen::MatrixXd const> bearing_compliance(ElasticDrive const& drive, int threads)
{
    auto const heights = static_cast<Index>(drive.stations.bearing);
    auto const places = static_cast<std::size_t>(drive.response->grid());
    // between all heights, this many steps of the grid apart
    std::vector<Eigen::MatrixXd> apart(places, Eigen::MatrixXd(heights, heights));
    for (std::size_t a = 0; a < drive.stations.bearing; ++a)
        for (std::size_t b = 0; b < drive.stations.bearing; ++b)
            for (std::size_t place = 0; place < places; ++place)
                apart[place](static_cast<Index>(a), static_cast<Index>(b)) =
                    drive.response->at(a, b, place) + (drive.outer_ring ? drive.outer_ring->at(a, b, place) : 0);
    std::size_t const angles = drive.bearing_steps.size();
    auto const count = heights * static_cast<Index>(angles);
    Eigen::MatrixXd g(count, count);
    constexpr std::size_t grain = 4;
    parallel_for(angles, threads, grain, [&](std::size_t j) {
        for (std::size_t i = 0; i < angles; ++i)
            g.block(static_cast<Index>(i) * heights, static_cast<Index>(j) * heights, heights, heights) =
                apart[drive.response->place(drive.bearing_steps[i] - drive.bearing_steps[j])];
    });
    if (drive.between_balls)
        g += *drive.between_balls;
    return numeric::shared_compliance(std::move(g), threads);
}

std::vector<std::vector<double>> displacements(ElasticDrive const& drive, Eigen::MatrixXd const& forces, int threads)
{
    std::vector<std::size_t> all(drive.stations.count());
    std::iota(all.begin(), all.end(), std::size_t{0});
    return drive.response->series(forces, drive.phase, all, threads);
}

SeriesPlace::SeriesPlace(ElasticDrive const& drive, double phi)
{
    int const sectors = drive.response->sectors();
    double const cosine = std::cos(sectors * phi), sine = std::sin(sectors * phi);
    waves_.reserve(drive.response->harmonics().size());
    double c = 1, s = 0;  // of n phi
    int n = 0;
    for (HarmonicResponse const& h : drive.response->harmonics()) {
        for (; n < h.n; n += sectors) {
            double const next = s * cosine + c * sine;
            c = c * cosine - s * sine;
            s = next;
        }
        waves_.push_back({static_cast<double>(n), c, s});
    }
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
