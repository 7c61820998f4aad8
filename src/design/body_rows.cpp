// SPDX-License-Identifier: GPL-3.0-or-later
// Table 4-1 of the thesis and (4-4), (4-5): dimensions by ranges, and what a short cup leaves of them.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/text.hpp"
#include "drive/end_shift.hpp"
#include "sheet.hpp"
#include "wishes.hpp"

namespace hdconj::design {
namespace {

constexpr int six_digits = 6;
constexpr double open_end = std::numeric_limits<double>::infinity();

/// A dimension in a range of shares of another one. The share of type-50 is taken where the range holds it, else the
/// end of the range that is nearer.
struct BodyRule
{
    std::string_view name, symbol, key;
    std::string_view base;  ///< symbol of the dimension that it is a share of
    double low, high;
    double type_50;  ///< share that the thesis prints
    std::string_view source;
};

constexpr std::string_view table_4_1 = "thesis Table 4-1";

constexpr std::array body_rules{
    BodyRule{"wall under the teeth", "delta", "flexspline.wall", "d_r", 0.01, 0.015, 0.014, table_4_1},
    BodyRule{"wall of the barrel", "delta_1", "flexspline.cup.barrel_wall", "delta", 0.5, 0.7, 0.4 / 0.7, table_4_1},
    BodyRule{"wall of the bottom", "delta_2", "flexspline.cup.bottom", "delta", 0.5, 0.7, 0.5 / 0.7, table_4_1},
    BodyRule{"tooth width", "L_2", "flexspline.cup.tooth_width", "d_r", 0.2, 0.25, 8.0 / 50, table_4_1},
    BodyRule{"length in front of the teeth", "L_1", "flexspline.cup.front_land", "L_2", 0.2, 0.3, 2.0 / 8, table_4_1},
    BodyRule{"fillet in front of the teeth", "R_1", "flexspline.cup.front_fillet", "m", 10, 20, 16, table_4_1},
    BodyRule{"fillet behind the teeth", "R_2", "flexspline.cup.rear_fillet", "m", 10, 20, 12, table_4_1},
    BodyRule{"fillet at the bottom", "R_3", "flexspline.cup.corner_radius", "delta", 4, 10, 2 / 0.7, table_4_1},
    BodyRule{"thickness of the flange", "t", "", "delta_1", 3, 4, 3 / 0.4, table_4_1},
    BodyRule{"outer diameter of the flange", "d_1", "", "d_r", 0.5, 0.6, 26.0 / 50, table_4_1},
    BodyRule{"inner diameter of the flange", "d_2", "", "d_1", 0.5, 0.5, 12.0 / 26, table_4_1},
    BodyRule{"outer diameter of the circular spline", "d_gw", "", "d_r", 1.4, open_end, 1.4, "thesis (4-4)"}};

std::string rule_text(BodyRule const& rule)
{
    std::string const base(rule.base);
    if (rule.high == open_end)
        return ">= " + short_number(rule.low) + " " + base;
    if (rule.low == rule.high)
        return short_number(rule.low) + " " + base;
    return "(" + short_number(rule.low) + " ... " + short_number(rule.high) + ") " + base;
}

std::string broken_by_thesis(BodyRule const& rule)
{
    constexpr int digits = 3;
    return "type-50 has " + short_number(rule.type_50, digits) + " " + std::string(rule.base) + ", against the rule";
}

/// The value of @p range that is nearest to @p value, with three digits where these stay in the range.
double inside(DesignRange const& range, double value)
{
    double const nearest = std::clamp(value, range.low, range.high), short_one = rounded(nearest);
    return range.contains(short_one) ? short_one : rounded(nearest, six_digits);
}

/// Length along the axis of a fillet of radius @p radius between two walls that differ by @p step.
double fillet_length(double radius, double step)
{
    return std::sqrt(step * (2 * radius - step));
}

/// The radius of a fillet of that length.
double fillet_radius(double length, double step)
{
    return (length * length / step + step) / 2;
}

class Body
{
  public:
    Body(Sheet& sheet, double wall, bool searched) : sheet_(sheet), wall_(wall), searched_(searched) {}

    void operator()()
    {
        for (auto const& rule : body_rules)
            add(rule);
    }

