// SPDX-License-Identifier: GPL-3.0-or-later
#include "wire_job.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "hdconj/scene/reading.hpp"
#include "hdconj/units.hpp"
#include "scene/tolerance_limits.hpp"
#include "scene/usual_wire.hpp"

namespace hdconj::wedm {
namespace {

/// Fewest slices that have one between the faces.
constexpr int with_middle = 3;

/// A fault of a key without its line and value, which scene::locate() finds.
Fault fault_at(std::string path, std::string reason, std::string remedy)
{
    return {std::move(path), 0, "", std::move(reason), std::move(remedy)};
}

void add_fault(Faults& faults, std::string path, std::string reason, std::string remedy)
{
    faults.push_back(fault_at(std::move(path), std::move(reason), std::move(remedy)));
}

/// Teeth of the part.
int wire_teeth(Scene const& scene)
{
    return cuts_flexspline(scene) ? scene.drive.flexspline_teeth : scene.drive.circular_spline_teeth;
}

/// Face width of the circular spline, or of the workpiece where none is stated [mm].
double toothed_width(Scene const& scene)
{
    return scene.circular_spline.width.value_or(thickness_of(scene));
}

/// Tilt of the part's teeth [rad].
double tilt_of(Scene const& scene)
{
    return scene.tilt ? scene.tilt->angle : 0;
}

/// Whether the slices of the circular spline have outlines of their own.
bool follows_cone(Scene const& scene)
{
    return scene.coning && scene.slices && scene.slices->count > 1 && scene.slices->surface != ToothSurface::tilted;
}

/// Whether the two faces of the part differ.
bool faces_differ(Scene const& scene)
{
    return tilt_of(scene) != 0 || follows_cone(scene);
}

/// Error of the contours on the faces of the workpiece [mm]: that of the outlines, and of rulings that go on beyond the
/// toothing more.
double contour_error_of(Scene const& scene)
{
    double const beyond = thickness_of(scene) / toothed_width(scene);
    return scene.solver.tolerance * (faces_differ(scene) && !cuts_flexspline(scene) ? std::max(1.0, beyond) : 1);
}

/// What the wire leaves is known to the tolerance and the error of the contour (WireJob::residual_error).
void check_residual_limit(Scene const& scene, Faults& faults)
{
    double const limit = scene.wedm->residual_limit;
    double const contour = contour_error_of(scene);
    double const known = scene.wedm->tolerance + contour;
    if (known <= limit)
        return;
    constexpr double enough = 1.01;  // beyond the digits that are printed
    bool const finer = limit / 2 >= 10 * contour;
    add_fault(faults, "wedm.tolerance",
              fmt::format("what the wire leaves is known to {:.6g} mm only, and wedm.residual_limit is {:.6g} mm",
                          known, limit),
              fmt::format("write {}wedm.residual_limit = {:.3g}",
                          finer ? fmt::format("at most wedm.tolerance = {:.3g}, or ", limit / 2) : "", enough * known));
}

void check_wire(Scene const& scene, Faults& faults)
{
    WireRequest const& wire = *scene.wedm;
    double const module = scene.drive.module, known = scene.solver.tolerance;
    double const width = wire.wire_diameter + 2 * wire.spark_gap;
    double const pitch = std::numbers::pi * module;
    if (width >= pitch)
        add_fault(faults, "wedm.wire_diameter",
                  fmt::format("wire and gap cut a slot of {:.6g} mm, and a whole pitch of the teeth is {:.6g} mm",
                              width, pitch),
                  "write a wire that fits into a tooth space, far thinner than half a pitch");
    if (!wire.stock.empty() && wire.stock.front() > module)
        add_fault(
            faults, "wedm.passes",
            fmt::format("a stock of {:.6g} mm is more than one module and leaves no tooth space", wire.stock.front()),
            fmt::format("write a small part of the module {:.6g}", module));
    if (wire.tolerance < 10 * known)
        add_fault(faults, "wedm.tolerance",
                  fmt::format("the outline itself is known to {:.6g} mm only (solver.tolerance)", known),
                  fmt::format("write at least {:.6g}, or a smaller solver.tolerance", 10 * known));
    if (wire.tolerance > scene::tenth_of_module(scene.drive))
        add_fault(faults, "wedm.tolerance", "is above a tenth of the module, too coarse for a tooth",
                  fmt::format("write at most {:.6g}, such as 0.0005", module / 10));
    else
        check_residual_limit(scene, faults);
}

void check_workpiece(Scene const& scene, Faults& faults)
{
    WireRequest const& wire = *scene.wedm;
    double const width = scene.circular_spline.width.value_or(0);
    if (thickness_of(scene) <= 0)
        faults.push_back({"wedm.thickness", wire.line, "",
                          "this key is missing, and circular_spline.width does not tell it either",
                          "write thickness = 7.0, a length in mm"});
    if (cuts_flexspline(scene))
        return;
    if (wire.thickness && *wire.thickness < width)
        add_fault(faults, "wedm.thickness",
                  fmt::format("the toothing is wider: circular_spline.width = {:.6g} mm", width),
                  "write at least that width, or remove the key");
    if (follows_cone(scene) &&
        thickness_of(scene) / 2 >= scene.coning->bottom_to_middle.value_or(0) - scene.coning->apex_height)
        add_fault(faults, wire.thickness ? "wedm.thickness" : "circular_spline.width",
                  "the workpiece would reach behind the apex of the cone", "write a smaller thickness");
    if (scene.is_reverse())
        add_fault(faults, "circular_spline.profile",
                  "the wire cuts the circular spline that is solved for, but its tooth is given",
                  "write --part flexspline, or give [flexspline.profile] in place of [circular_spline.profile]");
}

/// The path around the part.
void check_path(Scene const& scene, Faults& faults)
{
    WireRequest const& wire = *scene.wedm;
    int const teeth = wire_teeth(scene);
    double const radius = scene.drive.module * teeth / 2;
    bool const outside = cuts_flexspline(scene);
    double const around = std::numbers::pi * radius * (outside ? 0.5 : 1);
    double const tips = scene.circular_spline.inner_radius.value_or(radius);
    if (!outside && wire.lead_in > tips)
        add_fault(faults, "wedm.lead_in", "the lead-in would begin beyond the middle of the bore",
                  fmt::format("write at most {:.6g}, such as 3.0", tips));
    if (wire.start >= teeth)
        add_fault(faults, "wedm.start", fmt::format("there are {} tooth spaces, counted from 0", teeth),
                  fmt::format("write a whole number from 0 to {}", teeth - 1));
    for (auto const& [path, length] :
         {std::pair("wedm.overlap", wire.overlap), std::pair("wedm.stop_before", wire.stop_before)})
        if (length > around)
            add_fault(faults, path,
                      outside ? "is more than half of what a set-up cuts" : "is more than half the way around the part",
                      "write a few mm at most");
}

/// The circular spline may be tilted as far as the machine tilts its wire; the flexspline is cut upright and unloaded.
void check_tilt(Scene const& scene, Faults& faults)
{
    double const tilt = tilt_of(scene), largest = scene.wedm->largest_tilt;
    if (cuts_flexspline(scene)) {
        if (tilt != 0)
            add_fault(faults, "tilt.angle_deg",
                      "the flexspline's teeth are parallel to its axis; only the circular spline's are tilted",
                      "write --tilt 0");
    } else if (std::abs(tilt) > largest)
        add_fault(
            faults, "tilt.angle_deg",
            fmt::format("the machine tilts its wire by {:.6g} degrees at most (wedm.largest_tilt_deg)", largest / deg),
            "write a smaller angle, or the limit of a machine that can");
}

std::string in_ascii(std::string name)
{
    std::replace_if(
        name.begin(), name.end(), [](char c) { return c < ' ' || c > '~'; }, '_');
    return name;
}

}  // namespace

WireJob::WireJob(Scene const& scene, WireFaces part_faces) : faces(std::move(part_faces)), wire(*scene.wedm)
{
    name = in_ascii(scene.drive.name) + (faces.external ? "-flexspline" : "");
    if (wire.stock.empty())
        wire.stock = {0};
    machine = {thickness_of(scene), wire.lower_guide, wire.upper_guide};
    contour_error = contour_error_of(scene);
    if (faces.pitch.lower != faces.pitch.upper) {
        surface = scene.slices ? scene.slices->surface : ToothSurface::tilted;
        if (tilt_of(scene) != 0)
            tilt_kind = scene.tilt->kind;
    }
    Faults keys{fault_at("wedm.wire_diameter", "", "")};
    scene::locate(keys, scene);
    wire_key = keys.front();
}

double thickness_of(Scene const& scene)
{
    bool const of_cup = cuts_flexspline(scene) && scene.flexspline.cup;
    double const width = of_cup ? scene.flexspline.cup->tooth_width : scene.circular_spline.width.value_or(0);
    return scene.wedm->thickness.value_or(width);
}

void refuse_wire_faults(Scene const& scene)
{
    if (Faults const faults = scene::value_faults(scene); !faults.empty())
        throw InputError(faults);
    if (Faults faults = check_wedm(scene); !faults.empty())
        throw InputError(faults);
}

bool cuts_flexspline(Scene const& scene)
{
    return scene.wedm->part == WirePart::flexspline;
}

bool has_straight_rulings(Scene const& scene)
{
    bool const leans = tilt_of(scene) != 0;
    // of different outlines a ruled surface alone is straight, and a tilt moves them along other radii
    return follows_cone(scene) ? scene.slices->surface == ToothSurface::ruled && !leans
                               : !leans || scene.tilt->kind == TiltKind::radial;
}

void check_slices(Scene const& scene, CircularSplineOutline const& outline)
{
    double const half = toothed_width(scene) / 2, tolerance = scene.solver.tolerance;
    bool const single = outline.outline.size() == 1 && !faces_differ(scene);
    bool const ends = outline.z.size() > 1 && outline.z.size() == outline.outline.size() &&
                      std::abs(outline.z.front() + half) <= tolerance && std::abs(outline.z.back() - half) <= tolerance;
    if (!single && !ends)
        throw InputError(
            fault_at("circular_spline.width",
                     fmt::format("the outline that was solved has no slices at z = -{0:.6g} and +{0:.6g} mm", half),
                     "solve it with [slices] over that width, or let wedm solve it"));
}

}  // namespace hdconj::wedm

