// SPDX-License-Identifier: GPL-3.0-or-later
#include "measured_text.hpp"

#include <algorithm>
#include <cmath>

#include "figures/load_figures.hpp"
#include "figures/measured_figures.hpp"

namespace hdconj::report {
namespace {

std::string rig_text(MeasuredCurve const& curve)
{
    std::string text = curve.columns;
    if (curve.rig.torque_constant != 0) {
        text += fmt::format(", {:g} N m/A", curve.rig.torque_constant);
        text += curve.rig.efficiency != 1 ? fmt::format(", efficiency {:g}", curve.rig.efficiency) : "";
    }
    text += curve.rig.counts_per_turn != 0 ? fmt::format(", {:g} counts per turn", curve.rig.counts_per_turn) : "";
    text += curve.rig.torque_constant != 0 || curve.rig.counts_per_turn != 0
                ? fmt::format(", ratio {:g}", curve.rig.ratio)
                : "";
    return text;
}

/// What was measured beside what is simulated; nothing where neither has a value.
void write_estimate(Page& page, figures::MeasuredFigure const& figure, Measurement const& measured,
                    LoadCase const* simulated)
{
    Estimate const& estimate = figure.value(measured.found);
    auto value = simulated != nullptr ? figure.simulated(*simulated) : std::nullopt;
    if (value)
        *value *= std::pow(measured.curve.rig.angle_per_spline, figure.angles);
    if (estimate.count == 0 && !value)
        return;
    auto const& unit = figure.unit;
    page.line("  {:<30}{:>20}{:>12}   {}", fmt::format("{} [{}]", figure.words, unit.text),
              estimate.count == 0
                  ? "-"
                  : fmt::format("{:.4g} +- {:.2g}", unit.shown(estimate.value), unit.shown(estimate.error)),
              estimate.count, value ? fmt::format("{:.4g}", unit.shown(*value)) : "-");
}

/// Which readings were left out, by the lines of the file.
void write_strays(Page& page, Measurement const& measured)
{
    auto const& strays = measured.found.strays;
    if (strays.empty())
        return;
    constexpr std::size_t most = 10;
    std::vector<int> lines;
    for (std::size_t i = 0; i < std::min(most, strays.size()); ++i)
        lines.push_back(measured.curve.line[strays[i]]);
    page.line("  {} reading{} left out, far from {} neighbours: line{} {}{}", strays.size(), plural(strays.size()),
              strays.size() == 1 ? "its" : "their", plural(strays.size()), fmt::join(lines, ", "),
              strays.size() > most ? ", ..." : "");
}

}  // namespace

void write_measured(Page& page, LoadCase const* simulated, Measurement const& measured)
{
    auto const& [curve, found] = measured;
    Told const told(figures::measured_curve_figures(), found);
    page.line("measured: {} ({})", curve.file, rig_text(curve));
    page.line("  {} samples, {} load cycle{} up to {}{}", curve.twist.size(), told("cycles"),
              plural(static_cast<std::size_t>(found.cycles)), told.with_unit("largest_torque"),
              found.angle_step > 0 ? ", angles in steps of " + told.with_unit("angle_step") : "");
    page.line("  {:<30}{:>20}{:>12}{}", "", "measured", "of",
              simulated != nullptr ? "   simulated: " + figures::case_name(*simulated) : "");
    for (auto const& figure : figures::measured_figures())
        write_estimate(page, figure, measured, simulated);
    if (curve.rig.angle_per_spline != 1) {
        page.line("  at the output, which is the cup: its angles are {:.6g} times those of the circular spline{}",
                  curve.rig.angle_per_spline, simulated != nullptr ? " in the tables above" : "");
    }
    write_strays(page, measured);
    if (found.torque_middle != 0)
        page.line("  the torque reads {} without load, which was taken out", told.with_unit("torque_middle"));
    if (found.knee.count > 0 && found.friction.value > 3 * found.friction.error)
        page.line("  the knee is that of the loading branches, and contains the friction");
    if (found.backlash.count == 0)
        page.line("  friction leaves too few readings beyond the play: backlash and stiffness are not determined");
    else if (found.friction_width.count == 0)
        page.line("  too few readings to tell the width by friction from backlash");
    if (found.straight > 0) {
        page.line("  {} of {} loading branches are one straight line and are left out of the stages", found.straight,
                  found.whole.count);
    }
}

}  // namespace hdconj::report

namespace hdconj {

std::string summary_text(Measurement const& measured)
{
    report::Page page;
    report::write_measured(page, nullptr, measured);
    return page.text();
}

}  // namespace hdconj
