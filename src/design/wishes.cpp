// SPDX-License-Identifier: GPL-3.0-or-later
#include "wishes.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <variant>

#include "base/text.hpp"
#include "hdconj/base/suggest.hpp"
#include "hdconj/profile/registry.hpp"
#include "hdconj/scene/schema.hpp"
#include "hdconj/units.hpp"
#include "scene/validation.hpp"
#include "sheet.hpp"

namespace hdconj {
namespace design {
namespace {

/// DIN 780-1, both series [mm].
constexpr std::array standard_modules{0.05, 0.055, 0.06, 0.07, 0.08, 0.09,  0.1,  0.11,  0.12, 0.14, 0.16, 0.18, 0.2,
                                      0.22, 0.25,  0.28, 0.3,  0.35, 0.4,   0.45, 0.5,   0.55, 0.6,  0.65, 0.7,  0.75,
                                      0.8,  0.85,  0.9,  0.95, 1.0,  1.125, 1.25, 1.375, 1.5,  1.75, 2.0,  2.25, 2.5,
                                      2.75, 3.0,   3.5,  4.0,  4.5,  5.0,   5.5,  6.0,   7.0,  8.0,  9.0,  10.0};

constexpr DesignRange modules{0.05, 10};  // [mm]
constexpr char rule_of_diameters[] = "the rules hold for pitch diameters from 10 to 400 mm";
constexpr char rule_of_modules[] = "standard modules run from 0.05 to 10 mm";

double nearest_module(double wanted)
{
    return *std::min_element(standard_modules.begin(), standard_modules.end(),
                             [&](double a, double b) { return std::abs(a - wanted) < std::abs(b - wanted); });
}

class WishFaults
{
  public:
    explicit WishFaults(DesignWishes const& wishes) : wishes_(wishes) {}

    Faults operator()()
    {
        ratio();
        size();
        within("--length-ratio", wishes_.length_ratio, length_ratios, "a cup's length is 0.2 to 1 pitch diameters");
        within("--land", wishes_.land, {0, 0.8},
               "a tip land of at least 0 to 0.8 modules can be asked for; lands may come out wider");
        within("--safety", wishes_.safety, {1, 10}, "below 1 the cup breaks, above 10 no wall is thin enough");
        if (wishes_.torque && positive("--torque", *wishes_.torque / newton_metre, "write a torque in N m such as 28"))
            within("--torque", *wishes_.torque / newton_metre,
                   {scene::bounds::least_torque, scene::bounds::largest_torque},
                   "outside the range of load.torque, in N m");
        if (!(wishes_.clearance >= 0) || !std::isfinite(wishes_.clearance))
            fault("--clearance", short_number(wishes_.clearance), "no side clearance", "write 0 or a length in mm");
        words();
        name();
        return std::move(faults_);
    }

