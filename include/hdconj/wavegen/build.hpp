// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// What wave generator families are built from.
#pragma once

#include <string>
#include <string_view>
#include <utility>

#include "hdconj/scene/fault.hpp"
#include "hdconj/scene/parameters.hpp"

namespace hdconj {

/// What a family is told about the drive it deforms.
struct WaveGeneratorPlace
{
    double r_m = 0;      ///< radius of the undeformed neutral curve [mm]
    int waves = 2;       ///< n
    std::string folder;  ///< where relative file names start
};

/// The key that most families share.
inline constexpr std::string_view radial_deformation = "radial_deformation";

[[nodiscard]] inline ParameterSpec radial_deformation_key()
{
    return {radial_deformation, Quantity::positive_length, "largest radial deformation w0 of the neutral curve"};
}

/// Adds the fault that a family has no shape with this number of waves. @returns whether there was one
inline bool refuse_waves(FamilyChoice const& choice, int waves, std::string reason, std::string remedy, Faults& faults)
{
    faults.push_back({choice.path + ".waves", choice.line, std::to_string(waves), std::move(reason), std::move(remedy)});
    return true;
}

/// Adds the fault that the key @p key of @p choice has a value this family cannot use.
inline void refuse_key(FamilyChoice const& choice, std::string_view key, std::string reason, std::string remedy, Faults& faults)
{
    faults.push_back({choice.path + "." + std::string(key), choice.line_of(key), choice.text_of(key), std::move(reason), std::move(remedy)});
}

}  // namespace hdconj
