// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The numbers of a study record under their names in HDF5 and CSV, and words shared by text and page; private to src/io.
#pragma once

#include <span>
#include <string>

#include "hdconj/io/accuracy_files.hpp"
#include "picture_script.hpp"

namespace hdconj {

/// One number of a record. Whole numbers are stored as numbers too: a column is a column.
struct RecordFigure
{
    char const* name;
    char const* units;
    double (*value)(StudyRecord const&);
    void (*set)(StudyRecord&, double);
};
[[nodiscard]] std::span<RecordFigure const> record_figures();

/// One text of a record.
struct RecordText
{
    char const* name;
    std::string StudyRecord::*text;
};
[[nodiscard]] std::span<RecordText const> record_texts();

/// "1.2e-07", "-" where there is none.
[[nodiscard]] std::string scientific(double value);
/// "12.3 ms".
[[nodiscard]] std::string duration(double seconds);
/// A knob's value as a user writes it: "1e-06", "64", "1048576".
[[nodiscard]] std::string knob_text(double value);
/// "1 thread", "2 threads".
[[nodiscard]] std::string threads_text(int threads);
/// "type-50, solve" or "worst of the sample, solve".
[[nodiscard]] std::string ladder_name(StudyLadder const& ladder);
/// "order 1.00", "floor 2.57e-03", "no order: ...", "error falls 12 times a degree until degree 8", or empty.
[[nodiscard]] std::string ladder_remark(StudyLadder const& ladder);
/// What to write for a wanted error or time, in words.
[[nodiscard]] std::string advice_text(Recommendation const& advice);

/// Whether no setting was run more than once.
[[nodiscard]] bool are_single_runs(std::vector<StudyLadder> const& ladders);

/// Names of the studies in a report, in order.
[[nodiscard]] std::vector<std::string> studies_of(std::vector<StudyLadder> const& ladders);

/// What the picture of a study shows: error against time, or time against threads.
[[nodiscard]] std::string picture_words(std::vector<StudyLadder> const& ladders, std::string const& name);
/// That picture, log-log.
[[nodiscard]] std::string accuracy_script(StoredAccuracy const& study, std::vector<StudyLadder> const& ladders, std::string const& name, PictureFormat format);
/// Whether a study has two points to draw.
[[nodiscard]] bool has_picture(std::vector<StudyLadder> const& ladders, std::string const& name);

}  // namespace hdconj
