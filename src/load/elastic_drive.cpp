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
    int const grid = drive.response.grid(), at = c.tooth * drive.steps_per_tooth % grid;
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
    std::vector<BearingNode> const nodes = bearing_nodes(drive);
    auto const count = static_cast<Index>(nodes.size());
    Eigen::MatrixXd g(count, count);
    constexpr std::size_t grain = 16;
    parallel_for(nodes.size(), threads, grain, [&](std::size_t col) {
        auto const j = static_cast<Index>(col);
        BearingNode const& q = nodes[col];
        for (Index i = j; i < count; ++i) {
            BearingNode const& p = nodes[static_cast<std::size_t>(i)];
            g(i, j) = drive.response(p.height, q.height, p.at - q.at);
            if (drive.outer_ring)
                g(i, j) += (*drive.outer_ring)(p.height, q.height, p.at - q.at);
            if (drive.between_balls)
                g(i, j) += (*drive.between_balls)(i, j);
        }
    });
    parallel_for(nodes.size(), threads, grain, [&](std::size_t col) {
        auto const j = static_cast<Index>(col);
        g.col(j).head(j) = g.row(j).head(j);
    });
    return numeric::shared_compliance(std::move(g), threads);
}

std::vector<std::vector<double>> displacements(ElasticDrive const& drive, Eigen::MatrixXd const& forces, int threads)
{
    std::vector<std::size_t> all(drive.stations.count());
    std::iota(all.begin(), all.end(), std::size_t{0});
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
