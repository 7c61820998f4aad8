// SPDX-License-Identifier: GPL-3.0-or-later
// The circular spline as the flexspline tooth sees it: the inverse of the motion, its rates, its lobes.
#include "hdconj/motion/inverse_motion.hpp"

#include <cmath>
#include <numbers>

#include "hdconj/motion/any_motion.hpp"
#include "hdconj/motion/material_motion.hpp"
#include "hdconj/wavegen/inextensional_mode.hpp"
#include "support/catch.hpp"
#include "support/oracle/motion.hpp"
#include "support/type50.hpp"

namespace hdconj::test::inverse_motion_cases {

namespace {

constexpr double pitch = 2 * std::numbers::pi / type50_z_c;
constexpr double seat_radius = 25.55;
constexpr double angles[] = {-1.5, -0.9, -0.3, -0.01, 0.0, 0.2, 0.77, 1.5};

/// A point of circular-spline tooth @p k in the flexspline tooth's frame, in long double by the oracle's own motion.
oracle::Point<long double> seen(oracle::Motion<long double> const& motion, long double u, int k,
                                oracle::Point<long double> const& p)
{
    using Real = long double;
    Real const angle = (static_cast<Real>(k) - 0.5L) * motion.pitch();
    // its y axis points at the centre, its x axis to the left as seen from there
    oracle::Point<Real> const upright{-p.x, static_cast<Real>(seat_radius) - p.y};
    return motion.pose(u).to_tooth(oracle::turned_clockwise(upright, angle));
}

}  // namespace

TEST_CASE("the inverse motion composed with the motion is the seat", "[motion][reverse]")
{
    auto const closes = [](auto const& motion) {
        for (int k : {-1, 0, 1, 2}) {
            Pose const seat = motion::circular_spline_seat(k, pitch, seat_radius);
            motion::InverseMotion const inverse(motion, seat);
            for (double u : angles) {
                for (Vec2 const& x : {Vec2(0, 0), Vec2(0.3, 0.5), Vec2(-0.2, -0.1)})
                    CHECK((motion.pose(u)(inverse.pose(u)(x)) - seat(x)).norm() < 8 * seat_radius * unit_roundoff);
            }
        }
    };
    closes(type50_motion());
    closes(type50_motion(3));
    closes(type50_first_order());
    closes(motion::MaterialMotion(wavegen::inextensional_mode(wavegen::CosineCam{type50_w0, 2}), type50_r_m,
                                  type50_ratio));
}

TEST_CASE("rates of the inverse motion are the derivatives of its pose, in long double", "[motion][reverse]")
{
    for (int waves : {1, 2, 3}) {
        Scene scene = builtin_scene();
        scene.wave_generator.waves = waves;
        scene.drive.flexspline_teeth = type50_z_f;
        scene.drive.circular_spline_teeth = type50_z_c;
        oracle::Motion<long double> const reference(scene);
        Exact const motion = type50_motion(waves);
        for (int k : {0, 1}) {
            motion::InverseMotion const inverse(motion, motion::circular_spline_seat(k, pitch, seat_radius));
            for (double u : angles) {
                motion::MotionRates const rates = inverse.rates(u);
                Pose const pose = inverse.pose(u);
                for (Vec2 const& x : {Vec2(0, 0), Vec2(0.25, 0.5), Vec2(-0.2, 0.1)}) {
                    oracle::Point<long double> const p{x.x(), x.y()};
                    constexpr long double h = 1e-4L;
                    auto const at = [&](int steps) {
                        return seen(reference, static_cast<long double>(u) + static_cast<long double>(steps) * h, k, p);
                    };
                    // differences of sixth order: error h^6, rounding 1e-19/h
                    auto const first =
                        (1 / (60 * h)) * ((at(3) - at(-3)) + (-9.0L) * (at(2) - at(-2)) + 45.0L * (at(1) - at(-1)));
                    auto const second = (1 / (180 * h * h)) * ((-490.0L) * at(0) + 270.0L * (at(1) + at(-1)) +
                                                               (-27.0L) * (at(2) + at(-2)) + 2.0L * (at(3) + at(-3)));
                    Vec2 const place(static_cast<double>(at(0).x), static_cast<double>(at(0).y));
                    Vec2 const velocity(static_cast<double>(first.x), static_cast<double>(first.y));
                    Vec2 const acceleration(static_cast<double>(second.x), static_cast<double>(second.y));
                    Vec2 const own = rates.twist(x);
                    // p'' = R (omega right_of(v) + v')
                    Vec2 const own_change = rates.twist.omega * right_of(own) + rates.change(x);
                    CHECK((place - pose(x)).norm() < 1e-13);
                    CHECK((velocity - pose.rotate(own)).norm() < 1e-12);
                    CHECK((acceleration - pose.rotate(own_change)).norm() < 1e-9);
                    CHECK(own.norm() <= rates.velocity_size(x));
                    CHECK(rates.change(x).norm() <= rates.velocity_change_size(x));
                }
            }
        }
    }
}

TEST_CASE("after a lobe each tooth does what another one does in this", "[motion][reverse]")
{
    Exact const motion = type50_motion();
    double const lobe = 2 * motion.half_lobe();
    for (int k : {0, 1, 2}) {
        motion::InverseMotion const late(motion, motion::circular_spline_seat(k, pitch, seat_radius));
        motion::InverseMotion const now(motion, motion::circular_spline_seat(k - 1, pitch, seat_radius));
        for (double u : {-1.2, 0.0, 0.4}) {
            Vec2 const x(0.1, 0.3);
            CHECK((late.pose(u + lobe)(x) - now.pose(u)(x)).norm() < 1e-12);
            CHECK((late.rates(u + lobe).twist(x) - now.rates(u).twist(x)).norm() < 1e-12);
        }
    }
}

TEST_CASE("teeth 0 and 1 are each other's mirror image", "[motion][reverse]")
{
    Exact const motion = type50_motion();
    motion::InverseMotion const left(motion, motion::circular_spline_seat(0, pitch, seat_radius));
    motion::InverseMotion const right(motion, motion::circular_spline_seat(1, pitch, seat_radius));
    for (double u : angles) {
        Vec2 const a = right.pose(u)({0.2, 0.3});
        Vec2 const b = left.pose(-u)({-0.2, 0.3});
        CHECK(a.x() == -b.x());
        CHECK(a.y() == b.y());
    }
}

TEST_CASE("an erased motion is the motion, bit for bit", "[motion][reverse]")
{
    Exact const motion = type50_motion();
    motion::AnyMotion const erased(motion);
    CHECK(erased.half_lobe() == motion.half_lobe());
    CHECK(erased.symmetric() == motion.symmetric());
    CHECK(erased.breaks().size() == motion.breaks().size());
    for (double u : angles) {
        CHECK(erased.pose(u).origin == motion.pose(u).origin);
        CHECK(erased.rates(u).twist.q == motion.rates(u).twist.q);
        CHECK(erased.rates(u).change.omega == motion.rates(u).change.omega);
        CHECK(erased.angles(u).phi == motion.angles(u).phi);
    }
}

}  // namespace hdconj::test::inverse_motion_cases
