// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Uses the header-only and the compiled part of hdconj::core.
#include <string>

#include "hdconj/base/vec2.hpp"
#include "hdconj/error.hpp"

int main()
{
    bool const turns_left = hdconj::cross({1, 0}, {0, 1}) > 0;

    hdconj::InputError const error(hdconj::Fault{"drive.module", 3, "-1", "must be positive", "write 0.25"});
    bool const names_key = std::string(error.what()).find("drive.module") != std::string::npos;

    return turns_left && names_key ? 0 : 1;
}
