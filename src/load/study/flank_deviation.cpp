// SPDX-License-Identifier: GPL-3.0-or-later
#include "flank_deviation.hpp"

#include <algorithm>
#include <boost/math/interpolators/pchip.hpp>
#include <boost/math/special_functions/fpclassify.hpp>  // pchip of Boost 1.74 leaves it out
#include <cmath>
#include <functional>
#include <utility>

#include "hdconj/contact.hpp"
#include "load/model/ring_errors.hpp"

namespace hdconj::load {
namespace {

using scene::NumberRows;

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

/// The deviation of a profile. Heights are those of its tooth, from the pitch line towards the tip [mm].
struct ProfileDeviation
{
    std::function<double(double)> excess;  ///< of material at a height [mm]; null: none
    double largest = 0;                    ///< over the heights of the tooth, or 0 [mm]
};

/// @param slope   excess of material at the tip @p addendum over that at the root -@p dedendum
/// @param form    rows of height and excess beyond the slope
ProfileDeviation profile_deviation(double slope, NumberRows const& form, double addendum, double dedendum)
{
    if (slope == 0 && form.empty())
        return {};
    double const rise = slope / (addendum + dedendum);
    ProfileDeviation result{[=](double height) { return rise * height; }, std::max(rise * addendum, -rise * dedendum)};
    if (form.empty())
        return result;
    std::vector<double> height, excess;
    for (auto const& row : form) {
        height.push_back(row[0]);
        excess.push_back(row[1]);
    }
    double const low = height.front(), high = height.back();
    result.largest += std::max(0.0, *std::ranges::max_element(excess));
    boost::math::interpolators::pchip<std::vector<double>> const cubic(std::move(height), std::move(excess));
    result.excess = [=](double at) { return rise * at + cubic(std::clamp(at, low, high)); };
    return result;
}

/// Adds the deviation of the flexspline's profile to that of a tip relief.
void add_flexspline_profile(Errors const& errors, profile::Profile const& tooth, contact::FlankDeviation& result)
{
    RingErrors const ring = errors.flexspline.value_or(RingErrors{});
    ProfileDeviation const profile = profile_deviation(
        errors.profile_slope + ring.profile_slope,
        errors.profile_form.empty() ? ring.profile_form : errors.profile_form, tooth.addendum, tooth.dedendum);
    if (!profile.excess)
        return;
    result.excess = profile.largest;
    result.height = [=, before = result.height, pitch_line = tooth.pitch_line](double y) {
        return (before ? before(y) : 0) - profile.excess(y - pitch_line);
    };
}

/// Adds the deviation of the circular spline's profile. Its pitch circle has the radius m z_c/2, and its tooth reaches
/// from the tip circle to the end of the flank in the middle of the width.
void add_spline_profile(Scene const& scene, contact::FlankGrid const& flanks, contact::FlankDeviation& result)
{
    RingErrors const ring = scene.errors->circular_spline.value_or(RingErrors{});
    double const pitch_radius = scene.drive.module * scene.drive.circular_spline_teeth / 2;
    auto const& middle = flanks.point[GapMap::right][flanks.slices() / 2];
    auto const [tip, root] = std::ranges::minmax(middle, {}, [](Vec2 const& p) { return p.squaredNorm(); });
    ProfileDeviation const profile =
        profile_deviation(ring.profile_slope, ring.profile_form, pitch_radius - tip.norm(), root.norm() - pitch_radius);
    if (profile.excess)
        result.radius = [=](double r) { return -profile.excess(pitch_radius - r); };
}

}  // namespace

std::optional<contact::FlankDeviation> flank_deviation(contact::ContactContext const& context,
                                                       contact::FlankGrid const& flanks)
{
    std::vector<double> const& z = flanks.z;
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
        add_flexspline_profile(*scene.errors, context.tooth, result);
        add_spline_profile(scene, flanks, result);
    });
    return result;
}

}  // namespace hdconj::load
