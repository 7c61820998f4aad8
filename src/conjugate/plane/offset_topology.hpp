// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Whether a parallel offset keeps every stretch of a boundary.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "hdconj/conjugate/tooth_space.hpp"
#include "hdconj/envelope/any_envelope.hpp"
#include "hdconj/error.hpp"
#include "hdconj/scene/parameters.hpp"

namespace hdconj::conjugate {

/// Requires that no stretch of a boundary longer than the tolerance vanishes at the offset, where the neighbours'
/// offsets meet in front of it. A stretch that is only shortened is trimmed exactly and kept.
/// @param kept   whether a piece is there after the offset
/// @param point  point of a piece at u, before the offset
/// @throws NumericalError with place and size of the largest stretch lost
template <class Kept, class PointAt>
void require_same_topology(std::vector<BoundaryPiece> const& before, Kept const& kept, PointAt const& point,
                           double offset, double tolerance)
{
    double largest = 0;
    Vec2 where = Vec2::Zero();
    for (BoundaryPiece const& piece : before) {
        if (piece.arc < 0 || kept(piece))
            continue;
        constexpr int steps = 16;
        double length = 0;
        Vec2 last = point(piece, piece.begin);
        for (int i = 1; i <= steps; ++i) {
            Vec2 const next = point(piece, piece.begin + (piece.end - piece.begin) * i / steps);
            length += (next - last).norm();
            last = next;
            if (i == steps / 2 && length > largest / 2)
                where = next;
        }
        largest = std::max(largest, length);
    }
    if (largest > tolerance)
        throw NumericalError(ErrorCode::no_outline, "backlash offset",
                             "near (" + std::to_string(where.x()) + ", " + std::to_string(where.y()) + ") mm",
                             "an offset of " + std::to_string(offset) + " mm swallows a stretch of the flank " +
                                 std::to_string(largest) + " mm long",
                             "write a smaller circular_spline.backlash_offset");
}

/// Whether @p pieces, on @p arcs, have one on the contact that @p arc follows, of the tooth @p copy.
[[nodiscard]] inline bool has_contact(std::vector<BoundaryPiece> const& pieces,
                                      std::vector<envelope::ContactArc> const& arcs, envelope::ContactArc const& arc,
                                      int copy)
{
    return std::any_of(pieces.begin(), pieces.end(), [&](BoundaryPiece const& other) {
        if (other.arc < 0 || other.copy != copy)
            return false;
        envelope::ContactArc const& there = arcs[static_cast<std::size_t>(other.arc)];
        return there.piece == arc.piece && there.candidate == arc.candidate;
    });
}

/// The same for a tooth space, whose pieces are arcs of one tooth turned by whole pitches.
inline void require_same_topology(envelope::AnyEnvelope const& base, std::vector<envelope::ContactArc> const& base_arcs,
                                  ToothSpace const& before, std::vector<envelope::ContactArc> const& offset_arcs,
                                  ToothSpace const& after, double pitch, double offset, double tolerance)
{
    auto const arc_of = [&](BoundaryPiece const& piece) -> envelope::ContactArc const& {
        return base_arcs[static_cast<std::size_t>(piece.arc)];
    };
    auto const kept = [&](BoundaryPiece const& piece) {
        return has_contact(after.pieces, offset_arcs, arc_of(piece), piece.copy);
    };
    auto const point = [&](BoundaryPiece const& piece, double u) {
        return TurnedArc<motion::AnyMotion>{base, arc_of(piece), piece.copy * pitch}.point(u).p;
    };
    require_same_topology(before.pieces, kept, point, offset, tolerance);
}

}  // namespace hdconj::conjugate
