// SPDX-License-Identifier: GPL-3.0-or-later
// What is wrong with a command line, and what may have been meant.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace hdconj::cli {

/// Says what the first word might have meant when it is no verb.
[[nodiscard]] bool is_known_verb(CLI::App const& program, std::string_view word);

/// The wrong values of the options of the chosen verb, each as "--torque: '-1' is not above 0 (...)". CLI11 itself
/// stops at the first wrong value.
[[nodiscard]] std::vector<std::string> wrong_values(CLI::App& program);

/// Prints what is wrong with the command line, as JSON too where @p given contains --json.
/// @param wrong  what is wrong, one sentence each
/// @param given  the words of the command line
/// @returns the exit status for wrong input
[[nodiscard]] int refuse_command(std::vector<std::string> const& wrong, std::vector<std::string> const& given);

/// Prints which option of the verb, or which key of the scene, an unknown option may have meant. Where a second scene
/// was given, prints which word was taken for the first.
/// @param unexpected  words, at least one
void suggest_options(CLI::App const& program, std::vector<std::string> const& unexpected, std::string const& scene);

}  // namespace hdconj::cli
