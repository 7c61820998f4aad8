// SPDX-License-Identifier: GPL-3.0-or-later
// The motion of given displacements: its rates, its limits, and the exact motion as one of its cases.
#include "hdconj/motion/material_motion.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "hdconj/wavegen/displacement_of.hpp"
#include "hdconj/wavegen/inextensional_mode.hpp"
#include "hdconj/wavegen/registry.hpp"
#include "support/catch.hpp"
#include "support/oracle/number.hpp"
#include "support/type50.hpp"

namespace hdconj::test::material_motion_cases {

using oracle::Fifty;
using std::numbers::pi;

namespace {

using FiftyPoint = oracle::Point<Fifty>;

/// Neither symmetric nor free of strain, a turn of the ring as a whole included.
wavegen::MaterialDisplacement lopsided(int waves, double size = type50_w0)
{
    return {waves,
            {{0.01 * size, 0, 0.3 * size, 0},
             {size, 0.2 * size, 0.07 * size, -0.5 * size},
             {-0.03 * size, 0.04 * size, 0.01 * size, 0.02 * size},
             {0.002 * size, 0, 0, 0.001 * size}}};
}

/// A tooth point by the definition alone: in the frame that has turned by k phi, on the normal of the displaced curve,
/// whose tangent is a difference of points. In 50 digits, so that differences are as good as derivatives.
class Definition
{
  public:
    explicit Definition(wavegen::MaterialDisplacement const& displacement) : displacement_(displacement) {}

    [[nodiscard]] FiftyPoint operator()(Fifty const& phi, Vec2 const& x) const
    {
        FiftyPoint along = difference([&](Fifty const& at) { return curve(at); }, phi);
        along = (1 / length(along)) * along;
        FiftyPoint const outward{-along.y, along.x};
        FiftyPoint const p = curve(phi) + Fifty(x.x()) * along + Fifty(x.y()) * outward;
        return oracle::turned_clockwise(p, Fifty(-type50_ratio * phi));
    }

    /// Sixth-order difference with a step of 1e-5: error of the order of 1e-30.
    template <class F>
    [[nodiscard]] static FiftyPoint difference(F const& f, Fifty const& at)
    {
        Fifty const h("1e-5");
        auto const pair = [&](int i) { return f(Fifty(at + i * h)) - f(Fifty(at - i * h)); };
        return Fifty(1 / (60 * h)) * (pair(3) + Fifty(-9) * pair(2) + Fifty(45) * pair(1));
    }

  private:
    [[nodiscard]] FiftyPoint curve(Fifty const& phi) const
    {
        Fifty w = type50_r_m, v = 0;
        for (std::size_t k = 0; k < displacement_.harmonics.size(); ++k) {
            auto const& h = displacement_.harmonics[k];
            Fifty const angle = static_cast<int>(k) * displacement_.waves * phi;
            Fifty const c = cos(angle), s = sin(angle);
            w += h.w_cosine * c + h.w_sine * s;
            v += h.v_cosine * c + h.v_sine * s;
        }
        Fifty const c = cos(phi), s = sin(phi);
        return {w * s + v * c, w * c - v * s};
    }

