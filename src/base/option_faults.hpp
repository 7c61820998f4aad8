// SPDX-License-Identifier: GPL-3.0-or-later
// Limits of options that are whole numbers.
#pragma once

#include <optional>
#include <string>

#include "hdconj/error.hpp"

namespace hdconj {

/// Adds a fault of @p option where @p given is not from @p least to @p most.
/// @param remedy  after "write ", such as "one such as 16"
inline void require_whole(Faults& faults, char const* option, std::optional<int> given, int least, int most,
                          std::string const& remedy)
{
    if (given && (*given < least || *given > most))
        faults.push_back({option, 0, std::to_string(*given),
                          "no whole number from " + std::to_string(least) + " to " + std::to_string(most),
                          "write " + remedy});
}

}  // namespace hdconj
