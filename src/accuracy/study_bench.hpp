// SPDX-License-Identifier: GPL-3.0-or-later
// What every study is given, and how it keeps its records; private to src/accuracy.
#pragma once

#include <chrono>
#include <string>
#include <utility>
#include <vector>

#include "hdconj/accuracy.hpp"
#include "hdconj/error.hpp"
#include "study_drive.hpp"

namespace hdconj::accuracy {

/// Largest resident set since the last reset [MB]; not_measured where the system does not say.
[[nodiscard]] double peak_memory();
void reset_peak_memory();

/// What is said of a study, or of the scene where @ref study is empty.
struct StudyNote
{
    std::string study;
    std::string words;
};

/// The scene that is measured, and where records and notes go.
struct StudyRun
{
    AccuracyReport& report;
    std::vector<StudyNote>& notes;
    Scene const& scene;
    std::string name;  ///< of the drive
    int repeats = 1;
    bool quick = false;    ///< short series
    bool sampled = false;  ///< one of the sample: series of medium length
    int threads = 1;

    /// What @p run returns; its time and memory go into @p record. For runs that are long against a tick of the clock.
    template <class Run>
    auto timed(StudyRecord& record, Run const& run) const
    {
        reset_peak_memory();
        auto const start = std::chrono::steady_clock::now();
        auto result = run();
        record.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        record.memory = peak_memory();
        record.threads = threads;
        return result;
    }

    /// Notes why @p study has nothing to measure on this drive.
    /// @throws NumericalError on a design of the sample, whose reasons are counted and not listed
    void leave_out(std::string const& study, std::string const& why) const
    {
        if (sampled)
            throw NumericalError(ErrorCode::no_reference, "accuracy", study, why);
        notes.push_back({study, "left out, " + why});
    }

    /// Says @p words of @p study, once and not for each design of the sample.
    void note(std::string const& study, std::string const& words) const
    {
        if (!sampled)
            notes.push_back({study, words});
    }

    /// The length of a series.
    [[nodiscard]] int length(int full, int of_sample, int of_quick) const
    {
        return quick ? of_quick : sampled ? of_sample : full;
    }

    /// Keeps @p record as one of this drive.
    void keep(StudyRecord record) const
    {
        record.drive = name;
        report.records.push_back(std::move(record));
    }

    /// Runs @p run, which returns nothing, for every repeat of a record.
    template <class Run>
    void measure(StudyRecord const& record, Run const& run) const
    {
        for (int repeat = 0; repeat < repeats; ++repeat)
            measure_once(record, repeat, run);
    }

    /// The same for one repeat. Runs shorter than some milliseconds are repeated within one timing, so that a tick of
    /// the clock does not count.
    /// @param jobs  that a run does
    template <class Run>
    void measure_once(StudyRecord record, int repeat, Run const& run, int jobs = 1) const
    {
        record.repeat = repeat;
        reset_peak_memory();
        constexpr double long_enough = 3e-3;  // s
        long runs = 0;
        double seconds = 0;
        auto const start = std::chrono::steady_clock::now();
        do {
            run();
            ++runs;
            seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        } while (seconds < long_enough && !quick);
        record.seconds = seconds / (static_cast<double>(runs) * jobs);
        record.memory = peak_memory();
        keep(record);
    }
};

/// The same with the drive taken apart and its reference.
struct StudyBench : StudyRun
{
    StudyDrive const& drive;
    ReferenceCurve const& reference;
};

/// The flank stretch of the boundary, on the side of larger x, that is longest of those @p allowed; null: none.
template <class Allowed>
[[nodiscard]] conjugate::BoundaryPiece const* longest_flank(StudyBench const& bench, Allowed const& allowed)
{
    conjugate::BoundaryPiece const* longest = nullptr;
    double most = 0;
    for (std::size_t i = bench.drive.pieces.size() / 2; i < bench.drive.pieces.size(); ++i) {
        conjugate::BoundaryPiece const& piece = bench.drive.pieces[i];
        if (!bench.drive.is_flank(piece) || !allowed(piece))
            continue;
        if (double const length = bench.reference.length(static_cast<int>(i)); length > most) {
            most = length;
            longest = &piece;
        }
    }
    return longest;
}

void study_tolerance(StudyBench const& bench);
void study_sampling(StudyBench const& bench);
void study_motion_model(StudyBench const& bench);
void study_fit(StudyBench const& bench);
void study_union(StudyBench const& bench);
void study_roots(StudyBench const& bench);
void study_precision(StudyBench const& bench);
void study_contact_area(StudyRun const& bench);
void study_load_twist(StudyRun const& bench);
void study_threads(StudyBench const& bench);

/// Gives @p scene an outline per slice where it names no tooth surface; else it keeps its surface and the tilt of it.
void take_surface(Scene& scene);
/// Says of @p study which tooth surface @p scene has.
void note_surface(StudyRun const& bench, std::string const& study, Scene const& scene);

/// What a scene gives too little of for these studies; empty: nothing.
[[nodiscard]] std::string lacks_for_contact(Scene const& scene);
[[nodiscard]] std::string lacks_for_load(Scene const& scene);

/// 10^-digits.
[[nodiscard]] double power_of_ten(int digits);
/// Powers of ten from 1e-3 down, @p most of them, that the scene takes as solver.tolerance.
[[nodiscard]] std::vector<double> tolerances_of(Drive const& drive, int most);

}  // namespace hdconj::accuracy
