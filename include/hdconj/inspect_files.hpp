// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// What `inspect` prints and writes.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "hdconj/file/written_file.hpp"
#include "hdconj/inspect.hpp"

namespace hdconj {

/// The printed summary: registration, figures with their intervals, and what each figure means.
[[nodiscard]] std::string summary_text(Inspection const& inspection, std::vector<WrittenFile> const& written = {});

/// The same figures as one JSON object, keys in docs/reference/json.md. Numbers are finite or null.
[[nodiscard]] std::string summary_json(Inspection const& inspection, std::vector<WrittenFile> const& written = {});

/// Every point with its deviation as CSV: line, z, tooth, flank, arc length, deviation, its error and what became of
/// it.
/// @throws FileError where it cannot be written
void write_deviations(Inspection const& inspection, std::filesystem::path const& file);

}  // namespace hdconj
