// SPDX-License-Identifier: GPL-3.0-or-later
// A flank of the reverse problem: which of two branches side by side it stays on, and where it ends.
#pragma once

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <optional>
#include <vector>

#include "hdconj/base/tolerance.hpp"
#include "hdconj/conjugate/body_polygons.hpp"
#include "hdconj/conjugate/tooth_space.hpp"
#include "hdconj/numeric/bracketed_root.hpp"

namespace hdconj::conjugate {

/// The arc that a piece of a flank runs on; `copy` is the index of the tooth that sweeps it.
template <motion::RelativeMotion Motion>
[[nodiscard]] TurnedArc<Motion> turned_arc(std::vector<SweptTooth<Motion>> const& teeth, BoundaryPiece const& piece)
{
    SweptTooth<Motion> const& tooth = teeth[static_cast<std::size_t>(piece.copy)];
    return {tooth.envelope, tooth.arcs[static_cast<std::size_t>(piece.arc)], 0};
}

/// Keeps the flank on one of several branches that run side by side, no farther apart than @p step [mm]. Polygons pick
/// now one, now the other of them; the flank stays on the first as long as it can.
/// @param gap  raised to the largest distance between branches that were taken for one
template <motion::RelativeMotion Motion>
[[nodiscard]] std::vector<BoundaryPiece> without_changes(std::vector<SweptTooth<Motion>> const& teeth,
                                                         std::vector<BoundaryPiece> const& flank, double step,
                                                         double& gap)
{
    std::vector<BoundaryPiece> result;
    for (std::size_t i = 0; i < flank.size();) {
        BoundaryPiece piece = flank[i];
        std::size_t last = i;
        double u = piece.end;
        double widest = 0;
        double settled_gap = 0;
        for (std::size_t k = i + 1; k < flank.size(); ++k) {
            BoundaryPiece const& next = flank[k];
            bool const same = next.arc == piece.arc && next.copy == piece.copy;
            for (double const share : {0.0, 0.5, 1.0}) {
                NearestOnArc const there =
                    nearest_on(turned_arc(teeth, piece),
                               turned_arc(teeth, next).point(next.begin + share * (next.end - next.begin)).p, u);
                u = there.u;
                widest = std::max(widest, same ? 0 : there.gap);
            }
            if (!(widest <= step))
                break;
            if (same) {
                last = k;
                u = next.end;
                settled_gap = widest;
            }
        }
        piece.end = flank[last].end;
        gap = std::max(gap, settled_gap);
        result.push_back(piece);
        i = last + 1;
    }
    return result;
}

/// Where a flank of the reverse problem ends on @p piece. This is the begin of the piece when it ends at once, and
/// nothing when it goes on. It ends at half the pitch, or where the tooth that sweeps it touches with the end of its
/// tip. There the contact normal is along that tooth's centre line.
/// @param vertices    u at the vertices of the piece's polygon, between which at most one foot is looked for
/// @param side        1: right flank, -1: left
/// @param half_width  half the pitch at the root [mm]
template <motion::RelativeMotion Motion>
[[nodiscard]] std::optional<double> foot_on(SweptTooth<Motion> const& tooth, BoundaryPiece const& piece,
                                            std::vector<double> const& vertices, int side, double half_width)
{
    envelope::ContactArc const& arc = tooth.arcs[static_cast<std::size_t>(piece.arc)];
    // positive above the foot
    auto const above = [&](double u) {
        double const along = side * tooth.envelope.contact(arc, u).n.x();
        double const room = 1 - side * tooth.envelope.point(arc, u).p.x() / half_width;
        return std::min(along, room);
    };
    constexpr double on_centre_line = 4096 * unit_roundoff;  // a flat tip's normal, after some roundings
    if (!(above(piece.begin) > on_centre_line))
        return piece.begin;
    auto const [low, high] = std::minmax(piece.begin, piece.end);
    std::vector<double> stations;
    std::copy_if(vertices.begin(), vertices.end(), std::back_inserter(stations),
                 [low = low, high = high](double u) { return u > low && u < high; });
    std::sort(stations.begin(), stations.end());
    if (piece.begin > piece.end)
        std::reverse(stations.begin(), stations.end());
    stations.push_back(piece.end);
    double before = piece.begin;
    for (double u : stations) {
        if (!(above(u) > 0)) {
            numeric::BracketedRoot const root =
                numeric::bracketed_root(above, std::min(before, u), std::max(before, u));
            return root.found ? root.x : before;
        }
        before = u;
    }
    return std::nullopt;
}

}  // namespace hdconj::conjugate
