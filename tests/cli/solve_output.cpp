// SPDX-License-Identifier: GPL-3.0-or-later
// `hdconj solve` as a user meets it: files, exit statuses, kills. What holds for other verbs too: every_verb.cpp.
#include <csignal>
#include <random>
#include <thread>

#include "cli/hdconj_run.hpp"
#include "support/catch.hpp"

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
    CHECK_THAT(done.out, ContainsSubstring("200/202") && ContainsSubstring("type-50.h5") && ContainsSubstring("-2.567 um"));
    CHECK(folder.names() == std::vector<std::string>{"type-50.h5"});
}

TEST_CASE("solve names the file after any drive")
{
    TemporaryFolder const folder;
    CHECK(solve("--set 'drive.name=\"../a b\"'", folder).status == 0);
    CHECK(folder.names() == std::vector<std::string>{"a-b.h5"});
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
        WARN("no python with h5py and ezdxf, or no gnuplot: not tried");
        return;
    }
    TemporaryFolder const folder;
    REQUIRE(solve("-o a.h5 --dxf a.dxf --picture a.svg", folder).status == 0);
    std::string const reader = "'" HDCONJ_PYTHON "' '" HDCONJ_SOURCE_DIR "/tests/cli/read_with_h5py.py' ";
    auto const read = hdconj::test::run(reader + "a.h5 a.dxf", folder.path());
    INFO(read.out + read.err);
    CHECK(read.status == 0);
    CHECK_THAT(content(folder / "a.svg"), ContainsSubstring("path of a tooth corner") && ContainsSubstring("</svg>"));
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
    for (std::size_t i = 0; i < a.size(); ++i) {
        different += a[i] == c[i] ? 0 : 1;
    }
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
