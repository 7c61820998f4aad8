// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Designs that once broke something or sit at a limit, each with its cause and the outcome it must have.
#include <string>
#include <vector>

#include "hdconj/io/scene_toml.hpp"
#include "hdconj/numeric/error.hpp"
#include "hdconj/pipeline/solve.hpp"
#include "support/catch.hpp"

using namespace hdconj;

namespace {

struct HardDesign
{
    std::string name;
    std::string cause;
    std::vector<std::string> overrides;
    std::string refused_for;  ///< empty: a right answer; else part of the message
};

std::vector<std::string> const straight{
    "drive.module=0.37667952570639884", "drive.flexspline_teeth=283", "drive.circular_spline_teeth=284",
    "flexspline.wall=0.7102075460577444", "!flexspline.profile", "flexspline.profile.family=straight",
    "flexspline.profile.addendum=0.1956688069507966", "flexspline.profile.dedendum=0.2512165357218547",
    "flexspline.profile.pressure_angle_deg=23.501926364864964", "flexspline.profile.thickness=0.4412388595728802",
    "wave_generator.radial_deformation=0.20596716521136485", "wave_generator.waves=1",
    "circular_spline.inner_radius=53.32369505785473"};

std::vector<HardDesign> const table{
    {"fast contact", "a straight flank turns by 1 degree while its whole length touches: points round 100 times worse along it", straight, ""},
    {"one wave", "q_x is the difference of two lengths of 24 mm and all but vanishes, the cusp function is mostly rounding", {"wave_generator.waves=1", "circular_spline.inner_radius=25.12"}, ""},
    {"three waves", "teeth differ by 3", {"drive.circular_spline_teeth=203", "wave_generator.waves=3"}, ""},
    {"first order", "the other motion model", {"solver.kinematics=first-order"}, ""},
    {"small w0", "teeth never leave the tooth spaces", {"wave_generator.radial_deformation=0.15"}, "tip circle"},
    {"vanishing w0", "rigid limit", {"wave_generator.radial_deformation=1e-9", "circular_spline.inner_radius=25.0"}, "tip circle"},
    {"offset closes the lands", "neighbouring spaces overlap at the tip circle", {"circular_spline.backlash_offset=0.045"}, "pointed"},
    {"tip stays inside", "the tip never comes down to the tip circle, curves float above it and the walk got under them",
     {"flexspline.profile.addendum=0.2129", "!flexspline.profile.tip_line_from", "flexspline.profile.convex_radius=0.2934",
      "flexspline.profile.convex_offset=0.0987", "flexspline.profile.concave_radius=0.5228", "flexspline.profile.concave_rise=0.0686",
      "wave_generator.radial_deformation=0.1907", "!circular_spline.inner_radius"},
     "no tip land"},
    {"swallowed stretch", "a clearance of 20 um closes over a corner path of 3.4 um",
     {"flexspline.profile.addendum=0.1763", "flexspline.profile.tip_line_from=0.0624", "flexspline.profile.convex_offset=0.0252",
      "flexspline.profile.convex_radius=0.3007", "flexspline.profile.concave_radius=0.6552", "flexspline.profile.concave_rise=-0.0462",
      "wave_generator.radial_deformation=0.3002", "!circular_spline.inner_radius", "circular_spline.backlash_offset=0.02",
      "solver.kinematics=first-order"},
     "swallows a stretch of the flank 0.003389 mm long"},
    {"the same without clearance", "the corner path of 3.4 um is there",
     {"flexspline.profile.addendum=0.1763", "flexspline.profile.tip_line_from=0.0624", "flexspline.profile.convex_offset=0.0252",
      "flexspline.profile.convex_radius=0.3007", "flexspline.profile.concave_radius=0.6552", "flexspline.profile.concave_rise=-0.0462",
      "wave_generator.radial_deformation=0.3002", "!circular_spline.inner_radius", "solver.kinematics=first-order"},
     ""},
    {"swallowtail next to a cusp", "two branches cross 4 um from the cusp of one: polygons of the first look miss each other",
     {"drive.module=0.285372766780939", "drive.flexspline_teeth=207", "drive.circular_spline_teeth=210", "flexspline.wall=0.49858889072490536",
      "flexspline.profile.addendum=0.18224747639293287", "flexspline.profile.concave_radius=0.4261321264493276",
      "flexspline.profile.concave_rise=0.08679811073874014", "flexspline.profile.convex_offset=0.20624919686977042",
      "flexspline.profile.convex_radius=0.3942594164048105", "flexspline.profile.convex_rise=-0.07210057745713667",
      "flexspline.profile.dedendum=0.19135985021257954", "flexspline.profile.tip_line_from=0.10595148905275835",
      "wave_generator.radial_deformation=0.4280591501714085", "wave_generator.waves=3", "!circular_spline.inner_radius"},
     ""},
    {"huge offset", "offset larger than the tooth", {"circular_spline.backlash_offset=0.25"}, "tip circle"},
    {"tip circle inside the flank's last corner path", "the corner between flank and corner path lies 2 um above the tip circle", {"circular_spline.inner_radius=25.0485"}, ""},
    {"far more teeth outside", "50 000 pitches a lobe: found by fuzzing, 10 s and 2 GB before it was refused",
     {"drive.circular_spline_teeth=99998", "!circular_spline.inner_radius"}, "by 49899 teeth"},
    {"coarse tolerance", "a handful of points", {"solver.tolerance=0.02"}, ""},
    {"fine tolerance", "chord error near the rounding of the coordinates", {"solver.tolerance=1e-11"}, ""},
};

}  // namespace

