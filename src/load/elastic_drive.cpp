// SPDX-License-Identifier: GPL-3.0-or-later
#include "elastic_drive.hpp"

#include "contact_places.hpp"
#include "hdconj/base/parallel.hpp"

namespace hdconj::load {

using Eigen::Index;

Eigen::MatrixXd bearing_compliance(ElasticDrive const& drive, int threads)
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
    return g;
}

LineContact ElasticDrive::line_contact(FlankContact const& c) const
{
    return {flexspline, circular_spline, c.curvature, contact_depth};
}

}  // namespace hdconj::load
