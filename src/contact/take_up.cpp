// SPDX-License-Identifier: GPL-3.0-or-later
#include "hdconj/contact/take_up.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "hdconj/numeric/error.hpp"
#include "hdconj/numeric/parallel.hpp"
#include "hdconj/numeric/tolerance.hpp"

namespace hdconj {
namespace {

/// Points that may be the first to touch, and their gaps at one turn.
struct Rivals
{
    std::vector<GapField::Index> index;

    [[nodiscard]] std::vector<double> gaps(GapField const& field, double turn, int threads) const
    {
        std::vector<double> result(index.size());
        constexpr std::size_t block = 256;
        constexpr std::size_t grain = 16;
        parallel_for((index.size() + block - 1) / block, threads, grain, [&](std::size_t b) {
            std::size_t const end = std::min(index.size(), (b + 1) * block);
            for (std::size_t i = b * block; i < end; ++i)
                result[i] = field.gap(index[i], turn);
        });
        return result;
    }
};

double smallest(std::vector<double> const& gaps)
{
    return gaps.empty() ? std::numeric_limits<double>::infinity() : *std::min_element(gaps.begin(), gaps.end());
}

}  // namespace

TakeUp take_up(GapField const& field, GapMap const& at_rest, int flank, double limit, int threads)
{
    double const sense = flank == GapMap::right ? 1 : -1;
    double const reach = field.reach();
    std::size_t const slices = at_rest.z.size();
    std::size_t const points = at_rest.station.size();
    auto const rivals_within = [&](double turn) {
        Rivals rivals;
        for (std::size_t space = 0; space < at_rest.angle.size(); ++space)
            for (std::size_t k = 0; k < slices; ++k)
                for (std::size_t i = 0; i < points; ++i)
                    if (at_rest.at(space, flank, k, i) <= reach * turn)
                        rivals.index.push_back({space, flank, k, i});
        return rivals;
    };
    double first = std::numeric_limits<double>::infinity();
    for (std::size_t space = 0; space < at_rest.angle.size(); ++space)
        for (std::size_t k = 0; k < slices; ++k)
            for (std::size_t i = 0; i < points; ++i)
                first = std::min(first, at_rest.at(space, flank, k, i));

    // turn on while there is a gap, back while there is none
    double const way = first > 0 ? 1 : -1;
    double step = std::max(std::abs(first), 16 * unit_roundoff * reach) / reach;
    Rivals rivals = rivals_within(0);
    double turn = 0;
    double low = 0, high = 0;   // turns with and without a gap
    double at_low = first, at_high = first;
    bool done = first == 0;
    for (bool bracketed = done; !bracketed;)
    {
        constexpr double growth = 1.5;
        // the last look is at the limit itself
        if (!(step < limit))
            throw NumericalError("contact", "take-up", "no flank touches within a turn of " + std::to_string(limit) + " rad");
        step = std::min(growth * step, limit);
        rivals = rivals_within(step);
        double const gap = smallest(rivals.gaps(field, sense * way * step, threads));
        (gap > 0 ? low : high) = way * step;
        (gap > 0 ? at_low : at_high) = gap;
        done = gap == 0;
        turn = way * step;
        bracketed = done || (gap > 0) != (first > 0);
    }
    double const enough = 16 * unit_roundoff * reach;
    constexpr int budget = 100;
    int kept_low = 0, kept_high = 0;
    for (int i = 0; i < budget && !done; ++i)
    {
        double const share = at_low / (at_low - at_high);
        turn = low + share * (high - low);
        if (!(turn > std::min(low, high) && turn < std::max(low, high)))
            turn = 0.5 * (low + high);
        std::vector<double> const gaps = rivals.gaps(field, sense * turn, threads);
        double const gap = smallest(gaps);
        done = std::abs(gap) <= enough || std::abs(high - low) <= 4 * unit_roundoff * std::max(std::abs(low), std::abs(high));
        if (done)
            break;
        // who is further from zero here than the bracket can take it is out
        double const width = std::max(std::abs(high - turn), std::abs(turn - low));
        Rivals left;
        for (std::size_t r = 0; r < gaps.size(); ++r)
            if (gaps[r] <= reach * width)
                left.index.push_back(rivals.index[r]);
        rivals = std::move(left);
        if (gap > 0)
        {
            low = turn;
            at_low = gap;
            kept_low = 0;
            at_high *= ++kept_high > 1 ? 0.5 : 1;
        }
        else
        {
            high = turn;
            at_high = gap;
            kept_high = 0;
            at_low *= ++kept_low > 1 ? 0.5 : 1;
        }
    }
    if (!done)
        throw NumericalError("contact", "take-up", "the turn to first contact did not converge");
    std::vector<double> const gaps = rivals.gaps(field, sense * turn, threads);
    auto const touching = std::min_element(gaps.begin(), gaps.end());
    TakeUp result{turn, {}, 0};
    if (touching != gaps.end())
    {
        result.where = rivals.index[static_cast<std::size_t>(touching - gaps.begin())];
        result.gap = *touching;
    }
    return result;
}

}  // namespace hdconj
