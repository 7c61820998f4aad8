// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Laws of the material motion: the exact motion is one of its cases, and the touch law holds for random drives.
#include <algorithm>
#include <cmath>
#include <iostream>
#include <numbers>
#include <string>

#include "hdconj/distance/full_turn.hpp"
#include "hdconj/envelope/find_branches.hpp"
#include "hdconj/motion/material_motion.hpp"
#include "hdconj/wavegen/displacement_of.hpp"
#include "hdconj/wavegen/inextensional_mode.hpp"
#include "hdconj/wavegen/registry.hpp"
#include "support/catch.hpp"
#include "support/check_touch.hpp"
#include "support/oracle/run.hpp"
#include "support/type50.hpp"

namespace hdconj::test::material_cases {

using namespace oracle;
using hdconj::Kinematics;
using hdconj::Scene;
using hdconj::Solution;
using hdconj::motion::MaterialMotion;
using hdconj::wavegen::AnyWaveShape;
using hdconj::wavegen::CosineCam;
using hdconj::wavegen::NeutralCurve;

namespace {

hdconj::profile::Profile tooth_of(Scene const& scene)
{
    hdconj::Faults faults;
    hdconj::profile::Profile tooth =
        hdconj::profile::build_profile(scene.flexspline.profile, hdconj::test::place_of(scene), faults);
    REQUIRE(faults.empty());
    return tooth;
}

double ratio_of(Scene const& scene)
{
    return static_cast<double>(scene.drive.flexspline_teeth) / scene.drive.circular_spline_teeth;
}

struct Deviation
{
    double touched = 0, entered = 0;
    std::size_t points = 0;
};

/// The touch law by the program's own march over a full turn of @p motion.
Deviation touch_of(Solution const& solution, MaterialMotion const& motion)
{
    Scene const& scene = solution.scene;
    hdconj::profile::Profile const tooth = tooth_of(scene);
    int const lobe_pitches =
        (scene.drive.circular_spline_teeth - scene.drive.flexspline_teeth) / scene.wave_generator.waves;
    hdconj::distance::FullTurnClearance<MaterialMotion> const clearance(
        tooth, motion, 2 * std::numbers::pi / scene.drive.circular_spline_teeth, lobe_pitches);
    Deviation worst;
    for (auto const& piece : solution.circular_spline.pieces)
        for (std::size_t i = piece.first; i <= piece.last; ++i) {
            double const least = clearance(solution.circular_spline.outline[0][i]).distance;
            worst.entered = std::max(worst.entered, -least);
            if (must_be_touched(piece.kind)) {
                worst.touched = std::max(worst.touched, std::abs(least));
                ++worst.points;
            }
        }
    return worst;
}

}  // namespace

TEST_CASE("material motion of the exact displacement has the exact motion's outline and branches", "[touch][material]")
{
    for (Scene const& scene : {type_50(), liu_2025()}) {
        INFO(scene.drive.name);
        Solution const solution = hdconj::solve(scene);
        CosineCam const cam{solution.geometry.w0, scene.wave_generator.waves};
        double const r_m = solution.geometry.r_m;
        MaterialMotion const same(hdconj::wavegen::displacement_of(hdconj::wavegen::NeutralCurve<CosineCam>(cam, r_m)),
                                  r_m, ratio_of(scene));
        Deviation const worst = touch_of(solution, same);
        std::cout << scene.drive.name
                  << ", exact outline under the material motion of the exact displacement: touched to " << worst.touched
                  << " mm, entered by " << worst.entered << " mm, " << worst.points << " points\n";
        CHECK(worst.points > 100);
        CHECK(worst.touched < 1e-12);
        CHECK(worst.entered < 1e-12);

        hdconj::profile::Profile const tooth = tooth_of(scene);
        auto const set = hdconj::envelope::find_branches(hdconj::envelope::Envelope<MaterialMotion>(tooth, same, 0), 1);
        CHECK(set.record.certified());
        CHECK(set.branches.size() == solution.branches.size());

        // Negative control: the linear mode is another motion.
        Deviation const other =
            touch_of(solution, MaterialMotion(hdconj::wavegen::inextensional_mode(cam), r_m, ratio_of(scene)));
        CHECK(other.touched > 1e-3);
        CHECK(other.entered > 1e-4);
    }
}

TEST_CASE("touch law: random designs with the material motion", "[touch][random][material]")
{
    std::size_t const most = full_run() ? static_cast<std::size_t>(-1) : 30;
    designs::RandomDesigns draw(20120915);
    int const wanted = 60;
    int solved_now = 0, ellipses = 0, rings = 0, refused = 0;
    std::size_t points = 0;
    double worst = 0;
    for (int i = 0; solved_now < wanted && i < 10 * wanted; ++i) {
        Scene scene = draw.next();
        scene.solver.kinematics = Kinematics::material;
        auto& generator = scene.wave_generator;
        bool const ellipse = i % 3 == 1 && generator.waves == 2, ring = i % 3 == 2;
        if (ellipse || ring)
            generator.shape.family = ellipse ? "ellipse" : "ring-on-cosine-cam";
        if (ring)
            generator.shape.given["ring_thickness"] = {5 * scene.drive.module, 0};
        // drawn for another motion: by the oracle's judgement again
        if (!designs::is_valid(scene))
            continue;
        INFO(designs::toml_of(scene));
        try {
            Solution const solution = solved(scene);
            TouchScan scan(solution.scene, 1200);
            auto const report = touch_law(solution, scan, most, static_cast<std::uint64_t>(i));
            check_touched(report);
            worst = std::max(worst, report.worst());
            points += report.entered.points;
            ++solved_now;
            ellipses += ellipse;
            rings += ring;
        } catch (std::exception const& error) {
            ++refused;
            std::cout << "refused design:\n" << designs::toml_of(scene) << error.what() << "\n\n";
        }
    }
    std::cout << "touch law, material motion: " << solved_now << " designs (" << ellipses << " ellipses, " << rings
              << " rings), " << refused << " refused, " << points << " points, worst " << worst << " mm\n";
    CHECK(solved_now == wanted);
    CHECK(ellipses >= 5);
    CHECK(rings >= 5);
    CHECK(refused <= 1);
}

}  // namespace hdconj::test::material_cases
