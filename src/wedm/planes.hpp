// SPDX-License-Identifier: GPL-3.0-or-later
// Faces of the workpiece and guides of the wire: both lie on one straight line per matched pair of points.
#pragma once

#include "hdconj/wedm.hpp"

namespace hdconj::wedm {

/// One wire position by a point in a lower and one in an upper plane [mm].
struct WirePoints
{
    Vec2 lower = Vec2::Zero();
    Vec2 upper = Vec2::Zero();
};

/// Where the wire through @p faces is at height @p z [mm] above the lower face: P = (1 - z/T) L + z/T U. T > 0. z = 0
/// and z = T give the faces bit for bit, and so does every z where they are the same.
[[nodiscard]] inline Vec2 at_height(WireMachine const& machine, WirePoints const& faces, double z)
{
    double const share = z / machine.thickness;
    return share == 1 ? faces.upper : Vec2(faces.lower + share * (faces.upper - faces.lower));
}

/// Where the wire through @p faces (z = 0 and z = T) passes the guides: G_l = L - h_l/T (U - L), G_u = U + h_u/T (U -
/// L).
///
/// Weights of L and U sum to 1, so guides move with the part; U = L gives G_u = G_l = L bit for bit. An error of the
/// faces grows by 1 + 2 h/T: guides are computed from faces that were not rounded. T > 0.
[[nodiscard]] inline WirePoints guides_of(WireMachine const& machine, WirePoints const& faces)
{
    Vec2 const lean = (faces.upper - faces.lower) / machine.thickness;
    return {faces.lower - machine.lower_guide * lean, faces.upper + machine.upper_guide * lean};
}

/// The inverse: L = G_l + h_l/H (G_u - G_l), U = G_l + (h_l + T)/H (G_u - G_l), H the distance of the guides. Both are
/// means of the guides: an error of the guides does not grow.
[[nodiscard]] inline WirePoints faces_of(WireMachine const& machine, WirePoints const& guides)
{
    Vec2 const lean = (guides.upper - guides.lower) / machine.guide_distance();
    return {guides.lower + machine.lower_guide * lean, guides.lower + (machine.lower_guide + machine.thickness) * lean};
}

}  // namespace hdconj::wedm
