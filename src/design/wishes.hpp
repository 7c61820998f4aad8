// SPDX-License-Identifier: GPL-3.0-or-later
// What wishes say by themselves: numbers of teeth, module, material.
#pragma once

#include "hdconj/design.hpp"

namespace hdconj::design {

/// Mechanical properties of a steel.
struct Material
{
    std::string name, treatment;
    double tensile = 0;         ///< sigma_b [MPa]; 0: not given
    double yield = 0;           ///< sigma_s [MPa]; 0: not given
    double fatigue = 0;         ///< sigma_-1, alternating bending [MPa]
    double youngs_modulus = 0;  ///< [MPa]
    double poissons_ratio = 0;
    std::string strength_source, fatigue_source, elastic_source;
};

/// Materials of the flexspline.
[[nodiscard]] std::vector<Material> const& flexspline_materials();
/// Of the circular spline: steel 45.
[[nodiscard]] Material const& spline_material();
/// That of the wishes: a steel of the table, with the figures of the wishes in place of its own, or a steel of these
/// figures alone. @pre check_design() finds no fault with it
[[nodiscard]] Material material_of(DesignWishes const& wishes);

/// The largest stress that the wishes allow: fatigue strength over safety [MPa].
[[nodiscard]] double allowed_stress(DesignWishes const& wishes);

/// Waves of the wave generator, and teeth that the circular spline has more.
inline constexpr int waves = 2;

/// Lengths of a cup over its pitch diameter.
inline constexpr DesignRange length_ratios{0.2, 1};
/// Fatigue strengths of metals [MPa].
inline constexpr DesignRange fatigue_strengths{10, 5000};
/// Pitch diameters for which the rules hold [mm].
inline constexpr DesignRange diameters{10, 400};
/// Ratios of one stage.
inline constexpr DesignRange ratios{30, 320};

/// Whether two pitch diameters are the same within what six digits tell.
[[nodiscard]] bool agree(double a, double b);

/// Teeth of the flexspline: z_f = i (z_c - z_f).
[[nodiscard]] int teeth_of(DesignWishes const& wishes);
/// The module: as asked for, else the standard one nearest to diameter/z_f.
[[nodiscard]] double module_of(DesignWishes const& wishes);

}  // namespace hdconj::design
