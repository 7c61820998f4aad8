// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// A flank as the thesis makes it: a grid in the motion's parameter, iteration, a polynomial fit.
#pragma once

#include <cmath>
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
    template <motion::RelativeMotion Motion>
    GridPoints points(StudyDrive const& drive, Motion const& motion, conjugate::BoundaryPiece const& piece, double from,
                      double to, std::vector<double> const& contacts)
    {
        auto const count = static_cast<int>(contacts.size());
        envelope::ContactArc const& arc = drive.arc(piece);
        profile::PieceShape const& shape = drive.tooth.pieces[static_cast<std::size_t>(arc.piece)].shape;
        double t = piece.begin == arc.u_begin ? arc.t_begin
                   : piece.begin == arc.u_end ? arc.t_end
                                              : drive.envelope(piece).point(arc, piece.begin).t;
        GridPoints result;
        for (int i = 0; i < count; ++i) {
            double const s = from + (to - from) * i / (count - 1);
            double const found = secant_root(shape, motion.rates(s).twist, t),
                         right = contacts[static_cast<std::size_t>(i)];
            // The method sees by itself that it has left the flank; the next step begins with the last kept value.
            bool const kept = found >= -rounding_of_t && found <= 1 + rounding_of_t;
            if (kept)
                t = found;
            if (!kept || !(std::abs(found - right) <= same_contact)) {
                ++result.missed;
                result.extra += kept;
                continue;
            }
            OnPiece const on = on_piece(shape, t);
            result.points.push_back(drive.placed(piece, motion.pose(s)(on.x + drive.offset * on.n)));
            result.steps.push_back(i);
        }
        return result;
    }

    /// Fits a polynomial of @p degree by least squares, x against y or y against x, whichever of them varies more as
    /// the free variable. @returns 401 points of its curve
    [[nodiscard]] static std::vector<Vec2> fitted(std::vector<Vec2> const& points, int degree);

  private:
    /// NaN where it does not converge.
    [[nodiscard]] double secant_root(profile::PieceShape const& shape, PlanarVelocity const& twist, double t);
};

}  // namespace hdconj::accuracy
