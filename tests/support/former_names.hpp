// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Names of the format before, as docs/reference/json.md lists them.
#pragma once

#include <algorithm>
#include <fstream>
#include <optional>
#include <regex>
#include <string>
#include <vector>

namespace hdconj::test {

/// A name without unit, and what the format before called it.
struct Renamed
{
    std::string name, former;
    auto operator<=>(Renamed const&) const = default;
};

/// The rows of the page's table for @p object, behind @p more of HDF5 alone.
inline std::vector<Renamed> renamed(std::string const& object, std::vector<Renamed> more = {})
{
    std::ifstream page(HDCONJ_SOURCE_DIR "/docs/reference/json.md");
    std::regex const row("^\\| `" + object + "` \\| `(\\w+)` \\| `(\\w+)` \\|$");
    for (std::string line; std::getline(page, line);)
        if (std::smatch found; std::regex_match(line, found, row))
            more.push_back({found[1], found[2]});
    return more;
}

/// What follows @p stem in @p key, where that is an error, a count or a unit.
inline std::optional<std::string> end_of(std::string const& key, std::string const& stem)
{
    static std::regex const ends("(_error|_count)?(_(um|mm|arcmin|mm_per_rad))?");
    std::string const rest = key.starts_with(stem) ? key.substr(stem.size()) : "?";
    return std::regex_match(rest, ends) ? std::optional(rest) : std::nullopt;
}

/// Whether @p key is the former one of a figure.
inline bool is_former(std::string const& key, std::vector<Renamed> const& names)
{
    return std::any_of(names.begin(), names.end(),
                       [&](Renamed const& each) { return end_of(key, each.former).has_value(); });
}

}  // namespace hdconj::test
