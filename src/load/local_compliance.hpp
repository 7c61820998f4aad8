// SPDX-License-Identifier: GPL-3.0-or-later
// Local compliance of flank contacts.
#pragma once

#include <cstddef>
#include <vector>

#include "elastic_drive.hpp"

namespace hdconj::load {

/// Compliance of flank contacts beside that of the cup: Hertz approach and bending of the tooth as secants, indentation
/// of bodies that flow as tangents. (With secants of what is quadratic in the force, iterations alternate for ever.)
struct LocalCompliance
{
    std::vector<double> own;     ///< of each contact [mm/N]
    std::vector<double> offset;  ///< approach of the tangents without force [mm]: 0 for elastic contacts, else below 0
    /// Compliance between two contacts of one flank and slice: strips on one half-plane, and bending of their tooth.
    struct Coupling
    {
        std::size_t first, second;
        double compliance;  ///< [mm/N]
    };
    std::vector<Coupling> couplings;

    /// Approach of each contact under @p force [mm].
    [[nodiscard]] std::vector<double> operator()(std::vector<double> const& force) const;
};

/// @param force  of each contact, at which secants and tangents are taken; where it is zero, a line load of 1 N/mm
/// stands for it
[[nodiscard]] LocalCompliance local_compliance(ElasticDrive const& drive, std::vector<FlankContact> const& contacts,
                                               std::vector<double> const& force);

}  // namespace hdconj::load
