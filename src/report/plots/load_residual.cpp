// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <optional>

#include "hdconj/units.hpp"
#include "plot.hpp"
#include "plots.hpp"
#include "rig_samples.hpp"

namespace hdconj::report {
namespace {

/// Twist of the rig's two straight lines, or its one line, from half of the loop on; half of the loop alone where
/// neither is determined.
double twist_of_lines(MeasuredStiffness const& found, double torque)
{
    double const size = std::abs(torque), half = found.loop_width.value / 2;
    bool const bent = found.first.count > 0;
    if (!bent && found.whole.count == 0)
        return std::copysign(half, torque);
    double const first = bent ? found.first.value : found.whole.value, knee = bent ? found.knee.value : size;
    double const elastic = size <= knee ? size / first : knee / first + (size - knee) / found.second.value;
    return std::copysign(half + elastic, torque);
}

/// Twist of a computed curve at a torque; nothing beyond its ends or where its torques have both signs.
std::optional<double> twist_of_curve(std::vector<LoadedState> const& curve, double torque)
{
    auto const above = std::ranges::lower_bound(curve, torque, {}, &LoadedState::torque);
    if (above == curve.begin() || above == curve.end())
        return std::nullopt;
    LoadedState const &low = above[-1], &high = *above;
    if (low.torque * high.torque <= 0)
        return std::nullopt;
    return low.twist + (high.twist - low.twist) * (torque - low.torque) / (high.torque - low.torque);
}

}  // namespace

std::string load_residual_script(LoadStudy const& study, Measurement const& measured)
{
    auto const* shown = figures::shown_case(study);
    PlotColumns lines, curve;
    double const per_spline = measured.curve.rig.angle_per_spline;
    for (auto const& [twist, torque] : rig_samples(measured)) {
        if (std::abs(torque) < measured_at::no_load * measured.found.largest_torque)
            continue;
        // of the circular spline, as all curves
        double const at = torque * per_spline, turned = twist / per_spline;
        lines.row(at * per_newton_metre, (turned - twist_of_lines(measured.found, torque) / per_spline) * per_arcmin);
        if (auto const expected = shown != nullptr ? twist_of_curve(shown->curve, at) : std::nullopt)
            curve.row(at * per_newton_metre, (turned - *expected) * per_arcmin);
    }
    PlotData data(shown_load(study));
    data.set("bent", measured.found.first.count > 0);
    data.set("step", measured.found.angle_step / per_spline * per_arcmin);
    data.set("lines", lines);
    data.set("curve", curve);
    return plot_script("load_residual", data);
}

}  // namespace hdconj::report
