// SPDX-License-Identifier: GPL-3.0-or-later
// Contours that a control offsets, and the path that it makes of them.
#include <cmath>
#include <numbers>

#include "hdconj/error.hpp"
#include "support/catch.hpp"
#include "support/sample_wire_program.hpp"
#include "wedm/posts/control_offset.hpp"

namespace hdconj::test::control_offset_cases {

namespace {

constexpr double rounding = 1e-12;  // of a few operations at some millimetres

std::vector<Vec2> wire_of(WirePass const& pass)
{
    std::vector<Vec2> wire;
    for (std::size_t i = 1; i + 1 < pass.moves.size(); ++i)
        wire.push_back(pass.moves[i].lower);
    return wire;
}

/// A pass around a square of half width @p half from outside, which rolls about its corners in @p chords chords.
WirePass around_square(double half, double offset, int chords)
{
    WirePass pass;
    pass.offset = offset;
    Vec2 const start(0, -half - 3);
    auto const add = [&](Vec2 const& p, WireTag tag) { pass.moves.push_back({p, p, tag, -1}); };
    add(start, WireTag::thread);
    add({0, -half - offset}, WireTag::lead_in);
    for (int corner = 0; corner < 4; ++corner) {
        double const from = -std::numbers::pi / 2 * (corner + 1);
        Vec2 const at = half * std::numbers::sqrt2 * direction(from - std::numbers::pi / 4);
        for (int i = 0; i <= chords; ++i) {
            double const angle = from - std::numbers::pi / 2 * i / chords;
            add(at + offset * Vec2(std::cos(angle), std::sin(angle)), WireTag::contour);
        }
    }
    add({0, -half - offset}, WireTag::contour);
    add(start, WireTag::lead_out);
    return pass;
}

}  // namespace

TEST_CASE("the contour for a control inside a square is the square, entered along a line past the start hole", "[wire]")
{
    auto const program = sample::square_hole(0);
    auto const& pass = program.passes.front();
    auto const contour = wedm::offset_contour(pass, 0.001, 0);
    REQUIRE(contour.points.size() == pass.moves.size() + 2);
    CHECK(contour.points.front() == Vec2(0, 0));
    // the way in keeps the offset from the wire's first point: its end lies tan(asin(d/l)) l before the middle, and d
    // beyond the line there
    double const d = 0.062, l = 4.938, lean = std::asin(d / l);
    CHECK((contour.points[2] - Vec2(-5 * std::tan(lean), -5)).norm() < rounding);
    CHECK((contour.points[1] - 0.5 * contour.points[2]).norm() < rounding);
    Vec2 const corners[] = {{5, -5}, {5, 5}, {-5, 5}, {-5, -5}};
    for (std::size_t i = 0; i < 4; ++i)
        CHECK((contour.points[3 + i] - corners[i]).norm() < rounding);
    CHECK((contour.points[7] - Vec2(5 * std::tan(lean), -5)).norm() < rounding);
    CHECK(contour.deviation == 0);
    auto const made = wedm::path_of_control(contour.points, d, true, 1e-6);
    CHECK(wedm::distance_of_lines(made, wire_of(pass)) < rounding);
}

TEST_CASE("moves that roll around a corner become that corner to half a chord", "[wire]")
{
    for (int const chords : {1, 2, 7, 40}) {
        INFO(chords << " chords");
        WirePass const pass = around_square(2, 0.1, chords);
        double const chord = 0.1 * (1 - std::cos(std::numbers::pi / 4 / chords));
        auto const contour = wedm::offset_contour(pass, 0.002, chord);
        REQUIRE(contour.points.size() == 4 + 4 + 2);
        // half as deep in the part as the wire's moves, which are chords
        for (std::size_t i = 3; i < 7; ++i)
            CHECK((contour.points[i].cwiseAbs() - Vec2(2, 2)).norm() == Approx(chord / 2).epsilon(1e-3));
        auto const made = wedm::path_of_control(contour.points, 0.1, true, 1e-7);
        CHECK(contour.deviation < 0.7 * chord);
        CHECK(wedm::distance_of_lines(made, wire_of(pass)) <= 1.01 * contour.deviation);
    }
}

TEST_CASE("a control makes the wire's path again of the contours of a toothed ring, either way round", "[wire]")
{
    auto const program = sample::wire_ring(0);
    for (auto const& pass : program.passes) {
        auto const contour = wedm::offset_contour(pass, 0.002, 0);
        auto const made = wedm::path_of_control(contour.points, pass.offset, !pass.reversed, 1e-6);
        // where the wire rolls, an arc about a corner replaces the wire's own: d (1/cos(a/2) - 1) for a turn by a
        CHECK(wedm::distance_of_lines(made, wire_of(pass)) <= contour.deviation + 1e-6);
        CHECK(contour.deviation < 2e-4);
        REQUIRE(contour.stops.size() == (pass.number == 1 ? 1 : 0));
        for (auto const at : contour.stops) {
            auto const stop = std::ranges::find(pass.moves, WireTag::stop, &WireMove::tag);
            CHECK((contour.points[at] - stop->lower).norm() == Approx(pass.offset).epsilon(1e-3));
        }
    }
}

TEST_CASE("what a control cannot follow is refused: corners sharper than the wire, and a way in without room", "[wire]")
{
    // a slot that is narrower than the wire
    std::vector<Vec2> const slot{{0, 0},        {0, -2.5},  {0, -5}, {1, -5},   {1, -5.05},
                                 {1.05, -5.05}, {1.05, -5}, {2, -5}, {1, -2.5}, {0, 0}};
    CHECK_THROWS_AS(wedm::path_of_control(slot, 0.056, true, 1e-6), NumericalError);
    auto pass = sample::square_hole(0).passes.front();
    pass.moves.front().lower = pass.moves.back().lower = Vec2(0, -4.88);
    try {
        (void)wedm::offset_contour(pass, 0.001, 0);
        FAIL("not refused");
    } catch (NumericalError const& error) {
        CHECK(error.code() == ErrorCode::no_room);
        CHECK_THAT(error.what(), ContainsSubstring("a larger wedm.lead_in"));
    }
}

}  // namespace hdconj::test::control_offset_cases
