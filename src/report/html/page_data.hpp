// SPDX-License-Identifier: GPL-3.0-or-later
// What of a result the page holds.
#pragma once

#include <set>
#include <string>
#include <string_view>

#include "json_group.hpp"

namespace hdconj::report {

/// Groups and datasets that the page's part @p part, a word of ReportPart, leaves out: what a study repeats of the
/// solution, what other parts hold, and what no view shows.
[[nodiscard]] inline std::set<std::string> left_of_part(std::string_view part)
{
    if (part == "solve")
        return {"circular_spline", "neutral_curve", "contact", "load", "scene_files"};
    if (part == "wedm")
        return {"xy"};
    std::set<std::string> left{"flexspline", "neutral_curve", "envelope",        "conjugate_zones",
                               "undecided",  "notes",         "summary",         "timing",
                               "xy",         "end",           "circular_spline", "scene_files"};
    left.insert(part == "contact" ? "load" : "contact");
    return left;
}

}  // namespace hdconj::report
