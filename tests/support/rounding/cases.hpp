// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The drives of the rounding study: ordinary ones, and those that lose most.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "study.hpp"
#include "support/oracle/run.hpp"

namespace rounding {

struct Case
{
    std::string name;
    Scene scene;
};

/// A straight flank that turns by one degree while its whole length touches.
inline Scene fast_contact()
{
    return hdconj::builtin_scene(
        {"drive.module=0.37667952570639884", "drive.flexspline_teeth=283", "drive.circular_spline_teeth=284",
         "flexspline.wall=0.7102075460577444", "!flexspline.profile", "flexspline.profile.family=straight",
         "flexspline.profile.addendum=0.1956688069507966", "flexspline.profile.dedendum=0.2512165357218547",
         "flexspline.profile.pressure_angle_deg=23.501926364864964", "flexspline.profile.thickness=0.4412388595728802",
         "wave_generator.radial_deformation=0.20596716521136485", "wave_generator.waves=1",
         "circular_spline.inner_radius=53.32369505785473"});
}

/// Two branches that cross 4 um from the cusp of one.
inline Scene swallowtail()
{
    return hdconj::builtin_scene(
        {"drive.module=0.285372766780939", "drive.flexspline_teeth=207", "drive.circular_spline_teeth=210",
         "flexspline.wall=0.49858889072490536", "flexspline.profile.addendum=0.18224747639293287",
         "flexspline.profile.concave_radius=0.4261321264493276", "flexspline.profile.concave_rise=0.08679811073874014",
         "flexspline.profile.convex_offset=0.20624919686977042", "flexspline.profile.convex_radius=0.3942594164048105",
         "flexspline.profile.convex_rise=-0.07210057745713667", "flexspline.profile.dedendum=0.19135985021257954",
         "flexspline.profile.tip_line_from=0.10595148905275835", "wave_generator.radial_deformation=0.4280591501714085",
         "wave_generator.waves=3", "!circular_spline.inner_radius"});
}

inline std::vector<Case> cases()
{
    Scene const type_50 = oracle::type_50();
    auto const edited = [&](std::vector<std::string> const& overrides) { return hdconj::builtin_scene(overrides); };
    return {
        {"type-50", type_50},
        {"liu-2025", oracle::liu_2025()},
        {"one wave", edited({"wave_generator.waves=1", "circular_spline.inner_radius=25.12"})},
        {"three waves", edited({"drive.circular_spline_teeth=203", "wave_generator.waves=3"})},
        {"fast contact", fast_contact()},
        {"cusp", swallowtail()},
        // a flank inclined by 0.3 rad: an upright one would never touch
        {"arc radius 1e3", edited({"flexspline.profile.convex_radius=1000.0",
                                   "flexspline.profile.convex_offset=955.136", "flexspline.profile.convex_rise=-295.52",
                                   "flexspline.profile.concave_rise=0.152", "!flexspline.profile.tip_line_from"})},
        {"module 2^-11", designs::scaled(type_50, 0x1p-11 / 0.25)},
        {"module 2^10", designs::scaled(type_50, 0x1p10 / 0.25)},
        {"z_f 5000",
         edited({"drive.flexspline_teeth=5000", "drive.circular_spline_teeth=5002", "!circular_spline.inner_radius"})},
        {"z_f 30",
         edited({"drive.flexspline_teeth=30", "drive.circular_spline_teeth=32", "!circular_spline.inner_radius"})},
        // only the tip touches, at the ends of the lobe
        {"w0 1e-6", edited({"wave_generator.radial_deformation=1e-6", "!circular_spline.inner_radius"})}};
}

}  // namespace rounding
