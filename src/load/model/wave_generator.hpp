// SPDX-License-Identifier: GPL-3.0-or-later
// The wave generator of an elastic drive.
#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "contact/study/contact_context.hpp"
#include "elastic/ball_line.hpp"
#include "elastic/bearing.hpp"
#include "elastic/influence.hpp"
#include "hdconj/scene.hpp"
#include "load/elastic_drive.hpp"

namespace hdconj::load {

/// Even angles around the ring: those of the teeth, and more where they are few.
struct RingGrid
{
    int lobes;       ///< how often teeth and lobes repeat around the ring
    int sectors;     ///< and single balls and errors of the teeth with them
    int per_sector;  ///< teeth
    int steps;       ///< from tooth to tooth

    [[nodiscard]] int angles() const { return per_sector * steps; }
    /// The highest harmonic that these angles resolve.
    [[nodiscard]] int highest_harmonic() const { return angles() * sectors / 2; }
    /// Of the harmonics up to @p asked the highest one that the ring has.
    [[nodiscard]] int highest_harmonic(int asked) const
    {
        return std::min(asked, highest_harmonic()) / sectors * sectors;
    }
};

/// The angles of the teeth, or a few times as many: with those of some that let most contacts of the bearing be even.
[[nodiscard]] RingGrid ring_grid(Scene const& scene);

/// Angles of a sector at which the bearing may press on the cup: even where nearly as many as harmonics up to
/// @p highest resolve part a lobe evenly, else as even as the angles allow. Steps of the grid. They are their own
/// mirror image, so that a mirrored drive has the mirrored balance.
[[nodiscard]] std::vector<int> bearing_steps(RingGrid const& around, int highest);

/// The scene's bearing with the places where it presses on the cup.
struct PlacedBearing
{
    elastic::Bearing bearing;
    std::vector<double> circles;  ///< heights of its contacts above the cup's bottom [mm]
    double spread;  ///< angle over which one of its forces acts, on coarser grids too: the mean way from one contact
                    ///< to the next with the harmonics of the scene [rad]
    std::optional<double> ball_stiffness;  ///< of a single ball without its ring [N/mm]
    std::optional<double> ball_constant;   ///< k of F = k d^1.5 of a ball in its grooves [N/mm^1.5]
};

[[nodiscard]] PlacedBearing placed_bearing(contact::ContactContext const& context, int circles, RingGrid const& around);

/// The compliance matrices of @p influence, harmonic by harmonic.
[[nodiscard]] std::vector<HarmonicResponse> responses(elastic::Influence const& influence);

/// Enters the wave generator into @p drive, which has its phase.
/// @param highest  harmonic
void add_wave_generator(ElasticDrive& drive, PlacedBearing const& placed, contact::ContactContext const& context,
                        RingGrid const& around, int highest);

}  // namespace hdconj::load
