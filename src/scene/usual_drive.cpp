// SPDX-License-Identifier: GPL-3.0-or-later
#include "usual_drive.hpp"

#include <algorithm>
#include <cmath>

#include "base/text.hpp"
#include "tolerance_limits.hpp"

namespace hdconj::scene {

double usual_deformation(Drive const& drive)
{
    return drive.module * (drive.circular_spline_teeth - drive.flexspline_teeth) / 2;
}

double deformation_ratio(Drive const& drive, double w0)
{
    return w0 / usual_deformation(drive);
}

std::string usual_torque(Drive const& drive)
{
    constexpr double of_type_50 = 28, radius = 25;
    constexpr int digits = 2;
    return short_number(of_type_50 * std::pow(flexspline_pitch_radius(drive) / radius, 3), digits);
}

void Advice::add(std::string const& key, std::string const& value)
{
    words += (words.empty() ? "" : " and ") + key + " = " + value;
    set.push_back(key + "=" + value);
}

namespace {

constexpr double parting = 0.8;  // of the deformation, by which tips at the minor axis are nearer to the axis

/// Adds the tip circle that goes with the radial deformation @p w0; one that was given for another is left out. One
/// that is wider than what goes with either, for the lands' sake, stays where it leaves half of the working depth.
void add_tip_circle(Scene const& scene, double w0, Advice& advice)
{
    bool const given = scene.circular_spline.inner_radius.has_value();
    auto const usual = usual_tip_radius(scene, w0);
    double const middle = flexspline_pitch_radius(scene.drive) + w0,
                 addendum = scene.flexspline.profile.number_or("addendum", 0), standard = middle - addendum;
    auto const now = scene.wave_generator.shape.number("radial_deformation");
    // a tip circle for a larger deformation is to follow that; one for a smaller deformation leaves more land
    double const with_now = (now && *now > w0 ? usual_tip_radius(scene, *now) : std::nullopt).value_or(0);
    if (usual && given && *scene.circular_spline.inner_radius > std::max(*usual, with_now) &&
        *scene.circular_spline.inner_radius <= (*usual + middle + addendum) / 2)
        return;
    if (usual && (given || short_number(*usual) != short_number(standard))) {
        advice.add("circular_spline.inner_radius", short_number(*usual));
    } else if (given && !scene.is_reverse()) {
        advice.words += ", and leave circular_spline.inner_radius out";
        advice.set.emplace_back("!circular_spline.inner_radius");
    }
}

/// Adds the radial deformation @p w0 and what goes with it.
void add_deformation(Scene const& scene, double w0, Advice& advice)
{
    advice.add(scene.wave_generator.shape.path + ".radial_deformation", short_number(w0));
    add_tip_circle(scene, w0, advice);
    if (auto const largest = usual_addendum(scene, w0); largest && scene.flexspline.addendum > *largest)
        advice.add("flexspline.addendum", at_most_text(*largest));
}

}  // namespace

std::optional<double> usual_addendum(Scene const& scene, double w0)
{
    if (!scene.is_reverse() || scene.flexspline.inner_radius)
        return std::nullopt;
    auto const given = scene.given_profile().number("addendum");
    double const radius = flexspline_pitch_radius(scene.drive);
    if (!given)
        return std::nullopt;
    double const largest = scene.circular_spline.inner_radius.value_or(radius + w0 - *given) - radius + parting * w0;
    return largest > 0 ? std::optional(largest) : std::nullopt;
}

std::optional<double> usual_tip_radius(Scene const& scene, double w0)
{
    auto const addendum = scene.flexspline.profile.number("addendum");
    auto const dedendum = scene.flexspline_dedendum();
    if (scene.is_reverse() || !addendum || !dedendum || scene.flexspline.inner_radius)
        return std::nullopt;
    return usual_tip_radius(scene.drive, *addendum, *dedendum, w0);
}

double usual_tip_radius(Drive const& drive, double addendum, double dedendum, double w0)
{
    constexpr double rim = 0.05;  // modules
    double const radius = flexspline_pitch_radius(drive);
    return std::max(
        {radius + w0 - addendum, radius + addendum - parting * w0, radius + w0 - dedendum + rim * drive.module});
}

std::string with_height(FamilyChoice const& tooth, std::string const& change, std::string const& key)
{
    return tooth.has(key) ? "a " + change + " " + tooth.path + "." + key
                          : "a tooth in [" + tooth.path + "] with a " + change + " " + key;
}

Advice usual_pair(Scene const& scene, std::optional<double> kept)
{
    Advice advice;
    Drive drive = scene.drive;
    int const waves = scene.wave_generator.waves, more = drive.circular_spline_teeth - drive.flexspline_teeth;
    constexpr int usual_waves = 2;
    if (more != waves && more == usual_waves) {
        advice.add("wave_generator.waves", std::to_string(more));
    } else if (more != waves) {
        drive.circular_spline_teeth = drive.flexspline_teeth + waves;
        advice.add("drive.circular_spline_teeth", std::to_string(drive.circular_spline_teeth));
    }
    if (kept && is_usual(deformation_ratio(drive, *kept)))
        return advice;
    FamilyChoice const& shape = scene.wave_generator.shape;
    if (!shape.has("radial_deformation"))
        return {};
    add_deformation(scene, usual_deformation(drive), advice);
    return advice;
}

Advice with_deformation(Scene const& scene, double w0)
{
    Advice advice;
    if (scene.wave_generator.shape.has("radial_deformation"))
        add_deformation(scene, w0, advice);
    return advice;
}

Advice with_addendum(Scene const& scene, double w0, double addendum)
{
    constexpr int digits = 3;
    Scene higher = scene;
    higher.flexspline.profile.given.at("addendum").value = addendum;
    Advice advice;
    advice.add(scene.flexspline.profile.path + ".addendum", short_number(addendum, digits));
    auto const now = usual_tip_radius(scene, w0), then = usual_tip_radius(higher, w0);
    if (scene.circular_spline.inner_radius && now && then)
        advice.add("circular_spline.inner_radius", short_number(*scene.circular_spline.inner_radius + *then - *now));
    return advice;
}

void add_pressure_angle(Scene const& scene, Advice& advice)
{
    // straight and involute flanks of 60 to 240 teeth touch over one pitch and more from 24 and 19 degrees on
    constexpr double rack = 17, turning = 400, good = 26;  // [deg]
    FamilyChoice const& tooth = scene.flexspline.profile;
    auto const angle = tooth.number("pressure_angle_deg");
    bool const plain = tooth.family == "straight" || tooth.family == "involute";
    if (plain && angle && *angle < std::min(good, rack + turning / scene.drive.flexspline_teeth))
        advice.add(tooth.path + ".pressure_angle_deg", short_number(good));
}

std::optional<std::string> unusual_deformation(Drive const& drive, double w0)
{
    double const ratio = deformation_ratio(drive, w0);
    // without a positive tooth difference nothing is usual
    if (!(usual_deformation(drive) > 0) || is_usual(ratio))
        return std::nullopt;
    constexpr int digits = 3;
    return "the radial deformation " + short_number(w0) + " mm is " + short_number(ratio, digits) +
           " times the usual m (z_c - z_f)/2 = " + short_number(usual_deformation(drive)) + " mm";
}

}  // namespace hdconj::scene
