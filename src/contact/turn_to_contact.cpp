// SPDX-License-Identifier: GPL-3.0-or-later
#include "turn_to_contact.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/text.hpp"
#include "hdconj/base/parallel.hpp"
#include "hdconj/base/tolerance.hpp"
#include "hdconj/error.hpp"
#include "hdconj/units.hpp"

namespace hdconj::contact {
namespace {

/// Points that may be the first to touch, and their gaps at one turn. There are up to a hundred thousand of them at
/// first: one number for each, its place when spaces, slices and points are counted through.
struct Rivals
{
    int flank = 0;
    std::size_t slices = 0, points = 0;
    std::vector<std::size_t> place;

    [[nodiscard]] GapField::Index index(std::size_t i) const
    {
        std::size_t const line = place[i] / points;
        return {line / slices, flank, line % slices, place[i] % points};
    }
    /// Whether @p b is the point after @p a of one flank of one slice.
    [[nodiscard]] bool follows(std::size_t a, std::size_t b) const
    {
        return place[b] == place[a] + 1 && place[b] % points != 0;
    }

    [[nodiscard]] std::vector<double> gaps(GapField const& field, double turn, int threads) const
    {
        std::vector<double> result(place.size());
        constexpr std::size_t block = 256;
        constexpr std::size_t grain = 16;
        parallel_for((place.size() + block - 1) / block, threads, grain, [&](std::size_t b) {
            std::size_t const end = std::min(place.size(), (b + 1) * block);
            for (std::size_t i = b * block; i < end; ++i)
                result[i] = field.gap(index(i), turn);
        });
        return result;
    }
};

/// What is found at one turn.
struct Look
{
    SmallestGap least;
    std::vector<double> low;  ///< of each rival, or the minimum beside it
};

/// The smallest gap at and between the rivals. Minima between points are followed where they may lie below @p margin.
Look look(GapField const& field, Rivals const& rivals, double turn, double margin, int threads)
{
    Look result{{std::numeric_limits<double>::infinity(), {}}, rivals.gaps(field, turn, threads)};
    std::vector<double>& low = result.low;
    if (low.empty())
        return result;
    double const on_points = *std::min_element(low.begin(), low.end());
    double const enough = std::max(on_points, margin) + 0.5 * field.spacing();
    std::vector<std::size_t> deeper;
    for (std::size_t r = 0; r < low.size(); ++r) {
        if (low[r] > enough)
            continue;
        // who is no rival is no smaller
        bool const falls = (r > 0 && low[r - 1] < low[r] && rivals.follows(r - 1, r)) ||
                           (r + 1 < low.size() && low[r + 1] < low[r] && rivals.follows(r, r + 1));
        if (!falls)
            deeper.push_back(r);
    }
    std::vector<double> found(deeper.size());
    constexpr std::size_t grain = 8;
    parallel_for(deeper.size(), threads, grain, [&](std::size_t i) {
        found[i] = field.lowest_about(rivals.index(deeper[i]), low[deeper[i]], turn, smallest_gap_accuracy(field));
    });
    for (std::size_t i = 0; i < deeper.size(); ++i)
        low[deeper[i]] = found[i];
    auto const least = std::min_element(low.begin(), low.end());
    result.least = {*least, rivals.index(static_cast<std::size_t>(least - low.begin()))};
    return result;
}

}  // namespace

TurnToContact turn_to_contact(GapField const& field, GapMap const& at_rest, int flank, double limit, int threads,
                              double touches)
{
    double const sense = flank == GapMap::right ? 1 : -1;
    double const reach = field.reach();
    double const between = 0.5 * field.spacing();  // how much less a gap may be beside a point
    std::size_t const slices = at_rest.z.size();
    std::size_t const points = at_rest.station.size();
    auto const rivals_within = [&](double turn) {
        std::vector<std::vector<std::size_t>> found(at_rest.angle.size() / static_cast<std::size_t>(field.lobes()));
        constexpr std::size_t gaps_worth_a_thread = 1 << 16;
        parallel_for(found.size(), threads,
                     std::max<std::size_t>(1, gaps_worth_a_thread / std::max<std::size_t>(1, slices * points)),
                     [&](std::size_t s) {
                         std::size_t const space = field.first_of_lobe() + s;
                         for (std::size_t k = 0; k < slices; ++k)
                             for (std::size_t i = 0; i < points; ++i)
                                 if (at_rest.at(space, flank, k, i) <= reach * turn + between)
                                     found[s].push_back((space * slices + k) * points + i);
                     });
        Rivals rivals{flank, slices, points, {}};
        for (auto const& each : found)
            rivals.place.insert(rivals.place.end(), each.begin(), each.end());
        return rivals;
    };
    SmallestGap const resting = smallest_gap(field, at_rest, 0, flank, threads);
    double const first = resting.gap;
    if (std::abs(first) <= touches)
        return {0, resting.where, first, resting};

    // turn on while there is a gap, back while there is none
    double const way = first > 0 ? 1 : -1;
    double step = std::max(std::abs(first), 16 * unit_roundoff * reach) / reach;
    Rivals rivals;
    double turn = 0;
    double low = 0, high = 0;  // turns with and without a gap
    double at_low = first, at_high = first;
    bool done = first == 0;
    for (bool bracketed = done; !bracketed;) {
        constexpr double growth = 1.5;
        // the last look is at the limit itself
        if (!(step < limit))
            throw NumericalError(ErrorCode::no_contact, "contact", "turn to contact",
                                 "no flank touches within a turn of " + short_number(limit / deg) + " deg");
        step = std::min(growth * step, limit);
        rivals = rivals_within(step);
        double const gap = look(field, rivals, sense * way * step, 0, threads).least.gap;
        (gap > 0 ? low : high) = way * step;
        (gap > 0 ? at_low : at_high) = gap;
        done = gap == 0;
        turn = way * step;
        bracketed = done || (gap > 0) != (first > 0);
    }
    double const enough = 16 * unit_roundoff * reach;
    constexpr int budget = 100;
    int kept_low = 0, kept_high = 0;
    for (int i = 0; i < budget && !done; ++i) {
        double const share = at_low / (at_low - at_high);
        turn = low + share * (high - low);
        if (!(turn > std::min(low, high) && turn < std::max(low, high)))
            turn = 0.5 * (low + high);
        double const width = std::max(std::abs(high - turn), std::abs(turn - low));
        Look const now = look(field, rivals, sense * turn, reach * width, threads);
        double const gap = now.least.gap;
        done = std::abs(gap) <= enough ||
               std::abs(high - low) <= 4 * unit_roundoff * std::max(std::abs(low), std::abs(high));
        if (done)
            break;
        // who is further from zero here than the bracket can take it is out
        Rivals left{flank, slices, points, {}};
        for (std::size_t r = 0; r < now.low.size(); ++r)
            if (now.low[r] <= reach * width)
                left.place.push_back(rivals.place[r]);
        rivals = std::move(left);
        if (gap > 0) {
            low = turn;
            at_low = gap;
            kept_low = 0;
            at_high *= ++kept_high > 1 ? 0.5 : 1;
        } else {
            high = turn;
            at_high = gap;
            kept_high = 0;
            at_low *= ++kept_low > 1 ? 0.5 : 1;
        }
    }
    if (!done)
        throw NumericalError(ErrorCode::not_converged, "contact", "turn to contact",
                             "the turn to first contact did not converge");
    if (rivals.place.empty())
        return {turn, {}, 0, resting};
    SmallestGap const touching = look(field, rivals, sense * turn, 0, threads).least;
    return {turn, touching.where, touching.gap, resting};
}

}  // namespace hdconj::contact
