// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The elastic drive of a scene.
#pragma once

#include <vector>

#include "contact_bench.hpp"
#include "hdconj/elastic/unit_fields.hpp"
#include "hdconj/load/elastic_drive.hpp"

namespace hdconj::detail {

/// An elastic drive with the cup that it is made of.
struct LoadModel
{
    FourierSolid solid;
    UnitFields unit;              ///< of the drive's stations but for the turns
    double radius;                ///< at which turns are taken [mm]
    double middle;                ///< of the bearing above the cup's bottom [mm]
    ElasticDrive drive;
};

/// How fine a drive is resolved.
struct LoadGrid
{
    std::vector<std::size_t> slices;  ///< of the bench, increasing
    int circles = 0;                  ///< over the bearing's width
    int harmonics = 0;                ///< highest
    int layers = 1;                   ///< elements across the cup's wall, at least
};

/// As the scene asks.
[[nodiscard]] LoadGrid load_grid(ContactBench const& bench);

/// The highest harmonic that a drive's grid of angles can tell apart.
[[nodiscard]] int highest_harmonic(Scene const& scene);

/// Cup, wave generator and teeth of @p bench as `load` needs them.
/// @throws NumericalError for a cup that cannot be meshed or a drive with too many teeth for the memory that a load takes
[[nodiscard]] LoadModel load_model(ContactBench const& bench, LoadGrid const& resolution);

}  // namespace hdconj::detail
