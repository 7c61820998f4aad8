// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// What `solve` prints and writes of a neutral curve that it has found.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "hdconj/file/written_file.hpp"
#include "hdconj/wanted_curve.hpp"

namespace hdconj {

/// The printed summary: where flanks touch, the curve and what it asks of the ring, each figure with its error.
[[nodiscard]] std::string summary_text(WantedCurve const& found, std::vector<WrittenFile> const& written = {});

/// The same figures as one JSON object, keys in docs/reference/json.md. Numbers are finite or null.
[[nodiscard]] std::string summary_json(WantedCurve const& found, std::vector<WrittenFile> const& written = {});

/// All figures and rows, layout in docs/reference/hdf5.md.
/// @throws FileError where it cannot be written
void write_hdf5(WantedCurve const& found, std::filesystem::path const& file);

/// One wave of the curve as CSV, angle in degrees and displacement in mm: a file of the wave generator family "table".
/// @throws FileError where it cannot be written
void write_cam_table(WantedCurve const& found, std::filesystem::path const& file);

/// The surface of the cam as CSV, the parallel curve inside the neutral one: polar angle, radius, x and y of one turn.
/// @throws FileError where it cannot be written
void write_inner_surface(WantedCurve const& found, std::filesystem::path const& file);

/// The file of the cam that write_completed_drive() writes beside @p scene_file: NAME-cam.csv.
[[nodiscard]] std::filesystem::path completed_drive_cam(std::filesystem::path const& scene_file);

/// The scene of the completed drive: the flexspline's tooth on the found curve, with the table beside it. Every verb
/// takes it.
/// @throws FileError where a file cannot be written
void write_completed_drive(WantedCurve const& found, std::filesystem::path const& scene_file);

/// The neutral curve, its curvature and its error over half a wave. NAME.svg or NAME.png, drawn by gnuplot.
/// @throws FileError where gnuplot is missing or the file cannot be written
void write_picture(WantedCurve const& found, std::filesystem::path const& file);

}  // namespace hdconj
