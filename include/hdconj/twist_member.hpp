// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// What the twist of a drive consists of.
#pragma once

#include <string>

namespace hdconj {

/// One of the members in series between the circular spline and what holds the cup. Each carries the whole torque.
struct TwistMember
{
    std::string name;      ///< in words: "cup in torsion"
    double stiffness = 0;  ///< torque over its twist [N mm/rad]; 0: it has none, as the backlash
    double twist = 0;      ///< its part of the twist [rad]
    double fraction = 0;   ///< of the whole twist
    /// Estimated discretisation error [N mm/rad]; 0 for a stiffness that the scene gives.
    double stiffness_error = 0;
    double twist_error = 0;     ///< likewise [rad]
    double fraction_error = 0;  ///< likewise
};

}  // namespace hdconj
