// SPDX-License-Identifier: GPL-3.0-or-later
// Loops over lanes, compiled with -fno-math-errno and -fno-trapping-math, which change no value, and -ffp-contract=off
// as everything else: each copy does the same operations in the same order.
#include "hdconj/distance/tooth_lanes.hpp"

#include <cmath>
#include <limits>
#include <variant>

#include "base/loop_targets.hpp"

namespace hdconj::distance {
namespace {

/// The nearest foot so far: from it to the point, and the normal there.
struct Nearest
{
    Lanes squared, away_x, away_y, n_x, n_y, open_end;
};

inline void offer(Nearest& nearest, std::size_t l, bool inside, double away_x, double away_y, double n_x, double n_y,
                  double open_end)
{
    double const squared = away_x * away_x + away_y * away_y;
    bool const nearer = inside & (squared < nearest.squared[l]);
    nearest.squared[l] = nearer ? squared : nearest.squared[l];
    nearest.away_x[l] = nearer ? away_x : nearest.away_x[l];
    nearest.away_y[l] = nearer ? away_y : nearest.away_y[l];
    nearest.n_x[l] = nearer ? n_x : nearest.n_x[l];
    nearest.n_y[l] = nearer ? n_y : nearest.n_y[l];
    nearest.open_end[l] = nearer ? open_end : nearest.open_end[l];
}

HDCONJ_TARGETS
void distances(ToothLanes::Features const& tooth, Pose const& pose, PlanarVelocity const& twist, Lanes const& given_x,
               Lanes const& given_y, Lanes& distance, Lanes& slope)
{
    Lanes x, y;
    Nearest nearest;
    for (std::size_t l = 0; l < lanes; ++l) {
        double const from_x = given_x[l] - pose.origin.x(), from_y = given_y[l] - pose.origin.y();
        x[l] = pose.cosine * from_x - pose.sine * from_y;
        y[l] = pose.sine * from_x + pose.cosine * from_y;
        nearest.squared[l] = std::numeric_limits<double>::infinity();
        nearest.away_x[l] = nearest.away_y[l] = nearest.n_x[l] = nearest.n_y[l] = nearest.open_end[l] = 0;
    }
    for (ToothLanes::Vertex const& given : tooth.vertices) {
        ToothLanes::Vertex const v = given;
        for (std::size_t l = 0; l < lanes; ++l)
            offer(nearest, l, true, x[l] - v.x, y[l] - v.y, v.n_x, v.n_y, v.open_end);
    }
    for (ToothLanes::Line const& given : tooth.lines) {
        ToothLanes::Line const line = given;
        for (std::size_t l = 0; l < lanes; ++l) {
            double const from_x = x[l] - line.x, from_y = y[l] - line.y;
            double const along = from_x * line.t_x + from_y * line.t_y;
            double const across = from_y * line.t_x - from_x * line.t_y;
            offer(nearest, l, (along >= line.from) & (along <= line.to), -across * line.t_y, across * line.t_x,
                  -line.t_y, line.t_x, 0);
        }
    }
    for (ToothLanes::Arc const& given : tooth.arcs) {
        ToothLanes::Arc const arc = given;
        for (std::size_t l = 0; l < lanes; ++l) {
            double const from_x = x[l] - arc.x, from_y = y[l] - arc.y;
            double const length = std::sqrt(from_x * from_x + from_y * from_y);
            double const scale = arc.side / length;  // not finite at the centre, and then not inside
            double const n_x = scale * from_x, n_y = scale * from_y;
            double const above = arc.side * length - arc.radius;
            offer(nearest, l, n_x * arc.m_x + n_y * arc.m_y >= arc.cos_half_span, above * n_x, above * n_y, n_x, n_y,
                  0);
        }
    }
    for (std::size_t l = 0; l < lanes; ++l) {
        double const size = std::sqrt(nearest.squared[l]);
        double const along = nearest.away_x[l] * nearest.n_x[l] + nearest.away_y[l] * nearest.n_y[l];
        bool const outside = (nearest.open_end[l] != 0) | (along >= 0);
        double const sign = outside ? 1.0 : -1.0;
        // at a corner the gradient points from the corner to the point
        constexpr double aligned = 1 - 0x1p-20;
        bool const corner = (size > 0) & (std::abs(along) < aligned * size);
        double const n_x = corner ? sign / size * nearest.away_x[l] : nearest.n_x[l];
        double const n_y = corner ? sign / size * nearest.away_y[l] : nearest.n_y[l];
        distance[l] = sign * size;
        slope[l] = -(n_x * (twist.omega * y[l] + twist.q.x()) + n_y * (twist.q.y() - twist.omega * x[l]));
    }
}

constexpr double prolonged = 0x1p-40;

}  // namespace

void ToothLanes::operator()(Pose const& pose, PlanarVelocity const& twist, Lanes const& x, Lanes const& y,
                            Lanes& distance, Lanes& slope) const
{
    distances(features_, pose, twist, x, y, distance, slope);
}

std::optional<ToothLanes> tooth_lanes(profile::Profile const& profile)
{
    constexpr std::size_t most = 32;
    ToothLanes result;
    auto& [vertices, lines, arcs] = result.features_;
    profile::PieceShape const* before = nullptr;
    for (profile::ProfilePiece const& piece : profile.pieces) {
        if (piece.corner)
            continue;
        profile::PieceEnd const start = profile::start_of(piece.shape);
        Vec2 const other = before != nullptr ? profile::end_of(*before).normal : start.normal;
        Vec2 const mean = (start.normal + other).normalized();
        constexpr double smooth = 1 - 0x1p-40;
        if (before == nullptr || start.normal.dot(other) < smooth)
            vertices.push_back({start.point.x(), start.point.y(), mean.x(), mean.y(), before == nullptr ? 1.0 : 0.0});
        before = &piece.shape;
        if (auto const* line = std::get_if<profile::LinePiece>(&piece.shape)) {
            Vec2 const t = line->tangent();
            double const beyond = prolonged * line->length();
            lines.push_back({line->a.x(), line->a.y(), t.x(), t.y(), -beyond, line->length() + beyond});
        } else if (auto const* arc = std::get_if<profile::ArcPiece>(&piece.shape)) {
            Vec2 const middle = direction(0.5 * (arc->from + arc->to));
            double const half = 0.5 * std::abs(arc->to - arc->from);
            arcs.push_back({arc->centre.x(), arc->centre.y(), arc->radius, arc->radius > 0 ? 1.0 : -1.0, middle.x(),
                            middle.y(), std::cos(half) - prolonged});
        } else {
            return std::nullopt;
        }
    }
    if (before == nullptr || lines.size() + arcs.size() > most)
        return std::nullopt;
    profile::PieceEnd const last = profile::end_of(*before);
    vertices.push_back({last.point.x(), last.point.y(), last.normal.x(), last.normal.y(), 1.0});
    return result;
}

}  // namespace hdconj::distance
