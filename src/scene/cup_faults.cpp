// SPDX-License-Identifier: GPL-3.0-or-later
// The cup, its cone and the bearing that pushes it outward.
#include <utility>

#include "base/text.hpp"
#include "usual_cup.hpp"
#include "validation.hpp"

namespace hdconj::scene {
namespace {

/// Points between bearing and cup: their influences fill a matrix of some hundred megabytes.
constexpr int most_contact_points = 4000;

/// Diameter of a ball, of the thickness of the outer ring: about what type-50 has.
constexpr double ball_of_ring = 2.5;

/// Keys of the cup that say the same thing twice, or belong to one that is not there.
void check_cup(SceneReading const& reading, Faults& faults)
{
    auto const& given = reading.scene.given;
    for (std::string const side : {"rear", "front"}) {
        std::string const key = "flexspline.cup." + side;
        if (given.contains(key + "_ramp") && given.contains(key + "_fillet"))
            add_at(faults, key + "_fillet", "", "an arc takes the place of the ramp, and is as long as its radius says",
                   "remove one of " + side + "_ramp and " + side + "_fillet");
    }
    if (given.contains("flexspline.cup.tooth_share") && !given.contains("flexspline.cup.tooth_layer"))
        add_at(faults, "flexspline.cup.tooth_share", "", "there is no layer of teeth",
               "write tooth_layer = " + length_text(2.12 * reading.scene.drive.module) +
                   ", the height of the teeth in mm, or remove the key");
}

/// What the elastic cup cannot do without, and what is not for it. What the dimensions say to each other:
/// drive/drive.cpp.
void check_elastic(SceneReading const& reading, Faults& faults)
{
    auto const& scene = reading.scene;
    int const line = scene.coning->line;
    if (!scene.flexspline.cup && !scene.given.contains("flexspline.cup"))
        faults.push_back({"flexspline.cup", line, "",
                          "this table is missing: model \"elastic\" needs the cup's dimensions",
                          UsualCup(scene).advice_on_cup(), line > 0 ? "" : "--set"});
    if (!scene.bearing && !scene.given.contains("bearing"))
        faults.push_back({"bearing", line, "",
                          "this table is missing: model \"elastic\" needs what pushes the cup outward",
                          UsualCup(scene).advice_on_bearing(), line > 0 ? "" : "--set"});
    if (scene.given.contains("coning.apex_height"))
        add_at(faults, "coning.apex_height", number_text(scene.coning->apex_height),
               "the elastic cup tells where its apex is", "remove the key, or write model = \"linear\"");
}

/// Keys of single balls without what they belong to, and two keys that say how the balls yield.
void check_balls(SceneReading const& reading, Faults& faults)
{
    auto const& given = reading.scene.given;
    auto const has = [&](std::string const& key) { return given.contains("bearing." + key); };
    auto const refuse = [&](std::string const& key, std::string const& reason, std::string const& remedy) {
        if (has(key))
            add_at(faults, "bearing." + key, "", reason, remedy);
    };
    if (!has("balls")) {
        refuse("ball_phase_deg", "without the key balls they are a continuous row, which has no first ball",
               "write balls = 23 too, or remove the key");
        refuse("ball_diameter", "without the key balls they are a continuous row, to which Hertz' law does not apply",
               "write balls = 23 too, or remove the key");
    }
    if (!has("ball_diameter"))
        for (char const* const key :
             {"inner_conformity", "outer_conformity", "ball_youngs_modulus", "ball_poissons_ratio"})
            refuse(key, "without ball_diameter no ball has a groove to yield in",
                   "write ball_diameter = " + length_text(ball_of_ring * UsualCup(reading.scene).ring_thickness) +
                       ", a length in mm, or remove the key");
    else
        refuse("radial_stiffness", "ball_diameter says already how the balls yield",
               "remove one of ball_diameter and radial_stiffness");
}

/// A table that makes nothing yield.
void check_compliance(SceneReading const& reading, Faults& faults)
{
    auto const& scene = reading.scene;
    bool yields = false;
    for (char const* const key : {"flange", "hub", "shaft", "outer_radius"})
        yields = yields || scene.given.contains(std::string("compliance.") + key);
    if (scene.compliance && !yields)
        faults.push_back({"compliance", scene.compliance->line, "", "none of its keys is there, and nothing yields",
                          "write outer_radius = " + length_text(UsualCup(scene).outer_radius) +
                              ", in mm, or shaft = 60000, in N m/rad, or remove the table",
                          scene.compliance->line > 0 ? "" : "--set"});
}

/// Fit, oversize and clearance of a bearing are small parts of the module. Larger ones are given in another unit.
void check_bearing_lengths(SceneReading const& reading, Faults& faults)
{
    BearingChoice const& bearing = *reading.scene.bearing;
    double const most = reading.scene.drive.module / 2;
    for (auto const& [key, length] :
         {std::pair("bearing.fit", bearing.fit), std::pair("bearing.cam_oversize", bearing.cam_oversize),
          std::pair("bearing.clearance", bearing.clearance)})
        if (knows(reading, {"drive.module", key}) && length > most)
            add_at(faults, key, number_text(length),
                   "is more than half of the module: no bearing has so large a fit or clearance",
                   "write a length in mm, such as 0.005");
}

void check_bearing(SceneReading const& reading, Faults& faults)
{
    auto const& scene = reading.scene;
    if (!scene.bearing || !knows(reading, {"bearing.type"}))
        return;
    BearingChoice const& bearing = *scene.bearing;
    auto const refuse = [&](std::string const& key, std::string const& reason, std::string const& remedy) {
        add_at(faults, "bearing." + key, "", reason, remedy);
    };
    if (bearing.elastic && !scene.given.contains("bearing.ring_thickness"))
        faults.push_back({"bearing.ring_thickness", bearing.line, "",
                          "this key is missing: an outer ring that bends has a thickness",
                          "write ring_thickness = " + length_text(UsualCup(scene).ring_thickness) +
                              ", a length in mm, or type = \"rigid\""});
    if (bearing.elastic && knows(reading, {"bearing.width"}) && bearing.width <= 0)
        refuse("width", "an outer ring that bends has a width above 0",
               "write width = " + length_text(UsualCup(scene).bearing_width) + ", or type = \"rigid\"");
    for (std::string const key : {"ring_thickness", "radial_stiffness", "axially", "balls", "ball_phase_deg",
                                  "ball_diameter", "inner_conformity", "outer_conformity", "clearance",
                                  "youngs_modulus", "poissons_ratio", "ball_youngs_modulus", "ball_poissons_ratio"})
        if (!bearing.elastic && scene.given.contains("bearing." + key))
            refuse(key, "type \"rigid\" has no outer ring and no balls", "remove the key, or write type = \"elastic\"");
    if (bearing.balls && *bearing.balls < 2)
        refuse("balls", "one ball leaves the ring free to move across it",
               "write as many as the bearing has, such as 23, or leave the key out for a continuous row of balls");
    if (bearing.elastic)
        check_balls(reading, faults);
    check_bearing_lengths(reading, faults);
    if (knows(reading, {"bearing.angles"}) && bearing.angles % 2 != 0)
        refuse("angles", "is odd", "write an even number such as 48");
    if (knows(reading, {"bearing.angles", "bearing.circles"}) &&
        bearing.angles * bearing.circles > most_contact_points) {
        refuse(
            "angles",
            "with " + std::to_string(bearing.circles) + " circles makes " +
                std::to_string(bearing.angles * bearing.circles) + " points of contact, each with each",
            "write at most " + std::to_string(most_contact_points) + " points, such as angles = 96 and circles = 17");
    }
}

void check_coning(SceneReading const& reading, Faults& faults)
{
    auto const& scene = reading.scene;
    if (!scene.coning || !knows(reading, {"coning.model"}))
        return;
    if (!scene.given.contains("coning.bottom_to_middle")) {
        faults.push_back(
            {"coning.bottom_to_middle", scene.coning->line, "",
             "this key is missing: model " + in_quotes(to_string(scene.coning->model)) +
                 " needs the distance from the cup's bottom",
             "write bottom_to_middle = " + short_number(UsualCup(scene).bottom_to_middle) + ", a length in mm"});
    }
    if (scene.is_elastic())
        check_elastic(reading, faults);
    if (knows(reading, {"coning.bottom_to_middle"}) && scene.coning->apex_height >= *scene.coning->bottom_to_middle) {
        add_at(faults, "coning.apex_height", number_text(scene.coning->apex_height),
               "the apex must lie behind the middle of the bearing, which is " +
                   number_text(*scene.coning->bottom_to_middle) + " mm above the cup's bottom",
               "write a smaller height, such as 0");
        return;
    }
    bool const both =
        knows(reading, {"coning.bottom_to_middle", "circular_spline.width"}) && scene.circular_spline.width;
    double const to_apex = both ? *scene.coning->bottom_to_middle - scene.coning->apex_height : 0;
    if (both && *scene.circular_spline.width / 2 >= to_apex &&
        *scene.circular_spline.width / 2 < *scene.coning->bottom_to_middle) {
        add_at(faults, "coning.apex_height", number_text(scene.coning->apex_height),
               "the teeth would reach behind the apex: half the width is " +
                   number_text(*scene.circular_spline.width / 2) + " mm",
               "write a smaller height or a smaller circular_spline.width");
    }
    if (both && *scene.circular_spline.width / 2 >= *scene.coning->bottom_to_middle)
        add_at(faults, "coning.bottom_to_middle", number_text(*scene.coning->bottom_to_middle),
               "the teeth would reach through the cup's bottom: half the width is " +
                   number_text(*scene.circular_spline.width / 2) + " mm",
               "write a longer cup or a smaller circular_spline.width");
}

}  // namespace

void add_cup_faults(SceneReading const& reading, Faults& faults)
{
    check_coning(reading, faults);
    check_bearing(reading, faults);
    check_cup(reading, faults);
    check_compliance(reading, faults);
}

}  // namespace hdconj::scene
