// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The fuzzed targets over the stored inputs: tests/fuzz/corpus/<target> holds seeds, tests/fuzz/finds/<target> what
/// once was a find.
#include <algorithm>
#include <ctime>
#include <filesystem>

#include "drive_text.hpp"
#include "support/catch.hpp"
#include "support/temporary_folder.hpp"
#include "targets.hpp"

using namespace hdconj;
namespace fs = std::filesystem;

namespace {

/// No input may take longer [s of the processor], times what sanitizers cost.
constexpr double longest = 10.0 * HDCONJ_TIMEOUT_FACTOR;

std::vector<fs::path> inputs(std::string const& kind, std::string const& target)
{
    std::vector<fs::path> files;
    fs::path const folder = fs::path(HDCONJ_SOURCE_DIR) / "tests/fuzz" / kind / target;
    if (!fs::exists(folder))
        return files;
    for (auto const& entry : fs::directory_iterator(folder))
        files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files;
}

void replay(std::string const& target, void (*run)(fuzz::Bytes))
{
    for (char const* kind : {"corpus", "finds"}) {
        auto const files = inputs(kind, target);
        REQUIRE((!files.empty() || std::string(kind) == "finds"));
        for (fs::path const& file : files) {
            INFO(kind << "/" << target << "/" << file.filename().string());
            std::string const text = test::content(file);
            std::clock_t const begin = std::clock();
            CHECK_NOTHROW(run({reinterpret_cast<std::uint8_t const*>(text.data()), text.size()}));
            CHECK(static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC < longest);
        }
    }
}

}  // namespace

TEST_CASE("scene text: stored inputs of the fuzzer", "[fuzz]")
{
    replay("scene_text", fuzz::scene_text);
}

TEST_CASE("CSV profiles: stored inputs of the fuzzer", "[fuzz]")
{
    replay("csv_profile", fuzz::csv_profile);
}

TEST_CASE("wishes of a design: stored inputs of the fuzzer", "[fuzz]")
{
    replay("design_wishes", fuzz::design_wishes);
}

TEST_CASE("measured points: stored inputs of the fuzzer", "[fuzz]")
{
    replay("point_file", fuzz::point_file);
}

TEST_CASE("scene to solution: stored inputs of the fuzzer", "[fuzz]")
{
    replay("scene_solve", fuzz::scene_solve);
}
