// SPDX-License-Identifier: GPL-3.0-or-later
// What wave generator families are built from.
#pragma once

#include <string>
#include <string_view>
#include <utility>

#include "hdconj/error.hpp"
#include "hdconj/scene/parameter_fault.hpp"
#include "hdconj/scene/parameters.hpp"

namespace hdconj::wavegen {

/// The drive that a family deforms.
struct WaveGeneratorPlace
{
    double r_m = 0;      ///< radius of the undeformed neutral curve [mm]
    int waves = 2;       ///< n
    std::string folder;  ///< where relative file names start
};

/// The key that most families share.
inline constexpr std::string_view radial_deformation = "radial_deformation";

/// Keys of the family "wanted".
inline constexpr std::string_view major_displacement = "major_displacement";
inline constexpr std::string_view inner_distance = "inner_distance";

[[nodiscard]] inline scene::ParameterSpec radial_deformation_key()
{
    return {radial_deformation, scene::Quantity::positive_length, "largest radial deformation w0 of the neutral curve"};
}

/// The fault of a family that has no shape with this number of waves.
[[nodiscard]] inline Fault waves_fault(scene::FamilyChoice const& choice, int waves, std::string reason,
                                       std::string remedy)
{
    return {choice.path + ".waves", choice.line, std::to_string(waves), std::move(reason), std::move(remedy)};
}

}  // namespace hdconj::wavegen
