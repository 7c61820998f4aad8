// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <string>
#include <vector>

#include "hdconj/motion/exact_motion.hpp"
#include "hdconj/motion/first_order_motion.hpp"
#include "hdconj/wavegen/registry.hpp"
#include "support/catch.hpp"
#include "support/type50.hpp"

namespace hdconj::test::wavegen_cases {

using std::numbers::pi;

namespace {

constexpr double degree = pi / 180;

struct Named
{
    std::string name;
    wavegen::AnyWaveShape shape;
};

wavegen::TableCam cosine_table(int rows, int waves, double w0)
{
    std::vector<double> angles, values;
    for (int i = 0; i < rows; ++i) {
        angles.push_back(2 * pi * i / (rows * waves));
        values.push_back(w0 * std::cos(waves * angles.back()));
    }
    return {angles, values, waves};
}

/// Every family on type-50's ring, with breaks in unusual places too.
std::vector<Named> families(double w0 = type50_w0, double r_m = type50_r_m)
{
    return {{"cosine", wavegen::AnyWaveShape(wavegen::CosineCam{w0, 2})},
            {"cosine, one wave", wavegen::AnyWaveShape(wavegen::CosineCam{w0, 1})},
            {"ellipse", wavegen::AnyWaveShape(wavegen::EllipseCam(w0, r_m))},
            {"two rollers", wavegen::AnyWaveShape(wavegen::FourRoller(w0, 0, 2))},
            {"four rollers", wavegen::AnyWaveShape(wavegen::FourRoller(w0, 30 * degree, 2))},
            {"six rollers", wavegen::AnyWaveShape(wavegen::FourRoller(w0, 20 * degree, 3))},
            {"two discs", wavegen::AnyWaveShape(wavegen::TwoDisc(w0, 30 * degree, 2, r_m))},
            {"three discs", wavegen::AnyWaveShape(wavegen::TwoDisc(w0, 15 * degree, 3, r_m))},
            {"ring on cam", wavegen::AnyWaveShape(wavegen::RingOnCam(w0, 2, 4.0, r_m))},
            {"ring on cam, three waves", wavegen::AnyWaveShape(wavegen::RingOnCam(w0, 3, 2.0, r_m))},
            {"table", wavegen::AnyWaveShape(cosine_table(37, 2, w0))}};
}

}  // namespace

TEST_CASE("displacements are periodic and their derivatives are derivatives", "[wavegen]")
{
    constexpr double h = 1e-4;
    for (auto const& [name, shape] : families()) {
        INFO(name);
        double const period = 2 * pi / shape.waves();
        CHECK(shape(0).w == Approx(shape.amplitude()).epsilon(1e-12));
        for (int i = 0; i < 41; ++i) {
            double const u = -0.5 * period + period * (i + 0.37) / 41;
            bool near_break = false;
            for (double b : shape.breaks())
                near_break = near_break || std::abs(u - b) < 3 * h;
            wavegen::RadialDisplacement const d = shape(u);
            CHECK(shape(u + period).w == Approx(d.w).margin(1e-12));
            CHECK(shape(u - 3 * period).w2 == Approx(d.w2).margin(1e-11));
            if (shape.even())
                CHECK(shape(-u).w == Approx(d.w).margin(1e-12));
            if (near_break)
                continue;
            wavegen::RadialDisplacement const a = shape(u + h);
            wavegen::RadialDisplacement const b = shape(u - h);
            CHECK((a.w - b.w) / (2 * h) == Approx(d.w1).margin(2e-7));
            CHECK((a.w1 - b.w1) / (2 * h) == Approx(d.w2).margin(2e-7));
            CHECK((a.w2 - b.w2) / (2 * h) == Approx(d.w3).margin(2e-6));
        }
    }
}

TEST_CASE("curvature is continuous at breaks and a break belongs to the side of larger u", "[wavegen]")
{
    for (auto const& [name, shape] : families()) {
        INFO(name);
        for (double u : shape.breaks()) {
            constexpr double near = 1e-9;
            wavegen::RadialDisplacement const at = shape(u);
            wavegen::RadialDisplacement const before = shape(u - near);
            wavegen::RadialDisplacement const after = shape(u + near);
            CHECK(at.w == Approx(before.w).margin(1e-8));
            CHECK(at.w1 == Approx(before.w1).margin(1e-8));
            CHECK(at.w2 == Approx(before.w2).margin(1e-8));
            CHECK(at.w3 == Approx(after.w3).margin(1e-7));
            if (name != "table")
                CHECK(std::abs(at.w3 - before.w3) > 0.1 * type50_w0);
        }
    }
}

TEST_CASE("the ring closes: the tangential displacement is periodic to 1e-13", "[wavegen][motion]")
{
    for (auto const& [name, shape] : families()) {
        INFO(name);
        wavegen::NeutralCurve<wavegen::AnyWaveShape> const curve(shape, type50_r_m);
        motion::FirstOrderMotion<wavegen::AnyWaveShape> const first(shape, type50_r_m, type50_ratio);
        for (double u : {-3.0, -1.1, 0.0, 0.2, 0.9, 2.5}) {
            CHECK(std::abs(curve.phi(u + 2 * pi) - curve.phi(u) - 2 * pi) < 1e-13);
            // v/r_m of the thesis, over a turn
            CHECK(std::abs(first.v(u + 2 * pi) - first.v(u)) / type50_r_m < 1e-13);
        }
        // second path: the polygon of the curve, by Simpson's rule between breaks
        std::vector<double> cuts{-pi / shape.waves()};
        for (double b : shape.breaks())
            if (b > cuts.back() && b < pi / shape.waves())
                cuts.push_back(b);
        cuts.push_back(pi / shape.waves());
        double length = 0;
        for (std::size_t k = 0; k + 1 < cuts.size(); ++k) {
            constexpr int steps = 2000;
            double const h = (cuts[k + 1] - cuts[k]) / steps;
            for (int i = 0; i <= steps; ++i) {
                wavegen::RadialDisplacement const d = shape(cuts[k] + h * i);
                double const weight = i == 0 || i == steps ? 1 : i % 2 == 1 ? 4 : 2;
                length += weight * h / 3 * std::hypot(curve.r_0() + d.w, d.w1);
            }
        }
        CHECK(length * shape.waves() == Approx(2 * pi * type50_r_m).epsilon(1e-12));
        CHECK(curve.phi(0.7) == Approx(-curve.phi(-0.7)).margin(shape.even() ? 1e-14 : 1e-6));
    }
}

TEST_CASE("rates of both motions are derivatives for every family", "[wavegen][motion]")
{
    constexpr double h = 1e-5;
    auto const check = [&](auto const& motion) {
        for (double u : {-0.83, -0.4, 0.05, 0.31, 0.77}) {
            motion::MotionRates const r = motion.rates(u);
            Pose const here = motion.pose(u);
            Pose const after = motion.pose(u + h);
            Pose const before = motion.pose(u - h);
            for (Vec2 const& x : {Vec2(0, 0), Vec2(0.1, 0.8)})
                CHECK(((after(x) - before(x)) / (2 * h) - here.rotate(r.twist(x))).norm() < 2e-9);
            motion::MotionRates const ra = motion.rates(u + h);
            motion::MotionRates const rb = motion.rates(u - h);
            CHECK((ra.twist.omega - rb.twist.omega) / (2 * h) == Approx(r.change.omega).margin(2e-8));
            CHECK(((ra.twist.q - rb.twist.q) / (2 * h) - r.change.q).norm() < 1e-7);
        }
    };
    for (auto const& [name, shape] : families()) {
        INFO(name);
        if (name == "table")
            continue;  // w''' jumps every 5 degrees: its own test
        check(motion::ExactMotion<wavegen::AnyWaveShape>(
            wavegen::NeutralCurve<wavegen::AnyWaveShape>(shape, type50_r_m), type50_ratio));
        check(motion::FirstOrderMotion<wavegen::AnyWaveShape>(shape, type50_r_m, type50_ratio));
    }
}

TEST_CASE("ellipse: on the ellipse, with the published axes", "[wavegen]")
{
    // notes of Yao et al. 2025 against the elliptic integral
    CHECK(wavegen::EllipseCam(0.25, 25.525).minor_semi_axis() == Approx(25.2737696403).epsilon(1e-11));
    CHECK(wavegen::EllipseCam(0.3, 20).minor_semi_axis() == Approx(19.6977328033).epsilon(1e-11));
    wavegen::EllipseCam const cam(0.25, 25.525);
    double mean = 0, second = 0, fourth = 0;
    constexpr int points = 64;
    for (int i = 0; i < points; ++i) {
        double const u = 2 * pi * i / points;
        double const rho = 25.525 + cam(u).w;
        double const x = rho * std::sin(u) / cam.minor_semi_axis();
        double const y = rho * std::cos(u) / 25.775;
        CHECK(x * x + y * y == Approx(1).epsilon(1e-14));
        mean += cam(u).w / points;
        second += 2 * cam(u).w * std::cos(2 * u) / points;
        fourth += 2 * cam(u).w * std::cos(4 * u) / points;
    }
    CHECK(mean == Approx(-0.00246073).margin(5e-9));
    CHECK(second == Approx(0.25060008).margin(5e-9));
    CHECK(fourth == Approx(0.00184542).margin(5e-9));
}

TEST_CASE("four rollers: the closed form is the series of the ring", "[wavegen]")
{
    for (int n : {2, 3}) {
        for (double beta : {0.0, 20 * degree, 28 * degree}) {
            wavegen::FourRoller const shape(1, beta, n);
            auto const series = [&](double u) {
                double sum = 0;
                for (int k = 4000 * n; k >= n; k -= n) {
                    double const kk = static_cast<double>(k) * k - 1;
                    sum += std::cos(k * beta) * std::cos(k * u) / (kk * kk);
                }
                return sum;
            };
            for (double u : {0.0, 0.2, beta, 0.7, 1.0})
                CHECK(shape(u).w == Approx(series(u) / series(0)).margin(1e-11));
        }
    }
    // classical ring under two opposite forces: (2/pi - 1/2)/(pi/4 - 2/pi)
    CHECK(wavegen::FourRoller(1, 0, 2)(pi / 2).w == Approx((2 / pi - 0.5) / (pi / 4 - 2 / pi) * -1).epsilon(1e-13));
    struct Row
    {
        double beta;
        double w[7];
    };
    for (Row const& row : {Row{0, {1, .84009, .44919, -.03620, -.48870, -.80507, -.91828}},
                           Row{25, {1, .88286, .52968, .00753, -.51470, -.89148, -1.02803}},
                           Row{35, {1, .91377, .63041, .10001, -.53012, -1.01603, -1.19665}}})
        for (int i = 0; i < 7; ++i)
            CHECK(wavegen::FourRoller(1, row.beta * degree, 2)(15 * i * degree).w == Approx(row.w[i]).margin(6e-6));
}

TEST_CASE("two discs: circles where the ring lies on them, free between", "[wavegen]")
{
    double const beta = 30 * degree;
    wavegen::TwoDisc const shape(type50_w0, beta, 2, type50_r_m);
    CHECK(shape.disc_radius() + shape.eccentricity() == Approx(type50_r_m + type50_w0).epsilon(1e-14));
    CHECK(shape.eccentricity() > 0);
    for (double u : {-0.5, -0.2, 0.0, 0.35, 0.52}) {
        double const rho = type50_r_m + shape(u).w;
        CHECK(std::hypot(rho * std::sin(u), rho * std::cos(u) - shape.eccentricity()) ==
              Approx(shape.disc_radius()).epsilon(1e-14));
    }
    // free ring: rho'' + rho is c + d cos(u - 90 deg), here through three instants and checked at others
    auto const moment = [&](double u) { return shape(u).w2 + shape(u).w; };
    double const d = (moment(1.0) - moment(0.7)) / (std::sin(1.0) - std::sin(0.7));
    for (double u : {0.55, 0.9, 1.3, 1.57})
        CHECK(moment(u) == Approx(moment(0.7) + d * (std::sin(u) - std::sin(0.7))).epsilon(1e-11));
    // no wrap: the ring under two forces, up to terms of w0^2/r_m
    wavegen::TwoDisc const point(0.01, 1e-3, 2, type50_r_m);
    wavegen::FourRoller const forces(0.01, 0, 2);
    for (double u : {0.0, 0.4, 0.8, 1.2, 1.5})
        CHECK(point(u).w == Approx(forces(u).w).margin(2e-5));
}

TEST_CASE("ring on a cam: every point at the ring's thickness from the cam", "[wavegen]")
{
    for (int n : {1, 2, 3}) {
        double const t = 3.5;
        wavegen::RingOnCam const shape(type50_w0, n, t, type50_r_m);
        double const mean = shape.cam_radius() + t;
        auto const cam = [&](double a) {
            double const r = shape.cam_radius() + type50_w0 * std::cos(n * a);
            return Vec2(r * std::sin(a), r * std::cos(a));
        };
        for (double u : {0.0, 0.3, 0.8, 1.4, 2.2}) {
            double const rho = mean + shape(u).w;
            Vec2 const p(rho * std::sin(u), rho * std::cos(u));
            // golden section for the nearest cam point
            double a = u - 0.2, b = u + 0.2;
            double const g = (std::sqrt(5.0) - 1) / 2;
            for (int k = 0; k < 80; ++k) {
                double const c = b - g * (b - a), e = a + g * (b - a);
                ((cam(c) - p).norm() < (cam(e) - p).norm() ? b : a) = (cam(c) - p).norm() < (cam(e) - p).norm() ? e : c;
            }
            CHECK((cam(a) - p).norm() == Approx(t).epsilon(1e-13));
        }
        CHECK(wavegen::NeutralCurve<wavegen::RingOnCam>(shape, type50_r_m).r_0() == Approx(mean).epsilon(1e-14));
    }
    wavegen::RingOnCam const thin(type50_w0, 2, 1e-9, type50_r_m);
    for (double u : {0.0, 0.5, 1.1})
        CHECK(thin(u).w == Approx(wavegen::CosineCam{type50_w0, 2}(u).w).margin(1e-10));
}

TEST_CASE("table: the spline tends to its cam with h^4 and its curvature with h^2", "[wavegen]")
{
    auto const errors = [](int rows) {
        wavegen::TableCam const table = cosine_table(rows, 2, type50_w0);
        wavegen::CosineCam const cam{type50_w0, 2};
        std::pair<double, double> worst{0, 0};
        for (int i = 0; i < 500; ++i) {
            double const u = pi * (i + 0.5) / 500 - pi / 2;
            worst.first = std::max(worst.first, std::abs(table(u).w - cam(u).w));
            worst.second = std::max(worst.second, std::abs(table(u).w2 - cam(u).w2));
        }
        return worst;
    };
    auto const [w_coarse, bend_coarse] = errors(20);
    auto const [w_fine, bend_fine] = errors(80);
    CHECK(std::log2(w_coarse / w_fine) / 2 == Approx(4).margin(0.25));
    CHECK(std::log2(bend_coarse / bend_fine) / 2 == Approx(2).margin(0.25));
    CHECK(cosine_table(80, 2, type50_w0).even());
    CHECK(cosine_table(80, 3, type50_w0).breaks().size() == 80);
}

TEST_CASE("table: the largest displacement is that of the spline, wherever its rows stand", "[wavegen]")
{
    for (int const waves : {2, 3}) {
        double const step = 2 * pi / waves / 10;
        for (double const shift : {0.5, 0.4999, 0.1, 0.0}) {
            INFO(waves << " waves, rows off the peak by " << shift << " of their distance");
            std::vector<double> angles, values;
            for (int i = 0; i < 10; ++i) {
                angles.push_back((i + shift) * step);
                values.push_back(0.84 * std::cos(waves * angles.back()) + 0.02 * std::cos(2 * waves * angles.back()));
            }
            wavegen::TableCam const cam(angles, values, waves);
            double largest = 0;
            constexpr int places = 20001;
            for (int i = 0; i < places; ++i)
                largest = std::max(largest, cam((i - places / 2) * step / places).w);
            CHECK(cam.amplitude() == Approx(largest).epsilon(1e-8));
        }
    }
}

TEST_CASE("table: a row at the seam of the wave that conversion between units has moved stays there", "[wavegen]")
{
    double const seam = std::numbers::pi / 2;
    for (double const off : {0.0, 4e-16, -4e-16, 5e-13, -5e-13}) {
        INFO(off);
        std::vector<double> angles, values;
        for (int i = 0; i < 36; ++i) {
            double const angle = i * std::numbers::pi / 36;
            angles.push_back(i == 18 ? seam + off : angle);
            values.push_back(0.25 * std::cos(2 * angle));
        }
        wavegen::TableCam const cam(angles, values, 2);
        auto const breaks = cam.breaks();
        REQUIRE(breaks.size() == angles.size());
        // none makes a stretch that is no longer than a rounding
        CHECK(breaks.back() == seam);
        CHECK(breaks.front() > -seam + 0.08);
    }
}

}  // namespace hdconj::test::wavegen_cases
