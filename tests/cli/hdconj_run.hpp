// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The built program as a user calls it.
#pragma once

#include <filesystem>
#include <string>

#include "support/run_program.hpp"
#include "support/temporary_folder.hpp"

namespace hdconj::test {

/// The program, in quotes for the shell.
inline std::string const program = "'" HDCONJ_PROGRAM "'";

/// @param arguments  the verb and what follows it
inline Outcome hdconj_run(std::string const& arguments, std::filesystem::path const& folder = ".")
{
    return run(program + " " + arguments, folder);
}

inline bool contains(std::string const& text, std::string const& part)
{
    return text.find(part) != std::string::npos;
}

}  // namespace hdconj::test
