// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>

#include "accuracy_figures.hpp"
#include "hdconj/study/accuracy.hpp"
#include "summary_object.hpp"
#include "summary_page.hpp"

namespace hdconj {
namespace {

void write_ladder(Page& page, StudyLadder const& ladder)
{
    std::string const remark = ladder_remark(ladder);
    page.line("  {}{}{}", ladder_name(ladder), remark.empty() ? "" : ": ", remark);
    page.line("  {:>12}  {:>10} {:>10} {:>10} {:>6} {:>5} {:>11} {:>11} {:>11} {:>9}", ladder.knob.size() > 12 ? "knob" : ladder.knob, "error", "estimate", "residual",
              "missed", "extra", "median", "least", "most", "points");
    for (auto const& rung : ladder.rungs) {
        page.line("  {:>12}  {:>10} {:>10} {:>10} {:>6} {:>5} {:>11} {:>11} {:>11} {:>9.0f}", knob_text(rung.value), scientific(rung.error), scientific(rung.estimate),
                  scientific(rung.residual), rung.missed, rung.extra, duration(rung.median), duration(rung.least), duration(rung.most), rung.points);
    }
}

Json rung_object(StudyRung const& rung)
{
    return {{"value", number(rung.value)},
            {"error", number(rung.error)},
            {"estimate", number(rung.estimate)},
            {"residual_mm_per_rad", number(rung.residual)},
            {"missed", rung.missed},
            {"extra", rung.extra},
            {"median_s", number(rung.median)},
            {"least_s", number(rung.least)},
            {"most_s", number(rung.most)},
            {"evaluations", number(rung.evaluations)},
            {"points", number(rung.points)},
            {"memory_mb", number(rung.memory)},
            {"threads", rung.threads},
            {"drives", rung.drives},
            {"runs", rung.runs}};
}

Json advice_object(Recommendation const& advice)
{
    return {{"set", fmt::format("{}={}", advice.rung.knob, knob_text(advice.rung.value))},
            {"reaches", advice.reaches},
            {"error_mm", number(advice.rung.error)},
            {"sample_error_mm", number(advice.sample_error)},
            {"time_s", number(advice.rung.median)}};
}

}  // namespace

std::string summary_text(StoredAccuracy const& study, AccuracyAdvice const& advice)
{
    Page page;
    auto const& report = study.report;
    auto const ladders = ladders_of(report);
    page.line("{}: {} records, hdconj {} ({})", report.scene.drive.name, report.records.size(), study.origin.version, study.origin.revision);
    page.line("  {}, {}; {}", report.machine, threads_text(report.threads), study.origin.build);
    if (are_single_runs(ladders)) {
        page.line("  times are of single runs: none of them says how it compares with another");
    }
    bool const has_reference = report.reference_error > 0;   // studies along the axis need none
    if (has_reference) {
        page.line("  reference: 50 digits by another path, itself right to {} mm; brute force finds it touched to {} mm", scientific(report.reference_error),
                  scientific(report.reference_entry));
    }
    if (has_reference && report.scene.solver.kinematics != Kinematics::exact) {
        page.line("  measured against {} motion, as the scene has it; the study motion-model against exact motion", to_string(report.scene.solver.kinematics));
    }
    if (report.sample > 0) {
        page.line("  sample: {} designs about this one ({} drawn that make no drive)", report.sample, report.sample_refused);
    }
    for (auto const& note : report.notes) {
        page.line("  {}", note);
    }
    for (auto const& name : studies_of(ladders)) {
        std::string question;
        for (auto const& kind : study_kinds()) {
            if (kind.name == name) {
                question = kind.question;
            }
        }
        page.line("\n{}: {}", name, question);
        for (auto const& ladder : ladders) {
            if (ladder.study == name) {
                write_ladder(page, ladder);
            }
        }
    }
    auto const say = [&](std::string const& asked, std::optional<Recommendation> const& found) {
        page.line("\n{}\n  {}", asked, found ? advice_text(*found) : "no record of the study tolerance to go by: run it, or give --from a file that holds it");
    };
    if (advice.error) {
        say(fmt::format("error of {:.3g} mm or less, fastest", *advice.error), fastest_within(ladders, *advice.error));
    }
    if (advice.seconds) {
        say(fmt::format("{} or less, most accurate", duration(*advice.seconds)), finest_within(ladders, *advice.seconds));
    }
    return page.text();
}

std::string summary_json(StoredAccuracy const& study, AccuracyAdvice const& advice, std::vector<WrittenFile> const& written)
{
    auto const& report = study.report;
    auto const ladders = ladders_of(report);
    bool const has_reference = report.reference_error > 0;
    Json summary = {{"format", "hdconj-accuracy"},
                    {"format_version", 1},
                    {"program_version", study.origin.version},
                    {"git_revision", study.origin.revision},
                    {"build", study.origin.build},
                    {"libraries", study.origin.libraries},
                    {"machine", report.machine},
                    {"drive", report.scene.drive.name},
                    {"threads", report.threads},
                    {"records", report.records.size()},
                    {"reference_error_mm", has_reference ? number(report.reference_error) : Json()},
                    {"reference_entry_mm", has_reference ? number(report.reference_entry) : Json()},
                    {"sample", report.sample},
                    {"sample_refused", report.sample_refused},
                    {"notes", report.notes}};
    summary["ladders"] = Json::array();
    for (auto const& ladder : ladders) {
        Json rungs = Json::array();
        for (auto const& rung : ladder.rungs) {
            rungs.push_back(rung_object(rung));
        }
        summary["ladders"].push_back({{"study", ladder.study},
                                      {"drive", ladder.drive},
                                      {"method", ladder.method},
                                      {"knob", ladder.knob},
                                      {"unit", ladder.unit},
                                      {"order", number(ladder.order)},
                                      {"floor", number(ladder.floor)},
                                      {"no_order", ladder.no_order.empty() ? Json() : Json(ladder.no_order)},
                                      {"rungs", std::move(rungs)}});
    }
    auto const put = [&](char const* key, std::optional<Recommendation> const& found) {
        summary[key] = found ? advice_object(*found) : Json(nullptr);
    };
    if (advice.error) {
        put("for_error", fastest_within(ladders, *advice.error));
    }
    if (advice.seconds) {
        put("for_budget", finest_within(ladders, *advice.seconds));
    }
    summary["files"] = Json::array();
    for (auto const& file : written) {
        summary["files"].push_back({{"kind", file.kind}, {"path", file.file.string()}});
    }
    summary["seconds"] = number(report.seconds);
    constexpr int indent = 2;
    return summary.dump(indent, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace hdconj
