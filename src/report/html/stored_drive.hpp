// SPDX-License-Identifier: GPL-3.0-or-later
// A drive of a report from a stored result, whatever reads it.
#pragma once

#include "hdconj/report.hpp"
#include "io/layout/stored_group.hpp"

namespace hdconj::report {

/// What the root @p result of a result called @p file holds, as read_drive() has it.
/// @throws Misfit where it is no such result; InputError for a scene that this version refuses
[[nodiscard]] ReportedDrive drive_from(io::layout::StoredGroup const& result, std::filesystem::path const& file);

}  // namespace hdconj::report
