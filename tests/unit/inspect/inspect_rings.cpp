// SPDX-License-Identifier: GPL-3.0-or-later
// Rings whose errors are known: without noise each figure comes back, with noise its interval holds it.
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <set>

#include "hdconj/inspect.hpp"
#include "hdconj/read_scene.hpp"
#include "hdconj/solve.hpp"
#include "inspect/nominal_part.hpp"
#include "support/catch.hpp"
#include "support/measured_ring.hpp"
#include "support/type50.hpp"

namespace hdconj::test::inspect_rings_cases {

namespace {

constexpr double exact = 1e-9;  // mm
constexpr int small_ring = 60;

/// Rings of each kind: few, or with HDCONJ_FULL all of them.
int rings_of_kind(int full)
{
    return std::getenv("HDCONJ_FULL") != nullptr ? full : 2;
}

Scene scene_of(MeasuredRing const& ring)
{
    return builtin_scene({"drive.flexspline_teeth=" + std::to_string(ring.teeth),
                          "drive.circular_spline_teeth=" + std::to_string(ring.teeth + 2),
                          "circular_spline.inner_radius=" + std::to_string(ring.pitch_radius() + 0.025),
                          "solver.threads=1"});
}

Inspection inspected(MeasuredRing& ring, designs::Draws& draws, Registration registration)
{
    PointFile const file = points_of(ring, draws);
    return inspect_points(scene_of(ring), file, {InspectedPart::flexspline, std::nullopt, ring.probe, registration});
}

void give_errors(MeasuredRing& ring, designs::Draws& draws, double form)
{
    std::size_t const n = ring.measured.empty() ? static_cast<std::size_t>(ring.teeth) : ring.measured.size();
    for (auto* side : {&ring.left, &ring.right}) {
        side->resize(n);
        for (FlankErrors& each : *side)
            each = {draws.between(-5e-3, 5e-3), draws.between(-4e-3, 4e-3), draws.between(-3e-3, 3e-3), form};
    }
}

/// Pitch figures of the whole ring as they were made.
struct TruePitch
{
    double single = 0, total = 0;
};
TruePitch true_pitch(std::vector<FlankErrors> const& side)
{
    TruePitch truth;
    double low = side.front().position, high = low;
    for (std::size_t k = 0; k < side.size(); ++k) {
        truth.single = std::max(truth.single, std::abs(side[(k + 1) % side.size()].position - side[k].position));
        low = std::min(low, side[k].position);
        high = std::max(high, side[k].position);
    }
    truth.total = high - low;
    return truth;
}

double nominal_thickness(MeasuredRing const& ring)
{
    FormulaFlank const flank;
    Vec2 const middle = flank.at(flank.length() / 2).where + Vec2(0, ring.pitch_radius());
    return 2 * std::atan2(middle.x(), middle.y()) * ring.reference_radius();
}

void check_flanks(Inspection const& found, MeasuredRing const& ring)
{
    REQUIRE(found.flanks.size() == 2 * ring.measured.size());
    for (FlankFigures const& flank : found.flanks) {
        auto const k = static_cast<std::size_t>(std::find(ring.measured.begin(), ring.measured.end(), flank.tooth - 1) -
                                                ring.measured.begin());
        FlankErrors const& made = (flank.right ? ring.right : ring.left)[k];
        CHECK(std::abs(flank.slope.value - made.slope) < exact);
        CHECK(std::abs(flank.crowning.value - made.crowning) < exact);
        if (ring.strays > 0)
            continue;  // these figures are of the points that are left
        CHECK(std::abs(flank.form.value - made.form_range) < exact);
        CHECK(std::abs(flank.total.value - made.total) < exact);
    }
    for (ToothFigures const& tooth : found.teeth) {
        auto const k = static_cast<std::size_t>(std::find(ring.measured.begin(), ring.measured.end(), tooth.tooth - 1) -
                                                ring.measured.begin());
        double const made = nominal_thickness(ring) + ring.right[k].position - ring.left[k].position;
        CHECK(std::abs(tooth.thickness.value - made) < exact);
    }
}

void check_pitch(Inspection const& found, MeasuredRing const& ring)
{
    REQUIRE(found.sides.size() == 2);
    for (SideFigures const& side : found.sides) {
        TruePitch const made = true_pitch(side.right ? ring.right : ring.left);
        CHECK(side.pitches == ring.measured.size());
        CHECK(std::abs(side.single_pitch.value - made.single) < exact);
        CHECK(std::abs(side.total_pitch.value - made.total) < exact);
    }
}

}  // namespace

TEST_CASE("slope, crowning, form, pitch and thickness of a ring without noise come back", "[inspect]")
{
    int const kinds = 4;
    for (int i = 0; i < rings_of_kind(6) * kinds; ++i) {
        designs::Draws draws(1000 + static_cast<std::uint64_t>(i));
        MeasuredRing ring;
        ring.teeth = small_ring;
        ring.points = draws.whole(12, 30);
        ring.missing = i % kinds == 1 ? 0.3 : 0;
        ring.shuffled = i % kinds != 0;
        ring.probe = i % kinds == 2 ? 0.04 : i % kinds == 3 ? -0.03 : 0;
        give_errors(ring, draws, 1e-3);
        bool const turned = i % 2 == 1;
        ring.turn = turned ? draws.between(-0.4, 0.4) * 2 * std::numbers::pi / ring.teeth : 0;
        CAPTURE(i, ring.points, ring.turn, ring.probe);
        Inspection const found = inspected(ring, draws, turned ? Registration::turn : Registration::datum);
        check_flanks(found, ring);
        check_pitch(found, ring);
        CHECK(found.strays == 0);
        CHECK(found.beside == 0);
    }
}

TEST_CASE("points that stand off are left out, and the figures are exact without them", "[inspect]")
{
    for (int i = 0; i < rings_of_kind(12); ++i) {
        designs::Draws draws(2000 + static_cast<std::uint64_t>(i));
        MeasuredRing ring;
        ring.teeth = small_ring;
        ring.points = 20;
        ring.strays = draws.whole(1, 12);
        ring.shuffled = i % 2 == 0;
        ring.probe = i % 3 == 0 ? 0.03 : 0;
        give_errors(ring, draws, 0);
        CAPTURE(i, ring.strays);
        Inspection const found = inspected(ring, draws, Registration::datum);
        check_flanks(found, ring);
        check_pitch(found, ring);
        CHECK(found.strays > 0);
        CHECK(found.strays + found.beside <= static_cast<std::size_t>(ring.strays));
    }
}

TEST_CASE("an eccentric ring gives its eccentricity, runout, turn and shift back", "[inspect]")
{
    for (int i = 0; i < rings_of_kind(15); ++i) {
        designs::Draws draws(3000 + static_cast<std::uint64_t>(i));
        MeasuredRing ring;
        ring.teeth = small_ring;
        ring.points = 15;
        ring.probe = i % 2 == 0 ? 0 : draws.between(-0.03, 0.04);
        ring.shift = draws.between(2e-3, 0.02) * direction(draws.between(-3, 3));
        ring.shuffled = true;
        FlankErrors const same{0, draws.between(-2e-3, 2e-3), draws.between(-2e-3, 2e-3), 0};
        ring.left.assign(small_ring, same);
        ring.right.assign(small_ring, same);
        CAPTURE(i, ring.shift.x(), ring.shift.y());
        Inspection const raw = inspected(ring, draws, Registration::datum);
        REQUIRE(raw.planes.size() == 1);
        PlaneFigures const& plane = raw.planes.front();
        REQUIRE(plane.circle);
        CHECK(std::abs(plane.eccentricity.value - ring.shift.norm()) < exact);
        CHECK(std::abs(plane.direction - std::atan2(ring.shift.x(), ring.shift.y())) < 1e-6);
        double low = 1, high = -1;
        for (int k = 0; k < ring.teeth; ++k) {
            double const angle = k * 2 * std::numbers::pi / ring.teeth;
            double const outward = ring.shift.dot(Vec2(std::sin(angle), std::cos(angle)));
            low = std::min(low, outward);
            high = std::max(high, outward);
        }
        CHECK(std::abs(plane.runout.value - (high - low)) < exact);

        // a perfect part gives turn and shift to either registration of both
        ring.left.assign(small_ring, {});
        ring.right.assign(small_ring, {});
        ring.turn = draws.between(-0.3, 0.3) * 2 * std::numbers::pi / ring.teeth;
        for (auto const registration : {Registration::least_squares, Registration::minimum_zone}) {
            Inspection const found = inspected(ring, draws, registration);
            CHECK(std::abs(found.placement.shift_x.value - ring.shift.x()) < exact);
            CHECK(std::abs(found.placement.shift_y.value - ring.shift.y()) < exact);
            CHECK(std::abs(found.placement.turn.value - ring.turn) * ring.pitch_radius() < exact);
            CHECK(found.placement.rms < exact);
        }
    }
}

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

TEST_CASE("the intervals of a noisy ring hold the figures of the same ring without noise", "[inspect]")
{
    int held = 0, all = 0, held_extremes = 0, extremes = 0;
    auto const count = [](Uncertain const& found, double truth, int& in, int& of) {
        in += std::abs(found.value - truth) <= found.error ? 1 : 0;
        ++of;
    };
    for (int i = 0; i < 2 * rings_of_kind(12); ++i) {
        designs::Draws draws(4000 + static_cast<std::uint64_t>(i));
        MeasuredRing ring;
        ring.teeth = small_ring;
        ring.points = 16;
        ring.noise = draws.between(1e-4, 6e-4);
        ring.probe = i % 2 == 0 ? 0 : 0.03;
        give_errors(ring, draws, 0);
        ring.turn = draws.between(-0.2, 0.2) * 2 * std::numbers::pi / ring.teeth;
        Inspection const found = inspected(ring, draws, Registration::turn);
        REQUIRE(found.flanks.size() == 2 * small_ring);
        CHECK(std::abs(found.noise - ring.noise) < 0.15 * ring.noise);
        for (FlankFigures const& flank : found.flanks) {
            FlankErrors const& made = (flank.right ? ring.right : ring.left)[static_cast<std::size_t>(flank.tooth - 1)];
            count(flank.slope, made.slope, held, all);
            count(flank.crowning, made.crowning, held, all);
            count(flank.form, 0, held_extremes, extremes);
            count(flank.total, made.total, held_extremes, extremes);
        }
        for (ToothFigures const& tooth : found.teeth) {
            auto const k = static_cast<std::size_t>(tooth.tooth - 1);
            count(tooth.thickness, nominal_thickness(ring) + ring.right[k].position - ring.left[k].position, held, all);
        }
        for (SideFigures const& side : found.sides) {
            TruePitch const made = true_pitch(side.right ? ring.right : ring.left);
            count(side.single_pitch, made.single, held_extremes, extremes);
            count(side.total_pitch, made.total, held_extremes, extremes);
        }
    }
    double const share = static_cast<double>(held) / all,
                 share_of_extremes = static_cast<double>(held_extremes) / extremes;
    CAPTURE(held, all, held_extremes, extremes);
    CHECK(std::abs(share - 0.95) <= 0.03);
    CHECK(share_of_extremes >= 0.92);
}

}  // namespace hdconj::test::inspect_rings_cases
