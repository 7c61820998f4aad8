// SPDX-License-Identifier: GPL-3.0-or-later
// The tooth families by name.
#pragma once

#include <vector>

#include "hdconj/profile/builder.hpp"
#include "hdconj/scene/parameters.hpp"

namespace hdconj::profile {

/// Every registered flexspline tooth family, in the order of registration.
[[nodiscard]] std::vector<scene::FamilyDescription> const& profile_families();

/// Builds the tooth of @p choice; adds to @p faults and returns an empty profile when the parameters make none.
[[nodiscard]] Profile build_profile(scene::FamilyChoice const& choice, ToothPlace const& place, Faults& faults);

}  // namespace hdconj::profile
