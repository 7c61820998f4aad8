// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// What `inspect` prints and writes.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "hdconj/file/written_file.hpp"
#include "hdconj/inspect.hpp"
#include "hdconj/scene/reading.hpp"

namespace hdconj {

/// The printed summary: registration, figures with their intervals, and what each figure means.
[[nodiscard]] std::string summary_text(Inspection const& inspection, std::vector<WrittenFile> const& written = {});

/// The same figures as one JSON object, keys in docs/reference/json.md. Numbers are finite or null.
[[nodiscard]] std::string summary_json(Inspection const& inspection, std::vector<WrittenFile> const& written = {});

/// Every point with its deviation as CSV: line, z, tooth, flank, arc length, deviation, its error and what became of
/// it.
/// @throws FileError where it cannot be written
void write_deviations(Inspection const& inspection, std::filesystem::path const& file);

/// The place of each tooth with both flanks along the pitch circle, clockwise: tooth, place, uncertainty. Of the first
/// plane; the place of a tooth is the mean of those of its flanks. A scene takes the file of a whole ring in place of
/// the list errors.flexspline.pitch or errors.circular_spline.pitch.
/// @throws FileError where it cannot be written
void write_pitch(Inspection const& inspection, std::filesystem::path const& file);

/// All figures and points, layout in docs/reference/hdf5.md.
/// @throws FileError where it cannot be written
void write_hdf5(Inspection const& inspection, std::filesystem::path const& file);

/// The chart, one page: deviations along the flanks, positions and radial shifts round the ring. NAME.svg or NAME.png,
/// drawn by gnuplot.
void write_chart(Inspection const& inspection, std::filesystem::path const& file);

/// The file of points that write_measured_tooth() writes beside @p scene_file: NAME-tooth.csv.
[[nodiscard]] std::filesystem::path measured_tooth_points(std::filesystem::path const& scene_file);

/// The scene that write_measured_tooth() writes, with the points in the scene itself (family "b-spline", the same
/// spline): for whoever wants to solve it before it is written.
/// @param inspection  of one member's teeth, with a mean tooth
/// @param scene_file  only its name and folder are used
/// @throws FileError where there is no mean tooth
[[nodiscard]] scene::SceneReading measured_tooth_scene(Inspection const& inspection,
                                                       std::filesystem::path const& scene_file);

/// The scene with the mean measured tooth in place of its own: family "points", with the points beside it. Where the
/// scene gave the tooth of the other member only, the measured one is given in its place and the other is solved for: a
/// measured circular spline makes a reverse problem without axial effects, whose flexspline keeps its addendum and
/// dedendum.
/// @throws FileError where there is no mean tooth, or a file cannot be written
void write_measured_tooth(Inspection const& inspection, std::filesystem::path const& scene_file);

}  // namespace hdconj
