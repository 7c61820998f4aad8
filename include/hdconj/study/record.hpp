// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// What a work-precision study measures: one record for each case, method, knob and repeat.
#pragma once

#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include "hdconj/scene/scene.hpp"

namespace hdconj {

/// A number that a study does not have.
inline constexpr double not_measured = std::numeric_limits<double>::quiet_NaN();

/// One run of one method with one setting on one drive.
///
/// Errors are geometric and against the reference; what the program itself estimates, and what is left of the meshing condition,
/// stand beside them and are never taken for them.
struct StudyRecord
{
    std::string study;           ///< "tolerance"; the names are those of study_kinds()
    std::string drive;           ///< the scene's name, or "design-07" of the sample
    std::string method;          ///< "adaptive"
    std::string knob;            ///< "solver.tolerance"
    double value = 0;            ///< of the knob
    int repeat = 0;
    std::string unit = "mm";     ///< of the errors; contact areas are in mm^2
    double error = not_measured;      ///< L-infinity: largest distance of a computed point from the true curve
    double hausdorff = not_measured;  ///< distance of the computed curve from the true one, both ways, chords included
    double estimate = not_measured;   ///< the method's own estimate of the latter
    double residual = not_measured;   ///< |n.v| at the computed contacts, the largest [mm/rad]
    int branches = 0;            ///< found, where the method looks for branches or roots
    int missed = 0;              ///< of these; in the study polynomial-fit points of the grid without a contact on their flank
    int extra = 0;
    double seconds = 0;
    double evaluations = 0;      ///< of the meshing condition or the envelope point; 0: not counted
    double points = 0;           ///< of the result
    double memory = not_measured;  ///< largest resident set of the process while it ran [MB]
    int threads = 1;

    /// The error that methods are compared by.
    [[nodiscard]] double largest_error() const { return hausdorff >= error || !(error == error) ? hausdorff : error; }
};

/// The repeats of one setting together; of the sample, its worst design.
struct StudyRung
{
    std::string study, drive, method, knob, unit;
    double value = 0;
    double error = not_measured;      ///< largest_error() of the records; of a sample the worst
    double estimate = not_measured;
    double residual = not_measured;
    int missed = 0, extra = 0;
    double median = 0, least = 0, most = 0;  ///< seconds
    double evaluations = 0, points = 0, memory = not_measured;
    int threads = 1;
    int drives = 1;                   ///< designs that this is the worst of
    int runs = 1;                     ///< of each drive: times of one alone are compared with no others
};

/// A curve of the diagram: the rungs of one method on one drive (or the sample), in the order that they were run.
struct StudyLadder
{
    std::string study, drive, method, knob, unit;
    std::vector<StudyRung> rungs;
    double order = not_measured;   ///< slope of log error against log knob over the rungs above the floor, where errors fall from rung to rung
    double floor = not_measured;   ///< error that the finest rungs share, where they do
    std::string no_order{};        ///< why rungs enough have no order; else empty
};

/// What was measured.
struct AccuracyReport
{
    Scene scene;                       ///< as studied
    std::vector<StudyRecord> records;
    double reference_error = 0;        ///< largest distance of any reference from 50 digits, measured between its nodes [mm]
    double reference_entry = 0;        ///< how deep any tooth enters a reference, by brute force [mm]
    int sample = 0;                    ///< designs of the sample that were measured
    int sample_refused = 0;            ///< designs drawn that make no drive
    bool quick = false;
    int threads = 1;
    std::string machine;               ///< processor as the system names it
    std::vector<std::string> notes;    ///< what of the scene was left out, and why
    double seconds = 0;
};

}  // namespace hdconj
