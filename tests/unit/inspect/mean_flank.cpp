// SPDX-License-Identifier: GPL-3.0-or-later
// The mean flank of measured teeth, and points of a solved circular spline.
#include <cmath>
#include <numbers>

#include "hdconj/inspect.hpp"
#include "hdconj/read_scene.hpp"
#include "hdconj/solve.hpp"
#include "inspect/nominal_part.hpp"
#include "support/catch.hpp"
#include "support/measured_ring.hpp"
#include "support/type50.hpp"

namespace hdconj::test::mean_flank_cases {

TEST_CASE("the mean flank is the nominal one with the deviations that all flanks have", "[inspect]")
{
    designs::Draws draws(5000);
    MeasuredRing ring;
    ring.measured = {0, 1, 50, 120};
    FlankErrors const same{0, 3e-3, -2e-3, 0};
    ring.left.assign(4, same);
    ring.right.assign(4, same);
    Inspection const found = inspected(ring, draws, Registration::datum);
    REQUIRE(found.mean_flank.size() > 100);
    profile::Profile const tooth = type50_tooth();
    inspect::NominalPlane const nominal = inspect::plane_of_profile(tooth, type50_r_m);
    for (Vec2 const& p : found.mean_flank) {
        Vec2 const in_frame = p + Vec2(0, tooth.pitch_line);
        auto const foot = nominal.right(in_frame);
        double const xi = 2 * nominal.right.arc_length(foot.point) / nominal.right.length() - 1;
        if (foot.on)
            CHECK(std::abs(foot.distance - (same.slope / 2 * xi - same.crowning * xi * xi)) < exact);
    }
    CHECK(std::abs(found.mean_flank.front().y() - tooth.addendum) < 1e-12);
    CHECK(std::abs(found.mean_flank.back().y() + tooth.dedendum) < 1e-12);
}

TEST_CASE("points of the solved circular spline lie on it, those of a wider space beside it", "[inspect]")
{
    Scene scene = builtin_scene({"solver.threads=1"});
    Scene fine = scene;
    fine.solver.tolerance = 1e-8;
    CircularSplineOutline const spline = solve(fine).circular_spline;
    PointFile file{"spline", {}, false};
    double const pitch = 2 * std::numbers::pi / scene.drive.circular_spline_teeth, wider = 8e-5;  // rad
    for (int const space : {0, 1, 2, 70})
        for (OutlinePiece const& piece : spline.pieces)
            for (std::size_t i = piece.first; piece.kind == "flank" && i <= piece.last; i += 40) {
                Vec2 const& p = spline.outline.front()[i];
                double const out = (p.x() > 0 ? 1 : -1) * wider / 2;
                file.points.push_back({turned_clockwise(p, space * pitch + out), 0, 0, std::nullopt, 0});
            }
    Inspection const found =
        inspect_points(scene, file, {InspectedPart::circular_spline, std::nullopt, 0, Registration::datum});
    REQUIRE(found.teeth.size() == 4);
    // the points are right to 1e-8 mm, the nominal outline of the coarser solution to its own error
    double const known = found.nominal.front().error + 2e-8;
    CHECK(known < 1e-6);
    double const arc = wider * found.nominal.front().reference_radius;
    for (ToothFigures const& space : found.teeth)
        CHECK(std::abs(space.thickness.value - found.nominal.front().thickness - arc) < 4 * known);
    for (FlankFigures const& flank : found.flanks)
        CHECK(flank.total.value < 4 * known);
}

TEST_CASE("points of lands and roots are not evaluated, wherever the part stands", "[inspect]")
{
    Scene const scene = builtin_scene({"solver.threads=1", "solver.tolerance=1e-7"});
    CircularSplineOutline const spline = solve(scene).circular_spline;
    double const pitch = 2 * std::numbers::pi / scene.drive.circular_spline_teeth;
    Vec2 const shift(0.05, -0.03);
    for (double const turn : {0.0, 0.4 * pitch, -0.45 * pitch}) {
        PointFile file{"spline", {}, false};
        for (int const space : {0, 37, 80, 121, 160})
            for (std::size_t i = 0; i < spline.outline.front().size(); i += 12)
                file.points.push_back(
                    {turned_clockwise(spline.outline.front()[i], space * pitch + turn) + shift, 0, 0, std::nullopt, 0});
        for (Registration const registration : {Registration::least_squares, Registration::minimum_zone}) {
            CAPTURE(turn / pitch, to_string(registration));
            Inspection const found =
                inspect_points(scene, file, {InspectedPart::circular_spline, std::nullopt, 0, registration});
            CHECK(std::abs(found.placement.turn.value - turn) * 25 < 1e-6);
            CHECK(std::abs(found.placement.shift_x.value - shift.x()) < 1e-6);
            CHECK(std::abs(found.placement.shift_y.value - shift.y()) < 1e-6);
            CHECK(found.placement.rms < 1e-6);
            CHECK(found.strays == 0);
            CHECK(found.beside > 0);
            CHECK(found.teeth.size() == 5);
        }
    }
}

}  // namespace hdconj::test::mean_flank_cases
