// SPDX-License-Identifier: GPL-3.0-or-later
// Teeth in modules: Table 2-1 of the thesis for double arcs, proportions of our own for the other families.
#include <map>

#include "base/text.hpp"
#include "hdconj/scene/parameters.hpp"
#include "sheet.hpp"

namespace hdconj::design {
namespace {

/// One key of a tooth.
struct ToothRule
{
    std::string_view key, name, symbol;
    double share;           ///< in modules, or in the unit
    std::string_view unit;  ///< "m": a length in modules
};

using ToothRules = std::vector<ToothRule>;

ToothRules heights(double addendum, double dedendum)
{
    return {{"addendum", "addendum", "h_a", addendum, "m"}, {"dedendum", "dedendum", "h_f", dedendum, "m"}};
}

/// Heights that the points say: they have no keys.
ToothRules heights_of_points()
{
    return {{"", "addendum", "h_a", 0.8, "m"}, {"", "dedendum", "h_f", 1.12, "m"}};
}

ToothRules operator+(ToothRules rules, ToothRules const& more)
{
    rules.insert(rules.end(), more.begin(), more.end());
    return rules;
}

ToothRule thickness(double share)
{
    return {"thickness", "tooth thickness on the pitch circle", "s", share, "m"};
}

ToothRule pressure_angle(double degrees)
{
    return {"pressure_angle_deg", "pressure angle", "alpha", degrees, "deg"};
}

/// Table 2-1 has lengths in mm for m = 0.25 mm. Its l_f repeats b_f by a misprint: the arcs touch instead.
std::map<std::string, ToothRules, std::less<>> const& tooth_rules()
{
    static std::map<std::string, ToothRules, std::less<>> const rules{
        {"double-circular-arc",
         heights(0.9, 1.212) + ToothRules{{"convex_radius", "radius of the convex arc", "rho_a", 1.0804, "m"},
                                          {"convex_offset", "centre behind the centre line", "l_a", 0.3928, "m"},
                                          {"concave_radius", "radius of the concave arc", "rho_f", 2.058, "m"},
                                          {"concave_rise", "centre above the pitch line", "b_f", 0.2684, "m"},
                                          {"tip_line_from", "straight flank from this height", "h_t", 0.76, "m"}}},
        {"straight", heights(0.8, 1.12) + ToothRules{thickness(1.56), pressure_angle(29)}},
        {"involute", heights(0.8, 1.12) + ToothRules{pressure_angle(28.6), thickness(1.52)}},
        {"cycloid",
         heights(0.76, 1.04) +
             ToothRules{{"addendum_rolling_radius", "radius of the circle that rolls outside", "rho_a", 0.56, "m"},
                        {"dedendum_rolling_radius", "radius of the circle that rolls inside", "rho_f", 0.8, "m"},
                        thickness(1.56)}},
        {"s-tooth", heights(0.76, 1.04) + ToothRules{pressure_angle(9), thickness(1.56)}},
        {"arc-chain", heights(0.8, 1.12) + ToothRules{{"tip_thickness", "thickness at the tip", "s_a", 0.8, "m"},
                                                      {"tip_angle_deg", "flank's angle at the tip", "", 38, "deg"}}},
        {"bezier", heights_of_points()},
        {"b-spline", heights_of_points()}};
    return rules;
}

/// Lists of a tooth, lengths in modules; angles stand in the second column of `pieces` and stay.
struct ToothList
{
    std::string_view key, name;
    scene::NumberRows rows;
    bool points;
};

std::map<std::string, ToothList, std::less<>> const& tooth_lists()
{
    static std::map<std::string, ToothList, std::less<>> const lists{
        {"arc-chain",
         {"pieces", "arcs [radius, angle] and lines [length]", {{0.64, 20}, {1.4, 9}, {0.24}, {-2, 60}}, false}},
        {"bezier",
         {"points", "control points from tip to root", {{0.24, 0.8}, {0.6, 0.48}, {0.68, -0.16}, {1.16, -1.12}}, true}},
        {"b-spline",
         {"points",
          "points from tip to root",
          {{0.28, 0.8}, {0.48, 0.52}, {0.608, 0.24}, {0.688, 0}, {0.784, -0.32}, {0.928, -0.68}, {1.16, -1.12}},
          true}}};
    return lists;
}

constexpr int tooth_digits = 5;

}  // namespace

void add_tooth_rows(Sheet& sheet, DesignWishes const& wishes)
{
    std::string const table = "flexspline.profile.";
    bool const thesis = wishes.family == "double-circular-arc";
    std::string const source = thesis ? "thesis Table 2-1" : "proportions of data/scenes/" + wishes.family + ".toml";
    double const m = sheet["m"];
    sheet.add(
        {"tooth family", "", table + "family", "as asked for", {}, wishes.family, "", "wish", DesignOrigin::wish, ""});
    for (auto const& rule : tooth_rules().at(wishes.family)) {
        bool const length = rule.unit == "m";
        sheet.add({std::string(rule.name),
                   std::string(rule.symbol),
                   rule.key.empty() ? "" : table + std::string(rule.key),
                   short_number(rule.share) + (length ? " m" : " deg"),
                   {},
                   rounded(length ? rule.share * m : rule.share, tooth_digits),
                   length ? "mm" : "deg",
                   source,
                   DesignOrigin::rule,
                   ""});
    }
    if (thesis)
        sheet.add({"centre in front of the centre line",
                   "l_f",
                   table + "concave_offset",
                   "the arcs touch",
                   {},
                   std::string("tangent"),
                   "",
                   source,
                   DesignOrigin::limited,
                   "the table prints 0.0671, the value of b_f again, with which the arcs do not meet"});
    auto const list = tooth_lists().find(wishes.family);
    if (list == tooth_lists().end())
        return;
    scene::NumberRows rows = list->second.rows;
    for (auto& row : rows)
        for (std::size_t column = 0; column < row.size(); ++column)
            if (list->second.points || column == 0)
                row[column] = rounded(row[column] * m, tooth_digits);
    sheet.add({std::string(list->second.name),
               "",
               table + std::string(list->second.key),
               "lengths in modules",
               {},
               rows,
               "mm",
               source,
               DesignOrigin::rule,
               ""});
}

}  // namespace hdconj::design
