// SPDX-License-Identifier: GPL-3.0-or-later
// `hdconj solve` as a user meets it: files, exit statuses, kills. What holds for other verbs too: every_verb.cpp.
#include <cmath>
#include <csignal>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numbers>
#include <random>
#include <thread>

#include "hdconj_run.hpp"
#include "support/catch.hpp"
#include "support/not_tried.hpp"
#include "support/read_hdf5.hpp"

namespace hdconj::test::solve_output_cases {

using hdconj::test::content;
using hdconj::test::is_missing;
using hdconj::test::Outcome;
using hdconj::test::TemporaryFolder;

namespace {

Outcome solve(std::string const& arguments, TemporaryFolder const& folder)
{
    return hdconj::test::hdconj_run("solve " + arguments, folder.path());
}

}  // namespace

TEST_CASE("solve writes the drive's name and says so")
{
    TemporaryFolder const folder;
    auto const done = solve("", folder);
    CHECK(done.status == 0);
    CHECK(done.err.empty());
    CHECK_THAT(done.out,
               ContainsSubstring("200/202") && ContainsSubstring("type-50.h5") && ContainsSubstring("-2.567 um"));
    CHECK(folder.names() == std::vector<std::string>{"type-50.h5"});
}

TEST_CASE("solve names the file after any drive")
{
    TemporaryFolder const folder;
    CHECK(solve("--set 'drive.name=\"../a b\"'", folder).status == 0);
    CHECK(folder.names() == std::vector<std::string>{"a-b.h5"});
}

TEST_CASE("the land lies between one space and the next, whether or not the cam is its own mirror image")
{
    auto const [second, axial] = GENERATE(table<double, std::string>({
        {0, ""},
        {0.01, ""},
        {-0.01, ""},
        {0.01,
         "--set coning.model=linear --set coning.bottom_to_middle=9 --set slices.count=3 --set "
         "slices.surface=per-slice"},
    }));
    TemporaryFolder const folder;
    std::filesystem::copy_file(HDCONJ_SOURCE_DIR "/data/scenes/cam-table.toml", folder / "cam.toml");
    std::ofstream table(folder / "cam-table.csv");
    constexpr double rad = std::numbers::pi / 180;
    for (int degrees = 0; degrees < 180; degrees += 5)
        table << degrees << ',' << 0.25 * std::cos(2 * degrees * rad) + second * std::sin(4 * degrees * rad) << '\n';
    table.close();
    auto const done = solve("cam.toml -o a.h5 --json " + axial, folder);
    INFO(done.err);
    REQUIRE(done.status == 0);
    auto const summary = nlohmann::json::parse(done.out);
    auto const& geometry = summary.at("geometry");
    auto const file = hdconj::test::open_file(folder / "a.h5");
    auto const outline = hdconj::test::read(file, "/circular_spline/outline");
    auto const marks = hdconj::test::read(file, "/circular_spline/landmarks").values;
    std::size_t const middle = outline.shape[0] / 2;
    auto const angle = [&](double mark) {
        std::size_t const at = 2 * (middle * outline.shape[1] + static_cast<std::size_t>(mark));
        return std::atan2(outline.values[at], outline.values[at + 1]);
    };
    double const pitch = 2 * std::numbers::pi / 202, tip = geometry.at("tip_radius_mm").get<double>();
    double const left = tip * (pitch / 2 + angle(marks.front())), right = tip * (pitch / 2 - angle(marks.back()));
    double const stated = geometry.at("land_width_mm").get<double>(),
                 error = summary.at("error").at("error_land_width_mm").get<double>();
    constexpr double written = 1e-13;  // rounding of the points
    INFO("halves " << left << " and " << right);
    CHECK((second == 0) == (std::abs(left - right) < 1e-6));
    CHECK(std::abs(stated - (left + right)) <= error + written);
    CHECK(summary.at("error").at("error_land_half_angle_deg").get<double>() * rad * 2 * tip ==
          Approx(error).epsilon(1e-12));
    CHECK(std::abs(geometry.at("land_half_angle_deg").get<double>() * rad * 2 * tip - stated) <= written);
}

TEST_CASE("targets that are bad input are refused with 2, before anything is written")
{
    auto const [arguments, said] = GENERATE(table<std::string, std::string>({
        {"-o -", "standard output"},
        {"-o a.h5 --dxf ./a.h5", "is given to"},
        {"-o a.h5 --picture a.jpg", ".svg"},
        {"scene.toml -o ./scene.toml", "scene file"},
        {"--picture a", ".png"},
    }));
    TemporaryFolder const folder;
    hdconj::test::hdconj_run("init scene.toml", folder.path());
    auto const before = folder.names();
    auto const refused = solve(arguments, folder);
    INFO(arguments);
    CHECK(refused.status == 2);
    CHECK_THAT(refused.err, ContainsSubstring(said));
    CHECK(refused.out.empty());
    CHECK(folder.names() == before);
}

TEST_CASE("targets that cannot be written end with 1 and the reason")
{
    auto const [arguments, said] = GENERATE(table<std::string, std::string>({
        {"-o .", "is a folder"},
        {"-o none/a.h5", "mkdir -p"},
        {"-o a.h5 --dxf none/a.dxf", "mkdir -p"},
        {"-o /dev/full", "No space left on device"},
        {"-o a.h5 --dxf /dev/full", "No space left on device"},
    }));
    TemporaryFolder const folder;
    auto const failed = solve(arguments, folder);
    INFO(arguments);
    CHECK(failed.status == 1);
    CHECK_THAT(failed.err, ContainsSubstring(said));
    CHECK(failed.out.empty());
}

TEST_CASE("all files of a real run are read by other programs")
{
    if (std::string(HDCONJ_PYTHON).empty() || is_missing("gnuplot")) {
        not_tried("python with h5py and ezdxf, or gnuplot");
        return;
    }
    TemporaryFolder const folder;
    REQUIRE(solve("-o a.h5 --dxf a.dxf --picture a.svg", folder).status == 0);
    std::string const reader = "'" HDCONJ_PYTHON "' '" HDCONJ_SOURCE_DIR "/tests/cli/readers/read_with_h5py.py' ";
    auto const read = hdconj::test::run(reader + "a.h5 a.dxf", folder.path());
    INFO(read.out + read.err);
    CHECK(read.status == 0);
    CHECK_THAT(content(folder / "a.svg"), ContainsSubstring("path of a tooth corner") && ContainsSubstring("</svg>"));
}

TEST_CASE("OMP_NUM_THREADS limits the threads where the scene leaves their number open")
{
    TemporaryFolder const folder;
    std::string const alone = "OMP_NUM_THREADS=1 " + hdconj::test::program + " solve -o a.h5";
    CHECK_THAT(hdconj::test::run(alone, folder.path()).out, ContainsSubstring("time, 1 thread"));
    CHECK_THAT(hdconj::test::run(alone + " --threads 2", folder.path()).out, ContainsSubstring("time, 2 threads"));
}

TEST_CASE("two runs differ in date and times only")
{
    TemporaryFolder const folder;
    REQUIRE(solve("-o a.h5", folder).status == 0);
    REQUIRE(solve("-o b.h5 --threads 1 --set solver.threads=0", folder).status == 0);
    REQUIRE(solve("-o c.h5", folder).status == 0);
    auto const a = content(folder / "a.h5"), c = content(folder / "c.h5");
    REQUIRE(a.size() == c.size());
    std::size_t different = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        different += a[i] == c[i] ? 0 : 1;
    constexpr std::size_t date_and_times = 20 + 8 * 20;  // one date, at most twenty stages
    CHECK(different <= date_and_times);
}

TEST_CASE("a killed run leaves the old result or a whole new one")
{
    TemporaryFolder const folder;
    REQUIRE(solve("-o a.h5", folder).status == 0);
    auto const size = content(folder / "a.h5").size();
    std::mt19937 random(2);
    std::uniform_int_distribution<int> milliseconds(0, 60);
    for (int i = 0; i < 30; ++i) {
        pid_t const child = ::fork();
        if (child == 0) {
            ::execl(HDCONJ_PROGRAM, "hdconj", "solve", "--quiet", "-o", (folder / "a.h5").c_str(), nullptr);
            ::_exit(127);
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds(random)));
        ::kill(child, SIGKILL);
        int waited = 0;
        ::waitpid(child, &waited, 0);
        auto const found = content(folder / "a.h5");
        REQUIRE(found.size() == size);
        REQUIRE(found.rfind("\x89HDF\r\n\x1a\n", 0) == 0);
    }
}

}  // namespace hdconj::test::solve_output_cases
