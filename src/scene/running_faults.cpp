// SPDX-License-Identifier: GPL-3.0-or-later
// Friction of the running drive.
#include "base/text.hpp"
#include "validation.hpp"

namespace hdconj::scene {
namespace {

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

void add_running_faults(SceneReading const& reading, Faults& faults)
{
    if (knows(reading, {"friction.flanks"}))
        check_flanks(reading, faults);
    check_lubricant(reading, faults);
}

}  // namespace hdconj::scene
