// SPDX-License-Identifier: GPL-3.0-or-later
#include "friction_loss.hpp"

#include <algorithm>
#include <cmath>

#include "hdconj/units.hpp"

namespace hdconj::running {

double flank_coefficient(Friction const& friction, double speed)
{
    if (!friction.flanks_at_rest)
        return friction.flanks;
    return friction.flanks + (*friction.flanks_at_rest - friction.flanks) * std::exp(-speed / friction.stribeck_speed);
}

double viscosity(Friction const& friction, double temperature)
{
    constexpr double zero = 273.15, shift = 0.7;  // of ASTM D341
    auto const height = [](double nu) { return std::log10(std::log10(nu + shift)); };
    double const cold = std::log10(zero + 40), hot = std::log10(zero + 100);
    double const at_cold = height(*friction.viscosity_40), at_hot = height(*friction.viscosity_100);
    double const at = at_cold + (at_hot - at_cold) * (std::log10(zero + temperature) - cold) / (hot - cold);
    return std::pow(10, std::pow(10, at)) - shift;
}

double lubricant_torque(Friction const& friction, double diameter, double viscosity, double speed)
{
    constexpr double limit = 2000;  // of nu n: below, the film is always the same
    constexpr double unit = 1e-7;   // of f0, in Palmgren's units
    double const product = std::max(limit, viscosity * speed / rpm);
    // 160 is 2000^(2/3), rounded
    double const factor = product > limit ? std::pow(product, 2.0 / 3) : 160;
    return unit * friction.bearing_speed * factor * diameter * diameter * diameter;
}

double load_torque(Friction const& friction, double diameter, double ball_load)
{
    constexpr double equivalent = 0.8225;
    return friction.bearing_load * equivalent * ball_load * diameter;
}

double bearing_diameter(Scene const& scene, double flexspline_inner_radius)
{
    BearingChoice const& bearing = *scene.bearing;
    return 2 * (flexspline_inner_radius - bearing.ring_thickness.value_or(0)) - bearing.ball_diameter.value_or(0);
}

double flank_loss(LossModel const& model, LoadedRun const& run, double speed)
{
    double const rate = model.motion.cup_rate();
    double sum = 0;
    for (WeighedContacts const& position : run.sliding)
        for (SlidingContact const& each : position.contacts)
            sum += position.weight * flank_coefficient(model.friction, rate * each.sliding * speed) * each.force *
                   rate * each.sliding;
    return sum;
}

EfficiencyRow efficiency_at(LossModel const& model, LoadedRun const& run, double speed, double temperature)
{
    Friction const& friction = model.friction;
    double const rate = model.motion.cup_rate();
    EfficiencyRow row{.torque = run.torque, .speed = speed, .temperature = temperature};
    row.flanks = flank_loss(model, run, speed);
    row.bearing_load = rate * load_torque(friction, model.diameter, run.ball_load);
    if (friction.bearing_speed > 0)
        row.bearing_speed =
            rate * lubricant_torque(friction, model.diameter, viscosity(friction, temperature), rate * speed);
    row.seal = friction.seal;
    row.churning = friction.churning * speed;
    double const useful = run.torque / model.motion.ratio();
    double const lost = row.flanks + row.bearing_load + row.bearing_speed + row.seal + row.churning;
    row.input_torque = useful + lost;
    row.efficiency = useful / row.input_torque;
    if (std::isnan(row.efficiency))
        row.efficiency_error = row.efficiency;
    return row;
}

double resting_torque(LossModel const& model, LoadedRun const& run)
{
    double const bearing = load_torque(model.friction, model.diameter, run.ball_load) +
                           lubricant_torque(model.friction, model.diameter, 0, 0);
    return flank_loss(model, run, 0) + model.motion.cup_rate() * bearing + model.friction.seal;
}

std::optional<double> back_driving_torque(LossModel const& model, std::vector<LoadedRun> const& runs)
{
    auto const excess = [&](LoadedRun const& run) {
        return run.torque / model.motion.ratio() - resting_torque(model, run);
    };
    for (std::size_t i = 1; i < runs.size(); ++i) {
        double const here = excess(runs[i]);
        if (here < 0)
            continue;
        double const before = excess(runs[i - 1]);
        double const share = here > before ? -before / (here - before) : 0;
        return runs[i - 1].torque + share * (runs[i].torque - runs[i - 1].torque);
    }
    return std::nullopt;
}

}  // namespace hdconj::running
