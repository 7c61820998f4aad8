// SPDX-License-Identifier: GPL-3.0-or-later
// A process that is killed while it writes leaves the old file or the new one, and nothing that stays.
#include <csignal>
#include <cstdlib>
#include <random>
#include <thread>

#include "hdconj/file/atomic_file.hpp"
#include "hdconj/result_files.hpp"
#include "support/catch.hpp"
#include "support/run_program.hpp"
#include "support/sample_solution.hpp"
#include "support/temporary_folder.hpp"

namespace hdconj::test::kill_during_write_cases {

using test::content;
using test::TemporaryFolder;

namespace {

using Write = void (*)(Solution const&, std::filesystem::path const&);

/// Writes @p one and @p other in turn until it is killed.
[[noreturn]] void write_for_ever(Write write, Solution const& one, Solution const& other,
                                 std::filesystem::path const& file)
{
    for (;;) {
        write(other, file);
        write(one, file);
    }
}

/// Number of temporary files of @p name in @p folder; nothing may be there but these and the three results.
std::size_t temporaries(TemporaryFolder const& folder, std::string const& name)
{
    std::size_t left = 0;
    for (auto const& found : folder.names()) {
        bool const temporary = found.rfind("." + name + ".hdconj-", 0) == 0 && found.ends_with(".tmp");
        CHECK((temporary || found == name || found == "one" || found == "other"));
        left += temporary ? 1 : 0;
    }
    return left;
}

/// Ends a writing process @p times times by @p signal; every time the file must be one of the two.
/// @return how often a temporary file was left, that is, how often the signal hit a write
std::size_t end_writers(int signal, Write write, std::string const& name, int times, std::chrono::microseconds longest)
{
    ::setenv("SOURCE_DATE_EPOCH", "1000000000", 1);
    TemporaryFolder const folder;
    auto const one = sample::solution();
    auto other = one;
    other.neutral_curve.resize(other.neutral_curve.size() / 2);
    write(one, folder / "one");
    write(other, folder / "other");
    auto const bytes_of_one = content(folder / "one"), bytes_of_other = content(folder / "other");
    REQUIRE(bytes_of_one != bytes_of_other);
    write(one, folder / name);

    // A child that is hit before it has the program's handler ends as a program does, and not in Catch's handler.
    auto const handler = std::signal(signal, SIG_DFL);
    std::mt19937 random(1);
    std::uniform_int_distribution<long> wait(0, longest.count());
    std::size_t hit = 0;
    for (int i = 0; i < times; ++i) {
        pid_t const child = ::fork();
        if (child == 0) {
            file::remove_temporaries_when_interrupted();
            write_for_ever(write, one, other, folder / name);
        }
        std::this_thread::sleep_for(std::chrono::microseconds(wait(random)));
        ::kill(child, signal);
        int waited = 0;
        ::waitpid(child, &waited, 0);
        REQUIRE(test::status_of_wait(waited) == 128 + signal);
        auto const found = content(folder / name);
        REQUIRE((found == bytes_of_one || found == bytes_of_other));
        hit += temporaries(folder, name);
    }
    std::signal(signal, handler);
    write(one, folder / name);
    CHECK(temporaries(folder, name) == 0);
    ::unsetenv("SOURCE_DATE_EPOCH");
    return hit;
}

}  // namespace

TEST_CASE("a killed process leaves the old HDF5 file or the new one")
{
    auto const hit = end_writers(SIGKILL, write_hdf5, "result.h5", 150, std::chrono::milliseconds(12));
    CHECK(hit > 5);  // else the kills came at the wrong moments and nothing was tried
}

TEST_CASE("a killed process leaves the old DXF file or the new one")
{
    auto const hit = end_writers(SIGKILL, write_dxf, "result.dxf", 100, std::chrono::milliseconds(6));
    CHECK(hit > 5);
}

TEST_CASE("an interrupted process leaves the old file or the new one, and no temporary file")
{
    int const signal = GENERATE(SIGINT, SIGTERM, SIGHUP);
    CHECK(end_writers(signal, write_hdf5, "result.h5", 60, std::chrono::milliseconds(12)) == 0);
}

}  // namespace hdconj::test::kill_during_write_cases
