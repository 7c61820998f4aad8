// SPDX-License-Identifier: GPL-3.0-or-later
// The layout of each result, docs/reference/hdf5.md, and the parts that several of them share.
#pragma once

#include "columns.hpp"
#include "hdconj/accuracy_files.hpp"
#include "hdconj/contact.hpp"
#include "hdconj/inspect.hpp"
#include "hdconj/load.hpp"
#include "hdconj/measured.hpp"
#include "hdconj/running.hpp"
#include "hdconj/solution.hpp"
#include "hdconj/wanted_curve.hpp"
#include "hdconj/wedm.hpp"
#include "io/mesh/spline_surface.hpp"

namespace hdconj::io::layout {

/// Number of the layout of a result file; goes up when a reader of the old one would misread the new one.
inline constexpr int format_version = 2;

/// What the file of records of a study says it is.
inline constexpr char const* accuracy_format = "hdconj-accuracy";
inline constexpr int accuracy_version = 2;

/// Now, or SOURCE_DATE_EPOCH where that is set (reproducible files): ISO 8601, UTC.
[[nodiscard]] std::string date_text();

/// Everything that a result file may hold, with every part that only some drives have: what read_layout() looks for.
/// @param balls  of the bearing: forces of single balls are in N, those of a line of balls (0) in N/mm
[[nodiscard]] RecordedGroup whole_layout(int balls);

/// What a file is, who made it and when, and the name of the drive.
void write_origin(Writer const& root, char const* format, int version, Scene const& scene);

/// The attribute `scene` and, where the scene names files, the group `scene_files` with what they held.
void write_scene(Writer const& root, Scene const& scene);

/// All of docs/reference/hdf5.md up to `/circular_spline`, summary and time.
void write_solution(Writer const& root, Solution const& solution);

/// The slices, into the group `/circular_spline`.
/// @throws std::logic_error where slices differ in their number of points, or z in its number
void write_circular_spline(Writer const& place, CircularSplineOutline const& outline);

/// The side clearance of the written case [mm]; 0 without cases.
template <class Study>
[[nodiscard]] double written_side_clearance(Study const& study)
{
    return study.cases.empty() ? 0 : study.cases[study.written_case].backlash_offset;
}

/// All of a solution, its circular spline with the side clearance [mm] and, where there is one, the toothed surface.
void write_solution(Writer const& root, Solution const& solution, double side_clearance);

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

/// All of a result, into the root. @throws std::logic_error where its sizes contradict each other
void write_result(Writer const& root, Solution const& solution);
void write_result(Writer const& root, ContactStudy const& study);
/// @param measured  written beside the simulation; null: none
void write_result(Writer const& root, LoadStudy const& study, Measurement const* measured = nullptr);
void write_result(Writer const& root, RunStudy const& study);
void write_result(Writer const& root, Inspection const& inspection);
void write_result(Writer const& root, WantedCurve const& found);
/// What `/load/measured` holds.
void write_result(Writer const& root, Measurement const& measured);
void write_result(Writer const& root, StoredAccuracy const& study);
void write_result(Writer const& root, WireSetUps const& programs);

}  // namespace hdconj::io::layout
