// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The wave generator families by name.
#pragma once

#include <variant>
#include <vector>

#include "hdconj/scene/fault.hpp"
#include "hdconj/scene/parameters.hpp"
#include "hdconj/wavegen/cosine_cam.hpp"

namespace hdconj {

/// Any registered wave generator shape; visited once per run.
using AnyWaveShape = std::variant<CosineCam>;

/// Every registered wave generator family, in the order of registration.
/// `waves` and `family` are keys of [wave_generator] itself, not of a family.
[[nodiscard]] std::vector<FamilyDescription> const& wave_generator_families();

/// Builds the shape of @p choice with @p waves waves per turn; adds to @p faults what is wrong with it.
[[nodiscard]] AnyWaveShape build_wave_shape(FamilyChoice const& choice, int waves, Faults& faults);

}  // namespace hdconj
