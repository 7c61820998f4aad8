// SPDX-License-Identifier: GPL-3.0-or-later
// What holds for every verb that writes a result: its files, its streams, what a failure leaves, and any number of
// threads.
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "hdconj_run.hpp"
#include "support/catch.hpp"
#include "support/json_keys.hpp"
#include "support/read_hdf5.hpp"

namespace hdconj::test::every_verb_cases {

using nlohmann::json;

namespace {

/// Options that a verb cannot follow, how it ends then, and what it says.
struct Failure
{
    std::string options;
    int status;
    std::string said;
};

/// A verb whose result is an HDF5 file, with scene and options that make it quick: what is looked at here does not
/// depend on them.
struct Verb
{
    std::string name;
    std::string quick;
    std::vector<Failure> failures;

    [[nodiscard]] Outcome operator()(std::string const& arguments, TemporaryFolder const& folder) const
    {
        return hdconj_run(name + " " + quick + arguments, folder.path());
    }
};

std::string const coned =
    "'" HDCONJ_SOURCE_DIR "/data/scenes/type-50-coned.toml' --set slices.count=3 --set contact.flank_points=40 ";

std::vector<Verb> const& verbs()
{
    static std::vector<Verb> const table{
        {"solve", "", {{"--set flexspline.wall=-1 ", 2, "flexspline.wall"}}},
        {"contact", coned, {{"--tilt 50 ", 2, "--tilt = 50"}, {"--tilt 20 ", 1, "hdconj: slices: "}}},
        {"load", "--set slices.count=3 --no-curve ", {{"--torque=-1 ", 2, "--torque"}}},
        {"run", "--set slices.count=1 --no-errors --positions 4 ", {{"--torque=-1 ", 2, "--torque"}}},
    };
    return table;
}

/// A run with as many results as are compared, and those of its datasets that everything before goes into.
struct ThreadedRun
{
    std::string verb;
    std::string arguments;
    std::vector<char const*> datasets;
};

std::vector<ThreadedRun> const& threaded_runs()
{
    static std::vector<ThreadedRun> const table{
        {"contact",
         coned + "--surface tilted,ruled,per-slice --tilt 0,0.1 --revolution 3 ",
         {"/contact/map/gap", "/contact/contact_fraction", "/contact/turn_to_contact", "/contact/least_side_clearance",
          "/contact/flank_where", "/circular_spline/outline", "/circular_spline/z"}},
        {"load",
         "--set slices.count=3 --points 2 ",
         {"/load/case_000/curve/twist", "/load/case_000/map/force", "/load/case_000/map/gap", "/load/shape/u_r",
          "/load/cup/w_major"}},
        {"run",
         "--set slices.count=3 --positions 4 --set friction.flanks=0.1 --set friction.seal=0.01 ",
         {"/running/sequence_000/error", "/running/sequence_001/error", "/running/sequence_001/wave_generator_torque",
          "/running/sequence_001/spectrum/amplitude", "/running/losses/efficiency"}},
    };
    return table;
}

/// A run that is asked for every file it can write; the pictures only where there is a gnuplot.
struct FullRun
{
    std::string verb;
    std::string arguments;
    std::vector<std::string> pictures;
    std::size_t others;  ///< files that are no pictures
};

std::vector<FullRun> const& full_runs()
{
    static std::vector<FullRun> const table{
        {"contact",
         coned + "--tilt 0,0.1 --xdmf a.xdmf --stl a.stl --vtk a.vtk ",
         {"a-tilt.svg", "a-map.svg", "a-flank.svg"},
         4},
        {"load",
         "--set slices.count=3 --points 2 --vtu a.vtu ",
         {"a-curve.svg", "a-stiffness.svg", "a-pressure.svg", "a-flank.svg", "a-cup.svg", "a-stress.svg"},
         2},
        {"run",
         "--set slices.count=1 --no-errors --positions 4 --set friction.flanks=0.1 ",
         {"a-error.svg", "a-spectrum.svg", "a-efficiency.svg"},
         1},
    };
    return table;
}

/// What the part of a verb is called in its summary.
char const* part_of(std::string const& verb)
{
    return verb == "run" ? "running" : verb.c_str();
}

}  // namespace

TEST_CASE("every verb: --json prints one object and keeps the talk apart, --quiet prints nothing", "[program]")
{
    for (auto const& verb : verbs()) {
        INFO(verb.name);
        TemporaryFolder const folder;
        auto const summary = verb("--json -o a.h5", folder);
        REQUIRE(summary.status == 0);
        CHECK(json::parse(summary.out).at("files").at("hdf5").at("path") == "a.h5");
        CHECK(summary.err == "wrote a.h5\n");
        auto const quiet = verb("--quiet -o a.h5", folder);
        CHECK(quiet.status == 0);
        CHECK(quiet.out + quiet.err == "");
        auto const both = verb("--quiet --json -o a.h5", folder);
        CHECK(json::parse(both.out).at("format") == "hdconj-summary");
        CHECK(both.err.empty());
        CHECK(folder.names() == std::vector<std::string>{"a.h5"});
    }
}

TEST_CASE("every verb: a failure leaves the result that is there", "[program]")
{
    for (auto const& verb : verbs()) {
        INFO(verb.name);
        TemporaryFolder const folder;
        REQUIRE(verb("--quiet -o a.h5", folder).status == 0);
        auto const before = content(folder / "a.h5");
        for (auto const& [options, status, said] : verb.failures) {
            auto const failed = verb(options + "-o a.h5", folder);
            INFO(options << "\n" << failed.err);
            CHECK(failed.status == status);
            CHECK_THAT(failed.err, ContainsSubstring(said));
            CHECK(failed.out.empty());
        }
        auto const limited =
            run("ulimit -f 8 && " + program + " " + verb.name + " " + verb.quick + "-o a.h5", folder.path());
        CHECK(limited.status == 1);
        CHECK_THAT(limited.err, ContainsSubstring("ulimit -f"));
        CHECK(content(folder / "a.h5") == before);
        CHECK(folder.names() == std::vector<std::string>{"a.h5"});
    }
}

TEST_CASE("every verb: a missing gnuplot is told before the work", "[program]")
{
    for (std::string const verb : {"solve", "contact", "load", "run", "wedm"}) {
        INFO(verb);
        TemporaryFolder const folder;
        auto const failed = run("PATH=/nowhere && " + program + " " + verb + " -o out --picture a.svg", folder.path());
        CHECK(failed.status == 1);
        CHECK_THAT(failed.err, ContainsSubstring("gnuplot-nox"));
        CHECK(folder.names().empty());
    }
}

TEST_CASE("every verb: the number of threads changes no bit of any figure", "[program]")
{
    for (auto const& each : threaded_runs()) {
        INFO(each.verb);
        TemporaryFolder const folder;
        std::string const arguments = each.verb + " " + each.arguments + "--quiet --json --set solver.threads=1 -o ";
        auto const one = hdconj_run(arguments + "one.h5 --threads 1", folder.path());
        auto const two = hdconj_run(arguments + "two.h5 --threads 2", folder.path());
        REQUIRE(one.status == 0);
        REQUIRE(two.status == 0);
        char const* const part = part_of(each.verb);
        CHECK(without_times(json::parse(one.out), part).dump() == without_times(json::parse(two.out), part).dump());
        auto const a = open_file(folder / "one.h5"), b = open_file(folder / "two.h5");
        for (char const* name : each.datasets) {
            INFO(name);
            CHECK(read(a, name).values == read(b, name).values);
        }
    }
}

TEST_CASE("every verb writes every file asked for and names it", "[program]")
{
    bool const draws = !is_missing("gnuplot");
    for (auto const& each : full_runs()) {
        TemporaryFolder const folder;
        auto const done = hdconj_run(
            each.verb + " " + each.arguments + "-o a.h5 --json" + (draws ? " --picture a.svg" : ""), folder.path());
        INFO(each.verb << "\n" << done.err);
        REQUIRE(done.status == 0);
        std::vector<std::string> named;
        json const files = json::parse(done.out).at("files");
        for (auto const& file : files)
            named.push_back(file.at("path"));
        std::sort(named.begin(), named.end());
        auto written = folder.names();
        std::sort(written.begin(), written.end());
        CHECK(written == named);
        CHECK(named.size() == each.others + (draws ? each.pictures.size() : 0));
        for (auto const& name : written) {
            INFO(name);
            if (name.ends_with(".stl")) {
                CHECK(std::filesystem::file_size(folder / name) > 1000);
            } else if (name.ends_with(".svg")) {
                CHECK(std::find(each.pictures.begin(), each.pictures.end(), name) != each.pictures.end());
                CHECK_THAT(content(folder / name), ContainsSubstring("</svg>"));
            } else if (name.ends_with(".xdmf")) {
                CHECK_THAT(content(folder / name), ContainsSubstring("a.h5:/circular_spline"));
            } else if (name.ends_with(".vtk")) {
                CHECK_THAT(content(folder / name), ContainsSubstring("gap"));
            } else if (name.ends_with(".vtu")) {
                CHECK_THAT(content(folder / name), ContainsSubstring("displacement") && ContainsSubstring("von_mises"));
            }
        }
    }
}

TEST_CASE("run says where an efficiency is not determined", "[program]")
{
    TemporaryFolder const folder;
    std::string const arguments =
        "run --set slices.count=1 --no-errors --positions 4 --torque 5 --set friction.flanks=0.1 -o a.h5 ";
    auto const text = hdconj_run(arguments, folder.path()).out;
    CHECK_THAT(text, ContainsSubstring("efficiency -: not determined") && !ContainsSubstring("nan"));
    auto const rows = json::parse(hdconj_run(arguments + "--json", folder.path()).out).at("running").at("losses");
    CHECK(rows.at("efficiency").at(0).at("torque_Nm") == 0);
    CHECK(rows.at("efficiency").at(0).at("efficiency").is_null());
    CHECK(rows.at("efficiency").at(1).at("efficiency") < 1);
    auto const stored = read(open_file(folder / "a.h5"), "/running/losses/efficiency").values;
    CHECK(std::isnan(stored.at(0)));
    CHECK(stored.at(1) < 1);
}

}  // namespace hdconj::test::every_verb_cases
