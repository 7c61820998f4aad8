// SPDX-License-Identifier: GPL-3.0-or-later
// What families use to put a profile together.
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "hdconj/error.hpp"
#include "hdconj/numeric/bracketed_root.hpp"
#include "hdconj/profile/polynomial_curve.hpp"
#include "hdconj/profile/profile.hpp"
#include "hdconj/scene/parameter_fault.hpp"
#include "hdconj/scene/parameters.hpp"

namespace hdconj::profile {

/// The gear for which a family makes a tooth.
///
/// The gear's centre lies on the y axis. On the flexspline it is module teeth / 2 below the pitch line of a tooth, and
/// y points outward. On the circular spline, whose teeth point inward, it is as far above, and y points inward.
struct ToothPlace
{
    double module = 0;
    int teeth = 0;    ///< z_f; z_c of a tooth on the circular spline
    double wall = 0;  ///< delta; 0 on the circular spline: its tooth frame has its origin at the root
    double neutral_offset = 0;
    std::string folder;        ///< where relative file names start
    bool internal = false;     ///< a tooth on the circular spline
    int tooth_difference = 2;  ///< z_c - z_f
    int waves = 2;             ///< n

    /// y of the gear's centre, from the pitch line.
    [[nodiscard]] double centre() const { return (internal ? 0.5 : -0.5) * module * teeth; }
};

/// A named stretch of the right flank, given from the tip down to the root, y from the pitch line. Its pieces share
/// their tangents where they join; a corner can only stand between segments.
struct FlankSegment
{
    std::string name;
    std::vector<PieceShape> pieces;
};

/// A segment that is a curve, in pieces.
[[nodiscard]] FlankSegment curve_segment(std::string name, std::vector<CurvePiece> pieces);

/// Right flank from tip to root -> whole symmetric tooth. The flank is mirrored. A flat tip land joins the flanks when
/// they do not meet at x = 0. Corners are inserted where the normals make a convex angle.
/// @param dedendum  gives the pitch line: y = wall/2 + dedendum + neutral_offset in the tooth frame
[[nodiscard]] Profile symmetric_tooth(std::vector<FlankSegment> const& right_flank, ToothPlace const& place,
                                      double addendum, double dedendum);

/// Whole tooth given from left root to right root, y from the pitch line.
[[nodiscard]] Profile whole_tooth(std::vector<FlankSegment> const& segments, ToothPlace const& place, double addendum,
                                  double dedendum, bool mirror_symmetric);

/// Tips of typed numbers: half a tip thickness above minus this fraction of the addendum counts as pointed, not as
/// crossed.
inline constexpr double pointed_tip = 1e-9;  // digits that designers type

/// The argument between @p from and @p to at which a flank's height is @p y; nothing when it does not reach @p y. The
/// height must change in one direction only.
template <class F>
[[nodiscard]] std::optional<double> at_height(F&& flank, double y, double from, double to)
{
    numeric::BracketedRoot const root = numeric::bracketed_root([&](double s) { return flank(s).point.y() - y; },
                                                                std::min(from, to), std::max(from, to));
    if (!root.found)
        return std::nullopt;
    // the bracket is as wide as the roundings of its ends; one Newton step leaves those of the height
    CurveJet const there = flank(root.x);
    return root.x + (y - there.point.y()) / there.slope.y();
}

/// Tooth thickness at the pitch line: the key `thickness`, half the pitch when absent. A fault when it leaves no space
/// between the teeth.
[[nodiscard]] double thickness_at_pitch(scene::FamilyChoice const& choice, ToothPlace const& place, Faults& faults);

/// The fault of an addendum above the height @p pointed at which the two flanks meet.
/// @param otherwise  what else would help: "a larger thickness"
void refuse_crossing(scene::ParameterFaults const& refuse, double pointed, std::string const& otherwise);

}  // namespace hdconj::profile
