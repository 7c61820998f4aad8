// SPDX-License-Identifier: GPL-3.0-or-later
// How flanks that are made differ from those that are drawn.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "hdconj/base/vec2.hpp"

namespace hdconj::contact {

/// A tooth, or a tooth space with both of its flanks, that stands beside its place.
struct Displacement
{
    double turn = 0;            ///< about the axis, clockwise [rad]
    Vec2 shift = Vec2::Zero();  ///< in its own frame, in the middle of the width [mm]
    Vec2 lean = Vec2::Zero();   ///< by how much the shift grows along the axis, towards the cup's open end [mm/mm]
};

/// Deviations of flanks. Displacements are exact. Changes along the normal of the flank are added to the distance
/// between the nominal flanks: right but for the square of the deviation's slope along the flank times the gap.
struct FlankDeviation
{
    /// (k) by how much all gaps of a slice are larger [mm]; empty: by nothing
    std::vector<double> slice{};
    /// By how much the flexspline's flanks stand back at a height of the tooth frame [mm]; null: by nothing. The land
    /// counts as the edge beside it.
    std::function<double(double)> height{};
    double excess = 0;  ///< at no height do flanks stand out by more [mm]
    /// By how much the circular spline's flanks stand back at a distance from its axis [mm]; null: by nothing.
    std::function<double(double)> radius{};
    std::vector<Displacement> teeth{};   ///< of the flexspline, from tooth 0 on; empty: none
    std::vector<Displacement> spaces{};  ///< of the circular spline, from space 0 on; empty: none
    std::vector<double> z{};             ///< (k) place of a slice from the middle of the width [mm]; empty: 0

    /// The shift of @p of in a slice [mm].
    [[nodiscard]] Vec2 shift(Displacement const& of, std::size_t slice_number) const
    {
        return z.empty() ? of.shift : of.shift + z[slice_number] * of.lean;
    }
};

/// The displacement of a tooth or space by its number, which goes on over the ends of a turn.
[[nodiscard]] inline Displacement displacement_at(std::vector<Displacement> const& all, int number)
{
    if (all.empty())
        return {};
    auto const count = static_cast<int>(all.size());
    return all[static_cast<std::size_t>((number % count + count) % count)];
}

}  // namespace hdconj::contact
