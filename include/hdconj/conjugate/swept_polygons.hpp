// SPDX-License-Identifier: GPL-3.0-or-later
// Polygons of the bounding arcs of all teeth that reach one pitch: what the planar arrangement is given.
#pragma once

#include <cstddef>
#include <initializer_list>
#include <optional>
#include <string>
#include <vector>

#include "hdconj/base/vec2.hpp"

namespace hdconj::conjugate {

/// Calls @p take(first, end) for each run of two or more indices below @p count that are wanted, or beside one that is.
template <class Wanted, class Take>
void for_runs(std::size_t count, Wanted const& wanted, Take const& take)
{
    std::size_t first = 0;
    for (std::size_t k = 0; k <= count; ++k) {
        if (k < count && (wanted(k) || (k > 0 && wanted(k - 1)) || (k + 1 < count && wanted(k + 1))))
            continue;
        if (k > first + 1)
            take(first, k);
        first = k + 1;
    }
}

/// Polygons with the arc, the tooth and the parameter that each vertex came from.
class SweptPolygons
{
  public:
    /// Half of the land that advice leaves, in pitches.
    static constexpr double half_land = 0.07;

    /// @param pitch  angle between neighbouring teeth of the circular spline [rad]
    explicit SweptPolygons(double pitch) : pitch_(pitch) {}

    /// Where a polygon came from.
    struct Source
    {
        int arc = -1;           ///< -1: the floor, a wall
        int copy = 0;           ///< the tooth this many pitches clockwise
        std::vector<double> u;  ///< parameter of each vertex; on the floor its angle, on a line x, on a wall y
    };

    /// Adds a stretch of an arc for every tooth that reaches the middle pitch or the spaces beside it.
    void add(int arc, std::vector<Vec2> const& points, std::vector<double> const& u);

    /// Adds a stretch of an arc as it is, of the tooth @p copy.
    void add_one(int arc, int copy, std::vector<Vec2> const& points, std::vector<double> const& u);

    /// Ends closer than @p same get one pair of coordinates, so that the arrangement has no hairline gaps.
    void join_ends(double same);

    /// Adds the tip circle, from beyond the leftmost to beyond the rightmost polygon; returns its index.
    int add_floor(double radius, double chord);

    /// Adds the straight line at height @p y as the floor, from right to left beyond all polygons; returns its index.
    int add_floor_line(double y, double margin);

    /// Adds a straight wall at @p x from the height @p y down to below all polygons.
    void add_wall(double x, double y, double margin);

    /// Smallest y at which any polygon crosses one of these parallels to the y axis; infinite where none does.
    [[nodiscard]] double lowest_at(std::initializer_list<double> places) const;

    /// Largest radius that any polygon reaches at one of these angles from the y axis; 0 where none crosses there.
    [[nodiscard]] double radius_at(std::initializer_list<double> angles) const;

    /// The same half-way between two tooth spaces, on either side.
    [[nodiscard]] double radius_between_spaces() const;

    /// Radius at which two spaces leave a land of 0.14 pitches, more than 0.4 modules, between them; nothing where this
    /// is within the tip circle @p tip, or leaves less than half of the depth outside it and half a module.
    [[nodiscard]] std::optional<double> radius_of_land(double tip) const;

    /// That radius as an argument of --set; empty where there is none.
    [[nodiscard]] std::vector<std::string> wider_tip(double tip) const;

    /// The middle of the land is solid from the tip circle @p tip outward; where a tooth sweeps any of it, there is no
    /// land.
    /// @param side_clearance  that these polygons contain [mm]
    /// @throws NumericalError where there is no land
    void refuse_without_land(double tip, double side_clearance) const;

    /// Parameter at a position (vertices, with a fraction) along a polygon.
    [[nodiscard]] double u_at(int polygon, double position) const;

    [[nodiscard]] std::vector<std::vector<Vec2>> const& polygons() const { return polygons_; }
    [[nodiscard]] std::vector<Vec2> const& polygon(int i) const { return polygons_[static_cast<std::size_t>(i)]; }
    [[nodiscard]] Source const& source(int i) const { return sources_[static_cast<std::size_t>(i)]; }

  private:
    double pitch_;
    std::vector<std::vector<Vec2>> polygons_;
    std::vector<Source> sources_;
};

}  // namespace hdconj::conjugate
