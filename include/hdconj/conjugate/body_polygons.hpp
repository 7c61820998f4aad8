// SPDX-License-Identifier: GPL-3.0-or-later
// Polygons of what teeth sweep around a tooth of the other member.
#pragma once

#include <vector>

#include "hdconj/conjugate/arc_polygons.hpp"
#include "hdconj/conjugate/swept_polygons.hpp"

namespace hdconj::conjugate {

/// A moving tooth with the contact arcs of its envelope.
template <motion::RelativeMotion Motion>
struct SweptTooth
{
    envelope::Envelope<Motion> envelope;
    std::vector<envelope::ContactArc> arcs;
};

/// Polygons of all bounding arcs of @p teeth, chord error <= @p chord, as far as they hang below the height @p tip.
/// @param graded  with vertices crowded towards the arcs' ends
template <motion::RelativeMotion Motion>
[[nodiscard]] SweptPolygons body_polygons(std::vector<SweptTooth<Motion>> const& teeth, double tip, double chord,
                                          bool graded)
{
    SweptPolygons swept(0);
    double const ceiling = tip + 64 * chord;
    for (std::size_t j = 0; j < teeth.size(); ++j)
        for (std::size_t i = 0; i < teeth[j].arcs.size(); ++i)
            add_polygons(
                teeth[j].envelope, teeth[j].arcs[i], chord, graded, [&](Vec2 const& p) { return p.y() < ceiling; },
                [&](auto const& points, auto const& u) {
                    swept.add_one(static_cast<int>(i), static_cast<int>(j), points, u);
                });
    return swept;
}

}  // namespace hdconj::conjugate
