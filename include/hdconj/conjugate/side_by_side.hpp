// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Branches of the reverse problem that run closer to each other than anything tells apart.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "hdconj/conjugate/body_polygons.hpp"
#include "hdconj/conjugate/nearest_on_arc.hpp"
#include "hdconj/conjugate/tooth_space.hpp"

namespace hdconj::conjugate {

/// The arc that a piece of a flank runs on; `copy` is the index of the tooth that sweeps it.
template <motion::RelativeMotion Motion>
[[nodiscard]] TurnedArc<Motion> turned_arc(std::vector<SweptTooth<Motion>> const& teeth, BoundaryPiece const& piece)
{
    SweptTooth<Motion> const& tooth = teeth[static_cast<std::size_t>(piece.copy)];
    return {tooth.envelope, tooth.arcs[static_cast<std::size_t>(piece.arc)], 0};
}

/// Of branches that run side by side, no farther apart than @p step [mm], polygons pick now one, now the other: the
/// flank stays on the first as long as it can.
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

}  // namespace hdconj::conjugate