  private:
    void fault(std::string path, std::string value, std::string reason, std::string remedy)
    {
        faults_.push_back({std::move(path), 0, std::move(value), std::move(reason), std::move(remedy)});
    }
    bool positive(char const* path, double value, char const* remedy)
    {
        bool const fine = value > 0 && std::isfinite(value);
        if (!fine)
            fault(path, short_number(value), "not a number above 0", remedy);
        return fine;
    }
    void within(char const* path, double value, DesignRange const& range, char const* reason)
    {
        if (!range.contains(value))
            fault(path, short_number(value), reason,
                  "the nearest that works is " + short_number(value > range.high ? range.high : range.low));
    }
    void ratio()
    {
        std::size_t const before = faults_.size();
        within("--ratio", wishes_.ratio, ratios, "one stage has a ratio from 30 to 320");
        has_ratio_ = faults_.size() == before;
        if (has_ratio_ && wishes_.ratio != std::round(wishes_.ratio))
            fault("--ratio", number_text(wishes_.ratio),
                  "two waves need even numbers of teeth, z_f = 2 i and z_c = z_f + 2, so that i is a whole number",
                  "the nearest that works is " + short_number(std::round(wishes_.ratio)));
    }
    void size()
    {
        if (!wishes_.diameter && !wishes_.module)
            return fault("--diameter", "", "neither a pitch diameter nor a module is given",
                         "write --diameter 50, or --module 0.25");
        bool const has_diameter =
            wishes_.diameter && positive("--diameter", *wishes_.diameter, "write a length in mm such as 50");
        bool const has_module =
            wishes_.module && positive("--module", *wishes_.module, "write a length in mm such as 0.25");
        if (has_ratio_)
            size_of_teeth(has_diameter, has_module);
        else if (has_diameter)
            within("--diameter", *wishes_.diameter, diameters, rule_of_diameters);
        if (!has_ratio_ && has_module)
            within("--module", *wishes_.module, modules, rule_of_modules);
    }
    /// Module and pitch diameter beside each other, with teeth whose number is known.
    void size_of_teeth(bool has_diameter, bool has_module)
    {
        int const teeth = teeth_of(wishes_);
        constexpr int digits = 6, exact = 9;  // digits that agree() tells apart
        DesignRange const usable{std::max(modules.low, diameters.low / teeth),
                                 std::min(modules.high, diameters.high / teeth)};
        std::string const works = "the nearest that works is ";
        double const m = has_module ? *wishes_.module : has_diameter ? *wishes_.diameter / teeth : usable.low;
        double const nearest = m < usable.low ? rounded_up(usable.low, digits) : rounded_down(usable.high, digits);
        bool const fits = usable.contains(m) || (has_diameter && (agree(m, usable.low) || agree(m, usable.high)));
        if (!has_module && !fits)
            fault("--diameter", short_number(*wishes_.diameter),
                  diameters.contains(*wishes_.diameter)
                      ? "the module d_r/z_f would be " + short_number(m) + " mm, and " + rule_of_modules
                      : rule_of_diameters,
                  works + short_number(std::clamp(m, usable.low, usable.high) * teeth));
        double const asked = has_diameter ? *wishes_.diameter : m * teeth;
        bool const agrees = agree(m * teeth, asked);
        if (!has_module || (agrees && fits))
            return;
        std::string const made =
            "d_r = m z_f would be " + short_number(m * teeth) + " mm with " + std::to_string(teeth) + " teeth, ";
        std::string const reason = !modules.contains(m) ? rule_of_modules
                                   : !fits              ? made + "and " + rule_of_diameters
                                                        : made + "but --diameter is " + short_number(asked);
        std::string remedy = short_number(nearest);
        if (has_diameter && !agrees && usable.contains(asked / teeth))
            remedy = "--module " + short_number(asked / teeth, exact) +
                     (fits ? ", or --diameter " + short_number(m * teeth, exact) + ", or leave one of them out"
                           : ", or leave it out");
        else if (has_diameter && fits)
            remedy = "--diameter " + short_number(m * teeth, exact) + ", or leave it out";
        else if (has_diameter)
            remedy = "--module " + remedy + " with --diameter " + short_number(nearest * teeth, exact);
        fault("--module", short_number(m), reason, works + remedy);
    }
    void words()
    {
        std::vector<std::string_view> families, materials;
        for (auto const& family : profile::profile_families())
            if (family.name != "points")
                families.push_back(family.name);
        for (auto const& material : flexspline_materials())
            materials.push_back(material.name);
        if (wishes_.family == "points")
            fault("--family", wishes_.family, "points come from a measured tooth, and no rule gives them",
                  "write --family b-spline, a tooth by points of the scene");
        else
            one_of("--family", wishes_.family, families);
        material(materials);
    }
    /// As the scene takes it.
    void name()
    {
        scene::RawEntry given;
        given.value.kind = scene::RawValue::Kind::text;
        given.value.text = wishes_.name;
        given.value.written = in_quotes(printable(wishes_.name));
        scene::ParameterSpec const spec{"name", scene::Quantity::text, "name of the drive"};
        Scene without_files;
        auto const read = scene::validate_value(spec, "\"type-50\"", given, "name", without_files);
        if (auto const* const found = std::get_if<Faults>(&read))
            faults_.insert(faults_.end(), found->begin(), found->end());
    }
    /// A steel of the table, or the figures of another one.
    void material(std::vector<std::string_view> const& known)
    {
        if (wishes_.fatigue && positive("--fatigue", *wishes_.fatigue, "write a stress in MPa such as 550"))
            within("--fatigue", *wishes_.fatigue, fatigue_strengths,
                   "no fatigue strength of a metal in MPa: a good steel has 550");
        if (wishes_.youngs_modulus && positive("--youngs-modulus", *wishes_.youngs_modulus, "write 206000"))
            within("--youngs-modulus", *wishes_.youngs_modulus, {1000, scene::bounds::largest_modulus},
                   "no modulus of elasticity of a metal in MPa: steel has 206000");
        if (wishes_.poissons_ratio)
            within("--poissons-ratio", *wishes_.poissons_ratio, {0, scene::bounds::largest_poissons_ratio},
                   "steel has 0.3");
        bool const own = wishes_.fatigue && wishes_.youngs_modulus && wishes_.poissons_ratio;
        if (own && !wishes_.material.empty())
            return control_characters();
        std::size_t const before = faults_.size();
        one_of("--material", wishes_.material, known);
        if (faults_.size() > before)
            faults_.back().remedy += ", or give another steel by --fatigue, --youngs-modulus and --poissons-ratio";
    }
    /// The name of a steel of one's own stands in a comment of the scene.
    void control_characters()
    {
        if (std::ranges::any_of(wishes_.material, [](unsigned char c) { return std::iscntrl(c) != 0; }))
            fault("--material", printable(wishes_.material), "contains control characters", "leave them out");
    }
    void one_of(char const* path, std::string const& word, std::vector<std::string_view> const& words)
    {
        if (std::find(words.begin(), words.end(), word) != words.end())
            return;
        auto const meant = nearest(word, words);
        fault(path, printable(word), "not known: there is " + plain_list(words),
              "write " + std::string(meant.value_or(words.front())));
    }

    DesignWishes const& wishes_;
    Faults faults_;
    bool has_ratio_ = false;
};

}  // namespace

bool agree(double a, double b)
{
    constexpr double resolved = 1e-6;  // of numbers with six digits
    return std::abs(a - b) <= resolved * std::abs(b);
}

double allowed_stress(DesignWishes const& wishes)
{
    return material_of(wishes).fatigue / wishes.safety;
}

int teeth_of(DesignWishes const& wishes)
{
    return static_cast<int>(std::lround(wishes.ratio)) * waves;
}

double module_of(DesignWishes const& wishes)
{
    return wishes.module ? *wishes.module : nearest_module(*wishes.diameter / teeth_of(wishes));
}

}  // namespace design

Faults check_design(DesignWishes const& wishes)
{
    return design::WishFaults(wishes)();
}

}  // namespace hdconj
