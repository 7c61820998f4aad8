// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "base/text.hpp"
#include "checks.hpp"
#include "hdconj/units.hpp"
#include "limits.hpp"

namespace hdconj::judgement {
namespace {

/// The key of the largest eccentricity, else the table of the errors, else the side clearance.
std::string likely_place(Scene const& scene)
{
    if (!scene.errors)
        return "circular_spline.backlash_offset";
    std::string place = "errors";
    double largest = 0;
    auto const look = [&](char const* table, auto const& member) {
        if (member && member->eccentricity > largest) {
            largest = member->eccentricity;
            place = std::string("errors.") + table + ".eccentricity";
        }
    };
    look("flexspline", scene.errors->flexspline);
    look("circular_spline", scene.errors->circular_spline);
    look("wave_generator", scene.errors->wave_generator);
    return place;
}

}  // namespace

std::optional<Note> backlash(Scene const& scene, double turn, double side_clearance, std::string const& where)
{
    constexpr double touches = 1e-3;  // of the module: what first contacts are known to
    double const radius = scene.drive.module * scene.drive.circular_spline_teeth / 2;
    if (-turn * radius <= touches * scene.drive.module)
        return std::nullopt;
    auto note = note_on(NoteCode::backlash, per_arcmin * turn);
    if (!note)
        return note;
    note->place = likely_place(scene);
    note->cause = "without torque teeth press on both flanks" + where + ": the backlash is " +
                  short_number(note->figure, 3) + " arcmin" +
                  (scene.errors ? ", since the errors take more than the side clearance gives" : "");
    // both flanks give way by it, along their normals
    double const more = -turn * radius / 2;
    std::string const enough = length_at_least(side_clearance + more);
    note->advice = "write circular_spline.backlash_offset = " + enough + (scene.errors ? ", or smaller errors" : "");
    note->set = {"circular_spline.backlash_offset=" + enough};
    return note;
}

std::optional<Note> tip_interference(double turn, double depth, double least_tip)
{
    auto note = note_on(NoteCode::backlash, per_arcmin * turn);
    if (!note)
        return note;
    note->place = "circular_spline.inner_radius";
    note->cause = "without torque tips interfere by " + short_number(depth * per_um, 3) +
                  " um along the radius, and no turn brings them apart";
    std::string const enough = length_at_least(least_tip);
    note->advice = "write circular_spline.inner_radius = " + enough;
    note->set = {"circular_spline.inner_radius=" + enough};
    return note;
}

}  // namespace hdconj::judgement
