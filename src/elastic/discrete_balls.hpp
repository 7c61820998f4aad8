// SPDX-License-Identifier: GPL-3.0-or-later
// Single balls between cam and outer ring, in place of a line of them.
#pragma once

#include <optional>
#include <vector>

#include "ball_line.hpp"
#include "bearing.hpp"

namespace hdconj::elastic {

/// A ring on single balls, relative to a ring that is held on the cam all around.
///
/// With the Fourier coefficients h of the distance [mm] of the ring's inner circle from the cam, K its
/// stiffness, p = P_0 + E' f what holds it on the cam, and B the values of the coefficients' functions at the balls,
/// the ring takes the shape
///
///   K h + p = B' P,      B h = e - P/k,
///
/// P: forces of the balls [N], e >= 0: the gaps between ball and ring, k: stiffness of one ball. Eliminating h leaves
/// the form of a BallLine whose points are the balls: P = held + stiffness e + lift' f, and gaps of the bearing's
/// surface
///
///   g = (G + between) f - (d - sag) - lift e.
struct DiscreteBalls
{
    BallLine balls;           ///< of one sector: angles, forces and gaps are those of single balls
    Eigen::MatrixXd between;  ///< (contacts, contacts) compliance of the ring between its balls, not negative [mm/N]
    Eigen::VectorXd sag;      ///< (contacts) by how much the unloaded ring lies below one on the cam all around [mm]
};

/// Even angles of @p count balls that lie in one of @p sectors parts of the ring, from @p phase on [rad]. Domain: @p
/// sectors divides @p count.
[[nodiscard]] std::vector<double> ball_angles(int count, int sectors, double phase);

/// @param surface    of a rigid line of balls (BearingRing::radial_stiffness absent): harmonics are multiples of @p
/// sectors
/// @param contacts   as of ball_line()
/// @param phi        of the balls in one sector [rad], different from each other
/// @param stiffness  k of one ball [N/mm]; absent: rigid
/// The force of a ball acts at a point of the inner circle: the deflection under it is resolved to the wavelength of
/// the highest harmonic, 2 pi r/n.
/// @throws NumericalError for a rigid bearing, no ball, more rigid balls than the harmonics resolve, and balls that
/// leave the ring free to move as a whole (with harmonic 1: one ball, or two opposite ones)
[[nodiscard]] DiscreteBalls discrete_balls(BearingSurface const& surface, int sectors, BearingContacts const& contacts,
                                           std::vector<double> const& phi, std::optional<double> stiffness = {});

}  // namespace hdconj::elastic
