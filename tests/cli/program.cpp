// SPDX-License-Identifier: GPL-3.0-or-later
// The program from outside: exit status, what goes to standard output, what to standard error.
#include <sys/stat.h>
#include <unistd.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "hdconj/read_scene.hpp"
#include "hdconj_run.hpp"
#include "support/catch.hpp"
#include "support/not_tried.hpp"

namespace hdconj::test::program_cases {

namespace {

using test::hdconj_run;
using test::Outcome;
using test::TemporaryFolder;

constexpr int done = 0;
constexpr int failed = 1;
constexpr int refused = 2;

/// Bad input: status 2, nothing on standard output, and a message with @p part.
void check_bad_input(Outcome const& outcome, std::string const& part)
{
    INFO(outcome.err);
    CHECK(outcome.status == refused);
    CHECK(outcome.out.empty());
    CHECK(contains(outcome.err, part));
}

}  // namespace

TEST_CASE("help and version go to standard output", "[program]")
{
    for (std::string const arguments : {"--help", "-h", "init --help", "check --help", "solve --help"}) {
        auto const outcome = hdconj_run(arguments);
        INFO(arguments);
        CHECK(outcome.status == done);
        CHECK(outcome.err.empty());
        CHECK(contains(outcome.out, "Usage: hdconj"));
    }
    auto const help = hdconj_run("--help").out;
    for (std::string const verb : {"init", "check", "solve"})
        CHECK(contains(help, "\n  " + verb + " "));
    CHECK(contains(help, "Examples:"));
    CHECK(contains(hdconj_run("check --help").out, "double-circular-arc"));
    CHECK(contains(hdconj_run("--version").out, "hdconj "));
    CHECK(hdconj_run("--version").status == done);
    CHECK(hdconj_run("version").out == hdconj_run("--version").out);
    CHECK(hdconj_run("help").out == hdconj_run("--help").out);
    CHECK(hdconj_run("help solve").out == hdconj_run("solve --help").out);
    check_bad_input(hdconj_run("help slove"), "did you mean 'hdconj solve'");
    CHECK(hdconj_run("check -q").err.empty());
}

TEST_CASE("a wrong command line is refused", "[program]")
{
    check_bad_input(hdconj_run(""), "Usage:");
    check_bad_input(hdconj_run("chek"), "did you mean 'hdconj check'");
    check_bad_input(hdconj_run("slove drive.toml"), "did you mean 'hdconj solve'");
    check_bad_input(hdconj_run("drive.toml"), "after the verb");
    check_bad_input(hdconj_run("check --bogus"), "--bogus");
    check_bad_input(hdconj_run("check a.toml b.toml"), "b.toml");
    check_bad_input(hdconj_run("check a.toml solve"), "write hdconj solve as a command of its own");
    check_bad_input(hdconj_run("contact --tilt 0.1 0.2 a.toml"),
                    "'0.2' was taken for it. A list is one word with commas");
    check_bad_input(hdconj_run("check --set"), "--set");
    check_bad_input(hdconj_run("check --threads -3"), "--threads");
    check_bad_input(hdconj_run("check --threads many"), "--threads");
    check_bad_input(hdconj_run("--bogus"), "--bogus");
    check_bad_input(hdconj_run("solve --pictur a.svg"), "Did you mean --picture?");
    check_bad_input(hdconj_run("solve --qiet"), "Did you mean --quiet?");
    check_bad_input(hdconj_run("contact --tlit=0.1"), "Did you mean --tilt?");
    check_bad_input(hdconj_run("solve --tolerence 1e-7"), "--set solver.tolerance=VALUE");
    check_bad_input(hdconj_run("check --for load --treads 1"), "Did you mean --threads?");
    check_bad_input(hdconj_run("check --set wedm.dialects=xyz"), "no dialect is called so");
    std::string const given = HDCONJ_SOURCE_DIR "/data/scenes/circular-spline-given.toml";
    check_bad_input(hdconj_run("check --for contact " + given), "contact needs the flexspline's tooth");
    check_bad_input(hdconj_run("check --for load " HDCONJ_SOURCE_DIR "/data/scenes/s-tooth.toml"),
                    "a load needs the cup's dimensions");
    check_bad_input(hdconj_run("--versoin"), "Did you mean --version?");
    auto const unknown = hdconj_run("check a.toml --bogus b.toml");  // the value of an unknown option
    check_bad_input(unknown, "The following was not expected: --bogus b.toml\n");
    CHECK_FALSE(contains(unknown.err, "One scene is read"));
    CHECK_FALSE(contains(hdconj_run("check --bogus").err, "Did you mean"));
}

TEST_CASE("wrong values of several options are told at once", "[program]")
{
    auto const said = hdconj_run("load --points 0 --torque -1 --threads 1 --surface foo --json");
    CHECK(said.status == refused);
    for (auto const* const told : {"--points: '0' is no whole number from 1 to 1000\n", "--torque: '-1' is not above 0",
                                   "--surface: unknown word 'foo'", "Run with --help"})
        CHECK(contains(said.err, told));
    CHECK_FALSE(contains(said.err, "--threads"));
    CHECK(nlohmann::json::parse(said.out)["faults"].size() == 3);
}

TEST_CASE("faults of the scene, of options and of outputs are told at once", "[program]")
{
    for (auto const* const verb : {"solve", "contact", "load", "run"}) {
        CAPTURE(verb);
        auto const said = hdconj_run(std::string(verb) + " --set drive.module=-1 -o - --picture a.txt");
        CHECK(said.status == refused);
        for (auto const* const told : {"hdconj: 3 faults\n", "drive.module = -1", "--output = -", "--picture = a"})
            CHECK(contains(said.err, told));
    }
    auto const said = hdconj_run("contact --ring -o nowhere/x.h5");
    CHECK(said.status == refused);  // a folder that does not exist is told where nothing else is wrong
    CHECK(contains(said.err, "hdconj: 1 fault\n--ring"));
    CHECK(hdconj_run("contact -o nowhere/x.h5").status == failed);
}

TEST_CASE("the scene may stand behind a list, and an option of lists be given twice", "[program]")
{
    TemporaryFolder const folder;
    CHECK(hdconj_run("init drive.toml", folder.path()).status == done);
    auto const given =
        hdconj_run("contact --surface tilted --surface ruled,per-slice drive.toml --json", folder.path());
    CHECK(given.status == done);
    CHECK(nlohmann::json::parse(given.out)["contact"]["cases"].size() == 3);
    CHECK(hdconj_run("wedm --dialect dxf drive.toml --quiet", folder.path()).status == done);
}

TEST_CASE("a scene may have the name of a verb", "[program]")
{
    TemporaryFolder const folder;
    CHECK(hdconj_run("init solve", folder.path()).status == done);
    CHECK(contains(hdconj_run("check solve", folder.path()).out, "will be computed"));
}

TEST_CASE("init writes the built-in scene and never over a file", "[program]")
{
    TemporaryFolder const folder;
    auto const first = hdconj_run("init", folder.path());
    CHECK(first.status == done);
    CHECK(first.out.empty());
    CHECK(contains(first.err, "hdconj.toml"));
    CHECK(test::content(folder / "hdconj.toml") == builtin_scene_text());

    write(folder / "hdconj.toml", "mine");
    check_bad_input(hdconj_run("init", folder.path()), "--force");
    CHECK(test::content(folder / "hdconj.toml") == "mine");
    CHECK(hdconj_run("init --force --quiet", folder.path()).err.empty());
    CHECK(test::content(folder / "hdconj.toml") == builtin_scene_text());

    CHECK(hdconj_run("init -").out == builtin_scene_text());
    check_bad_input(hdconj_run("init .", folder.path()), "folder");
    CHECK(hdconj_run("init no/such/folder.toml", folder.path()).status == failed);
}

TEST_CASE("check prints the plan of a right scene", "[program]")
{
    TemporaryFolder const folder;
    CHECK(hdconj_run("init drive.toml", folder.path()).status == done);
    auto const built_in = hdconj_run("check");
    auto const file = hdconj_run("check drive.toml", folder.path());
    auto const piped = test::run("'" HDCONJ_PROGRAM "' init - | '" HDCONJ_PROGRAM "' check -");
    CHECK(built_in.status == done);
    CHECK(built_in.err.empty());
    CHECK(contains(built_in.out, "type-50"));
    CHECK(contains(built_in.out, "envelope"));
    CHECK(file.out == built_in.out);
    CHECK(piped.out == built_in.out);
    auto const plan = hdconj_run("check --plan").out;
    CHECK_FALSE(contains(plan, "type-50"));
    CHECK(contains(built_in.out, plan));
    CHECK(hdconj_run("check --quiet").out.empty());
    CHECK(contains(hdconj_run("check --set circular_spline.backlash_offset=0.02").out, "backlash_offset = 0.02 mm"));
}

TEST_CASE("check --json is one JSON object, also for a bad scene", "[program]")
{
    auto const good = nlohmann::json::parse(hdconj_run("check --json").out);
    CHECK(good["faults"].empty());
    CHECK(good["stages"].size() == 7);
    auto const outcome = hdconj_run("check --json --set flexspline.wall=-1 --set drive.modul=1");
    CHECK(outcome.status == refused);
    auto const bad = nlohmann::json::parse(outcome.out);
    CHECK(bad["faults"].size() == 2);
    CHECK_FALSE(bad.contains("stages"));
}

TEST_CASE("every verb with --json prints one object when it fails too", "[program]")
{
    for (char const* verb : {"solve", "contact", "load", "wedm", "accuracy"}) {
        INFO(verb);
        auto const outcome = hdconj_run(std::string(verb) + " --json --set flexspline.wall=-1");
        CHECK(outcome.status == refused);
        auto const bad = nlohmann::json::parse(outcome.out);
        CHECK(bad["scene"] == "the built-in scene");
        CHECK(bad["faults"][0]["path"] == "flexspline.wall");
    }
    auto const outcome = hdconj_run("solve --json --set wave_generator.radial_deformation=0.15");
    CHECK(outcome.status == failed);
    auto const bad = nlohmann::json::parse(outcome.out);
    CHECK(bad["error"]["code"] == "no-land");
    for (char const* key : {"stage", "place", "cause", "remedy"})
        CHECK_FALSE(bad["error"][key].get<std::string>().empty());
}

TEST_CASE("files that are no scene are refused", "[program]")
{
    TemporaryFolder const folder;
    write(folder / "empty.toml", "");
    write(folder / "binary.toml", std::string("\x7f"
                                              "ELF\0\0\0",
                                              7));
    write(folder / "huge.toml", std::string(std::size_t{17} << 20, ' '));
    check_bad_input(hdconj_run("check .", folder.path()), "folder");
    check_bad_input(hdconj_run("check missing.toml", folder.path()), "no such file");
    check_bad_input(hdconj_run("check empty.toml", folder.path()), "empty");
    check_bad_input(hdconj_run("check binary.toml", folder.path()), "binary");
    check_bad_input(hdconj_run("check huge.toml", folder.path()), "16 MiB");
    check_bad_input(hdconj_run("check /dev/zero"), "16 MiB");
    check_bad_input(hdconj_run("check - </dev/null"), "empty");
    check_bad_input(hdconj_run("check - </dev/zero"), "16 MiB");
    check_bad_input(hdconj_run("check ''"), "");
}

TEST_CASE("a file without read permission is refused", "[program]")
{
    TemporaryFolder const folder;
    write(folder / "secret.toml", std::string(builtin_scene_text()));
    ::chmod(folder.path().c_str(), 0755);
    ::chmod((folder / "secret.toml").c_str(), 0);
    // Root may read everything: then the program runs as nobody, where that can be done.
    std::string const as_nobody = "setpriv --reuid=65534 --regid=65534 --clear-groups ";
    std::string const who = ::geteuid() == 0 ? as_nobody : "";
    if (test::run(who + "test -x '" HDCONJ_PROGRAM "'").status != 0) {
        not_tried("this user may read everything");
        return;
    }
    check_bad_input(test::run(who + "'" HDCONJ_PROGRAM "' check secret.toml", folder.path()), "no permission");
}

TEST_CASE("faults name file, line, key and remedy on standard error", "[program]")
{
    TemporaryFolder const folder;
    write(folder / "drive.toml", "[drive]\nmodule = \"0.25\"\n");
    auto const outcome = hdconj_run("check drive.toml", folder.path());
    check_bad_input(outcome, "drive.toml");
    CHECK(contains(outcome.err, "line 2: drive.module = \"0.25\": "));
    CHECK(contains(outcome.err, "(write 0.25, a number without quotes)"));
    CHECK(contains(outcome.err, "6 faults"));
}

TEST_CASE("an elastic cup without its dimensions or its bearing is refused", "[program]")
{
    TemporaryFolder const folder;
    auto const outcome =
        hdconj_run("solve --set coning.model=elastic --set '!flexspline.cup' --set '!bearing'", folder.path());
    check_bad_input(outcome, "needs the cup's dimensions");
    CHECK(contains(outcome.err, "needs what pushes the cup outward"));
    CHECK(contains(outcome.err, "coning.bottom_to_middle"));
    CHECK(folder.names().empty());
}

TEST_CASE("check draws the plan of either verb", "[program]")
{
    std::string const cone = "--set coning.model=linear --set coning.bottom_to_middle=9 ";
    auto const solve = hdconj_run("check --plan " + cone);
    CHECK_FALSE(contains(solve.out, "gap_map"));
    CHECK(contains(solve.out, "coning of the surface"));
    auto const contact = hdconj_run("check --plan --for contact " + cone);
    CHECK(contains(contact.out, "coning.model = \"linear\""));
    CHECK(contains(contact.out, "gap_map"));
    // a scene with a table [contact] is meant for that verb
    CHECK(contains(hdconj_run("check --plan --set contact.contact_gap=0.002").out, "gap_map"));
}

TEST_CASE("standard output that is closed, full or gone", "[program]")
{
    CHECK(hdconj_run("check >/dev/full").status == failed);
    CHECK(contains(hdconj_run("check >/dev/full").err, "disk full"));
    auto const piped = test::run("( '" HDCONJ_PROGRAM "' check; echo $? >&2 ) | true");
    CHECK(piped.err == "0\n");
    CHECK(hdconj_run("check >&-").status == failed);
}

}  // namespace hdconj::test::program_cases
