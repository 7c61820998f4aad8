// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Single balls between cam and outer ring, in place of a line of them.
#pragma once

#include <optional>
#include <vector>

#include "hdconj/elastic/ball_line.hpp"
#include "hdconj/elastic/bearing.hpp"

namespace hdconj {

/// A ring that lies on single balls, as what it does beside a ring that is held on the cam all round.
///
/// With the Fourier coefficients h of the way [mm] by which the ring's inner circle stands off the cam, K its stiffness, p = P_0 + E' f what holds it on the cam, and B the values of the
/// coefficients' functions at the balls, the ring takes the shape
///
///   K h + p = B' P,      B h = e - P/k,
///
/// P: forces of the balls [N], e >= 0: the gaps between ball and ring, k: stiffness of one ball. Eliminating h leaves the form of a BallLine whose points are the balls:
/// P = held + stiffness e + lift' f, and gaps of the bearing's surface
///
///   g = (G + between) f - (d - sag) - lift e.
///
/// Everything follows from the harmonics that the held ring was solved for: nothing more is factorised.
struct DiscreteBalls
{
    BallLine balls;           ///< of one sector: angles, forces and gaps are those of single balls
    Eigen::MatrixXd between;  ///< (contacts, contacts), symmetric, not negative: what the ring gives way by between its balls [mm/N]
    Eigen::VectorXd sag;      ///< (contacts) by how much the unloaded ring lies lower than one on the cam all round [mm]
};

/// Even angles of @p count balls that lie in one of @p sectors parts of the ring, from @p phase on [rad]. Domain: @p sectors divides @p count.
[[nodiscard]] std::vector<double> ball_angles(int count, int sectors, double phase);

/// @param surface    of a rigid line of balls (BearingRing::radial_stiffness absent): harmonics are multiples of @p sectors
/// @param contacts   as of ball_line()
/// @param phi        of the balls in one sector [rad], different from each other
/// @param stiffness  k of one ball [N/mm]; absent: rigid
/// A ball's force is a point of the inner circle: what the ring gives way by right under it is as local as the highest harmonic, 2 pi r/n.
/// @throws NumericalError for a rigid bearing, no ball, rigid balls that are more than the harmonics tell apart, and balls that leave the ring free to move as a whole (where harmonic 1 is
///                        there: one, or two that face each other)
[[nodiscard]] DiscreteBalls discrete_balls(BearingSurface const& surface, int sectors, BearingContacts const& contacts, std::vector<double> const& phi,
                                           std::optional<double> stiffness = {});

}  // namespace hdconj
