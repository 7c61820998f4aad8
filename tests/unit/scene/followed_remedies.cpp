// SPDX-License-Identifier: GPL-3.0-or-later
// Remedies that say what to write, followed to the letter on drives of any size.
#include <fmt/format.h>

#include <regex>
#include <string>
#include <vector>

#include "hdconj/check.hpp"
#include "hdconj/load.hpp"
#include "hdconj/read_scene.hpp"
#include "hdconj/solve.hpp"
#include "support/catch.hpp"

namespace hdconj::test::followed_remedy_cases {
namespace {

using Keys = std::vector<std::string>;

/// Straight teeth of this module, without anything along the axis.
scene::SceneReading flat_drive(double module, Keys const& keys)
{
    std::string const text = fmt::format(
        "[drive]\nname = \"flat\"\nmodule = {0}\nflexspline_teeth = 100\ncircular_spline_teeth = 102\n"
        "[flexspline]\nwall = {1}\n[flexspline.profile]\nfamily = \"straight\"\naddendum = {2}\ndedendum = {3}\n"
        "thickness = {4}\npressure_angle_deg = 28.6\n"
        "[wave_generator]\nfamily = \"cosine\"\nradial_deformation = {0}\nwaves = 2\n",
        module, 1.4 * module, 0.8 * module, 1.1 * module, 1.5 * module);
    return examine_scene(text, "flat", {}, keys);
}

/// What @p fault tells to write, as arguments of --set.
Keys settings_of(Fault const& fault)
{
    std::smatch table, key;
    std::string const& remedy = fault.remedy;
    std::string path = fault.path.substr(0, fault.path.rfind('.') + 1), list = remedy;
    if (std::regex_search(remedy, table, std::regex(R"(write the line \[([a-z_.]+)\] and below it (.*))"))) {
        path = table[1].str() + ".";
        list = table[2];
    }
    Keys settings;
    for (std::regex const assignment(R"(([a-z_]+) = ("[a-z]+"|[0-9.e+-]+))"); std::regex_search(list, key, assignment);
         list = key.suffix()) {
        settings.push_back(path + key[1].str() + "=" + key[2].str());
        if (list == remedy)
            break;  // a single value, and after it what else is possible
    }
    return settings;
}

}  // namespace

TEST_CASE("remedies for a missing cup, bearing, width and torque suit a drive of any size", "[load]")
{
    for (double const module : {0.1, 0.25, 0.8, 3.0})
        for (Keys const& given : {Keys{}, Keys{fmt::format("circular_spline.width={}", 25 * module)},
                                  Keys{"bearing.type=rigid", fmt::format("bearing.width={}", 20 * module)}}) {
            Keys keys = given;
            Faults const missing = check_load(flat_drive(module, keys).scene, {});
            CHECK(missing.size() >= 3);
            for (Fault const& fault : missing)
                for (std::string const& setting : settings_of(fault))
                    keys.push_back(setting);
            INFO(module << ": " << fmt::format("{}", fmt::join(keys, " ")));
            auto reading = flat_drive(module, keys);
            examine_geometry(reading);
            CHECK(describe(reading.faults) == "");
            CHECK(describe(check_load(reading.scene, {})) == "");
        }
}

TEST_CASE("remedies for an elastic cone without cup and bearing suit a drive of any size", "[load]")
{
    for (double const module : {0.1, 0.8, 3.0}) {
        Keys keys{"coning.model=elastic", fmt::format("circular_spline.width={}", 14 * module)};
        Faults const missing = flat_drive(module, keys).faults;
        CHECK(missing.size() == 3);
        for (Fault const& fault : missing)
            for (std::string const& setting : settings_of(fault))
                keys.push_back(setting);
        INFO(module << ": " << fmt::format("{}", fmt::join(keys, " ")));
        auto reading = flat_drive(module, keys);
        examine_geometry(reading);
        CHECK(describe(reading.faults) == "");
    }
}

TEST_CASE("an amount that is advised in modules has two digits", "[scene]")
{
    auto const faults = flat_drive(0.18, {"tip_relief.amount=1", "tip_relief.from_height=0.05"}).faults;
    REQUIRE(faults.size() == 1);
    CHECK(faults.front().remedy == "write at most 0.018, such as 0.0029");
}

}  // namespace hdconj::test::followed_remedy_cases
