// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Writes and prints what `solve` computes, and reads it back for another verb.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "hdconj/file/written_file.hpp"
#include "hdconj/scene/reading.hpp"
#include "hdconj/solution.hpp"

namespace hdconj {

/// HDF5 result file, layout in docs/reference/hdf5.md. Written to a temporary file and renamed.
/// @throws FileError with the cause (disk full, no permission, a folder)
void write_hdf5(Solution const& solution, std::filesystem::path const& file);

/// DXF R12 (AC1009), POLYLINEs in mm, decimals to 1e-10 mm. Layers: CIRCULAR_SPLINE, one pitch (open, one polyline per
/// slice at its z); FLEXSPLINE_TOOTH, the tooth at the major axis (open); NEUTRAL_CURVE (closed).
/// @throws FileError
void write_dxf(Solution const& solution, std::filesystem::path const& file);

/// The right flank of the circular spline's tooth as points in mm, from tip to root, y from the pitch line: a file of
/// the tooth family "points" for `[circular_spline.profile]`. Only the longest stretch that one piece of the
/// flexspline's flank makes, which is smooth; the file's head says where the tooth stands.
/// @throws FileError where the space has no such stretch, or the file cannot be written
void write_spline_tooth(Solution const& solution, std::filesystem::path const& file);

/// Picture of the tooth family, the branches by kind and the final outline; SVG or PNG by the file's ending.
/// Drawn by gnuplot, which is looked for on the PATH.
/// @throws InputError for another ending; FileError when gnuplot is missing or the file cannot be written
void write_picture(Solution const& solution, std::filesystem::path const& file);

/// What can be known before the long work: ending, gnuplot, target. Throws what write_picture() would.
void check_picture(std::filesystem::path const& file);

/// What the printed summary holds.
enum class SummaryDetail
{
    figures,  ///< geometry, clearance, errors and times
    zones     ///< the table of conjugate zones too
};

/// The printed summary that a designer reads.
[[nodiscard]] std::string summary_text(Solution const& solution, std::vector<WrittenFile> const& written = {},
                                       SummaryDetail detail = SummaryDetail::figures);

/// The same figures as one JSON object, keys in docs/reference/json.md. Numbers are finite or null.
[[nodiscard]] std::string summary_json(Solution const& solution, std::vector<WrittenFile> const& written = {});

/// What contact or load found of the clearance of a case.
struct StoredCase
{
    std::string surface;                    ///< word of ToothSurface
    std::string kind;                       ///< word of TiltKind; empty without a tilt
    double tilt = 0;                        ///< [rad]
    std::optional<double> flank_clearance;  ///< with the scene's side clearance, where that is stored; negative beyond
                                            ///< its error: interference [mm]
    double flank_z = 0;                     ///< where [mm]
    bool interferes = false;                ///< more than the scene's side clearance is needed
    double side_clearance = 0;              ///< with which it does not [mm]
    double tip_radius = 0;                  ///< of the tip circle at z = 0 that goes with it [mm]
};

/// What later work needs of a result file.
struct StoredOutline
{
    std::string scene;  ///< text of the scene that was solved, after --set
    Solution solution;  ///< of it: the circular spline bit for bit as it was written, tip circle, errors of
                        ///< chords, points, side clearance and cup, notes and judgement
    std::string verb;   ///< of a result with cases: contact, load or run. The outline is that of a case: side
                        ///< clearance, tip circle and tilt may differ from the scene's. Empty: solve
    std::optional<double> side_clearance;  ///< that the outline of a case includes, where the file says so [mm]
    std::vector<StoredCase> cases;         ///< of contact or load
    scene::NamedTexts files;               ///< what the files held that the scene names; empty in older results
};

/// Reads the scene that the result @p file holds, and its geometry's faults. A file that the scene names and the result
/// does not keep is looked for beside the result.
/// @throws InputError where it is not there
[[nodiscard]] scene::SceneReading examine_stored_scene(StoredOutline const& stored, std::filesystem::path const& file,
                                                       std::vector<std::string> const& overrides = {});

/// Reads what write_hdf5 wrote of the circular spline, of any verb that solves one.
/// @throws InputError where @p file is none of our results, or its parts contradict each other
[[nodiscard]] StoredOutline read_outline(std::filesystem::path const& file);

/// Tells HDF5 not to tidy its memory when the process ends, where the system takes all of it at once. For a program
/// that is done with its files by then; called before its first file. A library must not.
void leave_memory_at_exit();

}  // namespace hdconj
