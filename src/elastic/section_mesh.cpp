// SPDX-License-Identifier: GPL-3.0-or-later
#include "section_mesh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <utility>

namespace hdconj::elastic {
namespace {

void require(bool good, char const* what, char const* cause)
{
    if (!good)
        throw NumericalError(ErrorCode::unsuitable_body, "elastic cup", what, cause);
}

void require_sound(Elasticity const& material, MeshSize const& size)
{
    require(material.youngs_modulus > 0 && std::isfinite(material.youngs_modulus), "Young's modulus",
            "must be positive and finite");
    require(material.poissons_ratio >= 0 && material.poissons_ratio < 0.5, "Poisson's ratio",
            "must be from 0 to below 0.5: at 0.5 the material keeps its volume, which these elements cannot express");
    require(size.along > 0 && size.across > 0, "mesh", "element sizes must be positive");
}

/// Elements over a @p length, none longer than @p longest, but for a little.
/// @param too_many  what is said of more than @p most
int elements_over(double length, double longest, int most, char const* too_many)
{
    constexpr double slack = 0.01;  // of an element, before there is one more
    double const wanted = std::ceil(length / longest - slack);
    require(wanted <= most, "mesh", too_many);
    return std::max(1, static_cast<int>(wanted));
}

/// A line across the wall.
struct Across
{
    Vec2 inner;
    Vec2 outer;
};

/// Lines at both ends and in the middle of each row of elements along the meridian.
struct SectionRows
{
    std::vector<Across> lines;
    int straight = 0;  ///< SectionMesh::straight
};

/// Adds a part of the section: rows no longer than @p longest [mm].
/// @param length  of the part [mm]; nothing is added where it is not above 0
/// @param at      line at s in [0, 1] along the part
void add_part(SectionRows& rows, double length, double longest, std::function<Across(double)> const& at)
{
    if (length <= 0)
        return;
    int const count =
        elements_over(length, longest, 10000,
                      "more than 10000 elements along one part of the section: the mesh is too fine for its length");
    if (rows.lines.empty())
        rows.lines.push_back(at(0));
    for (int i = 1; i <= 2 * count; ++i)
        rows.lines.push_back(at(i / (2.0 * count)));
}

/// Elements across a wall, no thicker than @p thickest [mm].
int layers_across(double wall, double thickest)
{
    return elements_over(wall, thickest, 200,
                         "more than 200 elements across the wall: the mesh is too fine for its thickness");
}

/// Elements between the lines, no thicker than @p thickest [mm].
SectionMesh mesh_of(SectionRows const& rows, Elasticity const& material, double thickest)
{
    double wall = 0;
    for (Across const& line : rows.lines)
        wall = std::max(wall, (line.outer - line.inner).norm());
    SectionMesh mesh;
    mesh.material = material;
    mesh.straight = rows.straight;
    int const layers = mesh.layers = layers_across(wall, thickest);
    // Lines between elements have corners and middles, those through the middles of elements corners only.
    for (std::size_t i = 0; i < rows.lines.size(); ++i) {
        Across const& line = rows.lines[i];
        int const steps = i % 2 == 0 ? 2 * layers : layers;
        for (int j = 0; j <= steps; ++j)
            mesh.nodes.push_back(line.inner + (line.outer - line.inner) * (static_cast<double>(j) / steps));
    }
    int const between = 2 * layers + 1, row = between + layers + 1;
    int const count = static_cast<int>(rows.lines.size() / 2);
    for (int i = 0; i < count; ++i) {
        int const first = i * row, middle = first + between, next = first + row;
        for (int j = 0; j < layers; ++j)
            mesh.elements.push_back({first + 2 * j, first + 2 * j + 2, next + 2 * j + 2, next + 2 * j,
                                     first + 2 * j + 1, middle + j + 1, next + 2 * j + 1, middle + j});
    }
    return mesh;
}

/// The bottom and the corner between it and the wall, which begins at the radius @p fillet.
void add_bottom(SectionRows& rows, CupSection const& cup, double fillet, MeshSize const& size)
{
    add_part(rows, fillet - cup.clamp_radius, 2 * size.along, [&](double s) {
        double const at = cup.clamp_radius + (fillet - cup.clamp_radius) * s;
        return Across{{at, cup.bottom}, {at, 0}};
    });
    double const quarter = std::numbers::pi / 2;
    add_part(rows, quarter * (cup.corner_radius - cup.wall / 2), 1.5 * size.along, [&](double s) {
        Vec2 const centre(fillet, cup.corner_radius);
        Vec2 const out(std::sin(quarter * s), -std::cos(quarter * s));
        double const wall = cup.bottom + (cup.wall - cup.bottom) * s;
        return Across{centre + (cup.corner_radius - wall) * out, centre + cup.corner_radius * out};
    });
    rows.straight = static_cast<int>(rows.lines.size() / 2);
}

/// Straight wall between two heights whose thickness changes linearly.
void add_straight(SectionRows& rows, CupSection const& cup, MeshSize const& size, std::array<double, 2> const& z,
                  std::array<double, 2> const& wall)
{
    add_part(rows, z[1] - z[0], wall[0] == wall[1] ? 1.1 * size.along : size.along, [&](double s) {
        double const at = z[0] + (z[1] - z[0]) * s;
        return Across{{cup.inner_radius, at}, {cup.inner_radius + wall[0] + (wall[1] - wall[0]) * s, at}};
    });
}

/// An arc of @p radius between the wall and the tooth ring.
/// @param upward  from its foot at height @p foot upward, or towards the foot from above
void add_fillet(SectionRows& rows, CupSection const& cup, MeshSize const& size, double foot, double radius, bool upward)
{
    constexpr double arc_rows = 3;  // at least: bending of a wall whose thickness curves
    double const angle = std::acos(std::max(0.0, 1 - (cup.ring_wall - cup.wall) / radius));
    add_part(rows, angle * radius, std::min(size.along, angle * radius / arc_rows), [&](double s) {
        double const a = angle * (upward ? s : 1 - s);
        double const z = foot + (upward ? 1 : -1) * radius * std::sin(a);
        return Across{{cup.inner_radius, z}, {cup.inner_radius + cup.wall + radius * (1 - std::cos(a)), z}};
    });
}

/// The wall from the corner to the open end, with the ring that bears the teeth. Its thickness changes from the height
/// @p rear to the ring and from there to @p front.
void add_wall(SectionRows& rows, CupSection const& cup, double rear, double front, MeshSize const& size)
{
    add_straight(rows, cup, size, {cup.corner_radius, rear}, {cup.wall, cup.wall});
    if (cup.rear_fillet > 0)
        add_fillet(rows, cup, size, rear, cup.rear_fillet, true);
    else
        add_straight(rows, cup, size, {rear, cup.ring_begin}, {cup.wall, cup.ring_wall});
    add_part(rows, cup.ring_end - cup.ring_begin, size.along, [&](double s) {
        double const z = cup.ring_begin + (cup.ring_end - cup.ring_begin) * s;
        return Across{{cup.inner_radius, z}, {cup.inner_radius + cup.ring_wall, z}};
    });
    if (cup.length <= cup.ring_end)
        return;
    if (cup.front_fillet > 0)
        add_fillet(rows, cup, size, front, cup.front_fillet, false);
    else
        add_straight(rows, cup, size, {cup.ring_end, front}, {cup.ring_wall, cup.wall});
    add_straight(rows, cup, size, {front, cup.length}, {cup.wall, cup.wall});
}

}  // namespace

SectionMesh section_mesh(CupSection const& cup, MeshSize const& size)
{
    require_sound(cup.material, size);
    SectionPlaces const at = section_places(cup);
    SectionRows rows;
    add_bottom(rows, cup, at.fillet, size);
    add_wall(rows, cup, at.rear, at.front, size);
    SectionMesh mesh = mesh_of(rows, cup.material, size.across);
    int const first_line = 2 * mesh.layers + 1;  // nodes
    for (int i = 0; i < first_line; ++i)
        mesh.clamped.push_back(i);
    if (cup.tooth_layer > 0)
        add_outer_layer(mesh, cup.ring_begin, cup.ring_end, cup.tooth_layer, size.across,
                        tooth_stress_matrix(cup.material, cup.tooth_share));
    return mesh;
}

void add_outer_layer(SectionMesh& mesh, double low, double high, double height, double thickest,
                     StressMatrix const& stress)
{
    constexpr double rounding = 1e-9;  // of heights that were divided and added up again
    require(height > 0 && std::isfinite(height), "layer of teeth", "its height must be above 0");
    auto const layers = static_cast<std::size_t>(mesh.layers);
    std::size_t const rows = mesh.elements.size() / layers;
    auto const at = [&](int node) { return mesh.nodes[static_cast<std::size_t>(node)]; };
    // nodes on which the next elements stand, line by line of the rows: below, in the middle of and above each
    std::vector<int> base;
    for (auto row = static_cast<std::size_t>(mesh.straight); row < rows; ++row) {
        QuadraticElement const& q = mesh.elements[row * layers + layers - 1];
        if (at(q[1]).y() < low - rounding || at(q[2]).y() > high + rounding)
            continue;
        if (base.empty())
            base.push_back(q[1]);
        base.push_back(q[5]);
        base.push_back(q[2]);
    }
    if (base.empty())
        throw NumericalError(ErrorCode::unsuitable_body, "elastic cup", "layer of teeth",
                             fmt::format("no wall between {:g} mm and {:g} mm to stand on", low, high));
    mesh.outer = OuterLayer{mesh.elements.size(), stress};
    int const steps = std::max(1, static_cast<int>(std::ceil(height / thickest - rounding)));
    for (int step = 0; step < steps; ++step) {
        std::vector<int> top, between;  // the latter of lines between elements only
        for (std::size_t i = 0; i < base.size(); ++i) {
            Vec2 const foot = at(base[i]), out(height / steps, 0);
            if (i % 2 == 0) {
                between.push_back(static_cast<int>(mesh.nodes.size()));
                mesh.nodes.push_back(foot + out / 2);
            }
            top.push_back(static_cast<int>(mesh.nodes.size()));
            mesh.nodes.push_back(foot + out);
        }
        for (std::size_t i = 0; i + 2 < base.size(); i += 2)
            mesh.elements.push_back({base[i], top[i], top[i + 2], base[i + 2], between[i / 2], top[i + 1],
                                     between[i / 2 + 1], base[i + 1]});
        base = std::move(top);
    }
}

SectionMesh ring_mesh(Vec2 const& lower, Vec2 const& upper, Elasticity const& material, MeshSize const& size)
{
    require_sound(material, size);
    require(lower.x() > 0 && upper.x() > lower.x() && upper.y() > lower.y(), "ring",
            "its section is empty or reaches the axis");
    SectionRows rows;
    add_part(rows, upper.y() - lower.y(), size.along, [&](double s) {
        double const z = lower.y() + (upper.y() - lower.y()) * s;
        return Across{{lower.x(), z}, {upper.x(), z}};
    });
    return mesh_of(rows, material, size.across);
}

MeshSize mesh_size(double radius)
{
    return {radius / 48, radius / 24};
}

MeshSize contact_mesh_size(CupSection const& section, double bearing_width, int across)
{
    MeshSize const standard = mesh_size(section.inner_radius);
    if (bearing_width <= 0 || across < 2)
        return standard;
    double const along = std::min(standard.along, 1.5 * bearing_width / (across - 1)),
                 wall = std::max({section.wall, section.ring_wall, section.bottom});
    return {along, wall / layers_across(wall, standard.across) * along / standard.along};
}

MeshSize in_layers(MeshSize size, CupSection const& section, int layers)
{
    if (layers > 1)
        size.across = std::min(size.across, std::min(section.wall, section.ring_wall) / layers);
    return size;
}

}  // namespace hdconj::elastic
