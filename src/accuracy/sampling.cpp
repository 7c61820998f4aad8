// SPDX-License-Identifier: GPL-3.0-or-later
// How an outline is made of points: equal steps of u, and the adaptive sampler.
#include <algorithm>
#include <cmath>
#include <vector>

#include "hdconj/envelope/sample.hpp"
#include "study_bench.hpp"

namespace hdconj::accuracy {
namespace {

/// Points of the boundary without its lands: those of @p sampled for each piece, neighbours sharing their common one.
template <class Sampled>
std::vector<Vec2> boundary_points(StudyDrive const& drive, Sampled const& sampled)
{
    std::vector<Vec2> all;
    bool joined = false;
    for (conjugate::BoundaryPiece const& piece : drive.pieces) {
        if (piece.arc < 0) {
            joined = false;  // the tip land of a tooth is one chord
            continue;
        }
        std::vector<Vec2> points = sampled(piece);
        for (Vec2& p : points)
            p = drive.placed(piece, p);
        all.insert(all.end(), points.begin() + (joined ? 1 : 0), points.end());
        joined = true;
    }
    return all;
}

/// Every piece with its own ends and the grid points between them.
std::vector<Vec2> uniform_points(StudyDrive const& drive, long count)
{
    double const step = 2 * drive.motion().half_lobe() / static_cast<double>(count);
    return boundary_points(drive, [&](conjugate::BoundaryPiece const& piece) {
        envelope::ContactArc const& arc = drive.arc(piece);
        envelope::AnyEnvelope const envelope = drive.envelope(piece);
        std::vector<Vec2> points{envelope.point(arc, piece.begin).p};
        bool const up = piece.end > piece.begin;
        double const a = std::min(piece.begin, piece.end) / step, b = std::max(piece.begin, piece.end) / step;
        auto const first = static_cast<long>(std::floor(a)) + 1, last = static_cast<long>(std::ceil(b)) - 1;
        for (long k = 0; k <= last - first; ++k)
            points.push_back(envelope.point(arc, step * static_cast<double>(up ? first + k : last - k)).p);
        points.push_back(envelope.point(arc, piece.end).p);
        return points;
    });
}

/// What the adaptive sampler makes of the boundary.
struct AdaptivePoints
{
    std::vector<Vec2> points;
    std::size_t evaluations = 0;
    double estimate = 0;
};

AdaptivePoints adaptive_points(StudyDrive const& drive, double chord)
{
    AdaptivePoints made;
    made.points = boundary_points(drive, [&](conjugate::BoundaryPiece const& piece) {
        envelope::SampledArc const sampled =
            envelope::sample_arc(drive.envelope(piece), drive.arc(piece), piece.begin, piece.end, chord, 1);
        made.evaluations += sampled.evaluations;
        made.estimate = std::max({made.estimate, sampled.chord, sampled.error});
        std::vector<Vec2> points;
        for (envelope::EnvelopePoint const& e : sampled.points)
            points.push_back(e.p);
        return points;
    });
    return made;
}

/// @param truth  the boundary without its lands
StudyRecord sampling_record(StudyBench const& bench, ReferenceCurve const& truth, char const* method, char const* knob,
                            double value, std::vector<Vec2> const& points)
{
    StudyRecord record{"sampling", {}, method, knob, value};
    CurveDifference const difference = truth.compare(points, bench.drive.height());
    record.error = difference.points;
    record.hausdorff = difference.hausdorff;
    record.evaluations = record.points = static_cast<double>(points.size());
    return record;
}

}  // namespace

void study_sampling(StudyBench const& bench)
{
    StudyDrive const& drive = bench.drive;
    ReferenceCurve const truth = bench.reference.inner();
    constexpr int first = 8, last = 20, last_of_sample = 16, last_of_quick = 13;
    for (int power = first; power <= bench.length(last, last_of_sample, last_of_quick); power += 2) {
        long const count = 1L << power;
        auto const make = [&] { return uniform_points(drive, count); };
        bench.measure(sampling_record(bench, truth, "equal steps of u", "steps over the lobe",
                                      static_cast<double>(count), make()),
                      [&] { (void)make(); });
    }
    constexpr int chords = 8, chords_of_sample = 6, chords_of_quick = 4;
    for (double const chord :
         tolerances_of(drive.scene.drive, bench.length(chords, chords_of_sample, chords_of_quick))) {
        auto const make = [&] { return adaptive_points(drive, chord); };
        AdaptivePoints const made = make();
        StudyRecord record = sampling_record(bench, truth, "adaptive", "chord", chord, made.points);
        record.estimate = made.estimate;
        record.evaluations = static_cast<double>(made.evaluations);
        bench.measure(record, [&] { (void)make(); });
    }
}

}  // namespace hdconj::accuracy
