// SPDX-License-Identifier: GPL-3.0-or-later
// Transmission error over the wave generator, its orders, and efficiency over torque.
#include <fmt/format.h>

#include <numbers>

#include "figures/number_text.hpp"
#include "figures/running_figures.hpp"
#include "hdconj/units.hpp"
#include "plot.hpp"
#include "plots.hpp"

namespace hdconj::report {
namespace {

std::string sequence_name(RunSequence const& sequence)
{
    bool const under_torque = sequence.torque != 0;
    auto const rows = figures::run_sequence_figures(under_torque);
    return fmt::format("{}, {}:  {}{}", figures::span_words(sequence.span),
                       under_torque ? fmt::format("{:g} N m", sequence.torque * per_newton_metre) : "unloaded",
                       rows["peak_to_peak"].value_text(sequence),
                       sequence.estimated ? " ± " + rows["peak_to_peak"].error_text(sequence) : "");
}

double mean_error(RunSequence const& sequence)
{
    double sum = 0;
    for (RunPosition const& each : sequence.positions)
        sum += each.error;
    return sum / static_cast<double>(sequence.positions.size());
}

/// Angle of the wave generator after which all comes again [rad]; of one position any.
double period_of(RunSequence const& sequence)
{
    return sequence.orders.empty() ? 1 : 2 * std::numbers::pi / sequence.orders.front().per_input;
}

}  // namespace

std::string run_error_script(RunStudy const& study)
{
    auto const place = figures::run_position_rows(false);
    PlotColumns curves, names;
    for (RunSequence const& each : study.sequences) {
        double const mean = mean_error(each), first = each.positions.front().angle;
        double const period = period_of(each);
        for (RunPosition const& at : each.positions)
            curves.row((at.angle - first) / period, place["error"].unit.shown(at.error - mean));
        // what comes again closes the curve
        curves.row(1, place["error"].unit.shown(each.positions.front().error - mean));
        curves.end_index();
        names.named_row(sequence_name(each), period * per_deg);
    }
    PlotData data(study.solution.scene.drive.name);
    data.set("curves", curves);
    data.set("names", names);
    return plot_script("run_error", data);
}

std::string run_spectrum_script(RunStudy const& study)
{
    auto const rows = figures::run_order_rows();
    PlotColumns orders, names;
    for (RunSequence const& each : study.sequences) {
        for (RunOrder const& order : each.orders)
            orders.row(order.per_input, rows["amplitude"].unit.shown(order.amplitude));
        if (each.orders.empty())
            orders.row(1, 0);
        orders.end_index();
        RunOrder const* const largest = figures::largest_order(each);
        names.named_row(sequence_name(each), each.orders.empty() ? 1 : each.orders.back().per_input,
                        largest != nullptr ? rows["amplitude"].unit.shown(largest->amplitude) : 0);
    }
    PlotData data(study.solution.scene.drive.name);
    data.set("orders", orders);
    data.set("names", names);
    return plot_script("run_spectrum", data);
}

std::string run_efficiency_script(RunStudy const& study)
{
    auto const rows = figures::efficiency_rows();
    PlotColumns curves, names;
    EfficiencyRow const* before = nullptr;
    for (EfficiencyRow const& each : study.losses->efficiency) {
        if (before == nullptr || before->speed != each.speed || before->temperature != each.temperature) {
            if (before != nullptr)
                curves.end_index();
            names.named_row(
                fmt::format("{} rpm, {} °C", rows["speed"].value_text(each), rows["temperature"].value_text(each)), 0);
        }
        curves.row(each.torque * per_newton_metre, each.efficiency * per_percent, each.efficiency_error * per_percent);
        before = &each;
    }
    PlotData data(study.solution.scene.drive.name);
    data.set("curves", curves);
    data.set("names", names);
    data.set("starting", study.losses->starting_torque * per_newton_metre);
    return plot_script("run_efficiency", data);
}

}  // namespace hdconj::report
