// SPDX-License-Identifier: GPL-3.0-or-later
// What studies are measured with: nearest points, distances of curves, orders, floors and advice.
#include <cmath>
#include <numbers>

#include "accuracy/convergence_series.hpp"
#include "accuracy/reference/reference_curve.hpp"
#include "hdconj/accuracy.hpp"
#include "support/catch.hpp"

namespace hdconj::test::study_cases {

namespace {

std::vector<Vec2> on_circle(int chords, double from, double to)
{
    std::vector<Vec2> points;
    for (int i = 0; i <= chords; ++i) {
        double const angle = from + (to - from) * i / chords;
        points.emplace_back(3 * std::cos(angle), 3 * std::sin(angle));
    }
    return points;
}

/// Chebyshev coefficients of 3 cos and 3 sin over 0 ... 2 in two patches, by sums at the nodes.
accuracy::ReferenceCurve circle()
{
    constexpr int nodes = 24;
    std::vector<accuracy::ReferencePatch> patches;
    for (int half = 0; half < 2; ++half) {
        accuracy::ReferencePatch patch;
        patch.stretch = half;
        for (int j = 0; j < nodes; ++j) {
            long double x = 0, y = 0;
            for (int i = 0; i < nodes; ++i) {
                long double const theta = std::numbers::pi_v<long double> * (i + 0.5L) / nodes;
                long double const angle = half + 0.5L + 0.5L * std::cos(theta);
                x += 3 * std::cos(angle) * std::cos(j * theta);
                y += 3 * std::sin(angle) * std::cos(j * theta);
            }
            long double const factor = (j == 0 ? 1.0L : 2.0L) / nodes;
            patch.x.push_back(factor * x);
            patch.y.push_back(factor * y);
        }
        patches.push_back(patch);
    }
    return {patches, 1e-18};
}

StudyRecord record(std::string const& drive, double value, double error, double seconds, int repeat = 0)
{
    StudyRecord made;
    made.study = "tolerance";
    made.drive = drive;
    made.method = "solve";
    made.knob = "solver.tolerance";
    made.value = value;
    made.repeat = repeat;
    made.hausdorff = error;
    made.error = error / 2;
    made.seconds = seconds;
    return made;
}

AccuracyReport report_of(std::vector<StudyRecord> const& records)
{
    AccuracyReport report;
    report.scene.drive.name = "drive";
    report.records = records;
    return report;
}

}  // namespace

TEST_CASE("reference curve: distances from a circle", "[study]")
{
    accuracy::ReferenceCurve const truth = circle();
    CHECK(truth.distance({4 * std::cos(0.3), 4 * std::sin(0.3)}) == Approx(1).epsilon(1e-14));
    CHECK(truth.distance({3 * std::cos(1.0), 3 * std::sin(1.0)}) < 1e-15);
    CHECK(truth.length(0) == Approx(3).epsilon(1e-3));
    // a polygon of n chords is off by its sagitta, of second order, and its vertices by nothing
    for (int const chords : {8, 64, 1024}) {
        accuracy::CurveDifference const difference = truth.compare(on_circle(chords, 0, 2), 0.1);
        CHECK(difference.points < 2e-15);
        CHECK(difference.hausdorff == Approx(3 * (1 - std::cos(1.0 / chords))).epsilon(1e-6).margin(2e-15));
        CHECK(difference.missed == 0);
    }
    // what is left out is missed and counts both ways
    accuracy::CurveDifference const half = truth.compare(on_circle(64, 0, 1), 0.1);
    CHECK(half.missed == 1);
    CHECK(half.hausdorff == Approx(6 * std::sin(0.5)).epsilon(1e-12));
    // a vertex off the curve is seen at its own size
    auto spoiled = on_circle(4096, 0, 2);
    spoiled[1000] *= 1 + 1e-6;
    CHECK(truth.compare(spoiled, 0.1).points == Approx(3e-6).epsilon(1e-6));
}

TEST_CASE("convergence series: median, order, floor and the worst of the sample", "[study]")
{
    std::vector<StudyRecord> records;
    for (int digits = 2; digits <= 6; ++digits) {
        double const value = std::pow(10.0, -digits), error = 3 * std::sqrt(value);
        for (int repeat = 0; repeat < 3; ++repeat)
            records.push_back(
                record("drive", value, error, 0.01 * digits * (repeat == 2 ? 50 : 1 + 0.1 * repeat), repeat));
        records.push_back(record("design-00", value, error / 2, 1));
        records.push_back(record("design-01", value, error * 2, 2));
    }
    auto const series_list = accuracy::convergence_series(report_of(records));
    REQUIRE(series_list.size() == 2);
    CHECK(series_list[0].drive == "drive");
    CHECK(series_list[0].order == Approx(0.5).epsilon(1e-12));
    CHECK(std::isnan(series_list[0].floor));
    CHECK(series_list[0].levels.front().median == Approx(0.022));
    CHECK(series_list[0].levels.front().least == Approx(0.02));
    CHECK(series_list[0].levels.front().most == Approx(1.0));
    CHECK(series_list[1].drive == accuracy::worst_of_sample);
    CHECK(series_list[1].levels.front().error == Approx(2 * series_list[0].levels.front().error));
    CHECK(series_list[1].levels.front().drives == 2);

    // errors that stay: a floor, and the order is that of the levels above it
    std::vector<ConvergenceLevel> levels;
    for (double const error : {1e-2, 1e-4, 1e-6, 2e-8, 2e-8}) {
        ConvergenceLevel level;
        level.value = std::pow(10.0, -static_cast<double>(levels.size()));
        level.error = error;
        levels.push_back(level);
    }
    CHECK(accuracy::floor_of(levels) == 2e-8);
    CHECK(accuracy::observed_order(levels, accuracy::floor_of(levels)) == Approx(2).epsilon(1e-12));
}

TEST_CASE("convergence series: an order only where errors fall from level to level", "[study]")
{
    auto const of = [](std::vector<double> const& errors, std::string const& knob = "slices.count") {
        std::vector<StudyRecord> records;
        for (std::size_t i = 0; i < errors.size(); ++i) {
            records.push_back(record("drive", static_cast<double>(i + 3), errors[i], 1));
            records.back().knob = knob;
        }
        return accuracy::convergence_series(report_of(records)).front();
    };
    CHECK(of({1e-1, 1e-2, 1e-3}).order < -1);
    CHECK(of({1e-1, 1e-2, 1e-3}).no_order.empty());
    for (std::vector<double> const& errors :
         {std::vector<double>{1e-3, 1e-2, 1e-1}, {1e-2, 1e-4, 1e-3}, {4.16, 4.16, 4.15, 1.5, 0.4}}) {
        CHECK(std::isnan(of(errors).order));
        CHECK(of(errors).no_order == "errors do not fall by 5 % at every level");
    }
    // what does not fall any more is a floor and spoils no order; two levels say nothing
    CHECK(of({1, 1e-1, 1e-2, 1e-5, 1.05e-5}).order < -1);
    CHECK(std::isnan(of({1, 0.1}).order));
    CHECK(of({1, 0.1}).no_order.empty());
    // exponential convergence: a factor for each degree, down to where it ends
    ConvergenceSeries const fit = of({1e-1, 1e-3, 1e-5, 1.1e-5}, accuracy::polynomial_degree);
    CHECK(std::isnan(fit.order));
    auto const fall = accuracy::error_per_step(fit.levels);
    REQUIRE(fall);
    CHECK(fall->factor == Approx(100));
    CHECK(fall->until == 5);
    CHECK_FALSE(accuracy::error_per_step(of({1e-3, 1e-2, 1e-4}, accuracy::polynomial_degree).levels));
    CHECK_FALSE(accuracy::error_per_step(of({1e-3, 1e-2}, accuracy::polynomial_degree).levels));
    CHECK_FALSE(accuracy::error_per_step({}));
    // how often each setting was run
    CHECK(accuracy::convergence_series(report_of({record("drive", 1, 1, 1, 0), record("drive", 1, 1, 1, 1)}))
              .front()
              .levels.front()
              .runs == 2);
}

TEST_CASE("numbers of designs and of repeats have limits", "[study]")
{
    auto const faults_of = [](int sample, int repeats) {
        AccuracyOptions options;
        options.sample = sample;
        options.repeats = repeats;
        return check_studies(options).size();
    };
    CHECK(faults_of(0, 1000) == 0);
    CHECK(faults_of(-1, -1) == 2);
    CHECK(faults_of(1001, 0) == 2);
}

TEST_CASE("advice: what is measured and no more, the sample counts", "[study]")
{
    auto const series_list = accuracy::convergence_series(report_of(
        {record("drive", 1e-3, 9e-4, 0.001), record("drive", 1e-4, 9e-5, 0.002), record("drive", 1e-5, 9e-6, 0.005),
         record("design-00", 1e-3, 8e-4, 1), record("design-00", 1e-4, 2e-4, 1), record("design-00", 1e-5, 8e-6, 1)}));
    auto const fast = accuracy::fastest_within(series_list, 1e-4);
    REQUIRE(fast);
    // 1e-4 keeps it on the drive but not on the sample
    CHECK(fast->level.value == 1e-5);
    CHECK(fast->reaches);
    auto const beyond = accuracy::fastest_within(series_list, 1e-9);
    REQUIRE(beyond);
    CHECK_FALSE(beyond->reaches);
    CHECK(beyond->level.value == 1e-5);
    auto const within = accuracy::finest_within(series_list, 0.003);
    REQUIRE(within);
    CHECK(within->level.value == 1e-4);
    CHECK(within->sample_error == 2e-4);
    CHECK_FALSE(accuracy::finest_within(series_list, 1e-6)->reaches);
    CHECK_FALSE(accuracy::fastest_within({}, 1));
}

}  // namespace hdconj::test::study_cases
