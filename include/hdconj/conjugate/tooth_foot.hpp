// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Where a flank of the reverse problem ends.
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

/// Where a flank of the reverse problem ends on @p piece: where the tooth that sweeps it touches with the very end of
/// its tip (its contact normal is along its own centre line), or at half the pitch. Its begin when at once, nothing
/// when the flank goes on.
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
    double const low = std::min(piece.begin, piece.end);
    double const high = std::max(piece.begin, piece.end);
    std::vector<double> stations;
    std::copy_if(vertices.begin(), vertices.end(), std::back_inserter(stations),
                 [&](double u) { return u > low && u < high; });
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
