// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Values of a scene as text.
#pragma once

#include <string>

#include "hdconj/scene/parameters.hpp"

namespace hdconj::scene {

/// A value as it would stand in a scene: number, quoted word or list, which is cut short after about one line.
[[nodiscard]] std::string value_text(ParameterValue const& value);

}  // namespace hdconj::scene
