// SPDX-License-Identifier: GPL-3.0-or-later
// Steels of the flexspline.
#include <algorithm>

#include "base/text.hpp"
#include "wishes.hpp"

namespace hdconj::design {
namespace {

/// A quenched and tempered steel of which a standard gives the least strengths. The fatigue strength follows from the
/// tensile strength, as in DIN 743-3 for rotating bars without a notch; the elastic constants are those of ISO 6336-2.
Material tempered(char const* name, char const* treatment, double tensile, double yield, char const* standard)
{
    constexpr double fatigue_ratio = 0.5, youngs_modulus = 206e3, poissons_ratio = 0.3;
    return {name,
            treatment,
            tensile,
            yield,
            fatigue_ratio * tensile,
            youngs_modulus,
            poissons_ratio,
            standard,
            "0.5 sigma_b, DIN 743-3",
            "steel, ISO 6336-2"};
}

}  // namespace

std::vector<Material> const& flexspline_materials()
{
    static char const thin[] = "quenched and tempered, up to 16 mm";
    static std::vector<Material> const materials{
        {"30CrMnSiA", "", 1800, 1600, usual_fatigue_strength, 206e3, 0.3, "thesis Table 4-2", "thesis Table 4-2",
         "thesis 3.3"},
        tempered("40CrNiMoA", "quenched at 850, tempered at 600 deg C", 980, 835, "GB/T 3077"),
        tempered("42CrMo4", thin, 1100, 900, "EN 10083-3"),
        tempered("34CrNiMo6", thin, 1200, 1000, "EN 10083-3"),
        tempered("30CrNiMo8", thin, 1250, 1050, "EN 10083-3")};
    return materials;
}

Material const& spline_material()
{
    static Material const steel_45{"45",        "", 700, 500, 340, 210e3, 0.31, "thesis Table 4-3", "thesis Table 4-3",
                                   "thesis 3.3"};
    return steel_45;
}

Material material_of(DesignWishes const& wishes)
{
    auto const& all = flexspline_materials();
    auto const known =
        std::find_if(all.begin(), all.end(), [&](Material const& each) { return each.name == wishes.material; });
    Material made = known != all.end() ? *known : Material{};
    made.name = printable(wishes.material);
    if (wishes.fatigue) {
        made.fatigue = *wishes.fatigue;
        made.fatigue_source = "wish";
    }
    made.youngs_modulus = wishes.youngs_modulus.value_or(made.youngs_modulus);
    made.poissons_ratio = wishes.poissons_ratio.value_or(made.poissons_ratio);
    if (wishes.youngs_modulus || wishes.poissons_ratio)
        made.elastic_source = "wish";
    return made;
}

}  // namespace hdconj::design
