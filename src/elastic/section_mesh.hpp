// SPDX-License-Identifier: GPL-3.0-or-later
// A meridian section as a row of quadratic elements.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "elasticity.hpp"
#include "hdconj/base/vec2.hpp"
#include "hdconj/error.hpp"

namespace hdconj::elastic {

/// Meridian section of the cup, lengths in mm, z from the outer face of the bottom towards the open end.
///
///     z = length      _
///                    | |   front land, `wall`
///     ring_end        \ \  ramp on the outside, `front_ramp` long
///                    |   | tooth ring, `ring_wall` (to the root of the teeth)
///     ring_begin      / /  ramp on the outside, `rear_ramp` long
///                    | |   barrel, `wall`
///     corner_radius  / /   outer fillet of `corner_radius`; the wall changes evenly into the bottom
///     z = 0   =======      bottom, clamped at `clamp_radius`
///
/// The inner surface of barrel, ring and land is one cylinder of `inner_radius`. A fillet of radius R between the walls
/// t and T is an arc, tangent to the thinner wall, in place of the ramp; it spans sqrt((T - t)(2 R - T + t)). Defaults:
/// the case that docs/explanation/elastic-cup.md checks against CalculiX.
struct CupSection
{
    double inner_radius = 24;
    double length = 15;
    double wall = 0.4;
    double ring_wall = 0.7;
    double ring_begin = 5;
    double ring_end = 13;
    double rear_ramp = 0.4;
    double front_ramp = 0.4;
    double rear_fillet = 0;  ///< radius of the arc behind the ring; 0: a straight ramp
    double front_fillet = 0;
    double tooth_layer = 0;    ///< height of the teeth as a layer on the ring (tooth_stress_matrix()); 0: none
    double tooth_share = 0.5;  ///< of it that is steel
    double bottom = 0.5;
    double corner_radius = 2;
    double clamp_radius = 13;
    Elasticity material;
};

/// Parts of the section whose dimensions may contradict each other.
enum class SectionPart
{
    walls,
    fillet,  ///< at the tooth ring
    flange,
    corner,  ///< at the bottom
    ramps,
    rear_ramp,
    front_ramp,
    tooth_ring,
    tooth_layer
};

/// A section that cannot be meshed.
class UnsoundSection : public NumericalError
{
  public:
    UnsoundSection(SectionPart part, std::string const& cause);

    [[nodiscard]] SectionPart part() const { return part_; }  ///< whose dimensions are wrong

  private:
    SectionPart part_;
};

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
[[nodiscard]] inline MeshSize mesh_size(double radius)
{
    return {radius / 48, radius / 24};
}

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

/// Size of elements of a cup for @p across circles of contact over a bearing of this width [mm]: two circles never
/// share all of their nodes. Elements are thinner in the proportion in which they are shorter than standard ones: one
/// across the wall that is half as long as it is thick gives a stress some 10 % too large opposite the bearing's edge.
[[nodiscard]] MeshSize contact_mesh_size(CupSection const& section, double bearing_width, int across);

/// The same with at least @p layers elements across the wall. One resolves bending; the local indentation by forces
/// needs two.
[[nodiscard]] MeshSize in_layers(MeshSize size, CupSection const& section, int layers);

}  // namespace hdconj::elastic
