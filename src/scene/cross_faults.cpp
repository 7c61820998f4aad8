// SPDX-License-Identifier: GPL-3.0-or-later
// What must hold between values. The geometry of tooth and neutral curve is checked where it is built.
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <optional>

#include "hdconj/scene/reading.hpp"
#include "text.hpp"

namespace hdconj {
namespace {

using detail::in_quotes;
using detail::number_text;

/// Tolerances below this many roundings of the radius cannot be reached in double precision.
constexpr double roundings_of_radius = 100;

/// An inner radius further than this share from the one that module and teeth give is a typing error.
constexpr double radius_doubt = 0.25;

/// Points between bearing and cup: their influences fill a matrix of some hundred megabytes.
constexpr int most_contact_points = 4000;

bool knows(SceneReading const& reading, std::initializer_list<std::string_view> paths)
{
    return std::all_of(paths.begin(), paths.end(),
                       [&reading](std::string_view path) { return reading.known.contains(path); });
}

Fault fault_at(std::string path, std::string value, std::string reason, std::string remedy)
{
    return {std::move(path), 0, std::move(value), std::move(reason), std::move(remedy)};
}

double pitch_radius(Scene const& scene)
{
    return scene.drive.module * scene.drive.flexspline_teeth / 2;
}

void check_teeth(SceneReading const& reading, Faults& faults)
{
    if (!knows(reading, {"drive.flexspline_teeth", "drive.circular_spline_teeth", "wave_generator.waves"})) {
        return;
    }
    auto const& drive = reading.scene.drive;
    int const waves = reading.scene.wave_generator.waves;
    int const more = drive.circular_spline_teeth - drive.flexspline_teeth;
    bool const meets = more > 0 && more % waves == 0;
    if (meets && more / waves > bounds::most_pitches_per_lobe) {
        faults.push_back(fault_at("drive.circular_spline_teeth", std::to_string(drive.circular_spline_teeth),
                                  "each wave would move the flexspline by " + std::to_string(more / waves) +
                                      " teeth of the circular spline, and more than " +
                                      std::to_string(bounds::most_pitches_per_lobe) + " are not computed",
                                  "write " + std::to_string(drive.flexspline_teeth + waves) +
                                      ", flexspline_teeth plus waves, or another small multiple of waves more"));
    }
    if (meets) {
        return;
    }
    int const right = drive.flexspline_teeth + std::max(1, (more + waves / 2) / waves) * waves;
    faults.push_back(fault_at("drive.circular_spline_teeth", std::to_string(drive.circular_spline_teeth),
                              "must be flexspline_teeth = " + std::to_string(drive.flexspline_teeth) +
                                  " plus a positive multiple of waves = " + std::to_string(waves) +
                                  ", or the teeth do not meet at every wave",
                              "write " + std::to_string(right)));
}

void check_tolerance(SceneReading const& reading, Faults& faults)
{
    if (!knows(reading, {"solver.tolerance", "drive.module"})) {
        return;
    }
    double const tolerance = reading.scene.solver.tolerance;
    double const largest = reading.scene.drive.module / 10;
    if (tolerance > largest) {
        faults.push_back(fault_at("solver.tolerance", number_text(tolerance),
                                  "above a tenth of the module says nothing about a tooth",
                                  "write at most " + number_text(largest) + ", such as 1e-6"));
    }
    if (!knows(reading, {"drive.flexspline_teeth"})) {
        return;
    }
    double const least = roundings_of_radius * std::numeric_limits<double>::epsilon() * pitch_radius(reading.scene);
    if (tolerance < least) {
        faults.push_back(fault_at(
            "solver.tolerance", number_text(tolerance),
            "cannot be reached in double precision on a radius of " + number_text(pitch_radius(reading.scene)) + " mm",
            "write at least " + number_text(least)));
    }
}

void check_wall(SceneReading const& reading, Faults& faults)
{
    auto const& scene = reading.scene;
    if (knows(reading, {"flexspline.wall", "flexspline.neutral_offset"}) &&
        std::abs(scene.flexspline.neutral_offset) > scene.flexspline.wall / 2) {
        faults.push_back(fault_at("flexspline.neutral_offset", number_text(scene.flexspline.neutral_offset),
                                  "the neutral layer would lie outside the wall",
                                  "write a length from " + number_text(-scene.flexspline.wall / 2) + " to " +
                                      number_text(scene.flexspline.wall / 2)));
    }
    auto const dedendum = scene.flexspline_dedendum();
    if (!dedendum || !knows(reading, {"flexspline.wall", "drive.module", "drive.flexspline_teeth"})) {
        return;
    }
    double const hole = pitch_radius(scene) - *dedendum - scene.flexspline.wall;
    if (!knows(reading, {"flexspline.inner_radius"}) && hole <= 0) {
        faults.push_back(fault_at("flexspline.wall", number_text(scene.flexspline.wall),
                                  "leaves no hole: the pitch radius is " + number_text(pitch_radius(scene)) + " mm",
                                  "write a thinner wall, or check module and flexspline_teeth"));
    }
}

void check_inner_radius(SceneReading const& reading, Faults& faults)
{
    auto const& scene = reading.scene;
    auto const dedendum = scene.flexspline_dedendum();
    if (!dedendum ||
        !knows(reading, {"flexspline.inner_radius", "flexspline.wall", "drive.module", "drive.flexspline_teeth"})) {
        return;
    }
    double const expected = pitch_radius(scene) - *dedendum - scene.flexspline.wall;
    if (std::abs(*scene.flexspline.inner_radius - expected) > radius_doubt * pitch_radius(scene)) {
        faults.push_back(fault_at("flexspline.inner_radius", number_text(*scene.flexspline.inner_radius),
                                  "contradicts module and teeth, which make it about " + number_text(expected) + " mm",
                                  "write a radius near that, or remove the key"));
    }
}

void check_deformation(SceneReading const& reading, Faults& faults)
{
    auto const& scene = reading.scene;
    auto const w0 = scene.wave_generator.shape.number("radial_deformation");
    if (!w0 || !knows(reading, {"drive.module", "drive.flexspline_teeth", "wave_generator.waves"})) {
        return;
    }
    // rho = r_0 + w0 cos(n u) has a hollow where w0 (n^2 + 1) > r_0.
    double const waves = scene.wave_generator.waves;
    double const largest = pitch_radius(scene) / (waves * waves + 1);
    if (*w0 >= largest) {
        faults.push_back(fault_at("wave_generator.radial_deformation", number_text(*w0),
                                  "the neutral curve would be hollow between the waves",
                                  "write less than " + number_text(largest) + ", usually about one module"));
    }
}

void check_clearance(SceneReading const& reading, std::string const& key, double clearance, Faults& faults)
{
    std::string const path = "circular_spline." + key;
    if (knows(reading, {path, "drive.module"}) && clearance > reading.scene.drive.module) {
        faults.push_back(
            fault_at(path, number_text(clearance), "a clearance above one module leaves no tooth",
                     "write a length from 0 to a small part of the module " + number_text(reading.scene.drive.module)));
    }
}

/// With the circular spline's tooth given, its space is as deep as that tooth says.
void check_reverse(SceneReading const& reading, Faults& faults)
{
    auto const& scene = reading.scene;
    if (scene.is_reverse() && knows(reading, {"circular_spline.root_clearance"}) && scene.circular_spline.root_clearance > 0) {
        faults.push_back(fault_at("circular_spline.root_clearance", number_text(scene.circular_spline.root_clearance),
                                  "the depth of the circular spline's tooth space is told by its given tooth",
                                  "write a larger circular_spline.profile.dedendum (or flexspline.dedendum for the other "
                                  "member) and remove this key"));
    }
}

/// Keys of the cup that say the same thing twice, or belong to one that is not there.
void check_cup(SceneReading const& reading, Faults& faults)
{
    auto const& given = reading.scene.given;
    for (std::string const side : {"rear", "front"}) {
        std::string const key = "flexspline.cup." + side;
        if (given.contains(key + "_ramp") && given.contains(key + "_fillet")) {
            faults.push_back(fault_at(key + "_fillet", "", "an arc takes the place of the ramp, and is as long as its radius says", "remove one of " + side + "_ramp and " + side + "_fillet"));
        }
    }
    if (given.contains("flexspline.cup.tooth_share") && !given.contains("flexspline.cup.tooth_layer")) {
        faults.push_back(fault_at("flexspline.cup.tooth_share", "", "there is no layer of teeth", "write tooth_layer = 0.53, the height of the teeth in mm, or remove the key"));
    }
}

/// What the elastic cup cannot do without, and what is not for it. What the dimensions say to each other: pipeline/check_scene.cpp.
void check_elastic(SceneReading const& reading, Faults& faults)
{
    auto const& scene = reading.scene;
    int const line = scene.coning->line;
    if (!scene.flexspline.cup && !scene.given.contains("flexspline.cup")) {
        faults.push_back({"flexspline.cup", line, "", "this table is missing: model \"elastic\" needs the cup's dimensions",
                          "write the line [flexspline.cup] and below it length = 15.0, barrel_wall = 0.4, bottom = 0.5, corner_radius = 2.0, "
                          "flange_radius = 13.0, tooth_width = 8.0, front_land = 2.0",
                          line > 0 ? "" : "--set"});
    }
    if (!scene.bearing && !scene.given.contains("bearing")) {
        faults.push_back({"bearing", line, "", "this table is missing: model \"elastic\" needs what pushes the cup outward",
                          "write the line [bearing] and below it type = \"elastic\", width = 6.0, ring_thickness = 1.2", line > 0 ? "" : "--set"});
    }
    if (scene.given.contains("coning.apex_height")) {
        faults.push_back(fault_at("coning.apex_height", number_text(scene.coning->apex_height), "the elastic cup tells where its apex is",
                                  "remove the key, or write model = \"linear\""));
    }
}

void check_bearing(SceneReading const& reading, Faults& faults)
{
    auto const& scene = reading.scene;
    if (!scene.bearing || !knows(reading, {"bearing.type"})) {
        return;
    }
    BearingChoice const& bearing = *scene.bearing;
    auto const refuse = [&](std::string const& key, std::string const& reason, std::string const& remedy) {
        faults.push_back(fault_at("bearing." + key, "", reason, remedy));
    };
    if (bearing.elastic && !scene.given.contains("bearing.ring_thickness")) {
        faults.push_back({"bearing.ring_thickness", bearing.line, "", "this key is missing: an outer ring that bends has a thickness",
                          "write ring_thickness = 1.2, a length in mm, or type = \"rigid\""});
    }
    if (bearing.elastic && knows(reading, {"bearing.width"}) && bearing.width <= 0) {
        refuse("width", "an outer ring that bends has a width above 0", "write width = 6.0, or type = \"rigid\"");
    }
    for (std::string const key : {"ring_thickness", "radial_stiffness", "axially", "balls", "ball_phase_deg"}) {
        if (!bearing.elastic && scene.given.contains("bearing." + key)) {
            refuse(key, "type \"rigid\" has no outer ring and no balls", "remove the key, or write type = \"elastic\"");
        }
    }
    if (bearing.balls && *bearing.balls < 2) {
        refuse("balls", "one ball leaves the ring free to move across it", "write as many as the bearing has, such as 23, or leave the key out for a line of balls");
    }
    if (!bearing.balls && scene.given.contains("bearing.ball_phase_deg")) {
        refuse("ball_phase_deg", "a line of balls looks the same from every angle", "write balls = 23 too, or remove the key");
    }
    if (knows(reading, {"bearing.angles"}) && bearing.angles % 2 != 0) {
        refuse("angles", "is odd", "write an even number such as 48");
    }
    if (knows(reading, {"bearing.angles", "bearing.circles"}) && bearing.angles * bearing.circles > most_contact_points) {
        refuse("angles", "with " + std::to_string(bearing.circles) + " circles makes " + std::to_string(bearing.angles * bearing.circles) + " points of contact, each with each",
               "write at most " + std::to_string(most_contact_points) + " points, such as angles = 96 and circles = 17");
    }
}

void check_coning(SceneReading const& reading, Faults& faults)
{
    auto const& scene = reading.scene;
    if (!scene.coning || !knows(reading, {"coning.model"})) {
        return;
    }
    if (!scene.given.contains("coning.bottom_to_middle")) {
        faults.push_back({"coning.bottom_to_middle", scene.coning->line, "",
                          "this key is missing: model " + in_quotes(scene.coning->model) + " needs the distance from the cup's bottom",
                          "write bottom_to_middle = 9.0, a length in mm"});
    }
    if (scene.is_elastic()) {
        check_elastic(reading, faults);
    }
    if (knows(reading, {"coning.bottom_to_middle"}) && scene.coning->apex_height >= *scene.coning->bottom_to_middle) {
        faults.push_back(fault_at("coning.apex_height", number_text(scene.coning->apex_height),
                                  "the apex must lie behind the middle of the bearing, which is " + number_text(*scene.coning->bottom_to_middle) +
                                      " mm above the cup's bottom",
                                  "write a smaller height, such as 0"));
        return;
    }
    bool const both = knows(reading, {"coning.bottom_to_middle", "circular_spline.width"}) && scene.circular_spline.width;
    double const to_apex = both ? *scene.coning->bottom_to_middle - scene.coning->apex_height : 0;
    if (both && *scene.circular_spline.width / 2 >= to_apex && *scene.circular_spline.width / 2 < *scene.coning->bottom_to_middle) {
        faults.push_back(fault_at("coning.apex_height", number_text(scene.coning->apex_height),
                                  "the teeth would reach behind the apex: half the width is " + number_text(*scene.circular_spline.width / 2) + " mm",
                                  "write a smaller height or a smaller circular_spline.width"));
    }
    if (both && *scene.circular_spline.width / 2 >= *scene.coning->bottom_to_middle) {
        faults.push_back(fault_at("coning.bottom_to_middle", number_text(*scene.coning->bottom_to_middle),
                                  "the teeth would reach through the cup's bottom: half the width is " +
                                      number_text(*scene.circular_spline.width / 2) + " mm",
                                  "write a longer cup or a smaller circular_spline.width"));
    }
}

void check_tilt(SceneReading const& reading, Faults& faults)
{
    auto const& scene = reading.scene;
    if (!scene.tilt) {
        return;
    }
    bool const too_steep = std::abs(scene.tilt->angle) >= bounds::largest_tilt_deg * rad_per_deg;
    if (too_steep && knows(reading, {"tilt.angle_deg"})) {
        faults.push_back(
            fault_at("tilt.angle_deg", number_text(scene.tilt->angle / rad_per_deg),
                     "teeth are not tilted by " + number_text(bounds::largest_tilt_deg) + " degrees or more",
                     "write an angle in degrees between -45 and 45, such as angle_deg = 0.2"));
    }
    bool const both = scene.slices && knows(reading, {"tilt.kind", "slices.surface"});
    if (both && scene.tilt->kind == "draft" && scene.slices->surface != "tilted") {
        faults.push_back(fault_at("tilt.kind", "\"draft\"",
                                  "a draft needs one outline to offset, but surface " +
                                      in_quotes(scene.slices->surface) + " has an outline for each slice",
                                  "write kind = \"radial\", or surface = \"tilted\" in [slices]"));
    }
    bool const upright = scene.slices && scene.circular_spline.width && knows(reading, {"tilt.angle_deg", "circular_spline.inner_radius"});
    double const rise = upright ? *scene.circular_spline.width / 2 * std::tan(std::abs(scene.tilt->angle)) : 0;
    if (upright && !too_steep && scene.circular_spline.inner_radius && rise >= *scene.circular_spline.inner_radius) {
        faults.push_back(fault_at("tilt.angle_deg", number_text(scene.tilt->angle / rad_per_deg),
                                  "over half the width of " + number_text(*scene.circular_spline.width) + " mm the tip circle would shrink to nothing",
                                  "write a smaller angle, such as angle_deg = 0.2"));
    }
}

void check_slices(SceneReading const& reading, Faults& faults)
{
    auto const& scene = reading.scene;
    bool const spread = scene.slices && knows(reading, {"slices.count"}) && scene.slices->count > 1;
    if (spread && !scene.given.contains("circular_spline.width")) {
        faults.push_back({"circular_spline.width", 0, "", "this key is missing: [slices] spreads over the width",
                          "write width = 7.0, a length in mm, in [circular_spline]"});
    }
}

/// The axial effects move the flexspline's given tooth.
void check_axial_reverse(SceneReading const& reading, Faults& faults)
{
    auto const& scene = reading.scene;
    auto const refuse = [&](std::string const& table, auto const& effect) {
        if (scene.is_reverse() && effect) {
            faults.push_back({table, effect->line, "", "axial effects need the flexspline's tooth, but the circular spline's is given",
                              "remove [" + table + "], or give [flexspline.profile] in place of [circular_spline.profile]",
                              effect->line > 0 ? "" : "--set"});
        }
    };
    refuse("coning", scene.coning);
    refuse("tilt", scene.tilt);
    refuse("slices", scene.slices);
    refuse("contact", scene.contact);
    if (scene.is_reverse() && scene.circular_spline.automatic_backlash) {
        faults.push_back(fault_at("circular_spline.backlash_offset", "\"auto\"", "needs the flexspline's tooth, but the circular spline's is given",
                                  "write a length in mm, such as 0.02"));
    }
}

void check_contact(SceneReading const& reading, Faults& faults)
{
    auto const& scene = reading.scene;
    if (scene.contact && knows(reading, {"contact.contact_gap", "drive.module"}) && scene.contact->gap > scene.drive.module / 10) {
        faults.push_back(fault_at("contact.contact_gap", number_text(scene.contact->gap), "flanks a tenth of the module apart do not touch",
                                  "write at most " + number_text(scene.drive.module / 10) + ", such as 0.001"));
    }
}

/// What the keys of [wedm] say to each other. What they say to the drive is judged where a wire is asked for (check_wedm), so that a drive of
/// another size can be solved without a word about its wire.
void check_wire(SceneReading const& reading, Faults& faults)
{
    WireRequest const& wedm = *reading.scene.wedm;
    bool const whole = knows(reading, {"wedm.wire_diameter", "wedm.spark_gap"});
    if (whole && wedm.spark_gap > wedm.wire_diameter) {
        faults.push_back(fault_at("wedm.spark_gap", number_text(wedm.spark_gap), "a gap wider than the wire is no spark gap",
                                  "write the gap in mm, such as 0.006"));
    }
    double const rounding = std::numbers::sqrt2 / 2 * std::pow(10.0, -wedm.decimals);
    if (knows(reading, {"wedm.tolerance", "wedm.decimals"}) && rounding > wedm.tolerance) {
        bool const told = reading.scene.given.contains("wedm.decimals");
        faults.push_back(fault_at(told ? "wedm.decimals" : "wedm.tolerance", told ? std::to_string(wedm.decimals) : number_text(wedm.tolerance),
                                  "rounding to " + std::to_string(wedm.decimals) + " decimals moves a point by up to " + number_text(rounding) +
                                      " mm, more than the tolerance of " + number_text(wedm.tolerance) + " mm",
                                  "write more decimals or a larger tolerance"));
    }
    double const reach = wedm.wire_diameter / 2 + wedm.spark_gap;
    if (whole && knows(reading, {"wedm.start_hole_radius"}) && wedm.start_hole_radius <= reach) {
        bool const told = reading.scene.given.contains("wedm.start_hole_radius");
        faults.push_back(fault_at(told ? "wedm.start_hole_radius" : "wedm.wire_diameter", number_text(told ? wedm.start_hole_radius : wedm.wire_diameter),
                                  "wire and gap do not go through a start hole of radius " + number_text(wedm.start_hole_radius) + " mm",
                                  "write a start_hole_radius above " + number_text(reach)));
    }
    double const stock = wedm.stock.empty() ? 0 : wedm.stock.front();
    double const least = wedm.start_hole_radius + reach + stock;
    if (whole && knows(reading, {"wedm.start_hole_radius", "wedm.lead_in"}) && wedm.lead_in <= least) {
        bool const told = reading.scene.given.contains("wedm.lead_in");
        faults.push_back(fault_at(told ? "wedm.lead_in" : "wedm.start_hole_radius", number_text(told ? wedm.lead_in : wedm.start_hole_radius),
                                  "the start hole would reach into the cut along the part: its centre is " + number_text(wedm.lead_in) +
                                      " mm from the tip land, its radius " + number_text(wedm.start_hole_radius) + " mm",
                                  "write a lead_in above " + number_text(least) + ", or a smaller hole"));
    }
}

void check_passes(SceneReading const& reading, Faults& faults)
{
    auto const& stock = reading.scene.wedm->stock;
    if (!knows(reading, {"wedm.passes"}) || stock.empty()) {
        return;
    }
    bool const falls = std::adjacent_find(stock.begin(), stock.end(), std::less_equal<>()) == stock.end();
    if (!falls || stock.back() != 0) {
        faults.push_back(fault_at("wedm.passes", "", falls ? "the last pass leaves " + number_text(stock.back()) + " mm on the part"
                                                           : "a pass that leaves no less than the one before cuts nothing",
                                  "write decreasing lengths that end with 0, such as passes = [[0.02], [0.005], [0]]"));
    }
}

void check_wedm(SceneReading const& reading, Faults& faults)
{
    if (reading.scene.wedm) {
        check_wire(reading, faults);
        check_passes(reading, faults);
    }
}

}  // namespace

Faults cross_faults(SceneReading const& reading)
{
    Faults faults;
    check_teeth(reading, faults);
    check_tolerance(reading, faults);
    check_wall(reading, faults);
    check_inner_radius(reading, faults);
    check_deformation(reading, faults);
    check_clearance(reading, "backlash_offset", reading.scene.circular_spline.backlash_offset, faults);
    check_clearance(reading, "root_clearance", reading.scene.circular_spline.root_clearance, faults);
    check_reverse(reading, faults);
    check_coning(reading, faults);
    check_bearing(reading, faults);
    check_cup(reading, faults);
    check_tilt(reading, faults);
    check_slices(reading, faults);
    check_axial_reverse(reading, faults);
    check_contact(reading, faults);
    check_wedm(reading, faults);
    locate(faults, reading.scene);
    return faults;
}

}  // namespace hdconj
