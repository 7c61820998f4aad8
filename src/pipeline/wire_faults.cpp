// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <numbers>
#include <utility>

#include "hdconj/pipeline/wedm.hpp"
#include "hdconj/profile/builder.hpp"
#include "hdconj/scene/reading.hpp"
#include "hdconj/scene/schema.hpp"
#include "wire_job.hpp"

namespace hdconj {
namespace {

using namespace detail;

double pitch_radius(Scene const& scene)
{
    return scene.drive.module * wire_teeth(scene) / 2;
}

void check_wire(Scene const& scene, Faults& faults)
{
    WireRequest const& wedm = *scene.wedm;
    double const width = wedm.wire_diameter + 2 * wedm.spark_gap;
    double const pitch = std::numbers::pi * scene.drive.module;
    if (width >= pitch)
        faults.push_back(fault_at("wedm.wire_diameter", "wire and gap cut a slot of " + short_number(width) + " mm, and a whole pitch of the teeth is " + short_number(pitch) + " mm",
                                  "write a wire that fits into a tooth space, far thinner than half a pitch"));
    if (!wedm.stock.empty() && wedm.stock.front() > scene.drive.module)
        faults.push_back(fault_at("wedm.passes", "a stock of " + short_number(wedm.stock.front()) + " mm is more than one module and leaves no tooth space",
                                  "write a small part of the module " + short_number(scene.drive.module)));
    if (wedm.tolerance < 10 * scene.solver.tolerance)
        faults.push_back(fault_at("wedm.tolerance", "the outline itself is known to " + short_number(scene.solver.tolerance) + " mm only (solver.tolerance)",
                                  "write at least " + short_number(10 * scene.solver.tolerance) + ", or a smaller solver.tolerance"));
    if (wedm.tolerance > scene.drive.module / 10)
        faults.push_back(fault_at("wedm.tolerance", "above a tenth of the module says nothing about a tooth",
                                  "write at most " + short_number(scene.drive.module / 10) + ", such as 0.0005"));
}

void check_workpiece(Scene const& scene, Faults& faults)
{
    WireRequest const& wedm = *scene.wedm;
    double const width = scene.circular_spline.width.value_or(0);
    if (thickness_of(scene) <= 0)
        faults.push_back({"wedm.thickness", wedm.line, "", "this key is missing, and circular_spline.width does not tell it either",
                          "write thickness = 7.0, a length in mm"});
    if (cuts_flexspline(scene))
        return;
    if (wedm.thickness && *wedm.thickness < width)
        faults.push_back(fault_at("wedm.thickness", "the toothing is wider: circular_spline.width = " + short_number(width) + " mm",
                                  "write at least that width, or remove the key"));
    if (follows_cone(scene) && thickness_of(scene) / 2 >= scene.coning->bottom_to_middle.value_or(0) - scene.coning->apex_height)
        faults.push_back(fault_at(wedm.thickness ? "wedm.thickness" : "circular_spline.width", "the workpiece would reach behind the apex of the cone",
                                  "write a smaller thickness"));
    if (scene.is_reverse())
        faults.push_back(fault_at("circular_spline.profile", "the wire cuts the circular spline that is solved for, but its tooth is given",
                                  "write --part flexspline, or give [flexspline.profile] in place of [circular_spline.profile]"));
}

/// The flexspline is cut as it is made: round, upright, unloaded.
void check_flexspline(Scene const& scene, Faults& faults)
{
    if (tilt_of(scene) != 0)
        faults.push_back(fault_at("tilt.angle_deg", "the flexspline's teeth are parallel to its axis; only the circular spline's are tilted", "write --tilt 0"));
}

void check_set_up(Scene const& scene, Faults& faults)
{
    WireRequest const& wedm = *scene.wedm;
    double const radius = pitch_radius(scene);
    bool const outside = cuts_flexspline(scene);
    double const around = std::numbers::pi * radius * (outside ? 0.5 : 1);
    if (!outside && wedm.lead_in > radius)
        faults.push_back(fault_at("wedm.lead_in", "the lead-in would begin beyond the middle of the bore", "write at most " + short_number(radius) + ", such as 3.0"));
    if (wedm.start >= wire_teeth(scene))
        faults.push_back(fault_at("wedm.start", "there are " + std::to_string(wire_teeth(scene)) + " tooth spaces, counted from 0",
                                  "write a whole number from 0 to " + std::to_string(wire_teeth(scene) - 1)));
    for (auto const& [path, length] : {std::pair("wedm.overlap", wedm.overlap), std::pair("wedm.stop_before", wedm.stop_before)})
        if (length > around)
            faults.push_back(fault_at(path, outside ? "is more than half of what a set-up cuts" : "is more than half the way around the part", "write a few mm at most"));
    if (!outside && std::abs(tilt_of(scene)) > wedm.largest_tilt)
        faults.push_back(fault_at("tilt.angle_deg", "the machine tilts its wire by " + short_number(wedm.largest_tilt / rad_per_deg) + " degrees at most (wedm.largest_tilt_deg)",
                                  "write a smaller angle, or the limit of a machine that can"));
}

}  // namespace

Faults check_wedm(Scene const& scene)
{
    Faults faults;
    if (!scene.wedm)
        return {{"wedm", 0, "", "this table is missing: it states wire and gap, which are never assumed", "write the line [wedm] and below it wire_diameter = 0.10 and spark_gap = 0.006"}};
    check_wire(scene, faults);
    check_workpiece(scene, faults);
    check_set_up(scene, faults);
    if (cuts_flexspline(scene))
        check_flexspline(scene, faults);
    locate(faults, scene);
    return faults;
}

}  // namespace hdconj
