// SPDX-License-Identifier: GPL-3.0-or-later
// The verb that is a program of its own.
#pragma once

#include <string>
#include <vector>

namespace hdconj::cli {

/// Replaces this process by `hdconj-study`, beside this program or on the path, as git does with its commands.
/// @param words the command line from "study" on
/// @return exit_failed, with a message, where there is no such program; else nothing returns
int start_study_program(std::vector<std::string> words);

}  // namespace hdconj::cli
