// SPDX-License-Identifier: GPL-3.0-or-later
#include "paired_path.hpp"

#include <algorithm>

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

std::vector<std::size_t> thinned(PairedPath const& path, double tolerance, std::vector<std::size_t> const& keep)
{
    std::vector<std::size_t> kept{0};
    auto next_kept = keep.begin();
    std::size_t const last = path.size() - 1;
    while (kept.back() < last) {
        std::size_t const from = kept.back();
        while (next_kept != keep.end() && *next_kept <= from)
            ++next_kept;
        std::size_t const end = next_kept == keep.end() ? last : std::min(last, *next_kept);
        std::size_t to = from + 1;
        auto const reaches = [&](std::size_t b) {
            for (std::size_t k = from + 1; k < b; ++k)
                if (from_move(path, k, from, b) > tolerance)
                    return false;
            return true;
        };
        while (to < end && reaches(to + 1))
            ++to;
        kept.push_back(to);
    }
    return kept;
}

}  // namespace hdconj::wedm
