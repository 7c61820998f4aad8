// SPDX-License-Identifier: GPL-3.0-or-later
// What follows from the wishes alone, and what the drive is loaded by.
#include <string>
#include <utility>

#include "base/text.hpp"
#include "hdconj/units.hpp"
#include "same_value.hpp"
#include "sheet.hpp"
#include "wishes.hpp"

namespace hdconj::design {

Sheet drive_rows(DesignWishes const& wishes)
{
    Sheet sheet;
    int const teeth = teeth_of(wishes);
    double const module = module_of(wishes), diameter = rounded(module * teeth, 6);
    auto const wish = [&](std::string name, std::string symbol, std::string key, scene::ParameterValue value,
                          std::string unit) {
        sheet.add({std::move(name),
                   std::move(symbol),
                   std::move(key),
                   "as asked for",
                   {},
                   std::move(value),
                   std::move(unit),
                   "wish",
                   DesignOrigin::wish,
                   ""});
    };
    auto const rule = [&](std::string name, std::string symbol, std::string key, std::string text, double value,
                          std::string unit, std::string source) {
        sheet.add({std::move(name),
                   std::move(symbol),
                   std::move(key),
                   std::move(text),
                   {},
                   value,
                   std::move(unit),
                   std::move(source),
                   DesignOrigin::rule,
                   ""});
    };
    wish("name", "", "drive.name", wishes.name, "");
    wish("ratio, circular spline held", "i", "", wishes.ratio, "1");
    rule("waves", "u", "wave_generator.waves", "2: balanced, one tooth a wave", waves, "1", "thesis 4.2");
    rule("teeth of the flexspline", "z_f", "drive.flexspline_teeth", "i u", teeth, "1", "thesis (4-1)");
    rule("teeth of the circular spline", "z_c", "drive.circular_spline_teeth", "z_f (1 + 1/i)", teeth + waves, "1",
         "thesis (4-2)");
    if (wishes.module)
        wish("module", "m", "drive.module", module, "mm");
    else
        rule("module", "m", "drive.module", "standard, nearest to d_r/z_f", module, "mm", "DIN 780-1, both series");
    rule("pitch diameter of the flexspline", "d_r", "", "m z_f", diameter, "mm", "thesis Table 4-1");
    wish(length_ratio_row, "", "", wishes.length_ratio, "1");
    sheet.add({"length of the cup",
               "L",
               "flexspline.cup.length",
               "length ratio times d_r",
               {},
               rounded(wishes.length_ratio * diameter),
               "mm",
               "wish",
               DesignOrigin::wish,
               ""});
    return sheet;
}

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
