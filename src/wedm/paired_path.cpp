// SPDX-License-Identifier: GPL-3.0-or-later
#include "paired_path.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "hdconj/base/stop.hpp"

namespace hdconj::wedm {

PairedPath taken(PairedPath const& path, std::vector<std::size_t> const& indices)
{
    PairedPath few;
    for (std::size_t const i : indices)
        few.add(path.lower[i], path.upper[i]);
    return few;
}

double from_move(PairedPath const& path, std::size_t k, std::size_t a, std::size_t b)
{
    Vec2 const low = path.lower[b] - path.lower[a];
    Vec2 const up = path.upper[b] - path.upper[a];
    Vec2 const to_low = path.lower[k] - path.lower[a];
    Vec2 const to_up = path.upper[k] - path.upper[a];
    double const length = low.squaredNorm() + up.squaredNorm();
    double const share = length > 0 ? std::clamp((to_low.dot(low) + to_up.dot(up)) / length, 0.0, 1.0) : 0;
    return std::max((to_low - share * low).norm(), (to_up - share * up).norm());
}

namespace {

/// Whether the move from @p a to @p b keeps to within @p tolerance of every point between.
bool reaches(PairedPath const& path, std::size_t a, std::size_t b, double tolerance)
{
    for (std::size_t k = a + 1; k < b; ++k)
        if (from_move(path, k, a, b) > tolerance)
            return false;
    return true;
}

}  // namespace

std::vector<std::size_t> thinned_to_long_moves(PairedPath const& path, double tolerance, IsShort const& is_short)
{
    // the cheapest way to each point: short moves, moves, and the point before
    struct Way
    {
        std::size_t shorts = 0, moves = 0, from = 0;
    };
    constexpr std::size_t unknown = std::numeric_limits<std::size_t>::max();
    std::vector<Way> ways(path.size(), {unknown, unknown, 0});
    ways.front() = {};
    for (std::size_t a = 0; a + 1 < path.size(); ++a) {
        end_if_stopped();
        for (std::size_t b = a + 1; b < path.size() && reaches(path, a, b, tolerance); ++b) {
            Way const way{ways[a].shorts + (is_short(a, b) ? 1 : 0), ways[a].moves + 1, a};
            if (std::pair(way.shorts, way.moves) < std::pair(ways[b].shorts, ways[b].moves))
                ways[b] = way;
        }
    }
    std::vector<std::size_t> kept{path.size() - 1};
    while (kept.back() > 0)
        kept.push_back(ways[kept.back()].from);
    std::reverse(kept.begin(), kept.end());
    return kept;
}

std::vector<std::size_t> thinned(PairedPath const& path, double tolerance, std::vector<std::size_t> const& keep)
{
    std::vector<std::size_t> kept{0};
    auto next_kept = keep.begin();
    std::size_t const last = path.size() - 1;
    while (kept.back() < last) {
        end_if_stopped();
        std::size_t const from = kept.back();
        while (next_kept != keep.end() && *next_kept <= from)
            ++next_kept;
        std::size_t const end = next_kept == keep.end() ? last : std::min(last, *next_kept);
        std::size_t to = from + 1;
        while (to < end && reaches(path, from, to + 1, tolerance))
            ++to;
        kept.push_back(to);
    }
    return kept;
}

}  // namespace hdconj::wedm
