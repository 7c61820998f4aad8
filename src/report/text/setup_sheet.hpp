// SPDX-License-Identifier: GPL-3.0-or-later
// What stands on the setup sheet of a wire program: one page for whoever clamps and cuts the part.
#pragma once

#include <string>
#include <vector>

#include "hdconj/wire_files.hpp"

namespace hdconj::report {

/// Rows of cells below a heading.
struct SheetTable
{
    std::string heading;
    std::vector<std::vector<std::string>> rows;

    /// Characters of each column's widest cell.
    [[nodiscard]] std::vector<std::size_t> widths() const;
};

/// A page in words.
struct SetupSheet
{
    std::string title;
    std::vector<SheetTable> tables;
};

[[nodiscard]] SetupSheet setup_sheet(WireSetUps const& programs, std::vector<WireFile> const& files);

}  // namespace hdconj::report
