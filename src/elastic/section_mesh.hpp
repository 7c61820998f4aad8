// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// A meridian section as a row of quadratic elements.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "cup_section.hpp"
#include "hdconj/base/vec2.hpp"

namespace hdconj::elastic {

/// Corners anticlockwise in (xi, eta) from (-1, -1), then the middles of the sides from that between corners 0 and 1
/// on.
using QuadraticElement = std::array<int, 8>;

/// Elements of another material on the outside of the wall, behind those of the wall in the list.
struct OuterLayer
{
    std::size_t first = 0;  ///< of them
    StressMatrix stress;    ///< stress from strain
};

/// Eight-node elements, `layers` across the wall (xi, from the inner to the outer surface) and any number along the
/// meridian (eta). Element of row i, layer j: number i layers + j.
struct SectionMesh
{
    std::vector<Vec2> nodes;  ///< (r, z) [mm]
    std::vector<QuadraticElement> elements;
    int layers = 1;
    int straight = 0;          ///< rows from this one on lie between planes z = constant
    std::vector<int> clamped;  ///< nodes that do not move
    Elasticity material;
    std::optional<OuterLayer> outer;

    [[nodiscard]] std::size_t wall_elements() const { return outer ? outer->first : elements.size(); }
    /// Stress from strain in an element.
    [[nodiscard]] StressMatrix stress(std::size_t element) const
    {
        return element < wall_elements() ? stress_matrix(material) : outer->stress;
    }
};

/// How fine. Lengths in mm.
struct MeshSize
{
    double along = 0.5;   ///< longest element along the wall; twice that in the bottom
    double across = 1.0;  ///< thickest element
};

/// Mesh of the cup: default size gives 40 elements and 609 unknowns per harmonic for the default section.
/// @throws NumericalError when the dimensions contradict each other
[[nodiscard]] SectionMesh section_mesh(CupSection const& cup, MeshSize const& size = {});

/// Mesh of a ring with rectangular section, free everywhere.
/// @throws NumericalError for an empty section or one that reaches the axis
[[nodiscard]] SectionMesh ring_mesh(Vec2 const& lower, Vec2 const& upper, Elasticity const& material,
                                    MeshSize const& size = {});

/// Puts a layer of @p height on the outside of the straight wall between @p low and @p high: elements as long as those
/// of the wall, no thicker than @p thickest. Domain: a mesh without a layer. @throws NumericalError where no element of
/// the wall lies between these heights, or the height is not above 0
void add_outer_layer(SectionMesh& mesh, double low, double high, double height, double thickest,
                     StressMatrix const& stress);

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
