// SPDX-License-Identifier: GPL-3.0-or-later
#include "gap_minima.hpp"

#include <algorithm>

#include "hdconj/base/tolerance.hpp"

namespace hdconj::load {
namespace {

/// Place in a stretch between two points where the slope is zero, from negative at 0 to positive at 1 (regula falsi,
/// Illinois).
FlankCurve::Place turning_place(FlankView const& view, std::size_t stretch, double low, double high, double at_low,
                                double at_high)
{
    constexpr int budget = 100;
    constexpr double enough = 16 * unit_roundoff;
    int side = 0;
    double share = low;
    for (int i = 0; i < budget && high - low > enough; ++i) {
        share = (low * at_high - high * at_low) / (at_high - at_low);
        if (!(share > low && share < high))
            share = 0.5 * (low + high);
        double const slope = view.slope({stretch, share});
        if (slope == 0)
            break;
        if (slope > 0) {
            high = share;
            at_high = slope;
            if (side == 1)
                at_low /= 2;
            side = 1;
        } else {
            low = share;
            at_low = slope;
            if (side == -1)
                at_high /= 2;
            side = -1;
        }
    }
    return {stretch, share};
}

}  // namespace

bool is_far(FlankView const& view)
{
    std::vector<Vec2> const& point = view.curve.points();
    std::vector<double> const& length = view.curve.arc_length();
    constexpr std::size_t stride = 8;
    std::size_t const last = length.size() - 1;
    for (std::size_t i = 0;; i = std::min(i + stride, last)) {
        double const reach = length[std::min(i + stride, last)] - length[i];
        if (view.gap(point[i]) - std::max(reach, length[i] - length[i - std::min(i, stride)]) <= view.search.limit)
            return false;
        if (i == last)
            return true;
    }
}

std::vector<GapMinimum> gap_minima(FlankView const& view, std::vector<double> const& gap)
{
    std::vector<GapMinimum> found;
    FlankCurve const& curve = view.curve;
    std::size_t const last_point = gap.size() - 1;
    double const least = *std::min_element(gap.begin(), gap.end());
    if (least > view.search.limit + curve.longest())
        return found;
    // The slopes at the ends of a stretch decide; stretches of no length are edges.
    bool falling = false, begun = false;
    for (std::size_t i = 0; i < last_point; ++i) {
        if (!(curve.length(i) > 0))
            continue;
        if (std::min(gap[i], gap[i + 1]) > view.search.limit + curve.length(i)) {
            falling = true;
            begun = true;
            continue;
        }
        double const at_begin = view.slope({i, 0}), at_end = view.slope({i, 1});
        if (!begun) {
            if (at_begin >= 0)
                found.push_back({{i, 0}, true});
        } else if (falling && at_begin >= 0)
            found.push_back({{i, 0}, false});  // an edge, or rounding at a point
        begun = true;
        if (at_begin < 0 && at_end > 0)
            found.push_back({turning_place(view, i, 0, 1, at_begin, at_end), false});
        falling = at_end < 0;
    }
    if (begun && falling && gap[last_point] <= view.search.limit)
        found.push_back({{curve.last(), 1}, true});
    return found;
}

}  // namespace hdconj::load
