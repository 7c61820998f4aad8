// SPDX-License-Identifier: GPL-3.0-or-later
// The header of a measured curve: which columns hold torque and angle, and in which units; private to src/rig.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "hdconj/error.hpp"

namespace hdconj::rig {

/// One column of the file.
struct MeasuredColumn
{
    std::size_t at = 0;   ///< number of the column, from 0
    double factor = 0;    ///< to rad, N mm, A or counts
    std::string heading;  ///< as written; empty: the file has no such column

    [[nodiscard]] bool given() const { return !heading.empty(); }
};

/// The columns that a header names: torque or current, angle or position.
struct MeasuredColumns
{
    char separator = ',';
    std::size_t count = 0;
    MeasuredColumn torque, current, angle, position;
};

/// Reads the header @p text of the file @p name. Faults of the header are added to @p faults; the columns are of no
/// use where there are any.
[[nodiscard]] MeasuredColumns measured_columns(std::string_view text, int line, std::string const& name,
                                               Faults& faults);

/// A fault of the whole file @p name.
[[nodiscard]] Fault fault_of_file(std::string const& name, std::string reason, std::string remedy);

/// A file whose first line is missing or no header.
inline constexpr char const* how_to_begin =
    "begin the file with a line such as \"angle [arcmin], torque [N m]\" or \"current [A], position [counts]\"";

}  // namespace hdconj::rig
