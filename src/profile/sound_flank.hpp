// SPDX-License-Identifier: GPL-3.0-or-later
// Whether a curve that a user composed freely is one side of a tooth, or a whole one.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "hdconj/profile/builder.hpp"

namespace hdconj::profile {

/// A fault of @p key for each of these, in the order of the flank; nothing added: the flank is sound.
///   - a curve whose parameter stands still (a cusp, or control points on each other), so that it has no tangent
///   - a flank that is not highest at its tip and lowest at its root, to a thousandth of its height
///   - a flank left of the tooth's centre line
///   - a flank that crosses itself
/// Found on a polygon with chord error of a 1024th of the height; the standing parameter by the sign of |x|^2 in
/// Bernstein form.
/// @param right_flank  from tip to root, y from the pitch line
void validate_flank(std::vector<FlankSegment> const& right_flank, scene::FamilyChoice const& choice,
                    std::string_view key, Faults& faults);

/// The same of a whole tooth, from left root to right root through points between @p bottom and @p top: refused are a
/// curve without a tangent, one that leaves the heights of its points by more than a 64th of the height, ends whose
/// heights differ by more than a 16th, and a crossing.
/// @return the height of the curve, which may rise a little above @p top between points
double validate_whole_tooth(FlankSegment const& tooth, double top, double bottom, scene::FamilyChoice const& choice,
                            std::string_view key, Faults& faults);

/// "(0.1, -0.2)" of a point for messages.
[[nodiscard]] std::string short_point(Vec2 const& p);

}  // namespace hdconj::profile