namespace hdconj {

Faults check_wedm(Scene const& scene)
{
    Faults faults;
    if (!scene.wedm)
        return {{"wedm", 0, "", "this table is missing: it states wire and gap, which are never assumed",
                 fmt::format("write the line [wedm] and below it wire_diameter = {} and spark_gap = {}",
                             scene::usual_wire, scene::usual_spark_gap)}};
    wedm::check_wire(scene, faults);
    wedm::check_workpiece(scene, faults);
    wedm::check_path(scene, faults);
    wedm::check_tilt(scene, faults);
    scene::locate(faults, scene);
    return faults;
}

std::string missing_side_clearance(Scene const& scene)
{
    CircularSpline const& spline = scene.circular_spline;
    bool const leans = wedm::tilt_of(scene) != 0, cones = scene.coning && !wedm::follows_cone(scene);
    if (wedm::cuts_flexspline(scene) || spline.automatic_backlash || spline.backlash_offset > 0 || !(leans || cones))
        return {};
    return fmt::format(
        "circular_spline.backlash_offset = 0: {}, so that teeth beside z = 0 enter the flanks; wedm does not compute "
        "how deep: write circular_spline.backlash_offset = \"auto\" in a scene with [slices], or what `hdconj contact` "
        "names",
        leans ? "the teeth of the ring are tilted" : "the cup cones and one outline is cut for all sections");
}

Scene wire_scene(Scene const& scene)
{
    Scene wanted = scene;
    wanted.contact.reset();
    wanted.circular_spline.width = wedm::toothed_width(scene);
    bool const automatic = scene.circular_spline.automatic_backlash;
    if (!wedm::faces_differ(scene)) {
        // An automatic side clearance looks at the slices.
        if (!automatic)
            wanted.slices.reset();
        return wanted;
    }
    if (!wanted.slices)
        wanted.slices = Slices{wedm::with_middle, ToothSurface::tilted, 0};
    bool const keeps = wanted.slices->surface == ToothSurface::per_slice || automatic;
    wanted.slices->count = keeps ? std::max(wedm::with_middle, wanted.slices->count) : wedm::with_middle;
    return wanted;
}

}  // namespace hdconj
