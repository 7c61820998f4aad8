// SPDX-License-Identifier: GPL-3.0-or-later
#include "flank_deviation.hpp"

#include <algorithm>
#include <cmath>

namespace hdconj::load {
namespace {

/// A relief of @p amount at the end of its @p length, at the distance @p along from where it begins [mm].
double parabola(double amount, double length, double along)
{
    double const share = std::max(0.0, along / length);
    return amount * share * share;
}

}  // namespace

std::optional<contact::FlankDeviation> flank_deviation(contact::ContactContext const& context,
                                                       std::vector<double> const& z)
{
    Scene const& scene = context.scene;
    if (!scene.tip_relief && !scene.end_relief)
        return std::nullopt;
    contact::FlankDeviation result;
    context.clock.run(Stage::tip_relief, [&] {
        double const amount = scene.tip_relief->amount, from = scene.tip_relief->from_height;
        double const begin = context.tooth.pitch_line + from, length = context.tooth.addendum - from;
        result.height = [=](double y) { return parabola(amount, length, y - begin); };
    });
    context.clock.run(Stage::end_relief, [&] {
        EndRelief const& relief = *scene.end_relief;
        for (double const at : z)
            result.slice.push_back(
                parabola(relief.amount, relief.length, std::abs(at) - (context.width / 2 - relief.length)));
    });
    return result;
}

}  // namespace hdconj::load
