// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Parts of a running drive: orders, errors that go back, lubricant, bearing, flanks.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "hdconj/error.hpp"
#include "hdconj/read_scene.hpp"
#include "hdconj/running.hpp"
#include "hdconj/units.hpp"
#include "running/friction_loss.hpp"
#include "running/losses.hpp"
#include "running/sequence_errors.hpp"
#include "running/sequence_figures.hpp"
#include "running/sequences.hpp"
#include "running/spectrum.hpp"
#include "support/catch.hpp"

namespace hdconj::test::running_part_cases {

namespace {

using std::numbers::pi;

constexpr double rpm = 2 * pi / 60;

running::LossModel loss_model(Friction const& friction)
{
    Drive drive;
    drive.flexspline_teeth = 200;
    drive.circular_spline_teeth = 202;
    return {friction, running::RunningMotion(drive, RunningMember::flexspline), 40};
}

}  // namespace

TEST_CASE("harmonics are those that a function was made of", "[running]")
{
    std::vector<double> x, f;
    for (int i = 0; i < 37; ++i) {
        x.push_back(2 * pi * i / 37 + 0.01 * std::sin(i));  // uneven
        f.push_back(7 + 2 * std::cos(3 * x.back() - 0.4) + 0.5 * std::cos(11 * x.back() + 1));
    }
    for (running::Harmonic const& each : running::harmonics(x, f, 15)) {
        CAPTURE(each.order);
        double const is = each.order == 3 ? 2 : each.order == 11 ? 0.5 : 0;
        CHECK(std::abs(each.amplitude - is) < 1e-12);
        if (is > 0)
            CHECK(each.phase == Approx(each.order == 3 ? 0.4 : -1).epsilon(1e-12));
    }
}

TEST_CASE("whole pitches move the errors of both rings and leave the phase", "[running]")
{
    Drive drive;
    drive.flexspline_teeth = 200;
    drive.circular_spline_teeth = 202;
    running::RunningMotion const motion(drive, RunningMember::flexspline);
    CHECK(motion.ratio() == 100);
    CHECK(running::RunningMotion(drive, RunningMember::circular_spline).ratio() == 101);
    running::RingPlace const place = running::ring_place(motion, 7.25);
    CHECK(place.pitches == 7);
    CHECK(place.phase == Approx(-0.25 * 2 * pi / 200));
    CHECK(running::ring_place(motion, -0.5).pitches == -1);
    CHECK(running::ring_place(motion, 0.5).pitches == 0);
    contact::FlankDeviation errors;
    errors.teeth.resize(5);
    errors.teeth[3].turn = 1;
    CHECK(running::gone_back(errors, 1).teeth[2].turn == 1);
    CHECK(running::gone_back(errors, -3).teeth[1].turn == 1);
    CHECK(running::gone_back(errors, 5).teeth[3].turn == 1);
}

TEST_CASE("positions at whole pitches are whole and fill the period", "[running]")
{
    auto const plan = running::whole_pitch_plan(RunSpan::input_turn, 202, 32);
    REQUIRE(plan.pitches.size() == 32);
    for (std::size_t i = 0; i < plan.pitches.size(); ++i) {
        CHECK(plan.pitches[i] == std::round(plan.pitches[i]));
        CHECK(std::abs(plan.pitches[i] - 202.0 * static_cast<double>(i) / 32) <= 0.5);
    }
    CHECK(running::whole_pitch_plan(RunSpan::input_turn, 12, 32).pitches.size() == 12);
    auto const between = running::places_between(plan);
    for (std::size_t i = 0; i < plan.pitches.size(); ++i) {
        CHECK(between.pitches[i] > plan.pitches[i]);
        CHECK(between.pitches[i] < plan.pitches[i] + 1);
    }
}

namespace {

running::RunningMotion motion_of_200()
{
    Drive drive;
    drive.flexspline_teeth = 200;
    drive.circular_spline_teeth = 202;
    return {drive, RunningMember::flexspline};
}

/// A transmission error over one tooth pitch, whose place runs from -1/2 to 1/2.
template <class Function>
RunSequence sequence_of(int positions, Function error)
{
    running::SpanPlan const plan = running::tooth_pitch_plan(positions);
    running::RunningMotion const motion = motion_of_200();
    RunSequence sequence;
    for (double const pitches : plan.pitches)
        sequence.positions.push_back({.angle = pitches * motion.pitch(), .error = error(pitches)});
    running::enter_figures(sequence, plan, motion);
    return sequence;
}

}  // namespace

TEST_CASE("a position's error is that about the mean, and none is small by chance", "[running]")
{
    auto const fine = [](double at) { return std::cos(2 * pi * at); };
    auto const coarse = [](double at) { return 5 + std::cos(2 * pi * at) + 0.1 * std::sin(4 * pi * at); };
    RunSequence sequence = sequence_of(16, fine);
    RunSequence const before = sequence;
    running::add_grid_error(sequence, sequence_of(16, coarse), 1);
    CHECK(sequence.estimated);
    double const rms = 0.1 / std::sqrt(2);
    for (std::size_t i = 0; i < sequence.positions.size(); ++i) {
        double const at = static_cast<double>(i) / 16 - 0.5, apart = std::abs(0.1 * std::sin(4 * pi * at));
        CHECK(sequence.positions[i].error == before.positions[i].error);
        CHECK(sequence.positions[i].error_error >= 2 * std::max(apart, rms));
    }
    REQUIRE(sequence.orders.size() == 7);
    CHECK(sequence.orders[1].amplitude_error - before.orders[1].amplitude_error >= 0.2);
    CHECK(sequence.orders[1].phase_error == pi);  // its amplitude is nothing but error
    CHECK(sequence.orders[0].phase_error < 0.3);
    // the shape's own error comes on top
    double const one = sequence.positions[3].error_error;
    running::add_shape_error(sequence, 0.5);
    CHECK(sequence.positions[3].error_error == Approx(one + 0.5));
}

TEST_CASE("a sequence that was stopped says how much of it there is", "[running]")
{
    for (std::size_t const done : {0U, 2U, 12U}) {
        CAPTURE(done);
        std::size_t asked = 0;
        std::string told;
        RunSequence const found = running::first_contacts(
            running::tooth_pitch_plan(16), motion_of_200(), [](double at) { return std::cos(2 * pi * at); },
            {[&] { return ++asked > done; }, {}, [&](std::string const& cause) { told = cause; }});
        CHECK(found.positions.size() == done);
        CHECK(found.planned == 16);
        for (double const figure : {found.peak_to_peak, found.peak_to_peak_error, found.rms, found.rms_error})
            CHECK(std::isnan(figure) == (done < 3));
        CHECK_THAT(told, ContainsSubstring("of 16 positions"));
    }
}

TEST_CASE("the rest of a sequence is not tried where its first quarter has no result", "[running]")
{
    struct Row
    {
        int positions, failing, tried;
    };
    for (Row const row : {Row{16, 16, 4}, Row{16, 4, 4}, Row{16, 3, 16}, Row{4, 4, 3}, Row{4, 2, 4}}) {
        CAPTURE(row.positions, row.failing);
        int tried = 0;
        std::vector<std::string> told;
        auto const turn_at = [&](double) {
            if (++tried <= row.failing)
                throw NumericalError(ErrorCode::overload, "load", "torque", "the teeth slip");
            return 0.0;
        };
        RunSequence const found =
            running::first_contacts(running::tooth_pitch_plan(row.positions), motion_of_200(), turn_at,
                                    {{}, {}, [&](std::string const& cause) { told.push_back(cause); }});
        CHECK(tried == row.tried);
        CHECK(found.positions.size() == static_cast<std::size_t>(std::max(0, row.tried - row.failing)));
        bool const gave_up = row.tried < row.positions;
        REQUIRE(told.size() == static_cast<std::size_t>(std::min(row.failing, row.tried)) + (gave_up ? 1 : 0));
        if (gave_up)
            CHECK_THAT(told.back(), ContainsSubstring("the others were not tried"));
    }
}

TEST_CASE("a sequence with missing positions has fewer orders and all its errors", "[running]")
{
    auto const wave = [](double at) { return std::cos(2 * pi * at) + 0.2 * std::cos(6 * pi * at + 1); };
    running::SpanPlan const plan = running::tooth_pitch_plan(16);
    running::RunningMotion const motion = motion_of_200();
    auto const without = [&](std::size_t left_out, auto error) {
        RunSequence sequence;
        for (std::size_t i = 0; i < plan.pitches.size(); ++i)
            if (i != left_out)
                sequence.positions.push_back(
                    {.angle = plan.pitches[i] * motion.pitch(), .error = error(plan.pitches[i])});
        running::enter_figures(sequence, plan, motion);
        return sequence;
    };
    for (std::size_t const left_out : {0U, 5U, 15U}) {
        RunSequence sequence = without(left_out, wave);
        REQUIRE(sequence.orders.size() == 3);  // two steps wide: less than half of eight
        CHECK(sequence.orders[0].amplitude == Approx(1));
        CHECK(sequence.orders[2].amplitude == Approx(0.2));
        running::add_grid_error(sequence, without(7, [&](double at) { return wave(at) + 0.01 * at; }), 1);
        CHECK(sequence.estimated);
        for (RunPosition const& each : sequence.positions)
            CHECK(each.error_error > 0);
        RunSequence longer = sequence_of(64, wave);
        running::add_error_of(longer, sequence);
        CHECK(longer.estimated);
        CHECK(longer.positions[9].error_error == Approx(sequence.positions[9].error_error));
    }
    RunSequence alone = sequence_of(16, wave);
    running::add_error_of(alone, sequence_of(16, wave));
    CHECK_FALSE(alone.estimated);
}

TEST_CASE("errors of orders contain what higher orders look like them", "[running]")
{
    // kinks: a triangle and the ripple of a rectified sine, whose orders do not end
    for (auto const& error :
         {+[](double at) { return std::abs(at); }, +[](double at) { return std::abs(std::sin(pi * at + 0.3)); }}) {
        RunSequence const few = sequence_of(16, error), many = sequence_of(401, error);
        for (std::size_t k = 0; k < few.orders.size(); ++k) {
            CAPTURE(k);
            CHECK(std::abs(few.orders[k].amplitude - many.orders[k].amplitude) <= few.orders[k].amplitude_error);
        }
    }
}

TEST_CASE("peak to peak is known to what lies between the positions", "[running]")
{
    // peaks with straight sides, whose places the positions miss by as much as they can and by less
    for (auto const& error : {+[](double at) { return std::abs(at - std::round(at)); },
                              +[](double at) { return 2 * std::abs(std::sin(pi * (at + 0.07))); },
                              +[](double at) { return std::cos(2 * pi * at + 0.9); },
                              +[](double at) {
                                  double const x = at - std::floor(at);
                                  return x < 0.7 ? x / 0.7 : (1 - x) / 0.3;
                              }}) {
        double const exact = sequence_of(2001, error).peak_to_peak;
        for (int const positions : {7, 8, 9, 12, 16, 17, 40}) {
            CAPTURE(positions);
            RunSequence const few = sequence_of(positions, error);
            CHECK(std::abs(few.peak_to_peak - exact) <= few.peak_to_peak_error);
            CHECK(few.peak_to_peak_error < 4.5 * exact / positions);
        }
    }
}

TEST_CASE("viscosity goes through both values and falls between them", "[running]")
{
    Friction friction;
    friction.viscosity_40 = 100;
    friction.viscosity_100 = 11;
    CHECK(running::viscosity(friction, 40) == Approx(100));
    CHECK(running::viscosity(friction, 100) == Approx(11));
    // ISO VG 100 of viscosity index 95: the chart of ASTM D341 gives some 30 mm^2/s at 70 degrees
    CHECK(running::viscosity(friction, 70) > 26);
    CHECK(running::viscosity(friction, 70) < 31);
    CHECK(running::viscosity(friction, 0) > running::viscosity(friction, 20));
}

TEST_CASE("Palmgren's torque of the lubricant is continuous where its two laws meet", "[running]")
{
    Friction friction;
    friction.bearing_speed = 2;
    double const below = running::lubricant_torque(friction, 40, 20, 99 * rpm),
                 above = running::lubricant_torque(friction, 40, 20, 101 * rpm);
    CHECK(below == Approx(160e-7 * 2 * 40 * 40 * 40));
    CHECK(above == Approx(below).epsilon(0.02));
    CHECK(running::lubricant_torque(friction, 40, 20, 800 * rpm) ==
          Approx(1e-7 * 2 * std::pow(16000, 2.0 / 3) * 64000));
}

TEST_CASE("the equivalent load of a bearing is that of forces that go with cos^(3/2)", "[running]")
{
    Friction friction;
    friction.bearing_load = 1;
    double load = 0, sum = 0;  // of 10000 balls on one half
    for (int i = 0; i < 10000; ++i) {
        double const cosine = std::cos(pi * (i + 0.5) / 10000 - pi / 2);
        sum += std::pow(cosine, 1.5);
        load += std::pow(cosine, 2.5);
    }
    CHECK(running::load_torque(friction, 1, sum) == Approx(load).epsilon(1e-4));
}

TEST_CASE("flanks rub by Coulomb's law, or by Stribeck's from rest on", "[running]")
{
    Friction friction;
    friction.flanks = 0.08;
    CHECK(running::flank_coefficient(friction, 0) == 0.08);
    CHECK(running::flank_coefficient(friction, 1e3) == 0.08);
    friction.flanks_at_rest = 0.12;
    friction.stribeck_speed = 20;
    CHECK(running::flank_coefficient(friction, 0) == Approx(0.12));
    CHECK(running::flank_coefficient(friction, 20) == Approx(0.08 + 0.04 / std::exp(1.0)));
}

TEST_CASE("without losses the efficiency is 1, and a constant loss takes all of a small torque", "[running]")
{
    running::LoadedRun run{1000, {{{{10, 0.5, 0}}, 1}}, 300};
    EfficiencyRow const none = running::efficiency_at(loss_model({}), run, 100, 40);
    CHECK(none.efficiency == 1);
    CHECK(none.input_torque == 10);
    run.torque = 0;
    EfficiencyRow const without_power = running::efficiency_at(loss_model({}), run, 100, 40);
    CHECK(std::isnan(without_power.efficiency));
    CHECK(std::isnan(without_power.efficiency_error));
    Friction friction;
    friction.seal = 5;
    double last = -1;
    for (double const torque : {0.0, 1.0, 100.0, 1e6}) {
        run.torque = torque;
        double const now = running::efficiency_at(loss_model(friction), run, 100, 40).efficiency;
        CHECK(now == Approx(torque / 100 / (torque / 100 + 5)));
        CHECK(now > last);
        last = now;
    }
    // 10 N slide by 0.5 mm/rad of the cup, which passes the wave generator 1.01 times as fast
    friction = {};
    friction.flanks = 0.1;
    CHECK(running::efficiency_at(loss_model(friction), run, 100, 40).flanks == Approx(0.1 * 10 * 0.5 * 1.01));
}

TEST_CASE("losses that grids share out otherwise are not known by their sum", "[running]")
{
    Friction friction;
    friction.flanks = 0.1;
    friction.bearing_load = 0.001;
    running::LossModel const model = loss_model(friction);
    running::RunTask const task{.motion = model.motion, .speeds = {100}, .temperatures = {40}};
    auto const runs_of = [&](double force, double balls) {
        running::LoadedRun const loaded{1000, {{{{force, 0.5, 0}}, 1}}, balls};
        return running::LossRuns{{{0, {}, balls}, loaded}, {}, 0};
    };
    auto const row_of = [&](double force, double balls) {
        return running::efficiency_at(model, runs_of(force, balls).asked.back(), 100, 40);
    };
    // as much less on the flanks as more in the bearing
    double const by_flanks = row_of(10, 300).flanks - row_of(8, 300).flanks,
                 by_ball = row_of(10, 301).bearing_load - row_of(10, 300).bearing_load;
    running::LossRuns const coarse = runs_of(8, 300 + by_flanks / by_ball);
    RunLosses const found = running::run_losses(model, task, runs_of(10, 300), {coarse, coarse}, 4);
    EfficiencyRow const row = found.efficiency.back();
    CHECK(row_of(8, coarse.asked.back().ball_load).input_torque == Approx(row.input_torque));
    CHECK(row.input_torque_error == Approx(2 * 4 * 2 * by_flanks));  // twice the safety, of both parts
    CHECK(row.efficiency_error == Approx(row.efficiency * row.input_torque_error / row.input_torque));
}

TEST_CASE("the wave generator is driven back where the torque has overcome what rests", "[running]")
{
    Friction friction;
    friction.flanks = 0.1;
    friction.seal = 5;
    auto const run_at = [](double torque) { return running::LoadedRun{torque, {{{{torque / 20, 0.5, 0}}, 1}}, 0}; };
    // T/100 = 5 + 0.1 T/20 0.5 1.01
    double const is = 5 / (0.01 - 0.1 * 0.5 * 1.01 / 20);
    auto const found = running::back_driving_torque(loss_model(friction), {run_at(0), run_at(500), run_at(1000)});
    REQUIRE(found);
    CHECK(*found == Approx(is));
    CHECK_FALSE(running::back_driving_torque(loss_model(friction), {run_at(0), run_at(is / 2)}));
    // flanks alone: the least torque drives back, or none does
    friction.seal = 0;
    CHECK(running::back_driving_torque(loss_model(friction), {run_at(0), run_at(500)}) == 0);
    friction.flanks = 1;
    CHECK_FALSE(running::back_driving_torque(loss_model(friction), {run_at(0), run_at(500), run_at(1000)}));
}

namespace {

/// A turn over the 82 pitches of a held ring, at whole pitches, with the errors of what lies between.
template <class Function>
RunSequence turn_of_82(Function error)
{
    Drive drive;
    drive.flexspline_teeth = 80;
    drive.circular_spline_teeth = 82;
    running::RunningMotion const motion(drive, RunningMember::flexspline);
    auto const turn_at = [&](double pitches) { return -error(pitches) / motion.turn_rate(); };
    running::SpanPlan const plan = running::whole_pitch_plan(RunSpan::input_turn, 82, 256);
    RunSequence turn = running::first_contacts(plan, motion, turn_at, {});
    running::add_shape_error(turn, 1e-12);
    running::add_places_between(turn, running::first_contacts(running::places_between(plan), motion, turn_at, {}), plan,
                                motion);
    return turn;
}

}  // namespace

TEST_CASE("a turn that does not close and lacks its first position has errors all the same", "[running]")
{
    Drive drive;
    drive.flexspline_teeth = 80;
    drive.circular_spline_teeth = 82;
    running::RunningMotion const motion(drive, RunningMember::flexspline);
    running::SpanPlan plan = running::whole_pitch_plan(RunSpan::input_turn, 82, 256);
    plan.closed = false;
    auto const turn_at = [](double pitches) { return 1e-5 * std::sin(pitches); };
    RunSequence turn = running::first_contacts(plan, motion, turn_at, {});
    RunSequence const between = running::first_contacts(running::places_between(plan), motion, turn_at, {});
    turn.positions.erase(turn.positions.begin());
    running::add_shape_error(turn, 1e-12);
    running::add_places_between(turn, between, plan, motion);
    CHECK(turn.estimated);
    CHECK(turn.peak_to_peak_error > 0);
    CHECK(turn.peak_to_peak_error < 1e-4);
    CHECK(std::isfinite(turn.rms_error));
}

TEST_CASE("the errors of a turn hold what lies between whole pitches", "[running]")
{
    // Of each pitch the tooth that stands out most leads, as one of the first contacts of a ring with pitch errors.
    constexpr int teeth = 82, fine = 32;
    auto const stands_out = [](double tooth) { return std::sin(2.4 * tooth * tooth); };
    auto const error = [&](double pitches) {
        double most = -10;
        double const nearest = std::round(pitches);
        for (double tooth = nearest - 3; tooth <= nearest + 3; ++tooth) {
            double const off = pitches - tooth;
            most = std::max(most, 1e-5 * (stands_out(std::fmod(tooth + teeth, teeth)) - 0.4 * off * off));
        }
        return most;
    };
    RunSequence const turn = turn_of_82(error);
    REQUIRE(turn.positions.size() == teeth);
    std::vector<double> x, values;
    for (int i = 0; i < teeth * fine; ++i) {
        x.push_back(2 * pi * i / (teeth * fine));
        values.push_back(error(static_cast<double>(i) / fine));
    }
    auto const [low, high] = std::ranges::minmax_element(values);
    double const mean = std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
    double squares = 0;
    for (double const value : values)
        squares += (value - mean) * (value - mean) / static_cast<double>(values.size());
    CHECK(turn.estimated);
    CHECK(*high - *low > turn.peak_to_peak);
    CHECK(*high - *low < turn.peak_to_peak + turn.peak_to_peak_error);
    CHECK(turn.peak_to_peak_error < 0.5 * turn.peak_to_peak);
    CHECK(std::abs(std::sqrt(squares) - turn.rms) < turn.rms_error);
    std::vector<running::Harmonic> const orders = running::harmonics(x, values, 40);
    for (std::size_t k = 0; k < orders.size(); ++k) {
        CAPTURE(k);
        CHECK(std::abs(orders[k].amplitude - turn.orders[k].amplitude) < turn.orders[k].amplitude_error);
    }
}

TEST_CASE("a turn of which too little is known between whole pitches has no errors", "[running]")
{
    RunSequence const turn = turn_of_82([](double pitches) {
        if (pitches != std::round(pitches))
            throw NumericalError(ErrorCode::not_converged, "run", "test", "no balance");
        return std::cos(2 * pi * pitches / 41);
    });
    CHECK(turn.positions.size() == 82);
    CHECK_FALSE(turn.estimated);
    RunSequence const nowhere = turn_of_82([](double pitches) {
        if (pitches == std::round(pitches))
            throw NumericalError(ErrorCode::not_converged, "run", "test", "no balance");
        return 0.0;
    });
    CHECK(nowhere.positions.empty());
    CHECK_FALSE(nowhere.estimated);
}

namespace {

/// First contacts of an eccentric ring of 62 teeth, mounted that many pitches further.
RunStudy eccentric(double pitches, RunOptions options)
{
    constexpr double pitch_deg = 360.0 / 62;
    std::string const text =
        "[drive]\nname = \"printed\"\nmodule = 1\nflexspline_teeth = 60\ncircular_spline_teeth = 62\n"
        "[flexspline]\nwall = 0.8\n[flexspline.profile]\nfamily = \"straight\"\naddendum = 0.8\n"
        "dedendum = 1.1\nthickness = 1.5\npressure_angle_deg = 28.6\n[circular_spline]\nwidth = 8\n"
        "[wave_generator]\nfamily = \"cosine\"\nradial_deformation = 1.0\nwaves = 2\n"
        "[solver]\ntolerance = 1e-5\n[errors.circular_spline]\neccentricity = 0.02\n"
        "eccentricity_phase_deg = " +
        std::to_string(-pitches * pitch_deg);
    options.torque = 0;
    return study_run(examine_scene(text, "printed", {}, {}).scene, options);
}

}  // namespace

TEST_CASE("an eccentricity has its extremes between whole pitches, within the error of a turn", "[running]")
{
    auto const run = [](double pitches) { return eccentric(pitches, {}).sequences; };
    auto const less = [](RunPosition const& a, RunPosition const& b) { return a.error < b.error; };
    RunSequence const turn = run(0).back();
    REQUIRE(turn.span == RunSpan::input_turn);
    REQUIRE(turn.positions.size() == 62);
    // whole pitches later the same ring stands there as if its phase were that much less
    auto const [low, high] = std::ranges::minmax_element(turn.positions, less);
    double lowest = low->error, highest = high->error;
    for (auto const& extreme : {low, high}) {
        RunSequence const pitch = run(static_cast<double>(extreme - turn.positions.begin())).front();
        for (RunPosition const& each : pitch.positions) {
            lowest = std::min(lowest, each.error);
            highest = std::max(highest, each.error);
        }
    }
    CHECK(highest - lowest > 1.01 * turn.peak_to_peak);
    CHECK(highest - lowest <= turn.peak_to_peak + turn.peak_to_peak_error);
}

TEST_CASE("a turn without its places between has no errors, and a stopped one says so", "[running]")
{
    RunOptions options;
    options.positions = 4;
    options.errors = false;
    RunSequence const plain = eccentric(0, options).sequences.back();
    CHECK_FALSE(plain.estimated);
    options.errors = true;
    RunSequence const whole = eccentric(0, options).sequences.back();
    CHECK(whole.estimated);
    CHECK(plain.peak_to_peak == whole.peak_to_peak);
    constexpr int positions = 4 + 62;
    for (auto const& [asked, told] : {std::pair(positions, "before the errors were known"),
                                      std::pair(positions + 20, "before the errors between the positions")}) {
        CAPTURE(told);
        int left = asked;
        options.stop = [&left] { return --left < 0; };
        RunStudy const stopped = eccentric(0, options);
        REQUIRE(stopped.sequences.size() == 2);
        CHECK(stopped.sequences.back().positions.size() == 62);
        CHECK_FALSE(stopped.sequences.back().estimated);
        REQUIRE(stopped.missing.size() == 1);
        CHECK_THAT(stopped.missing.front(), ContainsSubstring(told));
    }
}

TEST_CASE("figures of a sequence are those of the function that it samples", "[running]")
{
    Drive drive;
    drive.flexspline_teeth = 200;
    drive.circular_spline_teeth = 202;
    running::RunningMotion const motion(drive, RunningMember::flexspline);
    auto const plan = running::whole_pitch_plan(RunSpan::input_turn, 202, 64);
    RunSequence const found = running::first_contacts(
        plan, motion, [&](double pitches) { return -3e-6 * std::cos(2 * pi * 4 * pitches / 202) / motion.turn_rate(); },
        {});
    CHECK(found.peak_to_peak == Approx(6e-6).epsilon(0.02));
    CHECK(found.rms == Approx(3e-6 / std::sqrt(2)).epsilon(0.01));
    for (RunOrder const& each : found.orders) {
        CHECK(each.per_output == Approx(100 * each.per_input));
        CHECK(std::abs(each.amplitude - (std::lround(each.per_input) == 4 ? 3e-6 : 0)) < 1e-15);
    }
}

}  // namespace hdconj::test::running_part_cases
