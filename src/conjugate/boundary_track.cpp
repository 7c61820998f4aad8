// SPDX-License-Identifier: GPL-3.0-or-later
#include "boundary_track.hpp"

#include <cmath>
#include <iterator>
#include <string>

#include "hdconj/base/parallel.hpp"
#include "hdconj/envelope/chord_bound.hpp"
#include "hdconj/error.hpp"
#include "hdconj/numeric/bracketed_root.hpp"

namespace hdconj::conjugate {
namespace {

/// Length of a curve from @p a to @p b as that of the circular arc with the same chord and the same turn of its normal:
/// right to the fourth order of the chord, the chord itself only to the second. The chord where normals turn by more
/// than a right angle, as over a cusp.
double arc_length(envelope::EnvelopePoint const& a, envelope::EnvelopePoint const& b)
{
    double const chord = (b.p - a.p).norm(), along = a.n.dot(b.n);
    if (!(along > 0))
        return chord;
    double const half = 0.5 * std::atan2(std::abs(cross(a.n, b.n)), along);
    return half > 0 ? chord * half / std::sin(half) : chord;
}

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
        bool const coarse = std::ranges::any_of(chords, [&](Chords const& slice) { return slice.errors[i] > chord; });
        double const middle = 0.5 * (stations[i] + stations[i + 1]);
        if (coarse && middle > stations[i] && middle < stations[i + 1])
            added.push_back(middle);
    }
    return added;
}

}  // namespace

std::vector<BoundaryStretch> stretches_of(ToothSpaceBoundary const& curve, std::vector<BoundaryPiece> const& pieces)
{
    std::vector<BoundaryStretch> stretches;
    for (BoundaryPiece const& piece : pieces) {
        BoundaryPiece const* before = stretches.empty() ? nullptr : &stretches.back().pieces.back();
        if (before != nullptr && before->arc >= 0 && piece.arc >= 0 &&
            outline_goes_on(curve.tooth(), *before, curve.arc(*before), piece, curve.arc(piece))) {
            stretches.back().pieces.push_back(piece);
            continue;
        }
        OutlineStretch const origin = curve.made_by(piece);
        stretches.push_back({origin.kind, origin.segment, {piece}});
    }
    return stretches;
}

BoundaryTrack::BoundaryTrack(ToothSpaceBoundary const& curve, std::vector<BoundaryStretch> const& stretches,
                             Measure measure, double chord)
    : curve_(&curve), measure_(measure)
{
    std::vector<std::size_t> begins;  // index of the first station of each stretch
    for (BoundaryStretch const& stretch : stretches) {
        begins.push_back(stations_.size());
        for (BoundaryPiece const& piece : stretch.pieces) {
            pieces_.push_back(piece);
            envelope::SampledArc const sampled = curve.sampled(piece, chord);
            for (std::size_t i = 0; i < sampled.points.size(); ++i) {
                envelope::EnvelopePoint const& e = sampled.points[i];
                if (i > 0) {
                    envelope::EnvelopePoint const& before = sampled.points[i - 1];
                    length_ += measure == Measure::rulings ? arc_length(before, e) : (e.p - before.p).norm();
                }
                double const u = i == 0 ? piece.begin : i + 1 == sampled.points.size() ? piece.end : e.u;
                stations_.push_back(
                    {measure != Measure::profile ? length_ : curve.profile_parameter(piece, u), pieces_.size() - 1, u});
            }
        }
    }
    if (stations_.empty())
        return;
    first_ = stations_.front().share;
    last_ = stations_.back().share;
    double const range = last_ - first_;
    double highest = 0;
    for (std::size_t i = 0; i < stations_.size(); ++i) {
        double const share = range != 0 ? (stations_[i].share - first_) / range
                                        : static_cast<double>(i) / static_cast<double>(stations_.size());
        constexpr double rounding = 64 * unit_roundoff;
        monotone_ = monotone_ && share >= highest - rounding && share <= 1 + rounding;
        highest = std::max(highest, share);
        stations_[i].share = std::min(highest, 1.0);
    }
    stations_.back().share = 1;
    monotone_ = monotone_ && range != 0;
    for (std::size_t i = 1; i < begins.size(); ++i)
        joints_.push_back(stations_[begins[i]].share);
}

double BoundaryTrack::between(Station const& a, Station const& b, double share) const
{
    double const part = (share - a.share) / (b.share - a.share);
    double const guess = a.u + part * (b.u - a.u);
    if (measure_ == Measure::length)
        return guess;
    if (measure_ == Measure::rulings) {
        // as far along the chord: contacts run along their path at no steady pace, least so near a cusp
        constexpr std::uintmax_t budget = 60;
        Vec2 const from = curve_->at(pieces_[a.piece], a.u).p, chord = curve_->at(pieces_[a.piece], b.u).p - from;
        double const whole = chord.squaredNorm();
        if (!(part > 0 && part < 1 && whole > 0))
            return guess;
        auto const beyond = [&](double t) {
            return (curve_->at(pieces_[a.piece], a.u + t * (b.u - a.u)).p - from).dot(chord) / whole - part;
        };
        numeric::ShrunkBracket const along = numeric::shrunk_bracket(beyond, 0, 1, -part, 1 - part, 0, budget);
        return a.u + 0.5 * (along.low + along.high) * (b.u - a.u);
    }
    double const wanted = first_ + share * (last_ - first_);
    auto const excess = [&](double u) { return curve_->profile_parameter(pieces_[a.piece], u) - wanted; };
    numeric::BracketedRoot const root = numeric::bracketed_root(excess, std::min(a.u, b.u), std::max(a.u, b.u));
    return root.found ? root.x : guess;
}

TrackPoint BoundaryTrack::at(double share) const
{
    auto const after = std::upper_bound(stations_.begin(), stations_.end(), share,
                                        [](double s, Station const& station) { return s < station.share; });
    auto const not_before = std::lower_bound(stations_.begin(), stations_.end(), share,
                                             [](Station const& station, double s) { return station.share < s; });
    if (not_before != after) {
        CurvePoint const first = point(*not_before);
        CurvePoint const last = point(*(after - 1));
        return {first.p, first.n, last.n};
    }
    // strictly between two stations of one piece: joints are pairs of stations with one share
    Station const& a = *(after - 1);
    CurvePoint const c = curve_->at(pieces_[a.piece], between(a, *after, share));
    return {c.p, c.n, c.n};
}

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
