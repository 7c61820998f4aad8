// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The true outline of a drive, to measure others by.
#pragma once

#include <string>
#include <vector>

#include "hdconj/scene.hpp"
#include "hdconj/solution.hpp"
#include "reference_curve.hpp"

namespace hdconj::accuracy {

/// The outline that `solve` is asked for, in 50 digits by a path of its own: one pitch of the circular spline, mid-land
/// to mid-land, or in the reverse problem the flexspline tooth from root to root, y from its pitch line. Under the
/// motion model of the scene, with any wave generator; cut where the third derivative of its shape jumps.
///
/// Domain: a side clearance that is a number; root clearance and effects along the axis are not looked at.
/// Accuracy: ReferenceCurve::error(), some 1e-16 mm.
/// @throws InputError and NumericalError as `solve` does; NumericalError where an arc's centre is at rest too
[[nodiscard]] ReferenceCurve reference_outline(Scene const& scene);

/// Figures of a drive by the same path.
struct ReferenceFigures
{
    double r_0 = 0;          ///< base radius of the deformed neutral curve, as PairGeometry::r_0 [mm]
    double space_depth = 0;  ///< from the tip circle [mm]
    double land = 0;         ///< along the tip circle [mm]
};

/// @param truth  reference_outline(@p scene)
/// Domain: the forward problem, else as there; errors as there. Accuracy: that of double coordinates, and of the land
/// over the sine of the angle at which flank and tip circle cross.
[[nodiscard]] ReferenceFigures reference_figures(Scene const& scene, ReferenceCurve const& truth);

/// Where a contact crosses an end of its segment in 50 digits, near @p phi_begin or @p phi_end of the zones of @p
/// solution that end there: per such end the distance from the angle stated [rad], and the error that is stated for it.
struct ZoneEndCheck
{
    std::string segment_name;
    double off = 0;
    double stated = 0;
};

/// All zones of regular branches that end with their segment. Domain and errors as of reference_outline().
[[nodiscard]] std::vector<ZoneEndCheck> check_zone_ends(Solution const& solution);

}  // namespace hdconj::accuracy
