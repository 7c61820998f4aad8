// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The wave generator of an elastic drive.
#pragma once

#include <optional>
#include <vector>

#include "contact_bench.hpp"
#include "hdconj/elastic/bearing.hpp"
#include "hdconj/elastic/influence.hpp"
#include "hdconj/load/elastic_drive.hpp"
#include "ring_grid.hpp"

namespace hdconj::detail {

/// The scene's bearing; of single balls, what a ball gives way by apart from its ring.
struct PlacedBearing
{
    Bearing bearing;
    std::vector<double> circles;             ///< at which it presses, above the cup's bottom [mm]
    double spread;                           ///< of one of its forces around the ring [rad]
    std::optional<double> ball_stiffness;    ///< [N/mm]
};

[[nodiscard]] PlacedBearing placed_bearing(ContactBench const& bench, int circles, RingGrid const& around);

[[nodiscard]] std::vector<HarmonicResponse> responses(Influence const& influence);

/// Adds the wave generator: where it may press, and how far it stands out.
/// @param highest  harmonic
void add_wave_generator(ElasticDrive& drive, PlacedBearing const& placed, ContactBench const& bench, RingGrid const& around, int highest);

}  // namespace hdconj::detail
