// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// What teeth give way by in themselves, and edges that are round.
#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <cmath>
#include <numbers>

#include "load/hertz.hpp"
#include "load/local_compliance.hpp"
#include "load/round_edges.hpp"
#include "load/tooth_bending.hpp"
#include "support/catch.hpp"

namespace hdconj::test::local_compliance_cases {

namespace {

using std::numbers::pi;
constexpr elastic::Elasticity steel{206e3, 0.3};

/// A tooth with straight flanks from y = 1 to y = 1 + height.
profile::Profile trapezium(double foot, double tip, double height)
{
    profile::Profile tooth;
    tooth.pitch_line = 1;
    tooth.addendum = height;
    Vec2 const points[] = {{-foot / 2, 1}, {-tip / 2, 1 + height}, {tip / 2, 1 + height}, {foot / 2, 1}};
    for (int i = 0; i < 3; ++i)
        tooth.pieces.push_back({profile::LinePiece{points[i], points[i + 1]}, i, 0, 1, false});
    return tooth;
}

/// Deflection at height h under one N/mm at height k by integrating the beam: curvature and shear angle to slope, slope
/// to deflection.
double beam(double foot, double tip, double height, double h, double k)
{
    constexpr int parts = 40000;
    double const plane = load::plane_strain_modulus(steel),
                 shear_modulus = steel.youngs_modulus / (2 * (1 + steel.poissons_ratio));
    double const step = h / parts;
    double slope = 0, deflection = 0;
    for (int i = 0; i < parts; ++i) {
        double const y = (i + 0.5) * step;
        double const s = foot + (tip - foot) * y / height;
        double const turned = y < k ? (k - y) / (plane * s * s * s / 12) * step : 0;
        deflection += (slope + turned / 2 + (y < k ? 1.2 / (shear_modulus * s) : 0)) * step;
        slope += turned;
    }
    return deflection;
}

}  // namespace

TEST_CASE("a tooth bends as a beam does", "[load]")
{
    // a rectangle in closed form: cantilever 4 h^3/(E' s^3) and shear 1.2 h/(G s)
    load::ToothBending const block(trapezium(0.4, 0.4, 0.5), steel, 1e-6);
    double const h = 0.5, s = 0.4;
    double const expected = 4 * h * h * h / (load::plane_strain_modulus(steel) * s * s * s) +
                            2.4 * (1 + steel.poissons_ratio) * h / (steel.youngs_modulus * s);
    CHECK(block(1 + h, 1 + h) == Approx(expected).epsilon(1e-12));
    // a tooth that becomes thinner, load and deflection at different heights: by another path, and the other way round
    load::ToothBending const tooth(trapezium(0.5, 0.2, 0.6), steel, 1e-6);
    for (double const at : {0.1, 0.33, 0.6})
        for (double const load : {0.15, 0.4, 0.6}) {
            CAPTURE(at, load);
            CHECK(tooth(1 + at, 1 + load) == Approx(beam(0.5, 0.2, 0.6, at, load)).epsilon(1e-3));
            CHECK(tooth(1 + at, 1 + load) == Approx(tooth(1 + load, 1 + at)).epsilon(1e-14));
        }
    CHECK(tooth(0.9, 1.3) == 0);
    CHECK(tooth(2.0, 2.0) == tooth(1.6, 1.6));
    CHECK(load::ToothBending()(1, 1) == 0);
}

TEST_CASE("a strip gives way beside itself as a half-plane under a line load does", "[load]")
{
    load::LineContact const c{steel, steel, 5, 0.2};
    double const own = load::approach(c, 30) / 30, a = load::half_width(c, 30);
    // strips that meet are one
    CHECK(approach_beside(c, 0, a) == Approx(own).epsilon(1e-3));
    CHECK(approach_beside(c, 0, a) <= own);
    double last = own;
    for (double const x : {0.01, 0.03, 0.08, 0.15}) {
        // strain along the depth under Flamant's stresses, from the surface to the depth
        constexpr int parts = 20000;
        double sum = 0;
        double const e = steel.youngs_modulus, nu = steel.poissons_ratio;
        for (int i = 0; i < parts; ++i) {
            double const z = (i + 0.5) * c.depth / parts, r2 = x * x + z * z;
            double const along = 2 * z * z * z / (pi * r2 * r2), across = 2 * x * x * z / (pi * r2 * r2);
            sum += ((1 - nu * nu) / e * along - nu * (1 + nu) / e * across) * c.depth / parts;
        }
        CAPTURE(x);
        CHECK(approach_beside(c, x, a) == Approx(2 * sum).epsilon(1e-6));
        CHECK(approach_beside(c, x, a) < last);
        last = load::approach_beside(c, x, a);
    }
    CHECK(approach_beside(c, 10, a) >= 0);
}

TEST_CASE("a strip that flows gives way along the tangent of its law, one that does not along the secant", "[load]")
{
    load::ElasticDrive drive;
    drive.flexspline = drive.circular_spline = steel;
    drive.contact_depth = 0.2;
    drive.slice_width = {0.7};
    drive.flow_pressure = 2000;
    load::FlankContact strip;
    strip.curvature = 5;
    load::LineContact const line = drive.line_contact(strip);
    for (double const q : {1.0, 50.0, 200.0, 1000.0, 5000.0}) {
        CAPTURE(q);
        double const force = q * drive.slice_width.front(), more = 1e-4 * q;
        load::LocalCompliance const c = load::local_compliance(drive, {strip}, {force});
        CHECK(c({force}).front() == Approx(load::approach(line, q)).epsilon(1e-12));
        CHECK((c.offset.front() < 0) == load::flows(line, q));
        double const slope = (load::indentation(line, q + more) - load::indentation(line, q - more)) / (2 * more);
        CHECK(load::indentation_slope(line, q) == Approx(slope).epsilon(1e-6));
    }
    CHECK(load::flows(line, 5000));
    CHECK_FALSE(load::flows(line, 1));
}

TEST_CASE("strips of one flank give way as a body does, however close they are", "[load]")
{
    // forces on a body do work, whatever they are: the matrix of its compliance is positive definite
    constexpr double force = 100;
    load::ElasticDrive drive;
    drive.flexspline = drive.circular_spline = steel;
    drive.contact_depth = 0.2;
    drive.slice_width = {1};
    load::FlankContact strip;
    strip.curvature = 5;
    double const a = load::half_width(drive.line_contact(strip), force);
    for (int const count : {2, 3, 5})
        for (double const spacing : {0.01, 0.15, 0.25, 0.4, 2.0}) {
            CAPTURE(count, spacing);
            std::vector<load::FlankContact> strips;
            for (int i = 0; i < count; ++i) {
                strips.push_back(strip);
                strips.back().arc_length = 0.3 + i * spacing * a;
            }
            // a strip of another flank does not feel them
            strips.push_back(strip);
            strips.back().slice = 0;
            strips.back().flank = 1;
            load::LocalCompliance const c =
                load::local_compliance(drive, strips, std::vector<double>(strips.size(), force));
            double const alone = load::approach(drive.line_contact(strip), force) / force;
            CHECK(c.own.back() == Approx(alone).epsilon(1e-14));
            Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(count, count);
            for (int i = 0; i < count; ++i)
                matrix(i, i) = c.own[static_cast<std::size_t>(i)];
            for (auto const& [first, second, compliance] : c.couplings)
                matrix(static_cast<int>(first), static_cast<int>(second)) =
                    matrix(static_cast<int>(second), static_cast<int>(first)) = compliance;
            double const least =
                Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(matrix, Eigen::EigenvaluesOnly).eigenvalues().minCoeff();
            CHECK(least > 1e-7 * alone);
            CHECK(matrix.diagonal().maxCoeff() < 1.1 * alone);
            if (spacing == 2 || (count == 2 && spacing > 0.3))
                CHECK(matrix(0, 0) == Approx(alone).epsilon(1e-14));
        }
}

TEST_CASE("circles roll from the flank onto the land", "[load]")
{
    // straight flanks that lean by 20 degrees below a land at 25 mm, material on the right
    constexpr double land = 25, radius = 0.01, half_pitch = 0.016, lean = 20 * pi / 180;
    constexpr int points = 200;
    contact::FlankGrid grid;
    grid.z = {0};
    Vec2 const corner = land * Vec2(std::sin(0.014), std::cos(0.014)), along(-std::sin(lean), std::cos(lean)),
               normal(std::cos(lean), std::sin(lean));
    for (int i = 0; i < points; ++i) {
        grid.station.push_back(static_cast<double>(i) / (points - 1));
        for (int const flank : {0, 1}) {
            double const side = flank == 1 ? 1 : -1;
            auto const f = static_cast<std::size_t>(flank);
            grid.point[f].resize(1);
            grid.normal[f].resize(1);
            Vec2 const p = corner + 0.4 * grid.station.back() * along;
            grid.point[f][0].push_back({side * p.x(), p.y()});
            grid.normal[f][0].push_back({side * normal.x(), normal.y()});
        }
    }
    SECTION("a land with room for both edges")
    {
        contact::FlankGrid const round = load::with_round_edges(grid, radius, half_pitch);
        for (std::size_t const f : {std::size_t{0}, std::size_t{1}}) {
            CHECK(round.radius[f][0] == radius);
            Vec2 const c = round.point[f][0].front();
            // between two points of the grid the land is taken as straight
            double const spacing = 0.4 / (points - 1);
            CHECK(c.norm() == Approx(land + radius).margin(spacing * spacing / (8 * land)));
            Vec2 const foot = grid.point[f][0].front();
            CHECK((c - foot).dot(grid.normal[f][0].front()) == Approx(radius).epsilon(1e-9));
            CHECK(round.point[f][0].back() == Vec2(grid.point[f][0].back() + radius * grid.normal[f][0].back()));
            CHECK(round.point[f][0][1] == c);
        }
        CHECK(round.point[0][0].front().x() == Approx(-round.point[1][0].front().x()).epsilon(1e-14));
    }
    SECTION("a land that is too narrow: one circle in the middle of the tooth")
    {
        contact::FlankGrid const round = load::with_round_edges(grid, radius, 0.0141);
        Vec2 const c = round.point[1][0].front();
        CHECK(std::atan2(c.x(), c.y()) == Approx(0.0141).epsilon(1e-9));
        CHECK(c.norm() > land + radius);
        CHECK((c - grid.point[1][0].front()).dot(grid.normal[1][0].front()) == Approx(radius).epsilon(1e-9));
    }
    SECTION("a radius larger than the tooth is refused")
    {
        CHECK_THROWS_WITH(load::with_round_edges(grid, 5, half_pitch), ContainsSubstring("edge_radius"));
    }
}

}  // namespace hdconj::test::local_compliance_cases
