// SPDX-License-Identifier: GPL-3.0-or-later
// Whether a flank that a user composed freely is one side of a tooth.
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

/// "(0.1, -0.2)" of a point for messages.
[[nodiscard]] std::string short_point(Vec2 const& p);

}  // namespace hdconj::profile
