// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Did a parallel offset swallow a feature of the tooth space?
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "hdconj/conjugate/tooth_space.hpp"
#include "hdconj/numeric/error.hpp"
#include "hdconj/scene/parameters.hpp"

namespace hdconj::detail {

/// Refuses an offset at which a stretch of the tooth space's boundary longer than the tolerance has vanished: the
/// neighbours' offsets meet in front of it. A stretch that is only shortened is trimmed exactly and kept.
/// @throws NumericalError with place and size of the largest stretch lost
template<RelativeMotion Motion>
void refuse_swallowed(Envelope<Motion> const& base, std::vector<ContactArc> const& base_arcs, ToothSpace const& before,
                      std::vector<ContactArc> const& offset_arcs, ToothSpace const& after, double pitch, double offset, double tolerance)
{
    double largest = 0;
    Vec2 where = Vec2::Zero();
    for (BoundaryPiece const& piece : before.pieces)
    {
        if (piece.arc < 0)
            continue;
        ContactArc const& arc = base_arcs[static_cast<std::size_t>(piece.arc)];
        bool kept = false;
        for (BoundaryPiece const& other : after.pieces)
        {
            if (other.arc < 0 || other.copy != piece.copy)
                continue;
            ContactArc const& offset_arc = offset_arcs[static_cast<std::size_t>(other.arc)];
            kept = kept || (offset_arc.piece == arc.piece && offset_arc.candidate == arc.candidate);
        }
        if (kept)
            continue;
        TurnedArc<Motion> const turned{base, arc, piece.copy * pitch};
        constexpr int steps = 16;
        double length = 0;
        Vec2 last = turned.point(piece.begin).p;
        for (int i = 1; i <= steps; ++i)
        {
            Vec2 const next = turned.point(piece.begin + (piece.end - piece.begin) * i / steps).p;
            length += (next - last).norm();
            last = next;
            if (i == steps / 2 && length > largest / 2)
                where = next;
        }
        largest = std::max(largest, length);
    }
    if (largest > tolerance)
        throw NumericalError("backlash offset", "near (" + std::to_string(where.x()) + ", " + std::to_string(where.y()) + ") mm",
                             "an offset of " + std::to_string(offset) + " mm swallows a stretch of the flank " + std::to_string(largest)
                                 + " mm long; write a smaller circular_spline.backlash_offset");
}

}  // namespace hdconj::detail
