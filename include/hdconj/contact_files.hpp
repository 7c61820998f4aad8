// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// What `contact` writes and prints; surfaces for other programs are in mesh_files.hpp.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "hdconj/contact.hpp"
#include "hdconj/result_files.hpp"

namespace hdconj {

/// HDF5 result file: what write_hdf5() writes of the solution, the toothed surface as a mesh, and `/contact`; layout
/// in docs/reference/hdf5.md. Written to a temporary file and renamed.
/// @throws FileError with the cause; std::logic_error where sizes in @p study contradict each other
void write_hdf5(ContactStudy const& study, std::filesystem::path const& file);

/// The printed summary that a designer reads: the drive, one row per case, where the teeth interfere, the best tilt.
[[nodiscard]] std::string summary_text(ContactStudy const& study, std::vector<WrittenFile> const& written = {});

/// The figures of summary_json() of the solution and, under "contact", of the study; keys in docs/reference/json.md.
/// Numbers are finite or null.
[[nodiscard]] std::string summary_json(ContactStudy const& study, std::vector<WrittenFile> const& written = {});

/// Names of the pictures of a study: NAME.svg or .png stands for three.
struct ContactPictures
{
    std::filesystem::path tilt;   ///< NAME-tilt.svg: contact area and least side clearance against tilt
    std::filesystem::path map;    ///< NAME-map.svg: smallest gap along each flank over tooth space and slice
    std::filesystem::path flank;  ///< NAME-flank.svg: gap over the flank that has most contact
};

/// Names of the pictures for @p file, NAME.svg or NAME.png.
[[nodiscard]] ContactPictures contact_picture_names(std::filesystem::path const& file);

/// What can be known before the long work: ending, gnuplot, targets. Throws what write_contact_pictures() would.
void check_contact_pictures(std::filesystem::path const& file);

/// Draws by gnuplot what there is to draw: the tilt picture where some surface was computed at two tilts or more, the
/// other two where the study has a map. Gaps are coloured in bands at 0, 1, 2, 5 ... 100 times the contact gap.
/// @param study  what is drawn
/// @param file   NAME.svg or NAME.png, see contact_picture_names()
/// @returns the files that were written, of the kinds "picture_tilt", "picture_map", "picture_flank"
/// @throws InputError for another ending; FileError when gnuplot is missing or a file cannot be written
std::vector<WrittenFile> write_contact_pictures(ContactStudy const& study, std::filesystem::path const& file);

}  // namespace hdconj
