// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// One value against what its key takes.
#pragma once

#include <string>
#include <string_view>
#include <variant>

#include "hdconj/error.hpp"
#include "hdconj/scene/parameters.hpp"
#include "hdconj/scene/raw.hpp"

namespace hdconj::scene {

/// What @p spec takes, as a phrase: "a whole number from 1 to 3".
[[nodiscard]] std::string expectation(ParameterSpec const& spec);

/// "write " and the expectation, with @p example when there is one.
[[nodiscard]] std::string write_instead(ParameterSpec const& spec, std::string_view example);

/// The value of @p entry when @p spec takes it, else what is wrong with it: one fault, or one for each bad row of a
/// list.
/// @param path     key path for the message
/// @param example  good value for the remedy; may be empty
[[nodiscard]] std::variant<Parameter, Faults> validate_value(ParameterSpec const& spec, std::string_view example,
                                                             RawEntry const& entry, std::string const& path);

/// The same for a list of lists of numbers.
[[nodiscard]] std::variant<Parameter, Faults> validate_rows(ParameterSpec const& spec, RawEntry const& entry,
                                                            std::string const& path);

}  // namespace hdconj::scene