    wavegen::MaterialDisplacement const& displacement_;
};

/// A wave generator with a corner that it does not declare.
struct Cornered
{
    [[nodiscard]] static int waves() { return 2; }
    [[nodiscard]] static double amplitude() { return type50_w0; }
    [[nodiscard]] static bool even() { return true; }
    [[nodiscard]] static std::span<double const> breaks() { return {}; }
    [[nodiscard]] wavegen::RadialDisplacement operator()(double u) const
    {
        return {type50_w0 * std::abs(std::cos(u)), 0, 0, 0, 0, 1};
    }
};

double distance(FiftyPoint const& a, Vec2 const& b)
{
    return std::hypot(static_cast<double>(a.x - b.x()), static_cast<double>(a.y - b.y()));
}

/// Smooth wave generators on the ring of type-50.
std::vector<std::pair<std::string, wavegen::AnyWaveShape>> smooth_families(double w0)
{
    return {{"cosine", wavegen::AnyWaveShape(wavegen::CosineCam{w0, 2})},
            {"cosine, one wave", wavegen::AnyWaveShape(wavegen::CosineCam{w0, 1})},
            {"cosine, three waves", wavegen::AnyWaveShape(wavegen::CosineCam{w0, 3})},
            {"ellipse", wavegen::AnyWaveShape(wavegen::EllipseCam(w0, type50_r_m))},
            {"ring on cam", wavegen::AnyWaveShape(wavegen::RingOnCam(w0, 2, 4.0, type50_r_m))}};
}

}  // namespace

TEST_CASE("material motion: pose and rates are those of the definition in 50 digits", "[motion][material]")
{
    for (int waves : {1, 2, 3}) {
        wavegen::MaterialDisplacement const displacement = lopsided(waves);
        motion::MaterialMotion const motion(displacement, type50_r_m, type50_ratio);
        Definition const defined(displacement);
        for (double phi : {-1.4, -0.6, 0.0, 0.3, 1.5, 7.0}) {
            Pose const pose = motion.pose(phi);
            motion::MotionRates const rates = motion.rates(phi);
            for (Vec2 const& x : {Vec2(0, 0), Vec2(0.25, 0.8), Vec2(-0.3, 0.4)}) {
                auto const at = [&](Fifty const& angle) { return defined(angle, x); };
                auto const velocity_at = [&](Fifty const& angle) { return Definition::difference(at, angle); };
                Vec2 const own = rates.twist(x);
                // p'' = R (omega right_of(v) + v')
                Vec2 const own_change = rates.twist.omega * right_of(own) + rates.change(x);
                CHECK(distance(at(phi), pose(x)) < 2e-14);
                CHECK(distance(velocity_at(phi), pose.rotate(own)) < 2e-14);
                CHECK(distance(Definition::difference(velocity_at, phi), pose.rotate(own_change)) < 2e-14);
                CHECK(own.norm() <= rates.velocity_size(x));
                CHECK(rates.change(x).norm() <= rates.velocity_change_size(x));
            }
            CHECK(std::abs(rates.twist.omega) <= rates.omega_size);
            CHECK(std::abs(rates.change.omega) <= rates.omega_change_size);
            // the polar angle of the origin, turned back
            Vec2 const origin = turned_clockwise(pose.origin, type50_ratio * phi);
            CHECK(std::abs(std::remainder(motion.angles(phi).u - std::atan2(origin.x(), origin.y()), 2 * pi)) < 4e-15);
            CHECK(motion.angles(phi).phi == phi);
        }
    }
}

TEST_CASE("material motion of the exact displacement is the exact motion", "[motion][material]")
{
    // another derivation: arc length and polar angle there, series and undeformed angle here
    for (double w0 : {1e-6, type50_w0, 1.5}) {
        for (auto const& [name, shape] : smooth_families(w0)) {
            INFO(name << ", w0 = " << w0);
            motion::ExactMotion<wavegen::AnyWaveShape> const exact(
                wavegen::NeutralCurve<wavegen::AnyWaveShape>(shape, type50_r_m), type50_ratio);
            motion::MaterialMotion const material(wavegen::displacement_of(exact.curve()), type50_r_m, type50_ratio);
            // neglected harmonics, up to 8 roundings of r_m each, enter the third derivatives with the cube of their
            // order
            double const cut = 8 * unit_roundoff * type50_r_m;
            double const order = static_cast<double>(material.displacement().harmonics.size()) * shape.waves();
            double const change_limit = 1e-12 + cut * order * order * order / type50_r_m;
            CHECK(material.symmetric());
            CHECK(material.half_lobe() == exact.half_lobe());
            for (double u : {-1.5, -0.7, -0.01, 0.0, 0.4, 1.1, 2.9}) {
                double const phi = exact.curve().phi(u);
                wavegen::RadialDisplacement const d = shape(u);
                double const rho = exact.curve().r_0() + d.w;
                double const s = std::hypot(rho, d.w1);
                // du/dphi and its derivative
                double const g = type50_r_m / s;
                double const g1 = -g * g * d.w1 * (rho + d.w2) / (s * s);
                Pose const a = exact.pose(u);
                Pose const b = material.pose(phi);
                motion::MotionRates const ra = exact.rates(u);
                motion::MotionRates const rb = material.rates(phi);
                CHECK(std::abs(material.angles(phi).u - u) < 1e-14);
                for (Vec2 const& x : {Vec2(0, 0), Vec2(0.25, 0.8), Vec2(-0.3, 0.4)}) {
                    CHECK((a(x) - b(x)).norm() < 1e-13);
                    CHECK((g * ra.twist(x) - rb.twist(x)).norm() < 1e-12);
                    CHECK((g * g * ra.change(x) + g1 * ra.twist(x) - rb.change(x)).norm() < change_limit);
                }
            }
        }
    }
}

TEST_CASE("the inextensional mode is the first-order motion's displacement", "[motion][material]")
{
    for (auto const& [name, shape] : smooth_families(type50_w0)) {
        INFO(name);
        wavegen::MaterialDisplacement const mode = wavegen::inextensional_mode(shape);
        motion::FirstOrderMotion<wavegen::AnyWaveShape> const first(shape, type50_r_m, type50_ratio);
        CHECK(is_symmetric(mode));
        for (double phi : {-1.5, -0.4, 0.0, 0.3, 1.2}) {
            wavegen::PointDisplacement const at = wavegen::displacement_at(mode, phi);
            wavegen::RadialDisplacement const d = shape(phi);
            CHECK(at.w[0] == Approx(d.w).margin(1e-14));
            CHECK(at.w[1] == Approx(d.w1).margin(1e-13));
            CHECK(at.w[2] == Approx(d.w2).margin(1e-12));
            CHECK(at.w[3] == Approx(d.w3).margin(1e-11));
            CHECK(at.v[0] == Approx(first.v(phi)).margin(1e-14));
        }
    }
    // in closed form for the cosine cam
    wavegen::MaterialDisplacement const mode = wavegen::inextensional_mode(wavegen::CosineCam{type50_w0, 3});
    REQUIRE(mode.harmonics.size() == 2);
    CHECK(mode.harmonics[0].w_cosine == 0);
    CHECK(mode.harmonics[1].w_cosine == Approx(type50_w0).epsilon(1e-15));
    CHECK(mode.harmonics[1].v_sine == Approx(-type50_w0 / 3).epsilon(1e-15));
}

TEST_CASE("the three motion models differ by terms of second order in w0", "[motion][material]")
{
    std::array<std::array<double, 3>, 4> apart{};
    for (std::size_t i = 0; i < apart.size(); ++i) {
        double const w0 = 0.2 * std::pow(0.5, static_cast<double>(i));
        Exact const exact = type50_motion(2, w0);
        FirstOrder const first = type50_first_order(2, w0);
        motion::MaterialMotion const material(wavegen::inextensional_mode(wavegen::CosineCam{w0, 2}), type50_r_m,
                                              type50_ratio);
        for (double u = -1.5; u < 1.6; u += 0.1) {
            double const phi = exact.angles(u).phi;
            for (Vec2 const& x : {Vec2(0, 0), Vec2(0.25, 0.8)}) {
                Vec2 const e = exact.pose(u)(x), f = first.pose(phi)(x), m = material.pose(phi)(x);
                apart[i][0] = std::max(apart[i][0], (m - e).norm());
                apart[i][1] = std::max(apart[i][1], (m - f).norm());
                apart[i][2] = std::max(apart[i][2], (f - e).norm());
            }
        }
    }
    for (std::size_t pair = 0; pair < 3; ++pair) {
        for (std::size_t i = 0; i + 1 < apart.size(); ++i) {
            INFO("pair " << pair << ", w0 = " << 0.2 * std::pow(0.5, static_cast<double>(i)) << ": " << apart[i][pair]
                         << " mm");
            CHECK(std::log2(apart[i][pair] / apart[i + 1][pair]) == Approx(2).margin(0.05));
        }
    }
}

TEST_CASE("material motion: a lobe moves the tooth by whole pitches, and sides are mirror images", "[motion][material]")
{
    for (int waves : {1, 2, 3}) {
        motion::MaterialMotion const skew(lopsided(waves), type50_r_m, type50_ratio);
        CHECK_FALSE(skew.symmetric());
        CHECK(skew.breaks().empty());
        double const turned = (1 - type50_ratio) * 2 * skew.half_lobe();
        for (double phi : {-0.9, 0.1, 0.6}) {
            Vec2 const x(0.2, 0.5);
            CHECK((turned_clockwise(skew.pose(phi)(x), turned) - skew.pose(phi + 2 * skew.half_lobe())(x)).norm() <
                  2e-14 * (1 + phi * phi));
            CHECK((skew.rates(phi).twist(x) - skew.rates(phi + 2 * skew.half_lobe()).twist(x)).norm() < 5e-14);
        }
        motion::MaterialMotion const even(wavegen::inextensional_mode(wavegen::CosineCam{type50_w0, waves}), type50_r_m,
                                          type50_ratio);
        REQUIRE(even.symmetric());
        for (double phi : {0.1, 0.7, 1.4}) {
            Vec2 const right = even.pose(phi)({0.2, 0.5});
            Vec2 const left = even.pose(-phi)({-0.2, 0.5});
            CHECK(left.x() == -right.x());
            CHECK(left.y() == right.y());
        }
    }
}

TEST_CASE("material motion: a symmetric displacement, and pose and rates at once, have the bits of the general way",
          "[motion][material]")
{
    wavegen::MaterialDisplacement even;
    even.waves = 2;
    for (int k = 0; k < 9; ++k)
        even.harmonics.push_back({k == 3 ? 0 : 0.2 / (1 + k * k), 0, 0, k == 5 ? 0 : -0.1 / (1 + k * k)});
    motion::MaterialMotion const symmetric(even, type50_r_m, type50_ratio), skew(lopsided(2), type50_r_m, type50_ratio);
    REQUIRE(symmetric.symmetric());
    for (int i = -40; i <= 40; ++i) {
        double const phi = 0.04 * i;
        wavegen::PointDisplacement const one = wavegen::symmetric_displacement_at(even, phi),
                                         other = wavegen::displacement_at(even, phi);
        CHECK(one.w == other.w);
        CHECK(one.v == other.v);
        for (motion::MaterialMotion const* const motion : {&symmetric, &skew}) {
            motion::MotionState const both = motion->state(phi);
            Pose const pose = motion->pose(phi);
            motion::MotionRates const rates = motion->rates(phi);
            CHECK(both.pose.cosine == pose.cosine);
            CHECK(both.pose.sine == pose.sine);
            CHECK(both.pose.origin == pose.origin);
            CHECK(both.rates.twist.omega == rates.twist.omega);
            CHECK(both.rates.twist.q == rates.twist.q);
            CHECK(both.rates.change.omega == rates.change.omega);
            CHECK(both.rates.change.q == rates.change.q);
        }
    }
}

TEST_CASE("material motion: lengths scale with the drive bit for bit, and no displacement is the slow turn",
          "[motion][material]")
{
    motion::MaterialMotion const small(lopsided(2), type50_r_m, type50_ratio);
    motion::MaterialMotion const large(lopsided(2, 4 * type50_w0), 4 * type50_r_m, type50_ratio);
    motion::MaterialMotion const circle({2, {}}, type50_r_m, type50_ratio);
    for (double phi : {-1.1, 0.2, 0.8}) {
        CHECK(large.pose(phi).origin == 4 * small.pose(phi).origin);
        CHECK(large.pose(phi).sine == small.pose(phi).sine);
        CHECK(large.rates(phi).twist.q == 4 * small.rates(phi).twist.q);
        CHECK(large.rates(phi).change.omega == small.rates(phi).change.omega);
        CHECK(circle.pose(phi).sine == Approx(std::sin((1 - type50_ratio) * phi)).epsilon(1e-15));
        CHECK(circle.rates(phi).twist.omega == 1 - type50_ratio);
        CHECK(circle.rates(phi).twist.q.x() == Approx((1 - type50_ratio) * type50_r_m).epsilon(1e-14));
        CHECK(circle.rates(phi).twist.q.y() == 0);
    }
}

TEST_CASE("material motion: what folds back or is no series is refused with its place", "[motion][material]")
{
    auto const refused = [](wavegen::MaterialDisplacement const& d) {
        CHECK_THROWS_WITH(motion::MaterialMotion(d, type50_r_m, type50_ratio),
                          ContainsSubstring("phi = ") && ContainsSubstring("make the displacement smaller"));
    };
    refused({2, {{}, {25, 0, 0, 0}}});     // through the axis
    refused({2, {{}, {0.25, 0, 0, 13}}});  // v' = -26 at 90 degrees
    refused({2, {{std::numeric_limits<double>::quiet_NaN(), 0, 0, 0}}});
    wavegen::MaterialDisplacement limit{2, {{}, {0, 0, 0, type50_r_m / 2}}};
    refused(limit);  // v' = -r_m just there
    limit.harmonics[1].v_sine *= 1 - 0x1p-40;
    CHECK_THROWS_WITH(motion::MaterialMotion(limit, type50_r_m, type50_ratio), ContainsSubstring("cannot be told"));
    limit.harmonics[1].v_sine *= 0.99;
    CHECK_NOTHROW(motion::MaterialMotion(limit, type50_r_m, type50_ratio));

    CHECK_THROWS_WITH(wavegen::inextensional_mode(Cornered{}), ContainsSubstring("not smooth enough"));
    wavegen::FourRoller const rollers(type50_w0, pi / 6, 2);
    CHECK_THROWS_WITH(inextensional_mode(rollers), ContainsSubstring("third derivative jumps"));
    CHECK_THROWS_WITH(wavegen::displacement_of(wavegen::NeutralCurve<wavegen::FourRoller>(rollers, type50_r_m)),
                      ContainsSubstring("third derivative jumps"));
}

}  // namespace hdconj::test::material_motion_cases
