// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// A cell of a flank between two points and two slices, and the part of it that is in contact.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <utility>

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

/// Adds the cell's area and its part in contact: four triangles about its middle.
inline void add_cell(std::array<AreaCorner, 4> const& corner, double& contact, double& whole)
{
    AreaCorner middle{Eigen::Vector3d::Zero(), 0};
    for (AreaCorner const& c : corner) {
        middle.place += c.place / 4;
        middle.excess += c.excess / 4;
    }
    for (std::size_t i = 0; i < corner.size(); ++i) {
        AreaCorner const& a = corner[i];
        AreaCorner const& b = corner[(i + 1) % corner.size()];
        double const area = 0.5 * (a.place - middle.place).cross(b.place - middle.place).norm();
        whole += area;
        contact += area * share_below(a.excess, b.excess, middle.excess);
    }
}

}  // namespace hdconj::contact
