// SPDX-License-Identifier: GPL-3.0-or-later
// A meridian section as a row of quadratic elements.
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
    double along;   ///< longest element along the wall; twice that in the bottom
    double across;  ///< thickest element
};

/// Standard size for a body whose surface has this radius [mm]: so cups of one form have the same elements whatever
/// their size. The default section gets 40 elements and 609 unknowns per harmonic.
[[nodiscard]] MeshSize mesh_size(double radius);

/// Mesh of the cup. @throws NumericalError when the dimensions contradict each other
[[nodiscard]] SectionMesh section_mesh(CupSection const& cup, MeshSize const& size);
/// The same with elements of standard size.
[[nodiscard]] inline SectionMesh section_mesh(CupSection const& cup)
{
    return section_mesh(cup, mesh_size(cup.inner_radius));
}

/// Mesh of a ring with rectangular section, free everywhere.
/// @throws NumericalError for an empty section or one that reaches the axis
[[nodiscard]] SectionMesh ring_mesh(Vec2 const& lower, Vec2 const& upper, Elasticity const& material,
                                    MeshSize const& size);

/// Puts a layer of @p height on the outside of the straight wall between @p low and @p high: elements as long as those
/// of the wall, no thicker than @p thickest. Domain: a mesh without a layer. @throws NumericalError where no element of
/// the wall lies between these heights, or the height is not above 0
void add_outer_layer(SectionMesh& mesh, double low, double high, double height, double thickest,
                     StressMatrix const& stress);

/// Size of elements of a cup for @p across circles of contact over a bearing of this width [mm]: two circles never
/// share all of their nodes. Elements are thinner in the proportion in which they are shorter than standard ones: one
/// across the wall that is half as long as it is thick gives a stress some 10 % too large opposite the bearing's edge.
[[nodiscard]] MeshSize contact_mesh_size(CupSection const& section, double bearing_width, int across);

/// The same with at least @p layers elements across the wall. One resolves bending; the local indentation by forces
/// needs two.
[[nodiscard]] MeshSize in_layers(MeshSize size, CupSection const& section, int layers);

}  // namespace hdconj::elastic
