// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// From script to file; private to src/io.
#pragma once

#include <filesystem>
#include <string>

#include "hdconj/io/result_files.hpp"
#include "picture_script.hpp"

namespace hdconj {

/// What the file's ending asks for. @throws InputError for an ending that is not known
[[nodiscard]] PictureFormat format_of(std::filesystem::path const& file);

/// One picture of several: NAME.svg becomes NAME-what.svg.
[[nodiscard]] std::filesystem::path picture_part(std::filesystem::path const& file, std::string const& what);

/// Runs gnuplot and writes what it draws.
/// @throws FileError with gnuplot's own words, or where the file cannot be written
void draw_picture(std::string const& script, std::filesystem::path const& file);

/// The same, timed, for the summaries.
WrittenFile drawn(std::string const& kind, std::string const& script, std::filesystem::path const& file);

}  // namespace hdconj
