// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The wave generator families by name.
#pragma once

#include <vector>

#include "hdconj/scene/parameters.hpp"

namespace hdconj {

/// Every registered wave generator family, in the order of registration.
/// `waves` and `family` are keys of [wave_generator] itself, not of a family.
[[nodiscard]] std::vector<FamilyDescription> const& wave_generator_families();

}  // namespace hdconj
