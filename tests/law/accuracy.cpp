// SPDX-License-Identifier: GPL-3.0-or-later
// Deterministic gates of the work-precision studies, and what an error estimate must be: a bound, and not far above.
// Times are never looked at.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "accuracy/convergence_series.hpp"
#include "hdconj/accuracy.hpp"
#include "hdconj/error.hpp"
#include "hdconj/read_scene.hpp"
#include "support/catch.hpp"
#include "support/oracle/estimate_law.hpp"
#include "support/oracle/reference_outline.hpp"
#include "support/oracle/run.hpp"
#include "support/oracle/touch.hpp"
#include "support/oracle/touch_law.hpp"
#include "support/random_designs.hpp"

namespace hdconj::test::accuracy_cases {

namespace {

AccuracyReport measured(std::vector<std::string> const& studies, int sample)
{
    AccuracyOptions options;
    options.studies = studies;
    options.quick = true;
    options.sample = sample;
    return measure_accuracy(oracle::type_50(), options);
}

ConvergenceSeries const& series(std::vector<ConvergenceSeries> const& all, std::string_view method,
                                std::string_view drive = "type-50")
{
    for (auto const& each : all)
        if (each.method == method && each.drive == drive)
            return each;
    FAIL("no series " << method << " of " << drive);
    return all.front();
}

void falls(ConvergenceSeries const& steps)
{
    for (std::size_t i = 0; i + 1 < steps.levels.size(); ++i)
        CHECK(steps.levels[i + 1].error < steps.levels[i].error);
}

}  // namespace

TEST_CASE("accuracy: the reference in 50 digits is touched by the oracle's tooth", "[accuracy]")
{
    Scene const scene = oracle::type_50();
    accuracy::ReferenceCurve const truth = accuracy::reference_outline(scene);
    CHECK(truth.error() < 1e-15);
    oracle::TouchScan scan(scene);
    double worst = 0;
    int flank = 0;
    auto const& points = truth.points();
    for (std::size_t i = 0; i < points.size(); i += points.size() / 60) {
        double const distance = scan.nearest({points[i].x(), points[i].y()}).distance;
        bool const land = points[i].norm() < 25.025 + 1e-9;
        worst = std::max(worst, land ? -distance : std::abs(distance));
        flank += !land;
    }
    CHECK(flank > 30);
    CHECK(worst < 1e-11);
}

TEST_CASE("accuracy: smooth wave generators are traced by another path in 50 digits", "[accuracy]")
{
    // an ellipse by its eccentric angle, and a ring about a cam as vectors: no formula of the program's
    for (std::string const family : {"ellipse", "ring-on-cosine-cam"}) {
        INFO(family);
        Scene scene = read_scene(std::string(HDCONJ_SOURCE_DIR) + "/data/scenes/" + family + ".toml");
        scene.solver.tolerance = 1e-9;
        REQUIRE(check_accuracy(scene, {}).empty());
        accuracy::ReferenceCurve const truth = accuracy::reference_outline(scene);
        CHECK(truth.error() < 1e-15);
        Solution const solution = solve(scene);
        accuracy::CurveDifference const difference = truth.compare(solution.circular_spline.outline.front(), 1e-6);
        CHECK(difference.points < 1e-12);
        CHECK(difference.hausdorff <= solution.error.chord + solution.error.point);
        CHECK(difference.hausdorff > 0.5 * scene.solver.tolerance);
        CHECK(difference.missed == 0);
    }
}

TEST_CASE("accuracy: order, monotone error, work and branches of the convergence series", "[accuracy]")
{
    auto const report = measured({"tolerance", "sampling", "motion-model"}, 2);
    auto const all = accuracy::convergence_series(report);
    CHECK(report.sample == 2);
    CHECK(report.reference_error < 1e-13 / 100);
    CHECK(report.reference_interference < 1e-6);

    auto const& solve = series(all, "solve");
    CHECK(solve.order == Approx(1).margin(0.05));
    falls(solve);
    for (auto const& level : solve.levels) {
        INFO("tolerance " << level.value);
        CHECK(level.error <= level.value);
        CHECK(level.error > 0.5 * level.value);  // and no points are wasted
        CHECK(level.missed == 0);
        CHECK(level.extra == 0);
        CHECK(level.normal_speed < 1e-12);
    }
    // work: fewest points grow as the root of 1/tolerance
    CHECK(solve.levels.back().evaluations <= 5000);
    CHECK(solve.levels.back().points <= 620);
    falls(series(all, "solve", accuracy::worst_of_sample));

    auto const& equal = series(all, "equal steps of u");
    auto const& adaptive = series(all, "adaptive");
    falls(equal);
    falls(adaptive);
    CHECK(adaptive.order == Approx(1).margin(0.05));
    CHECK(equal.order < -1.5);
    // the same error with a tenth of the points
    CHECK(adaptive.levels.back().error < equal.levels.back().error);
    CHECK(10 * adaptive.levels[2].points < equal.levels.back().points);

    // first order stays at its floor, whatever the tolerance
    auto const& first = series(all, "first order");
    CHECK(first.floor > 1e-3);
    CHECK(first.floor < 5e-3);
    CHECK(first.levels.back().error == Approx(first.levels.front().error).epsilon(0.1));
}

TEST_CASE("accuracy: negative controls", "[accuracy]")
{
    // a knob that must not matter: threads change no bit and no error
    auto const all = accuracy::convergence_series(measured({"threads"}, 0));
    auto const& threads = series(all, "solve");
    REQUIRE(threads.levels.size() >= 2);
    CHECK(threads.levels[0].error == threads.levels[1].error);
    CHECK(threads.levels[1].extra == 0);
    // beside what the machine gives to solves that share nothing else, repeat by repeat
    auto const& apart = series(all, "solves side by side");
    REQUIRE(apart.levels.size() == threads.levels.size());
    for (std::size_t i = 0; i < threads.levels.size(); ++i) {
        CHECK(apart.levels[i].value == threads.levels[i].value);
        CHECK(apart.levels[i].median > 0);
    }
    // and an outline that is wrong is seen to be: by a point, and by a stretch left out
    Scene scene = oracle::type_50();
    accuracy::ReferenceCurve const truth = accuracy::reference_outline(scene);
    auto outline = solve(scene).circular_spline.outline.front();
    CHECK(truth.compare(outline, 1e-5).hausdorff < 1e-6);
    auto spoiled = outline;
    spoiled[spoiled.size() / 3].x() += 1e-5;
    CHECK(truth.compare(spoiled, 1e-5).points > 3e-6);
    spoiled = outline;
    spoiled.erase(spoiled.begin() + 100, spoiled.begin() + 250);
    CHECK(truth.compare(spoiled, 1e-5).missed > 0);
}

TEST_CASE("accuracy: fit, union, roots and number types do what they are shown for", "[accuracy]")
{
    auto const all = accuracy::convergence_series(measured({"polynomial-fit", "union", "roots", "number-type"}, 0));
    // more degrees do not bring the thesis' fit below its floor
    auto const& fit = series(all, "fit, exact motion");
    for (auto const& level : fit.levels)
        CHECK(level.error > 1e-4);
    falls(series(all, "points joined, exact motion"));
    falls(series(all, "union of positions"));
    // the scan loses pairs that certification finds, and finds none that are not there
    auto const& scan = series(all, "scan and bracket (spline)");
    CHECK(scan.levels.front().missed > 0);
    for (auto const& level : scan.levels)
        CHECK(level.extra == 0);
    for (std::size_t i = 0; i + 1 < scan.levels.size(); ++i)
        CHECK(scan.levels[i + 1].missed <= scan.levels[i].missed);
    CHECK(series(all, "certified (spline)").levels.front().error < 1e-11);
    CHECK(series(all, "closed form (arcs)").levels.front().error < 1e-11);
    CHECK(series(all, "float").levels.front().error > 1e-8);
    CHECK(series(all, "float").levels.front().error < 1e-4);
    CHECK(series(all, "double").levels.front().error < 5e-14);
    CHECK(series(all, "the program").levels.front().error < 5e-14);
    CHECK(series(all, "long double").levels.front().error < 1e-16);
}

TEST_CASE("accuracy: what the thesis' iteration finds off the flank is a missed point and no error", "[accuracy]")
{
    struct Row
    {
        char const* drive;
        char const* profile;
        char const* wave_generator;
    };
    for (Row const& row :
         {Row{"name = 'bezier'\nmodule = 0.25\nflexspline_teeth = 200\ncircular_spline_teeth = 202\n[flexspline]\nwall "
              "= 0.7\n",
              "family = 'bezier'\ndegree = 3\npoints = "
              "[[0.06,0.2],[0.12,0.13],[0.15,0.08],[0.165,0.0],[0.18,-0.08],[0.21,-0.17],[0.29,-0.28]]\n",
              "family = 'four-roller'\nradial_deformation = 0.25\nwaves = 2\nroller_angle_deg = 30\n"},
          Row{"name = 'involute'\nmodule = 0.4\nflexspline_teeth = 120\ncircular_spline_teeth = "
              "122\n[flexspline]\nwall = 0.8\n",
              "family = 'involute'\naddendum = 0.3\ndedendum = 0.4\npressure_angle_deg = 27\nthickness = 0.6\n",
              "family = 'ellipse'\nradial_deformation = 0.4\nwaves = 2\n"},
          Row{"name = 'straight'\nmodule = 0.3\nflexspline_teeth = 180\ncircular_spline_teeth = "
              "183\n[flexspline]\nwall = 0.6\n",
              "family = 'straight'\naddendum = 0.24\ndedendum = 0.33\nthickness = 0.46\npressure_angle_deg = 30\n",
              "family = 'cosine'\nradial_deformation = 0.3\nwaves = 3\n"}}) {
        INFO(row.drive);
        Scene const scene = parse_scene(std::string("[drive]\n") + row.drive + "[flexspline.profile]\n" + row.profile +
                                            "[wave_generator]\n" + row.wave_generator,
                                        "test");
        AccuracyOptions options;
        options.studies = {"polynomial-fit", "motion-model"};
        options.quick = true;
        options.sample = 0;
        auto const all = accuracy::convergence_series(measure_accuracy(scene, options));
        auto const of = [&](std::string const& method) { return series(all, method, scene.drive.name); };
        // points on the flank are as far off as the model is, where stray ones are off by a tooth
        double const model = of("first order").floor;
        REQUIRE(model > 0);
        constexpr int positions = 60;
        int missed = 0;
        for (std::string const way : {"fit, ", "points joined, "})
            for (auto const& level : of(way + "first order").levels) {
                INFO(way << level.value);
                CHECK(level.error < 2 * model);
                CHECK(level.points + level.missed == (way == "fit, " ? positions : level.value));
                missed += level.missed;
            }
        CHECK(missed > 0);
        for (auto const& level : of("fit, exact motion").levels) {
            CHECK(level.missed == 0);
            CHECK(level.points == positions);
        }
        // a coarse grid may lose its way, but what it keeps is right: every point to the scan's own rounding
        for (auto const& record :
             measure_accuracy(scene, {.studies = {"polynomial-fit"}, .sample = 0, .quick = true}).records)
            if (record.method == "points joined, exact motion") {
                CHECK(record.points + record.missed == record.value);
                CHECK(record.error < 1e-9);
            }
    }
}

TEST_CASE("accuracy: tolerances that are measured are ones that the scene takes", "[accuracy]")
{
    // teeth of two micrometres, and of ten millimetres
    for (auto const& [module, teeth] : {std::pair{0.002, 100}, std::pair{10.0, 200}}) {
        INFO("module " << module);
        auto const length = [m = module](char const* key, double modules) {
            return std::string(key) + " = " + std::to_string(modules * m) + "\n";
        };
        std::string const text =
            "[drive]\nname = 'scaled'\n" + length("module", 1) + "flexspline_teeth = " + std::to_string(teeth) +
            "\ncircular_spline_teeth = " + std::to_string(teeth + 2) + "\n[flexspline]\n" + length("wall", 2) +
            "[flexspline.profile]\nfamily = 'straight'\npressure_angle_deg = 30\n" + length("addendum", 0.8) +
            length("dedendum", 1.1) + length("thickness", 1.5) + "[wave_generator]\nfamily = 'cosine'\nwaves = 2\n" +
            length("radial_deformation", 1);
        Scene const scene = parse_scene(text, "test");
        auto const all = accuracy::convergence_series(
            measure_accuracy(scene, {.studies = {"tolerance"}, .sample = 0, .repeats = 1}));
        auto const& levels = series(all, "solve", "scaled").levels;
        CHECK(levels.size() >= 8);
        for (ConvergenceLevel const& level : levels) {
            char setting[64];
            std::snprintf(setting, sizeof setting, "solver.tolerance=%.17g", level.value);
            INFO(setting);
            CHECK_NOTHROW(parse_scene(text, "test", {}, {setting}));
            CHECK(level.error <= level.estimate);
        }
    }
}

TEST_CASE("accuracy: every study is of the sample too", "[accuracy]")
{
    AccuracyOptions options;
    options.quick = true;
    options.sample = 1;
    Scene const scene = read_scene(std::string(HDCONJ_SOURCE_DIR) + "/data/scenes/type-50.toml");
    auto const report = measure_accuracy(scene, options);
    REQUIRE(report.sample == 1);
    auto const settings = [&](std::string_view study, bool sample) {
        std::vector<std::pair<std::string, double>> all;
        for (auto const& record : report.records)
            if (record.study == study && (record.drive != scene.drive.name) == sample)
                all.emplace_back(record.method + ", " + record.knob, record.value);
        return all;
    };
    for (auto const& kind : study_kinds()) {
        INFO(kind.name);
        CHECK(!settings(kind.name, false).empty());
        CHECK(settings(kind.name, false) == settings(kind.name, true));
    }
    // what a load is measured against has its own estimate, and no distance from itself
    int finest = 0;
    for (auto const& record : report.records)
        if (record.study == "load" && record.method.starts_with("reference: ")) {
            CHECK(std::isnan(record.error));
            CHECK(record.estimate > 0);
            CHECK(record.seconds > 0);
            ++finest;
        }
    CHECK(finest == 2 * (1 + report.sample));
    // areas are as far off as they say at most, and no thread changes a bit
    for (auto const& record : report.records) {
        INFO(record.study << " " << record.drive << " " << record.method << " " << record.value);
        if (record.knob == "slices.count" && record.study == "contact-area")
            CHECK(record.error <= record.estimate);
        if (record.study == "threads")
            CHECK(record.extra == 0);
    }
}

TEST_CASE(
    "accuracy: where contacts of a curve merge, a point uncertain along the outline is no further off it than the "
    "estimate says, which is little",
    "[accuracy]")
{
    for (std::string const name : {"bezier", "b-spline"}) {
        Scene scene = read_scene(std::string(HDCONJ_SOURCE_DIR) + "/data/scenes/" + name + ".toml");
        scene.solver.tolerance = scene.drive.module * 2e-9;
        scene.solver.threads = 1;
        Solution const fine = solve(scene);
        INFO(name << ": points " << fine.error.point << " mm");
        CHECK(fine.error.point < 1e-2 * scene.solver.tolerance);
        oracle::EstimateTally const tally = oracle::estimates_bound({scene}, name);
        CHECK(tally.solved == 1);
        CHECK(tally.unjudged == 0);
        CHECK(tally.median() <= 1.3);
    }
}

TEST_CASE("accuracy: the estimate bounds the true error on random designs and is not far above", "[accuracy]")
{
    std::size_t const wanted = oracle::full_run() ? 500 : 24;
    designs::RandomDesigns draw(20250301);
    std::vector<Scene> scenes;
    for (std::size_t i = 0; i < wanted; ++i) {
        Scene scene = draw.next();
        scene.solver.kinematics = Kinematics::exact;
        scene.solver.threads = 1;
        scene.circular_spline.root_clearance = 0;
        // from chords that span a whole arc to thousands of them
        constexpr std::size_t decades = 7;
        scene.solver.tolerance = std::pow(10.0, -3 - static_cast<double>(i % decades));
        scenes.push_back(scene);
    }
    oracle::EstimateTally const tally = oracle::estimates_bound(scenes, "random designs");
    CHECK(tally.ends > 8 * tally.solved);
    CHECK(tally.solved >= wanted * 9 / 10);
    CHECK(tally.unjudged == 0);
    CHECK(tally.largest_land < 1e-6);
    CHECK(tally.median() <= 10);
}

TEST_CASE("accuracy: zones end at the same angles in another unit of length, within their errors", "[accuracy]")
{
    // every rounding is another one, so cusps and reversals, which the reference does not follow, are tried too
    designs::RandomDesigns draw(71);
    std::size_t ends = 0;
    constexpr int wanted = 12;
    for (int i = 0; i < wanted; ++i) {
        Scene scene = draw.next();
        scene.solver.tolerance = scene.drive.module * 1e-4;
        Scene const other = designs::scaled(scene, 1.37);
        Solution a, b;
        try {
            a = solve(scene);
            b = solve(other);
        } catch (NumericalError const&) {
            continue;
        }
        REQUIRE(a.zones.size() == b.zones.size());
        for (std::size_t k = 0; k < a.zones.size(); ++k) {
            ConjugateZone const& p = a.zones[k];
            ConjugateZone const& q = b.zones[k];
            INFO("design " << i << ", zone " << k << " of " << p.segment_name << "\n" << designs::toml_of(scene));
            for (auto const end : {&ConjugateZone::phi_begin, &ConjugateZone::phi_end})
                CHECK(std::abs(p.*end - q.*end) <= p.phi_error + q.phi_error);
            for (auto const end : {&ConjugateZone::t_begin, &ConjugateZone::t_end})
                CHECK(std::abs(p.*end - q.*end) <= p.t_error + q.t_error);
            // and are no empty claim
            CHECK(p.phi_error < 1e-6);
            ends += 2;
        }
    }
    CHECK(ends > 200);
}

}  // namespace hdconj::test::accuracy_cases
