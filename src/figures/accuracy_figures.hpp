// SPDX-License-Identifier: GPL-3.0-or-later
// The figures of a study of accuracy, and words that its text and page share.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "accuracy/convergence_series.hpp"
#include "figure_of.hpp"
#include "hdconj/accuracy_files.hpp"
#include "number_text.hpp"

namespace hdconj::figures {

/// One number of a record, a column of HDF5 and CSV. Whole numbers are stored as floating-point ones too.
struct RecordFigure
{
    FigureOf<StudyRecord> figure;
    void (*set)(StudyRecord&, double);
};
[[nodiscard]] std::span<RecordFigure const> record_figures();

/// One text of a record.
struct RecordText
{
    char const* name;
    std::string StudyRecord::*text;
    char const* meaning;
};
[[nodiscard]] std::span<RecordText const> record_texts();

inline constexpr Name convergence_series{"convergence_series", "ladders"};
inline constexpr Name levels{"levels", "rungs"};

[[nodiscard]] Rows<AccuracyReport> report_figures();
[[nodiscard]] Rows<ConvergenceLevel> level_figures();
[[nodiscard]] Rows<accuracy::Recommendation> advice_figures();

/// What a study answers.
[[nodiscard]] std::string question_of(std::string const& study);
/// "1 thread", "2 threads".
[[nodiscard]] std::string threads_text(int threads);
/// "type-50, solve" or "worst of the sample, solve".
[[nodiscard]] std::string series_name(ConvergenceSeries const& series);
/// "mm", "mm^2" or "relative".
[[nodiscard]] std::string unit_of_errors(ConvergenceSeries const& series);
/// "order 1.00", "floor 2.57e-03", "no order: ...", "error falls 12 times a degree until degree 8", or empty.
[[nodiscard]] std::string series_remark(ConvergenceSeries const& series);
/// What to write for a wanted error or time, in words.
[[nodiscard]] std::string advice_text(accuracy::Recommendation const& advice);

/// Whether no setting was run more than once.
[[nodiscard]] bool are_single_runs(std::vector<ConvergenceSeries> const& series_list);

/// Names of the studies in a report, in order.
[[nodiscard]] std::vector<std::string> studies_of(std::vector<ConvergenceSeries> const& series_list);

}  // namespace hdconj::figures
