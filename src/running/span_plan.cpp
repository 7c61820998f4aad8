// SPDX-License-Identifier: GPL-3.0-or-later
#include "span_plan.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

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

SpanPlan places_between(SpanPlan plan)
{
    double share = 0;
    for (double& each : plan.pitches) {
        share += std::numbers::phi - 1;
        share -= std::floor(share);
        each += share;
    }
    return plan;
}

}  // namespace hdconj::running
