// SPDX-License-Identifier: GPL-3.0-or-later
// The error estimate against 50 digits on every drive that can be solved: wave generators, motion models, tooth
// families, the reverse problem.
#include <cmath>
#include <cstddef>
#include <fstream>
#include <string>
#include <vector>

#include "hdconj/accuracy.hpp"
#include "hdconj/read_scene.hpp"
#include "support/catch.hpp"
#include "support/family_designs.hpp"
#include "support/oracle/estimate_law.hpp"
#include "support/oracle/reference_outline.hpp"
#include "support/oracle/run.hpp"
#include "support/oracle/touch_law.hpp"
#include "support/random_reverse_designs.hpp"
#include "support/random_wave_generators.hpp"
#include "support/temporary_folder.hpp"

namespace hdconj::test::accuracy_of_drives_cases {

namespace {

/// @p scene in one plane with the tolerance of design @p number: 1e-3 ... 1e-9 of a module of 1.
Scene measured_at(Scene scene, std::size_t number)
{
    constexpr std::size_t decades = 7;
    scene.solver.threads = 1;
    scene.circular_spline.root_clearance = 0;
    scene.solver.tolerance =
        std::pow(10.0, -3 - static_cast<double>(number % decades)) * std::max(1.0, scene.drive.module);
    return scene;
}

/// A model of motion that the wave generator has.
Kinematics model_of(std::string const& family, std::size_t number)
{
    bool const smooth = family == "cosine" || family == "ellipse" || family == "ring-on-cosine-cam";
    return all_kinematics[number % (smooth ? 3 : 2)];
}

std::size_t designs_wanted(std::size_t quick, std::size_t full)
{
    return oracle::full_run() ? full : quick;
}

Scene scene_file(std::string const& name)
{
    return read_scene(std::string(HDCONJ_SOURCE_DIR) + "/data/scenes/" + name + ".toml");
}

}  // namespace

TEST_CASE("accuracy: every wave generator and motion model has estimates that bound the error", "[accuracy]")
{
    hdconj::test::TemporaryFolder const folder;
    std::uint64_t seed = 900;
    for (std::string const family : {"four-roller", "two-disc", "table", "ellipse", "ring-on-cosine-cam"}) {
        designs::WaveGeneratorDesigns draw(family, ++seed);
        std::vector<Scene> scenes;
        for (std::size_t i = 0; i < designs_wanted(2, 100); ++i) {
            Scene scene = measured_at(draw.next(folder.path()), 3 * i + seed);
            scene.solver.kinematics = model_of(family, i + seed);
            scenes.push_back(scene);
        }
        oracle::EstimateTally const tally = oracle::estimates_bound(scenes, family);
        CHECK(tally.solved >= scenes.size() * 3 / 4);
        CHECK(tally.unjudged == 0);
        CHECK(tally.ends > 4 * tally.solved);
        CHECK(tally.median() <= 10);
    }
}

TEST_CASE("accuracy: every tooth family has estimates that bound the error", "[accuracy]")
{
    hdconj::test::TemporaryFolder const folder;
    std::uint64_t seed = 950;
    for (std::string const family :
         {"straight", "involute", "cycloid", "s-tooth", "arc-chain", "bezier", "b-spline", "points"}) {
        designs::FamilyDesigns draw(family, ++seed, folder.path());
        std::vector<Scene> scenes;
        for (std::size_t i = 0; i < designs_wanted(1, 60); ++i)
            scenes.push_back(measured_at(draw.next(), i + seed));
        oracle::EstimateTally const tally = oracle::estimates_bound(scenes, family);
        CHECK(2 * tally.solved >= scenes.size());
        CHECK(tally.unjudged <= scenes.size() / 20);
    }
}

TEST_CASE("accuracy: the reverse problem has estimates that bound the error", "[accuracy][reverse]")
{
    designs::RandomReverseDesigns draw(970);
    std::vector<Scene> scenes;
    for (std::size_t i = 0; i < designs_wanted(8, 150); ++i) {
        Scene scene = measured_at(draw.next(), i);
        scene.solver.kinematics = all_kinematics[i % 3];
        scenes.push_back(scene);
    }
    oracle::EstimateTally const tally = oracle::estimates_bound(scenes, "reverse problem");
    CHECK(tally.solved >= scenes.size() * 3 / 4);
    CHECK(tally.unjudged == 0);
    CHECK(tally.median() <= 10);
}

TEST_CASE("accuracy: a table of a cosine comes to the cosine's outline as its rows grow", "[accuracy]")
{
    hdconj::test::TemporaryFolder const folder;
    Scene scene = oracle::type_50();
    accuracy::ReferenceCurve const cosine = accuracy::reference_outline(scene);
    double const w0 = 0.25;
    scene.wave_generator.shape = {};
    scene.wave_generator.shape.path = "wave_generator";
    scene.wave_generator.shape.family = "table";
    scene.folder = folder.path();
    std::vector<double> apart;
    for (int const rows : {36, 72}) {
        std::string const name = "cosine-" + std::to_string(rows) + ".csv";
        std::ofstream out(folder / name);
        out.precision(17);
        for (int i = 0; i <= rows; ++i)
            out << 180.0 * i / rows << "," << w0 * std::cos(2 * std::acos(-1.0) * i / rows) << "\n";
        out.close();
        scene.wave_generator.shape.given["file"] = {name, 0};
        apart.push_back(cosine.largest_distance(accuracy::reference_outline(scene).points()));
    }
    // the tooth stands on the curve's normal: third order in the rows
    CHECK(apart[0] < 1e-4);
    CHECK(apart[1] < apart[0] / 5);
}

TEST_CASE("accuracy: the linear models keep to their own outlines, and second order from the exact one", "[accuracy]")
{
    Scene scene = scene_file("four-roller");
    scene.circular_spline.inner_radius.reset();
    scene.flexspline.profile.given["addendum"].value = 0.1;
    scene.flexspline.profile.given["tip_line_from"].value = 0.08;
    auto const apart = [&](double w0) {
        Scene drive = scene;
        drive.wave_generator.shape.given["radial_deformation"].value = w0;
        accuracy::ReferenceCurve const exact = accuracy::reference_outline(drive).inner();
        drive.solver.kinematics = Kinematics::first_order;
        return exact.largest_distance(accuracy::reference_outline(drive).inner().points());
    };
    double const far = apart(0.25), near = apart(0.2);
    CHECK(far > 1e-4);
    CHECK(std::log(far / near) / std::log(0.25 / 0.2) == Approx(2).margin(0.7));
}

TEST_CASE("accuracy: every family of the data runs its ladder of tolerances", "[accuracy]")
{
    AccuracyOptions options;
    options.studies = {"tolerance"};
    options.quick = true;
    options.sample = 0;
    for (std::string const name : {"four-roller", "cam-table", "circular-spline-given", "bezier"}) {
        Scene scene = scene_file(name);
        // each other model once
        scene.solver.kinematics = name == "cam-table" ? Kinematics::first_order
                                  : name == "bezier"  ? Kinematics::material
                                                      : Kinematics::exact;
        INFO(name);
        AccuracyReport const report = measure_accuracy(scene, options);
        CHECK(report.reference_error < 1e-15);
        CHECK(report.reference_interference < 2e-6);
        REQUIRE(report.records.size() == 4);
        for (StudyRecord const& record : report.records) {
            CHECK(record.hausdorff <= record.estimate);
            CHECK(record.hausdorff <= record.value);
            CHECK(record.hausdorff > 0.3 * record.value);
            CHECK(record.missed == 0);
            CHECK(record.extra == 0);
            CHECK(record.normal_speed < 1e-12);
        }
    }
}

}  // namespace hdconj::test::accuracy_of_drives_cases
