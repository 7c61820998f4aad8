// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// A numerical failure with its place and cause.
#pragma once

#include <stdexcept>
#include <string>

namespace hdconj {

/// A computation could not be finished to its tolerance (exit status 1).
class NumericalError : public std::runtime_error
{
  public:
    /// @param stage  where in the program: "envelope"
    /// @param place  where in the drive: "segment 2 at u = 12.3 deg"
    /// @param cause  what happened and what can be done
    NumericalError(std::string const& stage, std::string const& place, std::string const& cause)
        : std::runtime_error(stage + ": " + place + ": " + cause)
    {
    }
};

}  // namespace hdconj
