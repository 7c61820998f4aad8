// SPDX-License-Identifier: GPL-3.0-or-later
// Samples an envelope arc so that its polygon stays within a chord error, with no more points than that needs.
#pragma once

#include <algorithm>
#include <cmath>

#include "hdconj/envelope/arc_sampler.hpp"

namespace hdconj::envelope {

/// Points equidistributed in sqrt(turn * length). For a smooth curve each chord then has the same error, which takes
/// the fewest points possible up to higher order. Chords that are still too long are cut again until every chord
/// passes.
///
/// @param from, to  interval of u inside the arc; from > to gives the points in reverse order
/// @param threads   for chords that are bounded; estimated ones are evaluated as they are made
///
/// Accuracy: every point is an exact contact, not interpolated. `chord` is within a few per cent of the true chord
/// error, and by default not below it.
template <motion::RelativeMotion Motion>
[[nodiscard]] SampledArc sample_arc(Envelope<Motion> const& envelope, ContactArc const& arc, double from, double to,
                                    double chord, int threads, ChordTest test = ChordTest::bound)
{
    SampledArc result = ArcSampler<Motion>(envelope, arc, from, to, chord, threads, test)();
    for (EnvelopePoint const& e : result.points)
        if (e.error > result.error)
            result.error = std::max(result.error, envelope.off_curve(arc, e));
    if (from > to)
        std::reverse(result.points.begin(), result.points.end());
    return result;
}

/// The points of sample_arc() over the whole arc with estimated chords, handed to @p take part by part. A long polygon
/// costs no memory but what @p take keeps of it.
/// @param take  (points, how many are to come with them, unless chords are cut)
/// @returns what was asked of the chords, without points
template <motion::RelativeMotion Motion, class Take>
SampledArc sample_arc_in_parts(Envelope<Motion> const& envelope, ContactArc const& arc, double chord, Take&& take)
{
    return ArcSampler<Motion>(envelope, arc, arc.u_begin, arc.u_end, chord, 1, ChordTest::estimate).in_parts(take);
}

/// About how many chords sample_arc() takes for the whole arc, from eight of them: for sharing out work among threads.
template <motion::RelativeMotion Motion>
[[nodiscard]] double expected_chords(Envelope<Motion> const& envelope, ContactArc const& arc, double chord)
{
    constexpr int parts = 8;
    double total = 0;
    EnvelopePoint before = envelope.point(arc, arc.u_begin);
    for (int i = 1; i <= parts; ++i) {
        EnvelopePoint const after = envelope.point(arc, arc_parameter_to_u(arc, static_cast<double>(i) / parts));
        total += std::sqrt(chord_error(before, after) / chord);
        before = after;
    }
    return std::max(1.0, total);
}

}  // namespace hdconj::envelope
