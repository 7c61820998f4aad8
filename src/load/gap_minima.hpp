// SPDX-License-Identifier: GPL-3.0-or-later
// Minima of the gap along one flank; private to src/load.
#pragma once

#include <cstddef>
#include <vector>

#include "flank_contacts.hpp"
#include "flank_curve.hpp"

namespace hdconj::load {

/// One flank of a slice, seen from one tooth space.
struct FlankView
{
    contact::GapField const& field;
    FlankSearch const& search;
    FlankCurve const& curve;
    std::size_t space;
    int flank;
    std::size_t slice;
    double radius;  ///< of the circles whose centres the curve joins [mm]; 0: the curve is the flank
    contact::GapField::NearTeeth const& teeth;

    [[nodiscard]] contact::GapField::Touch touch(Vec2 const& q) const { return field.touch(teeth, q); }
    [[nodiscard]] double gap(Vec2 const& q) const { return touch(q).nearest.distance - radius; }
    /// Derivative of the gap along the flank; at an end of a stretch, from within the stretch.
    [[nodiscard]] double slope(FlankCurve::Place const& at) const
    {
        return touch(curve.point(at)).gradient().dot(curve.tangent(at));
    }
};

/// No gap of the flank is smaller than this [mm], by every eighth point.
[[nodiscard]] double sampled_bound(FlankView const& view);

/// A place of least gap.
struct GapMinimum
{
    FlankCurve::Place place;
    bool at_end = false;  ///< the flank ends there with the gap still falling
};

/// All places below the limit where the gap turns from falling to rising, and ends of the flank.
/// @param gap       at the points of the curve [mm]
/// @param gradient  of the gap there
[[nodiscard]] std::vector<GapMinimum> gap_minima(FlankView const& view, std::vector<double> const& gap,
                                                 std::vector<Vec2> const& gradient);

/// Part of the flank around a minimum in which the gap exceeds that of the minimum by no more than the depth of the
/// strip: distances along the flank from the minimum to both ends [mm], at most a tenth of the flank each.
struct ContactStrip
{
    double behind, ahead;
};
[[nodiscard]] ContactStrip contact_strip(FlankView const& view, GapMinimum const& at,
                                         contact::GapField::Touch const& touch);

}  // namespace hdconj::load
