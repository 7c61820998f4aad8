// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The fault of one parameter of a family, with its place in the scene.
#pragma once

#include <string>
#include <string_view>

#include "hdconj/scene/fault.hpp"
#include "hdconj/scene/parameters.hpp"

namespace hdconj {

/// What is wrong with the key @p key of @p choice: path, line and value as given, and the reason and remedy.
[[nodiscard]] Fault parameter_fault(FamilyChoice const& choice, std::string_view key, std::string reason, std::string remedy);

}  // namespace hdconj
