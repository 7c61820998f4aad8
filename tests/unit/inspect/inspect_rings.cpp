// SPDX-License-Identifier: GPL-3.0-or-later
// Rings whose errors are known: without noise each figure comes back, with noise its interval holds it.
#include <array>
#include <cmath>
#include <numbers>
#include <set>

#include "hdconj/inspect.hpp"
#include "hdconj/read_scene.hpp"
#include "support/catch.hpp"
#include "support/measured_ring.hpp"
#include "support/run/full_run.hpp"

namespace hdconj::test::inspect_rings_cases {

namespace {

constexpr int small_ring = 60;

/// Rings of each kind: few, or with HDCONJ_FULL all of them.
int rings_of_kind(int full)
{
    return full_run() ? full : 2;
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

TEST_CASE("planes of one file have their own figures, whatever the order of the points", "[inspect]")
{
    std::vector<double> const heights{-3, 0.5, 2.75};
    std::vector<MeasuredRing> rings;
    PointFile file{"planes", {}, true};
    designs::Draws draws(1500);
    for (double const z : heights) {
        MeasuredRing& ring = rings.emplace_back();
        ring.teeth = small_ring;
        ring.points = 14;
        give_errors(ring, draws, 1e-3);
        for (PartPoint point : points_of(ring, draws).points) {
            point.z = z + draws.between(-1e-4, 1e-4);  // as a machine holds it
            file.points.push_back(point);
        }
    }
    for (std::size_t i = file.points.size(); i-- > 1;)
        std::swap(file.points[i], file.points[static_cast<std::size_t>(draws.whole(0, static_cast<int>(i)))]);
    InspectOptions options{InspectedPart::flexspline, std::nullopt, 0, Registration::datum};
    Inspection const all = inspect_points(scene_of(rings[0]), file, options);
    REQUIRE(all.nominal.size() == heights.size());
    for (std::size_t k = 0; k < heights.size(); ++k) {
        CAPTURE(heights[k]);
        auto const elsewhere = [&](auto const& each) { return std::abs(each.z - heights[k]) > 1e-3; };
        Inspection of_plane = all;
        std::erase_if(of_plane.flanks, elsewhere);
        std::erase_if(of_plane.teeth, elsewhere);
        std::erase_if(of_plane.sides, elsewhere);
        check_flanks(of_plane, rings[k]);
        check_pitch(of_plane, rings[k]);
        options.plane = heights[k];
        Inspection const alone = inspect_points(scene_of(rings[k]), file, options);
        CHECK(alone.nominal.size() == 1);
        check_flanks(alone, rings[k]);
        check_pitch(alone, rings[k]);
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

TEST_CASE("few points on each flank tell the noise as well as many", "[inspect]")
{
    constexpr int rings = 12;
    for (int const points : {4, 5, 8, 25}) {
        double mean = 0;
        for (int i = 0; i < rings; ++i) {
            designs::Draws draws(5000 + static_cast<std::uint64_t>(i));
            MeasuredRing ring;
            ring.teeth = small_ring;
            ring.points = points;
            ring.noise = 5e-4;
            give_errors(ring, draws, 0);
            mean += inspected(ring, draws, Registration::turn).noise / ring.noise / rings;
        }
        CAPTURE(points);
        CHECK(std::abs(mean - 1) < 0.05);
    }
}

TEST_CASE("the interval of the eccentricity of a concentric ring holds zero", "[inspect]")
{
    constexpr int rings = 120;
    int held = 0;
    for (int i = 0; i < rings; ++i) {
        designs::Draws draws(6000 + static_cast<std::uint64_t>(i));
        MeasuredRing ring;
        ring.teeth = small_ring;
        for (int k = 0; k < small_ring; k += 3)
            ring.measured.push_back(k);
        ring.points = 10;
        ring.noise = 5e-4;
        Uncertain const found = inspected(ring, draws, Registration::turn).planes[0].eccentricity;
        held += found.value <= found.error ? 1 : 0;
    }
    CAPTURE(held);
    CHECK(held >= 0.92 * rings);
}

TEST_CASE("a single tooth is registered in the minimum zone", "[inspect]")
{
    for (int i = 0; i < 12; ++i) {
        MeasuredRing ring;
        ring.measured = {0};
        ring.points = 20;
        ring.noise = 3e-4;
        auto const largest = [&](Registration registration) {
            designs::Draws draws(8000 + static_cast<std::uint64_t>(i));
            double most = 0;
            for (PointDeviation const& each : inspected(ring, draws, registration).points)
                if (each.fate != PointFate::beside)
                    most = std::max(most, std::abs(each.deviation));
            return most;
        };
        CHECK(largest(Registration::minimum_zone) <= largest(Registration::least_squares));
    }
}

TEST_CASE("the intervals of the largest form and total deviation hold the largest true ones", "[inspect]")
{
    constexpr int rings = 200, kinds = 4;
    std::array<int, kinds> held{}, all{};
    for (int i = 0; i < rings; ++i) {
        designs::Draws draws(6000 + static_cast<std::uint64_t>(i));
        MeasuredRing ring;
        ring.teeth = small_ring;
        for (int tooth = 0; tooth < small_ring; tooth += 3)
            ring.measured.push_back(tooth);
        ring.points = 8 + i % 3 * 4;
        auto const kind = static_cast<std::size_t>(i % kinds);
        auto const count = [&](Uncertain const& figure, double truth) {
            held[kind] += std::abs(figure.value - truth) <= figure.error ? 1 : 0;
            ++all[kind];
        };
        // in turn a perfect ring, one worst flank, and flanks that are all bad
        bool const errors = kind > 1;
        give_errors(ring, draws, errors ? 2e-3 : 0);
        if (!errors) {
            ring.left.assign(ring.measured.size(), {});
            ring.right = ring.left;
            ring.left[2].slope = kind == 1 ? 5e-3 : 0;
        }
        ring.noise = 1e-3;
        Inspection const found = inspected(ring, draws, Registration::datum);
        REQUIRE(found.sides.size() == 2);
        for (SideFigures const& side : found.sides) {
            double form = 0, total = 0;
            for (FlankErrors const& made : side.right ? ring.right : ring.left) {
                form = std::max(form, made.form_range);
                total = std::max(total, made.total);
            }
            count(side.form, form);
            count(side.total, total);
        }
    }
    for (std::size_t kind = 0; kind < kinds; ++kind) {
        CAPTURE(kind, held[kind], all[kind]);
        CHECK(held[kind] >= 0.95 * all[kind]);
    }
}

}  // namespace hdconj::test::inspect_rings_cases
