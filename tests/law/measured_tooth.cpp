// SPDX-License-Identifier: GPL-3.0-or-later
// Noisy points of the tooth of a drive: the scene with the mean measured tooth is taken by solve, contact and load.
#include <array>
#include <cmath>
#include <iostream>
#include <numbers>
#include <string>
#include <vector>

#include "drive/drive.hpp"
#include "hdconj/base/rigid_motion.hpp"
#include "hdconj/contact.hpp"
#include "hdconj/error.hpp"
#include "hdconj/inspect.hpp"
#include "hdconj/inspect_files.hpp"
#include "hdconj/load.hpp"
#include "hdconj/read_scene.hpp"
#include "hdconj/solve.hpp"
#include "hdconj/units.hpp"
#include "inspect/nominal_part.hpp"
#include "support/catch.hpp"
#include "support/family_designs.hpp"
#include "support/measured_ring.hpp"
#include "support/oracle/touch_law.hpp"
#include "support/temporary_folder.hpp"

namespace hdconj::test::measured_tooth_cases {
namespace {

constexpr std::array families{"straight",  "involute", "cycloid",  "s-tooth",
                              "arc-chain", "bezier",   "b-spline", "points"};

/// How a tooth is measured, and what is wrong with it [mm].
struct Measurement
{
    int teeth = 1, points = 20;
    double margin = 0.06;  ///< share of the flank at either end that has no points
    double noise = 0;      ///< standard deviation
    double slope = 0, crowning = 0, wave = 0, phase = 0;
    designs::Draws draws{0};  ///< of the noise

