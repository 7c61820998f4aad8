// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The backlash of an assembled drive: it does not fall where material is taken from the circular spline.
#include <string>
#include <utility>
#include <vector>

#include "hdconj/load.hpp"
#include "hdconj/read_scene.hpp"
#include "hdconj/units.hpp"
#include "support/catch.hpp"

namespace hdconj::test::backlash_cases {
namespace {

/// A drive of ratio 80 whose tips only just pass each other, with one outline for all slices.
LoadCase drive_of_80(double side_clearance, double tip_radius)
{
    std::vector<std::string> const keys{"drive.flexspline_teeth=160",
                                        "drive.circular_spline_teeth=162",
                                        "drive.module=0.5",
                                        "flexspline.wall=1.12",
                                        "flexspline.cup.length=20",
                                        "flexspline.cup.barrel_wall=0.64",
                                        "flexspline.cup.bottom=0.784",
                                        "flexspline.cup.tooth_width=10.7",
                                        "flexspline.cup.front_land=2.67",
                                        "flexspline.cup.front_fillet=6.26",
                                        "flexspline.cup.rear_fillet=6",
                                        "flexspline.cup.corner_radius=3.85",
                                        "flexspline.cup.flange_radius=20.8",
                                        "flexspline.profile.addendum=0.45",
                                        "flexspline.profile.dedendum=0.606",
                                        "flexspline.profile.convex_radius=0.5402",
                                        "flexspline.profile.convex_offset=0.1964",
                                        "flexspline.profile.concave_radius=1.029",
                                        "flexspline.profile.concave_rise=0.1342",
                                        "flexspline.profile.tip_line_from=0.38",
                                        "wave_generator.radial_deformation=0.5",
                                        "circular_spline.width=9.36",
                                        "bearing.width=8.02",
                                        "bearing.ring_thickness=1.92",
                                        "!flexspline.cup.rear_ramp",
                                        "!flexspline.cup.front_ramp",
                                        "slices.count=3",
                                        "slices.surface=tilted",
                                        "circular_spline.backlash_offset=" + std::to_string(side_clearance),
                                        "circular_spline.inner_radius=" + std::to_string(tip_radius)};
    LoadOptions options;
    options.torque = 1 * newton_metre;
    options.curve = options.errors = false;
    return study_load(builtin_scene(keys), options).cases.front();
}

}  // namespace

TEST_CASE("tips that interfere along the radius take the scene's tip circle from the drive", "[load][backlash]")
{
    LoadCase const given = drive_of_80(0.159, 40.2288);
    REQUIRE(given.cleared);
    CHECK(given.tip > 40.28);
    CHECK_FALSE(given.tips);
    REQUIRE(given.given_tips);
    CHECK(given.given_tips->depth == Approx(0.206e-3).margin(0.01e-3));
    CHECK(given.given_tips->least_tip == Approx(40.2288 + given.given_tips->depth).epsilon(1e-12));
    LoadCase const passing = drive_of_80(0.159, given.given_tips->least_tip + 1e-5);
    CHECK_FALSE(passing.cleared);
    CHECK_FALSE(passing.given_tips);
    CHECK(passing.tip_radius_increase == 0);
    CHECK(passing.backlash > 0.9 * arcmin);
    CHECK(passing.backlash < given.backlash);
}

TEST_CASE("the backlash does not fall where material is taken from the circular spline", "[load][backlash]")
{
    double last = 0;
    int compared = 0;
    for (auto const& [side_clearance, tip_radius] :
         {std::pair(0.158, 40.2288), std::pair(0.162, 40.2288), std::pair(0.162, 40.2292), std::pair(0.165, 40.2292),
          std::pair(0.165, 40.24)}) {
        INFO("side clearance " << side_clearance << ", tip circle " << tip_radius);
        LoadCase const each = drive_of_80(side_clearance, tip_radius);
        if (each.tip_radius_increase > 0)
            continue;  // another tip circle than the others
        CHECK(each.backlash > last);
        last = each.backlash;
        ++compared;
    }
    CHECK(compared == 4);
    CHECK(last > 4.9 * arcmin);
}

}  // namespace hdconj::test::backlash_cases
