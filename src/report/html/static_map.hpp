// SPDX-License-Identifier: GPL-3.0-or-later
// The gaps of the flanks as a picture that needs no script.
#pragma once

#include <string>

#include "json_group.hpp"

namespace hdconj::report {

/// The smallest gap of each flank over tooth space and slice, a figure for each side; empty where there is no map.
/// @param contact  the result of `contact` as the page has it
[[nodiscard]] std::string static_gap_maps(Json const& contact);

}  // namespace hdconj::report