    [[nodiscard]] double form(double xi) const
    {
        return slope / 2 * xi - crowning * xi * xi + wave * std::sin(5 * xi + phase);
    }
};

/// From one tooth of few points to 14 teeth of many. @param errors  largest of slope, crowning and wave [mm]
Measurement drawn(int number, double noise, double errors)
{
    designs::Draws draws(1000 + static_cast<std::uint64_t>(number));
    Measurement how;
    how.noise = noise;
    how.teeth = std::array{1, 3, 14}[static_cast<std::size_t>(number % 3)];
    how.points = draws.whole(9, 40);
    if (errors > 0) {
        how.slope = errors * draws.between(-1, 1);
        how.crowning = errors * draws.between(-1, 1);
        how.wave = errors * draws.between(-0.3, 0.3);
        how.phase = draws.between(0, 6);
        how.margin = draws.between(0.02, 0.2);
    }
    how.draws = draws;
    return how;
}

PointFile measured_points(Scene const& scene, Measurement how)
{
    Faults faults;
    profile::Profile const tooth = drive::given_tooth(scene, faults);
    REQUIRE(faults.empty());
    double const seat = drive::ring_geometry(scene, tooth).r_m;
    inspect::NominalPlane const plane = inspect::plane_of_profile(tooth, seat);
    PointFile file{"ring", {}, false};
    for (int k = 0; k < how.teeth; ++k)
        for (bool const right : {false, true})
            for (int i = 0; i < how.points; ++i) {
                inspect::NominalFlank const& flank = plane.flank(right);
                double const share = how.margin + (1 - 2 * how.margin) * i / (how.points - 1);
                auto const at = flank.at(share * flank.length());
                double const off = how.form(2 * share - 1) + how.noise * normal(how.draws);
                Vec2 const p = at.point + off * at.normal + Vec2(0, seat);
                file.points.push_back({turned_clockwise(p, 2 * std::numbers::pi * k / scene.drive.flexspline_teeth), 0,
                                       0, std::nullopt, static_cast<int>(file.points.size()) + 2});
            }
    return file;
}

/// What is tried beyond solve.
enum class Verbs
{
    solve,
    contact,
    load
};

Inspection inspected(Scene const& scene, Measurement const& how)
{
    return inspect_points(scene, measured_points(scene, how),
                          {InspectedPart::flexspline, std::nullopt, 0, Registration::least_squares});
}

/// The scene with the measured tooth, in @p folder.
Scene measured_scene(Scene const& scene, Measurement const& how, TemporaryFolder const& folder)
{
    write_measured_tooth(inspected(scene, how), folder / "cut.toml");
    auto reading = examine_scene_file(folder / "cut.toml");
    examine_geometry(reading);
    INFO(describe(reading.faults));
    REQUIRE(reading.faults.empty());
    return reading.scene;
}

/// What the verbs make of the scene with the measured tooth.
void check_taken(Scene const& scene, Measurement const& how, Verbs verbs)
{
    TemporaryFolder const folder;
    Scene const measured = measured_scene(scene, how, folder);
    CHECK(solve(measured).certificate.certified());
    if (verbs == Verbs::contact)
        CHECK_FALSE(study_contact(measured).cases.empty());
    if (verbs != Verbs::load)
        return;
    LoadOptions options;
    options.curve = options.errors = false;
    options.torque = 7 * newton_metre;
    CHECK(study_load(measured, options).cup.largest_stress > 0);
}

/// A drive of a family with a face width.
Scene with_width(Scene const& made)
{
    std::string const width = "circular_spline.width=" + std::to_string(8 * made.drive.module);
    return examine_scene(designs::toml_of(made), "generated scene", made.folder, {width}).scene;
}

/// Whether contact takes the drive as it is.
bool has_contact(Scene const& scene)
{
    try {
        return !study_contact(scene).cases.empty();
    } catch (NumericalError const&) {
        return false;
    }
}

/// Drives with the seed @p seed, all noises, without and with errors of form.
/// @param with_contact  tried on so many of the drives
void check_family(std::string const& family, std::uint64_t seed, int drives, int with_contact,
                  std::vector<double> const& noises, std::vector<double> const& errors)
{
    TemporaryFolder const folder;
    designs::FamilyDesigns draw(family, seed, folder.path());
    int solved = 0, touched = 0;
    for (int i = 0; i < drives; ++i) {
        Scene const scene = with_width(draw.next());
        Verbs const verbs = i < with_contact && has_contact(scene) ? Verbs::contact : Verbs::solve;
        for (double const noise : noises)
            for (double const error : errors) {
                INFO(family << " " << i << ", noise " << noise << ", errors " << error);
                CHECK_NOTHROW(check_taken(scene, drawn(i, noise, error), verbs));
                ++(verbs == Verbs::contact ? touched : solved);
            }
    }
    std::cout << family << ": measured teeth, " << touched << " for contact, " << solved << " for solve\n";
}

/// Drive @p number of a family whose measured teeth were once refused.
Scene former_refusal(std::string const& family, int number)
{
    designs::FamilyDesigns draw(family, 77);
    for (int i = 0; i < number; ++i)
        (void)draw.next();
    return with_width(draw.next());
}

}  // namespace

TEST_CASE("solve takes the tooth that noisy points have measured", "[inspect]")
{
    for (char const* family : families)
        check_family(family, 78, 2, 0, {3e-4, 1e-3}, {2e-3});
}

TEST_CASE("a measured tooth whose end is almost level is taken", "[inspect]")
{
    auto const [family, number] =
        GENERATE(table<std::string, int>({{"s-tooth", 6}, {"arc-chain", 12}, {"cycloid", 12}}));
    INFO(family << " " << number);
    check_taken(former_refusal(family, number), drawn(number, 1e-3, 0), Verbs::solve);
}

TEST_CASE("a side clearance may cut off pieces of the spline through measured points", "[inspect]")
{
    Inspection const found = inspected(former_refusal("arc-chain", 55), drawn(55, 0, 0));
    Solution const solution = solve(measured_tooth_scene(found, "cut.toml").scene);
    // nothing is missing beside what was cut off: the outline touches, and nowhere enters
    constexpr std::size_t positions = 1200, most = 24;
    oracle::TouchScan scan(solution.scene, positions);
    auto const report = oracle::touch_law(solution, scan, most, 1);
    CAPTURE(report);
    CHECK(report.holds());
    CHECK(report.touched.points >= 10);
}

TEST_CASE("one tooth of few points, whose lean they hardly fix, is registered", "[inspect]")
{
    check_taken(former_refusal("bezier", 0), drawn(0, 3e-4, 0), Verbs::solve);
}

TEST_CASE("contact takes the tooth that noisy points have measured", "[inspect]")
{
    auto const reading = examine_scene_file(HDCONJ_SOURCE_DIR "/data/scenes/type-50.toml", {"solver.threads=1"});
    REQUIRE(reading.faults.empty());
    check_taken(reading.scene, drawn(1, 3e-4, 2e-3), Verbs::contact);
}

TEST_CASE("solve takes many measured teeth", "[.][measured-teeth]")
{
    for (char const* family : families)
        check_family(family, 77, 60, 0, {0, 1e-4, 3e-4, 1e-3}, {0, 3e-3});
}

TEST_CASE("contact takes many measured teeth", "[.][measured-teeth]")
{
    for (char const* family : families)
        check_family(family, 77, 4, 4, {3e-4, 1e-3}, {3e-3});
}

TEST_CASE("load takes many measured teeth", "[.][measured-teeth]")
{
    auto const reading = examine_scene_file(HDCONJ_SOURCE_DIR "/data/scenes/type-50-elastic.toml");
    for (int i = 0; i < 3; ++i)
        for (double const noise : {3e-4, 1e-3}) {
            INFO(i << ", noise " << noise);
            CHECK_NOTHROW(check_taken(reading.scene, drawn(i, noise, 3e-3), Verbs::load));
        }
}

}  // namespace hdconj::test::measured_tooth_cases
