// SPDX-License-Identifier: GPL-3.0-or-later
// Reliefs: how far flanks stand back from their nominal form.
#include <algorithm>
#include <cmath>
#include <string>

#include "base/text.hpp"
#include "hdconj/units.hpp"
#include "validation.hpp"

namespace hdconj::scene {
namespace {

/// Of the module.
constexpr double most_of_module = 0.1;

/// Refuses an amount that makes another tooth of it.
void check_amount(SceneReading const& reading, std::string const& key, double amount, Faults& faults)
{
    double const module = reading.scene.drive.module;
    if (knows(reading, {key, "drive.module"}) && amount > most_of_module * module)
        add_at(faults, key, number_text(amount), "more than a tenth of the module makes another drive",
               "write at most " + at_most_text(most_of_module * module) + ", such as " + number_text(0.016 * module));
}

/// Refuses a wobble that moves the ends of the ring further than an eccentricity may.
void check_wobble(SceneReading const& reading, std::string const& key, double wobble, Faults& faults)
{
    if (!knows(reading, {key, "drive.module", "circular_spline.width"}))
        return;
    double const half = *reading.scene.circular_spline.width / 2, most = most_of_module * reading.scene.drive.module;
    if (half * std::tan(wobble) > most)
        add_at(faults, key, number_text(to_deg(wobble)),
               "moves the ends of the teeth by more than a tenth of the module",
               "write at most " + at_most_text(to_deg(std::atan(most / half))));
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

void check_profile(SceneReading const& reading, Errors const& errors, Faults& faults)
{
    double largest = 0;
    bool rising = true;
    for (std::size_t i = 0; i < errors.profile_form.size(); ++i) {
        rising = rising && (i == 0 || errors.profile_form[i][0] > errors.profile_form[i - 1][0]);
        largest = std::max(largest, std::abs(errors.profile_form[i][1]));
    }
    if (!rising)
        add_at(faults, "errors.profile_form", "", "heights do not grow from row to row",
               "write each height once, from the root to the tip");
    check_amount(reading, "errors.profile_form", largest, faults);
    check_amount(reading, "errors.profile_slope", std::abs(errors.profile_slope), faults);
}

}  // namespace

void add_relief_faults(SceneReading const& reading, Faults& faults)
{
    Scene const& scene = reading.scene;
    if (scene.tip_relief)
        check_amount(reading, "tip_relief.amount", scene.tip_relief->amount, faults);
    if (scene.errors) {
        check_profile(reading, *scene.errors, faults);
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

}  // namespace hdconj::scene
