// SPDX-License-Identifier: GPL-3.0-or-later
// A scene whose neutral curve is wanted: what else it has to say, and what it cannot have.
#include "base/text.hpp"
#include "usual_drive.hpp"
#include "validation.hpp"

namespace hdconj::scene {
namespace {

/// Without the displacement only the scene says where the circular spline stands.
void check_seat(SceneReading const& reading, Faults& faults)
{
    if (!reading.scene.given.contains("circular_spline.inner_radius"))
        faults.push_back({"circular_spline.inner_radius", 0, "",
                          "this key is missing: the radius at which the given teeth of the circular spline stand, "
                          "which follows from no displacement while the neutral curve is wanted",
                          "write inner_radius = ..., the tip circle in mm, in [circular_spline]"});
}

/// The curve is found in one plane, between the teeth as they are.
void check_effects(SceneReading const& reading, Faults& faults)
{
    auto const& scene = reading.scene;
    auto const refuse = [&](std::string const& table, auto const& effect, std::string const& reason) {
        if (effect)
            faults.push_back({table, effect->line, "", reason,
                              "remove [" + table + "], and add it to the completed drive that solve writes",
                              effect->line > 0 ? "" : "--set"});
    };
    std::string const axial = "the neutral curve is wanted in one plane, where nothing varies along the axis";
    std::string const later = "needs a drive whose neutral curve is known";
    refuse("coning", scene.coning, axial);
    refuse("tilt", scene.tilt, axial);
    refuse("slices", scene.slices, axial);
    refuse("contact", scene.contact, later);
    refuse("load", scene.load, later);
    refuse("wedm", scene.wedm, later);
}

void check_values(SceneReading const& reading, Faults& faults)
{
    auto const& scene = reading.scene;
    auto const& spline = scene.circular_spline;
    if (spline.automatic_backlash || spline.backlash_offset > 0)
        add_at(faults, "circular_spline.backlash_offset",
               spline.automatic_backlash ? "\"auto\"" : number_text(spline.backlash_offset),
               "the given flanks touch as they are, so no side clearance is looked for or added",
               "remove this key; a given tooth that is thinner has its clearance already");
    if (spline.root_clearance > 0 && spline.profile)
        add_at(faults, "circular_spline.root_clearance", number_text(spline.root_clearance),
               "the depth of the circular spline's tooth space is told by its given tooth",
               "write " + with_height(*spline.profile, "larger", "dedendum") + " and remove this key");
    if (knows(reading, {"solver.kinematics"}) && scene.solver.kinematics == Kinematics::material)
        add_at(faults, "solver.kinematics", "\"material\"",
               "this model needs the Fourier series of a neutral curve that is known",
               "write \"exact\" or \"first-order\"");
    auto const displacement = scene.wave_generator.shape.number("major_displacement");
    if (displacement && knows(reading, {"drive.module", "drive.flexspline_teeth"}) &&
        *displacement > scene.drive.module * scene.drive.flexspline_teeth / 10)
        add_at(faults, "wave_generator.major_displacement", number_text(*displacement),
               "a tenth of the pitch diameter and more bends no ring of a harmonic drive",
               "write about " + number_text(scene.drive.module) + ", one module, or remove the key");
}

}  // namespace

void add_wanted_faults(SceneReading const& reading, Faults& faults)
{
    if (!reading.scene.wants_neutral_curve())
        return;
    check_seat(reading, faults);
    check_effects(reading, faults);
    check_values(reading, faults);
}

}  // namespace hdconj::scene
