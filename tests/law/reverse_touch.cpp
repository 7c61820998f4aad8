// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The touch law of the reverse problem: each point of the solved flexspline flank is touched by a circular-spline
/// tooth at some position and entered at none.
#include <iostream>
#include <map>
#include <sstream>

#include "hdconj/distance/tooth_distance.hpp"
#include "hdconj/profile/registry.hpp"
#include "support/catch.hpp"
#include "support/reverse_law.hpp"

namespace hdconj::test::reverse_touch_cases {

using namespace oracle;
using hdconj::Scene;
using hdconj::Solution;
using hdconj::Vec2;

TEST_CASE("reverse touch law: the given tooth of data/scenes, every point", "[touch][reverse]")
{
    for (std::vector<std::string> const& overrides : std::vector<std::vector<std::string>>{
             {},
             {"solver.kinematics=first-order"},
             {"solver.kinematics=material"},
             {"wave_generator.family=ellipse", "solver.kinematics=material"},
             {"circular_spline.backlash_offset=0.003"},
             {"circular_spline.inner_radius=25.06"},
             {"flexspline.neutral_offset=0.1"},
             {"wave_generator.family=ellipse"},
             {"wave_generator.family=four-roller", "wave_generator.roller_angle_deg=30"},
             {"wave_generator.family=four-roller", "wave_generator.roller_angle_deg=30",
              "solver.kinematics=first-order"},
             {"wave_generator.family=two-disc", "wave_generator.wrap_angle_deg=30"},
             {"wave_generator.waves=1", "drive.circular_spline_teeth=201", "wave_generator.radial_deformation=0.14",
              "flexspline.addendum=0.1", "circular_spline.profile.addendum=0.12"},
             {"wave_generator.waves=3", "drive.circular_spline_teeth=203", "wave_generator.radial_deformation=0.37"},
             {"wave_generator.waves=1", "drive.circular_spline_teeth=203", "wave_generator.radial_deformation=0.37",
              "flexspline.addendum=0.2"}}) {
        Solution const solution = hdconj::solve(given_scene(overrides));
        INFO((overrides.empty() ? "" : overrides.front()));
        check_every_point(solution);
    }
}

// Found by the law of accuracy on random drives: what lay above the open end of the last curve counted as outside, and
// nothing was left of the tooth.
TEST_CASE("reverse touch law: curves of the outermost teeth that end below the tip", "[touch][reverse]")
{
    for (char const* const text : {R"(
[drive]
name = "random reverse"
module = 0.44586398094972884
flexspline_teeth = 63
circular_spline_teeth = 65
[flexspline]
addendum = 0.29894924246291066
dedendum = 0.33892907226666463
wall = 0.722179939301243
neutral_offset = 0.13999756497471613
[circular_spline.profile]
family = "double-circular-arc"
addendum = 0.30413483904907695
concave_offset = "tangent"
concave_radius = 0.86633708549037
concave_rise = 0.07031449483665929
convex_offset = 0.6296627968463544
convex_radius = 0.9957754403577102
convex_rise = -0.3102472304331817
dedendum = 0.47710055916399663
tip_line_from = 0.24494031554860496
[wave_generator]
family = "cosine"
radial_deformation = 0.3339501531982759
waves = 2
[circular_spline]
backlash_offset = 0.0
[solver]
kinematics = "exact"
tolerance = 1e-08
)",
                                   R"(
[drive]
name = "random reverse"
module = 0.11227474569595795
flexspline_teeth = 152
circular_spline_teeth = 158
[flexspline]
addendum = 0.055899733486762096
dedendum = 0.061423984012701424
wall = 0.1191661165359992
[circular_spline.profile]
family = "straight"
addendum = 0.04709858291180779
dedendum = 0.059510215411587394
pressure_angle_deg = 26.22661428344788
thickness = 0.20081044059011743
[wave_generator]
family = "cosine"
radial_deformation = 0.3651957152838746
waves = 3
[circular_spline]
backlash_offset = 0.002765847837010971
[solver]
kinematics = "first-order"
tolerance = 1e-08
)"}) {
        Solution const solution = hdconj::solve(hdconj::parse_scene(text, "open end"));
        check_every_point(solution);
    }
}

TEST_CASE("reverse touch law: it notices five picometres and another drive", "[touch][reverse]")
{
    Solution const solution = hdconj::solve(given_scene());
    ReverseTouchScan scan(solution.scene);
    auto const flank = std::find_if(solution.flexspline_pieces.begin(), solution.flexspline_pieces.end(),
                                    [](auto const& piece) { return piece.kind == "flank"; });
    REQUIRE(flank != solution.flexspline_pieces.end());
    auto const p = point_of(solution.flexspline_outline[(flank->first + flank->last) / 2]);
    double most = 0;
    for (Point<double> const shift : {Point<double>{5e-9, 0}, {-5e-9, 0}, {0, 5e-9}, {0, -5e-9}})
        most = std::max(most, std::abs(scan.nearest(p + shift).distance));
    CHECK(most > 3 * touch_limit);
    CHECK(most < 6 * touch_limit);

    Solution const other = hdconj::solve(given_scene({"solver.kinematics=first-order"}));
    CHECK(reverse_touch_law(other, scan, 200).touched.deviation > 1e-4);
}

