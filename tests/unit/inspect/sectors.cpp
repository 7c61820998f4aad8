// SPDX-License-Identifier: GPL-3.0-or-later
// Adjacent teeth keep the errors that they have in common, whatever the registration shifts.
#include <cmath>
#include <numeric>
#include <string>

#include "hdconj/inspect.hpp"
#include "hdconj/read_scene.hpp"
#include "support/catch.hpp"
#include "support/measured_ring.hpp"
#include "support/run/full_run.hpp"

namespace hdconj::test::sectors_cases {
namespace {

constexpr double excess = 0.020;  // of the thickness
constexpr FlankErrors of_left{-excess / 2, 3e-3, -2e-3, 0}, of_right{excess / 2, -1e-3, 4e-3, 0};

MeasuredRing sector(int teeth, int points)
{
    MeasuredRing ring;
    ring.measured.resize(static_cast<std::size_t>(teeth));
    std::iota(ring.measured.begin(), ring.measured.end(), 0);
    ring.points = points;
    ring.left.assign(ring.measured.size(), of_left);
    ring.right.assign(ring.measured.size(), of_right);
    ring.turn = 2e-3;
    ring.shift = Vec2(0.004, -0.003);
    return ring;
}

double nominal_thickness(MeasuredRing const& ring)
{
    FormulaFlank const flank;
    Vec2 const middle = flank.at(flank.length() / 2).where + Vec2(0, ring.pitch_radius());
    return 2 * std::atan2(middle.x(), middle.y()) * ring.reference_radius();
}

}  // namespace

TEST_CASE("the shift of adjacent teeth takes up nothing that they have in common", "[inspect]")
{
    for (int const teeth : {1, 2, 5, 14, 60, 200}) {
        MeasuredRing ring = sector(teeth, 12);
        designs::Draws draws(3);
        Inspection const found = inspected(ring, draws, Registration::least_squares);
        CAPTURE(teeth);
        constexpr double rounding = 1e-4;  // second powers of the errors: 0.1 um of 20
        REQUIRE(found.planes.size() == 1);
        CHECK(std::abs(found.planes[0].thickness.value - nominal_thickness(ring) - excess) < rounding);
        for (SideFigures const& side : found.sides) {
            FlankErrors const& made = side.right ? of_right : of_left;
            CHECK(std::abs(side.slope.value - made.slope) < rounding);
            CHECK(std::abs(side.crowning.value - made.crowning) < rounding);
        }
    }
}

TEST_CASE("the intervals of adjacent teeth hold what they were made with", "[inspect]")
{
    constexpr int rings = 60;
    for (int const teeth : {1, 2, 4, 14}) {
        int held = 0, all = 0;
        auto const count = [&](Uncertain const& figure, double truth) {
            held += std::abs(figure.value - truth) <= figure.error ? 1 : 0;
            ++all;
        };
        for (int i = 0; i < rings; ++i) {
            MeasuredRing ring = sector(teeth, 12);
            ring.noise = 3e-4;
            designs::Draws draws(9000 + static_cast<std::uint64_t>(i));
            Inspection const found = inspected(ring, draws, Registration::least_squares);
            count(found.planes[0].thickness, nominal_thickness(ring) + excess);
            for (SideFigures const& side : found.sides) {
                count(side.slope, (side.right ? of_right : of_left).slope);
                count(side.crowning, (side.right ? of_right : of_left).crowning);
            }
        }
        CAPTURE(teeth, held, all);
        CHECK(held >= 0.91 * all);
        CHECK(held < all);
    }
}

namespace {

/// What a note says that the places of teeth make of a figure [mm]; 0 where it says nothing.
double told(Inspection const& found, std::string const& figure)
{
    for (std::string const& note : found.notes)
        if (note.find("the places of single teeth") != std::string::npos)
            if (auto const at = note.find(" " + figure + " +- "); at != std::string::npos)
                return std::stod(note.substr(at + figure.size() + 5)) / 1e3;
    return 0;
}

/// Adjacent teeth that stand off their places by @p scatter, both flanks or the right ones.
Inspection scattered_teeth(int teeth, bool both, double scatter, std::uint64_t seed)
{
    MeasuredRing ring = sector(teeth, 12);
    ring.noise = 2e-4;
    designs::Draws draws(seed);
    for (std::size_t k = 0; k < ring.measured.size(); ++k) {
        double const place = scatter * normal(draws);
        ring.left[k].position += place;
        ring.right[k].position += place;
    }
    PointFile file = points_of(ring, draws);
    std::size_t i = 0;
    std::erase_if(file.points, [&](PartPoint const&) { return !both && i++ / 12 % 2 == 0; });
    return inspect_points(scene_of(ring), file, {});
}

}  // namespace

TEST_CASE("what a sector's shift has of the places of single teeth is told", "[inspect]")
{
    int const rings = full_run() ? 200 : 30;
    auto const both = GENERATE(true, false);
    auto const teeth = GENERATE(8, 16);
    int held = 0, all = 0, exceeded = 0, without_cause = 0;
    for (int i = 0; i < rings; ++i) {
        auto const seed = 400 + static_cast<std::uint64_t>(i);
        Inspection const found = scattered_teeth(teeth, both, 1e-3, seed);
        auto const count = [&](Uncertain const& figure, double truth, std::string const& name) {
            double const off = std::abs(figure.value - truth);
            exceeded += off > figure.error ? 1 : 0;
            held += off <= std::max(figure.error, told(found, name)) ? 1 : 0;
            ++all;
        };
        for (SideFigures const& side : found.sides)
            count(side.slope, (side.right ? of_right : of_left).slope, "slope");
        for (PlaneFigures const& plane : found.planes)
            count(plane.thickness, nominal_thickness(sector(teeth, 12)) + excess, "thickness");
        count(found.placement.shift_x, 0.004, "shift");
        CHECK(told(found, "shift") > 0);
        without_cause += told(scattered_teeth(teeth, both, 0, seed), "shift") > 0 ? 1 : 0;
    }
    CAPTURE(teeth, both, held, all, without_cause);
    CHECK(held >= 0.8 * all);  // of 95, by few rings: a ring's figures err together
    CHECK(exceeded > 0.25 * all);
    CHECK(without_cause <= 0.1 * rings);
}

TEST_CASE("the places of a whole ring's teeth change none of its means", "[inspect]")
{
    Inspection const found = scattered_teeth(200, true, 3e-3, 1);
    CHECK(told(found, "shift") == 0);
    for (SideFigures const& side : found.sides)
        CHECK(std::abs(side.slope.value - (side.right ? of_right : of_left).slope) < 2 * side.slope.error);
}

TEST_CASE("one flank alone does not fix a shift", "[inspect]")
{
    MeasuredRing ring = sector(1, 12);
    designs::Draws draws(3);
    PointFile file = points_of(ring, draws);
    std::erase_if(file.points, [](PartPoint const& point) { return point.line < 14; });
    CHECK_THROWS_WITH(inspect_points(scene_of(ring), file, {}), ContainsSubstring("do not determine the position"));
}

TEST_CASE("a ring of another number of teeth is refused", "[inspect]")
{
    for (int const teeth : {198, 199, 201, 202}) {
        MeasuredRing ring;
        ring.teeth = teeth;
        designs::Draws draws(3);
        PointFile const file = points_of(ring, draws);
        CAPTURE(teeth);
        CHECK_THROWS_WITH(inspect_points(scene_of(MeasuredRing{}), file, {}),
                          ContainsSubstring("another number of teeth than 200"));
    }
}

}  // namespace hdconj::test::sectors_cases
