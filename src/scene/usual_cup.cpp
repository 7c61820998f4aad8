// SPDX-License-Identifier: GPL-3.0-or-later
#include "usual_cup.hpp"

#include <algorithm>

#include "base/text.hpp"
#include "tolerance_limits.hpp"

namespace hdconj::scene {

UsualCup::UsualCup(Scene const& scene)
{
    double const of_type_50 = 50, known = 2 * flexspline_pitch_radius(scene.drive),
                 diameter = known > 0 ? known : of_type_50;
    double const wall = scene.flexspline.wall > 0 ? scene.flexspline.wall : 0.014 * diameter;
    bool const has_cup = scene.flexspline.cup && scene.flexspline.cup->tooth_width > 0,
               has_bearing = scene.bearing && scene.bearing->width > 0;
    spline_width =
        scene.circular_spline.width.value_or(has_cup ? 0.875 * scene.flexspline.cup->tooth_width : 0.14 * diameter);
    outer_radius = 0.7 * diameter;
    ring_thickness = 0.024 * diameter;
    if (has_cup) {
        cup = *scene.flexspline.cup;
    } else {
        cup.tooth_width = std::max(spline_width / 0.875, has_bearing ? scene.bearing->width / 0.75 : 0);
        cup.front_land = std::max(0.04 * diameter, wall);
        cup.barrel_wall = wall / 1.75;
        cup.bottom = wall / 1.4;
        cup.corner_radius = std::max(0.04 * diameter, 1.5 * wall);
        cup.flange_radius = 0.26 * diameter;
        cup.length = scene.coning && scene.coning->bottom_to_middle
                         ? *scene.coning->bottom_to_middle + cup.tooth_width / 2 + cup.front_land
                         : 0.1 * diameter + cup.front_land + cup.tooth_width - (0.04 * diameter - cup.corner_radius);
    }
    bearing_width = has_bearing ? scene.bearing->width : 0.75 * cup.tooth_width;
    bottom_to_middle = cup.length - cup.front_land - cup.tooth_width / 2;
}

std::string UsualCup::advice_on_cup() const
{
    return "write the line [flexspline.cup] and below it length = " + length_text(cup.length) +
           ", barrel_wall = " + length_text(cup.barrel_wall) + ", bottom = " + length_text(cup.bottom) +
           ", corner_radius = " + length_text(cup.corner_radius) +
           ", flange_radius = " + length_text(cup.flange_radius) + ", tooth_width = " + length_text(cup.tooth_width) +
           ", front_land = " + length_text(cup.front_land);
}

std::string UsualCup::advice_on_bearing() const
{
    return "write the line [bearing] and below it type = \"elastic\", width = " + length_text(bearing_width) +
           ", ring_thickness = " + length_text(ring_thickness);
}

std::string length_text(double length)
{
    constexpr int digits = 3;
    std::string const text = short_number(length, digits);
    return text.find_first_of(".e") == std::string::npos ? text + ".0" : text;
}

}  // namespace hdconj::scene
