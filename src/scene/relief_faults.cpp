// SPDX-License-Identifier: GPL-3.0-or-later
// Reliefs and errors: how far flanks and cams are from their nominal form. Friction of the running drive.
#include <algorithm>
#include <cmath>
#include <string>

#include "base/text.hpp"
#include "hdconj/units.hpp"
#include "tolerance_limits.hpp"
#include "validation.hpp"

namespace hdconj::scene {
namespace {

/// Refuses an amount that makes another tooth of it.
void check_amount(SceneReading const& reading, std::string const& key, double amount, Faults& faults)
{
    Drive const& drive = reading.scene.drive;
    if (knows(reading, {key, "drive.module"}) && amount > tenth_of_module(drive))
        add_at(faults, key, number_text(amount), "more than a tenth of the module makes another drive",
               "write at most " + at_most_text(tenth_of_module(drive)) + ", such as " +
                   short_number(0.016 * drive.module, 2));
}

/// Refuses a wobble that moves the ends of the ring further than an eccentricity may.
void check_wobble(SceneReading const& reading, std::string const& key, double wobble, Faults& faults)
{
    if (!knows(reading, {key, "drive.module", "circular_spline.width"}))
        return;
    double const half = *reading.scene.circular_spline.width / 2, most = tenth_of_module(reading.scene.drive);
    if (half * std::tan(wobble) > most)
        add_at(faults, key, number_text(to_deg(wobble)),
               "moves the ends of the teeth by more than a tenth of the module",
               "write at most " + at_most_text(to_deg(std::atan(most / half))));
}

/// Refuses edges of the lands that leave no land.
void check_edges(SceneReading const& reading, double radius, Faults& faults)
{
    constexpr double most = 0.25;  // modules: lands are 0.2 to 0.7 wide, and an edge takes 0.7 of its radius
    if (knows(reading, {"load.edge_radius", "drive.module"}) && radius > most * reading.scene.drive.module)
        add_at(faults, "load.edge_radius", number_text(radius), "edges as round as that leave no land",
               "write at most " + at_most_text(most * reading.scene.drive.module) +
                   ", a quarter of the module, such as " + short_number(0.04 * reading.scene.drive.module, 2));
}

/// Whether the first numbers of @p rows grow from row to row.
bool are_growing(NumberRows const& rows)
{
    return std::ranges::adjacent_find(rows, [](auto const& a, auto const& b) { return !(b[0] > a[0]); }) == rows.end();
}

/// The largest size of the second numbers of @p rows.
double largest_excess(NumberRows const& rows)
{
    double largest = 0;
    for (auto const& row : rows)
        largest = std::max(largest, std::abs(row[1]));
    return largest;
}

/// @param table  the table of the keys profile_slope and profile_form, with its dot
void check_profile(SceneReading const& reading, std::string const& table, double slope, NumberRows const& form,
                   Faults& faults)
{
    if (!are_growing(form))
        add_at(faults, table + "profile_form", "", "heights do not grow from row to row",
               "write each height once, from the root to the tip");
    check_amount(reading, table + "profile_form", largest_excess(form), faults);
    check_amount(reading, table + "profile_slope", std::abs(slope), faults);
}

/// Refuses a profile of the flexspline that stands in two tables.
void check_twice(Scene const& scene, std::string const& key, Faults& faults)
{
    if (scene.given.contains("errors." + key) && scene.given.contains("errors.flexspline." + key))
        add_at(faults, "errors.flexspline." + key, "", "errors." + key + " says the same of the same flanks",
               "remove one of errors." + key + " and errors.flexspline." + key);
}

/// Errors of one ring. Its pitches stand in one list, or are random.
void check_ring(SceneReading const& reading, std::string const& ring, std::optional<RingErrors> const& errors,
                int teeth, Faults& faults)
{
    if (!errors)
        return;
    std::string const path = "errors." + ring + ".";
    check_amount(reading, path + "pitch_deviation", errors->pitch_deviation, faults);
    check_amount(reading, path + "eccentricity", errors->eccentricity, faults);
    check_wobble(reading, path + "wobble_deg", errors->wobble, faults);
    check_profile(reading, path, errors->profile_slope, errors->profile_form, faults);
    if (!knows(reading, {path + "pitch", "drive." + ring + "_teeth"}))
        return;
    auto const count = static_cast<int>(errors->pitch.size());
    if (count != teeth)
        add_at(faults, path + "pitch", "", std::to_string(count) + " places for " + std::to_string(teeth) + " teeth",
               "write one number for each tooth, in mm");
    if (reading.scene.given.contains(path + "pitch_deviation"))
        add_at(faults, path + "pitch_deviation", "", "the list pitch says where each tooth stands",
               "remove one of pitch and pitch_deviation");
    double largest = 0;
    for (double const place : errors->pitch)
        largest = std::max(largest, std::abs(place));
    check_amount(reading, path + "pitch", largest, faults);
}

void check_wave_generator(SceneReading const& reading, WaveGeneratorErrors const& errors, Faults& faults)
{
    std::string const table = "errors.wave_generator.", cam = table + "cam_deviation";
    check_amount(reading, table + "eccentricity", errors.eccentricity, faults);
    check_amount(reading, cam, largest_excess(errors.cam_deviation), faults);
    if (!are_growing(errors.cam_deviation))
        add_at(faults, cam, "", "angles do not grow from row to row", "write each angle once, in growing order");
    else if (!errors.cam_deviation.empty() &&
             !(errors.cam_deviation.back()[0] - errors.cam_deviation.front()[0] < from_deg(360)))
        add_at(faults, cam, "", "the angles span a whole turn or more",
               "leave out what repeats the first row after 360 degrees");
}

/// A Stribeck curve needs its speed, and falls from rest on.
void check_flanks(SceneReading const& reading, Faults& faults)
{
    Friction const& friction = *reading.scene.friction;
    bool const told = reading.scene.given.contains("friction.stribeck_speed");
    if (!friction.flanks_at_rest) {
        if (told)
            add_at(faults, "friction.stribeck_speed", number_text(friction.stribeck_speed),
                   "without flanks_at_rest the coefficient is the same at every speed",
                   "write flanks_at_rest, or remove this key");
        return;
    }
    if (!(friction.stribeck_speed > 0))
        add_at(faults, told ? "friction.stribeck_speed" : "friction.flanks_at_rest",
               told ? number_text(friction.stribeck_speed) : "",
               "nothing says at which speed the coefficient falls from flanks_at_rest to flanks",
               "write stribeck_speed = 20.0, a sliding speed in mm/s, in [friction]");
    if (*friction.flanks_at_rest < friction.flanks)
        add_at(faults, "friction.flanks_at_rest", number_text(*friction.flanks_at_rest),
               "flanks at rest would rub less than sliding ones",
               "write at least " + number_text(friction.flanks) + ", the value of flanks");
}

/// The part of the bearing's torque that depends on speed depends on the lubricant.
void check_lubricant(SceneReading const& reading, Faults& faults)
{
    Friction const& friction = *reading.scene.friction;
    if (friction.bearing_speed > 0)
        for (auto const& [key, given] : {std::pair("friction.viscosity_40", friction.viscosity_40.has_value()),
                                         std::pair("friction.viscosity_100", friction.viscosity_100.has_value())})
            if (!given && !reading.scene.given.contains(key))
                add_at(faults, key, "", "this key is missing: bearing_speed needs the lubricant at both temperatures",
                       "write the kinematic viscosity in mm^2/s, or remove bearing_speed");
    if (friction.viscosity_40 && friction.viscosity_100 && *friction.viscosity_100 >= *friction.viscosity_40)
        add_at(faults, "friction.viscosity_100", number_text(*friction.viscosity_100),
               "a lubricant is thinner at 100 than at 40 degrees Celsius",
               "write less than " + number_text(*friction.viscosity_40) + ", the value of viscosity_40");
}

}  // namespace

void add_relief_faults(SceneReading const& reading, Faults& faults)
{
    Scene const& scene = reading.scene;
    if (scene.tip_relief)
        check_amount(reading, "tip_relief.amount", scene.tip_relief->amount, faults);
    if (scene.load && scene.load->edge_radius)
        check_edges(reading, *scene.load->edge_radius, faults);
    if (scene.errors) {
        check_profile(reading, "errors.", scene.errors->profile_slope, scene.errors->profile_form, faults);
        for (char const* key : {"profile_slope", "profile_form"})
            check_twice(scene, key, faults);
        if (scene.errors->wave_generator)
            check_wave_generator(reading, *scene.errors->wave_generator, faults);
        check_ring(reading, "flexspline", scene.errors->flexspline, scene.drive.flexspline_teeth, faults);
        check_ring(reading, "circular_spline", scene.errors->circular_spline, scene.drive.circular_spline_teeth,
                   faults);
    }
    if (!scene.end_relief)
        return;
    check_amount(reading, "end_relief.amount", scene.end_relief->amount, faults);
    if (knows(reading, {"end_relief.length", "circular_spline.width"}) &&
        scene.end_relief->length > *scene.circular_spline.width / 2)
        add_at(faults, "end_relief.length", number_text(scene.end_relief->length),
               "the reliefs of both ends would overlap",
               "write at most " + at_most_text(*scene.circular_spline.width / 2) +
                   ", half the width of the circular spline");
}

void add_running_faults(SceneReading const& reading, Faults& faults)
{
    if (knows(reading, {"friction.flanks"}))
        check_flanks(reading, faults);
    check_lubricant(reading, faults);
}

}  // namespace hdconj::scene
