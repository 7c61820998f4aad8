// SPDX-License-Identifier: GPL-3.0-or-later
// Places inside the elements of a section.
#pragma once

#include "section_mesh.hpp"

namespace hdconj::elastic {

/// Place in a mesh: the point (xi, eta) of an element.
struct SectionPoint
{
    std::size_t element = 0;
    double xi = 0;
    double eta = 0;
};

/// The point of the straight wall at height @p z, @p depth of the wall from the inner surface (0) to the outer one (1).
/// @throws NumericalError outside the straight wall, or for a depth outside 0 to 1
[[nodiscard]] SectionPoint wall_point(SectionMesh const& mesh, double z, double depth);

/// Shape functions of the eight nodes.
[[nodiscard]] std::array<double, 8> shape_functions(double xi, double eta);
/// Their derivatives: first by xi, second by eta.
[[nodiscard]] std::array<Vec2, 8> shape_slopes(double xi, double eta);

/// (r, z) of a place.
[[nodiscard]] Vec2 position(SectionMesh const& mesh, SectionPoint const& point);

}  // namespace hdconj::elastic
