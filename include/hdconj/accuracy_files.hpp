// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// What `accuracy` writes, reads and prints.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "hdconj/accuracy.hpp"
#include "hdconj/file/written_file.hpp"

namespace hdconj {

/// Who made a report: goes into every row.
struct AccuracyOrigin
{
    std::string version;    ///< of the program
    std::string revision;   ///< of its sources
    std::string build;      ///< compiler and flags
    std::string libraries;  ///< versions of the libraries
};
/// The origin of what this program measures.
[[nodiscard]] AccuracyOrigin this_program();

/// A report, and the program that measured it.
struct StoredAccuracy
{
    AccuracyReport report;  ///< what was measured
    AccuracyOrigin origin;  ///< by which program
};

/// What is asked for: an error to keep or a time to stay within.
struct AccuracyAdvice
{
    std::optional<double> error;    ///< [mm]
    std::optional<double> seconds;  ///< wall time of a solve [s]
};

/// What can be known before the long work about the folder for a study of @p drive: one that holds a study of another
/// drive is not replaced. @throws FileError
void check_accuracy_folder(std::filesystem::path const& folder, std::string const& drive);

/// records.h5, records.csv and, where gnuplot is installed, a picture of each study as SVG and PNG, into a folder that
/// appears whole.
/// @throws FileError
std::vector<WrittenFile> write_accuracy_folder(StoredAccuracy const& study, std::filesystem::path const& folder);

/// Reads records.h5. The scene is as it was given; the notes say what a study leaves out.
/// @throws InputError where @p file holds no records, or a scene that this program does not take
[[nodiscard]] StoredAccuracy read_accuracy(std::filesystem::path const& file);

/// One row per case, method, knob and repeat, a line of names first.
[[nodiscard]] std::string accuracy_csv(StoredAccuracy const& study);

/// The picture of a study that belongs to a page: "figures/PAGE-STUDY.svg" beside it.
[[nodiscard]] std::filesystem::path accuracy_figure(std::filesystem::path const& page, std::string const& study);
/// The report as a page in Markdown.
/// @param study      what was measured
/// @param page_file  where the page will stand; links are relative to it
/// @param pictures   with links to its pictures
[[nodiscard]] std::string accuracy_page(StoredAccuracy const& study, std::filesystem::path const& page_file,
                                        bool pictures);
/// Writes that page and, where gnuplot is installed, its pictures. @throws FileError
std::vector<WrittenFile> write_accuracy_page(StoredAccuracy const& study, std::filesystem::path const& page);

/// The printed summary: a table for each study, and what is advised.
[[nodiscard]] std::string summary_text(StoredAccuracy const& study, AccuracyAdvice const& advice);

/// The same figures as one JSON object; keys in docs/reference/json.md.
[[nodiscard]] std::string summary_json(StoredAccuracy const& study, AccuracyAdvice const& advice,
                                       std::vector<WrittenFile> const& written);

}  // namespace hdconj
