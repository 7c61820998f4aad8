// SPDX-License-Identifier: GPL-3.0-or-later
// The tooth that a scene gives, and its pitch.
#pragma once

#include "hdconj/error.hpp"
#include "hdconj/profile/profile.hpp"
#include "hdconj/solution.hpp"

namespace hdconj::drive {

/// tooth_of() without advice on other numbers.
[[nodiscard]] profile::Profile build_tooth(Scene const& scene, bool outside, Faults& faults);

/// Where a tooth exceeds its share of the pitch of its member by most.
struct WidestPlace
{
    double excess = 0;          ///< on either side [mm]; 0: the tooth fits
    Vec2 point = Vec2::Zero();  ///< of the outline, in the tooth frame
    double pitch = 0;           ///< at its height [mm]
};
/// The tooth must fit into its share of the flexspline at every height; a circular-spline tooth, @p outside, into its
/// share of the circle, which gets wider towards its root.
[[nodiscard]] WidestPlace widest_place(Scene const& scene, profile::Profile const& tooth, PairGeometry const& g,
                                       bool outside);

}  // namespace hdconj::drive
