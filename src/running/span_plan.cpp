// SPDX-License-Identifier: GPL-3.0-or-later
#include "span_plan.hpp"

#include <algorithm>
#include <cmath>

namespace hdconj::running {

SpanPlan tooth_pitch_plan(int positions)
{
    SpanPlan plan;
    for (int i = 0; i < positions; ++i)
        plan.pitches.push_back(static_cast<double>(i) / positions - 0.5);
    return plan;
}

SpanPlan whole_pitch_plan(RunSpan span, int period, int positions)
{
    SpanPlan plan{span, {}, static_cast<double>(period)};
    int const count = std::min(period, positions);
    for (int i = 0; i < count; ++i)
        plan.pitches.push_back(std::round(static_cast<double>(i) * period / count));
    return plan;
}

}  // namespace hdconj::running
