// SPDX-License-Identifier: GPL-3.0-or-later
// The page of `hdconj accuracy --page` is written by this file from records; what follows from them is in
// accuracy_conclusions.cpp.

#include <cmath>

#include "accuracy_conclusions.hpp"
#include "figures/accuracy_figures.hpp"
#include "hdconj/accuracy.hpp"
#include "report/plots/plots.hpp"

namespace hdconj {
namespace {

void write_table(report::Page& page, ConvergenceSeries const& series)
{
    std::string const remark = figures::series_remark(series);
    page.line("\n**{}**{}{}\n", figures::series_name(series), remark.empty() ? "" : ": ", remark);
    page.line(
        "| {} | error [{}] | estimate | normal speed [mm/rad] | missed, extra | median | least ... most | evaluations "
        "| points | memory [MB] |",
        series.knob, figures::unit_of_errors(series));
    page.line("|---|---|---|---|---|---|---|---|---|---|");
    for (auto const& level : series.levels) {
        page.line("| {} | {} | {} | {} | {}, {} | {} | {} ... {} | {:.0f} | {:.0f} | {:.0f} |",
                  figures::knob_text(level.value), figures::scientific(level.error),
                  figures::scientific(level.estimate), figures::scientific(level.normal_speed), level.missed,
                  level.extra, figures::duration(level.median), figures::duration(level.least),
                  figures::duration(level.most), level.evaluations, level.points, level.memory);
    }
}

/// What errors are distances from.
void write_reference(report::Page& page, AccuracyReport const& report)
{
    page.line(
        "**Errors** are distances in mm from a reference that is computed in 50 digits by another method (frames from "
        "tangent vectors in place of angles, arcs as parallels of their centre's path, arc length by the trapezoidal "
        "rule or, where the wave generator's third derivative jumps, by one series from jump to jump, corners by "
        "Newton's method). It is of this drive's own wave generator (`{}`) and motion model (`{}`){}; the study "
        "motion-model is against exact motion. Between its nodes the reference is right to {} mm; brute force over all "
        "tooth positions finds it touched, and not entered, to {} mm, which is the resolution of that check. The error "
        "given is the larger of L-infinity (vertices off the curve) and Hausdorff distance (chords and missing "
        "stretches too). The residual |n.v| stands apart and says little about either. *Missed* and *extra* count "
        "branches, stretches of boundary or roots; in the study polynomial-fit, points of the grid that have no "
        "contact on the flank, and contacts of another branch taken for one; in the study threads, points that differ "
        "from those of one thread.\n",
        report.scene.wave_generator.shape.family, to_string(report.scene.solver.kinematics),
        report.scene.is_reverse() ? ", and of the flexspline tooth, which is solved for" : "",
        figures::scientific(report.reference_error), figures::scientific(report.reference_interference));
}

void write_knobs(report::Page& page, report::SeriesList const& series_list)
{
    page.line("## Which setting for which accuracy\n");
    page.line("| wanted [mm] | write | error on this drive | worst of the sample | time |");
    page.line("|---|---|---|---|---|");
    constexpr int coarsest = 2, finest = 11;
    for (int digits = coarsest; digits <= finest; ++digits) {
        double const wanted = std::pow(10.0, -digits);
        auto const found = accuracy::fastest_within(series_list, wanted);
        if (!found || !found->reaches)
            continue;
        page.line("| {:.0e} | `{} = {}` | {} | {} | {} |", wanted, found->level.knob,
                  figures::knob_text(found->level.value), figures::scientific(found->level.error),
                  figures::scientific(found->sample_error), figures::duration(found->level.median));
    }
    page.line(
        "\n`solver.tolerance` decides the error of the outline and `slices.count` that of the contact area. "
        "`kinematics` chooses a model and no accuracy. More `threads` help where the table of the study says so. For a "
        "wanted error or time: `hdconj accuracy --error 1e-6`, `hdconj accuracy --budget 10ms`; with `--from "
        "DIR/records.h5` from records that were measured before.\n");
}

/// A file as Markdown's links take it.
std::string link_to(std::string const& file)
{
    return file.find_first_of(" ()") == std::string::npos ? file : "<" + file + ">";
}

}  // namespace

std::filesystem::path accuracy_figure(std::filesystem::path const& page, std::string const& study)
{
    return page.parent_path() / "figures" / (page.stem().string() + "-" + study + ".svg");
}

std::string accuracy_page(StoredAccuracy const& study, std::filesystem::path const& page_file, bool pictures)
{
    auto const& report = study.report;
    auto const series_list = accuracy::convergence_series(report);
    report::Page page;
    page.line("# What accuracy costs in time\n");
    page.line(
        "Written by `hdconj accuracy --page`, from {} records; nothing on this page is typed by hand. Drive: {}. "
        "Machine: {}, {}, which may have had other work: {}. Program: hdconj {} ({}), {}. Libraries: {}.\n",
        report.records.size(), report.scene.drive.name, report.machine, figures::threads_text(report.threads),
        figures::are_single_runs(series_list) ? "times are of single runs, and no ratio is drawn from them"
                                              : "compare medians within a study",
        study.origin.version, study.origin.revision, study.origin.build, study.origin.libraries);
    if (report.reference_error > 0)
        write_reference(page, report);
    if (report.sample > 0) {
        page.line(
            "**Sample**: {} designs about the drive (radial deformation 0.85 to 1.1, wall 0.8 to 1.2, lengths of the "
            "profile 0.94 to 1.06 times; {} more were drawn and make no drive). For each setting the worst of them is "
            "listed; a slow machine is not a bad design, so their times are of single runs.\n",
            report.sample, report.sample_refused);
    }
    if (report::find(series_list, "tolerance", "solve") != nullptr)
        write_knobs(page, series_list);
    for (auto const& name : figures::studies_of(series_list)) {
        std::string const question = figures::question_of(name);
        page.line("## {}: {}\n", name, question);
        report::conclude(page, name, series_list, report.scene);
        if (pictures && report::has_picture(series_list, name)) {
            page.line("\n![{}]({})", question,
                      link_to("figures/" + accuracy_figure(page_file, name).filename().string()));
        }
        for (auto const& series : series_list)
            if (series.study == name)
                write_table(page, series);
        page.line("");
    }
    if (!report.notes.empty()) {
        page.line("## Notes\n");
        for (auto const& note : report.notes)
            page.line("* {}", note);
    }
    return page.text();
}

}  // namespace hdconj
