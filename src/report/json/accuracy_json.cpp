// SPDX-License-Identifier: GPL-3.0-or-later
// The keys are an interface, described in docs/reference/json.md.
#include "figures/accuracy_figures.hpp"
#include "hdconj/accuracy.hpp"
#include "summary_object.hpp"

namespace hdconj::report {
namespace {

constexpr int accuracy_json_version = 2;

Json series_object(ConvergenceSeries const& series)
{
    Json object = {
        {"study", series.study},         {"drive", series.drive},
        {"method", series.method},       {"knob", series.knob},
        {"unit", series.unit},           {"order", number(series.order)},
        {"floor", number(series.floor)}, {"no_order", series.no_order.empty() ? Json() : Json(series.no_order)}};
    add(object, figures::levels, list_of(series.levels, [](ConvergenceLevel const& level) {
            return figures_object(figures::level_figures(), level);
        }));
    return object;
}

Json advice_object(std::optional<accuracy::Recommendation> const& advice)
{
    if (!advice)
        return nullptr;
    Json object = {{"set", advice->level.knob + "=" + figures::knob_text(advice->level.value)}};
    add_figures(object, figures::advice_figures(), *advice);
    return object;
}

}  // namespace
}  // namespace hdconj::report

namespace hdconj {

std::string summary_json(StoredAccuracy const& study, AccuracyAdvice const& advice,
                         std::vector<WrittenFile> const& written)
{
    using report::Json;
    auto const& measured = study.report;
    auto const series_list = accuracy::convergence_series(measured);
    Json summary = {{"format", "hdconj-accuracy"},
                    {"format_version", report::accuracy_json_version},
                    {"program_version", study.origin.version},
                    {"git_revision", study.origin.revision},
                    {"build", study.origin.build},
                    {"libraries", study.origin.libraries},
                    {"machine", measured.machine},
                    {"drive", measured.scene.drive.name},
                    {"records", measured.records.size()}};
    report::add_figures(summary, figures::report_figures(), measured);
    if (!(measured.reference_error > 0)) {  // no study needs a reference
        for (char const* key : {"reference_error_mm", "reference_interference_mm", "reference_entry_mm"})
            summary[key] = nullptr;
    }
    summary["notes"] = measured.notes;
    report::add(summary, figures::convergence_series, report::list_of(series_list, report::series_object));
    if (advice.error)
        summary["for_error"] = report::advice_object(accuracy::fastest_within(series_list, *advice.error));
    if (advice.seconds)
        summary["for_budget"] = report::advice_object(accuracy::finest_within(series_list, *advice.seconds));
    summary["files"] = report::list_of(written, [](WrittenFile const& file) -> Json {
        return {{"kind", file.kind}, {"path", file.file.string()}};
    });
    return report::printed(summary);
}

}  // namespace hdconj
