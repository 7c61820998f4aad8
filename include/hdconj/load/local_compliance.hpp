// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// What flank contacts give way by in themselves.
#pragma once

#include <cstddef>
#include <vector>

#include "hdconj/load/elastic_drive.hpp"

namespace hdconj {

/// What flank contacts give way by in themselves, beside the cup: Hertz and bending of the tooth, as secants at given forces.
struct LocalCompliance
{
    std::vector<double> own;  ///< of each contact [mm/N]
    /// Contacts of one flank and slice give way under each other: as strips on one half-plane, and by bending of the tooth that they stand on.
    struct Coupling
    {
        std::size_t first, second;
        double compliance;  ///< [mm/N]
    };
    std::vector<Coupling> couplings;

    /// What each contact gives way by under @p force [mm].
    [[nodiscard]] std::vector<double> operator()(std::vector<double> const& force) const;
};

/// @param force  of each contact, at which the secants are taken; where there is none, that of a line load of 1 N/mm
[[nodiscard]] LocalCompliance local_compliance(ElasticDrive const& drive, std::vector<FlankContact> const& contacts, std::vector<double> const& force);

}  // namespace hdconj
