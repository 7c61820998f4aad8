// SPDX-License-Identifier: GPL-3.0-or-later
// Where the positions of a sequence stand.
#pragma once

#include <vector>

#include "hdconj/running.hpp"

namespace hdconj::running {

/// Where the positions of a sequence stand.
struct SpanPlan
{
    RunSpan span = RunSpan::tooth_pitch;
    std::vector<double> pitches;  ///< that the wave generator has turned at each position, increasing
    double period = 1;            ///< after which all comes again [pitches]
    bool repeats = true;          ///< false: all but what errors of the rings do
    bool closed = true;           ///< false: after the period other teeth of the turning ring are in mesh
};

/// Positions over one tooth pitch, even.
[[nodiscard]] SpanPlan tooth_pitch_plan(int positions);

/// Positions over @p period pitches, each a whole number, as even as these can be.
[[nodiscard]] SpanPlan whole_pitch_plan(RunSpan span, int period, int positions);

/// One place after each position of @p plan, less than a pitch further, by a share that is another one each time (what
/// multiples of the golden ratio are above whole numbers).
[[nodiscard]] SpanPlan places_between(SpanPlan plan);

}  // namespace hdconj::running
