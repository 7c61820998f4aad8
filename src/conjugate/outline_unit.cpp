// SPDX-License-Identifier: GPL-3.0-or-later
#include "outline_unit.hpp"

#include <cstddef>
#include <iterator>
#include <string>

#include "hdconj/base/parallel.hpp"
#include "hdconj/envelope/chord_bound.hpp"
#include "hdconj/error.hpp"

namespace hdconj::conjugate {
namespace {

envelope::EnvelopePoint begin_of(TrackPoint const& point)
{
    return {0, 0, point.p, point.after, 0};
}
envelope::EnvelopePoint end_of(TrackPoint const& point)
{
    return {0, 0, point.p, point.before, 0};
}

/// The chords of one slice between its stations: estimated errors, and bends as chord_errors() has them.
struct Chords
{
    std::vector<double> errors, bends;

    explicit Chords(std::vector<TrackPoint> const& points)
    {
        for (std::size_t i = 0; i + 1 < points.size(); ++i) {
            envelope::EnvelopePoint const a = begin_of(points[i]), b = end_of(points[i + 1]);
            double const length = (b.p - a.p).norm();
            errors.push_back(envelope::chord_error(a, b));
            bends.push_back(length > 0 && a.n.dot(b.n) > 0 ? cross(a.n, b.n) / length : 0);
        }
    }
};

/// Puts the bound of every chord in the place of its estimate where that is not to be relied on (bends_alike()).
void bound(Chords& chords, BoundaryTrack const& track, std::vector<double> const& stations,
           std::vector<TrackPoint> const& points)
{
    constexpr double nothing_known = 1;
    auto const at = [&](double share) { return begin_of(track.at(share)); };
    std::size_t evaluations = 0;
    for (std::size_t i = 0; i < chords.errors.size(); ++i)
        if (!envelope::bends_alike(chords.bends, i))
            chords.errors[i] = envelope::chord_bound(at, stations[i], begin_of(points[i]), stations[i + 1],
                                                     end_of(points[i + 1]), nothing_known, evaluations);
}

/// Middles of the intervals that any slice wants cut.
std::vector<double> middles(std::vector<double> const& stations, std::vector<Chords> const& chords, double chord)
{
    std::vector<double> added;
    for (std::size_t i = 0; i + 1 < stations.size(); ++i) {
        bool const coarse =
            std::any_of(chords.begin(), chords.end(), [&](Chords const& slice) { return slice.errors[i] > chord; });
        double const middle = 0.5 * (stations[i] + stations[i + 1]);
        if (coarse && middle > stations[i] && middle < stations[i + 1])
            added.push_back(middle);
    }
    return added;
}

}  // namespace

void sample(OutlineUnit& unit, double chord, int intervals, int threads)
{
    constexpr int fewest = 4;
    int const probe_chords = std::max(fewest, intervals);
    std::vector<double> added;
    for (int i = 0; i <= probe_chords; ++i)
        added.push_back(static_cast<double>(i) / probe_chords);
    for (BoundaryTrack const& track : unit.tracks)
        added.insert(added.end(), track.joints().begin(), track.joints().end());
    std::sort(added.begin(), added.end());
    added.erase(std::unique(added.begin(), added.end()), added.end());
    std::size_t const slices = unit.tracks.size();
    unit.at.assign(slices, {});
    std::vector<Chords> chords(slices, Chords({}));
    constexpr int deepest = 48;
    for (int depth = 0; !added.empty(); ++depth) {
        if (depth > deepest)
            throw NumericalError(ErrorCode::not_converged, "slices", "matched outline",
                                 "could not be sampled to a chord error of " + std::to_string(chord) + " mm");
        std::vector<double> merged;
        std::merge(unit.stations.begin(), unit.stations.end(), added.begin(), added.end(), std::back_inserter(merged));
        parallel_for(slices, threads, 8, [&](std::size_t k) {
            std::vector<TrackPoint> points;
            points.reserve(merged.size());
            std::size_t old = 0;
            for (double const share : merged)
                points.push_back(old < unit.stations.size() && unit.stations[old] == share ? unit.at[k][old++]
                                                                                           : unit.tracks[k].at(share));
            chords[k] = Chords(points);
            unit.at[k] = std::move(points);
        });
        unit.stations = std::move(merged);
        added = middles(unit.stations, chords, chord);
        if (!added.empty())
            continue;
        // by their estimates all are fine enough
        parallel_for(slices, threads, 8,
                     [&](std::size_t k) { bound(chords[k], unit.tracks[k], unit.stations, unit.at[k]); });
        added = middles(unit.stations, chords, chord);
    }
    for (Chords const& slice : chords)
        for (double const error : slice.errors)
            unit.chord = std::max(unit.chord, error);
}

}  // namespace hdconj::conjugate
