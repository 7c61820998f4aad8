// SPDX-License-Identifier: GPL-3.0-or-later
// Short stretches of a curve, on each of which a point not too far away has one foot at most.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "hdconj/base/vec2.hpp"
#include "hdconj/profile/pieces.hpp"

namespace hdconj::distance {

/// A stretch of a curve x(t), t in [from, to], with bounds that hold on all of it. It is also given as a short power
/// series about its middle: x(t) = sum x_k s^k, s = -1 ... 1.
struct CurveStretch
{
    /// No stretch needs more; one that does is cut.
    static constexpr std::size_t most_terms = 12;

    profile::CurvePiece const* curve = nullptr;
    double from = 0, to = 1;
    Vec2 first = Vec2::Zero(), last = Vec2::Zero();              ///< x at the ends
    Vec2 slope_first = Vec2::Zero(), slope_last = Vec2::Zero();  ///< x' there
    Vec2 bend_first = Vec2::Zero(), bend_last = Vec2::Zero();    ///< x'' there
    Vec2 low = Vec2::Zero(), high = Vec2::Zero();                ///< box around it
    Vec2 centre = Vec2::Zero(),
         bend = Vec2::Zero();  ///< x lies within `reach` of the one, x'' within `bend_reach` of the other
    double reach = 0, bend_reach = 0;
    double slowest = 0;     ///< |x'|^2 is nowhere less
    std::size_t terms = 0;  ///< of the series; what is left out is below a rounding of the largest coordinate
    std::array<double, most_terms> x{}, y{};
};

/// @p curve cut until the direction of x' changes little along each stretch. Neighbours have the same bits at their
/// common end.
[[nodiscard]] std::vector<CurveStretch> stretches_of(profile::CurvePiece const& curve);

/// A foot of a point on a stretch.
struct StretchFoot
{
    bool found = false;
    bool certain = true;  ///< false: nothing is proved, all of the curve has to be searched
    Vec2 point = Vec2::Zero();
    Vec2 normal = Vec2::Zero();  ///< left of x', of length 1
};

/// Where the distance of @p p from the stretch has a minimum inside of it: g(t) = (p - x).x' falls through 0. It falls
/// everywhere, so that there is one foot if g has different signs at the ends and none otherwise, where (p - x).x'' <
/// |x'|^2: bounds of both decide whether that is proved. Accuracy: some roundings of the coordinates, the foot along
/// the curve those over the curvature of the distance; a foot at an end belongs to the stretch before.
[[nodiscard]] StretchFoot foot_on(CurveStretch const& stretch, Vec2 const& p);

}  // namespace hdconj::distance
