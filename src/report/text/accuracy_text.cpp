// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "accuracy/convergence_series.hpp"
#include "figures/accuracy_figures.hpp"
#include "hdconj/accuracy.hpp"
#include "summary_page.hpp"

namespace hdconj::report {
namespace {

void write_series(Page& page, ConvergenceSeries const& series)
{
    std::string const remark = figures::series_remark(series);
    page.line("  {} [{}]{}{}", figures::series_name(series), figures::unit_of_errors(series),
              remark.empty() ? "" : ": ", remark);
    page.line("  {:>12}  {:>10} {:>10} {:>10} {:>6} {:>5} {:>11} {:>11} {:>11} {:>9}",
              series.knob.size() > 12 ? "knob" : series.knob, "error", "estimate", "speed n.v", "missed", "extra",
              "median", "least", "most", "points");
    for (auto const& level : series.levels) {
        Told const told(figures::level_figures(), level);
        page.line("  {:>12}  {:>10} {:>10} {:>10} {:>6} {:>5} {:>11} {:>11} {:>11} {:>9}", told("value"), told("error"),
                  told("estimate"), told("normal_speed"), told("missed"), told("extra"), told("median"), told("least"),
                  told("most"), told("points"));
    }
}

void write_head(Page& page, StoredAccuracy const& study, std::vector<ConvergenceSeries> const& series_list)
{
    auto const& report = study.report;
    Told const told(figures::report_figures(), report);
    page.line("{}: {} records, hdconj {} ({})", report.scene.drive.name, report.records.size(), study.origin.version,
              study.origin.revision);
    page.line("  {}, {}; {}", report.machine, figures::threads_text(report.threads), study.origin.build);
    if (figures::are_single_runs(series_list))
        page.line("  each time is that of a single run, so do not compare times");
    bool const has_reference = report.reference_error > 0;  // studies along the axis need none
    if (has_reference) {
        page.line("  reference: 50 digits by another method, error {}; brute force finds interference up to {}",
                  told.with_unit("reference_error"), told.with_unit("reference_interference"));
    }
    if (has_reference && report.scene.solver.kinematics != Kinematics::exact) {
        page.line("  measured against {} motion, as the scene has it; the study motion-model against exact motion",
                  to_string(report.scene.solver.kinematics));
    }
    if (report.sample > 0) {
        page.line("  sample: {} random designs around this one ({} more were no valid drive)", report.sample,
                  report.sample_refused);
    }
    for (auto const& note : report.notes)
        page.line("  {}", note);
}

void write_advice(Page& page, std::string const& asked, std::optional<accuracy::Recommendation> const& found)
{
    page.line("\n{}\n  {}", asked,
              found ? figures::advice_text(*found)
                    : "there is no record of the study tolerance: run it, or write --from with a file that holds it");
}

}  // namespace
}  // namespace hdconj::report

namespace hdconj {

std::string summary_text(StoredAccuracy const& study, AccuracyAdvice const& advice)
{
    report::Page page;
    auto const series_list = accuracy::convergence_series(study.report);
    report::write_head(page, study, series_list);
    for (auto const& name : figures::studies_of(series_list)) {
        page.line("\n{}: {}", name, figures::question_of(name));
        for (auto const& series : series_list)
            if (series.study == name)
                report::write_series(page, series);
    }
    if (advice.error) {
        report::write_advice(page, fmt::format("error of {:.3g} mm or less, fastest", *advice.error),
                             accuracy::fastest_within(series_list, *advice.error));
    }
    if (advice.seconds) {
        report::write_advice(page, figures::duration(*advice.seconds) + " or less, most accurate",
                             accuracy::finest_within(series_list, *advice.seconds));
    }
    return page.text();
}

}  // namespace hdconj
