// SPDX-License-Identifier: GPL-3.0-or-later
// How much flank is in contact: the part of its area where the gap is no larger than a limit.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <utility>

#include "gap_field.hpp"

namespace hdconj::contact {

/// A corner of a cell: place and gap less the limit.
struct AreaCorner
{
    Eigen::Vector3d place;
    double excess;
};

/// Part of a triangle with linear @p a, @p b, @p c on which the value is <= 0.
[[nodiscard]] inline double share_below(double a, double b, double c)
{
    if (a > b)
        std::swap(a, b);
    if (b > c)
        std::swap(b, c);
    if (a > b)
        std::swap(a, b);
    if (a > 0)
        return 0;
    if (c <= 0)
        return 1;
    if (b <= 0)
        return 1 - c / (c - a) * (c / (c - b));
    return a == 0 ? 0 : a / (a - b) * (a / (a - c));
}

/// The middle of a cell.
[[nodiscard]] inline AreaCorner cell_middle(std::array<AreaCorner, 4> const& corner)
{
    AreaCorner middle{Eigen::Vector3d::Zero(), 0};
    for (AreaCorner const& c : corner) {
        middle.place += c.place / 4;
        middle.excess += c.excess / 4;
    }
    return middle;
}

[[nodiscard]] inline double triangle_area(AreaCorner const& a, AreaCorner const& b, AreaCorner const& c)
{
    return 0.5 * (a.place - c.place).cross(b.place - c.place).norm();
}

/// Adds the cell's area and its part in contact: four triangles about its middle.
inline void add_cell(std::array<AreaCorner, 4> const& corner, double& contact, double& whole)
{
    AreaCorner const middle = cell_middle(corner);
    for (std::size_t i = 0; i < corner.size(); ++i) {
        AreaCorner const& a = corner[i];
        AreaCorner const& b = corner[(i + 1) % corner.size()];
        double const area = triangle_area(a, b, middle);
        whole += area;
        contact += area * share_below(a.excess, b.excess, middle.excess);
    }
}

/// Adds the part in contact alone, the same bits as add_cell().
inline void add_contact_of_cell(std::array<AreaCorner, 4> const& corner, double& contact)
{
    if (std::all_of(corner.begin(), corner.end(), [](AreaCorner const& c) { return c.excess > 0; }))
        return;
    AreaCorner const middle = cell_middle(corner);
    for (std::size_t i = 0; i < corner.size(); ++i) {
        AreaCorner const& a = corner[i];
        AreaCorner const& b = corner[(i + 1) % corner.size()];
        double const share = share_below(a.excess, b.excess, middle.excess);
        if (share != 0)
            contact += triangle_area(a, b, middle) * share;
    }
}

/// Areas of the flanks on one side of all tooth spaces.
struct ContactArea
{
    double contact = 0;  ///< [mm^2] with gap <= limit
    double whole = 0;    ///< [mm^2]
    int spaces = 0;      ///< tooth spaces with any contact
    [[nodiscard]] double share() const { return whole > 0 ? contact / whole : 0; }
};

/// Area integral over @p map on the flanks @p flank.
///
/// Every cell between two points and two slices is cut into four triangles at its middle, and the gap is taken linear
/// in each, so that the edge of the contact runs through cells. One slice stands for the whole @p width.
/// Accuracy: second order in the spacing; exact for a gap that is linear in each triangle.
[[nodiscard]] ContactArea contact_area(GapMap const& map, FlankGrid const& grid, int flank, double limit, double width);

}  // namespace hdconj::contact
