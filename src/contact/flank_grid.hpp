// SPDX-License-Identifier: GPL-3.0-or-later
// Points of the flanks of a tooth space, slice by slice.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "conjugate/matched_outline.hpp"
#include "hdconj/base/vec2.hpp"

namespace hdconj::contact {

/// Points of both flanks of one tooth space, the same for all spaces of a ring; flanks as in GapMap.
struct FlankGrid
{
    std::vector<double> z;        ///< (k) [mm]
    std::vector<double> station;  ///< (p) share of the middle slice's length, 0 at the land corner ... 1 at the end
    /// [flank][slice][point], frame of the tooth space [mm]
    std::array<std::vector<std::vector<Vec2>>, 2> point;
    std::array<std::vector<std::vector<Vec2>>, 2> normal;  ///< unit, into the material

    /// [flank][slice]: all points of the outline between the same two ends, in the same order, and their normals.
    /// Empty: the points above are all there are.
    std::array<std::vector<std::vector<Vec2>>, 2> line;
    std::array<std::vector<std::vector<Vec2>>, 2> line_normal;
    std::array<std::vector<std::size_t>, 2> index;  ///< place of point j among them

    /// Place of point @p j along the line, as between() counts.
    [[nodiscard]] double place(int flank, std::size_t j) const;

    /// A point of the flank between its points: @p s counts the points of the line from the land corner on.
    ///
    /// The cubic that has their places and tangents (hermite_between()): it differs from the true flank by no more than
    /// the square of the outline's chord error over a radius of curvature. Between centres of circles: the chord.
    [[nodiscard]] Vec2 between(int flank, std::size_t slice, double s) const;

    /// (k) where not empty: tip circle of the part [mm]. The points above begin on it or beyond it, where the flank
    /// comes from that reaches it when it is moved into the material.
    std::vector<double> tip;

    /// (k) where not empty: how far a tilt of kind "radial" has moved the slice outward [mm]. Side clearance is laid
    /// before that, as it is in the outline that is written.
    std::vector<double> shift;

    /// Side clearance that the points above already contain [mm]. The slices of a draft are computed with it: a slice
    /// that a draft moves inward loses an end of its flank, and moving the rest outward afterwards would not restore
    /// it.
    double included_clearance = 0;

    /// [flank][slice] where not empty: the points are centres of circles of this radius within the material, and gaps
    /// are those of the circles [mm]
    std::array<std::vector<double>, 2> radius;

    [[nodiscard]] bool operator==(FlankGrid const&) const = default;

    [[nodiscard]] std::size_t slices() const { return z.size(); }
    [[nodiscard]] std::size_t points() const { return station.size(); }
};

/// Points of a matched outline, @p count on each flank as evenly as its points allow: points of the outline itself, so
/// that one point has one origin in all slices. Fewer where the outline has fewer.
[[nodiscard]] FlankGrid flank_grid(conjugate::MatchedOutline const& outline, std::vector<double> const& z, int count);

/// The grid moved along its normals into the material until it has the side clearance @p offset [mm], as a part that is
/// made has it: overlaps of moved branches come together in their crossing (trim_overlaps()), what is left beyond a tip
/// circle on it, and `station` counts from there. Centres of circles are moved alone.
[[nodiscard]] FlankGrid moved_into_material(FlankGrid grid, double offset);

/// Slice @p k alone.
[[nodiscard]] FlankGrid slice_of(FlankGrid const& grid, std::size_t k);

/// The cubic from @p a to @p b with the tangents that the normals @p at_a and @p at_b tell (Hermite), at @p t of the
/// chord, 0 ... 1.
///
/// A smooth curve has about opposite slopes against its chord at both ends. Beside a corner, where only one branch's
/// tangent is known, one of them is several times the other: then the smaller one stands for both.
[[nodiscard]] inline Vec2 hermite_between(Vec2 const& a, Vec2 const& at_a, Vec2 const& b, Vec2 const& at_b, double t)
{
    Vec2 const chord = b - a;
    auto const slope_at = [&](Vec2 const& n) { return n.dot(chord) / cross(n, chord); };
    double begin = slope_at(at_a);
    double end = slope_at(at_b);
    constexpr double corner = 4;
    if (!(std::abs(begin) <= corner * std::abs(end)))
        begin = -end;
    else if (!(std::abs(end) <= corner * std::abs(begin)))
        end = -begin;
    double const bulge = t * (1 - t) * ((1 - t) * begin - t * end);
    return a + t * chord + (std::isfinite(bulge) ? bulge : 0) * left_of(chord);
}

}  // namespace hdconj::contact
