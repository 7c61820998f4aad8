// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Places where teeth touch, or may touch under load.
#pragma once

#include <cstddef>
#include <vector>

#include "hdconj/contact/gap_field.hpp"

namespace hdconj {

/// One point of a flank of the circular spline and the tooth nearest to it, in the plane of a slice.
///
/// A unit force along the normal presses the tooth by -normal and the circular spline by +normal. With the displacement (u_r, u_t) of the tooth's
/// foot on the neutral curve and its turn beta (clockwise), the gap changes by -(c_r u_r + c_t u_t + c_turn beta); with the turn of the whole flexspline by -lever.
struct FlankContact
{
    std::size_t space = 0;    ///< of the GapField
    int flank = 0;            ///< as in GapMap
    std::size_t slice = 0;
    int tooth = 0;            ///< number as in ToothPlaces
    double station = 0;       ///< place along the flank, 0 at the land corner ... 1 at the flank end
    std::size_t point = 0, next = 0;  ///< of the flank's points, between which it lies
    double share = 0;                 ///< of the way from one to the other
    double gap = 0;           ///< [mm]
    double c_r = 0, c_t = 0;  ///< normal in the undeformed ring's directions at the tooth, circular-spline material ahead
    double c_turn = 0;        ///< [mm]
    double lever = 0;         ///< [mm] torque about the axis of a unit force on the circular spline, clockwise: positive on right flanks
    double curvature = 0;     ///< of the gap along the flank: relative curvature of the line contact [1/mm]
    double tooth_x = 0, tooth_y = 0;  ///< nearest point of the tooth, tooth frame [mm]
    double inclination = 0;   ///< sine of the angle between normal and tooth's x axis: share of the force along the tooth
};

/// What is looked for, and where.
struct FlankSearch
{
    double turn = 0;              ///< of the flexspline, clockwise [rad]
    double limit = 0;             ///< contacts with a smaller gap only [mm]
    std::size_t first_space = 0;  ///< of the field
    std::size_t spaces = 0;
    double phase = 0;             ///< undeformed angle of tooth 0 [rad]
    int flexspline_teeth = 0;
    int circular_spline_teeth = 0;
    double least_curvature = 0, largest_curvature = 0;  ///< that `curvature` is kept between [1/mm]
};

/// The least gap of each (space, flank, slice), and a second least one where the gap has another minimum away from it (both arcs of a tooth
/// may touch). In order of space, flank, slice, station. Flanks that are farther than the limit are told by a few points: no gap changes faster than the way along the flank.
/// Accuracy: the gap is exact at the flank's points and parabolic between them; curvature from second differences over a twentieth of the flank.
[[nodiscard]] std::vector<FlankContact> flank_contacts(GapField const& field, FlankSearch const& search, int threads);

/// The same contacts at the same places of the flanks, whether their gaps are least there or not; curvatures stay.
[[nodiscard]] std::vector<FlankContact> at_same_places(GapField const& field, FlankSearch const& search, std::vector<FlankContact> const& contacts, int threads);

/// Part of a flank's length by which two contacts of it lie apart.
inline constexpr double contacts_apart = 0.15;

}  // namespace hdconj
