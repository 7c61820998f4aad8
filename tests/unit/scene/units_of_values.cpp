// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers with a unit where a scene takes none: the number that is advised is the one that was meant.
#include <fmt/format.h>

#include <array>
#include <optional>
#include <regex>
#include <string>
#include <utility>

#include "hdconj/profile/registry.hpp"
#include "hdconj/read_scene.hpp"
#include "hdconj/scene/reading.hpp"
#include "hdconj/units.hpp"
#include "hdconj/wavegen/registry.hpp"
#include "support/catch.hpp"
#include "support/draws.hpp"

namespace hdconj::test::units_of_values_cases {
namespace {

/// What is said of @p key with @p value in a drive that is right otherwise.
Fault fault_with(std::string const& key, std::string const& value)
{
    std::string const text =
        "[drive]\nname = \"d\"\nmodule = 0.3\nflexspline_teeth = 120\ncircular_spline_teeth = 122\n"
        "[flexspline]\nwall = 0.45\n[flexspline.profile]\nfamily = \"straight\"\naddendum = 0.25\ndedendum = 0.3\n"
        "thickness = 0.45\npressure_angle_deg = 28\n"
        "[wave_generator]\nfamily = \"cosine\"\nradial_deformation = 0.3\nwaves = 2\n";
    std::string const line = "\n" + key + " = ";
    std::size_t const at = text.find(line);
    REQUIRE(at != std::string::npos);
    std::string edited = text.substr(0, at) + line + value + text.substr(text.find('\n', at + 1));
    Faults const faults = examine_scene(edited, "d").faults;
    REQUIRE_FALSE(faults.empty());
    return faults.front();
}

/// The number that @p fault tells to write; nothing where it names none.
std::optional<double> told(Fault const& fault)
{
    std::smatch number;
    return std::regex_search(fault.remedy, number, std::regex("^write ([-0-9.e+]+)[, ]"))
               ? std::optional(std::stod(number[1]))
               : std::nullopt;
}

}  // namespace

TEST_CASE("a length or an angle with another unit is told in the unit of its key", "[scene]")
{
    struct Unit
    {
        char const* name;
        double factor;
    };
    constexpr std::array lengths{Unit{"mm", 1},    Unit{"um", 1e-3},   Unit{"cm", 10},      Unit{"m", 1e3},
                                 Unit{"in", 25.4}, Unit{"inch", 25.4}, Unit{"mil", 0.0254}, Unit{"nm", 1e-6}};
    constexpr std::array angles{Unit{"deg", 1}, Unit{"arcmin", 1.0 / 60}, Unit{"mrad", per_deg / 1000},
                                Unit{"rad", per_deg}};
    designs::Draws draws(1);
    auto const check = [&](Unit const& unit, char const* key, double meant) {
        std::string const typed = fmt::format("{:.5g}", meant / unit.factor);
        for (char const* const form : {"\"{} {}\"", "\"{}{}\"", "{} {}"}) {
            Fault const fault = fault_with(key, fmt::format(fmt::runtime(form), typed, unit.name));
            INFO(fault.value << ": " << fault.remedy);
            REQUIRE(told(fault));
            CHECK(*told(fault) == Approx(std::stod(typed) * unit.factor).epsilon(1e-11));
        }
    };
    for (Unit const& unit : lengths)
        check(unit, "wall", draws.between(0.2, 0.9));
    for (Unit const& unit : angles)
        check(unit, "pressure_angle_deg", draws.between(10, 40));
}

TEST_CASE("no number is told where the unit is not known or of another quantity", "[scene]")
{
    for (auto const& [key, value] : {std::pair{"wall", "\"3 furlongs\""},
                                     {"wall", "\"1/2\""},
                                     {"wall", "\"28 Nm\""},
                                     {"wall", "\"20 deg\""},
                                     {"wall", "28 Nm"},
                                     {"pressure_angle_deg", "\"3 mm\""},
                                     {"flexspline_teeth", "\"120 teeth\""},
                                     {"thickness", "0.45 pitches"}}) {
        Fault const fault = fault_with(key, value);
        INFO(key << " = " << value << ": " << fault.remedy);
        CHECK_FALSE(told(fault));
        CHECK(fault.remedy.find("without") != std::string::npos);
    }
}

TEST_CASE("the unit of a key is that in which scenes state it", "[scene]")
{
    scene::SceneFamilies const families{profile::profile_families(), wavegen::wave_generator_families()};
    for (auto const& [key, unit] : {std::pair{"circular_spline.backlash_offset", "mm"},  // or a word
                                    {"tilt.angle_deg", "deg"},
                                    {"load.torque", "N m"},
                                    {"compliance.hub", "N m/rad"},
                                    {"flexspline.cup.youngs_modulus", "MPa"},
                                    {"flexspline.profile.convex_radius", "mm"},  // of one family
                                    {"wave_generator.roller_angle_deg", "deg"},
                                    {"drive.flexspline_teeth", ""},
                                    {"drive.name", ""},
                                    {"errors.circular_spline.pitch", ""},
                                    {"flexspline.unknown", ""},
                                    {"unknown.wall", ""},
                                    {"flexspline", ""},
                                    {"", ""}}) {
        INFO(key);
        auto const described = scene::describe_key(key, families);
        CHECK((described ? described->unit : "") == unit);
    }
}

TEST_CASE("the description of a key says what it takes, as a fault of the scene does", "[scene]")
{
    scene::SceneFamilies const families{profile::profile_families(), wavegen::wave_generator_families()};
    CHECK_FALSE(scene::describe_key("flexspline.unknown", families));
    CHECK_FALSE(scene::describe_key("flexspline", families));
    auto const described = scene::describe_key("flexspline.wall", families);
    REQUIRE(described);
    CHECK(described->quantity == scene::Quantity::positive_length);
    CHECK(fault_with("wall", "\"?\"").remedy.starts_with("write " + described->expectation));
    auto const word = scene::describe_key("circular_spline.backlash_offset", families);
    REQUIRE(word);
    CHECK(word->quantity == scene::Quantity::length_or_word);
}

}  // namespace hdconj::test::units_of_values_cases
