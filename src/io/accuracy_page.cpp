// SPDX-License-Identifier: GPL-3.0-or-later
// docs/accuracy.md is written by this file from records; its words say only what the numbers bear out.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "accuracy_figures.hpp"
#include "hdconj/study/accuracy.hpp"
#include "summary_page.hpp"

namespace hdconj {
namespace {

using Ladders = std::vector<StudyLadder>;

StudyLadder const* find(Ladders const& ladders, std::string const& study, std::string const& method, bool sample = false)
{
    for (auto const& ladder : ladders) {
        if (ladder.study == study && ladder.method == method && (ladder.drive == worst_of_sample) == sample) {
            return &ladder;
        }
    }
    return nullptr;
}

StudyRung const& best_of(StudyLadder const& ladder)
{
    return *std::min_element(ladder.rungs.begin(), ladder.rungs.end(), [](auto const& a, auto const& b) { return a.error < b.error; });
}

/// Time of a ladder at an error, between its rungs on log-log lines; nothing outside of it.
std::optional<double> time_at(StudyLadder const& ladder, double error)
{
    for (std::size_t i = 0; i + 1 < ladder.rungs.size(); ++i) {
        auto const& a = ladder.rungs[i];
        auto const& b = ladder.rungs[i + 1];
        if (a.error >= error && b.error <= error && a.error > b.error) {
            double const share = std::log(a.error / error) / std::log(a.error / b.error);
            return a.median * std::pow(b.median / a.median, share);
        }
    }
    return {};
}

std::string um_text(double mm)
{
    return fmt::format("{:.3g} um", mm * 1e3);
}

void conclude_tolerance(Page& page, Ladders const& ladders)
{
    auto const* ladder = find(ladders, "tolerance", "solve");
    if (ladder == nullptr) {
        return;
    }
    double over = 0, under = 0;
    for (auto const& rung : ladder->rungs) {
        over = std::max(over, rung.estimate / rung.error);
        under = std::max(under, rung.error / rung.estimate);
    }
    auto const& last = ladder->rungs.back();
    page.line("The error follows the tolerance with order {:.2f}, down to {} mm, where the finest rung stands. The program's own estimate is at most {:.2f} times the true error{}. "
              "From {} to {} mm time grows from {} to {}.",
              ladder->order, scientific(last.error), over,
              under > 1 ? fmt::format(", and where chords are long it may be {:.0f} % too small", (under - 1) * 100) : " and never below it", scientific(ladder->rungs.front().error),
              scientific(last.error), duration(ladder->rungs.front().median), duration(last.median));
}

void conclude_sampling(Page& page, Ladders const& ladders)
{
    auto const* equal = find(ladders, "sampling", "equal steps of u");
    auto const* adaptive = find(ladders, "sampling", "adaptive");
    if (equal == nullptr || adaptive == nullptr) {
        return;
    }
    std::string ratios;
    for (auto const& rung : adaptive->rungs) {
        for (std::size_t i = 0; i + 1 < equal->rungs.size(); ++i) {
            auto const& a = equal->rungs[i];
            auto const& b = equal->rungs[i + 1];
            if (a.error >= rung.error && b.error <= rung.error && a.error > b.error) {
                double const share = std::log(a.error / rung.error) / std::log(a.error / b.error);
                ratios += fmt::format("{}{:.0f} at {} mm", ratios.empty() ? "" : ", ", a.points * std::pow(b.points / a.points, share) / rung.points, scientific(rung.error));
            }
        }
    }
    page.line("Both are of second order in the number of points. Equal steps of u need this many times the points for the same error: {}.", ratios);
}

void conclude_model(Page& page, Ladders const& ladders)
{
    auto const* first = find(ladders, "motion-model", "first order");
    auto const* material = find(ladders, "motion-model", "material");
    auto const* exact = find(ladders, "motion-model", "exact");
    if (first == nullptr || exact == nullptr) {
        return;
    }
    auto const floor = [](StudyLadder const* ladder) { return ladder->floor == ladder->floor ? ladder->floor : best_of(*ladder).error; };
    auto const times = [&](StudyLadder const* ladder) { return fmt::format("{:.2g}", ladder->rungs.back().median / exact->rungs.back().median); };
    page.line("First order stays at {}, whatever the tolerance{}: {} of the model, not of the arithmetic. At equal tolerance {} times the time of exact motion.", um_text(floor(first)),
              material == nullptr ? "" : fmt::format(", material at {}", um_text(floor(material))), material == nullptr ? "a floor" : "floors",
              material == nullptr ? "it takes " + times(first) : "they take " + times(first) + " and " + times(material));
}

void conclude_fit(Page& page, Ladders const& ladders)
{
    auto const* exact = find(ladders, "polynomial-fit", "fit, exact motion");
    auto const* first = find(ladders, "polynomial-fit", "fit, first order");
    auto const* joined = find(ladders, "polynomial-fit", "points joined, exact motion");
    if (exact == nullptr || first == nullptr || joined == nullptr) {
        return;
    }
    auto const& best = best_of(*exact);
    auto const& dense = best_of(*joined);
    auto const* sample = find(ladders, "polynomial-fit", "fit, exact motion", true);
    page.line("The fit is best with degree {:.0f}, {}; more degrees help no further, and no number of points does, since the flank is no polynomial. With first-order motion the best is {}. "
              "The same points joined by straight lines, {:.0f} of them, are right to {}.{}",
              best.value, um_text(best.error), um_text(best_of(*first).error), dense.value, um_text(dense.error),
              sample == nullptr ? "" : fmt::format(" Of the sample no degree fits all designs to better than {}. Where the worst of it is far off with first-order motion, the centre of an arc "
                                                   "nearly rests, and the first-order contact lies beyond the ends of the arc (docs/theory.md).", um_text(best_of(*sample).error)));
}

void conclude_union(Page& page, Ladders const& ladders)
{
    auto const* united = find(ladders, "union", "union of positions");
    if (united == nullptr) {
        return;
    }
    auto const& last = united->rungs.back();
    auto const* solve = find(ladders, "tolerance", "solve");
    auto const there = solve == nullptr ? std::optional<double>() : time_at(*solve, last.error);
    page.line("{:.0f} positions leave {} of the flank uncut and take {} and {:.0f} MB.{}", last.value, um_text(last.error), duration(last.median), last.memory,
              there ? fmt::format(" `solve` is there after {}, {:.0f} times sooner.", duration(*there), last.median / *there) : "");
}

void conclude_roots(Page& page, Ladders const& ladders)
{
    auto const* closed = find(ladders, "roots", "closed form (arcs)");
    auto const* proved = find(ladders, "roots", "certified (spline)");
    auto const* scan = find(ladders, "roots", "scan and bracket (spline)");
    if (proved == nullptr || scan == nullptr) {
        return;
    }
    auto const& sure = proved->rungs.front();
    auto const complete = std::find_if(scan->rungs.begin(), scan->rungs.end(), [](auto const& rung) { return rung.missed == 0; });
    std::string text;
    if (closed != nullptr) {
        text = fmt::format("In closed form a contact costs {}. ", duration(closed->rungs.front().median / closed->rungs.front().evaluations));
    }
    text += fmt::format("All certified roots of a polynomial piece at one instant cost {}. ", duration(sure.median / sure.evaluations));
    if (complete == scan->rungs.end()) {
        auto const& last = scan->rungs.back();
        text += fmt::format("The scan still misses {} of {:.0f} roots with {:.0f} steps a piece, in {:.2g} times the time.", last.missed, sure.points, last.value, last.median / sure.median);
    } else {
        text += fmt::format("The scan finds all {:.0f} roots from {:.0f} steps a piece on ({} missed with one step), in {:.2g} times the time, and cannot say so.", sure.points,
                            complete->value, scan->rungs.front().missed, complete->median / sure.median);
    }
    page.line("{}", text);
}

void conclude_type(Page& page, Ladders const& ladders)
{
    auto const* wide = find(ladders, "number-type", "long double");
    auto const* narrow = find(ladders, "number-type", "float");
    auto const* usual = find(ladders, "number-type", "double");
    if (wide == nullptr || narrow == nullptr || usual == nullptr) {
        return;
    }
    auto const& f = narrow->rungs.front();
    auto const& d = usual->rungs.front();
    auto const& l = wide->rungs.front();
    page.line("Points of a flank's arc are right to {} mm in float, {} mm in double and {} mm in long double, which takes {:.2g} times the time of double. Float takes {:.2g} times. "
              "Double is far below any tolerance that can be asked for.",
              scientific(f.error), scientific(d.error), scientific(l.error), l.median / d.median, f.median / d.median);
}

void conclude_contact(Page& page, Ladders const& ladders)
{
    auto const* slices = find(ladders, "contact-area", "slices");
    auto const* points = find(ladders, "contact-area", "flank points");
    if (slices == nullptr || points == nullptr) {
        return;
    }
    std::string reference;
    if (auto const* own = find(ladders, "contact-area", "reference: lengths in planes"); own != nullptr) {
        auto const& rung = own->rungs.back();
        reference = fmt::format(" Slices are measured against lengths of contact in {:.0f} exact planes, another path whose own error is {} mm^2, 1/{:.0f} of that of the most slices tested; "
                                "a table of a reference has its own error in place of a distance from it.",
                                rung.value, scientific(rung.error), std::floor(slices->rungs.back().error / rung.error));
    }
    auto const* sample = find(ladders, "contact-area", "slices", true);
    auto const* of_sample = find(ladders, "contact-area", "reference: lengths in planes", true);
    if (sample != nullptr && of_sample != nullptr) {
        reference += fmt::format(" The worst of {} designs of the sample is right to {} mm^2 with {:.0f} slices, against {:.0f} planes with errors of {} mm^2 or less.", sample->rungs.back().drives,
                                 scientific(sample->rungs.back().error),
                                 sample->rungs.back().value, of_sample->rungs.back().value, scientific(of_sample->rungs.back().error));
    }
    page.line("The contact area is right to {} mm^2 with {:.0f} slices and to {} mm^2 with {:.0f} flank points; slices are the knob that counts. "
              "This is no distance from a reference in 50 digits, see the notes below.{}",
              scientific(slices->rungs.back().error), slices->rungs.back().value, scientific(points->rungs.back().error), points->rungs.back().value, reference);
}

void conclude_load(Page& page, Ladders const& ladders)
{
    std::string found;
    for (char const* knob : {"harmonics", "slices", "flank points", "circles"}) {
        auto const* ladder = find(ladders, "load", std::string(knob) + ": twist");
        if (ladder != nullptr) {
            auto const& rung = ladder->rungs.back();
            found += fmt::format("{}{:.0f} {} ({}, {})", found.empty() ? "" : ", ", rung.value, knob, scientific(rung.error), duration(rung.median));
        }
    }
    std::string of_sample;
    for (char const* knob : {"harmonics", "slices", "flank points", "circles"}) {
        if (auto const* ladder = find(ladders, "load", std::string(knob) + ": twist", true); ladder != nullptr) {
            auto const& rung = ladder->rungs.back();
            of_sample += fmt::format("{}{} with {:.0f} {}", of_sample.empty() ? " The worst of the sample, from the standard grid: " : ", ", scientific(rung.error), rung.value, knob);
        }
    }
    if (!found.empty()) {
        page.line("How far the twist at the rated torque is from that of the finest rung, relative to it, and what it takes: {}. This is no distance from a reference in 50 digits, see the notes below.{}",
                  found, of_sample.empty() ? of_sample : of_sample + ".");
    }
}

void conclude_threads(Page& page, Ladders const& ladders)
{
    auto const* threads = find(ladders, "threads", "solve");
    if (threads == nullptr || threads->rungs.size() < 2) {
        return;
    }
    auto const& one = threads->rungs.front();
    auto const& last = threads->rungs.back();
    auto const* sample = find(ladders, "threads", "solve", true);
    int differ = last.extra;
    for (std::size_t i = 0; sample != nullptr && i < sample->rungs.size(); ++i) {
        differ = std::max(differ, sample->rungs[i].extra);
    }
    auto const* apart = find(ladders, "threads", "solves side by side");
    std::string const given = apart == nullptr || apart->rungs.size() < 2
        ? std::string()
        : fmt::format(", where the machine gave {:.2f}: so much more was done in the same minutes by {:.0f} solves side by side, which share nothing else",
                      apart->rungs.front().median / apart->rungs.back().median, last.value);
    page.line("{:.0f} threads are {:.2f} times as fast as one{}; {}.", last.value, one.median / last.median, given,
              differ > 0 ? fmt::format("{} points differ", differ) : fmt::format("no bit of the outline differs{}", sample == nullptr ? "" : ", of this drive or any design of the sample"));
}

void conclude(Page& page, std::string const& name, Ladders const& ladders)
{
    if (name == "tolerance") {
        conclude_tolerance(page, ladders);
    } else if (name == "sampling") {
        conclude_sampling(page, ladders);
    } else if (name == "motion-model") {
        conclude_model(page, ladders);
    } else if (name == "polynomial-fit") {
        conclude_fit(page, ladders);
    } else if (name == "union") {
        conclude_union(page, ladders);
    } else if (name == "roots") {
        conclude_roots(page, ladders);
    } else if (name == "number-type") {
        conclude_type(page, ladders);
    } else if (name == "contact-area") {
        conclude_contact(page, ladders);
    } else if (name == "load") {
        conclude_load(page, ladders);
    } else if (name == "threads") {
        conclude_threads(page, ladders);
    }
}

void write_table(Page& page, StudyLadder const& ladder)
{
    std::string const remark = ladder_remark(ladder);
    page.line("\n**{}**{}{}\n", ladder_name(ladder), remark.empty() ? "" : ": ", remark);
    page.line("| {} | error [{}] | estimate | residual [mm/rad] | missed, extra | median | least ... most | evaluations | points | memory [MB] |", ladder.knob, ladder.unit);
    page.line("|---|---|---|---|---|---|---|---|---|---|");
    for (auto const& rung : ladder.rungs) {
        page.line("| {} | {} | {} | {} | {}, {} | {} | {} ... {} | {:.0f} | {:.0f} | {:.0f} |", knob_text(rung.value), scientific(rung.error), scientific(rung.estimate),
                  scientific(rung.residual), rung.missed, rung.extra, duration(rung.median), duration(rung.least), duration(rung.most), rung.evaluations, rung.points,
                  rung.memory);
    }
}

/// What errors are distances from.
void write_reference(Page& page, AccuracyReport const& report)
{
    page.line("**Errors** are distances in mm from a reference that is computed in 50 digits by another path (frames from tangent vectors in place of angles, arcs as parallels of their centre's "
              "path, arc length by the trapezoidal rule or, where the wave generator's third derivative jumps, by one series from jump to jump, corners by Newton's method). It is of this drive's own "
              "wave generator (`{}`) and motion model (`{}`){}; the study motion-model is against exact motion. Between its nodes the reference is right to {} mm; brute force over all tooth positions "
              "finds it touched, and not entered, to {} mm, which is the resolution of that check. The error given is the larger of L-infinity (vertices off the curve) and Hausdorff distance (chords and missing stretches too). The residual "
              "|n.v| stands apart and says little about either. *Missed* and *extra* count branches, stretches of boundary or roots; in the study threads, points that differ from those of one "
              "thread.\n",
              report.scene.wave_generator.shape.family, to_string(report.scene.solver.kinematics),
              report.scene.is_reverse() ? ", and of the flexspline tooth, which is solved for" : "", scientific(report.reference_error), scientific(report.reference_entry));
}

void write_knobs(Page& page, Ladders const& ladders)
{
    page.line("## Which knob for which accuracy\n");
    page.line("| wanted [mm] | write | error on this drive | worst of the sample | time |");
    page.line("|---|---|---|---|---|");
    constexpr int coarsest = 2, finest = 11;
    for (int digits = coarsest; digits <= finest; ++digits) {
        double const wanted = std::pow(10.0, -digits);
        auto const found = fastest_within(ladders, wanted);
        if (!found || !found->reaches) {
            continue;
        }
        page.line("| {:.0e} | `{} = {}` | {} | {} | {} |", wanted, found->rung.knob, knob_text(found->rung.value), scientific(found->rung.error), scientific(found->sample_error),
                  duration(found->rung.median));
    }
    page.line("\n`solver.tolerance` is the knob for the outline, `kinematics` a choice of model and not of accuracy, `slices.count` the knob for the contact area, and `threads` worth "
              "its while where the table of the study says so. For a wanted error or time: `hdconj accuracy --error 1e-6`, `hdconj accuracy --budget 10ms`; with `--from DIR/records.h5` from "
              "records that were measured before.\n");
}

/// A file as Markdown's links take it.
std::string link_to(std::string const& file)
{
    return file.find_first_of(" ()") == std::string::npos ? file : "<" + file + ">";
}

}  // namespace

std::string accuracy_page(StoredAccuracy const& study, std::filesystem::path const& page_file, bool pictures)
{
    auto const& report = study.report;
    auto const ladders = ladders_of(report);
    Page page;
    page.line("# What accuracy costs in time\n");
    page.line("Written by `hdconj accuracy --page`, from {} records; nothing on this page is typed by hand. Drive: {}. Machine: {}, {} threads, which may have had other work: compare "
              "medians within a study. Program: hdconj {} ({}), {}. Libraries: {}.\n",
              report.records.size(), report.scene.drive.name, report.machine, report.threads, study.origin.version, study.origin.revision, study.origin.build,
              study.origin.libraries);
    if (report.reference_error > 0) {
        write_reference(page, report);
    }
    if (report.sample > 0) {
        page.line("**Sample**: {} designs about the drive (radial deformation 0.85 to 1.1, wall 0.8 to 1.2, lengths of the profile 0.94 to 1.06 times; {} more were drawn and make no drive). For each "
                  "setting the worst of them is shown; a slow machine is not a bad design, so their times are of single runs.\n",
                  report.sample, report.sample_refused);
    }
    if (find(ladders, "tolerance", "solve") != nullptr) {
        write_knobs(page, ladders);
    }
    for (auto const& name : studies_of(ladders)) {
        std::string question;
        for (auto const& kind : study_kinds()) {
            if (kind.name == name) {
                question = kind.question;
            }
        }
        page.line("## {}: {}\n", name, question);
        conclude(page, name, ladders);
        if (pictures && has_picture(ladders, name)) {
            page.line("\n![{}]({})", question, link_to("figures/" + accuracy_figure(page_file, name).filename().string()));
        }
        for (auto const& ladder : ladders) {
            if (ladder.study == name) {
                write_table(page, ladder);
            }
        }
        page.line("");
    }
    if (!report.notes.empty()) {
        page.line("## Notes\n");
        for (auto const& note : report.notes) {
            page.line("* {}", note);
        }
    }
    return page.text();
}

}  // namespace hdconj
