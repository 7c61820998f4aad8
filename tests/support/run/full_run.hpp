// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Whether a test is to look at all that it can.
#pragma once

#include <cstdlib>
#include <string>

namespace hdconj::test {

/// HDCONJ_FULL=1 in the environment: as many drives, points and settings as there are, which takes long.
inline bool full_run()
{
    char const* value = std::getenv("HDCONJ_FULL");
    return value && std::string(value) == "1";
}

}  // namespace hdconj::test
