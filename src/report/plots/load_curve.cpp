// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "figures/contact_figures.hpp"
#include "hdconj/units.hpp"
#include "plot.hpp"
#include "plots.hpp"
#include "rig_samples.hpp"

namespace hdconj::report {
namespace {

void add_point(PlotColumns& columns, double twist, double torque)
{
    columns.row(twist * per_arcmin, torque * per_newton_metre);
}

/// The curve as it is run through. Without torque the drive may lie anywhere in its play: drawn from end to end where
/// the torque changes its sign.
void add_curve(PlotColumns& columns, LoadCase const& each)
{
    double const half = each.backlash / 2;
    double last = 0;  // side of the play, 0: not known yet
    bool from_zero = false;
    for (auto const& state : each.curve) {
        double const side = state.torque > 0 ? 1 : state.torque < 0 ? -1 : 0;
        bool const in_play = half > 0 && (side == 0 || side != last);
        if (in_play && last != 0)
            add_point(columns, last * half, 0);
        if (in_play && side != 0 && (last != 0 || from_zero))
            add_point(columns, side * half, 0);
        if (!in_play || side != 0)
            add_point(columns, state.twist, state.torque);
        if (in_play) {
            from_zero = from_zero || side == 0;
            last = side != 0 ? side : last;
        }
    }
}

/// Both lines, each a little beyond the bend.
void add_stages(PlotColumns& columns, LoadCase const& each)
{
    auto const& stages = each.stages;
    double const rated = each.rated < each.curve.size() ? each.curve[each.rated].torque : 0;
    constexpr double beyond = 0.3;  // of the distance that the line covers
    auto const line = [&](double slope, double from, double to) {
        for (double const torque : {from, to})
            add_point(columns, stages.knee_twist + (torque - stages.knee) / slope, torque);
        columns.end_line();
    };
    line(stages.first, 0, stages.knee + beyond * (rated - stages.knee));
    line(stages.second, stages.knee - beyond * stages.knee, rated);
}

/// The points of the rig as of the circular spline, whose curves they are laid over.
PlotColumns rig_points(Measurement const& measured)
{
    double const per_spline = measured.curve.rig.angle_per_spline;
    PlotColumns points;
    for (RigSample const& each : rig_samples(measured))
        add_point(points, each.twist / per_spline, each.torque * per_spline);
    return points;
}

PlotColumns rig_figures(Measurement const& measured)
{
    auto const& found = measured.found;
    PlotColumns figures;
    figures.row(measured.curve.rig.angle_per_spline != 1, found.cycles, found.backlash.value * per_arcmin,
                found.backlash.error * per_arcmin, found.first.count, found.first.value * per_newton_metre_per_deg,
                found.first.error * per_newton_metre_per_deg, found.second.value * per_newton_metre_per_deg,
                found.second.error * per_newton_metre_per_deg, found.knee.value * per_newton_metre,
                found.backlash.count > 0);
    return figures;
}

}  // namespace

std::vector<RigSample> rig_samples(Measurement const& measured)
{
    auto const &twist = measured.curve.twist, &torque = measured.curve.torque;
    constexpr std::size_t most = 4000;
    std::vector<RigSample> samples;
    double const drift = measured.found.drift.value / static_cast<double>(twist.size());
    double const half = static_cast<double>(twist.size() - 1) / 2;  // the middle of the log has no drift
    for (std::size_t i = 0; i < twist.size(); i += twist.size() / most + 1)
        samples.push_back({twist[i] - measured.found.middle - drift * (static_cast<double>(i) - half),
                           torque[i] - measured.found.torque_middle});
    return samples;
}

bool has_curve(LoadStudy const& study)
{
    return std::any_of(study.cases.begin(), study.cases.end(), [](auto const& each) { return each.curve.size() > 1; });
}

std::string shown_load(LoadStudy const& study)
{
    auto const* shown = figures::shown_case(study);
    auto const* state = shown != nullptr ? figures::rated_state(*shown) : nullptr;
    return study.solution.scene.drive.name +
           (state == nullptr
                ? ""
                : fmt::format(":  {},  {:.4g} N m", figures::case_name(*shown), state->torque * per_newton_metre));
}

std::string load_curve_script(LoadStudy const& study, Measurement const* measured)
{
    constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
    PlotColumns curves, stages, cases;
    for (auto const& each : study.cases) {
        add_curve(curves, each);
        if (each.curve.empty())
            curves.row(nothing, nothing);
        curves.end_index();
        if (each.stages.found)
            add_stages(stages, each);
        else
            stages.row(nothing, nothing);
        stages.end_index();
        cases.named_row(figures::case_name(each), each.backlash * per_arcmin,
                        each.stages.first * per_newton_metre_per_deg, each.stages.second * per_newton_metre_per_deg,
                        each.stages.knee * per_newton_metre, each.stages.found);
    }
    auto const* shown = figures::shown_case(study);
    bool const play = shown != nullptr && shown->curve.size() > 1;
    PlotData data(study.solution.scene.drive.name);
    data.set("shown", static_cast<double>(study.written_case + 1));
    data.set("play", play ? shown->backlash * per_arcmin : 0);
    data.set("measured", measured != nullptr ? rig_points(*measured) : PlotColumns());
    data.set("rig", measured != nullptr ? rig_figures(*measured) : PlotColumns());
    data.set("curves", curves);
    data.set("stages", stages);
    data.set("cases", cases);
    return plot_script("load_curve", data);
}

}  // namespace hdconj::report
