// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalogue_figures.hpp"

#include <algorithm>
#include <cmath>

#include "load_case.hpp"
#include "loaded_scene.hpp"

namespace hdconj::load {
namespace {

/// A twist and its estimated error; negative: none.
struct Twist
{
    double value = 0, error = 0;
};

Stiffness slope(double torque, Twist const& from, Twist const& to)
{
    double const rise = to.value - from.value, error = from.error + to.error;
    return {torque / rise, torque * error / (rise * rise)};
}

}  // namespace

std::optional<CatalogueFigures> catalogue_figures(LoadProblem const& problem, DrivePair const& drives,
                                                  contact::FlankGrid const& flanks, Play const& play,
                                                  LoadCase const& solved)
{
    LoadedState const& rated = solved.curve[solved.rated];
    CatalogueFigures result;
    result.torque = catalogue_torques(problem.context.scene, rated.torque);
    auto const [first, second, lost] = result.torque;
    if (!(rated.torque > second))
        return std::nullopt;
    LoadedCurve const curve = loaded_curve(problem, drives.fine.unloaded, play, {lost, first, second, -lost}, {});
    if (!curve.unsettled.empty())
        return std::nullopt;
    CurveErrors errors;
    errors.states.resize(curve.states.size());
    if (drives.coarse)
        errors = curve_errors(problem.context, *drives.coarse, flanks, curve);
    result.estimated = solved.estimated;
    for (auto const& each : errors.states)
        result.estimated = result.estimated && each;
    auto const twist = [&](std::size_t i) {
        return Twist{curve.states[i].twist, result.estimated ? errors.states[i]->twist : 0};
    };
    Twist const free{std::max(0.0, solved.backlash) / 2, solved.backlash_error / 2},
        at_rated{rated.twist, solved.error.twist};
    result.k1 = slope(first, free, twist(1));
    result.k2 = slope(second - first, twist(1), twist(2));
    result.k3 = slope(rated.torque - second, twist(2), at_rated);
    result.lost_motion = twist(0).value - twist(3).value;
    result.lost_motion_error = twist(0).error + twist(3).error;
    return result;
}

}  // namespace hdconj::load
