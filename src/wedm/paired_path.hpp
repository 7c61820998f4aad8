// SPDX-License-Identifier: GPL-3.0-or-later
// A line in both faces at once, point for point, and fewer points on it.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "hdconj/base/vec2.hpp"

namespace hdconj::wedm {

/// Point k of the lower face and point k of the upper one are joined by a straight line: the wire. Travelled with the
/// void on the left.
struct PairedPath
{
    std::vector<Vec2> lower;  ///< (n) [mm]
    std::vector<Vec2> upper;  ///< (n)

    [[nodiscard]] std::size_t size() const { return lower.size(); }
    [[nodiscard]] std::vector<Vec2> const& face(bool is_upper) const { return is_upper ? upper : lower; }
    void add(Vec2 const& low, Vec2 const& up)
    {
        lower.push_back(low);
        upper.push_back(up);
    }
};

/// The points @p indices of @p path.
[[nodiscard]] PairedPath taken(PairedPath const& path, std::vector<std::size_t> const& indices);

/// How far point @p k lies from the straight move from @p a to @p b, in the face where that is more [mm]: from the
/// point of the move that is nearest in both faces together, so that between the faces no ruling is further from the
/// move than this.
[[nodiscard]] double from_move(PairedPath const& path, std::size_t k, std::size_t a, std::size_t b);

/// Whether the move from point a to point b of a path is too short.
using IsShort = std::function<bool(std::size_t a, std::size_t b)>;

/// As thinned(), but of the moves between points of a path thinned to 1/256 of the tolerance those of which the fewest
/// are short, and then the fewest. They keep to that tolerance of every point of @p path.
[[nodiscard]] std::vector<std::size_t> thinned_to_long_moves(PairedPath const& path, double tolerance,
                                                             IsShort const& is_short);

/// Indices of points whose straight moves keep to within @p tolerance [mm] of every point of @p path, as measured by
/// from_move; the ends and @p keep (increasing) are among them. Greedy from the first point, so not always the fewest.
/// A path of at least 2 points; n points take some n log n measurements.
[[nodiscard]] std::vector<std::size_t> thinned(PairedPath const& path, double tolerance,
                                               std::vector<std::size_t> const& keep = {});

}  // namespace hdconj::wedm
