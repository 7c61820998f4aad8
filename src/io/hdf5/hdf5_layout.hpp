// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of the result file that every verb writes, and the records of a study.
#pragma once

#include "hdconj/accuracy_files.hpp"
#include "hdconj/solution.hpp"
#include "hdf5_columns.hpp"
#include "io/mesh/spline_surface.hpp"

namespace hdconj::io::hdf5 {

/// Now, or SOURCE_DATE_EPOCH where that is set (reproducible files): ISO 8601, UTC.
[[nodiscard]] std::string date_text();

/// All of docs/reference/hdf5.md up to `/circular_spline`, summary and time.
void write_solution(Writer const& root, Solution const& solution);

/// The slices, into the group `/circular_spline`.
/// @throws std::logic_error where slices differ in their number of points, or z in its number
void write_circular_spline(Writer const& place, CircularSplineOutline const& outline);

/// The same and, where the solution has one, the toothed surface as a mesh.
void write_spline_and_surface(Writer const& place, Solution const& solution);

/// Surface and kind of tilt of the cases of a study, as columns.
template <class Cases>
void write_surface_names(Writer const& place, Cases const& cases)
{
    place.texts("surface", column(cases, [](auto const& each) { return std::string(to_string(each.surface)); }),
                "kind of the surface", "case");
    place.texts("kind", column(cases, [](auto const& each) { return std::string(to_string(each.kind)); }),
                "kind of tilt; empty without one", "case");
}

/// Names of the two flanks of a tooth space, for a map.
void write_flanks(Writer const& place);

/// The datasets of a mesh.
void write_surface(Writer const& place, Surface const& surface);

/// Records of a study as the bytes of a file. @throws Failure
[[nodiscard]] std::string accuracy_bytes(StoredAccuracy const& study);

/// The drive whose records @p file holds. @throws InputError as read_accuracy() does
[[nodiscard]] std::string stored_drive(std::filesystem::path const& file);

}  // namespace hdconj::io::hdf5
