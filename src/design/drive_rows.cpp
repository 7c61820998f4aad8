// SPDX-License-Identifier: GPL-3.0-or-later

#include "base/text.hpp"
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

}  // namespace hdconj::design
