// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "hdconj/units.hpp"
#include "plot.hpp"
#include "plots.hpp"

namespace hdconj::report {

std::string wire_residual_script(WireSetUps const& programs)
{
    int last_pass = 0, first_space = 0, last_space = 0;
    for (auto const& program : programs) {
        for (auto const& each : program.residuals) {
            last_pass = std::max(last_pass, each.pass);
            first_space = std::min(first_space, each.tooth);
            last_space = std::max(last_space, each.tooth);
        }
    }
    PlotColumns rows[2][2];  // by whether they mesh, and in which face
    double highest = 0;
    for (auto const& program : programs) {
        for (auto const& each : program.residuals) {
            if (each.pass != last_pass)
                continue;
            rows[each.meshing][each.upper].row(each.tooth, each.height * per_um);
            highest = std::max(highest, each.height * per_um);
        }
    }
    PlotData data(programs.front().name);
    data.set("pass", last_pass);
    data.set("wire_diameter", programs.front().wire_diameter);
    data.set("first_space", first_space);
    data.set("last_space", last_space);
    data.set("highest", highest);
    data.set("lower_idle", rows[false][false]);
    data.set("upper_idle", rows[false][true]);
    data.set("lower_meshing", rows[true][false]);
    data.set("upper_meshing", rows[true][true]);
    return plot_script("wire_residual", data);
}

}  // namespace hdconj::report
