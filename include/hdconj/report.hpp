// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// `report`: a drive, or several, as one HTML file that shows figures, teeth in mesh, load and wire.
#pragma once

#include <array>
#include <exception>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "hdconj/contact.hpp"
#include "hdconj/design.hpp"
#include "hdconj/error.hpp"
#include "hdconj/file/written_file.hpp"
#include "hdconj/load.hpp"
#include "hdconj/running.hpp"
#include "hdconj/scene_words.hpp"
#include "hdconj/solution.hpp"
#include "hdconj/turning_teeth.hpp"
#include "hdconj/wedm.hpp"

namespace hdconj {

/// What a report can be of.
enum class ReportPart
{
    solve,    ///< circular spline, teeth in mesh; always there
    contact,  ///< gaps over the face width
    load,     ///< the drive under torque
    run,      ///< the drive while it turns
    wedm,     ///< wire paths
    design    ///< the drive against the design rules
};

/// Words of ReportPart: the verbs that compute them.
template <>
inline constexpr std::array<std::string_view, 6> words_of<ReportPart>{"solve", "contact", "load",
                                                                      "run",   "wedm",    "design"};

/// What is asked of each drive of a report.
struct ReportOptions
{
    std::vector<ReportPart> parts;  ///< beside ReportPart::solve
    ContactOptions contact;         ///< of the part `contact`
    LoadOptions load;               ///< of the part `load`
    RunOptions run;                 ///< of the part `run`
    /// Asked before each part, torque and position: when true, what is computed so far is kept, and the rest is named
    /// as left out. Null: nobody stops it.
    std::function<bool()> stop = {};
};

/// A part that a report does not show.
struct LeftOut
{
    std::string part;     ///< a word of ReportPart, or "teeth in mesh"
    std::string why;      ///< in words
    bool failed = false;  ///< it was asked for
};

namespace report {
struct StoredResult;
}

/// One drive and what was computed of it, or read.
struct ReportedDrive
{
    /// Of the scene. Of a result file what the page needs beside `stored`: scene, circular spline, tip circle, errors
    /// of chords and points, judgement and notes.
    Solution solution;
    std::optional<TurningTeeth> teeth;                   ///< in the planes of outline()
    std::optional<ContactStudy> contact;                 ///< where asked for
    std::optional<LoadStudy> load;                       ///< where asked for
    std::optional<RunStudy> run;                         ///< where asked for
    WireSetUps wire;                                     ///< where asked for, else empty
    std::optional<SceneDesign> design;                   ///< where asked for
    std::shared_ptr<report::StoredResult const> stored;  ///< what a result file holds; null: all is computed
    std::string origin;             ///< the file, and what was computed beside it; empty: all is computed
    std::vector<LeftOut> left_out;  ///< and why
    /// The circular spline that the page shows: as the contact was computed with, where it was.
    [[nodiscard]] CircularSplineOutline const& outline() const
    {
        return contact ? contact->solution.circular_spline : solution.circular_spline;
    }
};

/// A drive of which a report shows nothing.
struct FailedDrive
{
    std::string name;  ///< of the drive
    std::string why;   ///< in words
};

/// The drives of a page, as far as they were computed.
struct Report
{
    std::vector<ReportedDrive> drives;  ///< those computed, in the order of the sources
    std::vector<FailedDrive> failed;    ///< those left out, in the same order
};

/// Makes the drives of a report one after the other by @p make, called with each of @p sources. One that fails is
/// named, with the drive that @p name_of says, and leaves the others as they are.
/// @throws InputError, NumericalError  the first failure, where no drive is left
template <class Sources, class NameOf, class Make>
[[nodiscard]] Report report_drives(Sources const& sources, NameOf const& name_of, Make const& make)
{
    Report report;
    std::exception_ptr first;
    auto const enter = [&](auto const& source, std::exception const& failure) {
        report.failed.push_back({name_of(source), failure.what()});
        if (!first)
            first = std::current_exception();
    };
    for (auto const& source : sources) {
        try {
            report.drives.push_back(make(source));
        } catch (InputError const& error) {
            enter(source, error);
        } catch (NumericalError const& error) {
            enter(source, error);
        }
    }
    if (report.drives.empty() && first)
        std::rethrow_exception(first);
    return report;
}

/// What @p report has not though it was asked for, a line each.
[[nodiscard]] std::vector<std::string> missing_of(Report const& report);

/// A neutral curve that is wanted has no report.
[[nodiscard]] Faults check_report(Scene const& scene);

/// Faults of the options, among them those of parts that are not asked for.
[[nodiscard]] Faults check_report(ReportOptions const& options);

/// Faults of those @p options that change how a scene is computed, for a report of result files only.
[[nodiscard]] Faults check_without_scene(ReportOptions const& options);

/// That such an option is given. @param option  as a command line has it
[[nodiscard]] Fault idle_option(std::string const& option);

/// Computes the parts of a report by solve(), study_contact(), study_load(), study_run(), wire_set_ups() and
/// design_beside(). A part
/// that cannot be computed leaves the others as they are and is named in ReportedDrive::left_out.
/// @param scene     the drive, lengths in mm, angles in rad; domain: no faults by check_scene() and check_report()
/// @param options   what is asked
/// @param on_stage  is told each stage that begins; null: nobody
/// @param progress  is told how much of a part is done; null: nobody
/// @throws InputError, NumericalError as solve()
[[nodiscard]] ReportedDrive report_drive(Scene const& scene, ReportOptions const& options,
                                         StageObserver const& on_stage = {}, Progress const& progress = {});

/// Whether @p file is a result file rather than a scene: by its ending, .h5 or .hdf5, or by its first bytes.
[[nodiscard]] bool is_result_file(std::filesystem::path const& file);

/// A drive from what `solve`, `contact`, `load` or `run` wrote: ReportedDrive::stored and what stands beside it.
/// @throws InputError where @p file is no such file, is cut off or damaged, or is of another version of the layout, and
/// with the faults of a scene that this version refuses
[[nodiscard]] ReportedDrive read_drive(std::filesystem::path const& file);

/// Adds what a result file does not hold, and computes it from the scene that it holds: the teeth in mesh. What is
/// asked for and not there is named in ReportedDrive::left_out.
[[nodiscard]] ReportedDrive complete_drive(ReportedDrive drive, ReportOptions const& options,
                                           StageObserver const& on_stage = {});

/// The page: one HTML file that needs no network and no other file. Arrays are those of the result files, in base64.
/// Figures are in double precision, large arrays in single, and maps of more than 200,000 values are thinned.
/// @param report  with at least one drive; several are compared
[[nodiscard]] std::string report_page(Report const& report);

/// What a page was made of as one JSON object, keys in docs/reference/json.md: the drives with their parts and what was
/// left out, drives that failed, and the files with their bytes.
[[nodiscard]] std::string summary_json(Report const& report, std::vector<WrittenFile> const& written);

}  // namespace hdconj
