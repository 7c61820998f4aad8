// SPDX-License-Identifier: GPL-3.0-or-later
#include "nearest_wishes.hpp"

#include <algorithm>
#include <cmath>

#include "base/text.hpp"
#include "hdconj/units.hpp"
#include "sheet.hpp"
#include "wishes.hpp"

namespace hdconj::design {
namespace {

bool has_mesh(DesignWishes const& wishes)
{
    return check_design(wishes).empty() && has_mesh_with_wall(wishes);
}

/// The value nearest to @p asked with which there is a mesh, between it and @p easiest, to three digits; nothing where
/// not even that one does.
template <class Enter>
std::optional<double> nearest_value(DesignWishes wishes, double asked, double easiest, Enter enter)
{
    constexpr int most_halvings = 16;
    auto const works = [&](double value) {
        enter(wishes, value);
        return has_mesh(wishes);
    };
    if (asked == easiest || !works(easiest))
        return std::nullopt;
    double refused = asked, accepted = easiest;
    for (int i = 0; i < most_halvings; ++i) {
        double const middle = rounded((refused + accepted) / 2);
        if (middle == refused || middle == accepted)
            break;
        (works(middle) ? accepted : refused) = middle;
    }
    return accepted;
}

Fault fault_of(char const* option, std::string asked, std::string const& reason, std::string const& nearest)
{
    return {option, 0, std::move(asked), reason, "the nearest that works is " + nearest};
}

/// The weakest steel of the table with the fatigue strength @p least; nothing where none has it, or where another
/// modulus would change the stress.
std::optional<std::string> stronger_steel(DesignWishes const& wishes, double least)
{
    std::optional<Material> best;
    Material const asked = material_of(wishes);
    for (Material const& each : flexspline_materials())
        if (each.fatigue >= least && each.youngs_modulus == asked.youngs_modulus &&
            each.poissons_ratio == asked.poissons_ratio && (!best || each.fatigue < best->fatigue))
            best = each;
    return best ? std::optional(best->name) : std::nullopt;
}

/// Adds the steel or the figure that has the fatigue strength @p least; a figure of the wishes goes before the steel's.
void add_strength(DesignWishes const& wishes, double least, std::string const& reason, Faults& faults)
{
    auto const steel = wishes.fatigue ? std::nullopt : stronger_steel(wishes, least);
    if (steel)
        faults.push_back(fault_of("--material", printable(wishes.material), reason, *steel));
    else if (fatigue_strengths.contains(least) && (wishes.fatigue || faults.empty()))
        faults.push_back(
            fault_of("--fatigue", wishes.fatigue ? short_number(*wishes.fatigue) : "", reason, short_number(least)));
}

Faults nearest_mesh(DesignWishes const& wishes, MeshChoice const& failed)
{
    Faults faults;
    std::string const reason = usual_refusal(failed);
    auto const try_between = [&](char const* option, double asked, double easiest, auto enter) {
        if (auto const value = nearest_value(wishes, asked, easiest, enter))
            faults.push_back(fault_of(option, short_number(asked), reason, short_number(*value)));
    };
    constexpr double accepted_land = 0.2;
    try_between("--land", wishes.land, std::min(wishes.land, accepted_land),
                [](DesignWishes& changed, double value) { changed.land = value; });
    try_between("--clearance", wishes.clearance, 0.0,
                [](DesignWishes& changed, double value) { changed.clearance = value; });
    try_between("--safety", wishes.safety, 1.0, [](DesignWishes& changed, double value) { changed.safety = value; });
    if (std::ranges::any_of(failed.trials, &MeshTrial::wall_stress))
        if (auto const stress = least_bending_with_wall(wishes))
            add_strength(wishes, rounded_up(wishes.safety * *stress), reason, faults);
    DesignWishes other = wishes;
    other.family = DesignWishes().family;
    if (other.family != wishes.family && has_mesh(other))
        faults.push_back(fault_of("--family", wishes.family, reason, other.family));
    if (!faults.empty())
        return faults;
    for (auto const& [option, value] :
         {std::pair{"--ratio", wishes.ratio}, std::pair{"--land", wishes.land},
          std::pair{"--clearance", wishes.clearance}, std::pair{"--safety", wishes.safety}})
        faults.push_back({option, 0, short_number(value), reason,
                          "change it together with the others; `hdconj design --ratio 100 --diameter 50` works"});
    return faults;
}

/// What to write, of @p ways that can be followed: "write a, b or c".
std::string write_one_of(std::vector<std::string> const& ways)
{
    std::string text = "write ";
    for (std::size_t i = 0; i < ways.size(); ++i)
        text += (i == 0 ? "" : i + 1 < ways.size() ? ", " : " or ") + ways[i];
    return text;
}

/// No wall has a mesh that is clear of the coned cup; that of the best fails for @p reason.
Fault too_much_cone(DesignWishes const& wishes, std::string const& reason, OtherWishes const& others)
{
    if (auto const length = others.least_length())
        return fault_of("--length-ratio", short_number(wishes.length_ratio), reason, short_number(*length));
    return {"--family", 0, wishes.family, reason,
            wishes.land > 0 ? "write a smaller --land or another --family" : "write another --family"};
}

/// The largest safety of hundredths that the stress @p stress leaves.
double safety_at(DesignWishes const& wishes, double stress)
{
    constexpr double hundredths = 100;
    return std::floor(hundredths * material_of(wishes).fatigue / stress) / hundredths;
}

/// Adds what helps a cup that is bent too far without any torque.
/// @param assembled  stress without torque of the wall that has the least
/// @param most       stress of the best wall under the torque
void add_bent(DesignWishes const& wishes, double assembled, double most, std::string const& reason, Faults& faults)
{
    std::string const smaller = ", with a smaller --torque";
    double const safety = std::min(safety_at(wishes, assembled), wishes.safety);
    if (safety > 1)
        faults.push_back(
            {"--safety", 0, short_number(wishes.safety), reason, "write less than " + short_number(safety) + smaller});
    auto const steel = wishes.fatigue ? std::nullopt : stronger_steel(wishes, wishes.safety * assembled);
    if (steel && std::ranges::find(faults, "--material", &Fault::path) == faults.end())
        faults.push_back({"--material", 0, printable(wishes.material), reason, "write " + *steel + smaller});
    if (safety > 1 || steel)
        return;
    if (faults.empty())
        add_strength(wishes, rounded_up(wishes.safety * most), reason, faults);
    faults.push_back(
        {"--ratio", 0, short_number(wishes.ratio), reason, "write a larger one, which bends the cup less"});
}

/// What helps where no torque worth naming is stood.
std::string larger_drive(DesignWishes const& wishes)
{
    std::vector<std::string> ways;
    if (module_of(wishes) * teeth_of(wishes) < diameters.high)
        ways.emplace_back(!wishes.module    ? "a larger --diameter"
                          : wishes.diameter ? "a larger --diameter with a larger --module"
                                            : "a larger --module");
    if (wishes.ratio < ratios.high)
        ways.emplace_back("a larger --ratio");
    return ways.empty() ? "write a smaller one" : write_one_of(ways) + ", which bends the wall less";
}

Faults nearest_load(DesignWishes const& wishes, MeshedSheet const& failed, OtherWishes const& others)
{
    constexpr double usual = 0.5;  // of the torque asked for: less is another drive
    WallTrial const& best = failed.walls.back();
    std::string const refusal = "with the best wall, " + short_number(best.wall) + " mm: " + best.refusal;
    if (best.interferes)
        return {too_much_cone(wishes, refusal, others)};
    bool const is_bent_too_far = best.assembled > allowed_stress(wishes);  // without torque
    std::string const reason = refusal + (is_bent_too_far ? ", even without torque" : "");
    Faults faults;
    auto const torque = others.most_torque();
    if (torque)
        faults.push_back(fault_of("--torque", short_number(*wishes.torque / newton_metre), reason,
                                  short_number(*torque / newton_metre)));
    if (!torque || *torque < usual * *wishes.torque)
        if (auto const length = others.least_length())
            faults.push_back(
                fault_of("--length-ratio", short_number(wishes.length_ratio), reason, short_number(*length)));
    double const most = std::max(best.assembled, best.loaded), safety = most > 0 ? safety_at(wishes, most) : 0;
    if (safety >= 1 && safety < wishes.safety)
        faults.push_back(fault_of("--safety", short_number(wishes.safety), reason, short_number(safety)));
    bool const has_helped = !faults.empty();
    double const least = rounded_up(wishes.safety * most);
    if (most > 0 && (wishes.fatigue || stronger_steel(wishes, least)))
        add_strength(wishes, least, reason, faults);
    if (is_bent_too_far && !has_helped) {
        double assembled = best.assembled;
        for (WallTrial const& each : failed.walls)
            if (!each.interferes && each.assembled > 0)
                assembled = std::min(assembled, each.assembled);
        add_bent(wishes, assembled, most, reason, faults);
    }
    if (faults.empty())
        faults.push_back({"--torque", 0, short_number(*wishes.torque / newton_metre), reason, larger_drive(wishes)});
    return faults;
}

}  // namespace

Faults nearest_wishes(DesignWishes const& wishes, MeshedSheet const& failed, OtherWishes const& others)
{
    return failed.mesh.best ? nearest_load(wishes, failed, others) : nearest_mesh(wishes, failed.mesh);
}

}  // namespace hdconj::design
