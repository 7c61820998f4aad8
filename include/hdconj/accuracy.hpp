// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Work-precision studies: for each method and setting a series from coarse to fine, error against time.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "hdconj/error.hpp"
#include "hdconj/scene.hpp"

namespace hdconj {

/// A number that a study does not have.
inline constexpr double not_measured = std::numeric_limits<double>::quiet_NaN();

/// One run of one method with one setting on one drive.
///
/// Errors are geometric and against the reference; what the program itself estimates, and what is left of the meshing
/// condition, stand beside them and are never taken for them.
struct StudyRecord
{
    std::string study;                ///< "tolerance"; the names are those of study_kinds()
    std::string drive;                ///< the scene's name, or "design-07" of the sample
    std::string method;               ///< "adaptive"
    std::string knob;                 ///< "solver.tolerance"
    double value = 0;                 ///< of the knob
    int repeat = 0;                   ///< number of the run with this setting, from 0
    std::string unit = "mm";          ///< of the errors; contact areas are in mm^2
    double error = not_measured;      ///< L-infinity: largest distance of a computed point from the true curve
    double hausdorff = not_measured;  ///< distance of the computed curve from the true one, both ways, chords included
    double estimate = not_measured;   ///< the method's own estimate of the latter
    double normal_speed = not_measured;  ///< |n.v| at the computed contacts, the largest [mm/rad]
    int branches = 0;                    ///< found, where the method looks for branches or roots
    int missed = 0;      ///< of these; in the study polynomial-fit points of the grid without a contact on their flank
    int extra = 0;       ///< branches or roots found that the reference does not have
    double seconds = 0;  ///< wall time
    double evaluations = 0;        ///< of the meshing condition or the envelope point; 0: not counted
    double points = 0;             ///< of the result
    double memory = not_measured;  ///< largest resident set of the process while it ran [MB]
    int threads = 1;               ///< that the run used

    /// The error that methods are compared by.
    [[nodiscard]] double largest_error() const { return hausdorff >= error || !(error == error) ? hausdorff : error; }
};

/// The repeats of one setting together; of the sample, its worst design.
struct ConvergenceLevel
{
    std::string study;                   ///< as in StudyRecord
    std::string drive;                   ///< as in StudyRecord
    std::string method;                  ///< as in StudyRecord
    std::string knob;                    ///< as in StudyRecord
    std::string unit;                    ///< of the errors
    double value = 0;                    ///< of the knob
    double error = not_measured;         ///< largest_error() of the records; of a sample the worst
    double estimate = not_measured;      ///< the method's own estimate of the error, the largest
    double normal_speed = not_measured;  ///< as in StudyRecord, the largest
    int missed = 0;                      ///< as in StudyRecord
    int extra = 0;                       ///< as in StudyRecord
    double median = 0;                   ///< of the wall times [s]
    double least = 0;                    ///< wall time [s]
    double most = 0;                     ///< wall time [s]
    double evaluations = 0;              ///< as in StudyRecord
    double points = 0;                   ///< of the result
    double memory = not_measured;        ///< [MB], as in StudyRecord
    int threads = 1;                     ///< that the runs used
    int drives = 1;                      ///< designs that this is the worst of
    int runs = 1;                        ///< of each drive: times of one alone are compared with no others
};

/// A curve of the diagram: the levels of one method on one drive (or the sample), in the order that they were run.
struct ConvergenceSeries
{
    std::string study;                     ///< as in StudyRecord
    std::string drive;                     ///< as in StudyRecord, or the worst of the sample
    std::string method;                    ///< as in StudyRecord
    std::string knob;                      ///< as in StudyRecord
    std::string unit;                      ///< of the errors
    std::vector<ConvergenceLevel> levels;  ///< from coarse to fine
    double order = not_measured;  ///< slope of log error against log knob over the levels above the floor, where errors
                                  ///< fall from level to level
    double floor = not_measured;  ///< error that the finest levels share, where they do
    std::string no_order{};       ///< why levels enough have no order; else empty
};

/// What was measured.
struct AccuracyReport
{
    Scene scene;                       ///< as studied
    std::vector<StudyRecord> records;  ///< one for each run
    double reference_error = 0;  ///< largest distance of any reference from 50 digits, measured between its nodes [mm]
    double reference_interference = 0;  ///< how deep any tooth enters a reference, by brute force [mm]
    int sample = 0;                     ///< designs of the sample that were measured
    int sample_refused = 0;             ///< designs drawn that make no drive
    bool quick = false;                 ///< whether the series were shortened for a test
    int threads = 1;                    ///< that the program may use
    std::string machine;                ///< processor as the system names it
    std::vector<std::string> notes;     ///< what of the scene was left out, and why
    double seconds = 0;                 ///< wall time of all studies
};

/// A study by its name, and the question it answers.
struct StudyKind
{
    std::string_view name;      ///< as in --study
    std::string_view question;  ///< that it answers
};

/// Every study, in the order in which they run.
[[nodiscard]] std::vector<StudyKind> const& study_kinds();

/// What is asked beside the scene.
struct AccuracyOptions
{
    std::vector<std::string> studies;  ///< names; empty: all
    int sample = 64;                   ///< designs beside the scene; 0: none
    int repeats = 5;                   ///< runs of each setting, for the median of the times
    bool quick = false;                ///< short series, one repeat: for tests
    std::uint64_t seed = 20250301;     ///< of the sample
};

/// Told which study runs, and how much of all is done, 0 ... 1.
using StudyProgress = std::function<void(std::string const& what, double share)>;

/// Numbers beyond their limits, and names of studies that there are not: all that can be said without a scene.
[[nodiscard]] Faults check_studies(AccuracyOptions const& options);

/// Faults of what is asked: studies that do not exist, or that this scene does not have. Every drive that `solve` takes
/// has a reference in 50 digits, of its own motion model and of the member that it solves for. The reverse problem has
/// no union, contact-area and load. The last two also need what they measure in the scene. Such a study is a fault
/// where it is named, and is otherwise left out with a note.
[[nodiscard]] Faults check_accuracy(Scene const& scene, AccuracyOptions const& options);

/// Runs the studies.
///
/// The drive that is measured has no root clearance, no automatic side clearance and no effects along the axis; `notes`
/// says so. Only contact-area knows of coning. Errors are against the scene's own motion model; those of the study
/// motion-model are against exact motion. Studies that the scene does not have, or that have no reference, are left out
/// while others run; `notes` says why. Deterministic but for the times and the memory.
/// @throws InputError for what check_accuracy() finds, and where every study had to be left out; NumericalError where
/// the scene itself cannot be solved, or has no reference and no other study was asked for
[[nodiscard]] AccuracyReport measure_accuracy(Scene const& scene, AccuracyOptions const& options = {},
                                              StudyProgress const& progress = {});

}  // namespace hdconj
