// SPDX-License-Identifier: GPL-3.0-or-later
// Distances of several neighbouring points from a tooth of arcs and lines at once, the same bits as one by one.
#pragma once

#include <vector>

#include "hdconj/distance/tooth_lanes.hpp"

namespace hdconj::distance {

/// ToothDistance for as many points at once as there are lanes.
///
/// Each point sees the same pieces in the same order with the same operations as in ToothDistance, so that the result
/// has the same bits. A piece whose box is farther from all points than what is known is left out for all. Which vector
/// instructions are used is chosen when the program is loaded; none of them fuses a product with a sum.
class DistanceLanes
{
  public:
    /// A joint of two pieces, or an end of the profile.
    struct Vertex
    {
        double x, y;      ///< place [mm]
        double n_x, n_y;  ///< mean of the normals on both sides
        double open_end;  ///< 1: root end of the profile
    };
    /// A line from a point on, or an arc about a centre.
    struct Piece
    {
        bool is_arc;                          ///< or a line
        double low_x, low_y, high_x, high_y;  ///< bounding box [mm]
        double x, y;                          ///< begin of the line, centre of the arc [mm]
        double t_x, t_y;                      ///< direction of the line, middle of the arc's normals
        double n_x, n_y;                      ///< normal of the line
        double size;                          ///< length of the line, radius of the arc [mm]
        double cos_half_span;                 ///< of the arc
    };

    /// Vertex i stands before piece i; the last one behind the last piece.
    DistanceLanes(std::vector<Vertex> vertices, std::vector<Piece> pieces);

    /// What is nearest to each point, as NearestPoint says.
    struct Nearest
    {
        Lanes distance;  ///< signed [mm]
        Lanes foot_y;    ///< ordinate of the nearest point of the tooth [mm]
        Lanes normal_x, normal_y;
    };

    /// @param x         abscissae of the points in the frame of the tooth [mm]
    /// @param y         ordinates [mm]
    void operator()(Lanes const& x, Lanes const& y, Nearest& nearest) const;

  private:
    std::vector<Vertex> vertices_;
    std::vector<Piece> pieces_;
};

}  // namespace hdconj::distance
