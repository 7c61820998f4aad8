// SPDX-License-Identifier: GPL-3.0-or-later
// Contact of two elastic bodies at a point, and of a ball with both its grooves (Hertz).
#pragma once

#include "elasticity.hpp"

namespace hdconj::elastic {

/// Two bodies that touch at a point.
struct PointContact
{
    Elasticity first, second;
    double along = 0;   ///< larger principal relative curvature, 1/R_1 + 1/R_2 [1/mm]
    double across = 0;  ///< smaller one, in the plane across, positive [1/mm]
};

/// k of F = k d^1.5 with the approach d of distant points [N/mm^1.5]. By elliptic integrals (Johnson, Contact
/// Mechanics, 4.2; Harris, Rolling Bearing Analysis, 6.32 ff), to rounding. Domain: 1e-11 along < across <= along.
[[nodiscard]] double point_constant(PointContact const& contact);

/// A ball between the grooves of two rings.
struct GroovedBall
{
    double diameter = 0;       ///< [mm]
    double outer_raceway = 0;  ///< radius of the bottom of the outer groove [mm]; the inner one lies a ball further in
    double inner_conformity = 0;  ///< radius of the groove over the diameter, above 0.5
    double outer_conformity = 0;  ///< likewise
    Elasticity ball, rings;
};

/// k of F = k d^1.5 of both contacts together [N/mm^1.5]: their approaches add up, k^(-2/3) = k_i^(-2/3) + k_o^(-2/3).
/// Both raceways count as round.
[[nodiscard]] double ball_constant(GroovedBall const& ball);

}  // namespace hdconj::elastic
