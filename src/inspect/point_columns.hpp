// SPDX-License-Identifier: GPL-3.0-or-later
// The header of a file of measured points; private to src/inspect.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "hdconj/error.hpp"

namespace hdconj::inspect {

/// One column of the file.
struct PointColumn
{
    std::size_t at = 0;   ///< number of the column, from 0
    double factor = 1;    ///< to mm
    std::string heading;  ///< as written; empty: the file has no such column

    [[nodiscard]] bool given() const { return !heading.empty(); }
};

/// The columns that a header names.
struct PointColumns
{
    char separator = ',';
    PointColumn x, y, z, tooth, flank;
};

/// Reads the header @p text of the file @p name. Faults are added to @p faults; the columns are of no use where there
/// are any.
[[nodiscard]] PointColumns point_columns(std::string_view text, int line, std::string const& name, Faults& faults);

/// How a file of points begins, for messages.
inline constexpr char const* first_line = "begin the file with a line that names its columns, such as x,y";

}  // namespace hdconj::inspect
