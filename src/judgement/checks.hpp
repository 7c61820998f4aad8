// SPDX-License-Identifier: GPL-3.0-or-later
// One function for each figure of a design that is checked: a note where it leaves its range, else nothing.
#pragma once

#include <optional>

#include "judgement.hpp"

namespace hdconj::judgement {

/// Radial deformation against m (z_c - z_f)/2.
[[nodiscard]] std::optional<Note> deformation(UnsolvedPair const& pair);
/// Teeth of the circular spline that a wave moves the flexspline by.
[[nodiscard]] std::optional<Note> tooth_difference(UnsolvedPair const& pair);
/// Tip land of the flexspline; nothing where the tip is round.
[[nodiscard]] std::optional<Note> tip_land(UnsolvedPair const& pair);
/// E c: the bending stress of the ring over its change of curvature, with c from the neutral layer to the surface that
/// is farther from it. Modulus as the cup has it, else of steel. [N/mm]
[[nodiscard]] double stress_of_bending(Scene const& scene);
/// Bending stress of the ring by sigma = E c w0 (n^2 - 1)/r_m^2 [MPa].
///
/// The curvature of an inextensional ring changes by (w + w'')/r_m^2, at most w0 (n^2 - 1)/r_m^2 for w = w0 cos(n phi).
/// Source: S. Timoshenko, Strength of Materials, part II (thin ring). Accuracy: first order in w0/r_m; teeth, cup and
/// edges are left out. The verb `load` computes the stress of the cup.
[[nodiscard]] double bending_stress(Scene const& scene, PairGeometry const& geometry);
/// That stress against its limits.
[[nodiscard]] std::optional<Note> wall_stress(UnsolvedPair const& pair);
/// Where along a lobe the flexspline's tips leave the circular spline's tip circle, in the slice where a tilt makes
/// that smallest.
[[nodiscard]] std::optional<Note> late_mesh(UnsolvedPair const& pair);

/// Teeth of a lobe that touch with a flank at the same time.
[[nodiscard]] std::optional<Note> flank_contact(Solution const& solution);
/// What a flank loses in contacts that end in a cusp.
[[nodiscard]] std::optional<Note> undercut(Solution const& solution);
/// Tip land of the circular spline.
[[nodiscard]] std::optional<Note> land(Solution const& solution);
/// Narrowest width of the tooth space down to where the centre of the wire of @p scene goes.
[[nodiscard]] std::optional<Note> narrow_space(Scene const& scene, Solution const& solution);

}  // namespace hdconj::judgement
