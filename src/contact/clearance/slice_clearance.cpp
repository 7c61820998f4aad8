// SPDX-License-Identifier: GPL-3.0-or-later
#include "slice_clearance.hpp"

#include <cmath>
#include <numbers>

#include "drive/drive.hpp"
#include "hdconj/base/parallel.hpp"
#include "hdconj/error.hpp"
#include "hdconj/numeric/bracketed_minimum.hpp"
#include "side_clearance_search.hpp"

namespace hdconj::contact {
namespace {

double least_on_points(TurnMinima const& minima)
{
    double least = std::numeric_limits<double>::infinity();
    for (auto const& slice : minima)
        for (distance::TurnMinimum const& m : slice)
            least = std::min(least, m.distance);
    return least;
}

/// The least that a convex distance may have between the neighbours @p i and @p q, above its chords on either side
/// prolonged. Where the contact changes from one position of the tooth to another, one chord may be too high: the lower
/// bound is told. Not a number where a point is not asked for.
double least_of_convex(std::vector<Vec2> const& place, std::vector<distance::TurnMinimum> const& minima, std::size_t i,
                       std::size_t q)
{
    auto const prolonged = [&](std::size_t from, std::size_t at) {
        double const rise = std::max(0.0, minima[from].distance - minima[at].distance);
        return minima[at].distance - rise * (place[q] - place[i]).norm() / (place[at] - place[from]).norm();
    };
    return std::min(prolonged(2 * i - q, i), prolonged(2 * q - i, q));
}

double least_of_slices(std::vector<Deepest> const& deepest)
{
    double least = std::numeric_limits<double>::infinity();
    for (Deepest const& each : deepest)
        least = std::min(least, each.turn.distance);
    return least;
}

}  // namespace

MovedSlice moved_slice(ClearanceSet const& set, std::size_t k, double distance)
{
    MovedSlice result;
    if (set.flank == nullptr) {
        for (std::size_t i = 0; i < set.point[k].size(); ++i)
            result.point.emplace_back(set.point[k][i] + distance * set.way[k][i]);
        return result;
    }
    result.flank = moved_into_material(slice_of(*set.flank, k), distance);
    result.point = result.flank.point[GapMap::right].front();
    if (set.point[k].size() > result.point.size())
        result.point.insert(result.point.end(), result.flank.point[GapMap::left].front().begin(),
                            result.flank.point[GapMap::left].front().end());
    return result;
}

SliceClearances::SliceClearances(ContactContext const& context, surface::ToothSurfaceBuilder& maker)
    : context_(context), maker_(maker), pitch_(2 * std::numbers::pi / context.scene.drive.circular_spline_teeth)
{
    std::size_t const slices = maker.z().size();
    // slices that do not cone have one motion
    std::size_t const different = context.scene.coning ? slices : 1;
    maker.find_motions(different);
    turns_.resize(different);
    parallel_for(different, context.threads, 4, [&](std::size_t k) {
        turns_[k] = std::make_unique<distance::FullTurnClearance<motion::AnyMotion>>(
            context_.tooth, maker_.motion(k).motion, pitch_, drive::pitches_per_lobe(context_.scene));
    });
}

TurnMinima SliceClearances::operator()(ClearanceSet const& set, double distance,
                                       std::vector<std::vector<std::uint8_t>> const* wanted) const
{
    std::vector<std::vector<distance::TurnMinimum>> minima(set.point.size());
    parallel_for(set.point.size(), context_.threads, 1, [&](std::size_t k) {
        distance::FullTurnClearance<motion::AnyMotion> const& turn = *turns_[of(k)];
        std::vector<Vec2> const place = moved_slice(set, k, distance).point;
        minima[k].resize(place.size());
        if (wanted == nullptr)
            return turn(place, nullptr, minima[k]);
        std::vector<Vec2> asked;
        for (std::size_t i = 0; i < place.size(); ++i)
            if ((*wanted)[k][i] != 0)
                asked.push_back(place[i]);
        std::vector<distance::TurnMinimum> found(asked.size());
        turn(asked, nullptr, found);
        for (std::size_t i = 0, next = 0; i < place.size(); ++i)
            if ((*wanted)[k][i] != 0)
                minima[k][i] = found[next++];
    });
    return minima;
}

Deepest SliceClearances::deepest(ClearanceSet const& set, std::size_t k, double distance,
                                 std::vector<distance::TurnMinimum> const& minima, double below) const
{
    Deepest best;
    MovedSlice const moved = moved_slice(set, k, distance);
    std::vector<Vec2> const& place = moved.point;
    for (std::size_t i = 0; i < minima.size(); ++i)
        if (minima[i].distance < best.turn.distance)
            best = {minima[i], place[i]};
    if (set.flank == nullptr)
        return best;
    distance::FullTurnClearance<motion::AnyMotion> const& turn = *turns_[of(k)];
    FlankGrid const& grid = moved.flank;
    double const enough = 4 * unit_roundoff * context_.tolerance.scale;
    constexpr double unseen = 1.0 / 4;  // of what clears: conjugate flanks touch everywhere, to rounding
    double const shallow = unseen * clearance_accuracy(context_.tolerance);
    for (std::size_t i = 0; i < minima.size(); ++i) {
        std::size_t const j = i % grid.points();
        int const side = i < grid.points() ? GapMap::right : GapMap::left;
        bool const first = j == 0, last = j + 1 == grid.points();
        double const here = minima[i].distance;
        if (!std::isfinite(here) || (!first && minima[i - 1].distance < here) ||
            (!last && minima[i + 1].distance < here))
            continue;
        for (int const step : {-1, 1}) {
            if (step < 0 ? first : last)
                continue;
            std::size_t const q = step < 0 ? i - 1 : i + 1;
            double const lowest = std::min(below, best.turn.distance);
            // the distance falls no faster than the flank goes on
            if (!(here - 0.5 * (place[i] - place[q]).norm() < lowest))
                continue;
            bool const before = step < 0 ? !last : !first;
            bool const after = step < 0 ? j > 1 : j + 2 < grid.points();
            if (before && after && least_of_convex(place, minima, i, q) >= lowest - shallow)
                continue;
            auto const at = [&](double s) {
                Vec2 const p = grid.between(side, 0, s);
                distance::TurnMinimum const found = turn(p, &minima[i]);
                if (found.distance < best.turn.distance)
                    best = {found, p};
                return found.distance;
            };
            (void)numeric::minimum_of_steps(at, grid.place(side, j), grid.place(side, step < 0 ? j - 1 : j + 1), here,
                                            enough);
        }
    }
    return best;
}

double SliceClearances::worst(ClearanceSet const& set, double distance, TurnMinima const& minima) const
{
    return least_of_slices(lowest(set, distance, minima, least_on_points(minima)));
}

std::vector<Deepest> SliceClearances::lowest(ClearanceSet const& set, double distance, TurnMinima const& minima,
                                             double below) const
{
    std::vector<Deepest> low(minima.size());
    parallel_for(minima.size(), context_.threads, 1,
                 [&](std::size_t k) { low[k] = deepest(set, k, distance, minima[k], below); });
    return low;
}

/// The clearance grows with the distance about as fast as it; false position on points that may decide, then all are
/// asked.
double least_offset(SliceClearances const& clearances, ClearanceSet const& set, TurnsOfSet& at_zero,
                    Tolerance const& tolerance)
{
    double const enough = std::max(clearance_accuracy(tolerance), set.known);
    // what is not entered is asked for its deepest places later, and where it touches none of them can be left out
    if (least_on_points(at_zero.minima) >= -enough)
        at_zero.deepest = clearances.lowest(set, 0, at_zero.minima);
    double const worst =
        at_zero.deepest.empty() ? clearances.worst(set, 0, at_zero.minima) : least_of_slices(at_zero.deepest);
    if (!(worst < -enough))
        return 0;
    // a place between two points may be less than either by half their distance
    double between = 0;
    for (std::size_t k = 0; set.flank != nullptr && k < set.point.size(); ++k)
        for (std::size_t i = 1; i < set.point[k].size(); ++i)
            if (i % set.flank->points() != 0)
                between = std::max(between, 0.5 * (set.point[k][i] - set.point[k][i - 1]).norm());
    std::vector<std::vector<std::uint8_t>> wanted(set.point.size());
    for (std::size_t k = 0; k < set.point.size(); ++k)
        for (distance::TurnMinimum const& m : at_zero.minima[k])
            wanted[k].push_back(m.distance - between <= worst / 2 ? 1 : 0);
    // on the points that may decide, then on all, where others may have come in
    auto const clearance_of = [&](std::vector<std::vector<std::uint8_t>> const* only) {
        return [&clearances, &set, only](double distance) {
            return clearances.worst(set, distance, clearances(set, distance, only));
        };
    };
    auto const guess = side_clearance_search(clearance_of(&wanted), -worst, enough);
    auto const distance = guess ? side_clearance_search(clearance_of(nullptr), *guess, enough) : guess;
    if (!distance)
        throw NumericalError(ErrorCode::not_converged, "contact", "least side clearance",
                             "did not converge: the side clearance that is needed may remove the whole flank");
    return *distance;
}

Closest closest(SliceClearances const& clearances, std::size_t k, Deepest const& deepest)
{
    return {deepest.turn.distance, deepest.where, clearances.motion(k).angles(deepest.turn.u).phi};
}

ClearanceSet flank_set(FlankGrid const& grid, bool both)
{
    ClearanceSet set{grid.point[GapMap::right], grid.normal[GapMap::right], 0, &grid};
    if (both) {
        for (std::size_t k = 0; k < grid.slices(); ++k) {
            auto const& p = grid.point[GapMap::left][k];
            auto const& n = grid.normal[GapMap::left][k];
            set.point[k].insert(set.point[k].end(), p.begin(), p.end());
            set.way[k].insert(set.way[k].end(), n.begin(), n.end());
        }
    }
    return set;
}

}  // namespace hdconj::contact
