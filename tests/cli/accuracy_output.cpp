// SPDX-License-Identifier: GPL-3.0-or-later
// `hdconj accuracy` as a user meets it: folder, streams, exit statuses, stored records, advice.
#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "hdconj/units.hpp"
#include "hdconj_run.hpp"
#include "support/catch.hpp"

namespace hdconj::test::accuracy_output_cases {

using hdconj::test::content;
using hdconj::test::is_missing;
using hdconj::test::Outcome;
using hdconj::test::TemporaryFolder;
using nlohmann::json;

namespace {

std::string const quick = "--quick --sample 0 --study tolerance,number-type ";

Outcome accuracy(std::string const& arguments, TemporaryFolder const& folder)
{
    return hdconj::test::hdconj_run("accuracy " + arguments, folder.path());
}

}  // namespace

TEST_CASE("accuracy writes a folder of records and pictures, and prints tables", "[accuracy]")
{
    TemporaryFolder const folder;
    auto const done = accuracy(quick + "--budget 10s --error 1um", folder);
    CHECK(done.status == 0);
    CHECK_THAT(done.out, ContainsSubstring("tolerance:") && ContainsSubstring("order 1.0") &&
                             ContainsSubstring("--set solver.tolerance=") && ContainsSubstring("reference: 50 digits"));
    CHECK_THAT(done.err, ContainsSubstring("wrote type-50-accuracy/records.h5"));
    CHECK(folder.names() == std::vector<std::string>{"type-50-accuracy"});
    std::istringstream csv(content(folder.path() / "type-50-accuracy/records.csv"));
    std::string line;
    std::getline(csv, line);
    CHECK(line.starts_with("study,drive,method,knob,unit,value,repeat,error,hausdorff,estimate,normal_speed,"));
    CHECK(line.ends_with("version,revision,compiler_and_flags,libraries,residual"));
    auto const columns = std::count(line.begin(), line.end(), ',');
    int rows = 0;
    while (std::getline(csv, line)) {
        bool quoted = false;
        auto found = columns - columns;
        for (char const c : line) {
            quoted = quoted != (c == '"');
            found += c == ',' && !quoted;
        }
        CHECK(found == columns);
        ++rows;
    }
    CHECK(rows == 4 + 4);  // tolerances 1e-3 ... 1e-6; three number types and the program
    if (!is_missing("gnuplot"))
        CHECK_THAT(content(folder.path() / "type-50-accuracy/tolerance.svg"), ContainsSubstring("<svg"));
    // once more into the same folder: exchanged; into one that holds something else: refused
    CHECK(accuracy(quick + "--quiet", folder).status == 0);
    std::ofstream(folder.path() / "type-50-accuracy/mine.txt") << "mine\n";
    auto const refused = accuracy(quick, folder);
    CHECK(refused.status == 1);
    CHECK_THAT(refused.err, ContainsSubstring("mine.txt"));
    CHECK(content(folder.path() / "type-50-accuracy/mine.txt") == "mine\n");
}

TEST_CASE("accuracy: a folder with the study of another drive is not replaced", "[accuracy]")
{
    TemporaryFolder const folder;
    std::string const fast = "--quick --sample 0 --study number-type --quiet -o study";
    REQUIRE(accuracy(fast, folder).status == 0);
    std::string const before = content(folder.path() / "study/records.h5");
    std::string const copy = "--set drive.name=another";
    auto const refused = accuracy(fast + " " + copy, folder);
    CHECK(refused.status == 1);
    CHECK_THAT(refused.err, ContainsSubstring("study of another drive, \"type-50\"") &&
                                ContainsSubstring("the name of a new folder"));
    CHECK(content(folder.path() / "study/records.h5") == before);
    REQUIRE(accuracy("--quick --sample 0 --study number-type --quiet -o other " + copy, folder).status == 0);
    CHECK(accuracy("--from other/records.h5 --quiet -o study", folder).status == 1);
    CHECK(content(folder.path() / "study/records.h5") == before);
    CHECK(accuracy("--from study/records.h5 --quiet -o study", folder).status == 0);
}

TEST_CASE("accuracy: stored records give the same figures, a page and advice", "[accuracy]")
{
    TemporaryFolder const folder;
    auto const measured = accuracy("--quick --sample 0 --study tolerance,number-type,threads --json -o a", folder);
    REQUIRE(measured.status == 0);
    json const first = json::parse(measured.out);
    CHECK(first.at("format") == "hdconj-accuracy");
    CHECK(first.at("reference_error_mm").get<double>() < 1e-14);
    auto const again = accuracy("--from a/records.h5 --json --page page.md --error 1e-5 --budget 1us", folder);
    REQUIRE(again.status == 0);
    json const second = json::parse(again.out);
    CHECK(second.at("convergence_series") == first.at("convergence_series"));
    // or a finer one, which a busy machine may have measured to be the faster
    CHECK_THAT(second.at("for_error").at("set").get<std::string>(), ContainsSubstring("solver.tolerance=1e-0"));
    CHECK(second.at("for_error").at("target_met") == true);
    CHECK(second.at("for_budget").at("target_met") == false);
    std::string const page = content(folder.path() / "page.md");
    CHECK_THAT(page, ContainsSubstring("# What accuracy costs in time") &&
                         ContainsSubstring("| 1e-05 | `solver.tolerance = 1e-0"));
    // every picture that the page shows is there
    for (auto at = page.find("](figures/"); at != std::string::npos; at = page.find("](figures/", at + 1)) {
        auto const name = page.substr(at + 2, page.find(')', at) - at - 2);
        if (!is_missing("gnuplot"))
            CHECK(std::filesystem::exists(folder.path() / name));
    }
    // another page in the same folder has pictures of its own
    REQUIRE(accuracy("--from a/records.h5 --quiet --page 'a second.md'", folder).status == 0);
    if (!is_missing("gnuplot")) {
        CHECK_THAT(content(folder.path() / "a second.md"), ContainsSubstring("](<figures/a second-tolerance.svg>)"));
        CHECK(std::filesystem::exists(folder.path() / "figures/a second-tolerance.svg"));
        CHECK(std::filesystem::exists(folder.path() / "figures/page-tolerance.svg"));
        // time on threads has axes of its own
        CHECK_THAT(content(folder.path() / "figures/page-threads.svg"),
                   ContainsSubstring("dotted: time of one thread over their number"));
        CHECK_THAT(content(folder.path() / "figures/page-tolerance.svg"), !ContainsSubstring("dotted"));
    }
    // a scene where a picture would stand is not replaced
    std::filesystem::copy_file(HDCONJ_SOURCE_DIR "/data/scenes/type-50.toml", folder.path() / "figures/mine-roots.svg");
    auto const refused = accuracy("figures/mine-roots.svg --page mine.md -o b", folder);
    CHECK(refused.status == 2);
    CHECK_THAT(refused.err, ContainsSubstring("mine-roots.svg too: this is the scene file"));
    CHECK(content(folder.path() / "figures/mine-roots.svg") == content(HDCONJ_SOURCE_DIR "/data/scenes/type-50.toml"));
}

TEST_CASE("accuracy: a page from stored records is that of the measuring run", "[accuracy]")
{
    std::string const scenes = "'" HDCONJ_SOURCE_DIR "/data/scenes/";
    for (std::string const& arguments :
         {scenes + "two-disc.toml' --set solver.kinematics=first-order --study tolerance",
          scenes + "circular-spline-given.toml' --study tolerance,sampling"}) {
        INFO(arguments);
        TemporaryFolder const folder;
        REQUIRE(accuracy("--quick --sample 0 --quiet -o study --page page.md " + arguments, folder).status == 0);
        std::string const measured = content(folder.path() / "page.md");
        REQUIRE(accuracy("--from study/records.h5 --quiet --page page.md", folder).status == 0);
        CHECK(content(folder.path() / "page.md") == measured);
        bool const reverse = arguments.find("given") != std::string::npos;
        CHECK_THAT(measured,
                   ContainsSubstring(reverse ? "(`cosine`) and motion model (`exact`), and of the flexspline tooth"
                                             : "(`two-disc`) and motion model (`first-order`);"));
    }
}

TEST_CASE("accuracy: drives of every kind are measured, and what a scene has no study of is said", "[accuracy]")
{
    TemporaryFolder const folder;
    struct Row
    {
        std::string arguments, note;
        std::size_t series_list;
    };
    std::string const scenes = "'" HDCONJ_SOURCE_DIR "/data/scenes/";
    int drives = 0;
    for (Row const& row : {Row{scenes + "four-roller.toml' --study tolerance,motion-model", "material left out", 3},
                           Row{scenes + "two-disc.toml' --study tolerance --set solver.kinematics=first-order", "", 1},
                           Row{scenes + "cam-table.toml' --study tolerance,threads", "", 3},
                           Row{"--study motion-model --set solver.kinematics=material", "", 3},
                           Row{"--study tolerance --set coning.model=linear --set coning.bottom_to_middle=9",
                               "[coning] left out: outlines are measured in the middle plane", 1},
                           Row{scenes + "circular-spline-given.toml'", "union: left out", 19}}) {
        INFO(row.arguments);
        auto const done =
            accuracy("--quick --sample 0 --json -o study-" + std::to_string(drives++) + " " + row.arguments, folder);
        REQUIRE(done.status == 0);
        json const report = json::parse(done.out);
        CHECK(report.at("reference_error_mm").get<double>() < 1e-14);
        CHECK_THAT(report.at("notes").dump(), ContainsSubstring(row.note));
        CHECK(report.at("convergence_series").size() == row.series_list);
        for (auto const& series : report.at("convergence_series"))
            if (series.at("study") == "tolerance")
                for (auto const& level : series.at("levels")) {
                    CHECK(level.at("error").get<double>() <= level.at("estimate").get<double>());
                    CHECK(level.at("missed") == 0);
                }
    }
    // a study along the axis needs no reference
    auto const axial = accuracy("--quick --sample 0 --study contact-area,load -o axial", folder);
    CHECK(axial.status == 0);
    CHECK_THAT(axial.out, !ContainsSubstring("50 digits by another method") && ContainsSubstring("  slices [mm^2]") &&
                              ContainsSubstring("  harmonics: twist [relative]"));
}

TEST_CASE("accuracy measures the tooth surface of the scene", "[accuracy]")
{
    TemporaryFolder const folder;
    std::string const set = " --set slices.count=3 --set slices.surface=tilted";
    auto const study = accuracy("--quick --sample 0 --study contact-area,load --json -o study" + set, folder);
    REQUIRE(study.status == 0);
    json const report = json::parse(study.out);
    std::string notes;
    for (auto const& note : report.at("notes"))
        notes += note.get<std::string>() + "\n";
    CHECK_THAT(notes, ContainsSubstring("load: tooth surface \"tilted\"\n") &&
                          ContainsSubstring("contact-area: tooth surface \"tilted\"\n"));
    // the finest grid of the study is that of a run of `load`
    auto const load = hdconj::test::hdconj_run(
        "load --no-curve --no-errors --json -o load.h5 --quiet"
        " --set load.harmonics=64 --set contact.flank_points=24"
        " --set bearing.circles=2" +
            set,
        folder.path());
    REQUIRE(load.status == 0);
    double const twist = json::parse(load.out).at("load").at("cases").at(0).at("rated").at("twist_arcmin");
    CHECK_THAT(notes, ContainsSubstring(fmt::format("whose twist is {:.3g} rad", twist * arcmin)));
}

TEST_CASE("accuracy: bad input is answered with what to write", "[accuracy]")
{
    TemporaryFolder const folder;
    struct Row
    {
        std::string arguments, answer;
    };
    for (Row const& row :
         {Row{"--study tolerence", "write tolerance"}, Row{"--budget 10", "write a number with s, ms or us"},
          Row{"--error nought", "write a number above 0"}, Row{"--error 0", "write a number above 0"},
          Row{"'" HDCONJ_SOURCE_DIR "/data/scenes/circular-spline-given.toml' --study tolerance,load",
              "needs the flexspline's tooth given"},
          Row{"'" HDCONJ_SOURCE_DIR "/data/scenes/circular-spline-given.toml' --study union",
              "leave it out, or give the flexspline's profile"},
          Row{"--set wave_generator.family=four-roller --set wave_generator.roller_angle_deg=25 --set "
              "solver.kinematics=material",
              "write \"exact\" or \"first-order\""},
          Row{"--sample -1", "--sample"},
          Row{"'" HDCONJ_SOURCE_DIR "/data/scenes/four-roller.toml' --study load", "the scene gives no flexspline.cup"},
          Row{"--set '!circular_spline.width' --study contact-area", "the scene gives no circular_spline.width"},
          Row{"--page records.csv", "write a name that ends in .md, such as records.md"},
          Row{"--from a.h5 --quick --repeats 2", "--quick, --repeats ask for it"},
          Row{"--from a.h5 --sample 2", "--sample asks for it"},
          Row{"--from a.h5 --study tolerance", "leave one of them out"},
          Row{"--from a.h5 --set drive.module=1", "leave SCENE and --set out"}}) {
        INFO(row.arguments);
        auto const refused = accuracy(row.arguments, folder);
        CHECK(refused.status == 2);
        CHECK(refused.out.empty());
        CHECK_THAT(refused.err, ContainsSubstring(row.answer));
    }
    // everything at once, the scene's faults too
    auto const all =
        accuracy("--study tolerance,foo,bar --budget 3xx --error 2yy --page a.txt --set drive.modle=3", folder);
    CHECK(all.status == 2);
    for (char const* part : {"6 faults", "drive.modle", "--study = foo", "--study = bar", "--budget = 3xx",
                             "--error = 2yy", "--page = a.txt"})
        CHECK_THAT(all.err, ContainsSubstring(part));
    auto const missing = accuracy("--from nothing.h5 --budget 3xx", folder);
    CHECK(missing.status == 2);
    CHECK_THAT(missing.err, ContainsSubstring("nothing.h5: is no file of records of a study: there is no such file") &&
                                ContainsSubstring("hdconj accuracy -o DIR") && ContainsSubstring("--budget = 3xx"));
    CHECK(folder.names().empty());
    // what is there but no records, and nothing of HDF5's own words
    std::filesystem::create_directory(folder.path() / "study");
    std::ofstream(folder.path() / "text.h5") << "no records\n";
    REQUIRE(hdconj::test::hdconj_run("solve --quiet -o result.h5", folder.path()).status == 0);
    std::ofstream(folder.path() / "cut.h5", std::ios::binary) << content(folder.path() / "result.h5").substr(0, 3000);
    for (Row const& row : {Row{"study", "it is a folder (write study/records.h5)"},
                           Row{"text.h5", "it is no HDF5 file"}, Row{"result.h5", "it is of another program or verb"},
                           Row{"cut.h5", "cut.h5: is no file of records of a study"}}) {
        INFO(row.arguments);
        auto const refused = accuracy("--from " + row.arguments, folder);
        CHECK(refused.status == 2);
        CHECK_THAT(refused.err,
                   ContainsSubstring(row.answer) && !ContainsSubstring("HDF5 cannot") && !ContainsSubstring("errno"));
    }
    CHECK_THAT(accuracy("--help", folder).out, ContainsSubstring("without coning, tilt and slices") &&
                                                   ContainsSubstring("polynomial-fit") &&
                                                   ContainsSubstring("Examples:"));
}

}  // namespace hdconj::test::accuracy_output_cases
