// SPDX-License-Identifier: GPL-3.0-or-later
// No verb replaces a file that it reads: the scene's points and cam tables, by any name, as a result or as one of
// several that stand for one option.
#include <filesystem>
#include <fstream>

#include "hdconj_run.hpp"
#include "support/catch.hpp"

namespace hdconj::test::own_inputs_cases {

namespace {

namespace fs = std::filesystem;
using hdconj::test::content;
using hdconj::test::hdconj_run;
using hdconj::test::TemporaryFolder;

std::string const scenes = HDCONJ_SOURCE_DIR "/data/scenes/";
std::string const by_table =
    " --set wave_generator.family=table --set wave_generator.file=in/cam.csv --set "
    "'!wave_generator.radial_deformation' ";

/// in/cam.csv, and links to it by the names of other results.
void prepare(TemporaryFolder const& folder)
{
    fs::create_directory(folder / "in");
    fs::copy_file(scenes + "cam-table.csv", folder / "in/cam.csv");
    fs::copy_file(scenes + "type-50-elastic.toml", folder / "elastic.toml");
    for (std::string const name :
         {"link.csv", "link.svg", "p-map.svg", "q-cup.svg", "r-ring.svg", "ring.xdmf.h5", "link.md"}) {
        fs::create_symlink("in/cam.csv", folder / name);
    }
    fs::create_directory_symlink("in", folder / "other");
}

struct Attempt
{
    std::string verb, arguments, place;
};

std::vector<Attempt> const& attempts()
{
    static std::vector<Attempt> const table{
        {"solve", "-o in/cam.csv", "--output = in/cam.csv: this file"},
        {"solve", "-o ./in/../in/cam.csv", "--output"},
        {"solve", "-o link.csv", "--output = link.csv: this file"},
        {"solve", "-o other/cam.csv", "--output"},
        {"solve", "--dxf in/cam.csv", "--dxf"},
        {"solve", "--picture link.svg", "--picture"},
        {"contact", "-o in/cam.csv", "--output"},
        {"contact", "--stl in/cam.csv", "--stl"},
        {"contact", "--vtk link.csv", "--vtk"},
        {"contact", "--xdmf in/cam.csv", "--xdmf"},
        {"contact", "--xdmf ring.xdmf --ring", "--xdmf = ring.xdmf: writes ring.xdmf.h5 too"},
        {"contact", "--picture p.svg", "--picture = p.svg: writes p-map.svg too"},
        {"load", "-o in/cam.csv", "--output"},
        {"load", "--vtu in/cam.csv", "--vtu"},
        {"load", "--picture q.svg", "--picture = q.svg: writes q-cup.svg too"},
        {"wedm", "-o in", "--output = in: holds in/cam.csv"},
        {"wedm", "-o other", "--output = other: holds in/cam.csv"},
        {"wedm", "-o cut --picture r.svg", "--picture = r.svg: writes r-ring.svg too"},
        {"accuracy", "-o in", "--output = in: holds in/cam.csv"},
        {"accuracy", "--page link.md", "--page = link.md: this file"},
        {"export elastic.toml", "--calculix in", "--calculix = in: holds"},
        {"export elastic.toml", "--vtu in/cam.csv", "--vtu"},
    };
    return table;
}

void check_refused(std::string const& command, std::string const& place, std::string const& read_by,
                   TemporaryFolder const& folder, fs::path const& input)
{
    auto const bytes = content(input);
    auto const before = folder.names();
    auto const refused = hdconj_run(command, folder.path());
    INFO(command << "\n" << refused.err);
    CHECK(refused.status == 2);
    CHECK_THAT(refused.err, ContainsSubstring(place) && ContainsSubstring("this file is read by " + read_by) &&
                                ContainsSubstring("would replace it"));
    CHECK(refused.out.empty());
    CHECK(content(input) == bytes);
    CHECK(folder.names() == before);
}

}  // namespace

TEST_CASE("no verb replaces the cam table that its scene names", "[program][inputs]")
{
    TemporaryFolder const folder;
    prepare(folder);
    for (auto const& [verb, arguments, place] : attempts())
        check_refused(verb + by_table + arguments, place, "wave_generator.file", folder, folder / "in/cam.csv");
}

TEST_CASE("no verb replaces the points that a scene in another folder names", "[program][inputs]")
{
    TemporaryFolder const folder;
    fs::create_directory(folder / "scene");
    fs::copy_file(scenes + "points.toml", folder / "scene/points.toml");
    fs::copy_file(scenes + "points-flank.csv", folder / "scene/points-flank.csv");
    for (std::string const option : {"-o", "--dxf"}) {
        check_refused("solve scene/points.toml " + option + " scene/points-flank.csv", "", "flexspline.profile.file",
                      folder, folder / "scene/points-flank.csv");
    }
    // the same name in another folder is another file
    CHECK(hdconj_run("solve scene/points.toml --quiet -o points-flank.csv", folder.path()).status == 0);
}

TEST_CASE("one picture's name may not be another result's", "[program][inputs]")
{
    TemporaryFolder const folder;
    auto const refused = hdconj_run("contact -o a-map.svg --picture a.svg", folder.path());
    CHECK(refused.status == 2);
    CHECK_THAT(refused.err,
               ContainsSubstring("--output = a-map.svg") && ContainsSubstring("is written by --picture too"));
    CHECK(folder.names().empty());
}

TEST_CASE("an empty name of a file is refused and never means the default", "[program][inputs]")
{
    TemporaryFolder const folder;
    fs::copy_file(scenes + "type-50-elastic.toml", folder / "elastic.toml");
    auto const before = folder.names();
    for (std::string const command : {"solve -o",
                                      "solve --output",
                                      "solve --dxf",
                                      "solve --picture",
                                      "contact -o",
                                      "contact --picture",
                                      "contact --xdmf",
                                      "contact --stl",
                                      "contact --vtk",
                                      "load -o",
                                      "load --picture",
                                      "load --vtu",
                                      "load --measured",
                                      "wedm -o",
                                      "wedm --picture",
                                      "wedm --from",
                                      "accuracy -o",
                                      "accuracy --from",
                                      "accuracy --page",
                                      "export elastic.toml --calculix",
                                      "export elastic.toml --vtu",
                                      "init"}) {
        auto const refused = hdconj_run(command + " ''", folder.path());
        INFO(command << "\n" << refused.err);
        CHECK(refused.status == 2);
        CHECK_THAT(refused.err, ContainsSubstring("an empty name") && ContainsSubstring("write a name"));
        CHECK(refused.out.empty());
        CHECK(folder.names() == before);
    }
}

TEST_CASE("an empty item of a list is refused and never left out", "[program][inputs]")
{
    TemporaryFolder const folder;
    for (std::string const command :
         {"contact --tilt 0,,0.1", "contact --tilt 0,0.1,", "contact --tilt ,0", "contact --tilt ,",
          "contact --surface tilted,", "contact --kind radial,,draft", "load --tilt 0,,0.1,", "load --surface ,tilted",
          "load --kind radial,", "wedm --dialect dxf,,csv", "accuracy --study tolerance,", "accuracy --study ,"}) {
        auto const refused = hdconj_run(command, folder.path());
        INFO(command << "\n" << refused.err);
        CHECK(refused.status == 2);
        CHECK_THAT(refused.err, ContainsSubstring("an item of '") && ContainsSubstring("is empty") &&
                                    ContainsSubstring("one comma between two items"));
        CHECK(refused.out.empty());
        CHECK(folder.names().empty());
    }
}

}  // namespace hdconj::test::own_inputs_cases
