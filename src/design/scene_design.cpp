// SPDX-License-Identifier: GPL-3.0-or-later
// The wishes that a scene stands for, and the scene beside the design that they make.
#include <algorithm>
#include <cmath>
#include <map>

#include "base/text.hpp"
#include "hdconj/design.hpp"
#include "hdconj/error.hpp"
#include "hdconj/units.hpp"
#include "mesh_search.hpp"
#include "same_value.hpp"
#include "wishes.hpp"

namespace hdconj {
namespace {

using design::agree;

/// What keeps @p scene from being what wishes make.
Faults unlike_wishes(Scene const& scene)
{
    Faults faults;
    auto const fault = [&](char const* path, std::string value, char const* reason, char const* remedy) {
        faults.push_back({path, 0, std::move(value), reason, remedy});
    };
    Drive const& drive = scene.drive;
    int const difference = drive.circular_spline_teeth - drive.flexspline_teeth, waves = scene.wave_generator.waves;
    if (difference != design::waves)
        fault("drive.circular_spline_teeth", std::to_string(drive.circular_spline_teeth),
              "the rules are for two teeth more than the flexspline has",
              "leave design out, or write z_c = z_f + 2 in the scene");
    if (waves != design::waves)
        fault("wave_generator.waves", std::to_string(waves), "the rules are for two waves",
              "leave design out, or write waves = 2 in the scene");
    if (scene.is_reverse())
        fault("circular_spline.profile.family", in_quotes(scene.circular_spline.profile->family),
              "the rules are for a given tooth of the flexspline, and here that of the circular spline is given",
              "leave design out");
    if (scene.flexspline.profile.family == "points")
        fault("flexspline.profile.family", in_quotes(scene.flexspline.profile.family),
              "points come from a measured tooth, and no rule gives them", "leave design out");
    return faults;
}

double pitch_diameter(Drive const& drive)
{
    return drive.module * drive.flexspline_teeth;
}

/// The drive's value of a row that no key of the scene holds.
std::optional<double> figure_of(DesignRow const& row, Solution const& drive)
{
    Drive const& pair = drive.scene.drive;
    if (row.symbol == "i")
        return static_cast<double>(pair.flexspline_teeth) / (pair.circular_spline_teeth - pair.flexspline_teeth);
    if (row.symbol == "d_r")
        return pitch_diameter(pair);
    if (row.symbol == "d_rn")
        return 2 * drive.geometry.flexspline_inner_radius;
    if (row.name == design::length_ratio_row && drive.scene.flexspline.cup)
        return drive.scene.flexspline.cup->length / pitch_diameter(pair);
    design::MeshFigures const mesh(drive);
    if (row.name == design::spline_land_row)
        return mesh.land;
    if (row.name == design::flank_contact_row)
        return mesh.flank_contact;
    if (row.name == design::lost_row)
        return mesh.lost;
    return std::nullopt;
}

/// Whether @p value lies in @p range, ends as exact as drawings have them.
bool lies_in(DesignRange const& range, double value)
{
    return range.contains(value) || agree(value, range.low) || (std::isfinite(range.high) && agree(value, range.high));
}

/// Where @p beside, of which all but the standing is known, stands against @p row.
RuleStanding standing_of(DesignRow const& row, ComparedRow const& beside)
{
    if (beside.here.empty())
        return row.key.empty() ? RuleStanding::no_key : RuleStanding::unstated;
    bool const same = design::same_value(row.written(), beside.here);
    auto const number = leading_number(beside.here);
    if (!beside.range || !number || !number->rest.empty())
        return same ? RuleStanding::as_proposed : RuleStanding::differs;
    bool const inside = lies_in(*beside.range, number->value);
    return inside ? (same ? RuleStanding::as_proposed : RuleStanding::within)
                  : (same ? RuleStanding::limited : RuleStanding::outside);
}

/// The drive's value of @p row as a scene writes it; empty: none.
std::string value_here(DesignRow const& row, Solution const& drive)
{
    constexpr int digits = 4;  // as the design has its own
    if (row.key.empty()) {
        auto const figure = figure_of(row, drive);
        return figure ? short_number(*figure, row.origin == DesignOrigin::figure ? digits : 6) : "";
    }
    auto const there = drive.scene.given.find(row.key);
    return there != drive.scene.given.end() ? there->second.written
                                            : design::standard_value(row.key).value_or(std::string());
}

/// A drive's rows beside those of its design. Ranges that are shares of another dimension are those of the drive's own.
std::vector<ComparedRow> compared(std::vector<DesignRow> const& rows, Solution const& drive)
{
    std::vector<ComparedRow> all;
    std::map<std::string, double> own;  // by symbol
    for (DesignRow const& row : rows) {
        ComparedRow beside{value_here(row, drive), RuleStanding::no_key, row.range};
        if (row.range && row.range_rule)
            if (auto const base = own.find(row.range_rule->base); base != own.end())
                beside.range = (*row.range_rule)(base->second);
        beside.standing = standing_of(row, beside);
        if (auto const number = leading_number(beside.here); number && number->rest.empty())
            own.emplace(row.symbol, number->value);
        all.push_back(std::move(beside));
    }
    return all;
}

/// A scene has the figures of its steel, and no name.
template <class Tell>
void tell_steel(Scene const& scene, DesignWishes& wishes, Tell const& tell)
{
    auto const& cup = scene.flexspline.cup;
    auto const& steels = design::flexspline_materials();
    bool const is_usual = !cup || cup->fatigue_strength == usual_fatigue_strength;
    auto const known =
        is_usual ? steels.end() : std::ranges::find(steels, cup->fatigue_strength, &design::Material::fatigue);
    if (known != steels.end())
        wishes.material = known->name;
    tell("--material", wishes.material,
         known != steels.end() ? "the steel of flexspline.cup.fatigue_strength"
                               : "the standard value: a scene names no steel");
    if (!cup)
        return;
    design::Material const steel = design::material_of(wishes);
    auto const own = [&](char const* option, std::optional<double>& wish, double here, double of_steel,
                         char const* key) {
        if (here == of_steel)
            return;
        wish = here;
        tell(option, number_text(here), key);
    };
    own("--fatigue", wishes.fatigue, cup->fatigue_strength, steel.fatigue, "flexspline.cup.fatigue_strength");
    own("--youngs-modulus", wishes.youngs_modulus, cup->youngs_modulus, steel.youngs_modulus,
        "flexspline.cup.youngs_modulus");
    own("--poissons-ratio", wishes.poissons_ratio, cup->poissons_ratio, steel.poissons_ratio,
        "flexspline.cup.poissons_ratio");
}

}  // namespace

DesignWishes wishes_of(Scene const& scene, std::vector<DerivedWish>* derived)
{
    throw_if_any(unlike_wishes(scene));
    std::vector<DerivedWish> unseen;
    std::vector<DerivedWish>& told = derived != nullptr ? *derived : unseen;
    auto const tell = [&](char const* option, std::string value, std::string from) {
        told.push_back({option, std::move(value), std::move(from)});
    };
    DesignWishes wishes;
    Drive const& drive = scene.drive;
    wishes.name = drive.name;
    wishes.ratio = static_cast<double>(drive.flexspline_teeth) / design::waves;
    tell("--ratio", short_number(wishes.ratio), "z_f/(z_c - z_f)");
    wishes.module = drive.module;
    tell("--module", number_text(drive.module), "drive.module");
    auto const& cup = scene.flexspline.cup;
    if (cup)
        wishes.length_ratio = design::rounded(cup->length / pitch_diameter(drive), 6);
    tell("--length-ratio", short_number(wishes.length_ratio),
         cup ? "flexspline.cup.length over m z_f" : "the standard value: the scene has no [flexspline.cup]");
    if (scene.load)
        wishes.torque = scene.load->torque;
    tell(
        "--torque", wishes.torque ? short_number(*wishes.torque / newton_metre) : "",
        wishes.torque ? "load.torque" : "left out: the scene has no load.torque, and the wall follows the rules alone");
    wishes.family = scene.flexspline.profile.family;
    tell("--family", wishes.family, "flexspline.profile.family");
    tell_steel(scene, wishes, tell);
    wishes.clearance = scene.circular_spline.backlash_offset;
    tell("--clearance", number_text(wishes.clearance),
         scene.circular_spline.automatic_backlash ? "the standard value: circular_spline.backlash_offset is \"auto\""
                                                  : "circular_spline.backlash_offset");
    tell("--land", short_number(wishes.land), "the standard value: no scene holds it");
    tell("--safety", short_number(wishes.safety), "the standard value: no scene holds it");
    return wishes;
}

SceneDesign design_beside(Solution const& drive)
{
    SceneDesign made;
    DesignWishes const wishes = wishes_of(drive.scene, &made.derived);
    made.design = design_drive(wishes);
    made.design.other = drive.scene.drive.name;
    made.design.differences = differences(made.design, drive.scene);
    made.here = compared(made.design.rows, drive);
    return made;
}

}  // namespace hdconj
