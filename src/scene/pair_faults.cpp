// SPDX-License-Identifier: GPL-3.0-or-later
// Teeth, wall, deformation and clearances of the pair in one plane, and of one whose neutral curve is wanted.
#include <algorithm>
#include <cmath>

#include "base/text.hpp"
#include "tolerance_limits.hpp"
#include "usual_drive.hpp"
#include "validation.hpp"

namespace hdconj::scene {
namespace {

/// What makes the pair a usual one whose flanks touch.
Advice drive_advice(Scene const& scene)
{
    Advice advice = usual_pair(scene, scene.wave_generator.shape.number("radial_deformation").value_or(0));
    add_pressure_angle(scene, advice);
    return advice;
}

void check_teeth(SceneReading const& reading, Faults& faults)
{
    if (!knows(reading, {"drive.flexspline_teeth", "drive.circular_spline_teeth", "wave_generator.waves"}))
        return;
    auto const& drive = reading.scene.drive;
    int const waves = reading.scene.wave_generator.waves;
    int const more = drive.circular_spline_teeth - drive.flexspline_teeth;
    bool const meets = more > 0 && more % waves == 0;
    if (meets && more / waves > bounds::most_pitches_per_lobe) {
        add_at(faults, "drive.circular_spline_teeth", std::to_string(drive.circular_spline_teeth),
               "each wave would move the flexspline by " + std::to_string(more / waves) +
                   " teeth of the circular spline, and more than " + std::to_string(bounds::most_pitches_per_lobe) +
                   " are not computed",
               "write " + std::to_string(drive.flexspline_teeth + waves) +
                   ", flexspline_teeth plus waves, or another small multiple of waves more");
        faults.back().set = drive_advice(reading.scene).set;
    }
    if (meets)
        return;
    Advice const advice = drive_advice(reading.scene);
    std::string const teeth = std::to_string(drive.flexspline_teeth + waves);
    add_at(faults, "drive.circular_spline_teeth", std::to_string(drive.circular_spline_teeth),
           "must be flexspline_teeth = " + std::to_string(drive.flexspline_teeth) +
               " plus a positive multiple of waves = " + std::to_string(waves) +
               ", or the teeth do not meet at every wave",
           more == 2 ? "write wave_generator.waves = 2, or here " + teeth : "write " + teeth);
    faults.back().set = advice.set;
}

void check_tolerance(SceneReading const& reading, Faults& faults)
{
    if (!knows(reading, {"solver.tolerance", "drive.module"}))
        return;
    double const tolerance = reading.scene.solver.tolerance;
    double const largest = tenth_of_module(reading.scene.drive);
    if (tolerance > largest)
        add_at(faults, "solver.tolerance", number_text(tolerance),
               "is above a tenth of the module, too coarse for a tooth",
               "write at most " + at_most_text(largest) + ", such as 1e-6");
    if (!knows(reading, {"drive.flexspline_teeth"}))
        return;
    double const least = least_tolerance(reading.scene.drive);
    if (tolerance < least)
        add_at(faults, "solver.tolerance", number_text(tolerance),
               "cannot be reached in double precision on a radius of " +
                   short_number(flexspline_pitch_radius(reading.scene.drive)) + " mm",
               "write at least " + at_least_text(least));
}

void check_wall(SceneReading const& reading, Faults& faults)
{
    auto const& scene = reading.scene;
    if (knows(reading, {"flexspline.wall", "flexspline.neutral_offset"}) &&
        std::abs(scene.flexspline.neutral_offset) > scene.flexspline.wall / 2) {
        add_at(faults, "flexspline.neutral_offset", number_text(scene.flexspline.neutral_offset),
               "the neutral layer would lie outside the wall",
               "write a length from " + number_text(-scene.flexspline.wall / 2) + " to " +
                   number_text(scene.flexspline.wall / 2));
    }
    auto const dedendum = scene.flexspline_dedendum();
    if (!dedendum || !knows(reading, {"flexspline.wall", "drive.module", "drive.flexspline_teeth"}))
        return;
    double const hole = flexspline_pitch_radius(scene.drive) - *dedendum - scene.flexspline.wall;
    if (!knows(reading, {"flexspline.inner_radius"}) && hole <= 0)
        add_at(faults, "flexspline.wall", number_text(scene.flexspline.wall),
               "leaves no hole: the pitch radius is " + short_number(flexspline_pitch_radius(scene.drive)) + " mm",
               "write a thinner wall, or check module and flexspline_teeth");
}

void check_inner_radius(SceneReading const& reading, Faults& faults)
{
    auto const& scene = reading.scene;
    auto const dedendum = scene.flexspline_dedendum();
    if (!dedendum ||
        !knows(reading, {"flexspline.inner_radius", "flexspline.wall", "drive.module", "drive.flexspline_teeth"}))
        return;
    double const expected = flexspline_pitch_radius(scene.drive) - *dedendum - scene.flexspline.wall;
    // off by the whole wall: a typing error
    if (std::abs(*scene.flexspline.inner_radius - expected) > scene.flexspline.wall)
        add_at(faults, "flexspline.inner_radius", number_text(*scene.flexspline.inner_radius),
               "contradicts module and teeth, which make it about " + short_number(expected) + " mm",
               "write about that radius, or remove the key");
}

void check_deformation(SceneReading const& reading, Faults& faults)
{
    auto const& scene = reading.scene;
    auto const w0 = scene.wave_generator.shape.number("radial_deformation");
    if (!w0 || !knows(reading, {"drive.module", "drive.flexspline_teeth", "wave_generator.waves"}))
        return;
    // rho = r_0 + w0 cos(n u) has a hollow where w0 (n^2 + 1) > r_0.
    double const waves = scene.wave_generator.waves;
    double const largest = flexspline_pitch_radius(scene.drive) / (waves * waves + 1);
    if (*w0 < largest)
        return;
    Advice const usual = drive_advice(scene);
    add_at(faults, "wave_generator.radial_deformation", number_text(*w0),
           "the neutral curve would be hollow between the waves",
           "write less than " + at_most_text(largest) + (usual.words.empty() ? "" : "; usual is " + usual.words));
    faults.back().set = usual.set;
}

void check_clearance(SceneReading const& reading, std::string const& key, double clearance, Faults& faults)
{
    std::string const path = "circular_spline." + key;
    if (knows(reading, {path, "drive.module"}) && clearance > reading.scene.drive.module)
        add_at(faults, path, number_text(clearance), "a clearance above one module leaves no tooth",
               "write a length from 0 to a small part of the module " + number_text(reading.scene.drive.module));
}

/// With the circular spline's tooth given, its space is as deep as that tooth says.
void check_reverse(SceneReading const& reading, Faults& faults)
{
    auto const& scene = reading.scene;
    if (scene.is_reverse() && knows(reading, {"circular_spline.root_clearance"}) &&
        scene.circular_spline.root_clearance > 0) {
        add_at(faults, "circular_spline.root_clearance", number_text(scene.circular_spline.root_clearance),
               "the depth of the circular spline's tooth space is told by its given tooth",
               "write " + with_height(*scene.circular_spline.profile, "larger", "dedendum") +
                   " (or flexspline.dedendum for the other member) and remove this key");
    }
}

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

void add_pair_faults(SceneReading const& reading, Faults& faults)
{
    check_teeth(reading, faults);
    check_tolerance(reading, faults);
    check_wall(reading, faults);
    check_inner_radius(reading, faults);
    check_deformation(reading, faults);
    check_clearance(reading, "backlash_offset", reading.scene.circular_spline.backlash_offset, faults);
    check_clearance(reading, "root_clearance", reading.scene.circular_spline.root_clearance, faults);
    check_reverse(reading, faults);
}

void add_wanted_faults(SceneReading const& reading, Faults& faults)
{
    if (!reading.scene.wants_neutral_curve())
        return;
    check_seat(reading, faults);
    check_effects(reading, faults);
    check_values(reading, faults);
}

}  // namespace hdconj::scene
