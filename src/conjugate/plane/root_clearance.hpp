// SPDX-License-Identifier: GPL-3.0-or-later
// Root clearance: the bottom of the tooth space moved outward along its centre line.
#pragma once

#include "conjugate/outline.hpp"

namespace hdconj::conjugate {

/// The stretches traced by the tooth's tip around the middle of the space: [first, last] indices of points.
struct Bottom
{
    std::size_t first = 0;
    std::size_t last = 0;
};
[[nodiscard]] Bottom bottom_of(Outline const& outline, std::size_t middle);

/// Unites the tooth space with its bottom moved by up to @p clearance along +y: the bottom between its widest points is
/// moved, and straight root walls join it to what stays. Flanks do not change.
/// @throws NumericalError when the bottom between its widest points is not one-to-one in x
void deepen(Outline& outline, std::size_t middle, double clearance);

}  // namespace hdconj::conjugate
