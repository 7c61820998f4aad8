// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "figures/number_text.hpp"
#include "figures/running_figures.hpp"
#include "hdconj/running_files.hpp"
#include "summary_page.hpp"

namespace hdconj::report {
namespace {

/// A figure, none of which is negative, with its error; where that exceeds a third of it, what it is at most. NaN: what
/// fewer than three positions do not tell.
template <class Record>
std::string told_with_error(figures::Rows<Record> const& rows, Record const& record, char const* name, bool estimated)
{
    auto const& row = rows[name];
    if (std::isnan(row.value(record)))
        return "not determined";
    if (!estimated)
        return row.value_with_unit(record) + " (no error estimate)";
    double const value = row.value(record), error = row.error(record);
    if (figures::is_unconverged(value, error))
        return "at most " + row.text.error(row.text_unit().shown(value + error)) + " " + row.text_unit().text;
    return row.value_text(record) + " +- " + row.error_text(record) + " " + row.text_unit().text;
}

void write_sequence(Page& page, RunSequence const& sequence)
{
    bool const under_torque = sequence.torque != 0;
    auto const rows = figures::run_sequence_figures(under_torque);
    std::size_t const found = sequence.positions.size();
    page.line("\n{}, {} positions, {}", figures::span_words(sequence.span),
              found < sequence.planned ? fmt::format("{} of {}", found, sequence.planned) : fmt::format("{}", found),
              under_torque ? fmt::format("{:g} N m", sequence.torque * per_newton_metre) : "unloaded");
    page.line("  transmission error        {}, rms {}",
              told_with_error(rows, sequence, "peak_to_peak", sequence.estimated),
              told_with_error(rows, sequence, "rms", sequence.estimated));
    std::vector<RunOrder> largest = sequence.orders;
    std::ranges::sort(largest, std::ranges::greater(), &RunOrder::amplitude);
    constexpr std::size_t shown = 3;
    std::string orders;
    for (std::size_t i = 0; i < std::min(shown, largest.size()); ++i) {
        Told const told(figures::run_order_rows(), largest[i]);
        std::string const amplitude = sequence.estimated
                                          ? told_with_error(figures::run_order_rows(), largest[i], "amplitude", true)
                                          : told.with_unit("amplitude");
        orders += (i > 0 ? ", " : "") + amplitude + " at " + told("per_input");
    }
    if (!orders.empty())
        page.line("  largest orders            {} per input turn", orders);
    if (under_torque)
        page.line("  wave generator torque     {}, ripple {}, without friction",
                  told_with_error(rows, sequence, "mean_torque", sequence.estimated),
                  told_with_error(rows, sequence, "torque_ripple", sequence.estimated));
    page.line("  time                      {}", rows["seconds"].value_with_unit(sequence));
}

void write_efficiency(Page& page, RunLosses const& losses)
{
    auto const rows = figures::efficiency_rows();
    constexpr auto columns = "{:>12} {:>8} {:>8} {:>12} {:>7} {:>9} {:>7} {:>9} {:>9} {:>9} {:>9} {:>9}";
    page.line("");
    page.line(columns, "temperature", "speed", "torque", "efficiency", "+-", "input", "+-", "flanks", "M1", "M0",
              "seals", "churning");
    page.line(columns, "deg C", "rpm", "N m", "%", "%", "N m", "N m", "N m", "N m", "N m", "N m", "N m");
    for (EfficiencyRow const& each : losses.efficiency) {
        Told const told(rows, each);
        auto const error = [&](char const* name) { return losses.estimated ? told.error(name) : "-"; };
        page.line(columns, told("temperature"), told("speed"), told("torque"), told("efficiency"), error("efficiency"),
                  told("input_torque"), error("input_torque"), told("flank_loss"), told("bearing_load_loss"),
                  told("bearing_speed_loss"), told("seal_loss"), told("churning_loss"));
    }
    page.line(
        "  input: torque that drives the wave generator, at torque 0 the no-load running torque; behind it what "
        "is lost of it");
    if (std::ranges::any_of(losses.efficiency, [](EfficiencyRow const& each) { return each.input_torque == 0; }))
        page.line("  efficiency -: not determined, because without torque and losses neither side has power");
}

void write_losses(Page& page, RunLosses const& losses)
{
    auto const rows = figures::run_loss_figures();
    page.line("\nfriction");
    auto const line = [&](char const* name, char const* note) {
        page.line("  {:<25} {}, {}", rows[name].text.label, told_with_error(rows, losses, name, losses.estimated),
                  note);
    };
    line("starting_torque", "on the wave generator, no torque on the output");
    if (losses.back_driving) {
        figures::BackDriving const back{*losses.back_driving, losses.back_driving_error};
        page.line("  back-driving torque       {}, on the output",
                  told_with_error(figures::back_driving_figures(), back, "back_driving_torque", losses.estimated));
    } else
        page.figure("back-driving torque", "not found", "up to the largest torque");
    line("ball_load", "at the largest torque");
    page.figure(rows["bearing_diameter"], losses);
    line("largest_sliding", "of loaded flanks, for each rad of the wave generator");
    write_efficiency(page, losses);
}

}  // namespace
}  // namespace hdconj::report

namespace hdconj {

std::string summary_text(RunStudy const& study, std::vector<WrittenFile> const& written)
{
    report::Page page;
    report::write_drive(page, study.solution);
    auto const rows = figures::run_study_figures();
    page.line("\nrunning: the {} turns, {}", study.output == RunningMember::flexspline ? "cup" : "circular spline",
              study.elastic ? "elastic cup" : "in the shape that the scene prescribes");
    page.figure(rows["ratio"], study, "turns of the wave generator for one of the output");
    if (study.torque > 0) {
        page.figure(rows["torque"], study);
        page.figure(rows["spline_torque"], study);
    }
    page.figure(rows["backlash_offset"], study,
                study.side_clearance_increased ? "of the flanks; with that of the scene teeth would press on both"
                                               : "of the flanks");
    if (study.tip_radius_increase > 0)
        page.figure(rows["tip_radius"], study,
                    "wider than the scene gives by " + rows["tip_radius_increase"].value_with_unit(study) +
                        ", so that the teeth clear or lands are left");
    for (RunSequence const& each : study.sequences)
        report::write_sequence(page, each);
    if (study.losses)
        report::write_losses(page, *study.losses);
    report::write_notes(page, study.solution.notes);
    report::write_end(page, study.solution, written);
    return page.text();
}

}  // namespace hdconj