TEST_CASE("hard designs give a right answer or name their place", "[hard]")
{
    for (HardDesign const& design : table)
    {
        DYNAMIC_SECTION(design.name << ": " << design.cause)
        {
            try
            {
                Solution const solution = solve(builtin_scene(design.overrides));
                INFO("accepted");
                REQUIRE(design.refused_for.empty());
                for (Vec2 const& p : solution.circular_spline.outline.front())
                    REQUIRE(p.allFinite());
                CHECK(solution.check->smallest_clearance >= solution.scene.circular_spline.backlash_offset - 1e-10);
                CHECK(solution.error.chord <= solution.scene.solver.tolerance);
            }
            catch (std::runtime_error const& error)
            {
                INFO(error.what());
                REQUIRE_FALSE(design.refused_for.empty());
                CHECK_THAT(error.what(), ContainsSubstring(design.refused_for));
            }
        }
    }
}

TEST_CASE("a drive in any unit of length is the same drive", "[hard]")
{
    Solution const base = solve(builtin_scene());
    for (double scale : {0x1p-10, 0x1p12})
    {
        auto const set = [&](std::string const& key, double value) { return key + "=" + std::to_string(value * 1e12) + "e-12"; };
        auto const lengths = {std::pair{"drive.module", 0.25}, {"flexspline.wall", 0.7}, {"flexspline.profile.addendum", 0.2250},
                              {"flexspline.profile.dedendum", 0.3030}, {"flexspline.profile.convex_radius", 0.2701},
                              {"flexspline.profile.convex_offset", 0.0982}, {"flexspline.profile.concave_radius", 0.5145},
                              {"flexspline.profile.concave_rise", 0.0671}, {"flexspline.profile.tip_line_from", 0.19},
                              {"wave_generator.radial_deformation", 0.25}, {"circular_spline.inner_radius", 25.025},
                              {"circular_spline.width", 7.0}, {"solver.tolerance", 1e-6}};
        std::vector<std::string> overrides;
        for (auto const& [key, value] : lengths)
            overrides.push_back(set(key, value * scale));
        Solution const scaled = solve(builtin_scene(overrides));
        auto const& a = base.circular_spline;
        auto const& b = scaled.circular_spline;
        REQUIRE(b.outline[0].size() >= a.outline[0].size() - 4);
        for (std::size_t k = 0; k < a.landmarks.size(); ++k)
        {
            Vec2 const p = a.outline[0][static_cast<std::size_t>(a.landmarks[k])];
            Vec2 const q = b.outline[0][static_cast<std::size_t>(b.landmarks[k])] / scale;
            // the overrides are typed with 12 decimals of the scaled length
            CHECK((p - q).norm() < 1e-7);
        }
        CHECK(scaled.check->smallest_clearance / scale > -1e-10);
    }
}
