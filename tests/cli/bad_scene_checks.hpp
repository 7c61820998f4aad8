// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// What must be said about a bad scene.
#pragma once

#include <algorithm>
#include <filesystem>
#include <string>

#include "bad_scenes_table.hpp"
#include "hdconj/read_scene.hpp"
#include "support/catch.hpp"

namespace hdconj::test {

/// All faults of a scene, those of its geometry too; relative file names start at @p folder.
inline Faults faults_of(std::string const& text, std::filesystem::path const& folder = {})
{
    auto reading = examine_scene(text, "scene", folder);
    examine_geometry(reading);
    return reading.faults;
}

inline Fault const* find_fault(Faults const& faults, std::string const& path)
{
    auto const found = std::find_if(faults.begin(), faults.end(), [&path](Fault const& f) { return f.path == path; });
    return found == faults.end() ? nullptr : &*found;
}

/// A fault says place, reason and remedy, and quotes no more of the scene than a line holds.
inline void check_fields(Fault const& fault)
{
    CHECK_FALSE(fault.path.empty());
    CHECK_FALSE(fault.reason.empty());
    CHECK_FALSE(fault.remedy.empty());
    CHECK(fault.line >= 0);
    constexpr std::size_t longest_value = 100;
    CHECK(fault.value.size() <= longest_value);
}

/// As many faults as @p row says, each of them whole.
inline void check_all(Faults const& faults, BadScene const& row)
{
    CHECK_FALSE(faults.empty());
    if (row.faults > 0)
        CHECK(faults.size() == static_cast<std::size_t>(row.faults));
    std::for_each(faults.begin(), faults.end(), check_fields);
}

/// @p text is refused as @p row says.
inline void check_row(BadScene const& row, std::string const& text)
{
    auto const faults = faults_of(text);
    INFO(row.name << "\n" << describe(faults));
    auto const* const fault = find_fault(faults, row.path);
    REQUIRE(fault != nullptr);
    CHECK_THAT(fault->reason, ContainsSubstring(row.reason));
    CHECK_THAT(fault->remedy, ContainsSubstring(row.remedy));
    check_all(faults, row);
}

}  // namespace hdconj::test
