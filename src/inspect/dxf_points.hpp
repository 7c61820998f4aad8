// SPDX-License-Identifier: GPL-3.0-or-later
// Points of a DXF file; private to src/inspect.
#pragma once

#include <filesystem>
#include <optional>

#include "file/csv.hpp"
#include "hdconj/inspect.hpp"

namespace hdconj::inspect {

/// A coordinate beyond 100 m is none of a gear [mm].
inline constexpr double farthest = 1e5;

/// Adds the points of @p file to @p result: of its entities POINT, POLYLINE and LWPOLYLINE. Everything else, bulges
/// too, is passed over. Lengths are in the unit that $INSUNITS names, in mm where it names none.
/// @returns nothing where the file was read
std::optional<file::Unreadable> read_dxf_points(std::filesystem::path const& file, PointReading& result);

}  // namespace hdconj::inspect
