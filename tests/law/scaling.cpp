// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// A drive that is k times as large, under k^3 of the torque: angles, stresses and pressures stay. What the program
/// takes in millimetres shows here.
#include <fmt/format.h>
#include <set>
#include <sstream>
#include <string>

#include "hdconj/load.hpp"
#include "hdconj/read_scene.hpp"
#include "hdconj/units.hpp"
#include "support/catch.hpp"
#include "support/elastic_drives.hpp"

namespace hdconj::test::scaling_cases {
namespace {

/// The scene with all of its lengths @p size times as large, the tolerance too.
std::string scaled(std::string const& scene, double size)
{
    static std::set<std::string> const no_lengths{
        "flexspline_teeth", "circular_spline_teeth", "youngs_modulus", "poissons_ratio", "waves", "balls", "count"};
    std::istringstream lines(scene + fmt::format("[solver]\ntolerance = {}\n", 1e-6));
    std::string result;
    for (std::string line; std::getline(lines, line); result += line + "\n") {
        std::size_t const equals = line.find(" = ");
        if (equals == std::string::npos || line[equals + 3] == '"' || no_lengths.contains(line.substr(0, equals)))
            continue;
        line = fmt::format("{} = {:.17}", line.substr(0, equals), size * std::stod(line.substr(equals + 3)));
    }
    return result;
}

LoadStudy under_torque(designs::ElasticDrive const& drive, double size)
{
    LoadOptions options;
    options.torque = size * size * size * drive.torque * newton_metre;
    options.curve = false;
    options.errors = false;
    return study_load(parse_scene(scaled(drive.scene, size), "scaled"), options, {}, {}, {});
}

}  // namespace

TEST_CASE("law: a drive of four times the size has the same angles, stresses and pressures", "[law][load]")
{
    constexpr double size = 4;  // a power of two: products are exact
    for (unsigned const seed : {1U, 2U, 4U}) {
        designs::ElasticDrive const drive = designs::elastic_drive(seed);
        LoadStudy const one = under_torque(drive, 1), large = under_torque(drive, size);
        CAPTURE(seed);
        REQUIRE(one.cases.size() == large.cases.size());
        CHECK(large.cup.largest_stress == Approx(one.cup.largest_stress).epsilon(1e-6));
        CHECK(large.cup.coning_major == Approx(one.cup.coning_major).epsilon(1e-6));
        CHECK(large.cup.wave_generator_force == Approx(size * size * one.cup.wave_generator_force).epsilon(1e-6));
        for (std::size_t i = 0; i < one.cases.size(); ++i) {
            LoadCase const &a = one.cases[i], &b = large.cases[i];
            LoadedState const &at = a.curve[a.rated], &in_large = b.curve[b.rated];
            CHECK(b.backlash == Approx(a.backlash).epsilon(1e-5).margin(1e-9));
            CHECK(in_large.twist == Approx(at.twist).epsilon(1e-5));
            CHECK(in_large.stiffness == Approx(size * size * size * at.stiffness).epsilon(1e-4));
            CHECK(in_large.largest_force == Approx(size * size * at.largest_force).epsilon(1e-4));
            CHECK(in_large.largest_pressure == Approx(at.largest_pressure).epsilon(1e-3));
            CHECK(in_large.largest_stress == Approx(at.largest_stress).epsilon(1e-4));
            CHECK(in_large.contact_area == Approx(size * size * at.contact_area).epsilon(1e-3));
        }
    }
}

}  // namespace hdconj::test::scaling_cases
