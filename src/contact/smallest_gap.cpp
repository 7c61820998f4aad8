// SPDX-License-Identifier: GPL-3.0-or-later
// The smallest gap of a map, with the minima between its points.
#include <algorithm>
#include <limits>

#include "gap_field.hpp"
#include "hdconj/base/parallel.hpp"
#include "hdconj/base/tolerance.hpp"

namespace hdconj::contact {

SmallestGap smallest_on_line(GapField const& field, GapField::Index const& line, double const* gap, double turn,
                             double below)
{
    std::size_t const points = field.grid().points();
    GapField::Index at = line;
    SmallestGap best{std::numeric_limits<double>::infinity(), at};
    for (std::size_t i = 0; i < points; ++i) {
        at.point = i;
        if (gap[i] < best.gap)
            best = {gap[i], at};
        if (!(gap[i] - 0.5 * field.spacing() < std::min(below, best.gap)) || (i > 0 && gap[i - 1] < gap[i]) ||
            (i + 1 < points && gap[i + 1] < gap[i]))
            continue;
        double const lowest = field.lowest_about(at, gap[i], turn, smallest_gap_accuracy(field));
        if (lowest < best.gap)
            best = {lowest, at};
    }
    return best;
}

double smallest_gap_accuracy(GapField const& field)
{
    return 4 * unit_roundoff * field.reach();
}

SmallestGap smallest_gap(GapField const& field, GapMap const& map, double turn, int flank, int threads)
{
    std::size_t const spaces = map.angle.size() / static_cast<std::size_t>(field.lobes());
    std::size_t const first = field.first_of_lobe();
    std::size_t const row = map.z.size() * map.station.size();
    auto const asked = [&](int side) { return flank < 0 || side == flank; };
    std::vector<double> least(2 * spaces, std::numeric_limits<double>::infinity());
    constexpr std::size_t gaps_worth_a_thread = 1 << 17;
    parallel_for(least.size(), threads, std::max<std::size_t>(1, gaps_worth_a_thread / std::max<std::size_t>(1, row)),
                 [&](std::size_t i) {
                     if (asked(static_cast<int>(i % 2)))
                         least[i] = *std::min_element(
                             map.gap.begin() + static_cast<std::ptrdiff_t>((2 * first + i) * row),
                             map.gap.begin() + static_cast<std::ptrdiff_t>((2 * first + i + 1) * row));
                 });
    double const on_points = *std::min_element(least.begin(), least.end());
    std::vector<SmallestGap> found(spaces);
    constexpr std::size_t spaces_worth_a_thread = 4;
    parallel_for(spaces, threads, spaces_worth_a_thread, [&](std::size_t s) {
        std::size_t const space = first + s;
        found[s].gap = std::numeric_limits<double>::infinity();
        for (int const side : {static_cast<int>(GapMap::left), static_cast<int>(GapMap::right)})
            for (std::size_t k = 0; asked(side) && k < map.z.size(); ++k) {
                SmallestGap const line =
                    smallest_on_line(field, {space, side, k, 0}, map.gap.data() + map.index(space, side, k, 0), turn,
                                     std::min(on_points, found[s].gap));
                if (line.gap < found[s].gap)
                    found[s] = line;
            }
    });
    return *std::min_element(found.begin(), found.end(),
                             [](SmallestGap const& a, SmallestGap const& b) { return a.gap < b.gap; });
}

}  // namespace hdconj::contact
