// SPDX-License-Identifier: GPL-3.0-or-later
#include <numbers>

#include "hdconj/profile/polynomial_curve.hpp"
#include "hdconj/profile/profile.hpp"
#include "profile/cusp.hpp"
#include "support/catch.hpp"

namespace hdconj::test::profile_curves_cases {

namespace {

profile::CurveJet circle(double angle)
{
    return {0.3 * direction(angle), 0.3 * left_of(direction(angle))};
}

/// Angle of the outward normal at either end of a piece.
double normal_angle(profile::PieceEnd const& end)
{
    return std::atan2(end.normal.y(), end.normal.x());
}

}  // namespace

TEST_CASE("polynomial pieces of a circle lie on it and join without a step or a bend", "[profile][curve]")
{
    for (double sweep : {1e-6, 0.2, 1.5, 6.0}) {
        INFO("sweep " << sweep);
        auto const pieces = profile::polynomial_curve(circle, 1.2, 1.2 - sweep, 1e-15);
        double worst = 0;
        double bend = 0;
        for (profile::CurvePiece const& piece : pieces)
            for (int i = 0; i <= 100; ++i) {
                Vec2 const p = piece.point(0.01 * i);
                worst = std::max(worst, std::abs(p.norm() - 0.3));
                bend = std::max(bend, std::abs(piece.first(0.01 * i).normalized().dot(p.normalized())));
            }
        CHECK(worst < 1e-15);
        // a direction cannot be better than the rounding of the points that it leads through
        CHECK(bend < std::max(1e-13, 1e-14 / sweep));
        for (std::size_t i = 0; i + 1 < pieces.size(); ++i) {
            CHECK(pieces[i].point(1) == pieces[i + 1].point(0));
            CHECK((pieces[i].first(1).normalized() - pieces[i + 1].first(0).normalized()).norm() < 1e-14);
        }
        CHECK(pieces.front().point(0) == circle(1.2).point);
        CHECK(pieces.back().point(1) == circle(1.2 - sweep).point);
    }
}

TEST_CASE("the error of a polynomial piece falls with the tenth power of its interval", "[profile][curve]")
{
    auto const error = [](double sweep) {
        profile::CurvePiece const piece = profile::hermite_interpolant(circle, 0.0, sweep);
        double worst = 0;
        for (int i = 1; i < 200; ++i)
            worst = std::max(worst, (piece.point(0.005 * i) - circle(0.005 * i * sweep).point).norm());
        return worst;
    };
    double const order = std::log2(error(3.0) / error(1.5));
    CHECK(order > 9.5);
    CHECK(order < 10.5);
}

TEST_CASE("a curve with a bend is refused, not approximated", "[profile][curve]")
{
    auto const bent = [](double s) { return profile::CurveJet{{std::abs(s), s}, {s < 0 ? -1.0 : 1.0, 1}}; };
    CHECK_THROWS_AS(profile::polynomial_curve(bent, -0.3, 0.7, 1e-12), NumericalError);
}

TEST_CASE("the arc onto a line is tangent to what it joins", "[profile][curve]")
{
    profile::FlankPoint const from{{0.2, 0.1}, 0.3};
    double const line_normal = 0.1;
    Vec2 const on_line = from.point + 1e-3 * right_of(direction(0.25));
    profile::ArcPiece const arc = profile::arc_onto_line(from, on_line, line_normal);
    CHECK(arc.radius > 0);
    CHECK((start_of(arc).point - from.point).norm() < 1e-16);
    CHECK(normal_angle(start_of(arc)) == Approx(from.normal));
    CHECK(std::abs(direction(line_normal).dot(end_of(arc).point - on_line)) < 1e-16);
}

TEST_CASE("two arcs join two points with their tangents", "[profile][curve]")
{
    // the two sides of a cusp of x = c y^1.5: normals 1.5 x/y
    for (double unequal : {1.0, 0.7, 1.3}) {
        double const y = 1e-6;
        double const x = 1e-8;
        profile::FlankPoint const a{{0.2 - x, 0.1 + y}, 1.5 * x / y};
        profile::FlankPoint const b{{0.2 + unequal * x, 0.1 - y}, 1.5 * unequal * x / y};
        profile::TwoArcs const arcs = profile::two_arcs(a, b);
        CHECK(arcs.convex.radius > 0);
        CHECK(arcs.concave.radius < 0);
        CHECK(arcs.convex.to < std::min(a.normal, b.normal));
        CHECK((start_of(arcs.convex).point - a.point).norm() < 1e-16);
        CHECK((end_of(arcs.concave).point - b.point).norm() < 1e-16);
        CHECK((end_of(arcs.convex).point - start_of(arcs.concave).point).norm() < 1e-16);
        CHECK(arcs.convex.from == a.normal);
        CHECK(arcs.concave.to == b.normal);
        CHECK(arcs.convex.to == arcs.concave.from);
    }
    // nothing to bend: no arcs
    CHECK(profile::two_arcs({{0, 0}, 0.1}, {{0.2, -1}, 0.1}).convex.radius == 0);
}

}  // namespace hdconj::test::profile_curves_cases
