// SPDX-License-Identifier: GPL-3.0-or-later
// A flank as the thesis makes it: a grid in the motion's parameter, iteration, a polynomial fit.
#pragma once

#include <cstddef>
#include <vector>

#include "study_drive.hpp"

namespace hdconj::accuracy {

/// Distance of profile parameters at which an end of a flank counts as met.
inline constexpr double rounding_of_t = 0x1p-30;
/// Distance of profile parameters of one contact: well above the remainder of the secant rule, well below the distance
/// of two contacts.
inline constexpr double same_contact = 0x1p-20;

/// Local point and unit normal of a piece.
struct OnPiece
{
    Vec2 x, n;
};
/// @param t  profile parameter, 0 ... 1 on the piece
[[nodiscard]] OnPiece on_piece(profile::PieceShape const& shape, double t);

/// Points of a flank at the steps of a grid.
struct GridPoints
{
    std::vector<Vec2> points;
    std::vector<int> steps;  ///< of the grid that each of them is of
    int missed = 0;  ///< steps without a point: the motion has no contact on the flank, or the iteration left the
                     ///< flank, did not converge or found another contact
    int extra = 0;   ///< steps at which it found another contact
};

/// The method of the thesis; it counts its evaluations of the meshing condition.
class GridAndFit
{
  public:
    std::size_t evaluations = 0;

    /// Contacts at equal steps of the motion's parameter. The secant rule finds each profile parameter from the one
    /// before. A converged value on the flank is compared with the entry of @p contacts, NaN where there is no contact.
    GridPoints points(StudyDrive const& drive, motion::AnyMotion const& motion, conjugate::BoundaryPiece const& piece,
                      double from, double to, std::vector<double> const& contacts);

    /// Fits a polynomial of @p degree by least squares, x against y or y against x, whichever of them varies more as
    /// the free variable. @returns 401 points of its curve
    [[nodiscard]] static std::vector<Vec2> fitted(std::vector<Vec2> const& points, int degree);

  private:
    /// NaN where it does not converge.
    [[nodiscard]] double secant_root(profile::PieceShape const& shape, PlanarVelocity const& twist, double t);
};

}  // namespace hdconj::accuracy
