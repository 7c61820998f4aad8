// SPDX-License-Identifier: GPL-3.0-or-later
// How the sections of the teeth move in the planes of the slices, where the wall moves along the axis.
#pragma once

#include <optional>
#include <vector>

#include "hdconj/solution.hpp"
#include "hdconj/wavegen/material_displacement.hpp"
#include "hdconj/wavegen/registry.hpp"

namespace hdconj::surface {

/// Displacements of the sections by the planes @p z of a drive whose wall cones (coning.axial_shift = "mapped").
///
/// Empty where the planes cut no other teeth than those of their slices: one plane, or no axial shift wanted; and where
/// the sections have no series: first-order kinematics, whose teeth do not stand along the normal, and wave generators
/// whose shape has breaks.
/// @throws NumericalError as the neutral curve, the axial shift and the cup do, and where a plane meets the wall behind
/// the apex of the cone
[[nodiscard]] std::optional<std::vector<wavegen::MaterialDisplacement>> section_displacements(
    Solution const& base, wavegen::AnyWaveShape const& shape, std::vector<double> const& z, int threads);

}  // namespace hdconj::surface
