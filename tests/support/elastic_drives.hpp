// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Seeded random drives with an elastic cup and bearing, as TOML text: modules 0.15 to 0.6, 160 to 240 teeth, cups 0.28
/// to 0.6 diameters long, teeth of type-50's proportions with 10 % of scatter.
#pragma once

#include <algorithm>
#include <string>

#include "draws.hpp"

namespace designs {

/// A drive and a torque of the order of its rating.
struct ElasticDrive
{
    std::string scene;
    double torque = 0;  ///< [N m]
};

inline ElasticDrive elastic_drive(unsigned seed)
{
    Draws draws(seed);
    std::string text;
    auto const table = [&](char const* name) { text += std::string("[") + name + "]\n"; };
    auto const word = [&](char const* key, char const* value) { text += std::string(key) + " = \"" + value + "\"\n"; };
    auto const number = [&](char const* key, auto value) {
        text += std::string(key) + " = " + std::to_string(value) + "\n";
        return value;
    };
    double const module = draws.between(0.15, 0.6);
    int const teeth = 2 * draws.whole(80, 120);
    double const diameter = module * teeth, wall = draws.about(0.0135 * diameter, 0.15);
    double const barrel = draws.between(0.55, 0.7) * wall, length = draws.between(0.28, 0.6) * diameter;
    double const width = draws.between(0.35, 0.5) * length, land = std::min(0.13 * length, 6 * module);
    double const addendum = draws.about(0.9 * module, 0.05), dedendum = draws.about(1.212 * module, 0.05);
    double const ramp = 0.6 * wall, inner = diameter / 2 - dedendum - wall;
    table("drive");
    number("module", module);
    number("flexspline_teeth", teeth);
    number("circular_spline_teeth", teeth + 2);
    table("flexspline");
    number("wall", wall);
    table("flexspline.cup");
    number("length", length);
    number("barrel_wall", barrel);
    number("bottom", 1.2 * barrel);
    number("corner_radius", std::min(4 * barrel, 0.12 * length));
    number("flange_radius", draws.between(0.45, 0.6) * inner);
    number("tooth_width", width);
    number("front_land", land);
    number("rear_ramp", ramp);
    number("front_ramp", ramp);
    number("youngs_modulus", 206000.0);
    number("poissons_ratio", 0.3);
    table("flexspline.profile");
    word("family", "double-circular-arc");
    number("addendum", addendum);
    number("dedendum", dedendum);
    number("convex_radius", draws.about(1.08 * module, 0.1));
    number("convex_offset", draws.about(0.393 * module, 0.1));
    number("concave_radius", draws.about(2.058 * module, 0.1));
    word("concave_offset", "tangent");
    number("concave_rise", draws.about(0.268 * module, 0.1));
    number("tip_line_from", 0.84 * addendum);
    table("wave_generator");
    word("family", "cosine");
    number("radial_deformation", draws.about(module, 0.08));
    number("waves", 2);
    table("circular_spline");
    number("width", 0.72 * width);
    number("backlash_offset", draws.chance(2.0 / 3) ? 0 : draws.between(0.1, 0.4) * module);
    table("coning");
    word("model", "elastic");
    number("bottom_to_middle", length - land - ramp - width / 2);
    word("axial_shift", "mapped");
    table("bearing");
    bool const elastic = draws.chance(0.75);
    word("type", elastic ? "elastic" : "rigid");
    number("width", 0.7 * width);
    if (elastic) {
        number("ring_thickness", 0.019 * diameter);
        word("axially", draws.chance(0.5) ? "held" : "free");
        if (draws.chance(1.0 / 3))
            number("balls", 2 * draws.whole(9, 13));
    }
    table("slices");
    number("count", 2 * draws.whole(2, 4) + 1);
    double const size = diameter / 50;
    return {text, 28 * size * size * size * draws.between(0.5, 1.5)};
}

}  // namespace designs
