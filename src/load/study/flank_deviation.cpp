// SPDX-License-Identifier: GPL-3.0-or-later
#include "flank_deviation.hpp"

#include <algorithm>
#include <boost/math/interpolators/pchip.hpp>
#include <boost/math/special_functions/fpclassify.hpp>  // pchip of Boost 1.74 leaves it out
#include <cmath>
#include <functional>
#include <utility>

#include "load/model/ring_errors.hpp"

namespace hdconj::load {
namespace {

/// A relief of @p amount at the end of its @p length, at the distance @p along from where it begins [mm].
double parabola(double amount, double length, double along)
{
    double const share = std::max(0.0, along / length);
    return amount * share * share;
}

/// How far the flexspline's flanks stand back at a height of the tooth frame [mm].
std::function<double(double)> tip_relief(TipRelief const& relief, profile::Profile const& tooth)
{
    double const amount = relief.amount, begin = tooth.pitch_line + relief.from_height;
    double const length = tooth.addendum - relief.from_height;
    return [=](double y) { return parabola(amount, length, y - begin); };
}

/// Adds the deviation of the flexspline's profile to that of a tip relief.
void add_profile(Errors const& errors, profile::Profile const& tooth, contact::FlankDeviation& result)
{
    if (errors.profile_slope == 0 && errors.profile_form.empty())
        return;
    double const slope = errors.profile_slope / (tooth.addendum + tooth.dedendum), pitch_line = tooth.pitch_line;
    result.excess = std::max(slope * tooth.addendum, -slope * tooth.dedendum);
    auto const before = result.height;
    result.height = [=](double y) { return (before ? before(y) : 0) - slope * (y - pitch_line); };
    if (errors.profile_form.empty())
        return;
    std::vector<double> height, excess;
    for (auto const& row : errors.profile_form) {
        height.push_back(row[0]);
        excess.push_back(row[1]);
    }
    double const low = height.front(), high = height.back();
    result.excess += std::max(0.0, *std::ranges::max_element(excess));
    boost::math::interpolators::pchip<std::vector<double>> const form(std::move(height), std::move(excess));
    auto const straight = result.height;
    result.height = [=](double y) { return straight(y) - form(std::clamp(y - pitch_line, low, high)); };
}

}  // namespace

std::optional<contact::FlankDeviation> flank_deviation(contact::ContactContext const& context,
                                                       std::vector<double> const& z)
{
    Scene const& scene = context.scene;
    if (!scene.tip_relief && !scene.end_relief && !scene.errors)
        return std::nullopt;
    contact::FlankDeviation result;
    context.clock.run(Stage::tip_relief, [&] { result.height = tip_relief(*scene.tip_relief, context.tooth); });
    context.clock.run(Stage::end_relief, [&] {
        EndRelief const& relief = *scene.end_relief;
        for (double const at : z)
            result.slice.push_back(
                parabola(relief.amount, relief.length, std::abs(at) - (context.width / 2 - relief.length)));
    });
    context.clock.run(Stage::errors, [&] {
        RingDisplacements rings = ring_displacements(scene);
        result.teeth = std::move(rings.teeth);
        result.spaces = std::move(rings.spaces);
        result.z = z;
        add_profile(*scene.errors, context.tooth, result);
    });
    return result;
}

}  // namespace hdconj::load
