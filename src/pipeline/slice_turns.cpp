// SPDX-License-Identifier: GPL-3.0-or-later
#include "slice_turns.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include "clearing_search.hpp"
#include "drive.hpp"
#include "hdconj/numeric/error.hpp"
#include "hdconj/numeric/parallel.hpp"

namespace hdconj::detail {
namespace {

double worst_of(TurnMinima const& minima)
{
    double worst = std::numeric_limits<double>::infinity();
    for (auto const& slice : minima)
        for (TurnMinimum const& m : slice)
            worst = std::min(worst, m.distance);
    return worst;
}

}  // namespace

SliceTurns::SliceTurns(ContactBench const& bench) : bench_(bench), pitch_(2 * std::numbers::pi / bench.scene.drive.circular_spline_teeth)
{
    std::size_t const slices = bench.maker.z().size();
    // slices that do not cone have one motion
    std::size_t const different = bench.scene.coning ? slices : 1;
    for (std::size_t k = 0; k < different; ++k)
        (void)bench.maker.motion(k);
    turns_.resize(different);
    parallel_for(different, bench.threads, 4, [&](std::size_t k) {
        turns_[k] = std::make_unique<FullTurnClearance<ErasedMotion>>(bench_.tooth, bench_.maker.motion(k).motion, pitch_, pitches_per_lobe(bench_.scene));
    });
}

TurnMinima SliceTurns::operator()(ClearanceSet const& set, double distance, std::vector<std::vector<std::uint8_t>> const* wanted) const
{
    std::vector<std::vector<TurnMinimum>> minima(set.point.size());
    parallel_for(set.point.size(), bench_.threads, 1, [&](std::size_t k) {
        minima[k].resize(set.point[k].size());
        TurnMinimum const* hint = nullptr;
        for (std::size_t i = 0; i < set.point[k].size(); ++i)
        {
            if (wanted != nullptr && (*wanted)[k][i] == 0)
                continue;
            minima[k][i] = (*turns_[of(k)])(set.point[k][i] + distance * set.way[k][i], hint);
            hint = &minima[k][i];
        }
    });
    return minima;
}

/// The clearance grows with the distance about as fast as it; false position on points that may decide, then all are asked.
double least_clearing(SliceTurns const& turns, ClearanceSet const& set, TurnMinima const& at_zero, Tolerance const& tolerance)
{
    double const worst = worst_of(at_zero);
    double const enough = tolerance.coincidence();
    if (!(worst < -enough))
        return 0;
    std::vector<std::vector<std::uint8_t>> wanted(set.point.size());
    for (std::size_t k = 0; k < set.point.size(); ++k)
        for (TurnMinimum const& m : at_zero[k])
            wanted[k].push_back(m.distance <= worst / 2 ? 1 : 0);
    // on the points that may decide, then on all, where others may have come in
    auto const clearance_of = [&](std::vector<std::vector<std::uint8_t>> const* only) {
        return [&turns, &set, only](double distance) { return worst_of(turns(set, distance, only)); };
    };
    auto const guess = clearing_search(clearance_of(&wanted), -worst, enough);
    auto const distance = guess ? clearing_search(clearance_of(nullptr), *guess, enough) : guess;
    if (!distance)
        throw NumericalError("contact", "clearing offset", "did not converge; the flank may be swallowed by the side clearance that it needs");
    return *distance;
}

Closest closest(std::vector<TurnMinimum> const& minima, std::vector<Vec2> const& points, ErasedMotion const& motion)
{
    auto const worst = std::min_element(minima.begin(), minima.end(), [](TurnMinimum const& a, TurnMinimum const& b) { return a.distance < b.distance; });
    return {worst->distance, points[static_cast<std::size_t>(worst - minima.begin())], motion.angles(worst->u).phi};
}

/// One or both flanks as one list per slice: of a symmetric pair the right one stands for both.
ClearanceSet flank_set(FlankGrid const& grid, bool both)
{
    ClearanceSet set{grid.point[GapMap::right], grid.normal[GapMap::right]};
    if (both)
    {
        for (std::size_t k = 0; k < grid.slices(); ++k)
        {
            auto const& p = grid.point[GapMap::left][k];
            auto const& n = grid.normal[GapMap::left][k];
            set.point[k].insert(set.point[k].end(), p.begin(), p.end());
            set.way[k].insert(set.way[k].end(), n.begin(), n.end());
        }
    }
    return set;
}

/// The bottom of the space, moved along the centre line; at most some tens of points.
ClearanceSet root_set(MatchedOutline const& outline)
{
    constexpr std::size_t enough = 64;
    std::size_t const first = outline.landmarks[1];
    std::size_t const last = outline.landmarks[3];
    std::size_t const stride = std::max<std::size_t>(1, (last - first) / enough);
    ClearanceSet set;
    for (auto const& points : outline.points)
    {
        set.point.emplace_back();
        for (std::size_t i = first; i <= last; i += stride)
            set.point.back().push_back(points[i]);
        // the middle of the bottom is where the tip goes deepest
        set.point.back().push_back(points[outline.landmarks[2]]);
        set.way.emplace_back(set.point.back().size(), Vec2{0, 1});
    }
    return set;
}

}  // namespace hdconj::detail
