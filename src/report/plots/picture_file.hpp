// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// From a plot's script to a file.
#pragma once

#include <filesystem>
#include <string>

#include "hdconj/result_files.hpp"

namespace hdconj::report {

enum class PictureFormat
{
    svg,
    png
};

/// What the file's ending asks for. @throws InputError for an ending that is not known
[[nodiscard]] PictureFormat format_of(std::filesystem::path const& file);

/// One picture of several: NAME.svg becomes NAME-what.svg.
[[nodiscard]] std::filesystem::path picture_part(std::filesystem::path const& file, std::string const& what);

/// What gnuplot draws by a script of @ref plot_script. @param file  that an error names
/// @throws FileError with gnuplot's own words
[[nodiscard]] std::string drawing(std::string const& script, std::filesystem::path const& file);

/// Draws and writes the file, timed for the summaries.
/// @throws FileError with gnuplot's own words, or where the file cannot be written
WrittenFile write_drawing(std::string const& kind, std::string const& script, std::filesystem::path const& file);

}  // namespace hdconj::report
