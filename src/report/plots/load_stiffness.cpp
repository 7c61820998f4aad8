// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <limits>

#include "hdconj/units.hpp"
#include "plot.hpp"
#include "plots.hpp"

namespace hdconj::report {
namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

void add_slopes(PlotColumns& columns, LoadCase const& each, double rated)
{
    bool any = false;
    for (std::size_t i = 0; i < each.curve.size(); ++i) {
        auto const& state = each.curve[i];
        if (!(state.torque * rated > 0))
            continue;
        auto const* error = figures::error_of(each, i);
        double const off = error != nullptr ? error->stiffness : 0;
        columns.row(state.torque * per_newton_metre, (state.stiffness - off) * per_newton_metre_per_deg,
                    state.stiffness * per_newton_metre_per_deg, (state.stiffness + off) * per_newton_metre_per_deg);
        any = true;
    }
    if (!any)
        columns.row(nothing, nothing, nothing, nothing);
}

void add_catalogue(PlotColumns& columns, LoadCase const& each, double rated)
{
    if (!each.catalogue) {
        columns.row(nothing, nothing);
        return;
    }
    auto const& [torque, k1, k2, k3, lost, lost_error, estimated] = *each.catalogue;
    auto const line = [&](double k, double from, double to) {
        for (double const at : {from, to})
            columns.row(std::copysign(at, rated) * per_newton_metre, k * per_newton_metre_per_deg);
        columns.end_line();
    };
    line(k1.value, 0, torque.first);
    line(k2.value, torque.first, torque.second);
    line(k3.value, torque.second, std::abs(rated));
}

}  // namespace

std::string load_stiffness_script(LoadStudy const& study)
{
    PlotColumns slopes, catalogue, cases;
    for (auto const& each : study.cases) {
        add_slopes(slopes, each, study.rated_torque);
        slopes.end_index();
        add_catalogue(catalogue, each, study.rated_torque);
        catalogue.end_index();
        auto const k = each.catalogue.value_or(CatalogueFigures());
        cases.named_row(figures::case_name(each), k.k1.value * per_newton_metre, k.k2.value * per_newton_metre,
                        k.k3.value * per_newton_metre, each.catalogue.has_value());
    }
    PlotData data(study.solution.scene.drive.name);
    data.set("slopes", slopes);
    data.set("catalogue", catalogue);
    data.set("cases", cases);
    return plot_script("load_stiffness", data);
}

}  // namespace hdconj::report
