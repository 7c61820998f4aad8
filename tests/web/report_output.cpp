// SPDX-License-Identifier: GPL-3.0-or-later
// `hdconj report` as a user meets it: what the page of a result file holds, what is refused, what --json says. The page
// itself: tests/web.
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "cli/hdconj_run.hpp"
#include "support/catch.hpp"
#include "support/read_hdf5.hpp"

namespace hdconj::test::report_output_cases {

using nlohmann::json;

namespace {

namespace fs = std::filesystem;

std::string const scenes = HDCONJ_SOURCE_DIR "/data/scenes/";
std::string const narrow = "'" + scenes + "type-50.toml' --set slices.count=3 --set circular_spline.width=2 ";

/// The data that a page holds.
json data_of(fs::path const& page)
{
    std::string const text = content(page), mark = "id=\"data\">";
    std::size_t const from = text.find(mark) + mark.size();
    return json::parse(text.substr(from, text.find("</script>", from) - from));
}

json drives_of(fs::path const& page)
{
    return data_of(page).at("drives");
}

json drive_of(fs::path const& page)
{
    return drives_of(page).at(0);
}

/// What a page says in words where scripts do not run.
std::string words_of(fs::path const& page)
{
    std::string const text = content(page);
    std::size_t const from = text.find("<noscript>");
    return text.substr(from, text.find("</noscript>") - from);
}

/// Without the times of the run, and without figures that this result has not: a page passes over them.
json without_times(json part)
{
    if (!part.is_object())
        return part;
    for (char const* const name : {"seconds", "timing", "figures"})
        part.erase(name);
    for (auto& each : part)
        each = without_times(each);
    return part;
}

struct Run
{
    std::string verb, arguments, part;
};

void change_version(fs::path const& file, int version)
{
    io::hdf5::File const opened(H5Fopen(file.c_str(), H5F_ACC_RDWR, H5P_DEFAULT), "open");
    io::hdf5::Attribute const attribute(H5Aopen(opened, "format_version", H5P_DEFAULT), "open");
    io::hdf5::checked(H5Awrite(attribute, H5T_NATIVE_INT, &version), "write");
}

}  // namespace

TEST_CASE("the page of a result file holds the numbers of the page that is computed", "[report]")
{
    TemporaryFolder const folder;
    for (Run const& each :
         {Run{"solve", narrow, "solve"}, Run{"contact", narrow + "--tilt 0,0.1 --revolution 3 ", "contact"},
          Run{"load", "--set slices.count=3 --no-curve ", "load"}}) {
        INFO(each.verb);
        REQUIRE(hdconj_run(each.verb + " " + each.arguments + "-o a.h5 -q", folder.path()).status == 0);
        auto const computed =
            hdconj_run("report " + each.arguments + "--with " + each.part + " -o computed.html", folder.path());
        REQUIRE(computed.status == 0);
        auto const read = hdconj_run("report a.h5 -o read.html", folder.path());
        REQUIRE(read.status == 0);
        json const here = drive_of(folder / "read.html"), there = drive_of(folder / "computed.html");
        json const numbers = without_times(there.at("results").at(each.part).at("groups"));
        CHECK(without_times(here.at("results").at(each.part).at("groups")) == numbers);
        CHECK(numbers.dump().size() > 10000);
        bool const is_loaded = each.verb == "load";  // the spline is that of the loaded drive then
        for (char const* const key : {"scene", "judgement", "flexspline_teeth", "name"})
            CHECK(here.at(key) == there.at(key));
        CHECK((here.at("outline_error") == there.at("outline_error")) == !is_loaded);
        CHECK(here.at("spline") == there.at(is_loaded ? "loaded_spline" : "spline"));
        CHECK((here.at("teeth") == there.at("teeth")) == !is_loaded);
        CHECK_THAT(here.at("origin").get<std::string>(), ContainsSubstring("a.h5") && ContainsSubstring("computed"));
        // without scripts every figure, all that is noted and what is not there
        std::string const words = words_of(folder / "read.html");
        json const& groups = here.at("results").at(each.part).at("groups");
        json const& group = groups.at(each.part == "solve" ? "summary" : each.part);
        REQUIRE(group.at("figures").size() > 10);
        for (json const& figure : group.at("figures"))
            CHECK_THAT(words, ContainsSubstring('\n' + figure[0].get<std::string>() + ' '));
        for (json const& note : here.at("judgement"))
            CHECK_THAT(words, ContainsSubstring(" " + note.at("code").get<std::string>() + " at "));
        for (json const& part : here.at("left_out"))
            CHECK_THAT(words, ContainsSubstring("<li>" + part.at("part").get<std::string>() + ": "));
        CHECK(there.at("origin") == "");
    }
}

TEST_CASE("the page of a running drive's file holds the numbers of the page that is computed", "[report]")
{
    TemporaryFolder const folder;
    std::string const scene = "--set slices.count=3 --set friction.flanks=0.08 --set running.positions=4 ";
    REQUIRE(hdconj_run("run " + scene + "-o a.h5 -q", folder.path()).status == 0);
    REQUIRE(hdconj_run("report " + scene + "--with run -o computed.html", folder.path()).status == 0);
    REQUIRE(hdconj_run("report a.h5 -o read.html", folder.path()).status == 0);
    json const here = drive_of(folder / "read.html"), there = drive_of(folder / "computed.html");
    json const numbers = without_times(there.at("results").at("run").at("groups"));
    CHECK(numbers.at("running").at("groups").contains("losses"));
    CHECK(numbers.at("running").at("groups").contains("sequence_001"));
    CHECK(without_times(here.at("results").at("run").at("groups")) == numbers);
    CHECK(here.at("teeth").is_object());
    std::string const words = words_of(folder / "read.html");
    for (char const* const each : {"starting_torque", "back_driving_torque", "peak_to_peak", "mean_torque"})
        CHECK_THAT(words, ContainsSubstring(std::string("\n") + each + ' '));
}

TEST_CASE("without scripts a page marks errors that are large or were not determined", "[report]")
{
    TemporaryFolder const folder;
    for (bool const errors : {true, false}) {
        INFO(errors);
        std::string const asked = errors ? "" : "--no-errors ";
        REQUIRE(hdconj_run("load --set slices.count=3 --no-curve " + asked + "-o a.h5 -q", folder.path()).status == 0);
        REQUIRE(hdconj_run("report a.h5 -o page.html", folder.path()).status == 0);
        std::string const words = words_of(folder / "page.html");
        auto const line = [&](std::string const& name) {
            std::size_t const from = words.find('\n' + name + ' ') + 1;
            return words.substr(from, words.find('\n', from) - from);
        };
        for (char const* const name : {"largest_stress", "contact_area"}) {
            INFO(line(name));
            CHECK((line(name).find("+- not determined") != std::string::npos) == !errors);
        }
        CHECK((line("contact_area").find("? mm^2") != std::string::npos) == errors);
        CHECK_THAT(words, ContainsSubstring("\n?: the error is more than a third of the figure"));
    }
}

TEST_CASE("a file that is no sound result is refused with what to do", "[report]")
{
    TemporaryFolder const folder;
    REQUIRE(hdconj_run("solve -o a.h5 -q", folder.path()).status == 0);
    fs::copy_file(folder / "a.h5", folder / "cut.h5");
    fs::resize_file(folder / "cut.h5", fs::file_size(folder / "a.h5") / 2);
    fs::copy_file(folder / "a.h5", folder / "cut");  // told by its first bytes
    fs::resize_file(folder / "cut", 1000);
    std::ofstream(folder / "text.h5") << "[drive]\n";
    for (int const version : {1, 3}) {
        fs::path const file = folder / ("version" + std::to_string(version) + ".h5");
        fs::copy_file(folder / "a.h5", file);
        change_version(file, version);
    }
    for (auto const& [name, cause] :
         {std::pair{"cut.h5", "missing or damaged"}, std::pair{"cut", "missing or damaged"},
          std::pair{"text.h5", "no HDF5 file"}, std::pair{"none.h5", "no such file"},
          std::pair{"version1.h5", "older version"}, std::pair{"version3.h5", "newer version"}}) {
        auto const done = hdconj_run(std::string("report ") + name + " -o page.html", folder.path());
        INFO(done.err);
        CHECK(done.status == 2);
        CHECK_THAT(done.err, ContainsSubstring(name) && ContainsSubstring(cause) && ContainsSubstring("-o FILE.h5"));
        CHECK_FALSE(fs::exists(folder / "page.html"));
    }
    auto const idle = hdconj_run("report a.h5 --set drive.module=0.3 --tilt 0.1 -o page.html", folder.path());
    CHECK(idle.status == 2);
    CHECK_THAT(idle.err,
               ContainsSubstring("--set") && ContainsSubstring("--tilt") && ContainsSubstring("result files"));
    auto const own = hdconj_run("report a.h5 -o a.h5", folder.path());
    CHECK(own.status == 2);
    CHECK_THAT(own.err, ContainsSubstring("would replace it"));
}

TEST_CASE("report refuses options of parts that are not asked for", "[report]")
{
    TemporaryFolder const folder;
    auto const done = hdconj_run("report --with wedm --tilt 0.2 --revolution 7 --no-curve -o page.html", folder.path());
    INFO(done.err);
    CHECK(done.status == 2);
    CHECK_THAT(done.err, ContainsSubstring("3 faults\n--tilt: ") && ContainsSubstring("--revolution: ") &&
                             ContainsSubstring("write --with contact too") && ContainsSubstring("--no-curve: ") &&
                             ContainsSubstring("write --with load too"));
    CHECK_THAT(hdconj_run("report -o page.txt", folder.path()).err, ContainsSubstring("write NAME.html"));
    CHECK(folder.names().empty());
}

TEST_CASE("report names the scene that fails", "[report]")
{
    TemporaryFolder const folder;
    REQUIRE(hdconj_run("init good.toml", folder.path()).status == 0);
    std::string narrow = content(folder / "good.toml");
    std::string const key = "radial_deformation = ";
    narrow.insert(narrow.find(key) + key.size(), "10");
    write(folder / "bad.toml", narrow);
    auto const bad = hdconj_run("report good.toml bad.toml --json", folder.path());
    INFO(bad.err);
    CHECK(bad.status == 2);
    CHECK_THAT(bad.err, ContainsSubstring("in bad.toml\nbad.toml line "));
    CHECK(json::parse(bad.out).at("scene") == "good.toml, bad.toml");
    CHECK(json::parse(bad.out).at("faults").at(0).at("origin") == "bad.toml");
    auto const failed =
        hdconj_run("report good.toml --set circular_spline.backlash_offset=0.065 --json", folder.path());
    INFO(failed.err);
    CHECK(failed.status == 1);
    CHECK(failed.err.starts_with("hdconj: good.toml: "));
    CHECK(json::parse(failed.out).at("scene") == "good.toml");
}

TEST_CASE("report shows the drives that can be solved, and names the others", "[report]")
{
    TemporaryFolder const folder;
    REQUIRE(hdconj_run("init good.toml", folder.path()).status == 0);
    std::string tight = content(folder / "good.toml");
    for (std::string const key : {"backlash_offset = 0.0", "name = \"type-50"})
        REQUIRE(tight.find(key) != std::string::npos);
    tight.replace(tight.find("backlash_offset = 0.0"), 21, "backlash_offset = 0.065");
    tight.insert(tight.find("name = \"") + 8, "tight <b> ");
    write(folder / "tight.toml", tight);
    auto const some = hdconj_run("report tight.toml good.toml -o some.html --json", folder.path());
    INFO(some.err);
    CHECK(some.status == 1);
    json const said = json::parse(some.out), data = data_of(folder / "some.html");
    CHECK(said.at("drives").size() == 1);
    CHECK(data.at("drives").size() == 1);
    CHECK(data.at("failed") == said.at("failed"));
    CHECK(said.at("failed").size() == 1);
    CHECK_THAT(said.at("failed").at(0).at("name").get<std::string>(), ContainsSubstring("tight <b>"));
    std::string const why = said.at("failed").at(0).at("why").get<std::string>();
    CHECK_THAT(some.err, ContainsSubstring("tight <b>") && ContainsSubstring(why));
    CHECK_THAT(content(folder / "some.html"), ContainsSubstring("<h2>tight &lt;b&gt;"));  // without scripts
    auto const none = hdconj_run("report tight.toml tight.toml -o none.html --json", folder.path());
    CHECK(none.status == 1);
    CHECK(json::parse(none.out).at("scene") == "tight.toml");
    CHECK(json::parse(none.out).at("error").at("cause").get<std::string>().size() > 10);
    CHECK_FALSE(fs::exists(folder / "none.html"));
}

TEST_CASE("a result holds the files that its scene names", "[report][wire]")
{
    TemporaryFolder const folder;
    fs::create_directories(folder / "sub");
    fs::create_directories(folder / "away");
    for (char const* const name : {"cam-table.toml", "cam-table.csv"})
        fs::copy_file(scenes + name, folder / "sub" / name);
    write(folder / "sub/form.csv", "height [mm],excess [um]\n-0.3,0\n-0.1,0.5\n0.1,0\n0.2,1\n");
    std::string const form = " --set 'errors.profile_form=\"form.csv\"' ";
    std::string const wire = " --set wedm.wire_diameter=0.1 --set wedm.spark_gap=0.01 ";
    REQUIRE(hdconj_run("solve sub/cam-table.toml -o a.h5 -q" + form + wire, folder.path()).status == 0);
    REQUIRE(hdconj_run("report sub/cam-table.toml -o computed.html" + form + wire, folder.path()).status == 0);
    REQUIRE(hdconj_run("wedm sub/cam-table.toml --dialect csv -o cut" + wire, folder.path()).status == 0);
    json const computed = drive_of(folder / "computed.html");
    std::string table = content(folder / "sub/cam-table.csv");  // another motion under the same name
    table.replace(table.find("0.25"), 4, "0.26");
    write(folder / "away/cam-table.csv", table);
    fs::path const away = folder / "away";
    for (bool const has_foreign : {true, false}) {
        auto const read = hdconj_run("report ../a.h5 -o read.html", away);
        INFO(read.err);
        REQUIRE(read.status == 0);
        CHECK(drive_of(away / "read.html").at("teeth") == computed.at("teeth"));
        CHECK(content(away / "read.html").find("scene_files") == std::string::npos);
        auto const cut = hdconj_run("wedm --from ../a.h5 --dialect csv -o cut", away);
        INFO(cut.err);
        REQUIRE(cut.status == 0);
        for (auto const& each : fs::directory_iterator(away / "cut"))
            if (each.path().extension() == ".csv")
                CHECK(content(each.path()) == content(folder / "cut" / each.path().filename()));
        if (has_foreign)
            fs::remove(away / "cam-table.csv");
    }
    {  // as former versions wrote it
        io::hdf5::File const opened(H5Fopen((folder / "a.h5").c_str(), H5F_ACC_RDWR, H5P_DEFAULT), "open");
        io::hdf5::checked(H5Ldelete(opened, "scene_files", H5P_DEFAULT), "delete");
    }
    for (std::string const verb : {"report ../a.h5 -o old.html", "wedm --from ../a.h5 -o old"}) {
        auto const old = hdconj_run(verb, away);
        CHECK(old.status == 2);
        CHECK_THAT(old.err, ContainsSubstring("cam-table.csv") && ContainsSubstring("neither kept in the result nor") &&
                                ContainsSubstring("put the file there"));
        CHECK(old.err.find("version") == std::string::npos);
    }
    for (char const* const name : {"cam-table.csv", "form.csv"})
        fs::copy_file(folder / "sub" / name, folder / name);
    REQUIRE(hdconj_run("report ../a.h5 -o beside.html", away).status == 0);
    CHECK(drive_of(away / "beside.html").at("teeth") == computed.at("teeth"));
}

TEST_CASE("report --json says what was written and left out", "[report]")
{
    TemporaryFolder const folder;
    // without a torque, for which a design would try walls for seconds
    std::string const light = "--set '!load' ";
    REQUIRE(hdconj_run("solve -o a.h5 -q " + light, folder.path()).status == 0);
    // a file and a scene in one page; the file has no contact
    auto const done =
        hdconj_run("report a.h5 " + narrow + light + "--with contact,design --json -o both.html", folder.path());
    CHECK(done.status == 1);
    json const said = json::parse(done.out);
    CHECK(said.at("format") == "hdconj-report");
    CHECK(said.at("files").at("html").at("path") == "both.html");
    CHECK(said.at("files").at("html").at("bytes") == fs::file_size(folder / "both.html"));
    json const& file = said.at("drives").at(0);
    json const& scene = said.at("drives").at(1);
    CHECK_THAT(file.at("origin").get<std::string>(), ContainsSubstring("a.h5"));
    CHECK(scene.at("origin").is_null());
    CHECK(file.at("parts") == json{"solve", "design"});
    CHECK(scene.at("parts") == json{"solve", "contact", "design"});
    json const design = drives_of(folder / "both.html").at(1).at("design");
    CHECK(design.at("rows").size() > 50);
    for (json const& row : design.at("rows"))
        CHECK(row.at("here").is_string());
    CHECK(drives_of(folder / "both.html").at(0).at("design").at("rows").size() == design.at("rows").size());
    json const& left = file.at("left_out").at(0);
    CHECK(left.at("part") == "contact");
    CHECK(left.at("failed") == true);
    CHECK_THAT(left.at("why").get<std::string>(), ContainsSubstring("--with contact"));
}

}  // namespace hdconj::test::report_output_cases