  private:
    void add(BodyRule const& rule)
    {
        constexpr double rounding = 1e-9;  // of shares that are quotients of printed numbers
        double const base = sheet_[rule.base];
        RangeRule const range_of{std::string(rule.base), {rule.low, rule.high}};
        DesignRange const range = range_of(base);
        double const share = rule.symbol == "delta" && wall_ > 0 ? wall_ : rule.type_50;
        DesignRow row{std::string(rule.name),
                      std::string(rule.symbol),
                      std::string(rule.key),
                      rule_text(rule),
                      range,
                      inside(range, share * base),
                      "mm",
                      std::string(rule.source),
                      DesignOrigin::rule,
                      "",
                      range_of};
        if (rule.type_50 < rule.low - rounding || rule.type_50 > rule.high + rounding)
            row.remark = broken_by_thesis(rule);
        if (rule.low == rule.high)
            row.range.reset();
        if (row.symbol == "delta" && searched_)
            row.origin = DesignOrigin::computed;
        limit(row);
        sheet_.add(std::move(row));
    }

    /// Makes @p row as small as @p most where it is larger, for the reason @p why.
    static void at_most(DesignRow& row, double most, std::string const& why)
    {
        if (row.number() <= most)
            return;
        row.value = rounded(most);
        bool const inside = !row.range || row.number() >= row.range->low;
        if (!inside)
            row.origin = DesignOrigin::limited;
        row.remark = why + (inside ? "" : ": below its range") + (row.remark.empty() ? "" : "; " + row.remark);
    }

    /// What the length of the cup leaves. The shares of the length are those of type-50, a cup of 0.3 pitch diameters.
    void limit(DesignRow& row) const
    {
        constexpr double share_of_teeth = 8.0 / 15, fillet_in_land = 0.9, straight = 0.9;
        if (row.symbol == "L_2")
            at_most(row, share_of_teeth * sheet_["L"], "8/15 of a short cup's length, as type-50");
        double const step = row.symbol.starts_with("R_") ? sheet_["delta"] - sheet_["delta_1"] : 0;
        if (row.symbol == "R_1" || row.symbol == "R_2")
            at_most(row, fillet_radius(fillet_in_land * sheet_["L_1"], step), "no longer than 0.9 L_1");
        if (row.symbol == "R_3")
            at_most(row, straight * (sheet_["L"] - sheet_["L_1"] - sheet_["L_2"] - fillet_length(sheet_["R_2"], step)),
                    "0.9 of the length that is left behind the teeth");
    }

