// SPDX-License-Identifier: GPL-3.0-or-later
// The body of revolution as a mesh in space: for other programs to look at and to compute with.
#pragma once

#include <Eigen/Core>

#include <array>
#include <vector>

#include "section_mesh.hpp"

namespace hdconj::elastic {

/// Where a node of the swept mesh stands.
struct SweptNode
{
    int section = 0;  ///< node of the section
    double phi = 0;   ///< [rad]
};

/// Hexahedra with twenty nodes: corners of the face at larger phi, those of the other face, then the middles of the
/// sides of the first, of the second, and of those between; positive volume where x = r cos phi, y = r sin phi.
struct SweptMesh
{
    std::vector<SweptNode> nodes;
    std::vector<std::array<int, 20>> elements;
};

inline constexpr int fewest_swept_steps = 4, most_swept_steps = 1440;

/// @p section swept from phi = 0 over @p angle in @p steps elements. A whole turn is closed.
/// @throws InputError for fewer or more steps than that
[[nodiscard]] SweptMesh swept_mesh(SectionMesh const& section, double angle, int steps);

/// Nodal forces [N] that do the same work as line loads on the nodes of the section, f_i(phi) = sum_k cosine(i, k)
/// cos(k waves phi) + sine(i, k) sin(k waves phi) [N/rad]; rows: nodes of the section. One number for each node of @p
/// swept. Exact for the quadratic sides between corners; on nodes in the middle of a section's side up to forces in
/// equilibrium in one element.
[[nodiscard]] std::vector<double> swept_loads(SectionMesh const& section, SweptMesh const& swept, double angle,
                                              int steps, int waves, Eigen::MatrixXd const& cosine,
                                              Eigen::MatrixXd const& sine);

}  // namespace hdconj::elastic
