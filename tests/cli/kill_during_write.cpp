// SPDX-License-Identifier: GPL-3.0-or-later
// A process that is killed while it writes leaves the old file or the new one.
#include <csignal>
#include <cstdlib>
#include <random>
#include <thread>

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

/// Kills a writing process @p times times; every time the file must be one of the two.
/// @return how often a temporary file was left, that is, how often the kill hit a write
std::size_t kill_writers(Write write, std::string const& name, int times, std::chrono::microseconds longest)
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

    std::mt19937 random(1);
    std::uniform_int_distribution<long> wait(0, longest.count());
    for (int i = 0; i < times; ++i) {
        pid_t const child = ::fork();
        if (child == 0)
            write_for_ever(write, one, other, folder / name);
        std::this_thread::sleep_for(std::chrono::microseconds(wait(random)));
        ::kill(child, SIGKILL);
        int waited = 0;
        ::waitpid(child, &waited, 0);
        REQUIRE(test::status_of_wait(waited) == 128 + SIGKILL);
        auto const found = content(folder / name);
        REQUIRE((found == bytes_of_one || found == bytes_of_other));
    }
    std::size_t left = 0;
    for (auto const& found : folder.names()) {
        bool const temporary = found.rfind("." + name + ".hdconj-", 0) == 0 && found.ends_with(".tmp");
        CHECK((temporary || found == name || found == "one" || found == "other"));
        left += temporary ? 1 : 0;
    }
    ::unsetenv("SOURCE_DATE_EPOCH");
    return left;
}

}  // namespace

TEST_CASE("a killed process leaves the old HDF5 file or the new one")
{
    auto const hit = kill_writers(write_hdf5, "result.h5", 150, std::chrono::milliseconds(12));
    CHECK(hit > 5);  // else the kills came at the wrong moments and nothing was tried
}

TEST_CASE("a killed process leaves the old DXF file or the new one")
{
    auto const hit = kill_writers(write_dxf, "result.dxf", 100, std::chrono::milliseconds(6));
    CHECK(hit > 5);
}

}  // namespace hdconj::test::kill_during_write_cases
