// SPDX-License-Identifier: GPL-3.0-or-later
// The largest torque that some wall stands.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "hdconj/design.hpp"

namespace hdconj::design {

/// The stress in the cup with a wall, by its number, under a torque [N mm].
using WallUnder = std::function<WallTrial(std::size_t, double)>;

/// The largest torque of two digits below @p asked that one of some walls stands; nothing where none is found. The
/// stress in a wall grows with the torque, at most in proportion, so that the result does not depend on @p asked where
/// every load has a result.
/// @param refused  of each wall under the torque @p asked, which none of them stands
/// @param allowed  stress [MPa]
/// @param far      torque above which a wall without a result is not tried again [N mm]
[[nodiscard]] std::optional<double> most_torque(std::vector<WallTrial> const& refused, double asked, double allowed,
                                                double far, WallUnder const& under);

}  // namespace hdconj::design
