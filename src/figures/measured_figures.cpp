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
        figure<&T::angle_step>("angle_step", arcmin, "smallest difference of two angles",
                               {"in steps of", significant<3>}),
        figure<&T::middle>("middle", arcmin, "middle of the backlash"),
        FigureOf<T>{"stray_readings", one, "readings left out: they leave the run of their neighbours",
                    [](T const& each) { return static_cast<double>(each.strays.size()); }}};
    return Rows<T>(rows);
}

std::span<MeasuredFigure const> measured_figures()
{
    using Found = MeasuredStiffness const&;
    using Case = LoadCase const&;
    using Value = std::optional<double>;
    constexpr auto not_simulated = [](Case) { return Value(); };
    static constexpr std::array figures = {
        MeasuredFigure{{"backlash"},
                       "backlash",
                       arcmin,
                       [](Found f) -> Estimate const& { return f.backlash; },
                       1,
                       [](Case c) { return Value(c.backlash); }},
        MeasuredFigure{{"friction_width"},
                       "width by friction",
                       arcmin,
                       [](Found f) -> Estimate const& { return f.friction_width; },
                       1,
                       not_simulated},
        MeasuredFigure{{"loop_width"},
                       "loop at zero torque",
                       arcmin,
                       [](Found f) -> Estimate const& { return f.loop_width; },
                       1,
                       not_simulated},
        MeasuredFigure{{"drift"},
                       "drift over the log",
                       arcmin,
                       [](Found f) -> Estimate const& { return f.drift; },
                       1,
                       not_simulated},
        MeasuredFigure{{"first_stage"},
                       "first stage",
                       newton_metre_per_degree,
                       [](Found f) -> Estimate const& { return f.first; },
                       -2,
                       [](Case c) { return c.stages.found ? Value(c.stages.first) : Value(); }},
        MeasuredFigure{{"second_stage"},
                       "second stage",
                       newton_metre_per_degree,
                       [](Found f) -> Estimate const& { return f.second; },
                       -2,
                       [](Case c) { return c.stages.found ? Value(c.stages.second) : Value(); }},
        MeasuredFigure{{"knee"},
                       "knee between them",
                       newton_metre,
                       [](Found f) -> Estimate const& { return f.knee; },
                       -1,
                       [](Case c) { return c.stages.found ? Value(c.stages.knee) : Value(); }},
        MeasuredFigure{{"whole_branch", "whole"},
                       "one line",
                       newton_metre_per_degree,
                       [](Found f) -> Estimate const& { return f.whole; },
                       -2,
                       [](Case c) { return c.stages.found || c.stages.first == 0 ? Value() : Value(c.stages.first); }}};
    return figures;
}

}  // namespace hdconj::figures
