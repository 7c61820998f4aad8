// SPDX-License-Identifier: GPL-3.0-or-later
// The torque of a design, and the bent cup and slices with which its ring is checked.
#include <string>
#include <utility>

#include "base/text.hpp"
#include "hdconj/units.hpp"
#include "sheet.hpp"

namespace hdconj::design {

void add_load_rows(Sheet& sheet, double torque)
{
    constexpr int digits = 6;
    constexpr double slices = 9;
    auto const add = [&](char const* name, char const* key, char const* rule, scene::ParameterValue value,
                         char const* unit) {
        sheet.add({name, "", key, rule, {}, std::move(value), unit, "load", DesignOrigin::rule, ""});
    };
    add("model of the cone", "coning.model", "the ring is made for the bent cup, with which it is checked",
        std::string("elastic"), "");
    add("bottom to middle of the bearing", "coning.bottom_to_middle", "L - L_1 - L_2/2, the middle of the teeth",
        rounded(sheet["L"] - sheet["L_1"] - sheet["L_2"] / 2, digits), "mm");
    add("slices across the face width", "slices.count", "as many as the ring is checked in", slices, "1");
    add("surface of the circular spline", "slices.surface", "one outline over the whole width", std::string("tilted"),
        "");
    sheet.add({"rated torque on the circular spline",
               "T",
               "load.torque",
               "as asked for",
               {},
               torque / newton_metre,
               "N m",
               "wish",
               DesignOrigin::wish,
               ""});
}

}  // namespace hdconj::design
