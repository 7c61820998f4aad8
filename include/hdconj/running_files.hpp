// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// What `run` writes and prints.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "hdconj/result_files.hpp"
#include "hdconj/running.hpp"

namespace hdconj {

/// HDF5 result file: what write_hdf5() writes of the solution, and `/running`; layout in docs/reference/hdf5.md.
/// @throws FileError with the cause
void write_hdf5(RunStudy const& study, std::filesystem::path const& file);

/// The printed summary: each sequence with its errors and largest orders, then losses and efficiency.
[[nodiscard]] std::string summary_text(RunStudy const& study, std::vector<WrittenFile> const& written = {});

/// The figures of summary_json() of the solution and, under "running", of the study; keys in docs/reference/json.md.
/// Numbers are finite or null.
[[nodiscard]] std::string summary_json(RunStudy const& study, std::vector<WrittenFile> const& written = {});

/// Names of the pictures of a running drive: NAME.svg or .png stands for three.
struct RunPictures
{
    std::filesystem::path error;       ///< NAME-error.svg: transmission error over the wave generator, each sequence
    std::filesystem::path spectrum;    ///< NAME-spectrum.svg: its orders
    std::filesystem::path efficiency;  ///< NAME-efficiency.svg: efficiency over torque, each speed and temperature
};

/// Names of the pictures for @p file, NAME.svg or NAME.png.
[[nodiscard]] RunPictures run_picture_names(std::filesystem::path const& file);

/// What can be known before the long work: ending, gnuplot, targets. Throws what write_run_pictures() would.
void check_run_pictures(std::filesystem::path const& file);

/// Draws by gnuplot what there is to draw.
/// @returns the files that were written, of the kinds "picture_error", "picture_spectrum", "picture_efficiency"
/// @throws InputError for another ending; FileError when gnuplot is missing or a file cannot be written
std::vector<WrittenFile> write_run_pictures(RunStudy const& study, std::filesystem::path const& file);

}  // namespace hdconj
