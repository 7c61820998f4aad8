// SPDX-License-Identifier: GPL-3.0-or-later
// Writes the bad scenes of the tables as files, for tests in other languages (tests/python).
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "bad_families_table.hpp"
#include "bad_scenes_table.hpp"
#include "support/catch.hpp"
#include "support/temporary_folder.hpp"

namespace hdconj::test::write_bad_scenes_cases {

TEST_CASE("writes the bad scenes into the folder HDCONJ_BAD_SCENES", "[.][write-bad-scenes]")
{
    char const* const folder = std::getenv("HDCONJ_BAD_SCENES");
    REQUIRE(folder != nullptr);
    int number = 0;
    auto const write = [&](std::string const& text) {
        std::ofstream file(std::filesystem::path(folder) / (std::to_string(number++) + ".toml"), std::ios::binary);
        file << text;
        REQUIRE(file.flush());
    };
    for (auto const* const table : {&wrong_values(), &wrong_tables(), &wrong_geometry()})
        for (auto const& row : *table)
            write(edited(row));
    for (auto const& row : wrong_texts())
        write(row.to);
    std::filesystem::path const scenes = std::filesystem::path(HDCONJ_SOURCE_DIR) / "data/scenes";
    for (auto const& [scene, row] : bad_families())
        write(edited(content(scenes / (scene + ".toml")), row));
}

}  // namespace hdconj::test::write_bad_scenes_cases
