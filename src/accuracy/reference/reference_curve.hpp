// SPDX-License-Identifier: GPL-3.0-or-later
// A true curve to measure others by: patches of Chebyshev series in long double, made from points in 50 digits.
#pragma once

#include <cstddef>
#include <vector>

#include "hdconj/base/vec2.hpp"
#include "region/segment_tree.hpp"

namespace hdconj::accuracy {

/// One smooth patch, parameter -1 ... 1.
struct ReferencePatch
{
    std::vector<long double> x, y;  ///< Chebyshev coefficients [mm]
    int stretch = 0;                ///< number of the stretch of boundary that it belongs to
};

/// How far a computed polygon is from the true curve.
struct CurveDifference
{
    double points = 0;     ///< largest distance of a vertex from the curve [mm]
    double hausdorff = 0;  ///< of polygon and curve, both ways [mm]
    int missed = 0;        ///< stretches of the curve whose middle is more than `far` from the polygon
};

/// A curve without gaps, from one end to the other.
///
/// Accuracy: the patches follow 50 digits to error() between their nodes. Distances are computed in long double, so
/// what is measured is limited by the polygon's own double coordinates (3.6e-15 mm at 25 mm).
class ReferenceCurve
{
  public:
    /// @param error  measured against 50 digits [mm]
    ReferenceCurve(std::vector<ReferencePatch> patches, double error);

    [[nodiscard]] double error() const { return error_; }
    [[nodiscard]] std::vector<ReferencePatch> const& patches() const { return patches_; }
    /// Dense points, for scans.
    [[nodiscard]] std::vector<Vec2> const& points() const { return points_; }

    /// Distance of @p p from the curve.
    [[nodiscard]] double distance(Vec2 const& p) const { return distance(p.x(), p.y()); }
    [[nodiscard]] double distance(long double x, long double y) const;

    /// The curve without its first and last stretch: without the lands of a tooth space.
    [[nodiscard]] ReferenceCurve inner() const;
    /// Length of one stretch [mm].
    [[nodiscard]] double length(int stretch) const;

    /// Distances of a polygon whose vertices follow the curve. @param far  what counts as missed [mm]
    [[nodiscard]] CurveDifference compare(std::vector<Vec2> const& polygon, double far) const;

    /// Largest distance of the curve from a polygon: one way only, for polygons that reach beyond its ends.
    [[nodiscard]] double largest_gap(std::vector<Vec2> const& polygon) const;
    /// Largest distance of @p points from the curve.
    [[nodiscard]] double largest_distance(std::vector<Vec2> const& points) const;

  private:
    struct Foot
    {
        std::size_t patch = 0;
        long double s = 0;
        long double distance = 0;
    };
    [[nodiscard]] Foot foot(long double x, long double y, std::size_t& near) const;
    [[nodiscard]] Foot refined(long double x, long double y, std::size_t patch, long double s) const;

    std::vector<ReferencePatch> patches_;
    std::vector<ReferencePatch> slopes_;
    std::vector<Vec2> points_;
    region::SegmentTree tree_;
    double error_;
};

}  // namespace hdconj::accuracy
