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
    Lanes squared, x, y, n_x, n_y;
    Lanes vertex;  ///< 0: none, on_joint or on_open_end
};
constexpr double on_joint = 1, on_open_end = 2;

inline void offer(Foot& foot, std::size_t l, bool inside, double p_x, double p_y, double x, double y, double n_x,
                  double n_y, double vertex)
{
    double const away_x = p_x - x, away_y = p_y - y;
    double const squared = away_x * away_x + away_y * away_y;
    bool const nearer = inside & (squared < foot.squared[l]);
    foot.squared[l] = nearer ? squared : foot.squared[l];
    foot.x[l] = nearer ? x : foot.x[l];
    foot.y[l] = nearer ? y : foot.y[l];
    foot.n_x[l] = nearer ? n_x : foot.n_x[l];
    foot.n_y[l] = nearer ? n_y : foot.n_y[l];
    foot.vertex[l] = nearer ? vertex : foot.vertex[l];
}

HDCONJ_TARGETS
void distances(DistanceLanes::Vertex const* vertex, DistanceLanes::Piece const* piece, std::size_t pieces,
               Lanes const& x, Lanes const& y, DistanceLanes::Nearest& nearest)
{
    constexpr double aligned = 1 - 0x1p-20;  // as in ToothDistance
    Foot foot;
    for (std::size_t l = 0; l < lanes; ++l) {
        foot.squared[l] = std::numeric_limits<double>::infinity();
        foot.x[l] = foot.y[l] = foot.n_x[l] = foot.n_y[l] = foot.vertex[l] = 0;
    }
    for (std::size_t i = 0; i <= pieces; ++i) {
        DistanceLanes::Vertex const v = vertex[i];
        double const vertex_kind = v.open_end != 0 ? on_open_end : on_joint;
        for (std::size_t l = 0; l < lanes; ++l)
            offer(foot, l, true, x[l], y[l], v.x, v.y, v.n_x, v.n_y, vertex_kind);
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
        double const away_x = x[l] - foot.x[l], away_y = y[l] - foot.y[l];
        double const along = away_x * foot.n_x[l] + away_y * foot.n_y[l];
        double const size = std::sqrt(foot.squared[l]);
        bool const outside = (foot.vertex[l] == on_open_end) | (along >= 0);
        double const straight = std::abs(along);
        bool const corner = (foot.vertex[l] != 0) & (size > 0) & (straight < aligned * size);
        double const scale = (outside ? 1.0 : -1.0) / size;
        nearest.distance[l] = outside ? size : -size;
        nearest.foot_y[l] = foot.y[l];
        nearest.normal_x[l] = corner ? scale * away_x : foot.n_x[l];
        nearest.normal_y[l] = corner ? scale * away_y : foot.n_y[l];
    }
}

}  // namespace

DistanceLanes::DistanceLanes(std::vector<Vertex> vertices, std::vector<Piece> pieces)
    : vertices_(std::move(vertices)), pieces_(std::move(pieces))
{
}

void DistanceLanes::operator()(Lanes const& x, Lanes const& y, Nearest& nearest) const
{
    distances(vertices_.data(), pieces_.data(), pieces_.size(), x, y, nearest);
}

}  // namespace hdconj::distance
