// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The tooth families by name.
#pragma once

#include <vector>

#include "hdconj/scene/parameters.hpp"

namespace hdconj {

/// Every registered flexspline tooth family, in the order of registration.
[[nodiscard]] std::vector<FamilyDescription> const& profile_families();

}  // namespace hdconj
