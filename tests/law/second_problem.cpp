// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The second problem: the flanks of a solved drive give its cam back.
#include <algorithm>
#include <cmath>
#include <iostream>
#include <string>

#include "cam/start.hpp"
#include "given_flanks.hpp"
#include "hdconj/error.hpp"
#include "hdconj/wanted_curve.hpp"
#include "support/catch.hpp"
#include "support/random_wave_generators.hpp"
#include "support/temporary_folder.hpp"

namespace hdconj::test::second_problem_cases {

namespace {

using given_flanks::GivenFlanks;
using given_flanks::KnownCurve;
using given_flanks::rounding_of;

/// The march over a drive's mesh against its known curve.
struct Comparison
{
    std::size_t points = 0;  ///< compared, of 99
    double error = 0;        ///< largest where the flanks determine the curve [mm]
    double growth = 0;       ///< of an error of a flank there
    bool whole = false;      ///< whether that is the whole mesh
};

/// Where an error of the flanks grows more than that, rounding of double precision exceeds 1e-9 mm.
constexpr double most_growth = 1e5;

Comparison compared(GivenFlanks const& given, KnownCurve const& known, cam::MeshPoint const& begin, double rounding)
{
    constexpr int points = 100;
    std::vector<double> angles;
    for (int i = 1; i < points; ++i)
        angles.push_back(begin.x + (given.end - begin.x) * i / points);
    cam::MarchedCurve const marched = cam::march(given.pair, given.rule, begin, angles, rounding);
    double const probe = 1e-13 * given.rule.r_m;
    cam::FlankPair const moved = given.pair.moved(probe);
    cam::MarchedCurve const other = cam::march(moved, given.rule, begin, angles, rounding);
    Comparison result;
    for (std::size_t i = 0; i < std::min(marched.points.size(), other.points.size()); ++i) {
        double const w = marched.points[i].state[0];
        double const growth = std::abs(other.points[i].state[0] - w) / probe;
        if (growth > most_growth)
            return result;
        result.growth = std::max(result.growth, growth);
        result.error = std::max(result.error, std::abs(w - known.state(marched.points[i].x)[0]));
        ++result.points;
    }
    result.whole = result.points == angles.size();
    return result;
}

struct Tally
{
    int drives = 0, singular = 0, whole = 0;
    double worst = 0;
};

/// Compares one drive.
void add_drive(Scene const& drawn, std::filesystem::path const& folder, Kinematics kinematics, Tally& tally)
{
    Scene changed = drawn;
    changed.solver.kinematics = kinematics;
    INFO(designs::toml_of(changed));
    Solution solution;
    try {
        solution = solve(parse_scene(designs::toml_of(changed), "generated scene", folder));
    } catch (std::runtime_error const&) {
        return;  // drawn for the exact motion
    }
    KnownCurve const known(solution.scene, solution.geometry.r_m);
    auto const given = given_flanks::flanks_of(solution, known.motion);
    if (!given)
        return;
    // the contact runs fastest where it begins
    double const begin = given->begin + (given->end - given->begin) / 64;
    cam::MeshPoint const at = known.point(given->rule, begin);
    auto const touching = given->pair.tangencies(given->rule.origin(at.x, at.state), at.contact.theta);
    if (touching.empty()) {
        ++tally.singular;  // the contact's normal passes the tooth's origin: no inclination answers to a gap
        return;
    }
    double const rounding = rounding_of(solution.scene);
    Comparison const found = compared(*given, known, at, rounding);
    ++tally.drives;
    CHECK(found.error < 1e-9);
    CHECK((found.whole || found.points > 0));
    tally.whole += found.whole ? 1 : 0;
    tally.worst = std::max(tally.worst, found.error);
}

void cam_comes_back(std::string const& family, std::uint64_t seed, int wanted, Kinematics kinematics)
{
    TemporaryFolder const folder;
    designs::RandomDesigns cosine(seed);
    designs::WaveGeneratorDesigns other(family, seed);
    Tally tally;
    for (int drawn = 0; tally.drives < wanted; ++drawn) {
        REQUIRE(drawn < 8 * wanted);
        Scene const scene = family == "cosine" ? cosine.next() : other.next(folder.path());
        // one wave with many teeth more passes walls of other spaces
        if (scene.wave_generator.waves > 1)
            add_drive(scene, folder.path(), kinematics, tally);
    }
    std::cout << "second problem, " << family << ": " << tally.drives << " drives, " << tally.singular
              << " singular at the beginning, " << tally.whole << " determined over the whole mesh, worst "
              << tally.worst << " mm\n";
    CHECK(2 * tally.whole >= wanted);
}

}  // namespace

TEST_CASE("second problem: flanks give their cosine cam back", "[second-problem]")
{
    cam_comes_back("cosine", 7, 20, Kinematics::exact);
}

TEST_CASE("second problem: flanks give their cosine cam back in the first order", "[second-problem]")
{
    cam_comes_back("cosine", 8, 10, Kinematics::first_order);
}

TEST_CASE("second problem: flanks give their elliptic cam back", "[second-problem]")
{
    cam_comes_back("ellipse", 9, 10, Kinematics::exact);
}

TEST_CASE("second problem: flanks give their two discs back", "[second-problem]")
{
    cam_comes_back("two-disc", 10, 10, Kinematics::exact);
}

TEST_CASE("second problem: flanks give their four rollers back", "[second-problem]")
{
    cam_comes_back("four-roller", 11, 10, Kinematics::exact);
}

TEST_CASE("second problem: the curve of type-50 from the axis on", "[second-problem]")
{
    Solution const solution = solve(oracle::type_50());
    KnownCurve const known(solution.scene, solution.geometry.r_m);
    auto const given = given_flanks::flanks_of(solution, known.motion);
    REQUIRE(given);
    double const rounding = rounding_of(solution.scene);
    cam::MeshBegin const begin =
        cam::mesh_begin(given->pair, given->rule, 2, known.state(0)[0], std::numbers::pi / 4, rounding);
    CHECK(std::abs(begin.first - given->begin) < 0.1 * deg);
    for (double const x : {0.0, begin.point.x / 2, begin.point.x})
        CHECK(std::abs(begin.to_axis(x).value - known.state(x)[0]) < 1e-13);
    Comparison const found = compared(*given, known, begin.point, rounding);
    CHECK(found.points > 90);
    CHECK(found.error < 1e-9);
    CHECK(found.growth > 1e4);
    // where the mesh ends is what the flanks say
    cam::MarchedCurve const to_end =
        cam::march(given->pair, given->rule, begin.point, {std::numbers::pi / 2}, rounding);
    CHECK(to_end.lost);
    CHECK(std::abs(to_end.last.x - given->end) < 1e-4 * deg);
}

}  // namespace hdconj::test::second_problem_cases
