// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of a drive that follow from its scene without solving anything.
#pragma once

#include <cmath>
#include <numbers>

#include "hdconj/base/rigid_motion.hpp"
#include "hdconj/error.hpp"
#include "hdconj/profile/profile.hpp"
#include "hdconj/solution.hpp"
#include "hdconj/wavegen/registry.hpp"

namespace hdconj::drive {

/// The tooth that the scene gives of a member, the circular spline where @p outside, in its own frame, or faults.
[[nodiscard]] profile::Profile tooth_of(Scene const& scene, bool outside, Faults& faults);

/// The tooth that the scene gives, in its own frame, or faults; the flexspline's where both are given.
[[nodiscard]] profile::Profile given_tooth(Scene const& scene, Faults& faults);

/// Radii of the flexspline's ring that follow from scene and given tooth: inner radius m z_f/2 - h_f - delta unless
/// given, r_m = inner radius + delta/2 - neutral_offset (design 3.1).
[[nodiscard]] PairGeometry ring_geometry(Scene const& scene, profile::Profile const& tooth);

/// The same, and what needs the amplitude of the wave generator: tip circle r_m + pitch line + w0 - h_a of the given
/// tooth unless given (design 3.1, 5.1). In the reverse problem this puts the pitch line of the circular spline's tooth
/// where that of the flexspline's is at the major axis.
[[nodiscard]] PairGeometry pair_geometry(Scene const& scene, profile::Profile const& tooth, double amplitude);
/// The same of a scene without faults.
[[nodiscard]] PairGeometry pair_geometry(Scene const& scene);

/// Wave generator's shape on the ring of @p tooth, or faults.
[[nodiscard]] wavegen::AnyWaveShape wave_shape(Scene const& scene, profile::Profile const& tooth, Faults& faults);

/// Radius of the origin of the frame of a given circular-spline tooth: the frame's y runs inward.
[[nodiscard]] double given_tooth_seat(PairGeometry const& g, profile::Profile const& tooth);

/// Frame of the circular spline's tooth next to the space on +y, clockwise: y from the pitch line of the flexspline at
/// the major axis towards the axis.
[[nodiscard]] inline Pose spline_tooth_frame(Scene const& scene, PairGeometry const& g)
{
    double const angle = std::numbers::pi / scene.drive.circular_spline_teeth;
    double const radius = g.r_m + g.w0 + g.pitch_line;
    return {-std::cos(angle), -std::sin(angle), radius * Vec2(std::sin(angle), std::cos(angle))};
}

/// Adds a fault where the tooth is wider than its share of the pitch of its member, the circular spline where @p
/// outside.
void validate_width(Scene const& scene, profile::Profile const& tooth, PairGeometry const& g, bool outside,
                    Faults& faults);

/// Number of pitches by which the tooth moves along the circular spline in one lobe: (z_c - z_f)/n.
[[nodiscard]] int pitches_per_lobe(Scene const& scene);

/// The width over which a drive's slices stand: 0 where it has one plane [mm].
[[nodiscard]] inline double width_of_slices(Scene const& scene)
{
    return scene.slices && scene.slices->count > 1 ? scene.circular_spline.width.value_or(0) : 0;
}

}  // namespace hdconj::drive
