// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// What tests ask of JSON: which keys there are, and figures without what differs from run to run.
#pragma once

#include <nlohmann/json.hpp>
#include <set>
#include <string>

namespace hdconj::test {

/// All keys of @p json at any depth.
inline void collect_keys(nlohmann::json const& json, std::set<std::string>& keys)
{
    for (auto const& [key, value] : json.items()) {
        if (json.is_object())
            keys.insert(key);
        if (value.is_structured())
            collect_keys(value, keys);
    }
}

/// A summary whose part @p verb has cases; times and files are left out.
inline nlohmann::json without_times(nlohmann::json summary, char const* verb)
{
    summary.erase("timing");
    summary.erase("files");
    for (char const* const rows : {"cases", "sequences"})
        if (summary.at(verb).contains(rows))
            for (auto& each : summary.at(verb).at(rows))
                each.erase("time_s");
    return summary;
}

}  // namespace hdconj::test
