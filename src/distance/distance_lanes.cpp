// SPDX-License-Identifier: GPL-3.0-or-later
// Loops over lanes, compiled as those of tooth_lanes.cpp.
#include "hdconj/distance/distance_lanes.hpp"

#include <cmath>
#include <limits>
#include <utility>

#include "base/loop_targets.hpp"

namespace hdconj::distance {
namespace {

/// The nearest foot so far.
struct Foot
{
    Lanes squared, x, y, n_x, n_y, open_end;
};

inline void offer(Foot& foot, std::size_t l, bool inside, double p_x, double p_y, double x, double y, double n_x,
                  double n_y, double open_end)
{
    double const away_x = p_x - x, away_y = p_y - y;
    double const squared = away_x * away_x + away_y * away_y;
    bool const nearer = inside & (squared < foot.squared[l]);
    foot.squared[l] = nearer ? squared : foot.squared[l];
    foot.x[l] = nearer ? x : foot.x[l];
    foot.y[l] = nearer ? y : foot.y[l];
    foot.n_x[l] = nearer ? n_x : foot.n_x[l];
    foot.n_y[l] = nearer ? n_y : foot.n_y[l];
    foot.open_end[l] = nearer ? open_end : foot.open_end[l];
}

HDCONJ_TARGETS
void distances(DistanceLanes::Vertex const* vertex, DistanceLanes::Piece const* piece, std::size_t pieces,
               Lanes const& x, Lanes const& y, Lanes& distance, Lanes& foot_y)
{
    Foot foot;
    for (std::size_t l = 0; l < lanes; ++l) {
        foot.squared[l] = std::numeric_limits<double>::infinity();
        foot.x[l] = foot.y[l] = foot.n_x[l] = foot.n_y[l] = foot.open_end[l] = 0;
    }
    for (std::size_t i = 0; i <= pieces; ++i) {
        DistanceLanes::Vertex const v = vertex[i];
        for (std::size_t l = 0; l < lanes; ++l)
            offer(foot, l, true, x[l], y[l], v.x, v.y, v.n_x, v.n_y, v.open_end);
    }
    for (std::size_t i = 0; i < pieces; ++i) {
        DistanceLanes::Piece const p = piece[i];
        Lanes within;  // 1: the box may hold what is nearer than what is known
        for (std::size_t l = 0; l < lanes; ++l) {
            double const left = p.low_x - x[l], right = x[l] - p.high_x;
            double const below = p.low_y - y[l], above = y[l] - p.high_y;
            double const beside = left > right ? left : right, over = below > above ? below : above;
            double const d_x = beside > 0 ? beside : 0, d_y = over > 0 ? over : 0;
            within[l] = d_x * d_x + d_y * d_y <= foot.squared[l] ? 1.0 : 0.0;
        }
        double any = 0;
        for (std::size_t l = 0; l < lanes; ++l)
            any += within[l];
        if (any == 0)
            continue;
        if (p.is_arc) {
            double const side = p.size > 0 ? 1.0 : -1.0;
            for (std::size_t l = 0; l < lanes; ++l) {
                double const from_x = x[l] - p.x, from_y = y[l] - p.y;
                double const length = std::sqrt(from_x * from_x + from_y * from_y);
                double const scale = side / length;  // not finite at the centre, and then not inside
                double const n_x = scale * from_x, n_y = scale * from_y;
                bool const inside = (within[l] != 0) & (n_x * p.t_x + n_y * p.t_y > p.cos_half_span);
                offer(foot, l, inside, x[l], y[l], p.x + p.size * n_x, p.y + p.size * n_y, n_x, n_y, 0);
            }
        } else {
            for (std::size_t l = 0; l < lanes; ++l) {
                double const along = (x[l] - p.x) * p.t_x + (y[l] - p.y) * p.t_y;
                bool const inside = (within[l] != 0) & (along > 0) & (along < p.size);
                offer(foot, l, inside, x[l], y[l], p.x + along * p.t_x, p.y + along * p.t_y, p.n_x, p.n_y, 0);
            }
        }
    }
    for (std::size_t l = 0; l < lanes; ++l) {
        double const along = (x[l] - foot.x[l]) * foot.n_x[l] + (y[l] - foot.y[l]) * foot.n_y[l];
        double const size = std::sqrt(foot.squared[l]);
        distance[l] = ((foot.open_end[l] != 0) | (along >= 0)) ? size : -size;
        foot_y[l] = foot.y[l];
    }
}

}  // namespace

DistanceLanes::DistanceLanes(std::vector<Vertex> vertices, std::vector<Piece> pieces)
    : vertices_(std::move(vertices)), pieces_(std::move(pieces))
{
}

void DistanceLanes::operator()(Lanes const& x, Lanes const& y, Lanes& distance, Lanes& foot_y) const
{
    distances(vertices_.data(), pieces_.data(), pieces_.size(), x, y, distance, foot_y);
}

}  // namespace hdconj::distance
