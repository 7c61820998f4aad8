// SPDX-License-Identifier: GPL-3.0-or-later
// Tilt, slices, contact and load: what is made of the teeth along the axis, and asked of them.
#include <cmath>

#include "base/text.hpp"
#include "hdconj/units.hpp"
#include "tolerance_limits.hpp"
#include "usual_cup.hpp"
#include "validation.hpp"

namespace hdconj::scene {
namespace {

void check_tilt(SceneReading const& reading, Faults& faults)
{
    auto const& scene = reading.scene;
    if (!scene.tilt)
        return;
    bool const too_steep = std::abs(scene.tilt->angle) >= bounds::largest_tilt_deg * deg;
    if (too_steep && knows(reading, {"tilt.angle_deg"}))
        add_at(faults, "tilt.angle_deg", number_text(scene.tilt->angle / deg),
               "teeth are not tilted by " + number_text(bounds::largest_tilt_deg) + " degrees or more",
               "write an angle in degrees between -45 and 45, such as angle_deg = 0.2");
    bool const both = scene.slices && knows(reading, {"tilt.kind", "slices.surface"});
    if (both && scene.tilt->kind == TiltKind::draft && scene.slices->surface != ToothSurface::tilted)
        add_at(faults, "tilt.kind", "\"draft\"",
               "a draft needs one outline to offset, but surface " + in_quotes(to_string(scene.slices->surface)) +
                   " has an outline for each slice",
               "write kind = \"radial\", or surface = \"tilted\" in [slices]");
    bool const upright = scene.slices && scene.circular_spline.width &&
                         knows(reading, {"tilt.angle_deg", "circular_spline.inner_radius"});
    double const rise = upright ? *scene.circular_spline.width / 2 * std::tan(std::abs(scene.tilt->angle)) : 0;
    if (upright && !too_steep && scene.circular_spline.inner_radius && rise >= *scene.circular_spline.inner_radius)
        add_at(faults, "tilt.angle_deg", number_text(scene.tilt->angle / deg),
               "over half the width of " + number_text(*scene.circular_spline.width) +
                   " mm the tip circle would shrink to nothing",
               "write a smaller angle, such as angle_deg = 0.2");
}

void check_slices(SceneReading const& reading, Faults& faults)
{
    auto const& scene = reading.scene;
    bool const spread = scene.slices && knows(reading, {"slices.count"}) && scene.slices->count > 1;
    if (spread && !scene.given.contains("circular_spline.width"))
        faults.push_back(
            {"circular_spline.width", 0, "", "this key is missing: [slices] spreads over the width",
             "write width = " + length_text(UsualCup(scene).spline_width) + ", a length in mm, in [circular_spline]"});
}

/// The axial effects move the flexspline's given tooth.
void check_axial_reverse(SceneReading const& reading, Faults& faults)
{
    auto const& scene = reading.scene;
    auto const refuse = [&](std::string const& table, auto const& effect) {
        if (scene.is_reverse() && effect)
            faults.push_back(
                {table, effect->line, "",
                 "axial effects need the flexspline's tooth, but the circular spline's is given",
                 "remove [" + table + "], or give [flexspline.profile] in place of [circular_spline.profile]",
                 effect->line > 0 ? "" : "--set"});
    };
    refuse("coning", scene.coning);
    refuse("tilt", scene.tilt);
    refuse("slices", scene.slices);
    refuse("contact", scene.contact);
    if (scene.is_reverse() && scene.circular_spline.automatic_backlash)
        add_at(faults, "circular_spline.backlash_offset", "\"auto\"",
               "needs the flexspline's tooth, but the circular spline's is given",
               "write a length in mm, such as 0.02");
}

void check_contact(SceneReading const& reading, Faults& faults)
{
    auto const& scene = reading.scene;
    if (scene.contact && knows(reading, {"contact.contact_gap", "drive.module"}) &&
        scene.contact->gap > tenth_of_module(scene.drive)) {
        add_at(faults, "contact.contact_gap", number_text(scene.contact->gap),
               "flanks a tenth of the module apart do not touch",
               "write at most " + at_most_text(tenth_of_module(scene.drive)) + ", such as 0.001");
    }
}

/// What the usual torque in place of a missing one says: load/study/loaded_scene.cpp.
void check_catalogue_torques(SceneReading const& reading, Faults& faults)
{
    auto const& load = reading.scene.load;
    if (load && load->first_torque && load->second_torque && !(*load->first_torque < *load->second_torque)) {
        std::string const second = short_number(*load->second_torque / newton_metre) + " N m";
        add_at(faults, "load.first_torque", short_number(*load->first_torque / newton_metre),
               "T1 is not below T2, " + second, "write one below " + second);
    }
}

}  // namespace

void add_axial_faults(SceneReading const& reading, Faults& faults)
{
    check_tilt(reading, faults);
    check_slices(reading, faults);
    check_axial_reverse(reading, faults);
    check_contact(reading, faults);
    check_catalogue_torques(reading, faults);
}

}  // namespace hdconj::scene
