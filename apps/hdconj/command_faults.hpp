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

/// What is wrong with the values that were given to options of the chosen verb, each as "--torque: '-1' is not above 0
/// (...)". The parser itself tells of the first alone.
[[nodiscard]] std::vector<std::string> wrong_values(CLI::App& program);

/// Says what is wrong with the command line of the words @p given. @returns the status to exit with
[[nodiscard]] int refuse_command(std::vector<std::string> const& wrong, std::vector<std::string> const& given);

/// Says what options that nobody knows might have meant, one of the verb's or a key of the scene, and what was taken
/// for the scene where a second one was given.
/// @param unexpected  words, at least one
void suggest_options(CLI::App const& program, std::vector<std::string> const& unexpected, std::string const& scene);

}  // namespace hdconj::cli
