// SPDX-License-Identifier: GPL-3.0-or-later
#include "measured_figures.hpp"

#include <array>

#include "number_text.hpp"

namespace hdconj::figures {

using namespace unit;

Rows<MeasuredStiffness> measured_curve_figures()
{
    using T = MeasuredStiffness;
    static constexpr std::array rows = {
        figure<&T::cycles>("cycles", one, "load cycles", {"cycles", whole}),
        figure<&T::straight>("straight_branches", one, "loading branches without a second stage", {"straight", whole}),
        figure<&T::largest_torque>("largest_torque", newton_metre, "largest torque of the curve")
            .without(hdf5)
            .printed({"up to", significant<4>}),
        figure<&T::angle_step>("angle_step", arcmin, "steps in which the angle is read; 0: it has none",
                               {"in steps of", significant<3>}),
        figure<&T::middle>("middle", arcmin, "middle of the backlash"),
        figure<&T::torque_middle>("torque_middle", newton_metre, "reading of the torque without load, taken out",
                                  {"reading without load", significant<4>}),
        FigureOf<T>{"stray_readings", one, "readings left out: they leave the run of their neighbours",
                    [](T const& each) { return static_cast<double>(each.strays.size()); }}};
    return Rows<T>(rows);
}

namespace {

template <Estimate MeasuredStiffness::*member>
Estimate const& estimate(MeasuredStiffness const& found)
{
    return found.*member;
}

std::optional<double> not_simulated(LoadCase const&)
{
    return std::nullopt;
}

std::optional<double> simulated_backlash(LoadCase const& each)
{
    return each.backlash;
}

template <double StiffnessStages::*member>
std::optional<double> simulated(LoadCase const& each)
{
    return each.stages.found ? std::optional(each.stages.*member) : std::nullopt;
}

std::optional<double> simulated_line(LoadCase const& each)
{
    return each.stages.found || each.stages.first == 0 ? std::nullopt : std::optional(each.stages.first);
}

}  // namespace

std::span<MeasuredFigure const> measured_figures()
{
    using F = MeasuredStiffness;
    using S = StiffnessStages;
    constexpr Unit per_degree = newton_metre_per_degree;
    static constexpr std::array figures = {
        MeasuredFigure{{"backlash"}, "backlash", arcmin, estimate<&F::backlash>, 1, simulated_backlash},
        MeasuredFigure{{"friction_width"}, "width by friction", arcmin, estimate<&F::friction_width>, 1, not_simulated},
        MeasuredFigure{{"loop_width"}, "loop at zero torque", arcmin, estimate<&F::loop_width>, 1, not_simulated},
        MeasuredFigure{{"drift"}, "drift over the log", arcmin, estimate<&F::drift>, 1, not_simulated},
        MeasuredFigure{{"friction_torque"}, "friction", newton_metre, estimate<&F::friction>, -1, not_simulated},
        MeasuredFigure{{"first_stage"}, "first stage", per_degree, estimate<&F::first>, -2, simulated<&S::first>},
        MeasuredFigure{{"second_stage"}, "second stage", per_degree, estimate<&F::second>, -2, simulated<&S::second>},
        MeasuredFigure{{"knee"}, "knee between them", newton_metre, estimate<&F::knee>, -1, simulated<&S::knee>},
        MeasuredFigure{{"whole_branch", "whole"}, "one line", per_degree, estimate<&F::whole>, -2, simulated_line}};
    return figures;
}

}  // namespace hdconj::figures