    Sheet& sheet_;
    double wall_;
    bool searched_;  ///< the wall is a result of a search
};

DesignRow equation(std::string name, std::string symbol, std::string key, std::string rule, double value,
                   std::string_view source)
{
    return {std::move(name),
            std::move(symbol),
            std::move(key),
            std::move(rule),
            {},
            rounded(value),
            "mm",
            std::string(source),
            DesignOrigin::rule,
            ""};
}

void add_steel(Sheet& sheet, Material const& steel, DesignWishes const& given, std::string const& table,
               std::string const& member)
{
    std::string const rule = "of " + steel.name + (steel.treatment.empty() ? "" : ", " + steel.treatment);
    auto const add = [&](char const* name, char const* symbol, std::string const& key, double value, char const* unit,
                         std::string const& source, bool wish) {
        sheet.add({name + (", " + member),
                   symbol,
                   key,
                   rule,
                   {},
                   value,
                   unit,
                   source,
                   wish ? DesignOrigin::wish : DesignOrigin::rule,
                   ""});
    };
    if (steel.yield > 0)
        add("yield strength", "sigma_s", "", steel.yield, "MPa", steel.strength_source, false);
    // a scene judges its wall by the usual steel unless it says otherwise
    bool const unusual = table == "flexspline.cup" && steel.fatigue != usual_fatigue_strength;
    add("fatigue strength", "sigma_-1", unusual ? table + ".fatigue_strength" : "", steel.fatigue, "MPa",
        steel.fatigue_source, given.fatigue.has_value());
    add("modulus of elasticity", "E", table + ".youngs_modulus", steel.youngs_modulus, "MPa", steel.elastic_source,
        given.youngs_modulus.has_value());
    add("Poisson's ratio", "nu", table + ".poissons_ratio", steel.poissons_ratio, "1", steel.elastic_source,
        given.poissons_ratio.has_value());
}

/// The ring is wider than its teeth, which lie inside those of the flexspline.
void add_spline_rows(Sheet& sheet, DesignWishes const& wishes, ConeNeed const& cone)
{
    double const teeth = sheet["L_2"];
    constexpr double share_of_teeth = 7.0 / 8, wider_from = 2, wider_to = 3;
    // Cups from a fifth of the diameter on move at most 1.84 times end_shift(); w_0 is about m.
    double const pulled_back = 2 * drive::end_shift(sheet["d_r"] / 2, sheet["m"], 2, sheet["L"]);
    double const inside = std::min(share_of_teeth * teeth, teeth - 2 * pulled_back);
    RangeRule const width{"L_2", {1, 1}, {wider_from, wider_to}};
    sheet.add({"width of the circular spline", "b_g", "", "L_2 + (2 ... 3) mm", width(teeth),
               rounded(teeth + wider_from), "mm", "thesis (4-5)", DesignOrigin::rule,
               "type-50 has L_2 - 1, against the rule", width});
    sheet.add(equation("width of its toothing", "", "circular_spline.width",
                       "7/8 L_2, at most L_2 - d_r m/(2 L), inside the flexspline's teeth", inside,
                       "type-50; axial movement of bent cups"));
    bool const for_cone = cone.clearance > wishes.clearance;
    sheet.add({"side clearance", "", "circular_spline.backlash_offset",
               for_cone ? "teeth of the coned cup clear over a turn" : "as asked for",
               for_cone ? std::optional(DesignRange{cone.clearance, DesignRange().high}) : std::nullopt,
               for_cone ? cone.clearance : wishes.clearance, "mm", for_cone ? "load" : "wish",
               for_cone ? DesignOrigin::computed : DesignOrigin::wish,
               for_cone ? "the coned cup needs " + short_number(cone.clearance) + " mm to clear, more than --clearance"
                        : ""});
    add_steel(sheet, spline_material(), {}, "circular_spline", "circular spline");
}

void add_bearing_rows(Sheet& sheet)
{
    constexpr double share_of_teeth = 6.0 / 8, share_of_diameter = 1.2 / 50;
    std::string const why = "the thesis does not give the bearing: an assumption to vary";
    sheet.add({"bearing",
               "",
               "bearing.type",
               "outer ring on balls",
               {},
               std::string("elastic"),
               "",
               "type-50",
               DesignOrigin::assumption,
               why});
    for (auto row :
         {equation("width of the bearing", "", "bearing.width", "3/4 L_2", share_of_teeth * sheet["L_2"], "type-50"),
          equation("thickness of its outer ring", "", "bearing.ring_thickness", "0.024 d_r",
                   share_of_diameter * sheet["d_r"], "type-50")}) {
        row.origin = DesignOrigin::assumption;
        sheet.add(std::move(row));
    }
}

}  // namespace

void add_body_rows(Sheet& sheet, DesignWishes const& wishes, double wall, ConeNeed const& cone)
{
    Body(sheet, wall, wishes.torque.has_value())();
    DesignRow inner =
        equation("inner diameter of the flexspline", "d_rn", "", "d_rf - 2 delta, d_rf = d_r - 2 h_f", 0, table_4_1);
    inner.value = rounded(sheet["d_r"] - 2 * sheet["h_f"] - 2 * sheet["delta"], six_digits);
    inner.remark = "type-50 has 50.35, which is no d_rf - 2 delta = 47.994: larger than the root circle";
    sheet.add(std::move(inner));
    sheet.add(equation("radius of the clamped flange", "", "flexspline.cup.flange_radius", "d_1/2", sheet["d_1"] / 2,
                       table_4_1));
    add_steel(sheet, material_of(wishes), wishes, "flexspline.cup", "flexspline");
    add_spline_rows(sheet, wishes, cone);
    add_bearing_rows(sheet);
    if (wishes.torque)
        add_load_rows(sheet, *wishes.torque);
}

}  // namespace hdconj::design