TEST_CASE("reverse touch law: random designs", "[touch][random][reverse]")
{
    std::size_t const most = full_run() ? all_points : 40;
    int const wanted = 100;
    designs::RandomReverseDesigns draw(19551122);
    std::map<std::string, int> refusals, kinds;
    std::vector<std::string> broken;
    std::size_t points = 0;
    double worst = 0;
    for (int i = 0; i < wanted; ++i) {
        Scene const scene = draw.next();
        Solution solution;
        try {
            solution = reversed(scene);
        } catch (std::exception const& error) {
            ++refusals[error.what()];
            std::cout << "refused design:\n" << designs::reverse_toml_of(scene) << error.what() << "\n\n";
            continue;
        }
        ++kinds[scene.circular_spline.profile->family];
        ++kinds[std::to_string(scene.wave_generator.waves) + " waves"];
        if (scene.circular_spline.backlash_offset > 0)
            ++kinds["side clearance"];
        ReverseTouchScan scan(solution.scene);
        auto const report = reverse_touch_law(solution, scan, most);
        points += report.entered.points;
        worst = std::max(worst, report.worst());
        if (!report.holds() || report.touched.points < 10) {
            std::ostringstream text;
            text << designs::reverse_toml_of(scene) << report;
            broken.push_back(text.str());
        }
    }
    std::cout << "reverse touch law, random designs: " << wanted << " of " << draw.drawn << " drawn, "
              << refusals.size() << " refused, " << points << " points, worst " << worst << " mm\n";
    for (auto const& [what, count] : kinds)
        std::cout << "  " << what << ": " << count << "\n";
    for (auto const& text : broken)
        std::cout << "law broken by:\n" << text << "\n\n";
    CHECK(broken.empty());
    CHECK(refusals.empty());
    CHECK(kinds["straight"] > 15);
    CHECK(kinds["double-circular-arc"] > 30);
    CHECK(kinds["1 waves"] >= 5);
    CHECK(kinds["3 waves"] > 5);
    CHECK(kinds["side clearance"] > 10);
}

TEST_CASE("every tooth family is taken on the circular spline and touched", "[touch][reverse]")
{
    std::size_t families = 0;
    for (std::string const name :
         {"arc-chain", "b-spline", "bezier", "cycloid", "involute", "points", "s-tooth", "straight", "type-50"}) {
        // the tooth of a forward scene, put on the other member
        Scene scene = hdconj::read_scene(std::string(HDCONJ_SOURCE_DIR) + "/data/scenes/" + name + ".toml");
        double const m = scene.drive.module;
        scene.circular_spline = {};
        scene.circular_spline.profile = scene.flexspline.profile;
        scene.circular_spline.profile->path = "circular_spline.profile";
        scene.flexspline.profile = {};
        scene.flexspline.addendum = 0.6 * m;
        scene.flexspline.dedendum = 1.3 * m;
        Solution const solution = hdconj::solve(scene);
        INFO(name);
        CHECK(std::abs(solution.check->smallest_clearance) < 1e-11);
        ++families;

        // by the oracle's motion and the exact distance to the given tooth
        hdconj::Faults faults;
        hdconj::profile::Profile const tooth =
            hdconj::profile::build_profile(*scene.circular_spline.profile,
                                           {m, scene.drive.circular_spline_teeth, 0, 0, scene.folder.string(), true,
                                            scene.drive.circular_spline_teeth - scene.drive.flexspline_teeth, 2},
                                           faults);
        REQUIRE(faults.empty());
        hdconj::distance::ToothDistance const distance(tooth);
        Scene as_forward = scene;
        as_forward.flexspline.inner_radius = solution.geometry.flexspline_inner_radius;
        Motion<double> const motion(as_forward);
        double const pitch_line = solution.geometry.pitch_line;
        double const seat = solution.geometry.circular_spline_inner_radius + tooth.addendum + tooth.pitch_line;
        auto const at = [&](Vec2 const& p, int k, double u) {
            auto const there = turned_clockwise(motion.pose(u).to_circular_spline({p.x(), p.y() + pitch_line}),
                                                -(k - 0.5) * motion.pitch());
            return distance({-there.x, seat - there.y}).distance;
        };
        for (auto const& piece : solution.flexspline_pieces) {
            if (piece.kind != "flank" && piece.kind != "corner")
                continue;
            std::size_t const stride = std::max<std::size_t>(1, (piece.last - piece.first) / 3);
            for (std::size_t i = piece.first; i <= piece.last; i += stride) {
                Vec2 const p = solution.flexspline_outline[i];
                constexpr int steps = 1500;
                double const step = pi<double>() / steps;
                struct Low
                {
                    double value, u;
                    int k;
                };
                std::vector<Low> lows;
                double best = 1;
                for (int k : {-1, 0, 1, 2}) {
                    std::vector<double> values;
                    for (int j = 0; j <= steps; ++j)
                        values.push_back(at(p, k, -pi<double>() / 2 + step * j));
                    for (std::size_t j = 1; j + 1 < values.size(); ++j)
                        if (values[j] <= values[j - 1] && values[j] <= values[j + 1])
                            lows.push_back({values[j], -pi<double>() / 2 + step * static_cast<double>(j), k});
                }
                for (Low const& low : lows)
                    best = std::min(best, low.value);
                // a tooth moves by less than this in a step
                double const slack = 4 * m * step;
                double least = 1;
                for (Low const& low : lows) {
                    if (low.value > best + slack)
                        continue;
                    double from = low.u - step, to = low.u + step;
                    for (int n = 0; n < 70; ++n) {
                        double const c = from + (to - from) / 3, e = to - (to - from) / 3;
                        (at(p, low.k, c) < at(p, low.k, e) ? to : from) = at(p, low.k, c) < at(p, low.k, e) ? e : c;
                    }
                    least = std::min({least, low.value, at(p, low.k, 0.5 * (from + to))});
                }
                INFO(piece.kind << " point " << i << ": " << least);
                CHECK(std::abs(least) < touch_limit);
            }
        }
    }
    CHECK(families == 9);
}

}  // namespace hdconj::test::reverse_touch_cases
