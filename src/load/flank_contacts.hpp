// SPDX-License-Identifier: GPL-3.0-or-later
// Contacts of teeth, closed or open.
#pragma once

#include <cstddef>
#include <vector>

#include "contact/gap_field.hpp"
#include "flank_curve.hpp"

namespace hdconj::load {

/// One point of a flank of the circular spline and the tooth nearest to it, in the plane of a slice.
///
/// A unit force along the normal presses the tooth by -normal and the circular spline by +normal. With the displacement
/// (u_r, u_t) of the tooth's foot on the neutral curve and its turn beta (clockwise), the gap changes by -(c_r u_r +
/// c_t u_t + c_turn beta); with the turn of the whole flexspline by -lever.
struct FlankContact
{
    std::size_t space = 0;  ///< of the GapField
    int flank = 0;          ///< as in GapMap
    std::size_t slice = 0;
    int tooth = 0;               ///< number as in ToothPoses
    double arc_fraction = 0;     ///< place along the flank, 0 at the land corner ... 1 at the flank end
    double arc_length = 0;       ///< the same [mm], on the line of circles' centres where edges are round
    Vec2 point = Vec2::Zero();   ///< of the flank, in the frame of its space [mm]
    Vec2 normal = Vec2::Zero();  ///< into the circular spline, in that frame
    double gap = 0;              ///< [mm]
    double c_r = 0, c_t = 0;     ///< normal in the undeformed ring's directions at the tooth, into the circular spline
    double c_turn = 0;           ///< [mm]
    double lever = 0;        ///< clockwise torque of a unit force on the circular spline: positive on right flanks [mm]
    double curvature = 0;    ///< of the gap along the flank: relative curvature of the line contact [1/mm]
    double tooth_y = 0;      ///< height of the nearest point of the tooth, tooth frame [mm]
    bool on_edge = false;    ///< on a rounded edge, whose radius alone decides its curvature
    double inclination = 0;  ///< sine of the angle between normal and tooth's x axis: share of the force along it
};

/// Limits of a search for contacts.
struct FlankSearch
{
    double turn = 0;              ///< of the flexspline, clockwise [rad]
    double limit = 0;             ///< contacts with a smaller gap only [mm]
    std::size_t first_space = 0;  ///< of the field
    std::size_t spaces = 0;
    double phase = 0;  ///< undeformed angle of tooth 0 [rad]
    int flexspline_teeth = 0;
    double strip_depth = 0;  ///< how much more gap belongs to one contact: that at the edges of a typical strip [mm]
    bool in_middle = false;  ///< every force acts in the middle of its strip, on edges too
    FlankTangents tangents = FlankTangents::parabola;
};

/// What searches know of the gaps of a field that only moves: no gap of a flank is smaller than its bound.
class GapBounds
{
  public:
    /// After a movement that closes no gap by more than @p fall [mm]. Infinite: nothing is known any more.
    void lower(double fall);

  private:
    friend std::vector<FlankContact> flank_contacts(contact::GapField const& field, FlankSearch const& search,
                                                    int threads, GapBounds* known);
    std::vector<double> least_;  ///< (spaces, flanks, slices) [mm]; empty: nothing is known
};

/// Finds the local minima of the gap along every (space, flank, slice), each with the strip of the flank that belongs
/// to it, in order of space, flank, slice and arc length. A few points exclude flanks beyond the limit, since no gap
/// changes faster than the arc length.
///
/// Flanks are smooth curves through the grid's points, third order in their spacing. Least gaps are at roots of the
/// gap's derivative, ends and edges. The strip of one is where the gap is no more than strip_depth larger, 2 b wide:
/// the contact is in its middle, its curvature is 2 strip_depth/b^2, and lesser minima within it belong to it. As a
/// Hertz strip under the line load q has the depth a^2 kappa/2 = 2 q/(pi E*), that is the curvature that the pressure
/// sees, and it changes little by little where the least gap jumps along flanks that fit each other well. Accuracy: a
/// strip ends at a tenth of the flank on either side. Domain: gaps above -radius (with_round_edges()).
/// @param known  of the same spaces, or null: flanks whose bound is beyond the limit are passed by, which changes no
///               result, and bounds are found for the others
[[nodiscard]] std::vector<FlankContact> flank_contacts(contact::GapField const& field, FlankSearch const& search,
                                                       int threads, GapBounds* known = nullptr);

/// Adds those of @p before that carried @p force and have no contact of @p contacts within a strip's half width: the
/// minimum of a contact vanishes at once where flanks that fit each other over a long stretch turn by a little,
/// although the gap there hardly changes. They keep place and curvature. The order stays that of flank_contacts().
void hold_contacts(contact::GapField const& field, FlankSearch const& search, std::vector<FlankContact> const& before,
                   std::vector<double> const& force, std::vector<FlankContact>& contacts);

}  // namespace hdconj::load
