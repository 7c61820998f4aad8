// SPDX-License-Identifier: GPL-3.0-or-later
// Balls between cam and outer ring, which carry compression only.
#pragma once

#include <Eigen/Core>

#include <cmath>
#include <optional>
#include <vector>

#include "numeric/complementarity.hpp"

namespace hdconj::elastic {

struct BearingSurface;

/// The line of balls at even angles of a lobe, and the response of the ring where it stands off the cam.
///
/// bearing_surface() holds the ring's line of balls on the cam all round. Where the ring stands off by h [mm] in place
/// of 0, the balls' forces and the gaps between bearing and cup are
///
///   P = P_0 + K h + E' f,     g = G f - d - E h,     and balls push:   P >= 0,  h >= 0,  P h = 0.
///
/// h is a trigonometric polynomial through its values at the points; P are the forces [N] that do its work, of the part
/// of the line that a point stands for. On a mirror plane P is half of what acts there, like any force of a Repetition.
struct BallLine
{
    std::vector<double> phi;    ///< of the points [rad]
    Eigen::VectorXd held;       ///< P_0: of the unloaded ring, held on the cam [N]
    Eigen::MatrixXd stiffness;  ///< K [N/mm]: symmetric, positive but for motions of the whole ring
    Eigen::MatrixXd lift;       ///< E: (contacts, points), the surface's rise for 1 mm of h
    /// k of balls that yield, P = k d^1.5 [N/mm^1.5]: where one is pressed, h = -d. Absent: balls are rigid.
    std::optional<double> hertz = {};
};

/// Where bearing and cup may touch: the force there acts evenly over `spread`, and gaps are means over it.
struct BearingContacts
{
    std::vector<double> phi;      ///< of each contact [rad]
    std::vector<Eigen::Index> z;  ///< row of BearingSurface of each
    double spread = 0;            ///< [rad]
};

/// @param points  in a lobe, even; at most twice the harmonics of @p surface
/// @param mirrored  for an even cam and contacts of half a lobe: points of half a lobe, both ends included
/// @throws NumericalError for a rigid bearing, or points that the harmonics cannot tell apart
[[nodiscard]] BallLine ball_line(BearingSurface const& surface, int waves, BearingContacts const& contacts, int points,
                                 bool mirrored, int threads = 1);

/// Contacts and balls in equilibrium.
struct BallContact
{
    numeric::ComplementaritySolution contacts;
    Eigen::VectorXd force;  ///< P [N]
    Eigen::VectorXd gap;    ///< between ring and balls [mm]: h where no ball is pressed, else 0
    int rounds = 0;         ///< complementarity problems solved: 1 where no ball would have to pull
};

/// Solves @p problem, that of a ring held on the cam, with balls that push only: points are released and caught again
/// until those that touch push and those that do not stand off. Balls that yield are springs whose stiffness is the
/// secant of their law, found again until the approaches agree with the law to 1e-7 of the largest.
/// @param first    contact of @p problem that is the first of @p line; they are the last ones, in order
/// @param start    forces of the points in a neighbouring problem to begin with; empty: none are known
/// @param problem  nothing in it yields; on return the ring does where no ball is pressed, or balls yield: `yielding`
///                 and `approach`
/// @throws NumericalError as solve_complementarity does, where no such set of points is found, and for a ring that can
/// move as a whole
[[nodiscard]] BallContact solve_on_balls(numeric::Complementarity& problem, Eigen::Index first, BallLine const& line,
                                         numeric::ComplementarityOptions options = {},
                                         std::vector<double> const& start = {});

/// Mean of cos(n phi) over @p spread [rad] about phi = 0.
inline double mean_of_cosine(double n, double spread)
{
    double const half = n * spread / 2;
    return half == 0 ? 1 : std::sin(half) / half;
}

}  // namespace hdconj::elastic
