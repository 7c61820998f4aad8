// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// A smooth range of the motion, cut where the contacts of one piece change.
#pragma once

#include <utility>
#include <vector>

#include "hdconj/envelope/branch.hpp"
#include "hdconj/envelope/critical_angles.hpp"
#include "hdconj/envelope/smooth_ranges.hpp"

namespace hdconj::envelope {

/// Between two neighbouring cuts the number of contacts is constant and each is a smooth function of u.
struct CutRange
{
    CutRange(SmoothRange const& whole, std::vector<CriticalAngle> events) : range(whole), critical(std::move(events))
    {
        cuts.push_back(range.a);
        for (CriticalAngle const& c : critical)
            cuts.push_back(c.u);
        cuts.push_back(range.b);
    }

    /// Why an arc begins, or ends, with the range.
    [[nodiscard]] BranchEnd at_begin() const { return range.from_break ? BranchEnd::continues : BranchEnd::range_end; }
    [[nodiscard]] BranchEnd at_end() const { return range.to_break ? BranchEnd::continues : BranchEnd::range_end; }

    SmoothRange range;
    std::vector<CriticalAngle> critical;  ///< in order; cuts[i + 1] is the angle of critical[i]
    std::vector<double> cuts;
};

}  // namespace hdconj::envelope
