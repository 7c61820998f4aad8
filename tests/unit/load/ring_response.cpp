// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Forces on a ring, line contact and the flank contacts that a load looks at.
#include "load/ring_response.hpp"

#include <cmath>
#include <numbers>

#include "load/hertz.hpp"
#include "support/catch.hpp"

namespace hdconj::test::ring_response_cases {

namespace {

using std::numbers::pi;

/// Two stations, radial and tangential, of an inextensional ring: U falls as 1/n^2, V = -U/n; with something of its own
/// for n = 0.
std::vector<load::HarmonicResponse> ring(int sectors, int highest)
{
    std::vector<load::HarmonicResponse> all;
    for (int n = 0; n <= highest; n += sectors) {
        Eigen::MatrixXd s(2, 2);
        double const u = n == 0 ? 0.3 : 1.0 / (n * n);
        double const v = n == 0 ? 0.2 : 1.0 / (n * n * n);
        s << u, n == 0 ? 0 : -v, n == 0 ? 0 : -v, n == 0 ? 0.2 : v / n + 0.01;
        all.push_back({n, s});
    }
    return all;
}

std::vector<load::RingStation> stations(std::size_t turns)
{
    std::vector<load::RingStation> result{{load::RingStation::Parity::cosine, 0.01},
                                          {load::RingStation::Parity::sine, 0.02}};
    for (std::size_t i = 0; i < turns; ++i)
        result.push_back({load::RingStation::Parity::sine, 0.02});
    return result;
}

double at(std::vector<double> const& series, int sectors, double phi)
{
    double sum = 0;
    for (std::size_t k = 0; 2 * k < series.size(); ++k)
        sum += series[2 * k] * std::cos(static_cast<double>(k) * sectors * phi) +
               series[2 * k + 1] * std::sin(static_cast<double>(k) * sectors * phi);
    return sum;
}

}  // namespace

TEST_CASE("a ring answers a force at one place as a force at another answers it", "[load]")
{
    std::vector<load::HarmonicResponse> harmonics = ring(2, 40);
    load::add_turns(harmonics, {0}, {1}, 24.0);
    load::PointResponse const response(stations(1), harmonics, 2, 50, 2);
    for (std::size_t a = 0; a < 3; ++a)
        for (std::size_t b = 0; b < 3; ++b)
            for (int steps : {0, 3, 17, 25, -8, 53})
                CHECK(response(a, b, steps) == response(b, a, -steps));
}

TEST_CASE("series of displacements under forces are the sums of what each force does", "[load]")
{
    constexpr int sectors = 2, grid = 30;
    std::vector<load::HarmonicResponse> harmonics = ring(sectors, 28);
    load::add_turns(harmonics, {0}, {1}, 24.0);
    load::PointResponse const response(stations(1), harmonics, sectors, grid, 1);
    Eigen::MatrixXd force = Eigen::MatrixXd::Zero(3, grid);
    force(0, 4) = 3;
    force(1, 11) = -2;
    force(2, 25) = 5;
    double const phase = 0.013;
    auto const series = response.series(force, phase, {0, 1, 2});
    for (std::size_t a = 0; a < 3; ++a)
        for (int i = 0; i < grid; ++i) {
            double const sum = 3 * response(a, 0, i - 4) - 2 * response(a, 1, i - 11) + 5 * response(a, 2, i - 25);
            CHECK(at(series[a], sectors, phase + response.step() * i) == Approx(sum).margin(1e-14));
        }
}

TEST_CASE("the turn of a surface is what its displacements say", "[load]")
{
    constexpr double radius = 24;
    std::vector<load::HarmonicResponse> harmonics = ring(2, 12);
    load::add_turns(harmonics, {0}, {1}, radius);
    std::vector<load::RingStation> sharp(3);
    sharp[1].parity = sharp[2].parity = load::RingStation::Parity::sine;
    load::PointResponse const response(sharp, harmonics, 2, 60, 1);
    Eigen::MatrixXd force = Eigen::MatrixXd::Zero(3, 60);
    force(0, 7) = 1;
    force(1, 19) = 2;
    auto const series = response.series(force, 0, {0, 1, 2});
    constexpr double h = 1e-5;
    for (double phi : {0.0, 0.4, 1.3, 2.9}) {
        double const slope = (at(series[0], 2, phi + h) - at(series[0], 2, phi - h)) / (2 * h);
        CHECK(at(series[2], 2, phi) == Approx((at(series[1], 2, phi) - slope) / radius).margin(1e-9));
    }
}

TEST_CASE("a spread force does what many forces over its arc do", "[load]")
{
    constexpr int grid = 600;
    std::vector<load::HarmonicResponse> const harmonics = ring(2, 20);
    std::vector<load::RingStation> wide(2), sharp(2);
    wide[1].parity = sharp[1].parity = load::RingStation::Parity::sine;
    double const step = 2 * pi / 2 / grid;
    wide[0].spread = 40 * step;
    load::PointResponse const spread(wide, harmonics, 2, grid, 1), point(sharp, harmonics, 2, grid, 1);
    // station 1 has no spread: what it does under the spread force is the mean over the arc, here by the trapezoid rule
    double mean = 0;
    for (int i = -20; i <= 20; ++i)
        mean += point(1, 0, 55 - i) * (std::abs(i) == 20 ? 0.5 : 1) / 40;
    CHECK(spread(1, 0, 55) == Approx(mean).epsilon(1e-4));
}

TEST_CASE("line contact by Hertz", "[load]")
{
    // two steel cylinders of 10 mm radius, 100 N/mm: textbook values
    elastic::Elasticity const steel{210e3, 0.3};
    load::LineContact const c{steel, steel, 0.2, 5};
    double const modulus = 210e3 / (1 - 0.09) / 2;
    CHECK(contact_modulus(c) == Approx(modulus));
    CHECK(half_width(c, 100) == Approx(std::sqrt(4 * 100 / (pi * modulus * 0.2))));
    CHECK(largest_pressure(c, 100) == Approx(std::sqrt(100 * modulus * 0.2 / pi)));
    // an ellipse over the strip carries the load
    CHECK(pi / 2 * half_width(c, 100) * largest_pressure(c, 100) == Approx(100));
    // twice the load: pressure by sqrt 2; the approach less than twice, and never falls
    CHECK(largest_pressure(c, 200) == Approx(std::sqrt(2.0) * largest_pressure(c, 100)));
    double last = 0;
    for (double q = 1e-9; q < 1e6; q *= 10) {
        double const now = load::approach(c, q);
        CHECK(now > last);
        last = now;
    }
    CHECK(approach(c, 200) < 2 * approach(c, 100));
    CHECK(approach(c, 0) == 0);
    CHECK(half_width(c, -1) == 0);
}

TEST_CASE("a line contact whose steel flows", "[load]")
{
    elastic::Elasticity const steel{210e3, 0.3};
    load::LineContact const elastic{steel, steel, 0.2, 5};
    load::LineContact soft = elastic;
    soft.flow_pressure = 1500;
    // the mean pressure q/(2 a) reaches the flow pressure at 16 p^2/(pi E* kappa)
    double const first = 16 * 1500 * 1500.0 / (pi * contact_modulus(elastic) * 0.2);
    CHECK(first / (2 * half_width(elastic, first)) == Approx(1500));
    CHECK_FALSE(flows(soft, 0.999 * first));
    CHECK(flows(soft, 1.001 * first));
    for (double const share : {0.01, 0.5, 0.999}) {
        CHECK(half_width(soft, share * first) == half_width(elastic, share * first));
        CHECK(approach(soft, share * first) == approach(elastic, share * first));
        CHECK(largest_pressure(soft, share * first) == largest_pressure(elastic, share * first));
    }
    double last = 0;
    for (double q = first / 4; q < 20 * first; q *= 1.1) {
        CHECK(q / (2 * half_width(soft, q)) <= 1500 * (1 + 1e-12));
        CHECK(largest_pressure(soft, q) <= 4 / pi * 1500 * (1 + 1e-12));
        CHECK(approach(soft, q) > last);
        CHECK(approach(soft, q) >= approach(elastic, q));
        last = approach(soft, q);
    }
    // far beyond it the surface gives way as the overlap of parabolas whose strip carries p: kappa (q/(2 p))^2/2
    double const far = 1e4 * first, strip = far / (2 * 1500);
    CHECK(approach(soft, far) == Approx(0.2 * strip * strip / 2).epsilon(1e-3));
}

}  // namespace hdconj::test::ring_response_cases
