// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numbers>

#include "hdconj/units.hpp"
#include "plot.hpp"
#include "plots.hpp"

namespace hdconj::report {

bool has_balls(LoadStudy const& study)
{
    auto const* shown = figures::shown_case(study);
    return study.balls > 0 && shown != nullptr && !shown->bearing.ball_force.empty();
}

std::string load_ball_script(LoadStudy const& study)
{
    auto const& bearing = figures::shown_case(study)->bearing;
    PlotColumns carrying, idle;
    for (std::size_t b = 0; b < bearing.ball_angle.size(); ++b) {
        double const force = bearing.ball_force.at(b);
        for (int i = 0; i < study.sectors; ++i) {
            constexpr double turn = 2 * std::numbers::pi;
            double const angle = std::remainder(bearing.ball_angle[b] + turn * i / study.sectors, turn);
            (force > 0 ? carrying : idle).row(angle * per_deg, force);
        }
    }
    PlotData data(shown_load(study));
    data.set("largest", *std::max_element(bearing.ball_force.begin(), bearing.ball_force.end()));
    data.set("waves", study.solution.scene.wave_generator.waves);
    data.set("carrying", carrying);
    data.set("idle", idle);
    return plot_script("load_balls", data);
}

}  // namespace hdconj::report
