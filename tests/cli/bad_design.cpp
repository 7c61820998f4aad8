// SPDX-License-Identifier: GPL-3.0-or-later
// Wrong wishes of `hdconj design` and `hdconj init --like`: place, reason, remedy, exit status, and no file.
#include <fstream>
#include <nlohmann/json.hpp>

#include "bad_commands.hpp"
#include "support/run/full_run.hpp"

namespace hdconj::test::bad_design_cases {
namespace {

std::string const fifty = "--ratio 100 --diameter 50 ";

std::vector<BadCommand> const& design_commands()
{
    static std::vector<BadCommand> const table{
        {"", "--ratio", "is required", "--help"},
        {"--diameter 50", "--ratio", "is required", "--help"},
        {"--ratio abc --diameter 50", "--ratio", "'abc' is no finite number", "such as 100"},
        {"--ratio '' --diameter 50", "--ratio", "'' is no finite number", "such as 100"},
        {"--ratio nan --diameter 50", "--ratio", "'nan' is no finite number", "such as 100"},
        {"--ratio inf --diameter 50", "--ratio", "'inf' is no finite number", "such as 100"},
        {"--ratio 100:1 --diameter 50", "--ratio", "'100:1' is no finite number", "such as 100"},
        {"--ratio 100.5 --diameter 50", "--ratio = 100.5", "two waves need even numbers of teeth", "works is 101"},
        {"--ratio 99.6 --diameter 50", "--ratio = 99.6", "whole number", "works is 100"},
        {"--ratio=-100 --diameter 50", "--ratio = -100", "from 30 to 320", "works is 30"},
        {"--ratio 0 --diameter 50", "--ratio = 0", "from 30 to 320", "works is 30"},
        {"--ratio 29 --diameter 50", "--ratio = 29", "from 30 to 320", "works is 30"},
        {"--ratio 321 --diameter 50", "--ratio = 321", "from 30 to 320", "works is 320"},
        {"--ratio 1e9 --diameter 50", "--ratio = 1e+09", "from 30 to 320", "works is 320"},
        {"--ratio 100", "--diameter", "neither a pitch diameter nor a module", "--module 0.25"},
        {"--ratio 100 --diameter 0", "--diameter = 0", "not a number above 0", "such as 50"},
        {"--ratio 100 --diameter=-50", "--diameter = -50", "not a number above 0", "such as 50"},
        {"--ratio 100 --diameter 50mm", "--diameter", "'50mm' is no finite number", "such as 50"},
        {"--ratio 100 --diameter 5", "--diameter = 5", "from 10 to 400 mm", "works is 10"},
        {"--ratio 100 --diameter 1000", "--diameter = 1000", "from 10 to 400 mm", "works is 400"},
        {"--ratio 320 --diameter 20", "--diameter = 20", "the module d_r/z_f would be 0.03125", "works is 32"},
        {"--ratio 100 --module 0", "--module = 0", "not a number above 0", "such as 0.25"},
        {"--ratio 100 --module x", "--module", "'x' is no finite number", "such as 0.25"},
        {"--ratio 100 --module 0.01", "--module = 0.01", "from 0.05 to 10 mm", "works is 0.05"},
        {"--ratio 100 --module 20", "--module = 20", "from 0.05 to 10 mm", "works is 2"},
        {"--ratio 100 --module 4", "--module = 4", "would be 800 mm", "works is 2"},
        {"--ratio 100 --diameter 50 --module 0.3", "--module = 0.3", "would be 60 mm with 200 teeth",
         "--module 0.25, or --diameter 60"},
        {fifty + "--length-ratio 0.1", "--length-ratio = 0.1", "0.2 to 1 pitch diameters", "works is 0.2"},
        {fifty + "--length-ratio 2", "--length-ratio = 2", "0.2 to 1 pitch diameters", "works is 1"},
        {fifty + "--length-ratio=-1", "--length-ratio = -1", "0.2 to 1 pitch diameters", "works is 0.2"},
        {fifty + "--length-ratio 1/4", "--length-ratio", "'1/4' is no finite number", "such as 0.25"},
        {fifty + "--torque 0", "--torque = 0", "not a number above 0", "in N m such as 28"},
        {fifty + "--torque 1e-12", "--torque = 1e-12", "outside the range of load.torque", "works is 1e-09"},
        {fifty + "--torque=-28", "--torque = -28", "not a number above 0", "in N m such as 28"},
        {fifty + "--torque 28Nm", "--torque", "'28Nm' is no finite number", "such as 28"},
        {fifty + "--family involut", "--family = involut", "not known", "write involute"},
        {fifty + "--family gear", "--family = gear", "not known: there is double-circular-arc", "write "},
        {fifty + "--family points", "--family = points", "no rule gives them", "--family b-spline"},
        {fifty + "--family ''", "--family", "not known", "write "},
        {fifty + "--material steel", "--material = steel", "not known: there is 30CrMnSiA", "write 30CrMnSiA"},
        {fifty + "--material 30crmnsia", "--material = 30crmnsia", "not known", "write 30CrMnSiA"},
        {fifty + "--material 17-4PH", "--material = 17-4PH", "not known", "by --fatigue, --youngs-modulus and"},
        {fifty + "--material 17-4PH --fatigue 500", "--material = 17-4PH", "not known", "--youngs-modulus"},
        {fifty + "--material \"$(printf 'a\\nb')\" --fatigue 500 --youngs-modulus 2e5 --poissons-ratio 0.3",
         "--material = a\\x0ab", "control characters", "leave them out"},
        {fifty + "--fatigue 0", "--fatigue = 0", "not a number above 0", "in MPa such as 550"},
        {fifty + "--fatigue 550MPa", "--fatigue", "'550MPa' is no finite number", "such as 550"},
        {fifty + "--youngs-modulus=-1", "--youngs-modulus = -1", "not a number above 0", "write 206000"},
        {fifty + "--youngs-modulus 1e8", "--youngs-modulus = 1e+08", "steel has 206000", "works is 1e+07"},
        {fifty + "--poissons-ratio 0.6", "--poissons-ratio = 0.6", "steel has 0.3", "works is 0.499"},
        {fifty + "--land=-0.1", "--land = -0.1", "a tip land", "works is 0"},
        {fifty + "--land 2", "--land = 2", "a tip land", "works is 0.8"},
        {fifty + "--clearance=-0.01", "--clearance = -0.01", "no side clearance", "write 0"},
        {fifty + "--clearance 0.2", "--clearance = 0.2", "no radial deformation", "the nearest that works is 0.144"},
        {fifty + "--safety 0.5", "--safety = 0.5", "below 1 the cup breaks", "works is 1"},
        {fifty + "--safety 50", "--safety = 50", "above 10", "works is 10"},
        {"--ratio 30 --diameter 50 --safety 5", "--safety = 5", "bending the ring stresses it",
         "the nearest that works is "},
        {fifty + "-o there.toml", "there.toml", "is there already", "--force"},
        {fifty + "-o .", ".", "this is a folder", "name a file in it"},
        {fifty + "-o ''", "--output", "an empty name", "write a name"},
        {fifty + "-o -", "--output = -", "do not go to standard output", "a file name"},
        {fifty + "drive.toml", "drive.toml", "not expected", "--help"},
        {fifty + "--lenght-ratio 0.3", "--lenght-ratio", "not expected", "Did you mean --length-ratio?"},
        {"--ratio 100.5 --diameter 5 --family gear", "3 faults", "--family = gear", "--diameter = 5"}};
    return table;
}

}  // namespace

TEST_CASE("design refuses wishes with place, reason and the nearest that works", "[cli][design]")
{
    TemporaryFolder folder;
    std::ofstream(folder.path() / "there.toml") << "# mine\n";
    REQUIRE(design_commands().size() >= 40);
    for (auto const& row : design_commands())
        check_refused("design", row, folder);
    if (full_run())  // every wall is tried, as law/design_wishes does with its words
        check_refused("design",
                      {fifty + "--torque 1e6", "--torque = 1e+06", "with the best wall", "the nearest that works is "},
                      folder);
}

TEST_CASE("with JSON refused wishes are one object with every fault", "[cli][design]")
{
    TemporaryFolder folder;
    auto const refused = hdconj_run("design --ratio 100.5 --length-ratio 3 --json", folder.path());
    CHECK(refused.status == 2);
    auto const json = nlohmann::json::parse(refused.out);
    CHECK(json.at("scene") == "the wishes");
    REQUIRE(json.at("faults").size() == 3);
    CHECK(json.at("faults")[0].at("path") == "--ratio");
}

TEST_CASE("init refuses a drive that it does not have", "[cli][design]")
{
    TemporaryFolder folder;
    check_refused("init", {"a.toml --like size-21", "--like", "unknown word 'size-21'", "size-20"}, folder);
    check_refused("init", {"a.toml --like ''", "--like", "", "size-20"}, folder);
}

TEST_CASE("init writes ready drives that solve without a note and carry their torque", "[cli][design]")
{
    TemporaryFolder folder;
    for (std::string const size : {"size-20"}) {
        auto const made = hdconj_run("init " + size + ".toml --like " + size, folder.path());
        INFO(made.err);
        REQUIRE(made.status == 0);
        auto const solved = hdconj_run("solve " + size + ".toml --strict", folder.path());
        INFO(solved.err);
        CHECK(solved.status == 0);
        CHECK(solved.out.find("judgement") == std::string::npos);
        CHECK(solved.out.find(size + ":") != std::string::npos);
        auto const loaded =
            hdconj_run("load " + size + ".toml --no-curve --no-errors --set slices.count=3 --set bearing.circles=5",
                       folder.path());
        INFO(loaded.err);
        CHECK(loaded.status == 0);
    }
}

TEST_CASE("the command in the second line of a scene makes that scene again", "[cli][design]")
{
    TemporaryFolder folder;
    for (std::string const wishes :
         {"--ratio 90 --diameter 45 --material 42CrMo4 --fatigue 512.5",
          "--ratio 80 --module 0.24 --length-ratio 0.3 --family involute --land 0.3 --clearance 0.01 --safety 1.1",
          "--ratio 80 --diameter 40 --material \"Bob's \\$HOME * Ti\" --fatigue 450 --youngs-modulus 114000 "
          "--poissons-ratio 0.34"}) {
        REQUIRE(hdconj_run("design " + wishes + " -o a.toml -q --force", folder.path()).status == 0);
        std::string const text = content(folder / "a.toml"), begin = "# hdconj ";
        std::size_t const at = text.find('\n') + 1;
        REQUIRE(text.compare(at, begin.size(), begin) == 0);
        std::size_t const from = at + begin.size();
        std::string const command = text.substr(from, text.find('\n', from) - from);
        INFO(command);
        REQUIRE(hdconj_run(command + " -o a.toml -q --force", folder.path()).status == 0);
        CHECK(content(folder / "a.toml") == text);
    }
}

TEST_CASE("design writes a scene that check, contact and load take", "[cli][design]")
{
    TemporaryFolder folder;
    auto const made =
        hdconj_run("design --ratio 100 --diameter 50 --length-ratio 0.25 --torque 28 -o d.toml --json", folder.path());
    INFO(made.err);
    REQUIRE(made.status == 0);
    CHECK(made.out.find("\"stress_loaded_MPa\"") != std::string::npos);
    for (std::string const verb :
         {"check d.toml --strict", "solve d.toml --strict", "contact d.toml", "load d.toml --no-curve --no-errors"}) {
        auto const taken = hdconj_run(verb, folder.path());
        INFO(verb << "\n" << taken.err);
        CHECK(taken.status == 0);
    }
}

}  // namespace hdconj::test::bad_design_cases
