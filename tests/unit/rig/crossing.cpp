// SPDX-License-Identifier: GPL-3.0-or-later
// Readings inside the backlash or too few beside it, curves that bend near zero torque, bends near either end, and logs
// without strays.
#include <cmath>
#include <random>

#include "hdconj/measured.hpp"
#include "support/catch.hpp"
#include "support/rig_loop.hpp"

namespace hdconj::test::crossing_cases {

using sample::minute;
using sample::nm;
using sample::Rig;
using sample::rig_loop;

namespace {

MeasuredCurve without_readings(MeasuredCurve curve)
{
    curve.twist.clear();
    curve.torque.clear();
    curve.line.clear();
    return curve;
}

void append(MeasuredCurve& curve, double twist, double torque)
{
    curve.twist.push_back(twist);
    curve.torque.push_back(torque);
    curve.line.push_back(static_cast<int>(curve.line.size()) + 2);
}

/// @p curve with @p count readings on each way across the backlash, which stays at one torque within 0.05 N m.
MeasuredCurve sampled_by_time(MeasuredCurve const& curve, Rig const& rig, int count)
{
    MeasuredCurve result = without_readings(curve);
    std::mt19937 random(rig.seed);
    std::normal_distribution<double> scatter(0, 0.05 * nm);
    auto const add = [&](double twist, double torque) { append(result, twist, torque); };
    for (std::size_t i = 0; i < curve.twist.size(); ++i) {
        double const before = i > 0 ? curve.twist[i - 1] : 0;
        if (i > 1 && std::abs(curve.twist[i] - before) > rig.drive.backlash / 2)
            for (int j = 1; j <= count; ++j) {
                double const side = curve.twist[i] > before ? 1 : -1;
                add(std::lerp(before, curve.twist[i], j / (count + 1.0)),
                    rig.torque_offset + side * rig.coulomb + scatter(random));
            }
        add(curve.twist[i], curve.torque[i]);
    }
    return result;
}

/// @p curve with readings where the torque turns round: the angle rests until the friction is overcome.
MeasuredCurve resting_at_reversals(MeasuredCurve const& curve, Rig const& rig)
{
    MeasuredCurve result = without_readings(curve);
    std::mt19937 random(rig.seed);
    std::normal_distribution<double> noise(0, rig.angle_noise);
    auto const add = [&](double twist, double torque) { append(result, twist, torque); };
    for (std::size_t i = 0; i < curve.twist.size(); ++i) {
        add(curve.twist[i], curve.torque[i]);
        bool const turns = i > 0 && i + 1 < curve.torque.size() &&
                           (curve.torque[i] - curve.torque[i - 1]) * (curve.torque[i + 1] - curve.torque[i]) < 0;
        constexpr int readings = 12;
        for (int j = 1; turns && j <= readings; ++j)
            add(curve.twist[i] + noise(random), std::lerp(curve.torque[i], curve.torque[i + 1], j / (readings + 1.0)));
    }
    return result;
}

double pull(Estimate const& found, double wanted)
{
    return std::abs(found.value - wanted) / found.error;
}

}  // namespace

TEST_CASE("readings inside the backlash do not change it", "[load][measured]")
{
    for (int const count : {1, 5, 10})
        for (auto const& [friction, offset] : {std::pair(0.7, 0.0), {1.5, 0.0}, {0.0, 3.0}, {0.0, 1.0}, {1.0, -5.0}})
            for (unsigned seed = 1; seed <= 5; ++seed) {
                Rig rig;
                rig.cycles = 2;
                rig.per_branch = 60;
                rig.angle_noise = 0.03 * minute;
                rig.coulomb = friction * nm;
                rig.torque_offset = offset * nm;
                rig.seed = seed;
                auto const found = measured_stiffness(sampled_by_time(rig_loop(rig), rig, count));
                INFO(count << " readings, friction " << friction << ", offset " << offset << ", seed " << seed);
                CHECK(pull(found.backlash, rig.drive.backlash) < 4);
                CHECK(found.backlash.error < 0.5 * minute);
                CHECK(pull(found.first, rig.drive.first) < 4);
                CHECK(std::abs(found.torque_middle - rig.torque_offset) < 0.3 * nm);
            }
}

TEST_CASE("where too few readings show the backlash, friction under load tells it from the loop", "[load][measured]")
{
    constexpr int tries = 25;
    for (int const per_branch : {14, 16, 20})
        for (double const friction : {0.0, 0.3, 0.5}) {
            double squares = 0, mean = 0;
            Rig rig;
            rig.drive.backlash = 1 * minute;
            rig.drive.first = 100 * sample::nm_per_degree;
            rig.cycles = 2;
            rig.per_branch = per_branch;
            rig.angle_noise = 0.02 * minute;
            rig.coulomb = friction * nm;
            for (rig.seed = 1; rig.seed <= tries; ++rig.seed) {
                auto const found = measured_stiffness(rig_loop(rig));
                double const deviation = (found.backlash.value - rig.drive.backlash) / found.backlash.error;
                squares += deviation * deviation / tries;
                mean += deviation / tries;
                CHECK(found.backlash.value + found.friction_width.value ==
                      Approx(found.loop_width.value).epsilon(1e-12));
                CHECK(found.backlash.error < 0.25 * minute);
            }
            INFO(per_branch << " readings, friction " << friction << ", " << std::sqrt(squares) << ", " << mean);
            CHECK(std::sqrt(squares) < 1.2);
            CHECK(std::abs(mean) < 0.6);  // three standard errors of the mean of so many
        }
}

TEST_CASE("a drift that nothing tells is in the error of the backlash", "[load][measured]")
{
    Rig rig;
    rig.cycles = 1;  // nothing is repeated
    rig.last_stretch = false;
    rig.per_branch = 20;
    rig.angle_noise = 0.01 * minute;
    for (double const drift : {-1.0, 1.0}) {
        rig.drift = drift * minute;
        auto const backlash = measured_stiffness(rig_loop(rig)).backlash;
        CHECK(pull(backlash, rig.drive.backlash) < 2);
        CHECK(backlash.error < 1.5 * minute);
    }
    rig.per_branch = 300;
    rig.coulomb = 4 * nm;  // the drift hides it, and the backlash is crossed far from zero torque
    rig.drift = -4 * minute;
    rig.angle_noise = 0.2 * minute;
    for (rig.seed = 1; rig.seed <= 5; ++rig.seed)
        CHECK(pull(measured_stiffness(rig_loop(rig)).backlash, rig.drive.backlash) < 3);
}

TEST_CASE("the error of the backlash contains the curvature below the readings", "[load][measured]")
{
    for (int const per_branch : {60, 100, 300})
        for (double const noise : {0.0, 0.03})
            for (unsigned seed = 1; seed <= 10; ++seed) {
                Rig rig;
                rig.cycles = 2;
                rig.per_branch = per_branch;
                rig.angle_noise = noise * minute;
                rig.seed = seed;
                auto curve = rig_loop(rig);
                for (std::size_t i = 0; i < curve.twist.size(); ++i)  // 1.2' (T/N m)^0.8: steep where the load begins
                    curve.twist[i] +=
                        std::copysign(1.2 * minute * std::pow(std::abs(curve.torque[i]) / nm, 0.8), curve.torque[i]);
                auto const found = measured_stiffness(curve);
                INFO(per_branch << " readings, noise " << noise << ", seed " << seed);
                CHECK(pull(found.backlash, rig.drive.backlash) < 4);
                CHECK(pull(found.loop_width, rig.drive.backlash) < 4);
            }
}

TEST_CASE("curvature that noise hides is in the error of the backlash", "[load][measured]")
{
    constexpr int tries = 30;
    for (auto const& [per_branch, noise] :
         {std::pair(20, 0.05), {30, 0.05}, {60, 0.05}, {60, 0.1}, {200, 0.1}, {200, 0.3}}) {
        double of_backlash = 0, of_width = 0;
        Rig rig;
        rig.cycles = 2;
        rig.per_branch = per_branch;
        rig.angle_noise = noise * minute;
        for (rig.seed = 1; rig.seed <= tries; ++rig.seed) {
            auto curve = rig_loop(rig);
            for (std::size_t i = 0; i < curve.twist.size(); ++i)  // 2' (1 - exp(-T/4 N m)): soft where the load begins
                curve.twist[i] -=
                    std::copysign(2 * minute * std::expm1(-std::abs(curve.torque[i]) / (4 * nm)), curve.torque[i]);
            auto const found = measured_stiffness(curve);
            of_backlash += std::pow(pull(found.backlash, rig.drive.backlash), 2) / tries;
            of_width += std::pow(pull(found.loop_width, rig.drive.backlash), 2) / tries;
        }
        INFO(per_branch << " readings, noise " << noise);
        CHECK(std::sqrt(of_backlash) < 1.3);
        CHECK(std::sqrt(of_width) < 1.3);
        CHECK(std::sqrt(of_backlash) > 0.5);
    }
}

TEST_CASE("a stage with fewer than three readings is not determined", "[load][measured]")
{
    Rig rig;
    rig.cycles = 2;
    rig.per_branch = 10;
    rig.angle_noise = 0.03 * minute;
    rig.drive = {5 * minute, 250 * sample::nm_per_degree, 550 * sample::nm_per_degree, 24 * nm};
    int determined = 0;
    for (rig.seed = 1; rig.seed <= 40; ++rig.seed) {
        auto const found = measured_stiffness(rig_loop(rig));
        determined += found.second.count > 0 ? 1 : 0;
        CHECK(found.second.count == found.knee.count);
        CHECK((found.first.count == 0 || pull(found.first, rig.drive.first) < 4));
    }
    CHECK(determined <= 2);
}

TEST_CASE("of a hundred logs without strays at most one loses a reading", "[load][measured]")
{
    int logs = 0, losing = 0;
    for (double const friction : {0.0, 3.0})
        for (int const per_branch : {30, 60})
            for (unsigned seed = 1; seed <= 100; ++seed) {
                Rig rig;
                rig.cycles = 2;
                rig.per_branch = per_branch;
                rig.angle_noise = 0.03 * minute;
                rig.coulomb = friction * nm;
                rig.seed = seed;
                ++logs;
                losing += measured_stiffness(resting_at_reversals(rig_loop(rig), rig)).strays.empty() ? 0 : 1;
            }
    CHECK(losing <= logs / 100);
}

}  // namespace hdconj::test::crossing_cases
