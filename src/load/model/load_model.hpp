// SPDX-License-Identifier: GPL-3.0-or-later
// The elastic drive of a scene.
#pragma once

#include <memory>
#include <vector>

#include "contact/study/contact_context.hpp"
#include "elastic/harmonic_field.hpp"
#include "elastic/section_mesh.hpp"
#include "load/elastic_drive.hpp"

namespace hdconj::load {

/// An elastic drive with the cup that it is made of.
struct LoadModel
{
    elastic::FourierSolid solid;
    std::shared_ptr<elastic::UnitFields const> unit;  ///< of the drive's stations but for the turns
    double radius;                                    ///< at which turns are taken [mm]
    double middle;                                    ///< of the bearing above the cup's bottom [mm]
    elastic::CupSection section;                      ///< of the cup, without teeth
    ElasticDrive drive;
};

/// Resolution of the model.
struct LoadGrid
{
    std::vector<std::size_t> slices;  ///< indices among those of the context, increasing
    int circles = 0;                  ///< over the bearing's width
    int harmonics = 0;                ///< highest
    int layers = 1;                   ///< elements across the cup's wall, at least
};

/// The resolution that the scene asks for.
[[nodiscard]] LoadGrid load_grid(contact::ContactContext const& context);

/// Cup, wave generator and teeth of @p context as `load` needs them.
/// @throws NumericalError for a cup that cannot be meshed or a drive with too many teeth for the memory that a load
/// takes
[[nodiscard]] LoadModel load_model(contact::ContactContext const& context, LoadGrid const& resolution);

/// The drive of @p model after the wave generator has turned: tooth 0 stands at the undeformed angle @p phase [rad].
/// What a unit force does to the cup stays as it is; the wave generator is placed anew.
[[nodiscard]] ElasticDrive drive_at(LoadModel const& model, contact::ContactContext const& context,
                                    LoadGrid const& resolution, double phase);

}  // namespace hdconj::load
