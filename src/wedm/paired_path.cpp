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

/// A point up to @p end that one move from point @p from reaches, and the next one not: sought in steps that double and
/// then in halves, so that the work grows with the number of points and not with its square.
std::size_t reached_from(PairedPath const& path, std::size_t from, std::size_t end, double tolerance)
{
    std::size_t good = from + 1, bad = end + 1;
    for (std::size_t step = 1; good + step < bad; step *= 2) {
        if (reaches(path, from, good + step, tolerance))
            good += step;
        else
            bad = good + step;
    }
    while (bad - good > 1) {
        std::size_t const middle = good + (bad - good) / 2;
        (reaches(path, from, middle, tolerance) ? good : bad) = middle;
    }
    return good;
}

/// What a choice of moves may lose of the tolerance by points that it does not look at.
constexpr double share_of_choice = 1.0 / 256;

}  // namespace

std::vector<std::size_t> thinned_to_long_moves(PairedPath const& path, double tolerance, IsShort const& is_short)
{
    std::vector<std::size_t> const chosen = thinned(path, share_of_choice * tolerance);
    PairedPath const few = taken(path, chosen);
    double const left = (1 - 2 * share_of_choice) * tolerance;  // off a line between chosen points in either face
    // the cheapest way to each point: short moves, moves, and the point before
    struct Way
    {
        std::size_t shorts = 0, moves = 0, from = 0;
    };
    constexpr std::size_t unknown = std::numeric_limits<std::size_t>::max();
    std::vector<Way> ways(few.size(), {unknown, unknown, 0});
    ways.front() = {};
    for (std::size_t a = 0; a + 1 < few.size(); ++a) {
        end_if_stopped();
        for (std::size_t b = a + 1; b < few.size() && reaches(few, a, b, left); ++b) {
            Way const way{ways[a].shorts + (is_short(chosen[a], chosen[b]) ? 1 : 0), ways[a].moves + 1, a};
            if (std::pair(way.shorts, way.moves) < std::pair(ways[b].shorts, ways[b].moves))
                ways[b] = way;
        }
    }
    std::vector<std::size_t> kept{path.size() - 1};
    for (std::size_t at = few.size() - 1; at > 0; at = ways[at].from)
        kept.push_back(chosen[ways[at].from]);
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
        kept.push_back(reached_from(path, from, end, tolerance));
    }
    return kept;
}

}  // namespace hdconj::wedm
