// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Cholesky>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "elastic/influence.hpp"
#include "elastic/swept_mesh.hpp"
#include "hdconj/error.hpp"
#include "support/catch.hpp"

namespace hdconj::test::elastic_solid_cases {

using Eigen::Index;

namespace {

using std::numbers::pi;
constexpr double w0 = 0.25;  // mm

/// Nodes of a mesh for which a place is given.
template <class F>
std::vector<int> nodes_where(elastic::SectionMesh const& mesh, F&& is)
{
    std::vector<int> found;
    for (std::size_t i = 0; i < mesh.nodes.size(); ++i)
        if (is(mesh.nodes[i]))
            found.push_back(static_cast<int>(i));
    return found;
}

/// What keeps a ring from shifting along and turning about its axis.
elastic::Supports against_rigid_motion()
{
    return {{0, elastic::Direction::axial, -1, 0}, {0, elastic::Direction::tangential, -1, 0}};
}

/// Stations on the inner surface from z = 5 to 13 every half millimetre.
std::vector<elastic::Station> tooth_band(elastic::SectionMesh const& mesh, double depth, elastic::Direction direction)
{
    std::vector<elastic::Station> stations;
    for (int i = 0; i <= 16; ++i)
        stations.push_back(wall_station(mesh, 5 + 0.5 * i, depth, direction));
    return stations;
}

/// Slope of the best line through values at equal steps.
double slope(Eigen::VectorXd const& values, double step)
{
    double top = 0, bottom = 0;
    double const middle = static_cast<double>(values.size() - 1) / 2;
    for (Index i = 0; i < values.size(); ++i) {
        double const x = static_cast<double>(i) - middle;
        top += x * values[i];
        bottom += x * x;
    }
    return top / bottom / step;
}

/// Coning of the linear case: u_r = w0 cos 2 phi on one circle of the inner surface.
double coning_deg(elastic::FourierSolid const& solid)
{
    auto stations = tooth_band(solid.mesh(), 0, elastic::Direction::radial);
    auto const c = influence(solid, {}, stations, {2}).compliance(0);
    Eigen::VectorXd const u = c.col(8) * (w0 / c(8, 8));
    return std::atan(slope(u, 0.5)) * 180 / pi;
}

}  // namespace

TEST_CASE("the cup answers line loads as the validated table says", "[elastic]")
{
    elastic::FourierSolid const solid(elastic::section_mesh({}));
    CHECK(solid.mesh().elements.size() == 40);
    CHECK(solid.unknowns() == 609);
    struct Row
    {
        int n;
        double w;       // mm per N/mm of arc at r = 24, z = 9
        double coning;  // 1/mm, du_r/dz over u_r there
    };
    std::array<Row, 11> const table{{{0, 6.954e-4, 0},
                                     {2, 1.1160e-1, .1168},
                                     {4, 1.2747e-2, .1163},
                                     {6, 3.3018e-3, .0905},
                                     {8, 1.3005e-3, .0529},
                                     {10, 6.420e-4, .0258},
                                     {16, 1.532e-4, .0022},
                                     {24, 5.068e-5, 0},
                                     {32, 2.584e-5, 0},
                                     {48, 1.240e-5, 0},
                                     {96, 6.454e-6, 0}}};
    std::vector<int> harmonics;
    for (Row const& row : table)
        harmonics.push_back(row.n);
    std::vector<elastic::Station> const stations{wall_station(solid.mesh(), 9, 0, elastic::Direction::radial),
                                                 wall_station(solid.mesh(), 8, 0, elastic::Direction::radial),
                                                 wall_station(solid.mesh(), 10, 0, elastic::Direction::radial)};
    elastic::Influence const cup = influence(solid, {}, stations, harmonics);
    for (std::size_t i = 0; i < table.size(); ++i) {
        CAPTURE(table[i].n);
        auto const& c = cup.compliance(i);
        CHECK(24 * c(0, 0) == Approx(table[i].w).epsilon(0.0005));
        CHECK((c - c.transpose()).norm() == 0);
        if (table[i].coning > 0)
            CHECK((c(2, 0) - c(1, 0)) / 2 / c(0, 0) == Approx(table[i].coning).epsilon(0.005).margin(0.0003));
    }
}

TEST_CASE("linear coning, reactions and twist of the cup agree with CalculiX", "[elastic]")
{
    elastic::FourierSolid const solid(elastic::section_mesh({}));
    SECTION("coning under a displaced circle")
    {
        CHECK(coning_deg(solid) == Approx(1.677).epsilon(0.0005));
        CHECK(coning_deg(elastic::FourierSolid(elastic::section_mesh({}), elastic::Quadrature::full)) ==
              Approx(coning_deg(solid)).epsilon(0.0003));
    }
    SECTION("reaction per two lobes of the circle, and of a strip that is glued")
    {
        std::vector<elastic::Station> stations;
        for (int i = 0; i <= 24; ++i)
            stations.push_back(wall_station(solid.mesh(), 6 + 0.25 * i, 0, elastic::Direction::radial));
        auto const c = influence(solid, {}, stations, {2}).compliance(0);
        // integral of q cos 2 phi over two lobes: 2 q
        CHECK(2 * w0 / c(12, 12) == Approx(107.5).epsilon(0.001));
        CHECK(2 * c.ldlt().solve(Eigen::VectorXd::Constant(25, w0)).sum() == Approx(2968.4).epsilon(0.001));
    }
    SECTION("28 Nm spread evenly over the tooth ring")
    {
        auto const stations = tooth_band(solid.mesh(), 1, elastic::Direction::tangential);
        auto const c = influence(solid, {}, stations, {0}).compliance(0);
        Eigen::VectorXd load = Eigen::VectorXd::Constant(17, 1.0 / 16);
        load[0] = load[16] = 1.0 / 32;
        double const r = 24.7;
        Eigen::VectorXd const v = c * load * (28e3 / (2 * pi * r));
        CHECK(v.mean() / r == Approx(2.9131e-4).epsilon(0.0005));
    }
}

TEST_CASE("the coning of the cup converges with its mesh", "[elastic]")
{
    // one element across the wall, finer and finer along it
    std::vector<double> coning;
    for (double const along : {1.0, 0.5, 0.25, 0.125})
        coning.push_back(coning_deg(elastic::FourierSolid(elastic::section_mesh({}, {along, 1.0}))));
    double const first = std::abs(coning[1] - coning[0]), second = std::abs(coning[2] - coning[1]),
                 third = std::abs(coning[3] - coning[2]);
    CAPTURE(coning, first, second, third);
    CHECK(first < 0.01);
    CHECK(second < 0.002);
    CHECK(third < second);
}

TEST_CASE("a thick ring under inner pressure widens as Lame says", "[elastic]")
{
    elastic::Elasticity const material{206e3, 0.3};
    double const a = 10, b = 15, width = 2, pressure = 100;
    double const expected =
        pressure * a / material.youngs_modulus * ((b * b + a * a) / (b * b - a * a) + material.poissons_ratio);
    auto const error = [&](double across, elastic::Quadrature quadrature) {
        elastic::FourierSolid const solid(elastic::ring_mesh({a, 0}, {b, width}, material, {2, across}), quadrature);
        std::vector<elastic::Station> stations;
        for (double const z : {0.0, 1.0, 2.0})
            stations.push_back(wall_station(solid.mesh(), z, 0, elastic::Direction::radial));
        auto const c = influence(solid, against_rigid_motion(), stations, {0}).compliance(0);
        // shares of an even pressure on the side of one element: 1/6, 4/6, 1/6
        Eigen::VectorXd const u = c * Eigen::Vector3d(1, 4, 1) * (pressure * width * a / 6);
        return std::abs(u.dot(Eigen::Vector3d(1, 4, 1)) / 6 / expected - 1);
    };
    // four Gauss points each have the exact strain: right at the nodes
    constexpr double rounding = 1e-11;
    CHECK(error(2.5, elastic::Quadrature::reduced) < rounding);
    CHECK(error(1.25, elastic::Quadrature::reduced) < rounding);
    // nine integrate the energy: order 4
    CHECK(error(1.25, elastic::Quadrature::full) < 1e-5);
    CHECK(std::log2(error(2.5, elastic::Quadrature::full) / error(1.25, elastic::Quadrature::full)) ==
          Approx(4).margin(0.3));
}

TEST_CASE("a long cylinder under a ring load bends as a beam on an elastic foundation", "[elastic]")
{
    elastic::Elasticity const material{206e3, 0.3};
    double const r = 100;
    double last = 1;
    for (double const t : {4.0, 1.0, 0.25}) {
        double const beta = std::pow(3 * (1 - 0.09) / (r * r * t * t), 0.25);
        double const stiffness = material.youngs_modulus * t * t * t / (12 * (1 - 0.09));
        double const expected = 1 / (8 * beta * beta * beta * stiffness);  // mm per N/mm
        double const length = 16 / beta;
        elastic::FourierSolid const solid(
            elastic::ring_mesh({r - t / 2, 0}, {r + t / 2, length}, material, {length / 128, t}));
        auto const c =
            elastic::influence(solid, against_rigid_motion(),
                               {elastic::wall_station(solid.mesh(), length / 2, 0.5, elastic::Direction::radial)}, {0})
                .compliance(0);
        double const error = std::abs(r * c(0, 0) / expected - 1);
        CAPTURE(t, error);
        CHECK(error < 1.5 * t / r + 0.001);
        CHECK(error < last);
        last = error;
    }
}

TEST_CASE("a thin ring under two opposite forces", "[elastic]")
{
    elastic::Elasticity const material{206e3, 0.3};
    double const r = 50, t = 0.5, width = 0.5;
    elastic::FourierSolid const solid(elastic::ring_mesh({r - t / 2, 0}, {r + t / 2, width}, material, {width, t}));
    auto const harmonics = elastic::harmonics_of(2, 200);
    elastic::Influence const ring =
        elastic::influence(solid, against_rigid_motion(),
                           {elastic::wall_station(solid.mesh(), width / 2, 0, elastic::Direction::radial)}, harmonics);
    double const bending = material.youngs_modulus * width * t * t * t / 12;
    // pulled apart by 1 N: inextensional bending, and what stretching and shear add, of the order (t/r)^2
    double const across = 2 * ring({0, 0}, {0, 0}, {2, false});
    double const along = 2 * ring({0, pi / 2}, {0, 0}, {2, false});
    double const scale = r * r * r / bending;
    CHECK(across == Approx((pi / 4 - 2 / pi) * scale).epsilon(0.003));
    CHECK(along == Approx((1 / 2.0 - 2 / pi) * scale).epsilon(0.003));
}

TEST_CASE("a free tube under n = 2 bends without stretching as its wall gets thin", "[elastic]")
{
    // Rayleigh: w = (a + b z) cos 2 phi, v = -(a + b z)/2 sin 2 phi, u_z = -(b r/4) cos 2 phi; only bending and twist
    // of the wall store energy
    double const nu = 0.3, e = 206e3, r = 24, length = 24;
    int const n = 2;
    std::vector<double> shifts, tilts;
    for (double const t : {0.72, 0.24, 0.08}) {
        elastic::FourierSolid const solid(
            elastic::ring_mesh({r - t / 2, -length / 2}, {r + t / 2, length / 2}, {e, nu}, {0.2, 1}));
        std::vector<elastic::Station> stations;
        for (double const z : {-length / 4, length / 4})
            stations.push_back(wall_station(solid.mesh(), z, 0.5, elastic::Direction::radial));
        stations.push_back(wall_station(solid.mesh(), length / 4, 0.5, elastic::Direction::tangential));
        stations.push_back(wall_station(solid.mesh(), length / 4, 0.5, elastic::Direction::axial));
        auto const c = influence(solid, {}, stations, {n}).compliance(0);
        double const d = e * t * t * t / (12 * (1 - nu * nu)), factor = d * (n * n - 1) * (n * n - 1);
        double const a = r * r * r / (factor * length);
        double const b =
            length / 4 / (factor * (length * length * length / (12 * r * r * r) + 2 * (1 - nu) * length / (n * n * r)));
        double const shift = (c(0, 1) + c(1, 1)) / 2, tilt = (c(1, 1) - c(0, 1)) / (length / 2);
        shifts.push_back(std::abs(shift / a - 1));
        tilts.push_back(std::abs(tilt / b - 1));
        CAPTURE(t, shift / a, tilt / b);
        CHECK(c(2, 1) == Approx(-c(1, 1) / 2).epsilon(2 * t / r + 1e-4));
        CHECK(c(3, 1) == Approx(-tilt * r / 4).epsilon(2 * t / r + 1e-3));
        // the free edges bend on sqrt(r t): that much of the length is softer
        CHECK(shifts.back() < std::sqrt(t / r));
        CHECK(tilts.back() < 2 * std::sqrt(t / r));
    }
    // and by nothing else: order 1/2 (rounding, some 1e-16 (r/t)^4, ends the sequence at r/t = 1000)
    CHECK(std::log(shifts[1] / shifts[2]) / std::log(3.0) == Approx(0.5).margin(0.05));
    CHECK(std::log(tilts[1] / tilts[2]) / std::log(3.0) == Approx(0.5).margin(0.3));
}

TEST_CASE("torsion of a tube and of a plate", "[elastic]")
{
    elastic::Elasticity const material{206e3, 0.3};
    double const shear = material.youngs_modulus / 2.6;
    SECTION("tube")
    {
        double const a = 20, b = 24, length = 60;
        elastic::SectionMesh const mesh = elastic::ring_mesh({a, 0}, {b, length}, material, {0.5, 1});
        elastic::Supports supports{{0, elastic::Direction::axial}};
        for (int node : nodes_where(mesh, [](Vec2 const& p) { return p.y() == 0; }))
            supports.push_back({node, elastic::Direction::tangential});
        elastic::FourierSolid const solid(mesh);
        std::vector<elastic::Station> const stations{wall_station(mesh, 20, 1, elastic::Direction::tangential),
                                                     wall_station(mesh, 40, 1, elastic::Direction::tangential),
                                                     wall_station(mesh, 60, 0.5, elastic::Direction::tangential)};
        auto const c = influence(solid, supports, stations, {0}).compliance(0);
        double const moment = 2 * pi * 22;  // of 1 N/rad at the middle of the wall
        double const twist = (c(1, 2) - c(0, 2)) / b;
        CHECK(twist == Approx(moment * 20 / (shear * pi / 2 * (std::pow(b, 4) - std::pow(a, 4)))).epsilon(1e-5));
    }
    SECTION("plate")
    {
        double const a = 13, b = 23, thickness = 0.5;
        elastic::SectionMesh const mesh = elastic::ring_mesh({a, 0}, {b, thickness}, material, {0.5, 0.5});
        elastic::Supports supports{{0, elastic::Direction::axial}};
        for (int node : nodes_where(mesh, [](Vec2 const& p) { return p.x() == 13; }))
            supports.push_back({node, elastic::Direction::tangential});
        elastic::FourierSolid const solid(mesh);
        std::vector<elastic::Station> const stations{wall_station(mesh, 0.25, 0.5, elastic::Direction::tangential),
                                                     wall_station(mesh, 0.25, 1, elastic::Direction::tangential)};
        auto const c = influence(solid, supports, stations, {0}).compliance(0);
        double const moment = 2 * pi * b, half = (a + b) / 2;
        CHECK(c(0, 1) / half ==
              Approx(moment / (4 * pi * shear * thickness) * (1 / (a * a) - 1 / (half * half))).epsilon(1e-4));
    }
}

TEST_CASE("a free ring moves without strain where a rigid body does", "[elastic]")
{
    elastic::FourierSolid const solid(elastic::ring_mesh({20, 0}, {22, 6}, {}, {1, 1}));
    auto const strain_energy = [&](int n, auto&& displacement) {
        Eigen::VectorXd u(solid.unknowns());
        for (std::size_t i = 0; i < solid.mesh().nodes.size(); ++i)
            u.segment<3>(static_cast<Index>(3 * i)) = displacement(solid.mesh().nodes[i]);
        return u.dot(solid.stiffness(n) * u) / u.squaredNorm() / solid.stiffness(n).diagonal().maxCoeff();
    };
    constexpr double rounding = 1e-14;
    CHECK(std::abs(strain_energy(0, [](Vec2 const&) { return Eigen::Vector3d(0, 1, 0); })) < rounding);
    CHECK(std::abs(strain_energy(0, [](Vec2 const& p) { return Eigen::Vector3d(0, 0, p.x()); })) < rounding);
    CHECK(std::abs(strain_energy(1, [](Vec2 const&) { return Eigen::Vector3d(1, 0, -1); })) < rounding);
    CHECK(std::abs(strain_energy(1, [](Vec2 const& p) { return Eigen::Vector3d(-p.y(), p.x(), p.y()); })) < rounding);
    CHECK(strain_energy(2, [](Vec2 const&) { return Eigen::Vector3d(1, 0, -1); }) > 1e-5);

    for (int const n : {0, 1})
        CHECK_THROWS_WITH(elastic::HarmonicSolver(solid, {}, n), ContainsSubstring("can move as a whole"));
    CHECK_NOTHROW(elastic::HarmonicSolver(solid, {}, 2));
    CHECK_NOTHROW(elastic::HarmonicSolver(solid, against_rigid_motion(), 0));
    // springs hold as well as fixed nodes do
    CHECK_NOTHROW(
        elastic::HarmonicSolver(solid, {{0, elastic::Direction::axial, 1}, {0, elastic::Direction::tangential, 1}}, 0));
}

TEST_CASE("influence obeys Betti and Fourier", "[elastic]")
{
    elastic::FourierSolid const solid(elastic::section_mesh({}, {1.0, 1.0}));
    std::vector<elastic::Station> stations;
    for (elastic::Direction const direction :
         {elastic::Direction::radial, elastic::Direction::axial, elastic::Direction::tangential})
        for (double const z : {6.0, 9.3, 12.7})
            stations.push_back(
                wall_station(solid.mesh(), z, direction == elastic::Direction::tangential ? 1 : 0, direction));
    elastic::Influence const all = influence(solid, {}, stations, elastic::harmonics_of(1, 24));
    elastic::Influence const even = influence(solid, {}, stations, elastic::harmonics_of(2, 24));
    constexpr double rounding = 1e-12;
    std::vector<elastic::InfluencePoint> points;
    for (std::size_t i = 0; i < stations.size(); ++i)
        points.push_back({i, 0.37 * static_cast<double>(i) - 1});
    double const size = all.matrix(points).cwiseAbs().maxCoeff();

    SECTION("what b does to a, a does to b; and turning both changes nothing")
    {
        for (auto const& a : points)
            for (auto const& b : points) {
                CHECK(std::abs(all(a, b) - all(b, a)) <= rounding * size);
                CHECK(std::abs(all(a, b) - all({a.station, a.phi + 1.1}, {b.station, b.phi + 1.1})) <= rounding * size);
            }
    }
    SECTION("mirror images")
    {
        for (auto const& a : points)
            for (auto const& b : points) {
                bool const turned = (all.direction(a.station) == elastic::Direction::tangential) !=
                                    (all.direction(b.station) == elastic::Direction::tangential);
                CHECK(std::abs(all({a.station, -a.phi}, {b.station, -b.phi}) - (turned ? -1 : 1) * all(a, b)) <=
                      rounding * size);
                double const image = all.direction(b.station) == elastic::Direction::tangential ? -1 : 1;
                CHECK(std::abs(all(a, b, {1, true}) - (all(a, b) + image * all(a, {b.station, -b.phi}))) <=
                      rounding * size);
            }
    }
    SECTION("forces repeated round the axis")
    {
        for (auto const& a : points)
            for (auto const& b : points) {
                double const sum = all(a, b) + all(a, {b.station, b.phi + pi});
                CHECK(std::abs(all(a, b, {2, false}) - sum) <= rounding * size);
                CHECK(std::abs(even(a, b, {2, false}) - sum) <= rounding * size);
            }
    }
    SECTION("a mean load and one harmonic, summed over points of the circle")
    {
        constexpr int count = 64;
        double mean = 0, second = 0;
        for (int i = 0; i < count; ++i) {
            double const phi = 2 * pi * i / count;
            mean += all({1, 0.3}, {1, phi}) / count;
            second += all({1, 0.3}, {1, phi}) * std::cos(2 * phi) / count;
        }
        CHECK(mean == Approx(all.compliance(0)(1, 1) / (2 * pi)));
        CHECK(second == Approx(all.compliance(2)(1, 1) * std::cos(0.6) / (2 * pi)));
    }
    SECTION("the same bits for any number of threads, and symmetric")
    {
        elastic::Influence const again = influence(solid, {}, stations, elastic::harmonics_of(1, 24), 2);
        for (std::size_t i = 0; i < all.harmonics().size(); ++i)
            CHECK(again.compliance(i) == all.compliance(i));
        Eigen::MatrixXd const one = all.matrix(points, {2, true}, 1);
        CHECK(one == all.matrix(points, {2, true}, 2));
        CHECK(one == one.transpose());
    }
}

TEST_CASE("harmonics converge away from a force and grow under it as their logarithm", "[elastic]")
{
    elastic::FourierSolid const solid(elastic::section_mesh({}));
    std::vector<elastic::Station> const stations{wall_station(solid.mesh(), 9, 0, elastic::Direction::radial)};
    std::vector<double> under, beside;
    for (int const highest : {24, 48, 96, 192}) {
        elastic::Influence const cup = influence(solid, {}, stations, elastic::harmonics_of(2, highest));
        under.push_back(cup({0, 0}, {0, 0}, {2, false}));
        beside.push_back(cup({0, 0.4}, {0, 0}, {2, false}));
    }
    CHECK(std::abs(beside[3] - beside[2]) < 0.001 * std::abs(beside[3]));
    CHECK(std::abs(beside[3] - beside[2]) < std::abs(beside[1] - beside[0]));
    CHECK(under[3] > under[2]);
    CHECK(under[3] - under[2] < 0.01 * under[3]);
}

TEST_CASE("walls of all kinds are solved or refused", "[elastic]")
{
    auto const coning_of = [](elastic::CupSection const& cup) {
        return coning_deg(elastic::FourierSolid(elastic::section_mesh(cup)));
    };
    SECTION("very thin and very thick")
    {
        elastic::CupSection thin;
        thin.wall = thin.bottom = 0.05;
        thin.ring_wall = 0.08;
        // the thinner, the nearer to Rayleigh's cone from the bottom
        CHECK(coning_of(thin) == Approx(std::atan(w0 / 9) * 180 / pi).epsilon(0.08));
        elastic::CupSection thick;
        thick.wall = thick.ring_wall = thick.bottom = 5;
        thick.corner_radius = 6;
        thick.ring_begin = 7;
        thick.clamp_radius = 10;
        CHECK(elastic::section_mesh(thick).layers > 1);
        elastic::FourierSolid const solid(elastic::section_mesh(thick));
        auto const c = elastic::influence(solid, {},
                                          {elastic::wall_station(solid.mesh(), 8, 0, elastic::Direction::radial),
                                           elastic::wall_station(solid.mesh(), 10, 0, elastic::Direction::radial)},
                                          {2})
                           .compliance(0);
        CHECK(c(0, 0) > 0);
        CHECK(c(1, 1) > c(0, 0));
    }
    SECTION("Poisson's ratio at its limits")
    {
        for (double const nu : {0.0, 0.49}) {
            elastic::CupSection cup;
            cup.material.poissons_ratio = nu;
            CHECK(coning_of(cup) == Approx(1.68).epsilon(0.03));
        }
        elastic::CupSection cup;
        cup.material.poissons_ratio = 0.5;
        CHECK_THROWS_WITH(elastic::section_mesh(cup), ContainsSubstring("Poisson's ratio"));
    }
    SECTION("one element along each part, one along all of a ring")
    {
        CHECK(elastic::FourierSolid(elastic::section_mesh({}, {100, 100})).mesh().elements.size() == 7);
        CHECK(coning_deg(elastic::FourierSolid(elastic::section_mesh({}, {100, 100}))) == Approx(1.677).epsilon(0.2));
        elastic::FourierSolid const ring(elastic::ring_mesh({20, 0}, {21, 1}, {}, {10, 10}));
        CHECK(ring.mesh().elements.size() == 1);
        CHECK_NOTHROW(elastic::HarmonicSolver(ring, {}, 2));
    }
    SECTION("many harmonics")
    {
        elastic::FourierSolid const solid(elastic::section_mesh({}));
        auto const c = elastic::influence(
            solid, {}, {elastic::wall_station(solid.mesh(), 9, 0, elastic::Direction::radial)}, {1, 1000, 100000});
        CHECK(c.compliance(0)(0, 0) > c.compliance(1)(0, 0));
        CHECK(c.compliance(1)(0, 0) > c.compliance(2)(0, 0));
        CHECK(c.compliance(2)(0, 0) > 0);
    }
    SECTION("no land in front of the ring, no step of the wall")
    {
        elastic::CupSection cup;
        cup.length = cup.ring_end;
        CHECK_NOTHROW(elastic::section_mesh(cup));
        cup.ring_wall = cup.wall;
        cup.rear_ramp = 0;
        CHECK_NOTHROW(elastic::section_mesh(cup));
    }
    SECTION("dimensions that contradict each other")
    {
        auto const refused = [](auto&& change, char const* why) {
            elastic::CupSection cup;
            change(cup);
            CHECK_THROWS_WITH(elastic::section_mesh(cup), ContainsSubstring(why));
        };
        refused([](elastic::CupSection& c) { c.wall = 0; }, "thicker than 0");
        refused([](elastic::CupSection& c) { c.wall = 5; }, "must be larger than the walls");
        refused([](elastic::CupSection& c) { c.clamp_radius = 23; }, "corner fillet");
        refused([](elastic::CupSection& c) { c.ring_begin = 2.2; }, "inside the corner fillet");
        refused([](elastic::CupSection& c) { c.length = 12; }, "beyond the cup's length");
        refused([](elastic::CupSection& c) { c.length = 13.2; }, "front ramp");
        refused([](elastic::CupSection& c) { c.rear_ramp = 0; }, "rear ramp");
        refused([](elastic::CupSection& c) { c.material.youngs_modulus = -1; }, "Young's modulus");
        CHECK_THROWS_AS(elastic::section_mesh({}, {1e-7, 1}), NumericalError);
        CHECK_THROWS_AS(elastic::section_mesh({}, {0, 1}), NumericalError);
        CHECK_THROWS_AS(elastic::ring_mesh({0, 0}, {1, 1}, {}, {1, 1}), NumericalError);
        elastic::SectionMesh const mesh = elastic::section_mesh({});
        CHECK_THROWS_WITH(wall_point(mesh, 1, 0), ContainsSubstring("outside the straight wall"));
        CHECK_THROWS_WITH(wall_point(mesh, 9, 1.5), ContainsSubstring("depth"));
        for (int const steps : {-1, 0, 3, 1441})
            CHECK_THROWS_AS(elastic::swept_mesh(mesh, pi, steps), InputError);
        CHECK(elastic::swept_mesh(mesh, pi, 4).elements.size() == 4 * mesh.elements.size());
    }
}

}  // namespace hdconj::test::elastic_solid_cases
