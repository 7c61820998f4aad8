// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <fstream>

#include "hdconj/error.hpp"
#include "hdconj/load_files.hpp"
#include "hdconj/measured.hpp"
#include "support/catch.hpp"
#include "support/rig_loop.hpp"
#include "support/temporary_folder.hpp"

namespace hdconj::test::measured_cases {

using sample::minute;
using sample::nm;
using sample::nm_per_degree;
using sample::Rig;
using sample::rig_loop;
using test::TemporaryFolder;

namespace {

MeasuredReading read(std::string const& text, RigOptions const& rig = {}, double ratio = 100)
{
    TemporaryFolder const folder;
    std::ofstream(folder / "curve.csv") << text;
    return examine_measured(folder / "curve.csv", rig, ratio);
}

/// What a user reads, without the folder of the test.
std::string refusal(std::string const& text, RigOptions const& rig = {})
{
    auto const reading = read(text, rig);
    REQUIRE_FALSE(reading.faults.empty());
    for (auto const& fault : reading.faults) {
        CHECK_FALSE(fault.reason.empty());
        CHECK_FALSE(fault.remedy.empty());
    }
    auto told = describe(reading.faults);
    auto const name = told.find("curve.csv");
    return name == std::string::npos ? told : told.substr(name);
}

void check_near(Estimate const& found, double wanted, double within)
{
    CHECK(std::abs(found.value - wanted) <= within);
}

}  // namespace

TEST_CASE("an exact loop gives play and stages back", "[load][measured]")
{
    for (double const offset : {0.0, 0.02}) {
        Rig rig;
        rig.offset = offset;
        auto const found = measured_stiffness(rig_loop(rig));
        CHECK(found.cycles == 4);
        CHECK(found.largest_torque == rig.torque);
        check_near(found.backlash, rig.drive.backlash, 1e-9 * rig.drive.backlash);
        check_near(found.first, rig.drive.first, 1e-6 * rig.drive.first);
        check_near(found.second, rig.drive.second, 1e-6 * rig.drive.second);
        check_near(found.knee, rig.drive.knee, 1e-5 * rig.drive.knee);
        CHECK(found.middle == Approx(offset).margin(1e-12));
        CHECK(found.loop_width.count == 4);
        CHECK(found.backlash.count == 7);
        CHECK(found.first.count == 8);
        CHECK(found.straight == 0);
        CHECK(found.first.error < 1e-6 * rig.drive.first);
    }
}

TEST_CASE("friction widens the loop and is told from backlash", "[load][measured]")
{
    Rig lag;
    lag.friction = 0.7 * minute;
    Rig coulomb;
    coulomb.coulomb = 1.1 * nm;
    for (auto const& [rig, width] :
         {std::pair(lag, 2 * lag.friction), std::pair(coulomb, 2 * coulomb.coulomb / coulomb.drive.first)}) {
        auto const found = measured_stiffness(rig_loop(rig));
        check_near(found.backlash, rig.drive.backlash, 1e-9);
        check_near(found.friction_width, width, 1e-9);
        check_near(found.loop_width, rig.drive.backlash + width, 1e-9);
        check_near(found.first, rig.drive.first, 1e-6 * rig.drive.first);
        check_near(found.second, rig.drive.second, 1e-6 * rig.drive.second);
        check_near(found.knee, rig.drive.knee + rig.coulomb, 1e-5 * rig.drive.knee);
    }
}

TEST_CASE("friction of any size does not change backlash and stages", "[load][measured]")
{
    for (int const per_branch : {30, 200})
        for (double const share : {0.02, 0.035, 0.06, 0.1, 0.125, 0.18, 0.25})
            for (double const noise : {0.0, 0.02}) {
                Rig rig;
                rig.per_branch = per_branch;
                rig.coulomb = share * rig.torque + 1;
                rig.angle_noise = noise * minute;
                INFO(per_branch << " readings a branch, friction " << rig.coulomb / nm << " N m, noise " << noise);
                auto const found = measured_stiffness(rig_loop(rig));
                check_near(found.backlash, rig.drive.backlash, 1e-9 + 4 * found.backlash.error);
                check_near(found.friction_width, 2 * rig.coulomb / rig.drive.first,
                           1e-9 + 4 * found.friction_width.error);
                CHECK(found.backlash.error < 0.1 * minute);
                check_near(found.first, rig.drive.first, (0.001 + noise) * rig.drive.first);
                check_near(found.second, rig.drive.second, (0.001 + noise) * rig.drive.second);
                check_near(found.knee, rig.drive.knee + rig.coulomb, 0.02 * rig.drive.knee);
            }
}

TEST_CASE("where friction hides the play, backlash and stiffness are not determined", "[load][measured]")
{
    Rig rig;
    rig.coulomb = 0.9 * rig.torque;  // the flanks meet where the branch ends
    for (bool const coarse : {false, true}) {
        if (coarse) {
            rig.per_branch = 9;
            rig.coulomb = 0.2 * rig.torque;
        }
        auto const found = measured_stiffness(rig_loop(rig));
        CHECK(found.loop_width.count > 0);
        for (auto const& each :
             {found.backlash, found.friction_width, found.first, found.second, found.knee, found.whole})
            CHECK(each.count == 0);
        CHECK(found.straight == 0);
    }
}

TEST_CASE("a loop of friction alone has no backlash", "[load][measured]")
{
    Rig rig;
    rig.drive.backlash = 0;
    rig.coulomb = 1.1 * nm;
    rig.angle_noise = 0.1 * minute;
    auto const found = measured_stiffness(rig_loop(rig));
    CHECK(found.loop_width.value > 10 * found.loop_width.error);
    check_near(found.backlash, 0, 3 * found.backlash.error);
    CHECK(found.backlash.error < found.loop_width.value / 5);
}

TEST_CASE("a drift beyond the twist under load is found too", "[load][measured]")
{
    Rig rig;
    rig.drift = 60 * minute;
    rig.angle_noise = 0.02 * minute;
    check_near(measured_stiffness(rig_loop(rig)).backlash, rig.drive.backlash, 0.1 * minute);
}

TEST_CASE("an even drift of the angle is found and taken out", "[load][measured]")
{
    Rig rig;
    rig.drift = 3 * minute;
    auto const found = measured_stiffness(rig_loop(rig));
    check_near(found.drift, rig.drift, 1e-9);
    check_near(found.backlash, rig.drive.backlash, 1e-9);
    check_near(found.second, rig.drive.second, 1e-6 * rig.drive.second);
    rig.cycles = 1;  // nothing is repeated
    CHECK(measured_stiffness(rig_loop(rig)).drift.count == 0);
}

TEST_CASE("stray readings are left out, and only they", "[load][measured]")
{
    for (double const step : {0.0, 0.108}) {
        Rig rig;
        rig.angle_noise = 0.1 * minute;
        rig.angle_step = step * minute;
        CHECK(measured_stiffness(rig_loop(rig)).strays.empty());
        auto curve = rig_loop(rig);
        std::vector<std::size_t> const off = {50, 51, 333, 402, 820, 1190, 1417};
        for (std::size_t const i : off)
            curve.twist[i] += (i % 2 == 0 ? 20 : -20) * minute;
        curve.torque[700] += 15 * nm;
        auto const found = measured_stiffness(curve);
        std::vector<std::size_t> wanted = off;
        wanted.insert(wanted.begin() + 4, 700);
        CHECK(found.strays == wanted);
        check_near(found.second, rig.drive.second, 0.02 * rig.drive.second);
    }
}

TEST_CASE("one wrong torque changes neither drift nor loop", "[load][measured]")
{
    for (int const per_branch : {28, 56})
        for (double const part : {-0.3, -0.2, 0.2, 0.3}) {
            Rig rig;
            rig.cycles = 2;
            rig.per_branch = per_branch;
            rig.angle_noise = 0.02 * minute;
            rig.coulomb = 0.6 * nm;
            std::size_t const readings = rig_loop(rig).torque.size();
            for (std::size_t i = 4; i + 4 < readings; i += 3) {
                auto curve = rig_loop(rig);
                curve.torque[i] += part * rig.torque;
                auto const found = measured_stiffness(curve);
                INFO(per_branch << " a branch, " << part << " of the torque at reading " << i);
                REQUIRE(found.drift.count > 0);
                CHECK(std::abs(found.drift.value) < 5 * found.drift.error);
                CHECK(std::abs(found.friction.value - rig.coulomb) < 5 * found.friction.error);
                CHECK(std::abs(found.backlash.value - rig.drive.backlash) < 5 * found.backlash.error);
            }
        }
}

TEST_CASE("with strays, drift and friction the stated errors are those that are met", "[load][measured]")
{
    constexpr int tries = 60;
    double backlash = 0, first = 0, second = 0, knee = 0;
    auto const pull = [](Estimate const& found, double wanted) {
        return std::pow((found.value - wanted) / found.error, 2) / tries;
    };
    for (unsigned seed = 1; seed <= tries; ++seed) {
        Rig rig;
        rig.per_branch = 100;
        rig.cycles = 3;
        rig.angle_noise = 0.15 * minute;
        rig.coulomb = 0.8 * nm;
        rig.drift = 3 * minute;
        rig.strays = 0.01;
        rig.stray_size = 20 * minute;
        rig.seed = seed;
        auto const found = measured_stiffness(rig_loop(rig));
        backlash += pull(found.backlash, rig.drive.backlash);
        first += pull(found.first, rig.drive.first);
        second += pull(found.second, rig.drive.second);
        knee += pull(found.knee, rig.drive.knee + rig.coulomb);
    }
    for (double const squares : {backlash, first, second, knee}) {
        CHECK(std::sqrt(squares) > 0.7);
        CHECK(std::sqrt(squares) < 1.25);
    }
}

TEST_CASE("backlash that noise hides, or that is none, is found without bias under any friction", "[load][measured]")
{
    constexpr int tries = 120;
    for (double const backlash : {0.0, 0.2, 3.0})
        for (double const friction : {0.0, 0.8, 2.0, 5.0, 10.0})
            for (int const per_branch : {40, 150}) {
                double squares = 0, mean = 0, first = 0;
                for (unsigned seed = 1; seed <= tries; ++seed) {
                    Rig rig;
                    rig.drive.backlash = backlash * minute;
                    rig.per_branch = per_branch;
                    rig.cycles = 3;
                    rig.angle_noise = 0.1 * minute;
                    rig.coulomb = friction * nm;
                    rig.seed = seed;
                    auto const found = measured_stiffness(rig_loop(rig));
                    double const pull = (found.backlash.value - rig.drive.backlash) / found.backlash.error;
                    squares += pull * pull / tries;
                    mean += pull / tries;
                    first += std::pow((found.first.value - rig.drive.first) / found.first.error, 2) / tries;
                }
                INFO(backlash << "', " << friction << " N m, " << per_branch << " readings a branch");
                CHECK(std::sqrt(squares) > 0.7);
                CHECK(std::sqrt(squares) < 1.25);
                CHECK(std::abs(mean) < 0.4);  // three standard errors of the mean of so many
                CHECK(std::sqrt(first) < 1.4);
            }
}

TEST_CASE("with noise and an encoder's steps what is found lies within its own uncertainty", "[load][measured]")
{
    int outside_three = 0;
    constexpr int tries = 30;
    for (unsigned seed = 1; seed <= tries; ++seed) {
        Rig rig;
        rig.angle_noise = 0.08 * minute;
        rig.angle_step = 0.108 * minute;  // 2000 counts per turn behind 1:100
        rig.seed = seed;
        rig.cycles = 1 + static_cast<int>(seed % 4);
        auto const found = measured_stiffness(rig_loop(rig));
        INFO(seed);
        CHECK(found.angle_step == Approx(rig.angle_step).epsilon(1e-6));
        CHECK(found.cycles == rig.cycles);
        CHECK(found.backlash.error > 0);
        check_near(found.loop_width, rig.drive.backlash, 0.12 * minute);
        check_near(found.backlash, rig.drive.backlash, 0.2 * minute);
        check_near(found.first, rig.drive.first, 0.02 * rig.drive.first);
        check_near(found.second, rig.drive.second, 0.02 * rig.drive.second);
        for (auto const& [estimate, wanted] :
             {std::pair(found.backlash, rig.drive.backlash), std::pair(found.first, rig.drive.first),
              std::pair(found.second, rig.drive.second)}) {
            outside_three += std::abs(estimate.value - wanted) > 3 * estimate.error ? 1 : 0;
        }
    }
    CHECK(outside_three <= 3 * tries / 20);
}

TEST_CASE("friction is the same whatever the steps of the encoder", "[load][measured]")
{
    for (double const coulomb : {0.0, 1.3})
        for (double const step : {0.108, 0.2, 0.5})
            for (int const per_branch : {57, 200}) {
                Rig rig;
                rig.coulomb = coulomb * nm;
                rig.angle_step = step * minute;
                rig.per_branch = per_branch;
                rig.drift = 0.01 * minute;
                auto const found = measured_stiffness(rig_loop(rig));
                CAPTURE(coulomb, step, per_branch, found.friction.value / nm, found.friction.error / nm);
                check_near(found.friction, rig.coulomb, 4 * found.friction.error + 1e-9 * nm);
                CHECK(found.friction.error < 0.5 * nm);
            }
}

TEST_CASE("coarse steps of an encoder are in the error of the loop and of backlash", "[load][measured]")
{
    for (unsigned seed = 1; seed <= 10; ++seed) {
        Rig rig;
        rig.drive.backlash = (5 + 0.03 * seed) * minute;
        rig.angle_step = 0.3 * minute;  // all branches round to the same side
        rig.angle_noise = 0.02 * minute;
        rig.seed = seed;
        auto const found = measured_stiffness(rig_loop(rig));
        check_near(found.loop_width, rig.drive.backlash, 2 * found.loop_width.error);
        check_near(found.backlash, rig.drive.backlash, 2 * found.backlash.error);
        CHECK(found.loop_width.error < rig.angle_step);
    }
}

/// Root of the mean of squared pulls of the backlash over seeds.
double rms_pull(Rig rig)
{
    constexpr int tries = 60;
    double squares = 0;
    for (rig.seed = 1; rig.seed <= tries; ++rig.seed) {
        Estimate const found = measured_stiffness(rig_loop(rig)).backlash;
        squares += std::pow((found.value - rig.drive.backlash) / found.error, 2) / tries;
    }
    return std::sqrt(squares);
}

TEST_CASE("what the torque reads without load is taken out", "[load][measured]")
{
    for (double const offset : {-5.0, 2.5, 4.0, 6.0})
        for (double const friction : {0.0, 1.0}) {
            Rig rig;
            rig.torque_offset = offset * nm;
            rig.coulomb = friction * nm;
            rig.cycles = 2;
            rig.per_branch = 60;
            rig.angle_noise = 0.02 * minute;
            INFO(offset << " N m, friction " << friction << " N m");
            auto const found = measured_stiffness(rig_loop(rig));
            check_near(found.first, rig.drive.first, 0.02 * rig.drive.first);
            CHECK(std::abs(found.torque_middle - rig.torque_offset) < 0.3 * nm);  // readings are 0.47 N m apart
            CHECK(std::abs(found.friction.value - rig.coulomb) < 3 * found.friction.error);
            CHECK(rms_pull(rig) < 1.25);
        }
    CHECK(measured_stiffness(rig_loop({})).torque_middle == 0);
}

TEST_CASE("the error of the backlash holds for few readings and for a bend near zero torque", "[load][measured]")
{
    Rig few;
    few.cycles = 2;
    few.angle_noise = 0.02 * minute;
    for (int const per_branch : {20, 30, 60}) {
        few.per_branch = per_branch;
        INFO(per_branch << " readings from 0 to the largest torque");
        CHECK(rms_pull(few) < 1.25);
        CHECK(rms_pull(few) > 0.5);
    }
    Rig bent = few;
    bent.drive.knee = 2.5 * nm;
    bent.per_branch = 100;
    CHECK(rms_pull(bent) < 1.25);
    CHECK(rms_pull(bent) > 0.5);
}

TEST_CASE("steps of an encoder are in the error of the stiffness", "[load][measured]")
{
    for (auto const& [step, drift] : {std::pair(0.3, 0.0), {0.5, 0.0}, {0.3, 2.0}}) {
        Rig rig;
        rig.drift = drift * minute;
        rig.cycles = 2;
        rig.per_branch = 60;
        rig.angle_noise = 0.02 * minute;
        rig.angle_step = step * minute;
        for (rig.seed = 1; rig.seed <= 10; ++rig.seed) {
            auto const found = measured_stiffness(rig_loop(rig));
            INFO(step << "', seed " << rig.seed);
            check_near(found.first, rig.drive.first, 2 * found.first.error);
            check_near(found.second, rig.drive.second, 2 * found.second.error);
            check_near(found.knee, rig.drive.knee, 2 * found.knee.error);
        }
    }
}

TEST_CASE("a curve written by hand has play and stiffness too", "[load][measured]")
{
    Rig rig;
    rig.cycles = 1;
    rig.per_branch = 7;  // every 4 N m
    rig.last_stretch = false;
    auto const found = measured_stiffness(rig_loop(rig));
    CHECK(found.cycles == 1);
    check_near(found.backlash, rig.drive.backlash, 1e-9);
    CHECK(found.whole.count == 2);
    CHECK(found.whole.value > rig.drive.first);
    CHECK(found.whole.value < rig.drive.second);
    CHECK(found.backlash.error > 0);
}

TEST_CASE("one straight stage is not made two", "[load][measured]")
{
    Rig rig;
    rig.drive.second = rig.drive.first;
    rig.angle_noise = 0.05 * minute;
    auto const found = measured_stiffness(rig_loop(rig));
    CHECK(found.first.count == 0);
    CHECK(found.straight == 8);
    CHECK(found.whole.value == Approx(rig.drive.first).epsilon(0.01));
}

TEST_CASE("what is no loop is refused", "[load][measured]")
{
    auto const curve = rig_loop({});
    auto const cut = [&](std::size_t from, std::size_t to) {
        auto part = curve;
        part.twist.assign(curve.twist.begin() + static_cast<std::ptrdiff_t>(from),
                          curve.twist.begin() + static_cast<std::ptrdiff_t>(to));
        part.torque.assign(curve.torque.begin() + static_cast<std::ptrdiff_t>(from),
                           curve.torque.begin() + static_cast<std::ptrdiff_t>(to));
        return part;
    };
    CHECK_THROWS_WITH(measured_stiffness(cut(0, 5)), ContainsSubstring("5 samples"));
    CHECK_THROWS_WITH(measured_stiffness(cut(0, 400)), ContainsSubstring("one sign only"));
    CHECK_THROWS_WITH(measured_stiffness(cut(0, 590)), ContainsSubstring("never taken off from the negative side"));
    CHECK_THROWS_WITH(measured_stiffness(cut(600, 1000)), ContainsSubstring("never taken off from the positive side"));
    auto turned = curve;
    for (auto& each : turned.twist)
        each = -each;
    CHECK_THROWS_WITH(measured_stiffness(turned), ContainsSubstring("torque falls while the angle grows") &&
                                                      ContainsSubstring("turn the sign of one column"));
    turned.rig.counts_per_turn = 2000;
    CHECK_THROWS_WITH(measured_stiffness(turned), ContainsSubstring("--counts-per-turn"));
    for (auto& each : turned.twist)
        each = 1;
    CHECK_THROWS_WITH(measured_stiffness(turned), ContainsSubstring("do not depend on each other"));
    auto halved = curve;
    halved.twist.pop_back();
    CHECK_THROWS_AS(measured_stiffness(halved), std::logic_error);
    CHECK_NOTHROW(measured_stiffness(cut(0, 800)));
}

TEST_CASE("angles and torques are read in every unit", "[load][measured]")
{
    constexpr double degree = sample::degree;
    struct Row
    {
        char const* text;
        double twist, torque;
    };
    for (auto const& [text, twist, torque] :
         {Row{"angle [deg], torque [N m]\n2,3\n", 2 * degree, 3 * nm},
          Row{"torque [Nm];angle [arcmin]\n3;2\n", 2 * degree / 60, 3 * nm},
          Row{"torque (N mm)\ttwist (rad)\n3\t2\n", 2, 3},
          Row{"\xef\xbb\xbfTorque [mN\xc2\xb7m],Angle [mrad]\r\n3,2\r\n", 2e-3, 3},
          Row{"# log of a rig\n\ntime [s], load [N*m], angle [°], note\n0.1, +3e0, 2, \"good\"\n", 2 * degree, 3 * nm},
          Row{"angle ['],torque [N m]\n 2 , 3 \n# end\n", 2 * degree / 60, 3 * nm},
          Row{"angle [arcsec],torque [N m]\n2,-3", 2 * degree / 3600, -3 * nm}}) {
        auto const reading = read(text);
        INFO(text << describe(reading.faults));
        REQUIRE(reading.faults.empty());
        REQUIRE(reading.curve.twist.size() == 1);
        CHECK(reading.curve.twist[0] == Approx(twist).epsilon(1e-14));
        CHECK(reading.curve.torque[0] == Approx(torque).epsilon(1e-14));
    }
}

TEST_CASE("motor current and encoder counts become torque and angle at the output", "[load][measured]")
{
    RigOptions rig;
    rig.torque_constant = 0.119;
    rig.counts_per_turn = 2000;
    // 2.3529 A of the thesis' motor are 28 N m behind 1:100; one count is 0.108 arcmin
    auto reading = read("current [A], position [counts]\n2.35294117647, 0\n0, 1\n", rig, -100);
    REQUIRE(reading.faults.empty());
    CHECK(reading.curve.torque[0] == Approx(28 * nm).epsilon(1e-9));
    CHECK(reading.curve.twist[1] == Approx(0.108 * minute).epsilon(1e-12));
    CHECK(reading.curve.rig.ratio == 100);
    rig.ratio = 50;
    rig.efficiency = 0.5;
    rig.counts_per_turn = -2000;
    reading = read("current [mA], counts\n1000, 2000\n", rig, -100);
    REQUIRE(reading.faults.empty());
    CHECK(reading.curve.torque[0] == Approx(0.119 * 50 * 0.5 * nm).epsilon(1e-12));
    CHECK(reading.curve.twist[0] == Approx(-2 * std::numbers::pi / 50).epsilon(1e-12));
    CHECK(reading.curve.line == std::vector<int>{2});
}

TEST_CASE("a measured curve by itself is told without a simulation", "[load][measured]")
{
    MeasuredCurve curve = rig_loop({});
    curve.rig.angle_per_spline = 1.01;
    std::string const told = summary_text(Measurement{curve, measured_stiffness(curve)});
    CHECK_THAT(told, ContainsSubstring("its angles are 1.01 times those of the circular spline\n"));
}

TEST_CASE("a heading written as advised is read", "[load][measured]")
{
    for (auto const& [written, advised] : {std::pair("torque in N m, angle in arcmin", "torque [N m], angle [arcmin]"),
                                           {"Torque / N m, Angle / deg", "torque [N m], angle [deg]"},
                                           {"load_Nmm, twist_rad", "load [Nmm], twist [rad]"},
                                           {"torqe [mN m], angel [deg]", "torque [mN m], angle [deg]"}}) {
        std::string const told = refusal(written + std::string("\n1,2\n")), better = advised;
        INFO(told);
        auto const comma = better.find(',');
        CHECK_THAT(told, ContainsSubstring("write " + better.substr(0, comma) + " in place of"));
        CHECK_THAT(told, ContainsSubstring("write " + better.substr(comma + 2) + " in place of"));
        CHECK(read(better + "\n1,2\n").faults.empty());
    }
    CHECK_THAT(refusal("torqe, angle [deg]\n1,2\n"),
               ContainsSubstring("write torque [N m], [N mm] or [mN m] in place of torqe"));
}

TEST_CASE("a file with faults says which where and what to write", "[load][measured]")
{
    RigOptions rig;
    rig.torque_constant = 0.119;
    rig.counts_per_turn = 2000;
    CHECK_THAT(refusal(""),
               ContainsSubstring("no header and no samples") && ContainsSubstring("angle [arcmin], torque [N m]"));
    CHECK_THAT(refusal("1,2\n3,4\n"),
               ContainsSubstring("curve.csv line 1: header") && ContainsSubstring("begins with numbers"));
    CHECK_THAT(refusal("angle [deg], torqe [N m]\n"), ContainsSubstring("no column \"torque\" or \"current\"") &&
                                                          ContainsSubstring("write torque [N m] in place of torqe"));
    CHECK_THAT(refusal("angle, torque [N m]\n"), ContainsSubstring("line 1: column 1 = angle: the unit is missing") &&
                                                     ContainsSubstring("[deg], [arcmin]"));
    CHECK_THAT(
        refusal("angle [deg], torque [lbf]\n"),
        ContainsSubstring("column 2 = torque [lbf]: the unit is not known") && ContainsSubstring("[N m], [N mm]"));
    CHECK_THAT(refusal("angle [deg], torque [N m], twist [rad]\n"),
               ContainsSubstring("column 3") && ContainsSubstring("has a column already"));
    CHECK_THAT(refusal("angle [deg], torque [N m], current [A]\n"), ContainsSubstring("they may disagree"));
    CHECK_THAT(
        refusal("angle [deg], torque [N m]\n1,2\n1,abc\n1\nnan,2\n1,\n"),
        ContainsSubstring(
            "curve.csv line 3: column 2, torque [N m] = abc: is no finite number (write a number such as 12.5)") &&
            ContainsSubstring("line 4: column 2, torque [N m]: is missing: the line has 1 field") &&
            ContainsSubstring("line 5: column 1, angle [deg] = nan: is no finite number") &&
            ContainsSubstring("line 6: column 2, torque [N m]: is empty"));
    CHECK_THAT(refusal("angle [deg], torque [N m]\n1,5, 2,25\n"),
               ContainsSubstring("line 2: line: has 4 fields for 2 columns") && ContainsSubstring("semicolons"));
    CHECK(read("angle [deg], torque [N m]\n1,2,\n").faults.empty());
    CHECK_THAT(refusal("angle [deg]; torque [N m]\n1,5;2\n"),
               ContainsSubstring("= 1,5") && ContainsSubstring("point in place of the decimal comma"));
    CHECK_THAT(describe(read("current [A], position [counts]\n1,2\n").faults),
               ContainsSubstring("--torque-constant: is missing") &&
                   ContainsSubstring("--counts-per-turn: is missing") && ContainsSubstring("0.119") &&
                   ContainsSubstring("2000"));
    CHECK_THAT(describe(read("angle [deg], torque [N m]\n1,2\n", rig).faults),
               ContainsSubstring("--torque-constant = 0.119") && ContainsSubstring("no motor current") &&
                   ContainsSubstring("--counts-per-turn = 2000") && ContainsSubstring("leave it out"));
    rig.torque_constant = 0;
    rig.counts_per_turn = std::numeric_limits<double>::infinity();
    rig.efficiency = 1.5;
    rig.ratio = 0;
    CHECK(read("current [A], position [counts]\n1,2\n", rig).faults.size() == 4);
    std::string many = "angle [deg], torque [N m]\n";
    for (int i = 0; i < 1000; ++i)
        many += "x,y\n";
    Faults const listed = read(many).faults;
    REQUIRE(listed.size() == 21);
    CHECK(listed.back().reason == "1980 more faults are not listed");
    TemporaryFolder const folder;
    CHECK_THAT(describe(examine_measured(folder.path(), {}, 100).faults), ContainsSubstring("is a folder"));
    CHECK_THAT(describe(examine_measured(folder / "none.csv", {}, 100).faults), ContainsSubstring("cannot be read"));
    CHECK_THAT(describe(examine_measured("/dev/zero", {}, 100).faults), ContainsSubstring("no file that ends"));
}

}  // namespace hdconj::test::measured_cases
