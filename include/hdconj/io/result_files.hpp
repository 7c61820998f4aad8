// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// What `solve` writes and prints.
#pragma once

#include <filesystem>
#include <string>

#include "hdconj/pipeline/solution.hpp"

namespace hdconj {

/// HDF5 result file, layout in docs/hdf5.md. Written to a temporary file and renamed.
/// @throws FileError with the cause (disk full, no permission, a folder)
void write_hdf5(Solution const& solution, std::filesystem::path const& file);

/// DXF R12 (AC1009), closed-free POLYLINEs in mm: one pitch of the circular spline, the flexspline tooth.
void write_dxf(Solution const& solution, std::filesystem::path const& file);

/// Picture of the tooth family, the branches by kind and the final outline; SVG or PNG by the file's ending.
/// @throws InputError for another ending; FileError when gnuplot is missing or the file cannot be written
void write_picture(Solution const& solution, std::filesystem::path const& file);

/// The printed summary that a designer reads.
[[nodiscard]] std::string summary_text(Solution const& solution);

/// The same figures as one JSON object.
[[nodiscard]] std::string summary_json(Solution const& solution);

}  // namespace hdconj
