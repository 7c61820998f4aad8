// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// What verbs check of a single word of the command line, for CLI11's check(): what is wrong with it, or nothing.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace hdconj::cli {

/// @p given should be the name of a file or folder: an empty one, as from an unset shell variable, must not quietly mean the default.
[[nodiscard]] std::string name_fault(std::string const& given);

/// @p given should be one of @p words.
[[nodiscard]] std::string word_fault(std::string const& given, std::vector<std::string_view> const& words);

/// @p given should be an angle in degrees. @param remedy  what to write
[[nodiscard]] std::string angle_fault(std::string const& given, std::string const& remedy);
/// The same, one of a list.
[[nodiscard]] std::string angle_fault(std::string const& given);

/// The number at the beginning of such an angle [deg].
[[nodiscard]] double angle_deg(std::string const& given);

/// @p given should be a finite number. @param remedy  "write a torque in N m such as 28"
[[nodiscard]] std::string number_fault(std::string const& given, std::string const& remedy);

/// The same, above 0.
[[nodiscard]] std::string positive_fault(std::string const& given, std::string const& remedy);

}  // namespace hdconj::cli
